#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""--rename on every joint, link, motor and material of public models, and back.

In each model all of them get a new name at once; then a sample of them one by one. The report must
stay the same, and renaming back must give the same bytes.
Usage: rename_corpus_test.py CASES CORPUS
"""
import collections
import json
import pathlib
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402

BY_NAMES = ("SML1303", "SML1528", "SML1529", "SML1530", "SML1535")
SUFFIX = "_renamed"
SINGLE_ONES = 500


def names_in_urdf(path):
    """(kind, name) of everything that a URDF defines."""
    try:
        root = xml.etree.ElementTree.parse(path).getroot()
    except (xml.etree.ElementTree.ParseError, OSError, ValueError, LookupError):
        return []
    names = [(child.tag, child.get("name")) for child in root
             if child.tag in ("link", "joint", "material")]
    names += [("material", material.get("name")) for material in root.findall("link/visual/material")]
    # The link `world` has a meaning by its name.
    return [(kind, name) for kind, name in names if name and (kind, name) != ("link", "world")]


def names_in_model(path):
    """The names in the URDF that a .smurf lists, and the motors."""
    names = []
    for listed in re.findall(r"^\s*-\s*([^\s#]+)\s*$", path.read_text(errors="replace"), re.M):
        file = path.parent / listed.strip("'\"")
        if file.suffix == ".urdf":
            names = names_in_urdf(file)
        elif file.suffix == ".yml" and file.is_file():
            section = re.search(r"^motors:\s*\n((?:[ -].*\n|\s*\n)*)", file.read_text(), re.M)
            found = re.findall(r"^\s*-?\s+name:\s*['\"]?(.*?)['\"]?\s*$",
                               section.group(1) if section else "", re.M)
            names += [("motor", name) for name in found]
    return names


def models_with(path):
    """The model, and other models that list the same URDF, which are renamed together."""
    def urdfs(model):
        return set(re.findall(r"[^\s'\"/]+\.urdf", model.read_text(errors="replace")))
    if path.suffix != ".smurf":
        return [path]
    return [path] + [other for other in sorted(path.parent.glob("*.smurf"))
                     if other != path and urdfs(other) & urdfs(path)]


class Corpus:
    def __init__(self, tools, folder):
        self.tools, self.folder = tools, folder
        self.errors = []

    def run(self, model, renames=()):
        command = ["smurf-lint", "--isolated", "--quiet", "--format", "json", "--fail-on", "never"]
        command += [f"--rename={rename}" for rename in renames]
        command += [path.relative_to(self.folder) for path in models_with(self.folder / model)]
        return self.tools.run(*command, cwd=self.folder)

    def bytes_around(self, model):
        """All texts that a rename could change."""
        folder = (self.folder / model).parent
        top = folder.parent if folder.name in ("smurf", "urdf") else folder
        return {path: path.read_bytes() for path in top.rglob("*")
                if path.suffix in (".urdf", ".yml", ".smurf", ".smurfs", ".srdf") and path.is_file()}

    @staticmethod
    def findings(result):
        report = json.loads(result.stdout)
        # Findings about equal names of a link and a joint, and about sides and siblings, depend on the names.
        return collections.Counter((one["id"], one["file"], one["line"])
                                   for one in report["diagnostics"] if one["id"] not in BY_NAMES)

    def check(self, model, names):
        before = self.bytes_around(model)
        found = self.findings(self.run(model))
        there = self.run(model, [f"{kind}:{name}={name}{SUFFIX}" for kind, name in names])
        if there.returncode != 0:
            return self.fail(model, names, "refused: " + there.stderr.strip())
        changed = self.findings(there)
        if changed != found:
            self.fail(model, names, f"lost {found - changed}, new {changed - found}")
        back = self.run(model, [f"{kind}:{name}{SUFFIX}={name}" for kind, name in names])
        if back.returncode != 0:
            self.fail(model, names, "refused on the way back: " + back.stderr.strip())
        differing = [path for path, text in before.items() if path.read_bytes() != text]
        for path in differing:
            self.fail(model, names, f"other bytes after renaming back: {path}")
            path.write_bytes(before[path])

    def fail(self, model, names, what):
        shown = names[0] if len(names) == 1 else f"{len(names)} names"
        self.errors.append(f"{model}: {shown}: {what}")


def main():
    program, source = sys.argv[1], pathlib.Path(sys.argv[2])
    if not source.is_dir():
        print(f"no corpus at {source}: skipped")
        return 77
    with tempfile.TemporaryDirectory() as scratch, cases.Cases(program) as tools:
        folder = pathlib.Path(scratch).resolve() / "corpus"
        shutil.copytree(source, folder, symlinks=True)
        corpus = Corpus(tools, folder)
        models = []
        for path in sorted(folder.rglob("*")):
            if path.suffix == ".smurf" or path.suffix == ".urdf":
                read = names_in_model if path.suffix == ".smurf" else names_in_urdf
                names = sorted(set(read(path)))
                if names:
                    models.append((str(path.relative_to(folder)), names))
        for model, names in models:
            corpus.check(model, names)
        every = [(model, name) for model, names in models for name in names]
        step = 7919  # a prime, so that all models are used in turn
        single = min(SINGLE_ONES, len(every))
        for number in range(single):
            model, name = every[number * step % len(every)]
            corpus.check(model, [name])
    for error in corpus.errors:
        print(error)
    kinds = collections.Counter(kind for _, (kind, _) in every)
    print(f"{len(every)} names in {len(models)} models ({dict(kinds)}): all at once in each model, "
          f"and {single} one by one; {len(corpus.errors)} errors")
    return 1 if corpus.errors else 0


if __name__ == "__main__":
    sys.exit(main())
