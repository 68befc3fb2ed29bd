# SPDX-License-Identifier: BSD-3-Clause
"""Models and checks of xacro files, with arguments."""
import inputs  # noqa: F401
import pytest
import smurf

ROBOT = """<?xml version="1.0"?>
<robot name="rod" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="mass" default="1"/>
  <xacro:arg name="links" default="a"/>
  <xacro:macro name="rod" params="name">
    <link name="${name}">
      <inertial><mass value="$(arg mass)"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    </link>
  </xacro:macro>
  <xacro:rod name="$(arg links)"/>
</robot>
"""


@pytest.fixture(name="path")
def robot(tmp_path):
    path = tmp_path / "rod.urdf.xacro"
    path.write_text(ROBOT)
    return path


def names(model):
    return [link.name for link in model.links]


def test_arguments_of_a_model(path):
    assert names(smurf.load_model(path)) == ["a"]
    assert names(smurf.load_model(path, args={"links": "b", "mass": 2.5})) == ["b"]
    assert smurf.load_model(path, args={"mass": 2.5}).links[0].inertial.mass == 2.5
    assert names(smurf.load_model(path, args=None)) == ["a"]


def test_arguments_of_a_check(path):
    assert not smurf.check(path).findings
    found = smurf.check(path, args={"mass": "-1"}).findings
    assert [one.id for one in found] == ["SML1509"]
    assert found[0].place.file == str(path) and found[0].place.line == 7
    assert [one.id for one in smurf.load_model(path, args={"mass": -1}).check().findings] == ["SML1509"]


def test_session(path):
    session = smurf.Session()
    session.set_text(path, ROBOT.replace('default="a"', 'default="c"'))
    assert names(session.load_model(path)) == ["c"]
    assert names(session.load_model(path, args={"links": "d"})) == ["d"]


def test_environment(path, monkeypatch):
    monkeypatch.setenv("ROD_LINK", "e")
    path.write_text(ROBOT.replace("$(arg links)", "$(env ROD_LINK)"))
    assert [one.id for one in smurf.check(path).findings] == ["SML3317"]
    assert names(smurf.load_model(path, xacro_env=["ROD_LINK"])) == ["e"]


@pytest.mark.parametrize("arguments", [["a"], {1: "b"}, {"a": ["b"]}, {"a": None}, "a:=b"])
def test_wrong_arguments(path, arguments):
    with pytest.raises(TypeError):
        smurf.load_model(path, args=arguments)
