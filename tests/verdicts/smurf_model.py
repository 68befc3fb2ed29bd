# SPDX-License-Identifier: BSD-3-Clause
"""The SMURF model and the scene that smurf_damage.py damages: every section that Phobos 2 or MARS 1 reads, taken by both."""

URDF = """<robot name="m">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base">
    <inertial><origin xyz="0 0 0.1"/><mass value="8"/><inertia ixx="0.2" ixy="0" ixz="0" iyy="0.25" iyz="0" izz="0.3"/></inertial>
    <visual name="base_look"><geometry><box size="0.6 0.5 0.2"/></geometry><material name="grey"/></visual>
    <collision name="base_hull"><geometry><box size="0.6 0.5 0.2"/></geometry></collision>
  </link>
  <link name="arm">
    <inertial><origin xyz="0 0 0.3"/><mass value="1.5"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.025" iyz="0" izz="0.03"/></inertial>
    <visual name="arm_look"><geometry><mesh filename="../meshes/cube.obj"/></geometry><material name="grey"/></visual>
    <collision name="arm_hull"><geometry><mesh filename="../meshes/cube.obj"/></geometry></collision>
  </link>
  <link name="hand">
    <inertial><origin xyz="0 0 0.1"/><mass value="1"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.025" iyz="0" izz="0.03"/></inertial>
    <visual name="hand_look"><geometry><cylinder radius="0.1" length="0.3"/></geometry><material name="grey"/></visual>
    <collision name="hand_hull"><geometry><cylinder radius="0.1" length="0.3"/></geometry></collision>
  </link>
  <link name="cap">
    <inertial><mass value="0.5"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    <visual name="cap_look"><geometry><sphere radius="0.1"/></geometry><material name="grey"/></visual>
    <collision name="cap_hull"><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <joint name="waist" type="revolute">
    <origin xyz="0 0 0.2" rpy="0 0 0.3"/><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
  <joint name="wrist" type="revolute">
    <origin xyz="0 0 0.6"/><parent link="arm"/><child link="hand"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="5" velocity="3"/>
  </joint>
  <joint name="mount" type="fixed"><origin xyz="0 0 0.3"/><parent link="hand"/><child link="cap"/></joint>
</robot>
"""

CUBE = "".join(f"v {x} {y} {z}\n" for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (-0.1, 0.1)) + "".join(
    f"f {face}\n" for face in ("1 2 4", "1 4 3", "5 8 6", "5 7 8", "1 5 6", "1 6 2", "3 8 7", "3 4 8", "1 3 7", "1 7 5", "2 6 8", "2 8 4"))


def color(value):
    return {"r": value, "g": value, "b": value, "a": 1.0}


