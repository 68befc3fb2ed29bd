# SPDX-License-Identifier: BSD-3-Clause
"""URDF to SMURF and back, for the URDFs of an export pass: the guarantees of the converters.

G0  urdf2smurf --in-place, then smurf2urdf: identical bytes, if the URDF is strict XML.
G1  urdf2smurf into a folder, then smurf2urdf: every element, attribute and text is equal, but for
    mesh paths, which name the same file, and names given to collisions that sensors refer to.
G3  urdf2smurf a second time changes nothing; export_options_test looks at smurf2urdf.
And the model has no error that the URDF has not. That masses and kinematics are kept (G4) is
proven by the tools themselves, which refuse to write anything else.

Usage: round_trip_test.py EXPORTS    EXPORTS is written by export_pass.py
"""
import os
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import exported  # noqa: E402

STEPS = ("in place", "back", "repaired", "new", "new again", "default")


def parse(path):
    try:
        return ElementTree.parse(path).getroot()
    except ElementTree.ParseError:
        return None


def is_strict(path):
    """Expat accepts any version in a declaration, other readers do not."""
    declared = re.match(rb"<\?xml\s+version\s*=\s*[\"']([^\"']*)", path.read_bytes())
    return parse(path) is not None and (declared is None or declared[1].startswith(b"1."))


def same(what, one, other):
    if one != other:
        raise AssertionError(f"{what} differ: {str(one)[:200]} ... {str(other)[:200]}")


def compare(one, other, folders):
    """`folders` are those of the two files, from which mesh paths start."""
    same("G1: tags", one.tag, other.tag)
    is_of_contact = one.tag == "collision" and (one.text or "").strip() != ""
    if not is_of_contact:  # a name that Gazebo gives; contact_sensors_test holds that it finds the shape
        same("G1: texts", one.text, other.text)
    same("G1: texts after elements", one.tail, other.tail)
    attributes = dict(other.attrib)
    if one.tag == "collision" and "name" not in one.attrib:
        attributes.pop("name", None)
    if "filename" in one.attrib and one.attrib["filename"] != attributes.get("filename"):
        paths = [one.attrib["filename"], attributes.pop("filename")]
        places = [os.path.normpath(folder / path.removeprefix("file://")) for folder, path in zip(folders, paths)]
        if paths[0].startswith("package://") and pathlib.Path(places[1]).is_file():
            below = os.path.normpath(paths[0].split("/", 3)[3])  # the folder of a package may have another name
            places = [below, places[1][-len(below):]]
        same("G1: mesh files", *places)
        attributes["filename"] = one.attrib["filename"]
    same("G1: attributes", one.attrib, attributes)
    same("G1: numbers of children", len(one), len(other))
    for child, twin in zip(one, other):
        compare(child, twin, folders)


def outside_of_urdf(errors):
    """(id, line); a motor gets the effort and speed of its joint, which may be zero (SML4103)."""
    return [(rule, line) for rule, line, is_in_urdf in errors if not is_in_urdf and rule != "SML4103"]


def check(robot):
    for step in STEPS:
        if robot.failure(step):
            raise AssertionError(robot.failure(step))
    # What readers of strict XML refuse is repaired; a second run finds nothing more to repair.
    source = robot.folder / ("source.urdf" if is_strict(robot.source) else "repaired.urdf")
    same("G0: the URDF", source.read_bytes(), (robot.folder / "in_place.urdf").read_bytes())
    one, other = parse(robot.source), parse(robot.export("default"))
    if one is not None:  # files that Python's strict reader refuses are only compared by bytes
        compare(one, other, (robot.source.parent, robot.export("default").parent))
    same("errors", outside_of_urdf(robot.record["errors"]), outside_of_urdf(robot.record["model_errors"]))
    same("G3: the files", *robot.record["sums"])


def main():
    urdfs = [robot for robot in exported.robots(sys.argv[1]) if robot.is_urdf]
    # An error only in models with annotations: MARS confuses a link and a shape of the same name.
    urdfs = [robot for robot in urdfs if "SML3114" not in str(robot.source)]
    readable = [robot for robot in urdfs if robot.is_readable]
    failures = []
    for robot in readable:
        try:
            check(robot)
        except AssertionError as failure:
            failures.append(f"{robot.source}: {failure}")
    forced = sum(not robot.is_sound for robot in readable)
    print(f"{len(readable)} URDFs made the round trip, {forced} of them, with errors, by --force; "
          f"{len(urdfs) - len(readable)} cannot be read")
    if not readable:
        failures.append("no URDF was tried")
    exported.end(failures)


if __name__ == "__main__":
    main()
