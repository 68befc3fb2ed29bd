# SPDX-License-Identifier: BSD-3-Clause
"""What readers did with the damaged robots: running them, and the tables of it.

A cell says `refuses`, `crashes` (or hangs), `same` (the robot of the case without the damage), or
what is another: `masses,limits`; `taken` where the reader does not take the other case.
"""
import concurrent.futures
import json
import math
import os
import pathlib
import re
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
NODE_MODULES = HERE.parent.parent / "build/readers/node_modules"
PYTHON = HERE.parent.parent / "build/readers/python/bin/python"
TABLE = HERE / "executed.tsv"
DRAKE_TABLE = HERE / "drake_executed.tsv"  # of robots with elements that only Drake reads
FILES_A_RUN = 400
FOLDER = None  # in which readers run; none: that of the first file
SECONDS_A_RUN = 900
TOLERANCE = 1e-9  # relative, because a reader gives the same results for the same numbers
REFUSED = ("refuses", "crashes")


def command_version(*command):
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return ""
    return done.stdout.strip()


def npm_version(name):
    return json.loads((NODE_MODULES / name / "package.json").read_text())["version"]


def python_version(package):
    return command_version(PYTHON, "-c", f"import importlib.metadata; print(importlib.metadata.version('{package}'))")


def as_it_is(text):
    return text


def with_obj(text):
    """Drake refuses each robot whose collision is an STL file, so that nothing else would be seen."""
    return text.replace(b"cube.stl", b"cube.obj")


class Reader:
    """`text_of` gives the text of a case for this reader."""

    def __init__(self, name, command, version, text_of=as_it_is):
        self.name, self.command, self.version, self.text_of = name, command, version, text_of


def readers(build):
    """The readers that can be run here, and the names of the others."""
    found, absent = [], []
    for name, program, package in (("urdfdom", "urdfdom_robot", "urdfdom"),
                                   ("libsdformat", "sdformat_robot", "sdformat12"), ("DART", "dart_robot", "dart")):
        version = command_version("dpkg-query", "-W", "-f=${Version}", "liburdfdom-dev") if package == "urdfdom" \
            else command_version("pkg-config", "--modversion", package)
        path = build / program
        if path.exists():
            found.append(Reader(name, [path], version))
        else:
            absent.append(name)
    for version, program in (("4.0.1", "urdfdom4_robot"), ("6.0.0", "urdfdom6_robot")):
        name = f"urdfdom-{version[0]}"
        if (build / program).exists():
            found.append(Reader(name, [build / program], version))
        else:
            absent.append(name)
    for name, program, package in (("MuJoCo-2.3", "mujoco_robot.py", "mujoco-2.3.7"), ("MuJoCo-3.1", "mujoco_robot.py", "mujoco-3.1.6"),
                                   ("MuJoCo-3.3", "mujoco_robot.py", "mujoco-3.3.7"), ("DART-6.20", "dart_robot.py", "dartpy-6.20.0"),
                                   ("Isaac", "isaac_robot.py", "urdf-usd-converter-0.3.4")):
        folder = PYTHON.parent.parent.parent / package
        # Without the packages of the environment, whose OpenUSD is another than that of Isaac's converter.
        options = ["-S"] if name == "Isaac" else []
        if folder.is_dir():
            found.append(Reader(name, ["env", f"PYTHONPATH={folder}", PYTHON, *options, HERE / program], package.rsplit("-", 1)[1]))
        else:
            absent.append(name)
    for name, program, package in (("MuJoCo", "mujoco_robot.mjs", "@mujoco/mujoco"),
                                   ("urdf-loader", "urdf_loader_robot.mjs", "urdf-loader")):
        if shutil.which("node") and (NODE_MODULES / package).is_dir():
            found.append(Reader(name, ["node", HERE / program, NODE_MODULES], npm_version(package)))
        else:
            absent.append(name)
    for name, program, package, text_of in (("MuJoCo-4", "mujoco_robot.py", "mujoco", as_it_is),
                                            ("Bullet", "bullet_robot.py", "pybullet", as_it_is),
                                            ("Drake", "drake_robot.py", "drake", with_obj),
                                            ("Pinocchio", "pinocchio_robot.py", "pin", as_it_is),
                                            ("Newton", "newton_robot.py", "newton", as_it_is)):
        version = python_version(package)
        if version:
            found.append(Reader(name, [PYTHON, HERE / program], version, text_of))
        else:
            absent.append(name)
    return found, absent


def run_once(command, files):
    """The results for each file; a file that ends the process is the last of them."""
    folder = FOLDER or os.path.dirname(files[0])
    with subprocess.Popen([str(part) for part in command], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, cwd=folder) as process:
        try:
            output, _ = process.communicate("".join(file + "\n" for file in files).encode(), SECONDS_A_RUN)
        except subprocess.TimeoutExpired:
            process.kill()
            output, _ = process.communicate()
    said = {}
    for line in output.decode(errors="replace").splitlines():
        if line.endswith("}"):
            reading = json.loads(line)
            said[reading["file"]] = reading
    return said


def run(command, files):
    """{file: what is said of it}; a reader that ends with a file goes on with the next one."""
    said, rest = {}, list(files)
    while rest:
        more = run_once(command, rest)
        if not more:
            raise RuntimeError(f"{command[0]} does not run")
        said.update(more)
        rest = [file for file in rest if file not in said]
    return said


def read_all(reader, files):
    parts = [files[start:start + FILES_A_RUN] for start in range(0, len(files), FILES_A_RUN)]
    said = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for part in pool.map(lambda part: run(reader.command, part), parts):
            said.update(part)
    return said


def is_equal(one, other):
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(is_equal, one, other))
    if isinstance(one, (int, float)) and isinstance(other, (int, float)):
        return math.isclose(one, other, rel_tol=TOLERANCE, abs_tol=1e-12)
    return one == other


def differences(robot, twin):
    """The differing parts, by the words before the colons of the keys."""
    keys = robot.keys() | twin.keys()
    changed = {key.split(":")[0] for key in keys if not is_equal(robot.get(key, ""), twin.get(key, ""))}
    return ",".join(sorted(changed)) or "same"


def judge(cases, paths, said):
    """{name: cell}"""
    cells = {}
    for name, case in cases.items():
        reading, twin = said[str(paths[name])], said[str(paths[case.twin])]
        if reading["verdict"] in REFUSED:
            cells[name] = reading["verdict"]
        elif "robot" not in twin:
            cells[name] = "taken"
        else:
            cells[name] = differences(reading["robot"], twin["robot"])
    return cells


def read_table(table=TABLE):
    """{reader: version}, {name: {reader: cell}}"""
    lines = table.read_text(encoding="utf-8").splitlines()
    versions = dict(re.findall(r"([\w.-]+) ([\w.+-]+)(?:,|$)", lines[1].lstrip("# ")))
    heading = lines[2].split("\t")[1:]
    rows = (line.split("\t") for line in lines[3:])
    return versions, {row[0]: dict(zip(heading, row[1:])) for row in rows}


def write_table(table, date, versions, rows, robots="damage.py", script="record.py"):
    names = list(versions)
    lines = [f"# What readers did with the robots of {robots} on {date}; written by {script}, not to be edited.",
             "# " + ", ".join(f"{name} {version}" for name, version in versions.items()),
             "\t".join(["case", *names])]
    lines += ["\t".join([name, *(cells[reader] for reader in names)]) for name, cells in rows.items()]
    table.write_text("\n".join(lines) + "\n", encoding="utf-8")