SECTIONS = {
    "motors": {"motors": [
        {"name": "waist", "joint": "waist", "type": "PID", "p": 10.0, "i": 0.1, "d": 0.2, "minValue": -1.0, "maxValue": 1.0,
         "maxEffort": 10.0, "maxSpeed": 2.0},
        {"name": "wrist", "joint": "wrist", "type": "DC", "minValue": -2.0, "maxValue": 2.0, "maxEffort": 5.0, "maxSpeed": 3.0}]},
    "sensors": {"sensors": [
        {"name": "eye", "type": "CameraSensor", "link": "hand", "rate": 40, "width": 64, "height": 48, "opening_width": 60.0,
         "opening_height": 45.0, "show_cam": False, "depth_image": False,
         "orientation_offset": {"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0}, "position_offset": {"x": 0.1, "y": 0.0, "z": 0.2}},
        {"name": "scan", "type": "RotatingRaySensor", "link": "cap", "rate": 50, "bands": 16, "lasers": 4, "opening_width": 3.0,
         "opening_height": 0.5, "max_distance": 20.0, "min_distance": 0.1, "horizontal_offset": 0.1, "vertical_offset": 0.1,
         "horizontal_resolution": 0.2, "draw_rays": False},
        {"name": "angles", "type": "JointPosition", "link": "base", "id": ["waist", "wrist"]},
        {"name": "speeds", "type": "JointVelocity", "link": "base", "id": ["waist"]},
        {"name": "force", "type": "Joint6DOF", "link": "hand"},
        {"name": "imu", "type": "NodeIMU", "link": "base", "id": ["base"]},
        {"name": "place", "type": "NodePosition", "link": "base", "id": ["base", "hand"]},
        {"name": "current", "type": "MotorCurrent", "link": "base", "id": ["waist"]}]},
    "materials": {"materials": [
        {"name": "grey", "ambientColor": color(0.1), "diffuseColor": color(0.5), "specularColor": color(0.2), "shininess": 10.0}]},
    "joint": {"joint": [
        {"name": "waist", "springDamping": 0.5, "springStiffness": 0.0, "reducedDataPackage": False, "noDataPackage": False}]},
    "link": {"link": [{"name": "arm", "linear_damping": 0.1, "angular_damping": 0.1, "noDataPackage": True}]},
    "collision": {"collision": [
        {"name": "arm_hull", "link": "arm", "bitmask": 3, "cfriction1": 0.8, "cmax_num_contacts": 4, "ccfm": 0.001}]},
    "visuals": {"visuals": [{"name": "arm_look", "link": "arm", "visualType": "mesh"}]},
    "poses": {"poses": [{"name": "start", "joints": {"waist": 0.1, "wrist": 0.2}}]},
    "submechanisms": {"submechanisms": [
        {"name": "chain", "type": "serial", "contextual_name": "chain", "jointnames": ["waist", "wrist"],
         "jointnames_active": ["waist", "wrist"], "jointnames_independent": ["waist", "wrist"],
         "jointnames_spanningtree": ["waist", "wrist"]}]},
    "lights": {"lights": [
        {"name": "lamp", "type": 1, "directional": False, "position": {"x": 0.0, "y": 0.0, "z": 2.0},
         "lookat": {"x": 0.0, "y": 0.0, "z": 0.0}, "angle": 30.0, "exponent": 1.0, "ambient": color(0.1), "diffuse": color(0.9),
         "specular": color(0.5), "constantAttenuation": 1.0, "linearAttenuation": 0.1, "quadraticAttenuation": 0.0}]},
    "nodes": {"nodes": [
        {"name": "ball", "parent": "hand", "physicmode": "sphere", "mass": 0.1, "extend": {"x": 0.1, "y": 0.1, "z": 0.1},
         "position": {"x": 0.0, "y": 0.0, "z": 0.5}, "rotation": {"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0}, "movable": True,
         "noPhysical": False, "groupid": 3, "filename": "PRIMITIVE"}]},
    "graphics": {"graphics": [{"clearColor": color(0.8), "fogEnabled": False, "fogDensity": 0.2, "fogStart": 1.0, "fogEnd": 30.0}]},
    "controllers": {"controllers": [{"name": "brain", "rate": 20, "sensors": ["angles"], "motors": ["waist"]}]},
}
# Phobos or MARS cannot load a model with one of these, so they are damaged in separate models.
APART = {"lights", "nodes", "graphics", "controllers", "submechanisms"}

SCENE = {
    "smurfs": [
        {"name": "left", "type": "smurf", "file": "smurf/m.smurf", "position": [1.0, 0.0, 0.5], "rotation": [1.0, 0.0, 0.0, 0.0],
         "anchor": "world"},
        {"name": "right", "type": "smurf", "file": "smurf/m.smurf", "parent": "left::base", "anchor": "parent",
         "position": [0.0, 1.0, 0.5], "rotation": [0.7071067811865476, 0.0, 0.0, 0.7071067811865476], "pose": "start"},
        {"name": "bare", "type": "urdf", "file": "urdf/m.urdf", "position": [3.0, 0.0, 0.5]},
        {"name": "cell", "type": "smurfs", "file": "cell.smurfs", "position": [0.0, 0.0, 1.0], "anchor": "world"}],
}
CELL = {"smurfs": [{"name": "inner", "type": "smurf", "file": "smurf/m.smurf", "position": [0.0, 5.0, 0.0], "parent": "world"}]}
WORLD = {
    "smurfs": [{"name": "left", "type": "smurf", "file": "smurf/m.smurf", "position": [1.0, 0.0, 0.5]}],
    "physics": {"gravity": {"x": 0.0, "y": 0.0, "z": -9.81}, "ode": {"cfm": 0.001, "erp": 0.1, "stepsize": 1.0}},
    "environment": {"skybox": {"path": "sky"}, "background": color(0.5),
                    "fog": {"density": 0.1, "start": 1.0, "end": 10.0, "color": color(0.5)}},
    "lights": SECTIONS["lights"]["lights"],
}
OTHERS = {"smurfs": [
    {"name": "ground", "type": "primitive", "geometry": {"type": "plane"}, "position": [0.0, 0.0, 0.0]},
    {"name": "crate", "type": "primitive", "geometry": {"type": "box"}, "mass": 2.0, "extend": {"x": 0.5, "y": 0.5, "z": 0.5},
     "position": {"x": 0.0, "y": 0.0, "z": 0.5}, "material": {"diffuseColor": color(0.3)}}]}


class Raw(str):
    """A text that is written unquoted in YAML: `.nan`, `~`, `[`."""


def is_plain(text):
    return bool(text) and all(char.isalnum() or char in "_./" for char in text) and not text[0].isdigit() \
        and text.lower() not in ("true", "false", "yes", "no", "null", "on", "off", "y", "n")


def scalar(value):
    if isinstance(value, Raw):
        return str(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return value if is_plain(value) else "'" + value.replace("'", "''") + "'"
    return str(value)


def flow(value):
    if isinstance(value, list):
        return "[" + ", ".join(map(flow, value)) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {flow(one)}" for key, one in value.items()) + "}"
    return scalar(value)


def yaml(data):
    """Sections with one line per entry and key, and small values in one line, as people write them."""
    if not isinstance(data, dict):
        return flow(data) + "\n"
    text = ""
    for key, section in data.items():
        if not isinstance(section, list) or not all(isinstance(entry, dict) and entry for entry in section) or not section:
            text += f"{key}: {flow(section)}\n"
            continue
        text += f"{key}:\n"
        for entry in section:
            lines = [f"{name}: {flow(one)}" for name, one in entry.items()]
            text += "- " + "\n  ".join(lines) + "\n"
    return text
