# SPDX-License-Identifier: BSD-3-Clause
"""Folders, formats, fixes and comparisons are those of the programs."""
import json
import pathlib
import re
import shutil

import inputs
import pytest
import smurf

MODELS = inputs.FIXTURES / "models"
SCENES = inputs.FIXTURES / "scenes"


@pytest.fixture(autouse=True)
def _programs(monkeypatch):
    monkeypatch.setenv("PATH", str(inputs.BIN), prepend=":")


def formats():
    return re.findall(r"^  (\S+) ", inputs.run("smurfs-flatten", "--format", "help").stdout.decode(), re.M)


@pytest.mark.parametrize("paths", [[MODELS], [SCENES], [MODELS / "arm", SCENES / "nested" / "outer.smurfs"], [inputs.FIXTURES]])
def test_folders(paths):
    done = inputs.run("smurf-lint", "--format", "json", *paths)
    expected = json.loads(done.stdout)
    report = smurf.check(paths[0] if len(paths) == 1 else map(str, paths))
    actual = json.loads(report.to_json())
    for one in (actual, expected):
        one.pop("tool")
        one["summary"].pop("links", None)
        one.pop("robots", None)
    assert actual["summary"] == expected["summary"]
    assert actual["diagnostics"] == expected["diagnostics"]


def test_folders_without_robots(tmp_path, capfd):
    with pytest.raises(smurf.Error, match="no .smurf, .smurfs, .smurfa, .urdf or .xacro file in"):
        smurf.check(tmp_path)
    with pytest.raises(smurf.Error, match="No such file"):
        smurf.check([MODELS, tmp_path / "nothing"])
    with pytest.raises(ValueError):
        smurf.check([])
    with pytest.raises(TypeError):
        smurf.check(3)
    assert capfd.readouterr().err == ""  # the exception says it


def test_a_session_checks_folders(tmp_path):
    shutil.copytree(MODELS / "arm", tmp_path / "arm")
    motors = tmp_path / "arm/smurf/arm_motors.yml"
    session = smurf.Session()
    assert not session.check(tmp_path).errors
    session.set_text(motors, motors.read_text().replace("joint: joint2_shoulder", "joint: joint2_sholder"))
    assert [finding.id for finding in session.check(tmp_path)] == ["SML3101"]


def test_formats(monkeypatch):
    """Each format of each scene, as smurfs-flatten writes it, or both refuse it."""
    monkeypatch.chdir(inputs.FIXTURES)
    compared = refused = 0
    files = [path.relative_to(inputs.FIXTURES) for path in (*MODELS.glob("**/*.smurf"), *SCENES.glob("**/*.smurfs"))]
    for path in sorted(files):
        load = smurf.load_scene if inputs.is_scene(path) else smurf.load_model
        for name in formats():
            done = inputs.run("smurfs-flatten", "--format", name, path)
            try:
                export = load(path).write(name)
            except smurf.Error:
                assert done.returncode == 1, (path, name)
                refused += 1
                continue
            assert done.returncode == 0, (path, name, done.stderr)
            assert export.text.encode() == done.stdout, (path, name)
            assert export.format == name and str(export) == export.text
            compared += 1
    assert compared > 100


def test_options_of_formats(tmp_path, monkeypatch):
    monkeypatch.chdir(inputs.FIXTURES)
    scene = smurf.load_scene(inputs.NESTED.relative_to(inputs.FIXTURES))
    poses = [instance.X_WE.tolist() for instance in scene.instances]
    first = scene.instances[0]
    for name, options, words in (
            ("sdf", {"ground": True, "base": "fixed"}, ["--ground", "--base", "fixed"]),
            ("json", {"links": True, "dialect": "mars"}, ["--links", "--dialect", "mars"]),
            ("mjcf", {"form": "reference"}, ["--form", "reference"])):
        done = inputs.run("smurfs-flatten", "--format", name, *words, scene.path)
        assert scene.write(name, **options).text.encode() == done.stdout
    # The scene is as it was, and so are objects that Python holds.
    assert [instance.X_WE.tolist() for instance in scene.instances] == poses
    assert first.X_WE.tolist() == poses[0] and first == scene.instances[0]
    scene.write("mjcf").save(tmp_path / "scene.xml")
    assert (tmp_path / "scene.xml").read_text() == scene.write("mjcf").text
    for options in ({"form": "x"}, {"base": "x"}, {"dialect": "x"}, {"ground": True}):
        with pytest.raises(ValueError):
            scene.write("json", **options)
    with pytest.raises(ValueError, match="not one of the formats: json"):
        scene.write("docx")


def test_losses():
    losses = smurf.load_model(inputs.ARM).write("mjcf").losses
    assert losses and all(isinstance(one, smurf.Finding) and one.id.startswith("SML82") for one in losses)
    assert not smurf.load_model(inputs.ARM).write("json").losses


