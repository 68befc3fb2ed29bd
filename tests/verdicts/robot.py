# SPDX-License-Identifier: BSD-3-Clause
"""The robot that damage.py damages: every element and attribute of URDF, every shape, the joint
types that all readers know, and links at the root, at fixed and at moving joints.

Also the small tree it is kept in, for what is damaged need not be XML that a library would write.
"""
import struct
import xml.etree.ElementTree

TEXT = """
<robot name="damaged" version="1.0">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <material name="red"><color rgba="1 0 0 1"/></material>
  <link name="base">
    <inertial>
      <origin xyz="0.01 0.02 0.03" rpy="0 0 0"/><mass value="8"/>
      <inertia ixx="0.2" ixy="0.01" ixz="0.02" iyy="0.25" iyz="0.03" izz="0.3"/>
    </inertial>
    <visual name="base_look">
      <origin xyz="0 0 0.1" rpy="0 0 0.5"/><geometry><box size="0.6 0.5 0.2"/></geometry><material name="grey"/>
    </visual>
    <collision name="base_hull">
      <origin xyz="0 0 0.1" rpy="0 0 0.5"/><geometry><box size="0.6 0.5 0.2"/></geometry>
    </collision>
  </link>
  <link name="plate">
    <inertial>
      <origin xyz="0.01 0.02 0.03" rpy="0 0 0"/><mass value="2"/>
      <inertia ixx="0.02" ixy="0.001" ixz="0.002" iyy="0.025" iyz="0.003" izz="0.03"/>
    </inertial>
    <visual name="plate_look">
      <origin xyz="0.1 0 0" rpy="0 0 0"/><geometry><cylinder radius="0.15" length="0.3"/></geometry><material name="red"/>
    </visual>
    <collision name="plate_hull">
      <origin xyz="0.1 0 0" rpy="0 0 0"/><geometry><cylinder radius="0.15" length="0.3"/></geometry>
    </collision>
  </link>
  <link name="arm">
    <inertial>
      <origin xyz="0.01 0.02 0.3" rpy="0.1 0.2 0.3"/><mass value="1.5"/>
      <inertia ixx="0.02" ixy="0.001" ixz="0.002" iyy="0.025" iyz="0.003" izz="0.03"/>
    </inertial>
    <visual name="arm_look">
      <origin xyz="0 0.1 0.3" rpy="0.3 0.2 0.1"/><geometry><mesh filename="cube.stl" scale="0.2 0.3 0.6"/></geometry>
      <material name="green"><color rgba="0 1 0 1"/><texture filename="cube.png"/></material>
    </visual>
    <collision name="arm_hull">
      <origin xyz="0 0.1 0.3" rpy="0.3 0.2 0.1"/><geometry><box size="0.2 0.3 0.6"/></geometry>
    </collision>
    <collision name="arm_cap">
      <origin xyz="0 0 0.6" rpy="0 0 0"/><geometry><sphere radius="0.2"/></geometry>
    </collision>
  </link>
  <link name="slide">
    <inertial>
      <origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.012" iyz="0" izz="0.014"/>
    </inertial>
    <visual name="slide_look"><geometry><sphere radius="0.15"/></geometry><material name="red"/></visual>
    <collision name="slide_hull"><geometry><sphere radius="0.15"/></geometry></collision>
  </link>
  <link name="wheel">
    <inertial>
      <origin xyz="0 0 0" rpy="0 0 0"/><mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.012" iyz="0" izz="0.014"/>
    </inertial>
    <collision name="wheel_hull"><geometry><cylinder radius="0.15" length="0.05"/></geometry></collision>
  </link>
  <link name="tool">
    <inertial>
      <origin xyz="0.01 0.02 0.03" rpy="0 0 0"/><mass value="0.5"/>
      <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.0025" iyz="0" izz="0.003"/>
    </inertial>
    <visual name="tool_look">
      <origin xyz="0 0 0.05" rpy="0 0 0"/><geometry><mesh filename="cube.obj" scale="0.1 0.1 0.2"/></geometry>
    </visual>
    <collision name="tool_hull">
      <origin xyz="0 0 0.05" rpy="0 0 0"/><geometry><mesh filename="cube.stl" scale="0.1 0.1 0.2"/></geometry>
    </collision>
  </link>
  <link name="finger">
    <inertial>
      <origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="0.5"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.012" iyz="0" izz="0.014"/>
    </inertial>
    <collision name="finger_hull"><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
  <joint name="plate_bolt" type="fixed">
    <origin xyz="0.3 0.2 0.1" rpy="0.1 0.2 0.3"/><parent link="base"/><child link="plate"/>
  </joint>
  <joint name="shoulder" type="revolute">
    <origin xyz="0.1 0.2 0.4" rpy="0.3 0.2 0.1"/><parent link="base"/><child link="arm"/><axis xyz="0 0.6 0.8"/>
    <limit lower="-1.5" upper="1.25" effort="20" velocity="2.5"/><dynamics damping="0.5" friction="0.25"/>
    <calibration rising="0.5"/>
    <safety_controller soft_lower_limit="-1.2" soft_upper_limit="1.1" k_position="10" k_velocity="5"/>
  </joint>
  <joint name="rail" type="prismatic">
    <origin xyz="0 0.1 0.6" rpy="0 0.5 0"/><parent link="arm"/><child link="slide"/><axis xyz="1 0 0"/>
    <limit lower="-0.25" upper="0.5" effort="30" velocity="1.5"/><dynamics damping="2" friction="1"/>
  </joint>
  <joint name="axle" type="continuous">
    <origin xyz="0.3 0 0.2" rpy="0 0 0.5"/><parent link="arm"/><child link="wheel"/><axis xyz="0 1 0"/>
    <limit effort="4" velocity="8"/><dynamics damping="0.5" friction="0.25"/>
  </joint>
  <joint name="tool_bolt" type="fixed">
    <origin xyz="0 0 0.7" rpy="0 0.5 0"/><parent link="arm"/><child link="tool"/>
  </joint>
  <joint name="knuckle" type="revolute">
    <origin xyz="0 0 0.2" rpy="0 0.1 0"/><parent link="slide"/><child link="finger"/><axis xyz="0 0 1"/>
    <limit lower="-0.75" upper="0.75" effort="5" velocity="4"/>
    <mimic joint="shoulder" multiplier="0.5" offset="0.1"/>
  </joint>
  <transmission name="shoulder_drive">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="shoulder"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
    <actuator name="shoulder_motor"><mechanicalReduction>50</mechanicalReduction></actuator>
  </transmission>
  <gazebo reference="arm">
    <selfCollide>true</selfCollide><mu1>0.5</mu1><mu2>0.5</mu2><kp>10000</kp><kd>10</kd><minDepth>0.001</minDepth>
    <maxVel>0.1</maxVel><maxContacts>5</maxContacts><dampingFactor>0.01</dampingFactor><gravity>true</gravity>
  </gazebo>
  <gazebo reference="shoulder">
    <stopCfm>0.1</stopCfm><stopErp>0.2</stopErp><provideFeedback>true</provideFeedback>
    <implicitSpringDamper>true</implicitSpringDamper><springStiffness>3</springStiffness>
    <springReference>0.1</springReference><fudgeFactor>1</fudgeFactor>
  </gazebo>
</robot>
"""


