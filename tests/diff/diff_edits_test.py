#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random edits of single facts are told exactly, and edits that change none are not told at all.

Usage: diff_edits_test.py SMURF-DIFF SMURF2URDF FOLDER [EDITS [SEED]]
"""
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import edits  # noqa: E402


class Tester:
    def __init__(self, smurf_diff, smurf2urdf, work):
        self.smurf_diff, self.smurf2urdf, self.work = smurf_diff, smurf2urdf, work
        self.failures, self.done = [], {"edits": 0, "same": 0}

    def diff(self, old, new, text=None, options=()):
        """The differences; None if one of both cannot be read."""
        done = subprocess.run([self.smurf_diff, "--format", "json", *options, old, *(["-", "--stdin-filename", old] if text is not None else [new])],
                              input=text, capture_output=True, timeout=600)
        if done.returncode == 2:
            return None
        return json.loads(done.stdout)["differences"]

    def expect_edit(self, title, edit, found):
        self.done["edits"] += 1
        if found is None or len(found) != 1 or not edit.is_told_by(found[0]):
            self.failures.append(f"{title}: {edit}\n  told: {json.dumps(found)[:1500]}")

    def expect_same(self, title, found):
        self.done["same"] += 1
        if found:
            self.failures.append(f"{title}: nothing has changed\n  told: {json.dumps(found)[:1500]}")

    def rename(self, path, rng):
        """Renames a link or joint in all places with smurf-lint."""
        text = path.read_bytes()
        things = [(one.tag, one.attributes["name"]) for one in edits.elements_of(text)
                  if one.tag in ("link", "joint") and one.parent.tag == "robot" and one.attributes.get("name")]
        if not things:
            return
        old, new = self.work / "old.urdf", self.work / "new.urdf"
        for copy in (old, new):
            copy.write_bytes(text)
        kind, name = rng.choice(things)
        lint = pathlib.Path(self.smurf_diff).with_name("smurf-lint")
        done = subprocess.run([lint, "--rename", f"{kind}:{name}=brand_new_name", new], capture_output=True)
        if done.returncode == 0 and new.read_bytes() != text:
            self.expect_edit(path, edits.Edit(None, kind, "brand_new_name", "", change="renamed"), self.diff(old, new))

    def canonical(self, path):
        output = self.work / "canonical.urdf"
        output.unlink(missing_ok=True)
        subprocess.run([self.smurf2urdf, "--canonical", "--force", "-q", path, "-o", output], capture_output=True)
        if output.exists():
            self.expect_same(f"{path}, canonical", self.diff(path, output, options=package_of(path)))


def package_of(path):
    """The option that names the folder of a file as a package, for copies elsewhere."""
    manifest = path.parent / "package.xml"
    name = re.search(r"<name>(.*?)</name>", manifest.read_text()) if manifest.exists() else None
    return [f"--package={name[1]}={path.parent}"] if name else []


def is_sound(text):
    """Excludes files in which the edited element would be ambiguous: names must be unique."""
    try:
        elements = edits.elements_of(text)
    except Exception:
        return False
    names = [(one.tag, one.attributes.get("name")) for one in elements if one.parent is elements[0] and one.tag in ("link", "joint")]
    parts = [(id(one.parent), one.tag, one.attributes.get("name")) for one in elements if one.tag in ("visual", "collision")]
    return elements[0].tag == "robot" and len(set(names)) == len(names) and len(set(parts)) == len(parts)


def try_urdf(tester, path, rng):
    text = path.read_bytes()
    if not is_sound(text) or tester.diff(path, path) is None:
        return False
    edit = edits.urdf_edit(text, rng)
    if edit is None:
        return False
    tester.expect_edit(path, edit, tester.diff(path, None, edit.text))
    tester.expect_same(f"{path}, in another order", tester.diff(path, None, edits.shuffled_urdf(text, rng)))
    tester.canonical(path)
    if rng.random() < 0.3:
        tester.rename(path, rng)
    return True


def try_yaml(tester, main, path, rng):
    """A file of a model or scene, in a copy of its folder without meshes."""
    try:
        text = path.read_text(encoding="utf-8")
        edit = edits.yaml_edit(text, rng)
    except (UnicodeDecodeError, edits.yaml.YAMLError):
        return False
    if edit is None:
        return False
    root = main.parent.parent
    copies = [tester.work / "old", tester.work / "new"]
    for copy in copies:
        shutil.rmtree(copy, ignore_errors=True)
        for file in root.rglob("*"):
            if file.suffix in (".smurf", ".smurfs", ".smurfa", ".yml", ".yaml", ".urdf", ".scn"):
                target = copy / file.relative_to(root)
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(file.read_bytes())
    old, new = (copy / main.relative_to(root) for copy in copies)
    if tester.diff(old, old) is None:
        return False
    (copies[1] / path.relative_to(root)).write_text(edit.text, encoding="utf-8")
    tester.expect_edit(path, edit, tester.diff(old, new))
    try:
        (copies[1] / path.relative_to(root)).write_text(edits.shuffled_yaml(text, rng), encoding="utf-8")
        tester.expect_same(f"{path}, in another order", tester.diff(old, new))
    except edits.yaml.YAMLError:
        pass  # PyYAML does not support lists as keys
    return True


def files_of(folder):
    """(main, file): a file to edit, and the file that includes it; None: it is not included."""
    urdfs = sorted(folder.rglob("*.urdf"))
    parts = []
    for main in sorted(folder.rglob("*.smurf")):
        parts += [(main, path) for path in sorted(main.parent.glob("*.yml")) if path.name in main.read_text()]
    scenes = [(path, path) for suffix in ("smurfs", "smurfa") for path in sorted(folder.rglob("*." + suffix))]
    return urdfs, parts + scenes


def main():
    smurf_diff, smurf2urdf, folder = sys.argv[1:4]
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 200
    rng = random.Random(int(sys.argv[5]) if len(sys.argv) > 5 else 20260101)
    if edits.yaml is None or not pathlib.Path(folder).is_dir():
        print("skipped: python3-yaml or the folder is absent")
        return 77
    urdfs, parts = files_of(pathlib.Path(folder).resolve())
    with tempfile.TemporaryDirectory(prefix="smurf-diff-") as work:
        tester = Tester(smurf_diff, smurf2urdf, pathlib.Path(work))
        for _ in range(20 * count):
            if tester.done["edits"] >= count:
                break
            if parts and (not urdfs or rng.random() < 0.5):
                try_yaml(tester, *rng.choice(parts), rng)
            else:
                try_urdf(tester, rng.choice(urdfs), rng)
    print("\n".join(tester.failures))
    print(f"{tester.done['edits']} edits, {tester.done['same']} versions that are the same, {len(tester.failures)} failures")
    return 1 if tester.failures or tester.done["edits"] < count else 0


if __name__ == "__main__":
    sys.exit(main())