def test_notebooks():
    """The robot as a page of its own, in a frame; reports and drawings as they are."""
    arm = smurf.load_model(inputs.ARM)
    if inputs.run("smurfs-flatten", "--format", "html", inputs.ARM).returncode != 0:
        assert arm._repr_html_() is None
        pytest.skip("this build has no viewer")
    frame = arm._repr_html_()
    page = arm.write("html").text
    assert frame.startswith("<iframe ") and frame.endswith("</iframe>") and frame.count("<iframe") == 1
    assert page.replace("&", "&amp;").replace('"', "&quot;") in frame
    assert smurf.load_scene(inputs.NESTED)._repr_html_().startswith("<iframe ")
    assert arm.write("svg")._repr_html_().startswith("<svg")
    assert arm.write("json")._repr_html_() is None
    bad = smurf.check(inputs.FIXTURES / "rules/SML3101-unknown-joint/bad/model.smurf")
    assert "<joint" not in bad._repr_html_() and "error[SML3101]" in bad._repr_html_()


def test_fixes(tmp_path):
    """As smurf-lint --fix leaves the files."""
    changed = {}
    folders = sorted({*sorted(inputs.FIXTURES.glob("rules/*/bad"))[::3], inputs.FIXTURES / "rules/SML1424-irrelevant-child/bad"})
    for unsafe, infos in ((False, False), (True, False), (True, True)):
        words = ["--fix", *(["--unsafe-fixes"] if unsafe else []), *(["--min-severity", "info"] if infos else [])]
        for bad in folders:
            copy = tmp_path / f"{unsafe}{infos}-{bad.parent.name}"
            shutil.copytree(bad, copy)
            try:
                texts = smurf.fix(copy, unsafe=unsafe, infos=infos)
            except smurf.Error:  # it has nothing that the name of a folder would lead to
                continue
            before = {path: path.read_bytes() for path in copy.rglob("*") if path.is_file()}
            assert not [path for path, content in texts.items() if before[pathlib.Path(path)] == content]
            inputs.run("smurf-lint", *words, copy)
            after = {str(path): path.read_bytes() for path in before if path.read_bytes() != before[path]}
            assert texts == after, (bad, words)
            changed[unsafe, infos] = changed.get((unsafe, infos), 0) + len(texts)
    assert changed[True, True] > changed[True, False] > changed[False, False] > 3
    assert smurf.fix(MODELS / "arm") == {}


def test_comparison(tmp_path):
    shutil.copytree(MODELS / "arm", tmp_path / "arm")
    urdf = tmp_path / "arm/urdf/arm.urdf"
    urdf.write_text(urdf.read_text().replace('upper="', 'upper="1'))
    new = tmp_path / "arm/smurf/arm.smurf"
    done = inputs.run("smurf-diff", "--format", "json", inputs.ARM, new)
    found = smurf.diff(inputs.ARM, new)
    expected = json.loads(done.stdout)
    assert len(found) == len(expected["differences"]) > 0
    assert found.differences == list(found) == expected["differences"]
    assert str(found) == inputs.run("smurf-diff", inputs.ARM, new).stdout.decode()
    assert not smurf.diff(inputs.ARM, inputs.ARM) and len(smurf.diff(inputs.ARM, new, 1e9)) < len(found)
    with pytest.raises(smurf.Error, match="is a scene and"):
        smurf.diff(inputs.ARM, inputs.NESTED)
    with pytest.raises(smurf.Error):
        smurf.diff(inputs.ARM, tmp_path / "nothing.urdf")


def test_conversions(tmp_path):
    """Each program, chosen by the output."""
    urdf = MODELS / "arm/urdf/arm.urdf"
    smurf.convert(urdf, f"{tmp_path}/new/", motors="all", copy_meshes=True)
    made = smurf.load_model(tmp_path / "new/smurf/arm.smurf")
    assert len(made.motors) == 6 and all(link.visuals is not None for link in made.links)
    assert list((tmp_path / "new/meshes").iterdir())
    smurf.convert(made.path, tmp_path / "plain.urdf", prefix="left_")
    assert smurf.load_model(tmp_path / "plain.urdf").links[0].name.startswith("left_")
    said = smurf.convert(made.path, tmp_path / "arm.xml", format="mjcf", copy_assets=tmp_path / "assets")
    assert "smurfs-flatten: wrote" in said and (tmp_path / "arm.xml").read_text().count("<mujoco") == 1
    with pytest.raises(smurf.Error, match="unknown option '--presett'; did you mean '--preset'"):
        smurf.convert(made.path, tmp_path / "other.urdf", presett="ros2")
    assert not (tmp_path / "other.urdf").exists()