class Element:
    """A tag, attributes in their order, children and text."""

    def __init__(self, tag, attributes=(), children=(), text=""):
        self.tag, self.attributes, self.children = tag, [list(one) for one in attributes], list(children)
        self.text = text

    def get(self, name):
        return next((value for key, value in self.attributes if key == name), None)

    def set(self, name, value):
        for attribute in self.attributes:
            if attribute[0] == name:
                attribute[1] = value
                return
        self.attributes.append([name, value])

    def drop(self, name):
        self.attributes = [one for one in self.attributes if one[0] != name]

    def all(self, tag):
        return [child for child in self.children if child.tag == tag]

    def first(self, *path):
        """The element at that path of tags, None if it is absent; `link:arm` also states a name."""
        found = self
        for step in path:
            tag, _, name = step.partition(":")
            fits = [one for one in found.all(tag) if not name or one.get("name") == name]
            if not fits:
                return None
            found = fits[0]
        return found

    def copy(self):
        return Element(self.tag, self.attributes, [child.copy() for child in self.children], self.text)

    def write(self, depth=0):
        indent = "  " * depth
        opening = f"{indent}<{self.tag}" + "".join(
            f' {name}="{escape(value)}"' for name, value in self.attributes)
        if not self.children and not self.text:
            return opening + "/>\n"
        if not self.children:
            return f"{opening}>{escape(self.text)}</{self.tag}>\n"
        inner = "".join(child.write(depth + 1) for child in self.children)
        stray = f"{indent}  {escape(self.text)}\n" if self.text else ""
        return f"{opening}>\n{stray}{inner}{indent}</{self.tag}>\n"


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


