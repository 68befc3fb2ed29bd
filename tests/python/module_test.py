# SPDX-License-Identifier: BSD-3-Clause
"""Promises to users of Python: types, lifetimes, errors, copies, docstrings, the programs behind -m."""
import copy
import gc
import inspect
import json
import os
import pathlib
import pickle
import shutil
import subprocess
import sys
import threading

import inputs
import numpy as np
import pytest
import smurf


def test_dump():
    """The objects have the same values as --dump-model."""
    for path in inputs.fixtures()[::3]:
        done = inputs.run("smurf-lint", "--dump-model", path)
        try:
            loaded = smurf.load_scene(path) if inputs.is_scene(path) else smurf.load_model(path)
        except smurf.Error:
            continue
        assert loaded.to_json().encode() == done.stdout, path


def test_values():
    arm = smurf.load_model(inputs.ARM)
    dump = json.loads(arm.to_json())["model"]
    assert arm.name == dump["modelname"]
    assert arm.files == [file["path"] for file in dump["files"]]
    assert [link.name for link in arm.links] == [link["name"] for link in dump["links"]]
    for link, entry in zip(arm.links, dump["links"]):
        assert (link.place.line, link.place.column) == (entry["source"]["line"], entry["source"]["column"])
        if link.inertial is None:
            assert "inertial" not in entry
            continue
        assert link.inertial.mass == entry["inertial"]["mass"]
        assert link.inertial.X_LI[:3, 3].tolist() == entry["inertial"]["X_LI"]["position"]
        inertia = entry["inertial"]["inertia"]
        assert link.inertial.inertia.shape == (3, 3)
        assert link.inertial.inertia[0, 1] == link.inertial.inertia[1, 0] == inertia["ixy"]
        for visual, shape in zip(link.visuals, entry["visuals"]):
            kind = type(visual.geometry).__name__.lower()
            assert kind == shape["geometry"]["type"]
            if kind == "mesh":
                assert visual.geometry.path == shape["geometry"]["file"]
                assert visual.geometry.exists == shape["geometry"]["exists"]
    for joint, entry in zip(arm.joints, dump["joints"]):
        assert (joint.name, joint.type, joint.parent, joint.child) == tuple(
            entry[key] for key in ("name", "type", "parent", "child"))
        assert arm.joint(joint.name) == joint and hash(arm.joint(joint.name)) == hash(joint)
    for motor, entry in zip(arm.motors, dump["annotations"]["motors"]):
        assert motor.joint == entry["values"]["joint"]
        assert motor.max_effort == entry["values"]["maxEffort"]
        place = motor.places["joint"]
        text = pathlib.Path(place.file).read_text().splitlines()[place.line - 1]
        assert text[place.column - 1:place.end_column - 1] == motor.joint
    assert len(arm.motors) == len(dump["annotations"]["motors"]) > 0


PARTS = ("limit", "dynamics", "mimic", "safety_controller", "calibration")


def test_parts_of_joints():
    """Every attribute in the schema of the dump is a property."""
    schema = json.loads((inputs.ROOT / "schemas/model-dump.schema.json").read_text())
    parts = {part: schema["definitions"]["joint"]["properties"][part]["properties"] for part in PARTS}
    written = "".join(f"<{part} " + " ".join(f'{name}="{i}"' for i, name in enumerate(names)) + "/>"
                      for part, names in parts.items())
    model = smurf.parse_urdf(
        f'<robot name="r"><link name="0"/><link name="1"/><joint name="0" type="revolute"><parent link="0"/>'
        f'<child link="1"/>{written}</joint></robot>')
    [entry] = json.loads(model.to_json())["model"]["joints"]
    for part, names in parts.items():
        read = getattr(model.joints[0], part)
        assert {name: getattr(read, name) for name in names} == entry[part], part
        assert set(read.places) == set(names) and read.place.line == 1


def test_scene():
    scene = smurf.load_scene(inputs.NESTED)
    table = scene.instance("cell/Table")
    assert table.parent == ("Base", "flange") and table.anchor == ("Base", "flange")
    assert table.model.links and table.place.file.endswith("cell.smurfs")
    with pytest.raises(KeyError):
        scene.instance("Tabel")
    with pytest.raises(ValueError):
        table.model.check()


