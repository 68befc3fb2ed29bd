# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of element that libsdformat makes of a URDF is in the SDF of smurfs-flatten, or named as a loss.

Poses are not compared: libsdformat merges links on fixed joints, which stay links here, and gives
joints poses, where links have them here. tests/readers/simulators_test.py compares where links are.

Usage: gazebo_conversion_test.py SMURFS-FLATTEN BUILD FOLDER
"""
import json
import pathlib
import subprocess
import sys
import tempfile

# Marks of libsdformat for its own use.
OF_LIBSDFORMAT = {"pose", "ignition::corrected_offsets"}
# An element with this value says nothing more than its absence.
DEFAULTS = {"scale": {"1 1 1"}, "spring_reference": {"0"}, "spring_stiffness": {"0"}, "damping": {"0"},
            "friction": {"0"},
            "cfm": {"0", "0.0"}, "erp": {"0.2", "0.20000000000000001"}, "static": {"0", "false"}}
CONTAINERS = {"ode", "contact", "friction", "surface", "physics", "limit", "dynamics", "script"}
# The colour of the one script of a merged link covers all its visuals; here, it covers those of its own link.
MERGED = {"fixed_joint_reduction_collision_visual_empty_root.urdf"}


def elements(program, file):
    """Kinds of elements; none if libsdformat refuses the file."""
    done = subprocess.run([program, file], capture_output=True, encoding="utf-8", errors="replace", timeout=600,
                          check=False)
    lines = [line.split("\t") for line in done.stdout.splitlines()]
    if not lines or lines[-1] != ["end"]:
        return None
    kinds = set()
    for line in lines:
        if line[0] != "element":
            continue
        tags = [tag for tag in line[1].split("/")[1:] if tag not in ("sdf", "world", "model")]
        value = line[2].strip()
        says_nothing = value in DEFAULTS.get(tags[-1], ()) or (tags[-1] in CONTAINERS and not value) if tags else True
        if not says_nothing and not set(tags) & OF_LIBSDFORMAT:
            kinds.add("/".join(tags))
    return kinds


def missing(tool, program, urdf, folder):
    """Kinds that are neither in our SDF nor named; none if one of both refuses the URDF."""
    gazebo = elements(program, urdf)
    if not gazebo:
        return None
    command = [tool, urdf, "--format", "sdf", "-o", folder / "out.sdf", "--loss-report", folder / "lost.json",
               "--force", "--quiet", "--allow-outside"]
    if subprocess.run(command, capture_output=True, timeout=600, check=False).returncode != 0:
        return None
    ours = elements(program, folder / "out.sdf")
    if ours is None:
        return {"all, since libsdformat refuses our SDF"}
    losses = " ".join(loss["message"] for loss in json.loads((folder / "lost.json").read_text())["losses"])
    lost = {kind for kind in gazebo - ours if f"`{kind.rsplit('/', 1)[-1]}`" not in losses}
    return {kind for kind in lost if not (urdf.name in MERGED and "/material/script" in kind)}


def main():
    tool, build, corpus = (pathlib.Path(word).absolute() for word in sys.argv[1:4])
    program = build / "sdf_elements"
    if not program.exists() or not corpus.is_dir():
        print("skipped: libsdformat is not installed" if corpus.is_dir() else f"skipped: {corpus} is not there")
        sys.exit(77)
    failures, count = [], 0
    with tempfile.TemporaryDirectory() as scratch:
        for urdf in sorted(corpus.rglob("*.urdf")):
            lost = missing(tool, program, urdf, pathlib.Path(scratch))
            count += lost is not None
            failures += [f"{urdf.relative_to(corpus)}: {kind}" for kind in sorted(lost or ())]
    print(f"{count} URDFs that both convert, {len(failures)} kinds of elements missing")
    if count == 0:
        failures.append("nothing was compared")
    sys.exit("\n".join(failures) or 0)


if __name__ == "__main__":
    main()