def parse(text):
    def written(name):
        return name.replace("{http://drake.mit.edu}", "drake:")

    def convert(node):
        attributes = [(written(name), value) for name, value in node.attrib.items()]
        return Element(written(node.tag), attributes, map(convert, node), (node.text or "").strip())
    robot = convert(xml.etree.ElementTree.fromstring(text))
    if "xmlns:drake" in text:
        robot.set("xmlns:drake", "http://drake.mit.edu")
    return robot


def document(robot):
    return '<?xml version="1.0"?>\n' + robot.write()


def cube(name):
    """Twelve triangles of a cube of 1 m as `v` and `f` of OBJ count them, from 0."""
    corners = [(x, y, z) for x in (-.5, .5) for y in (-.5, .5) for z in (-.5, .5)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [three for a, b, c, d in quads for three in ((a, b, c), (a, c, d))]
    writers = {"stl": binary_stl, "ascii.stl": ascii_stl, "obj": obj, "dae": dae}
    return writers[name](corners, triangles)


def binary_stl(corners, triangles):
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *corners[a], *corners[b], *corners[c], 0)
                      for a, b, c in triangles)
    return b"\0" * 80 + struct.pack("<I", len(triangles)) + facets


def ascii_stl(corners, triangles):
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join(
        "vertex {} {} {}\n".format(*corners[i]) for i in three) + "endloop\nendfacet\n"
                     for three in triangles)
    return f"solid cube\n{facets}endsolid cube\n".encode()


def obj(corners, triangles):
    lines = ["v {} {} {}".format(*corner) for corner in corners]
    lines += ["f {} {} {}".format(*(i + 1 for i in three)) for three in triangles]
    return ("\n".join(lines) + "\n").encode()


def dae(corners, triangles):
    numbers = " ".join(str(x) for corner in corners for x in corner)
    indices = " ".join(str(i) for three in triangles for i in three)
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="cube"><mesh>
<source id="p"><float_array id="a" count="24">{numbers}</float_array><technique_common>
<accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>{indices}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#cube"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
""".encode()


def meshes():
    """Files beside the robots, by name; missing files are only named in cases."""
    stl = cube("stl")
    return {"cube.stl": stl, "cube.obj": cube("obj"), "cube.dae": cube("dae"),
            "ascii.stl": cube("ascii.stl"), "broken.stl": stl[:200], "empty.stl": b"",
            "obj_in.stl": cube("obj"), "stl_in.obj": stl, "CUBE2.STL": stl, "cube.xyz": stl,
            "pointer.stl": b"version https://git-lfs.github.com/spec/v1\noid sha256:" + b"0" * 64 +
                           b"\nsize 684\n",
            "cube.png": b"\x89PNG\r\n\x1a\n"}