def test_lifetimes():
    """Parts stay valid after the variables of their parents are gone."""
    motor = smurf.load_model(inputs.ARM).motors[0]
    link = smurf.load_scene(inputs.NESTED).instances[0].model.links[0]
    entity = smurf.load_scene(inputs.NESTED).flatten(links=True).instances[0]
    finding = smurf.check(inputs.FIXTURES / "rules/SML3101-unknown-joint/bad/model.smurf")[0]
    session = smurf.Session()
    loaded = session.load_model(inputs.ARM)
    del session
    for _ in range(3):
        gc.collect()
        smurf.check(inputs.ARM)
    assert motor.joint and motor.places and link.place.line > 0 and entity.links
    assert "SML3101" in finding.text() and loaded.check().errors == 0


def test_no_leaks():
    gc.collect()
    resident = lambda: int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    for round in range(60):
        model = smurf.load_model(inputs.ARM)
        model.check(), model.links, model.forward_kinematics(), smurf.check(inputs.ARM)
        if round == 20:
            before = resident()
    assert resident() - before < 1000, "pages"


def test_threads():
    expected = [str(finding) for finding in smurf.check(inputs.ARM)]
    results = []
    session = smurf.Session()

    def work():
        for _ in range(5):
            results.append([str(finding) for finding in smurf.check(inputs.ARM)])
            results.append([str(finding) for finding in session.check(inputs.ARM)])

    threads = [threading.Thread(target=work) for _ in range(4)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert results == [expected] * 40


def run_in_python(program, *arguments):
    return subprocess.run([sys.executable, "-c", program, *map(str, arguments)], capture_output=True, text=True,
                          timeout=600)


def test_first_arrays_of_threads():
    """numpy is imported for the first array, while other threads also request one."""
    done = run_in_python("""
import sys, threading, time
class Slow:
    def find_spec(self, name, path, target=None):
        if name.startswith("numpy"): time.sleep(0.001)
sys.meta_path.insert(0, Slow())
import smurf
arm = smurf.load_model(sys.argv[1])
threads = [threading.Thread(target=arm.forward_kinematics) for _ in range(8)]
[thread.start() for thread in threads]
[thread.join() for thread in threads]
""", inputs.ARM)
    assert done.returncode == 0, done.stderr


def test_end_while_threads_check():
    """Python ends daemon threads when they try to get its lock."""
    done = run_in_python("""
import sys, threading, time, smurf
def check():
    while True: smurf.check(sys.argv[1])
for _ in range(3): threading.Thread(target=check, daemon=True).start()
time.sleep(0.3)
""", inputs.ARM)
    assert (done.returncode, done.stderr) == (0, "")


def test_objects_without_a_value():
    """Python can create objects without their constructor; an object without a value would crash."""
    for name in smurf.__all__:
        cls = getattr(smurf, name)
        if inspect.isclass(cls) and not issubclass(cls, (Exception, smurf.Session, smurf.CheckRecord, bytes)):
            for make in (object.__new__, cls.__new__, cls.__base__.__new__):
                with pytest.raises(TypeError):
                    make(cls)
    with pytest.raises(TypeError):
        smurf.Session.__new__(smurf.Session)


def test_messages_are_plain(tmp_path):
    name = "a\x1b[31m\u202e\n::error::b"
    (tmp_path / f"{name}.zsmurf").write_text("no archive")
    (tmp_path / f"{name}.smurfs").write_text("smurfs: []")
    with pytest.raises(smurf.Error) as unreadable:
        smurf.load_model(tmp_path / f"{name}.zsmurf")
    with pytest.raises(ValueError) as a_scene:
        smurf.load_model(tmp_path / f"{name}.smurfs")
    for message in (str(unreadable.value), str(a_scene.value)):
        assert message.isprintable() and "error::b" in message


def test_unreadable(tmp_path):
    for path in (tmp_path / "none.smurf", tmp_path, "", "/dev/null", tmp_path / "no/urdf.urdf"):
        if path != tmp_path:  # which is searched
            assert [finding.id for finding in smurf.check(path)] == ["SML0001"]
        for load in (smurf.load_model, smurf.load_scene):
            with pytest.raises(smurf.Error):
                load(path)
    broken = tmp_path / "broken.urdf"
    broken.write_text("<robot name='a'")
    with pytest.raises(smurf.Error) as raised:
        smurf.load_model(broken)
    assert raised.value.findings and raised.value.findings[0].place.file == str(broken)
    assert str(broken) in str(raised.value)


@pytest.mark.parametrize("arguments, keywords, error", [
    ((), {}, TypeError),
    ((None,), {}, TypeError),
    ((3,), {}, TypeError),
    (("a\0b",), {}, ValueError),
    (("a.smurf", "b"), {}, TypeError),
    (("a.smurf",), {"colour": True}, TypeError),
    (("a.smurf",), {"\ud800": True}, ValueError),
    (("a.smurf",), {"select": "SML99999"}, ValueError),
    (("a.smurf",), {"select": 3}, TypeError),
    (("a.smurf",), {"select": [3]}, TypeError),
    (("a.smurf",), {"severities": {"SML3101": "fatal"}}, ValueError),
    (("a.smurf",), {"severities": ["SML3101"]}, TypeError),
    (("a.smurf",), {"targets": "abaqus"}, ValueError),
    (("a.smurf",), {"packages": {1: "b"}}, TypeError),
    (("a.smurf",), {"isolated": 1}, TypeError),
    (("a.smurf",), {"isolated": True, "config": "b"}, ValueError),
    (("a.smurf",), {"jobs": -1}, ValueError),
    (("a.smurf",), {"jobs": 10**30}, ValueError),
    (("a.smurf",), {"jobs": "many"}, TypeError),
])
def test_wrong_arguments(arguments, keywords, error):
    for load in (smurf.check, smurf.load_model, smurf.load_scene, smurf.Session().check):
        with pytest.raises(error):
            load(*arguments, **keywords)


@pytest.mark.parametrize("positions, error", [
    ({"no such joint": 0}, ValueError),
    ({"joint1_waist": "much"}, TypeError),
    ({"joint1_waist": float("nan")}, ValueError),
    ({"joint1_waist": float("inf")}, ValueError),
    ({3: 0}, TypeError),
    ([0, 1], ValueError),
    ("no such pose", ValueError),
])
def test_wrong_positions(positions, error):
    with pytest.raises(error):
        smurf.load_model(inputs.ARM).forward_kinematics(positions)


def test_other_mistakes():
    arm = smurf.load_model(inputs.ARM)
    with pytest.raises(KeyError):
        arm.link("no such link")
    with pytest.raises(TypeError):
        arm.link(3)
    with pytest.raises(AttributeError):
        arm.links[0].name = "other"
    with pytest.raises(AttributeError):
        arm.colour
    with pytest.raises(ValueError):
        smurf.load_model(inputs.NESTED)
    with pytest.raises(ValueError):
        smurf.load_scene(inputs.NESTED).flatten(dialect="none")
    with pytest.raises(ValueError):
        smurf.explain("SML99999")
    with pytest.raises(IndexError):
        smurf.check(inputs.ARM)[10**30 if False else 100000]
    for cls in (smurf.Model, smurf.Link, smurf.Finding, smurf.FlatScene):
        with pytest.raises(TypeError):
            cls()
    assert arm.links[0] != arm.joints[0] and arm != None and arm.links[0] != 3  # noqa: E711


def test_paths(tmp_path):
    """All kinds of file names: str, bytes, pathlib; also names that are not UTF-8."""
    urdf = inputs.ARM.parent.parent / "urdf/arm.urdf"
    names = {str(smurf.load_model(path).path) for path in (urdf, str(urdf), os.fsencode(urdf))}
    assert names == {str(urdf)}
    odd = os.path.join(os.fsencode(tmp_path), b"a\xff\xc3.urdf")
    with open(odd, "wb") as file:
        file.write(b'<robot name="\xff\xfe"><link name="\xc3"/><link name="\xc3"/></robot>')
    report = smurf.check(odd)
    assert report.errors and report.to_json() and report.text() and repr(report[0])
    assert os.fsencode(report[0].place.file) == odd
    try:
        model = smurf.load_model(odd)
        assert os.fsencode(model.path) == odd and repr(model) and model.to_json() and model.links
    except smurf.Error as error:
        assert error.findings


def test_docstrings():
    for name in smurf.__all__:
        item = getattr(smurf, name)
        if name == "__version__":
            continue
        assert inspect.getdoc(item), name
        if inspect.isclass(item):
            for member, value in vars(item).items():
                if not member.startswith("_"):
                    assert inspect.getdoc(value), f"{name}.{member}"


def test_explain():
    assert "unknown-joint" in smurf.explain("SML3101") and smurf.explain("unknown-joint") == smurf.explain("SML3101")


def python(*arguments, path, **environment):
    command = [sys.executable, "-m", "smurf", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=600,
                          env={**os.environ, "PATH": path, **environment})


def test_programs(tmp_path):
    done = python("lint", inputs.ARM, path="/usr/bin:/bin")
    assert done.returncode == 0 and "no findings" in done.stdout
    bad = inputs.FIXTURES / "rules/SML3101-unknown-joint/bad/model.smurf"
    assert python("lint", bad, path="/usr/bin:/bin").returncode == 1
    assert python("flatten", inputs.NESTED, path="/usr/bin:/bin").stdout.startswith("{")
    assert python(path="").returncode == 2 and python("--help", path="").returncode == 0
    assert "no command 'lnit'" in python("lnit", path="").stderr
    # Elsewhere: on PATH, or reported as missing.
    copy = tmp_path / "a/b/c/d/smurf"
    shutil.copytree(pathlib.Path(smurf.__file__).parent, copy)
    done = python("lint", inputs.ARM, path="/nowhere", PYTHONPATH=str(copy.parent))
    assert done.returncode == 2 and "neither beside this module nor on PATH" in done.stderr
    done = python("lint", inputs.ARM, path=str(inputs.BIN), PYTHONPATH=str(copy.parent))
    assert done.returncode == 0 and "no findings" in done.stdout


def test_array_types():
    arm = smurf.load_model(inputs.ARM)
    for joint in arm.joints:
        assert joint.X_PJ.dtype == np.float64 and joint.X_PJ.shape == (4, 4) and joint.X_PJ.flags["C_CONTIGUOUS"]
        assert np.allclose(joint.X_PJ[:3, :3] @ joint.X_PJ[:3, :3].T, np.eye(3), atol=1e-12)


POOL = """
import multiprocessing, operator, sys
import smurf
if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        print(*pool.map(operator.attrgetter("name"), smurf.load_model(sys.argv[1]).links))
"""


def test_objects_that_cannot_be_pickled_or_made_say_so(tmp_path):
    (tmp_path / "a.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    report = smurf.check(str(tmp_path / "a.urdf"))
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        with pytest.raises(TypeError):
            pickle.dumps(smurf.Session(), protocol)
    for one in (report, smurf.Session()):
        with pytest.raises(TypeError):
            type(one).__mro__[1]()


def test_pickles(tmp_path, monkeypatch):
    """What was loaded by path or from a text is loaded again elsewhere."""
    monkeypatch.chdir(tmp_path)
    arm = smurf.load_model(inputs.ARM, targets=["mars"])
    again = pickle.loads(pickle.dumps(arm))
    assert again.path == arm.path and again.to_json() == arm.to_json() and again != arm
    assert [verdict.target for verdict in again.check().targets] == ["mars"]
    links = pickle.loads(pickle.dumps(arm.links))
    assert [link.name for link in links] == [link.name for link in arm.links]
    assert copy.deepcopy(arm.joints[1]).axis.tolist() == arm.joints[1].axis.tolist()
    scene = smurf.load_scene(inputs.NESTED)
    model = pickle.loads(pickle.dumps(scene.models[1]))
    assert model.path == scene.models[1].path
    assert pickle.loads(pickle.dumps(scene.models[1].links[0])).name == scene.models[1].links[0].name
    assert pickle.loads(pickle.dumps(scene)).to_json() == scene.to_json()
    script = tmp_path / "pool.py"
    script.write_text(POOL)
    done = subprocess.run([sys.executable, script, inputs.ARM], capture_output=True, text=True, timeout=600)
    assert done.stdout.split() == [link.name for link in arm.links], done.stderr
    session = smurf.Session()
    session.set_text("mem.urdf", "<robot name='a'><link name='b'/></robot>")
    with pytest.raises(TypeError, match="what a Session has loaded cannot be pickled"):
        pickle.dumps(session.load_model("mem.urdf"))


def test_texts(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "box.stl").write_bytes(b"solid\nendsolid\n")
    text = "<robot name='a'><link name='b'><visual><geometry><mesh filename='box.stl'/></geometry></visual></link></robot>"
    for urdf in (text, text.encode()):
        model = smurf.parse_urdf(urdf)
        assert model.links[0].visuals[0].geometry.exists and model.check().findings
        assert pickle.loads(pickle.dumps(model)).links[0].name == "b"
    assert not smurf.parse_urdf(text, "elsewhere/robot.urdf").links[0].visuals[0].geometry.exists
    xacro = "<robot name='a' xmlns:xacro='http://ros.org/wiki/xacro'><xacro:arg name='n' default='b'/><link name='$(arg n)'/></robot>"
    assert [smurf.parse_urdf(xacro, args=args).links[0].name for args in ({}, {"n": "c"})] == ["b", "c"]
    with pytest.raises(smurf.Error):
        smurf.parse_urdf("no robot")
    with pytest.raises(TypeError):
        smurf.parse_urdf(3)
