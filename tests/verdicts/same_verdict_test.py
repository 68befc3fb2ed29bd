#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The verdict on a robot does not depend on how it is written.

usage: same_verdict_test.py CASES FIXTURES SHARED

- A xacro file has the verdicts and counts of its own expansion (smurf2urdf), for every target.
- A URDF whose links, joints and shapes are in reverse order has the verdicts and counts of the original.

Files are fixtures and, if SHARED exists, public robots. Rules in which the order is meant are left out: IN_ORDER.
"""
import collections
import json
import pathlib
import shutil
import sys
import tempfile
import xml.parsers.expat

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402

TARGETS = "ros,gazebo,dart,mujoco,mujoco:2.3,drake,pinocchio,pybullet,newton,isaac,mars"
# SML1204, SML1208: which of several roots is the first. SML1703, SML1711: the material that a link uses stands before it.
# SML1659: the size of the first use of a mesh. SML1713: the colour of the first visual of a link.
IN_ORDER = "SML1204,SML1208,SML1659,SML1703,SML1711,SML1713"
# About xacro itself, names of files, or companions and launch files that name the file: the expansion cannot have them.
OF_THE_FILE = "SML33,SML34,SML35,SML36,SML37,SML38,SML42,SML9"
# A package beside the file: packages are searched for around a xacro file, but only above a URDF.
FOUND_AROUND = "SML1658"
LEAST_XACRO, LEAST_REORDERED = 20, 300
LEAST_PUBLIC_XACRO, LEAST_PUBLIC_REORDERED = 200, 700


def verdicts(tools, path, words, ignore, folder):
    """{target: (answer, refusals, losses, unknown)}; nothing of a file that is only a part of robots."""
    done = tools.run("smurf-lint", "--isolated", "--allow-outside", "--ignore", ignore, "--target", TARGETS, "--format", "json",
                     str(path), *words, cwd=folder)
    report = json.loads(done.stdout)
    return {target: tuple(one[key] for key in ("verdict", "refusals", "losses", "unknown"))
            for target, one in report.get("targets", {}).items()}, report


def difference(left, right):
    return "; ".join(f"{target}: {left[target]} and {right[target]}" for target in left if left[target] != right[target])


class Expansions:
    def __init__(self, tools):
        self.tools, self.faults, self.compared = tools, [], 0

    def compare(self, entry, words, title):
        expanded = entry.parent / "same_verdict_of_expansion.urdf"
        made = self.tools.run("smurf2urdf", str(entry), *words, "-o", str(expanded), cwd=entry.parent)
        if made.returncode != 0 or not expanded.exists():
            return
        own, report = verdicts(self.tools, entry, words, OF_THE_FILE, entry.parent)
        if not own or any(one["id"] == FOUND_AROUND for one in report["diagnostics"]):
            expanded.unlink()
            return
        other, _ = verdicts(self.tools, expanded, (), OF_THE_FILE, entry.parent)
        expanded.unlink()
        self.compared += 1
        if own != other:
            self.faults.append(f"{title}: xacro and expansion: {difference(own, other)}")


REVERSED = {"robot": ("link", "joint"), "link": ("visual", "collision")}


def reversed_text(text):
    """The bytes of a URDF with elements of a kind in reverse order; None if it cannot be parsed."""
    parser = xml.parsers.expat.ParserCreate()
    parser.buffer_text = True
    stack, spans = [], []  # spans: (depth key of the parent, tag, begin, end)

    def start(name, _):
        stack.append((name, parser.CurrentByteIndex))

    def end(name):
        tag, begin = stack.pop()
        stop = parser.CurrentByteIndex
        # At the end of an element without content, expat is behind its tag already.
        is_empty = text[begin:stop].count(b"<") == 1 and text[begin:stop].endswith(b"/>")
        stop = stop if is_empty else text.index(b">", stop) + 1
        parent = stack[-1] if stack else ("", 0)
        if name in REVERSED.get(parent[0], ()) and len(stack) in (1, 2):
            spans.append((parent[1], name, begin, stop))

    parser.StartElementHandler, parser.EndElementHandler = start, end
    try:
        parser.Parse(text, True)
    except (xml.parsers.expat.ExpatError, ValueError):
        return None

    def rebuild(begin, stop):
        inside = sorted(one for one in spans if begin < one[2] and one[3] <= stop and one[2:] != (begin, stop))
        inside = [one for one in inside if not any(o[2] < one[2] and one[3] <= o[3] for o in inside if o != one)]
        by_kind = collections.defaultdict(list)
        for one in inside:
            by_kind[one[1]].append(one)
        inside.sort(key=lambda one: one[2])
        out, at, seen = b"", begin, collections.Counter()
        for one in inside:
            kind = sorted(by_kind[one[1]], key=lambda each: each[2])
            swap = kind[-1 - seen[one[1]]]
            seen[one[1]] += 1
            out += text[at:one[2]] + (rebuild(swap[2], swap[3]) if one[1] == "link" else text[swap[2]:swap[3]])
            at = one[3]
        return out + text[at:stop]

    return rebuild(0, len(text))


def main():
    program, fixtures, shared = map(pathlib.Path, sys.argv[1:])
    faults, reordered = [], 0
    with cases.Cases(program) as tools, tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        expansions = Expansions(tools)
        copy = scratch / "fixtures"
        shutil.copytree(fixtures, copy)
        for entry in sorted(copy.rglob("*.xacro")):
            expansions.compare(entry, (), str(entry.relative_to(copy)))
        public = (shared / "xacro" / "entries.tsv").exists()
        if public:
            shutil.copytree(shared / "xacro" / "corpus", scratch / "xacro")
            for line in (shared / "xacro" / "entries.tsv").read_text("utf8").splitlines():
                if line.startswith("#"):
                    continue
                repository, file, words = line.split("\t")[:3]
                expansions.compare(scratch / "xacro" / repository / file, words.split(), f"{repository}/{file} {words}")
            shutil.copytree(shared / "corpus" / "urdf", scratch / "corpus")
        for folder in ("fixtures", "corpus") if public else ("fixtures",):
            for path in sorted((scratch / folder).rglob("*.urdf")):
                original = path.read_bytes()
                changed = reversed_text(original)
                if changed is None or changed == original:
                    continue
                before, _ = verdicts(tools, path, (), IN_ORDER, path.parent)
                if not before:
                    continue
                path.write_bytes(changed)
                after, _ = verdicts(tools, path, (), IN_ORDER, path.parent)
                path.write_bytes(original)
                reordered += 1
                if before != after:
                    faults.append(f"{path.relative_to(scratch)}: reordered: {difference(before, after)}")
        faults += expansions.faults
        print(f"compared {expansions.compared} xacro files with their expansions, {reordered} files with others in reverse order")
        print("\n".join(faults))
        is_few = expansions.compared < (LEAST_PUBLIC_XACRO if public else LEAST_XACRO) or \
            reordered < (LEAST_PUBLIC_REORDERED if public else LEAST_REORDERED)
        if is_few:
            print("fewer files than expected")
    return 1 if faults or is_few else 0


if __name__ == "__main__":
    sys.exit(main())
