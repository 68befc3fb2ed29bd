# SPDX-License-Identifier: BSD-3-Clause
"""A literal in a xacro file is damaged: is the finding at the damaged bytes?

usage: xacro_edits_test.py SMURF-LINT EDITS [SHARED-FOLDER]

Robots of our own, of several files with macros in macros, properties, blocks and YAML; with SHARED-FOLDER, public robots
as well, which are skipped without that folder. A number gets a letter, which no reader accepts: in a literal, that letter
must be in the marked bytes; in a number that an expression uses, in the marked bytes or in a label. The choice is the
same in every run.
"""
import concurrent.futures
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROBOT = """<?xml version="1.0"?>
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="parts/wheel.xacro"/>
  <xacro:property name="body" value="${xacro.load_yaml('body.yaml')}"/>
  <xacro:property name="radius" value="0.12"/>
  <xacro:property name="grip" value="0.9"/>
  <xacro:macro name="axle" params="side x effort *place">
    <xacro:wheel name="${side}" radius="${radius}" mass="0.75" effort="${effort}" friction="${grip / 10}">
      <xacro:insert_block name="place"/>
    </xacro:wheel>
    <link name="${side}_cap">
      <visual>
        <origin xyz="${x} 0.02 0.03" rpy="0 1.57 0"/>
        <geometry>
          <cylinder radius="0.015" length="0.025"/>
        </geometry>
      </visual>
    </link>
    <joint name="${side}_cap" type="fixed">
      <parent link="${side}_wheel"/>
      <child link="${side}_cap"/>
    </joint>
  </xacro:macro>
  <link name="base">
    <inertial>
      <mass value="${body['mass']}"/>
      <inertia ixx="0.11" ixy="0" ixz="0" iyy="0.12" iyz="0" izz="0.13"/>
    </inertial>
  </link>
  <xacro:axle side="left" x="0.21" effort="11.5">
    <origin xyz="0.31 0.32 0.33" rpy="0 0 0.34"/>
  </xacro:axle>
  <xacro:axle side="right" x="-0.22" effort="12.5">
    <origin xyz="-0.35 0.36 0.37"/>
  </xacro:axle>
</robot>
"""
WHEEL = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="name radius mass effort friction:=0.05 *origin">
    <link name="${name}_wheel">
      <inertial>
        <origin xyz="0 0 0.001"/>
        <mass value="${mass}"/>
        <inertia ixx="0.0041" ixy="0" ixz="0" iyy="0.0042" iyz="0" izz="0.0043"/>
      </inertial>
      <collision>
        <geometry>
          <sphere radius="${radius}"/>
        </geometry>
      </collision>
    </link>
    <joint name="${name}_wheel" type="continuous">
      <parent link="base"/>
      <child link="${name}_wheel"/>
      <xacro:insert_block name="origin"/>
      <axis xyz="0 1 0"/>
      <limit effort="${effort}" velocity="6.5"/>
      <dynamics damping="0.01" friction="${friction}"/>
    </joint>
  </xacro:macro>
