# SPDX-License-Identifier: BSD-3-Clause
"""Nothing is lost silently: whatever annotation can be changed without a change of what
smurf2urdf writes, its loss report names, with file, line, pointer and class.

Of each list of entries, values are changed one at a time, each key where it comes first. Words that
say which link or joint an entry is about say nothing more.

Usage: losses_test.py CASES
"""
import json
import pathlib
import re
import shutil
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402

try:
    import yaml
except ImportError:
    print("skipped: python3-yaml is not installed; see scripts/setup --readers")
    sys.exit(77)

FIXTURES = pathlib.Path(__file__).resolve().parent.parent.parent / "build/fixtures/models"
CLASSES = {"not-expressible", "not-requested", "ambiguous"}
OPTIONS = {"default": [],
           "everything": ["--apply", "all", "--sensors", "gazebo", "--actuation", "ros2_control",
                          "--srdf", "out.srdf"]}
# These keys name the subject of an entry; the linter checks whether they agree.
REFERENCES = {"name", "link", "joint", "parent", "child", "joint_type", "motor", "mimic_motor"}
# An SRDF states which links collide without bits; and a quaternion of one component is normalised.
SAID_OTHERWISE = {"bitmask", "orientation_offset/w"}
# Data about the files, not about the robot.
OF_THE_MAIN_FILE = {"modelname", "files", "date", "SMURF version", "version", "description"}


def leaves(node, pointer=""):
    """(pointer, container, key) of each value."""
    items = node.items() if isinstance(node, dict) else enumerate(node)
    for key, value in items:
        place = f"{pointer}/{key}"
        if isinstance(value, (dict, list)) and value:
            yield from leaves(value, place)
        else:
            yield place, node, key


def changed(value):
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return value + 1 if isinstance(value, int) else value + 0.125
    return f"{value}_changed" if isinstance(value, str) else ["changed"]


class Model:
    def __init__(self, tools, folder, options):
        self.tools, self.folder, self.options = tools, folder, options

    def export(self):
        """The result, and the losses."""
        command = ["smurf2urdf", "smurf/arm.smurf", "-o", "out.urdf", "--loss-report", "lost.json",
                   "--force", "--quiet", *self.options]
        self.tools.run(*command, cwd=self.folder).check_returncode()
        written = [(self.folder / name).read_text() for name in ("out.urdf", "out.srdf")
                   if (self.folder / name).exists()]
        return written, json.loads((self.folder / "lost.json").read_text())["losses"]


def is_named(losses, file, pointer):
    """The value itself, or its parent."""
    return any(loss["file"].endswith(file) and f"{pointer}/".startswith(f"{loss['pointer']}/")
               for loss in losses)


def check_places(losses, folder, failures):
    for loss in losses:
        lines = (folder / loss["file"]).read_text().splitlines()
        if loss["class"] not in CLASSES or not loss["pointer"].startswith("/"):
            failures.append(f"incomplete: {loss}")
        elif not re.search(r"/\d+$", loss["pointer"]) and (
                loss["pointer"].rsplit("/", 1)[-1] not in lines[loss["line"] - 1]):
            failures.append(f"not there: {loss}: {lines[loss['line'] - 1]}")


def says_something(path, pointer):
    words = pointer.split("/")
    return not (words[-1] in REFERENCES or words[-1] in SAID_OTHERWISE
                or "/".join(words[-2:]) in SAID_OTHERWISE
                or (path.suffix == ".smurf" and words[1] in OF_THE_MAIN_FILE))


def check(tools, source, options, failures):
    """The number of changed values."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "model"
        shutil.copytree(source, folder)
        model = Model(tools, folder, options)
        before, losses = model.export()
        check_places(losses, folder, failures)
        count, seen = 0, set()
        for path in sorted((folder / "smurf").iterdir()):
            text = path.read_text()
            document = yaml.safe_load(text)
            for pointer, container, key in list(leaves(document)):
                kind = path.name + re.sub(r"\d+", "*", pointer)
                if kind in seen or not says_something(path, pointer):
                    continue
                seen.add(kind)
                count += 1
                value = container[key]
                container[key] = changed(value)
                path.write_text(yaml.safe_dump(document, sort_keys=False, allow_unicode=True))
                container[key] = value
                after, losses = model.export()
                if after == before and not is_named(losses, path.name, pointer):
                    failures.append(f"{source.name} {options}: {path.name}{pointer} can be changed "
                                    "silently")
            path.write_text(text)
        return count


def main():
    failures = []
    with cases.Cases(sys.argv[1]) as tools:
        for source in (FIXTURES / "arm", FIXTURES / "arm_phobos2"):
            for name, options in OPTIONS.items():
                count = check(tools, source, options, failures)
                print(f"{source.name}, {name} options: {count} values changed")
    sys.exit("\n".join(failures) or 0)


if __name__ == "__main__":
    main()
