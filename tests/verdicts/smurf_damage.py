#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""SMURF models and scenes with one damage each, always the same ones, for the readers that SMURF has of its own.

usage: smurf_damage.py FOLDER    writes them, a folder each

The name of a case says where and how what smurf_model.py holds is damaged: `motors/0/maxSpeed:word`. Cases `urdf/...` are
a selection of those of damage.py.
"""
import collections
import copy
import pathlib
import re
import sys
from dataclasses import dataclass, field

import damage
import robot as robots
import smurf_model as model
from smurf_model import Raw

EVERY = 24  # one case here for this number of cases of damage.py
THOROUGH = 2
CORE = {"null", "word", "unknown"}
LIKE_OTHERS = {"y", "z", "g", "b", "a"}  # like x and r, which precede them
NAMES = {"link", "joint", "name", "id", "jointnames", "jointnames_active", "jointnames_independent", "jointnames_spanningtree",
         "sensors", "motors", "parent", "anchor", "pose", "mimic_motor"}


@dataclass
class Case:
    name: str
    main: str                 # the input of a reader, from the folder of the case
    files: dict = field(default_factory=dict)
    twin: str = "model"       # the case without this damage


def model_files(sections, urdf=model.URDF):
    names = [f"m_{name}.yml" for name in sections]
    files = {"urdf/m.urdf": urdf, "meshes/cube.obj": model.CUBE,
             "smurf/m.smurf": model.yaml({"modelname": "m", "files": ["../urdf/m.urdf", *names]})}
    files.update({f"smurf/m_{name}.yml": model.yaml(data) for name, data in sections.items()})
    return files


def kinds_of(key, value):
    """{kind: another value}"""
    kinds = {"null": Raw("~"), "empty": "", "list": [value], "mapping": {"a": 1}, "empty-list": [], "word": "word"}
    if isinstance(value, bool):
        kinds |= {"number": 1, "two": 2, "quoted": "true", "yes": Raw("yes"), "cased": Raw("True")}
    elif isinstance(value, (int, float)):
        kinds |= {"negative": -1.0, "zero": 0, "fraction": 0.5, "nan": Raw(".nan"), "inf": Raw(".inf"), "huge": Raw("1e400"),
                  "exponent": Raw("1e-1"), "quoted": "1.0", "comma": Raw("'1,0'"), "unit": Raw("1.0 m"), "hex": Raw("0x10"),
                  "true": True, "plus": Raw("+1.0"), "point": Raw("1.")}
    elif isinstance(value, str):
        kinds |= {"number": 5, "true": True, "padded": f" {value} ", "cased": value.swapcase(), "longer": value + "x",
                  "blanks": "a b"}
    elif isinstance(value, list):
        kinds |= {"doubled": value + value[-1:], "fewer": value[:-1], "more": value + [1.0], "scalar": value[0],
                  "null-entry": value + [Raw("~")], "number-entry": value[:-1] + [7], "mapping-entry": value + [{"a": 1}]}
    elif isinstance(value, dict):
        kinds |= {"as-list": list(value.values()), "scalar": 1.0, "more": {**value, "q": 1.0}}
    if key in NAMES and isinstance(value, str):
        kinds["unknown"] = "nobody"
    return kinds


def places(data, path=()):
    """Every key below, the outermost first: (path, value)."""
    items = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in items:
        if key in LIKE_OTHERS:
            continue
        yield (*path, key), value
        if isinstance(value, (dict, list)) and value and not (isinstance(value, list) and not isinstance(value[0], dict)):
            yield from places(value, (*path, key))


def changed(data, path, change):
    data = copy.deepcopy(data)
    above = data
    for step in path[:-1]:
        above = above[step]
    change(above, path[-1])
    return data


def renamed(name):
    def change(above, key):
        items = [(name if one == key else one, value) for one, value in above.items()]
        above.clear()
        above.update(items)
    return change


def damages(data):
    """(name, the data with this damage). The first keys of each type are damaged in every way, later ones in fewer."""
    met, types = set(), collections.Counter()
    for path, value in places(data):
        label, key = "/".join(map(str, path)), path[-1]
        yield f"{label}:dropped", changed(data, path, lambda above, one: above.pop(one))
        types[type(value)] += key not in met
        is_thorough = key not in met and types[type(value)] <= THOROUGH
        for kind, other in kinds_of(key, value).items():
            if is_thorough or kind in CORE:
                yield f"{label}:{kind}", changed(data, path, lambda above, one, other=other: above.__setitem__(one, other))
        if key in met:
            continue
        met.add(key)
        if isinstance(key, int):
            yield f"{label}:doubled", changed(data, path, lambda above, one: above.append(copy.deepcopy(above[one])))
            continue
        yield f"{label}:key-misspelt", changed(data, path, renamed(key[:-2] + key[:-3:-1]))
        yield f"{label}:key-cased", changed(data, path, renamed(key.capitalize()))


class Cases:
    def __init__(self):
        self.by_name = {}

    def add(self, name, main, files, twin):
        assert name not in self.by_name, name
        self.by_name[name] = Case(name, main, files, twin)


def add_sections(cases):
    together = {name: data for name, data in model.SECTIONS.items() if name not in model.APART}
    cases.add("model", "smurf/m.smurf", model_files(together), "model")
    for name, data in model.SECTIONS.items():
        twin, sections = "model", together
        if name in model.APART:
            twin, sections = f"model+{name}", {**together, name: data}
            cases.add(twin, "smurf/m.smurf", model_files(sections), twin)
        for label, other in damages(data):
            cases.add(label, "smurf/m.smurf", model_files({**sections, name: other}), twin)
        cases.add(f"{name}:plural", "smurf/m.smurf", model_files({**sections, name: with_other_number(data)}), twin)
    add_more_entries(cases, together)


def with_other_number(data):
    """`joint` for `joints`, `motors` for `motor`."""
    (name, section), = data.items()
    return {name[:-1] if name.endswith("s") else name + "s": section}


def add_more_entries(cases, together):
    """Faults for all readers, or for one reader only, caused by an additional entry."""
    sensor = {"name": "one", "link": "hand", "rate": 40}
    types = ("RaySensor", "ScanningSonar", "JointLoad", "JointTorque", "JointAVGTorque", "MultiLevelLaserRangeFinder",
             "NodeVelocity", "NodeAngularVelocity", "NodeRotation", "NodeCOM", "NodeContact", "NodeContactForce", "HapticField",
             "IMU", "GPS", "Multibeam", "MotorPosition", "camera", "Nonsense")
    lists = {"Joint": ["waist"], "Node": ["hand"], "Motor": ["waist"]}
    for kind in types:
        ids = next((ids for start, ids in lists.items() if kind.startswith(start)), None)
        entry = {**sensor, "type": kind, **({"id": ids} if ids else {})}
        cases.add(f"sensors:{kind}", "smurf/m.smurf", with_entry(together, "sensors", entry), "model")
    more = {
        "contact-collisions": ("sensors", {**sensor, "type": "NodeContact", "id": ["hand_hull"]}),
        "six-with-joint": ("sensors", {**sensor, "type": "Joint6DOF", "joint": "wrist"}),
        "six-at-root": ("sensors", {**sensor, "type": "Joint6DOF", "link": "base"}),
        "position-first": ("sensors", {**sensor, "type": "CameraSensor", "position_offset": {"x": 0.0, "y": 0.0, "z": 1.0},
                                       "orientation_offset": {"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0}}),
        "position-alone": ("sensors", {**sensor, "type": "CameraSensor", "position_offset": {"x": 0.0, "y": 0.0, "z": 1.0}}),
        "euler": ("sensors", {**sensor, "type": "CameraSensor", "orientation_offset": {"roll": 0.0, "pitch": 10.0, "yaw": 0.0}}),
        "mimic": ("motors", {"name": "follow", "joint": "wrist", "type": "PID", "minValue": -1.0, "maxValue": 1.0, "maxEffort": 1.0,
                             "maxSpeed": 1.0, "mimic_motor": "waist", "mimic_multiplier": 2.0, "mimic_offset": 0.1}),
        "mimic-unknown": ("motors", {"name": "follow", "joint": "wrist", "type": "PID", "maxEffort": 1.0, "maxSpeed": 1.0,
                                     "mimic_motor": "nobody"}),
        "of-fixed": ("motors", {"name": "stuck", "joint": "mount", "type": "PID", "maxEffort": 1.0, "maxSpeed": 1.0}),
        "unknown-material": ("materials", {"name": "nobody", "diffuseColor": model.color(0.1)}),
        "unknown-collision": ("collision", {"name": "nobody", "link": "arm", "bitmask": 1}),
        "unknown-visual": ("visuals", {"name": "nobody", "link": "arm"}),
        "unknown-joint": ("joint", {"name": "nobody", "springDamping": 1.0}),
        "unknown-link": ("link", {"name": "nobody", "linear_damping": 1.0}),
        "dependent": ("joint", {"name": "wrist", "depends_on": ["waist"]}),
        "pose-of-fixed": ("poses", {"name": "other", "joints": {"mount": 0.1}}),
        "pose-outside": ("poses", {"name": "other", "joints": {"waist": 9.0, "wrist": 0.0}}),
        "include": ("motors", {"URI": "more.yml", "name": "waist", "joint": "waist"}),
    }
    for label, (section, entry) in more.items():
        cases.add(f"{section}:{label}", "smurf/m.smurf", with_entry(together, section, entry), "model")


def with_entry(sections, name, entry):
    (key, entries), = sections[name].items()
    return model_files({**sections, name: {key: [*entries, entry]}})


def add_files(cases):
    files = cases.by_name["model"].files
    main = {"modelname": "m", "files": re.findall(r"[\w./]+\.(?:urdf|yml)", files["smurf/m.smurf"])}
    for label, other in damages(main):
        cases.add(f"main/{label}", "smurf/m.smurf", {**files, "smurf/m.smurf": model.yaml(other)}, "model")
    lists = {
        "urdf-last": main["files"][1:] + main["files"][:1], "urdf-twice": main["files"][:1] + main["files"],
        "missing-urdf": ["../urdf/none.urdf", *main["files"][1:]], "missing-yml": main["files"] + ["none.yml"],
        "missing-yaml": main["files"] + ["none.yaml"], "missing-other": main["files"] + ["none.txt"],
        "twice": main["files"] + main["files"][-1:], "backslash": [one.replace("/", "\\") for one in main["files"]],
        "cased": [one.replace("urdf", "URDF") for one in main["files"]], "through-none": ["../none/../urdf/m.urdf", *main["files"][1:]],
        "folder": main["files"] + ["../meshes"], "main-itself": main["files"] + ["m.smurf"],
    }
    for label, names in lists.items():
        cases.add(f"main/files:{label}", "smurf/m.smurf",
                  {**files, "smurf/m.smurf": model.yaml({**main, "files": names})}, "model")
    texts = {
        "empty": lambda text: "", "comment": lambda text: "# nothing\n", "scalar": lambda text: "word\n", "list": lambda text: "- 1\n",
        "null": lambda text: "~\n", "tab": lambda text: "\t" + text, "unclosed": lambda text: text + "x: [1, 2\n",
        "unclosed-quote": lambda text: text + "x: 'a\n", "two-documents": lambda text: text + "---\n" + text,
        "doubled-key": lambda text: text + text, "crlf": lambda text: text.replace("\n", "\r\n"),
        "bom": lambda text: "\ufeff" + text, "latin": lambda text: "# \udce4\n" + text, "control": lambda text: text + "x: \x01\n",
        "anchor": lambda text: "x: &a 1\ny: *a\n" + text, "unknown-alias": lambda text: text + "x: *none\n",
        "merge": lambda text: "x: &a {b: 1}\ny: {<<: *a}\n" + text, "tag": lambda text: text + "x: !!float 1\n",
        "own-tag": lambda text: text + "x: !mine 1\n", "colon": lambda text: text + "x: a: b\n", "no-blank": lambda text: text + "x:1\n",
        "indent": lambda text: text + " x: 1\n", "own-section": lambda text: text + "mine: {a: 1}\n",
        "own-scalar": lambda text: text + "mine: 3\n", "own-list": lambda text: text + "mine: [1, 2]\n",
        "own-null": lambda text: text + "mine: ~\n", "number-key": lambda text: text + "3: 4\n",
    }
    for place, label in (("smurf/m.smurf", "main"), ("smurf/m_motors.yml", "annotations")):
        for kind, change in texts.items():
            cases.add(f"{label}#{kind}", "smurf/m.smurf", {**files, place: change(files[place])}, "model")
    for kind, place in (("no-mesh", "meshes/cube.obj"), ("no-annotations", "smurf/m_motors.yml")):
        cases.add(f"model#{kind}", "smurf/m.smurf", {name: text for name, text in files.items() if name != place}, "model")
    for kind, path in (("package", "package://m/meshes/cube.obj"), ("file-uri", "file:///none/cube.obj"), ("absolute", "/none/cube.obj"),
                       ("suffix", "../meshes/cube.xyz")):
        for tag in ("visual", "collision"):
            head, tail = files["urdf/m.urdf"].split(f'<{tag} name="arm', 1)
            urdf = head + f'<{tag} name="arm' + tail.replace("../meshes/cube.obj", path, 1)
            cases.add(f"urdf#{tag}-{kind}", "smurf/m.smurf", {**files, "urdf/m.urdf": urdf}, "model")


def add_scenes(cases):
    files = {**cases.by_name["model"].files, "cell.smurfs": model.yaml(model.CELL)}
    for name, scene in (("scene", model.SCENE), ("world", model.WORLD), ("others", model.OTHERS)):
        cases.add(name, "s.smurfs", {**files, "s.smurfs": model.yaml(scene)}, name)
        for label, other in damages(scene):
            cases.add(f"{name}/{label}", "s.smurfs", {**files, "s.smurfs": model.yaml(other)}, name)
    with_entities = {"entities": model.SCENE["smurfs"]}
    cases.add("scene:entities", "s.smurfs", {**files, "s.smurfs": model.yaml(with_entities)}, "scene")
    cases.add("scene:itself", "cell.smurfs", {**files, "cell.smurfs": model.yaml(
        {"smurfs": [{"name": "again", "type": "smurfs", "file": "cell.smurfs"}]})}, "scene")
    missing = {**files, "s.smurfs": model.yaml(model.SCENE)}
    for place in ("cell.smurfs", "urdf/m.urdf", "meshes/cube.obj", "smurf/m_motors.yml"):
        cases.add(f"scene#no-{place}", "s.smurfs", {name: text for name, text in missing.items() if name != place}, "scene")


def add_urdfs(cases):
    meshes = robots.meshes()
    for number, (name, case) in enumerate(damage.all_cases().items()):
        if number % EVERY == 0:
            cases.add(f"urdf/{name}", "urdf/m.urdf", {"urdf/m.urdf": case.text, **{f"urdf/{one}": content
                      for one, content in meshes.items()}}, "urdf/robot")


def all_cases():
    """{name: Case}; each follows its twin"""
    cases = Cases()
    add_sections(cases)
    add_files(cases)
    add_scenes(cases)
    add_urdfs(cases)
    return cases.by_name


def write(cases, folder):
    """{name: path of the main file}"""
    paths = {}
    for number, (name, case) in enumerate(cases.items()):
        place = folder / f"{number:04}"
        for path, text in case.files.items():
            (place / path).parent.mkdir(parents=True, exist_ok=True)
            (place / path).write_bytes(text if isinstance(text, bytes) else text.encode(errors="surrogateescape"))
        paths[name] = place / case.main
    return paths


if __name__ == "__main__":
    print(len(write(all_cases(), pathlib.Path(sys.argv[1]))))