</robot>
"""
BODY = "mass: 7.25\n"
OWN = {"rover.urdf.xacro": ROBOT, "parts/wheel.xacro": WHEEL, "body.yaml": BODY}
NUMBER = re.compile(r"(?<![\w.$'-])-?\d+\.\d+(?![\w.])")


def places(text, is_yaml):
    """Offsets behind the numbers in values of attributes, without comments and the declaration."""
    if is_yaml:
        return [one.end() for one in NUMBER.finditer(text)]
    plain = re.sub(r"<!--.*?-->|<\?.*?\?>", lambda comment: " " * len(comment[0]), text, flags=re.S)
    values = [value for value in re.finditer(r"=\s*(\"[^\"<]*\"|'[^'<]*')", plain)]
    return [one.end() for value in values for one in NUMBER.finditer(plain, value.start(1), value.end(1))]


def offset(text, line, column):
    lines = text.split("\n")
    return sum(len(one) + 1 for one in lines[:line - 1]) + column - 1


def findings(tool, folder, entry, arguments):
    done = subprocess.run([tool, entry, *arguments, "--format", "json", "--select", "SML18,SML33,SML11,SML14,SML15,SML16", "--no-ignore-files"],
                          cwd=folder, capture_output=True, timeout=600, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{entry}: exit code {done.returncode}: {done.stderr[-500:]!r}")
    return json.loads(done.stdout)["diagnostics"]


def spans(found):
    """File, first and last place of a finding and of its labels."""
    for one in (found, *found.get("labels", [])):
        if "line" in one:
            yield (one["file"], one["line"], one["column"],
                   one.get("end_line", one["line"]), one.get("end_column", one["column"]))


def lands(found, path, text, at):
    return any(file == path and offset(text, line, column) <= at < offset(text, end_line, end_column)
               for file, line, column, end_line, end_column in spans(found))


def try_edit(tool, folder, entry, arguments, path, at, known):
    """What is wrong; "" if nothing, none if the number has no influence on the robot."""
    file = folder / path
    text = file.read_text("utf8")
    edited = text[:at] + "q" + text[at:]
    file.write_text(edited, "utf8")
    try:
        new = [one for one in findings(tool, folder, entry, arguments) if (one["id"], one["message"]) not in known]
    finally:
        file.write_text(text, "utf8")
    if not new:
        return None
    if any(lands(one, path, edited, at) for one in new):
        return ""
    line = text.count("\n", 0, at) + 1
    first = {key: new[0].get(key) for key in ("id", "message", "file", "line", "column")}
    return f"{entry}: {path}:{line}: {text.splitlines()[line - 1].strip()[:100]}: {first}"


def check_robot(tool, folder, entry, arguments, files, most, random_):
    known = {(one["id"], one["message"]) for one in findings(tool, folder, entry, arguments)}
    all_places = [(path, at) for path in files
                  for at in places((folder / path).read_text("utf8"), path.endswith(".yaml"))]
    random_.shuffle(all_places)
    landed, failures = 0, []
    for path, at in all_places:
        if landed + len(failures) >= most:
            break
        problem = try_edit(tool, folder, entry, arguments, path, at, known)
        landed += problem == ""
        failures += [problem] if problem else []
    return landed, failures


def check_own(tool, most):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for path, text in OWN.items():
            (folder / path).parent.mkdir(exist_ok=True)
            (folder / path).write_text(text, "utf8")
        total = sum(len(places(text, path.endswith(".yaml"))) for path, text in OWN.items())
        landed, failures = check_robot(tool, folder, "rover.urdf.xacro", [], list(OWN), most, random.Random(1))
        # Every number of this robot is used, but for the default of a parameter that all calls set.
        used = total - 1
        return landed, failures + ([] if landed + len(failures) >= min(most, used) else ["numbers without influence"])


def check_public(tool, shared, most):
    rows = [line.split("\t") for line in (shared / "entries.tsv").read_text("utf8").splitlines() if line[0] != "#"]
    rows = [row for row in rows if not row[5].strip()]  # those that need no other repository
    each = max(1, -(-most // len(rows)) + 1)

    def one(row):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            shutil.copytree(shared / "corpus" / row[0], folder / "r", symlinks=True)
            entry = "r/" + row[1]
            files = sorted({found for found in included(folder, entry)})
            return check_robot(tool, folder, entry, row[2].split(), files, each, random.Random(row[0] + row[1]))

    def included(folder, entry):
        """The xacro files below the entry's package; those that are not read have no influence."""
        text = (folder / entry).read_text("utf8", "replace")
        names = set(re.findall(r"([\w.-]+\.xacro)", text)) | {pathlib.Path(entry).name}
        for path in folder.rglob("*.xacro"):
            if path.name in names and path.is_file() and not path.is_symlink():
                try:
                    path.read_text("utf8")
                except UnicodeDecodeError:
                    continue
                yield str(path.relative_to(folder))

    landed, failures = 0, []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for count, problems in pool.map(one, rows):
            landed += count
            failures += problems
    return landed, failures


def main():
    tool, most = sys.argv[1], int(sys.argv[2])
    if len(sys.argv) < 4:
        landed, failures = check_own(tool, most)
    else:
        shared = pathlib.Path(sys.argv[3]).resolve() / "xacro"
        if not (shared / "entries.tsv").is_file():
            print(f"skipped: there is no {shared}")
            return 77
        landed, failures = check_public(tool, shared, most)
        if landed + len(failures) < most:
            failures.append("fewer edits than expected")
    print(f"{landed} of {landed + len(failures)} edits have a finding at their bytes")
    print("\n".join(failures[:50]))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
