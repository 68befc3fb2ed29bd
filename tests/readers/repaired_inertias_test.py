# SPDX-License-Identifier: BSD-3-Clause
"""Do robots whose inertias --fix-inertia has repaired load without a message about inertia, and hang still?

Usage: repaired_inertias_test.py SMURF-LINT SMURF-LOAD-CHECK SCRATCH

Pendulums of boxes, cylinders and shapeless links, each with a tensor that no body, or not this one, can have. Only
the values of masses and inertias may change.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SKIPPED = 77
# Mass, size along the link, and half of the thickness of the links.
LINKS = [(1.5, 0.3, 0.03), (0.8, 0.2, 0.02), (0.3, 0.1, 0.015)]


def tensor(mass, length, radius):
    across = mass * (length ** 2 + 3 * radius ** 2) / 12
    return [across, across, mass * radius ** 2 / 2, 0, 0, 0]


def swapped(t):
    """The order of a lower triangle: xx xy yy xz yz zz in the slots ixx ixy ixz iyy iyz izz."""
    xx, yy, zz, xy, xz, yz = t
    return [xx, xz, zz, xy, yy, yz]


DEFECTS = {
    "sign": lambda t: [t[0], -t[1], *t[2:]],
    "decimal point": lambda t: [10 * t[0], *t[1:]],
    "zero": lambda t: [0] * 6,
    "rod": lambda t: [t[0], t[1], 0, *t[3:]],
    "order": swapped,
    "g mm2": lambda t: [1e9 * entry for entry in t],
    "product": lambda t: [*t[:3], 2 * t[0], 0, 0],
    "large product": lambda t: [*t[:4], 3 * t[2], 0],
}


def shape(form, length, radius):
    if form == "box":
        return f'<geometry><box size="{2 * radius} {2 * radius} {length}"/></geometry>'
    return f'<geometry><cylinder radius="{radius}" length="{length}"/></geometry>'


def robot(form, defect):
    text = f'<?xml version="1.0"?>\n<robot name="pendulum">\n  <!-- {form} -->\n  <link name="base">\n    <inertial><mass value="5"/>'
    text += '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>\n  </link>\n'
    above, drop = "base", 0
    for number, (mass, length, radius) in enumerate(LINKS):
        t = defect(tensor(mass, length, radius))
        name = f"rod_{number}"
        text += f"""  <link name="{name}">
    <inertial>
      <origin xyz="0 0 {-length / 2}"/>
      <mass   value="{mass}"/>  <!-- weighed -->
      <inertia ixx='{t[0]:.6g}' ixy="{t[3]:.6g}" ixz="{t[4]:.6g}"
               iyy="{t[1]:.6g}" iyz="{t[5]:.6g}" izz="{t[2]:.6g}" />
    </inertial>
"""
        if form != "none":
            text += f"""    <collision><origin xyz="0 0 {-length / 2}"/>{shape(form, length, radius)}</collision>\n"""
        text += f"""  </link>
  <joint name="{name}_joint" type="revolute">
    <parent link="{above}"/><child link="{name}"/><origin xyz="0 0 {-drop}"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="10" velocity="10"/><dynamics damping="0.1"/>
  </joint>
"""
        above, drop = name, length + 0.005
    return text + "</robot>\n"


def without_numbers(text):
    return re.sub(r"""(\b(?:value|i[xyz]{2})=)(["'])[^"']*\2""", r"\1\2\2", text)


def run(*command, **keywords):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **keywords)


def readings(command, files):
    done = run(*command, input="".join(f"{file}\n" for file in files))
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def complaints(name, command, files):
    answers = readings(command, files)
    failed = [one for one in answers if one["verdict"] != "takes" or "nertia" in one.get("message", "")]
    print(f"{name}: {len(answers)} robots, {len(failed)} with a message")
    lost = len(files) - len(answers)
    return [f"{name}: {one['file']}: {one['message']}" for one in failed] + [f"{name}: {lost} without answer"] * (lost > 0)


def repair(lint, folder):
    """The repaired files, and what is wrong with the edits."""
    files, failures = [], []
    for form in ("box", "cylinder", "none"):
        for defect, change in DEFECTS.items():
            if form == "none" and defect in ("zero", "g mm2", "decimal point", "order"):
                continue  # without shapes, nothing says what the tensor should be
            file = folder / f"{form}-{defect.replace(' ', '_')}.urdf"
            before = robot(form, change)
            file.write_text(before)
            done = run(lint, "--isolated", "--fix-inertia", "--fix-only", file)
            after = file.read_text()
            if done.returncode != 0 or after == before:
                failures.append(f"{file.name}: not repaired: {done.stderr}")
            if without_numbers(after) != without_numbers(before):
                failures.append(f"{file.name}: bytes outside of the numbers have changed")
            left = run(lint, "--isolated", "--select", "SML1511,SML1512,SML1513,SML1518,SML1523", "--format", "json", file)
            failures += [f"{file.name}: {one['message']}" for one in json.loads(left.stdout)["diagnostics"]]
            files.append(file)
    return files, failures


def main(lint, load_check, scratch):
    scratch = pathlib.Path(scratch)
    python = ROOT / "build/readers/python/bin/python"
    has_mujoco = python.exists() and run(python, "-c", "import mujoco").returncode == 0
    with tempfile.TemporaryDirectory() as temporary:
        files, failures = repair(lint, pathlib.Path(temporary))
        read_by = 0
        for name in ("sdformat_robot", "dart_robot"):
            if (scratch / name).exists():
                failures += complaints(name, [scratch / name], files)
                read_by += 1
        if has_mujoco:
            failures += complaints("mujoco", [python, ROOT / "tests/verdicts/mujoco_robot.py"], files)
            read_by += 1
        for file in files:
            done = run(load_check, "--format", "json", file)
            found = json.loads(done.stdout).get("diagnostics", [])
            failures += [f"smurf-load-check: {file.name}: {one['id']} {one['message']}" for one in found
                         if one["severity"] != "info"]
        print(f"{len(files)} robots, {len(failures)} failures")
    for failure in failures:
        print(failure)
    if failures:
        return 1
    return 0 if read_by else SKIPPED


sys.exit(main(*sys.argv[1:]))
