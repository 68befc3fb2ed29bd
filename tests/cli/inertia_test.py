# SPDX-License-Identifier: BSD-3-Clause
"""--masses and --fix-inertia of smurf-lint."""
import csv
import io
import json
import subprocess

import cli

# A box of 0.4 x 0.04 x 0.04 m and 0.5 kg, with an inertia in kg mm2; below it a rod with a wrong sign.
ROBOT = """<robot name="lamp">
  <link name="arm">
    <inertial>
      <mass value="0.50"/>   <!-- weighed -->
      <inertia ixx="130" ixy="0" ixz="0"
               iyy="6700" iyz="0" izz="6700"/>
    </inertial>
    <collision><geometry><box size="0.4 0.04 0.04"/></geometry></collision>
  </link>
  <link name="tip">
    <inertial>
      <mass value="0.5"/>
      <inertia ixx="-0.00013" ixy="0" ixz="0" iyy="0.0067" iyz="0" izz="0.0067"/>
    </inertial>
  </link>
  <joint name="j" type="fixed"><parent link="arm"/><child link="tip"/></joint>
</robot>
"""


class Masses(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("r.urdf", ROBOT)

    def test_table(self):
        lines = self.expect(0, "--masses", "r.urdf").stdout.splitlines()
        self.assertEqual(lines[0].split(), ["link", "mass", "kg", "volume", "m3", "kg/m3", "gyration", "m", "verdict"])
        self.assertEqual(lines[1].split()[:4], ["arm", "0.5", "0.00064", "781"])
        self.assertIn("SML1518", lines[1])
        self.assertIn("SML1512", lines[2])
        self.assertEqual(lines[3].split(), ["total", "1"])

    def test_csv(self):
        rows = list(csv.DictReader(io.StringIO(self.expect(0, "--masses", "r.urdf", "--csv").stdout)))
        self.assertEqual([row["link"] for row in rows], ["arm", "tip"])
        self.assertAlmostEqual(float(rows[0]["density_kg_m3"]), 0.5 / 0.00064)
        self.assertEqual(rows[0]["volume_of"], "shapes")
        self.assertEqual(rows[1]["volume_m3"], "")

    def test_mistakes(self):
        self.expect_complaint("--csv needs --masses", "--csv", "r.urdf")
        self.write("a.txt", "")
        self.expect_complaint("'a.txt' is not a model or URDF", "--masses", "a.txt")


class Repair(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("r.urdf", ROBOT)

    def test_writes_the_tensor_of_the_shapes_and_nothing_else(self):
        done = self.run_tool("--fix-inertia", "--fix-only", "r.urdf")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("its shapes, filled with 0.5 kg, which is 781 kg/m3", done.stderr)
        expected = ROBOT.replace('"130"', '"0.0001333333"').replace('"6700"', '"0.006733333"')
        self.assertEqual(self.read("r.urdf"), expected.replace("-0.00013", "0.00013"))
        self.assertIn("no findings", self.expect(0, "--select", "SML15", "--ignore", "SML1527", "r.urdf").stdout)

    def test_shows_the_changes(self):
        done = self.run_tool("--fix-inertia=density:1000", "--diff", "r.urdf")
        self.assertEqual(done.returncode, 1)
        self.assertIn('+      <mass value="0.64"/>', done.stdout)
        self.assertEqual(self.read("r.urdf"), ROBOT)

    def test_an_absent_inertia_is_added(self):
        for end in ("\n", "\r\n"):
            text = f"""<robot name="r"><link name="a"><inertial><mass value="2"/></inertial>
    <collision><geometry><box size="0.2 0.2 0.4"/></geometry></collision></link>
  <link name="b">
    <inertial>
      <mass value="2"></mass> <!-- kg -->
      <origin xyz="0 0 0.1" rpy="0 1.5707963267948966 0"/>
    </inertial>
    <collision><origin xyz="0 0 0.1"/><geometry><box size="0.2 0.2 0.4"/></geometry></collision>
  </link>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
</robot>
""".replace("\n", end)
            self.write("r.urdf", text.encode())
            done = self.run_tool("--fix-inertia", "--fix-only", "r.urdf")
            self.assertIn("has no inertia; the principal moments become 0.0133, 0.0333, 0.0333: its shapes, filled with 2 kg", done.stderr)
            element = '<inertia ixx="{0}" ixy="0" ixz="0" iyy="0.03333333" iyz="0" izz="{1}"/>'
            expected = text.replace('"2"/>', '"2"/>' + element.format("0.03333333", "0.01333333"))
            expected = expected.replace("</mass>", f"</mass>{end}      " + element.format("0.01333333", "0.03333333"))
            self.assertEqual((self.folder / "r.urdf").read_bytes().decode(), expected)
        self.write("r.urdf", text.encode())
        self.assertEqual(self.run_tool("--fix-inertia=nearest", "--diff", "r.urdf").stdout, "")

    def test_a_density_replaces_a_wrong_mass(self):
        wrong = ROBOT.replace('"0.50"', '"500"').replace('"130"', '"0.00013"').replace('"6700"', '"0.0067"')
        self.write("r.urdf", wrong)
        self.assertNotIn("arm", self.run_tool("--fix-inertia", "--diff", "r.urdf").stderr)
        done = self.run_tool("--fix-inertia=density:1000", "--diff", "r.urdf")
        self.assertIn("the mass of link `arm` is too large for its shapes; principal moments", done.stdout)
        self.assertIn('+      <mass value="0.64"/>', done.stdout)

    def test_nearest(self):
        done = self.run_tool("--fix-inertia=nearest", "--diff", "r.urdf")
        self.assertIn("principal moments -0.00013, 0.0067, 0.0067 become", done.stdout)

    def test_a_centre_at_an_edge_is_not_repaired_by_a_tensor(self):
        self.write("r.urdf", """<robot name="r"><link name="a"><inertial><origin xyz="0.23 0 0"/><mass value="1"/>
<inertia ixx="0.0003" ixy="0" ixz="0" iyy="0.0134" iyz="0" izz="0.0134"/></inertial>
<collision><geometry><box size="0.4 0.04 0.04"/></geometry></collision></link></robot>""")
        said = self.expect(0, "--min-severity", "info", "r.urdf").stdout
        self.assertIn("is the centre of mass right? It lies at an edge of the shapes", said)
        before = self.read("r.urdf")
        for source in ("mass", "box", "nearest"):
            self.run_tool("--fix-inertia=" + source, "--fix-only", "r.urdf")
            self.assertEqual(self.read("r.urdf"), before)

    def test_the_rounding_error_of_zero_is_no_tensor(self):
        """The nearest possible tensor would be that of a point, too."""
        self.write("r.urdf", ROBOT.replace("-0.00013", "-4.7e-41").replace('"0.0067"', '"9.4e-41"'))
        tip = self.read("r.urdf").split('name="tip"')[1]
        self.run_tool("--fix-inertia", "--fix-only", "r.urdf")
        self.assertEqual(self.read("r.urdf").split('name="tip"')[1], tip)

    def test_a_little_too_much_is_rounding(self):
        """Not the decimal point of a small product, although the tensor were possible without it."""
        self.write("r.urdf", '<robot name="r"><link name="a"><inertial><mass value="2"/><inertia ixx="0.0051" iyy="0.01" '
                   'izz="0.0153" ixy="0.00001" ixz="0" iyz="0.000002"/></inertial></link></robot>')
        said = self.expect(1, "r.urdf").stdout
        self.assertIn("rounded or measured numbers? The largest moment is 1.3 % beyond that of a body", said)
        self.assertNotIn("decimal point", said)

    def test_moments_are_in_the_difference_which_git_applies(self):
        done = self.run_tool("--fix-inertia", "--diff", "r.urdf")
        lines = done.stdout.splitlines()
        self.assertRegex(lines[0], r"^# r.urdf:5: the inertia of link `arm` .* become 0.000133, 0.00673, 0.00673: its shapes")
        self.write("a.patch", done.stdout)
        subprocess.run(["git", "apply", "a.patch"], cwd=self.folder, check=True)
        self.assertIn("0.006733333", self.read("r.urdf"))

    def test_models_of_a_scene(self):
        self.write("m.smurf", "modelname: m\nfiles: [r.urdf]\n")
        self.write("s.smurfs", "smurfs:\n- {name: One, type: smurf, file: m.smurf, position: [0, 0, 0]}\n")
        self.assertEqual(self.run_tool("--fix-inertia", "--fix-only", "s.smurfs").returncode, 0)
        self.assertIn("0.006733333", self.read("r.urdf"))

    def test_mistakes(self):
        self.expect_complaint("--fix-inertia: 'heavy' is not mass, mesh, box, nearest or density:VALUE",
                              "--fix-inertia=heavy", "r.urdf")
        self.expect_complaint(
            "--fix-inertia cannot be combined with --fix, --rename or --generate-baseline",
            "--fix-inertia", "--fix", "r.urdf")


# Two wheels of one macro; an arm whose moments are computed.
XACRO = """<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="big" value="6700"/>
  <xacro:macro name="wheel" params="name length">
    <link name="${name}">
      <inertial>
        <mass value="0.50"/>
        <inertia ixx="130" ixy="0" ixz="0" iyy="${big}" iyz="0" izz="6700.0"/>
      </inertial>
      <collision><geometry><box size="${length} 0.04 0.04"/></geometry></collision>
    </link>
    <joint name="${name}_j" type="continuous"><parent link="base"/><child link="${name}"/><axis xyz="1 0 0"/></joint>
  </xacro:macro>
  <link name="base"/>
  <xacro:wheel name="a" length="0.4"/>
  <xacro:wheel name="b" length="0.4"/>
</robot>
"""


class RepairOfXacro(cli.CliTest):
    def repaired(self, text, *more):
        self.write("r.urdf.xacro", text)
        done = self.run_tool("--fix-inertia", "--fix-only", "r.urdf.xacro", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.read("r.urdf.xacro"), done.stderr

    def test_literals_that_all_users_agree_on(self):
        text, told = self.repaired(XACRO)
        expected = XACRO.replace('value="6700"', 'value="0.006733333"').replace('"6700.0"', '"0.006733333"')
        self.assertEqual(text, expected.replace('"130"', '"0.0001333333"'))
        self.assertEqual(told.count("its shapes, filled with 0.5 kg"), 1)

    def test_wheels_that_need_different_values(self):
        other = XACRO.replace('name="b" length="0.4"', 'name="b" length="0.5"')
        text, told = self.repaired(other)
        self.assertEqual(text, other)
        self.assertIn("r.urdf.xacro:2: the inertia of link `a` is too large", told)
        self.assertIn("other parts of the robots use the same number", told)

    def test_a_number_that_something_else_uses(self):
        for use in ('<link name="c"><visual><geometry><sphere radius="${big}"/></geometry></visual></link>',
                    '<link name="c"><visual><geometry><sphere radius="${big/2}"/></geometry></visual></link>'):
            other = XACRO.replace('<link name="base"/>', '<link name="base"/>' + use
                                  + '<joint name="cj" type="fixed"><parent link="base"/><child link="c"/></joint>')
            text, told = self.repaired(other)
            self.assertEqual(text, other)
            self.assertIn("give `iyy` of this link its own number, 0.006733333", told)

    def test_a_number_in_a_computation_that_leaves_no_trace(self):
        """The robot that xacro then makes is compared with the one that was meant."""
        other = XACRO.replace('<link name="base"/>', '<link name="base"/><xacro:if value="${big > 1}"><!-- large --><link name="c"/>'
                              '<joint name="cj" type="fixed"><parent link="base"/><child link="c"/></joint></xacro:if>')
        self.write("r.urdf.xacro", other)
        done = self.run_tool("--fix-inertia", "--fix-only", "r.urdf.xacro")
        self.assertEqual(done.returncode, 2)
        self.assertIn("other parts of the robot would change, too; nothing was written", done.stderr)
        self.assertEqual(self.read("r.urdf.xacro"), other)

    def test_computed_values_are_named(self):
        other = XACRO.replace('"130"', '"${2 * 65}"')
        text, told = self.repaired(other)
        self.assertEqual(text, other)
        self.assertIn("`ixx` is computed; change `${2 * 65}` so that it gives 0.0001333333", told)
        done = self.run_tool("--fix-inertia", "--diff", "r.urdf.xacro")
        self.assertEqual((done.returncode, done.stdout), (1, ""))

    def test_an_absent_inertia_is_told(self):
        other = XACRO.replace('<inertia ixx="130" ixy="0" ixz="0" iyy="${big}" iyz="0" izz="6700.0"/>', "")
        text, told = self.repaired(other)
        self.assertEqual(text, other)
        self.assertIn('xacro makes this inertial; write `<inertia ixx="0.0001333333"', told)

    def test_robots_that_share_a_macro(self):
        head, calls = XACRO.split('  <link name="base"/>\n')
        self.write("wheel.xacro", head + "</robot>\n")
        robot = '<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">\n<xacro:include filename="wheel.xacro"/>\n<link name="base"/>\n'
        self.write("one.urdf.xacro", robot + calls)
        self.write("two.urdf.xacro", robot + calls.replace("0.4", "0.6"))
        done = self.run_tool("--fix-inertia", "--fix-only", "one.urdf.xacro", "two.urdf.xacro")
        self.assertEqual(self.read("wheel.xacro"), head + "</robot>\n")
        self.assertIn("wheel.xacro:", done.stderr)
        self.run_tool("--fix-inertia", "--fix-only", "one.urdf.xacro")
        self.assertIn("0.006733333", self.read("wheel.xacro"))


# A box of 0.1 x 0.2 x 0.1 m and 0.3 kg, with an inertia in kg mm2, a ball without a shape.
NODES = """# signs
nodes:
  - {name: sign, parent: base, physicmode: box, extend: {x: 0.1, y: 0.2, z: 0.1}, mass: 0.30, density: 0,
     inertia: true, i00: 1250.0, i01: 0, i10: 0, i11: 500.0, i22: 1250}
  - name: ball
    parent: base
    physicmode: mesh
    mass: 2
    inertia: true
    i00: 0.01   # measured
    i11: 0.01
    i22: 0.03
"""


class RepairOfSmurf(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("r.urdf", '<robot name="r"><link name="base"/></robot>\n')
        self.write("nodes.yml", NODES)
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, nodes.yml]\n")

    def repaired(self, how, *more):
        done = self.run_tool("--fix-inertia=" + how, "--fix-only", "r.smurf", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.read("nodes.yml"), done.stderr

    def test_shape_and_nearest(self):
        text, told = self.repaired("mass")
        expected = NODES.replace("i00: 1250.0", "i00: 0.00125").replace("i11: 500.0", "i11: 0.0005").replace("i22: 1250}", "i22: 0.00125}")
        self.assertEqual(text, expected.replace("i22: 0.03", "i22: 0.01999998"))
        self.assertIn("node `sign` is too large for its mass and size", told)
        self.assertIn("its shape, filled with 0.3 kg, which is 150 kg/m3", told)
        self.assertIn("node `ball` is impossible for a body", told)
        self.assertIn("no findings", self.expect(0, "--select", "SML1533", "r.smurf").stdout)
        self.assertEqual(self.read("r.urdf"), '<robot name="r"><link name="base"/></robot>\n')

    def test_density_gives_the_mass(self):
        text, _ = self.repaired("density:1000")
        self.assertIn("mass: 2, density: 0,", text)
        self.assertIn("i00: 0.008333333, i01: 0, i10: 0", text)
        self.assertIn("i22: 0.03\n", text)  # the shape is not known

    def test_what_mars_does_not_use_is_left_alone(self):
        for old, new in (("inertia: true", "inertia: false"), ("inertia: true, i", "i"), ("inertia: true\n", "\n"),
                         ("inertia: true", "noPhysical: true, inertia: true")):
            self.write("nodes.yml", NODES.split("  - name: ball")[0].replace(old, new))
            found = self.expect(0, "--select", "SML1533", "r.smurf").stdout
            self.assertEqual("SML1533" in found, new == "\n", (new, found))

    def test_absent_numbers_are_zero(self):
        self.write("nodes.yml", NODES.replace("i10: 0,", "").replace("i01: 0,", "i01: 100,"))
        self.assertIn("node `sign` is not symmetric", self.expect(0, "r.smurf").stdout)
        text, _ = self.repaired("mass")
        self.assertIn("i00: 0.00125, i01: 0,", text)

    def test_safe_fixes_do_not_write_it(self):
        self.run_tool("--fix", "r.smurf")
        self.assertEqual(self.read("nodes.yml"), NODES)
        self.run_tool("--fix", "--unsafe-fixes", "r.smurf")
        self.assertIn("i00: 0.00125", self.read("nodes.yml"))


class Siblings(cli.CliTest):
    def test_one_wheel_that_differs_is_one_finding(self):
        """It differs from the other side, too."""
        link = ('<link name="{0}_wheel"><inertial><mass value="{1}"/><inertia ixx="0.005" ixy="0" ixz="0" iyy="0.003" iyz="0" izz="0.003"/></inertial></link>'
                '<joint name="{0}" type="continuous"><parent link="base"/><child link="{0}_wheel"/><axis xyz="1 0 0"/></joint>\n')
        wheels = (("front_left", 3), ("front_right", 1), ("rear_left", 1), ("rear_right", 1))
        self.write("r.urdf", '<robot name="r"><link name="base"/>\n' + "".join(link.format(*one) for one in wheels) + "</robot>\n")
        found = json.loads(self.expect(0, "--select", "SML1528,SML1530", "--format", "json", "r.urdf").stdout)["diagnostics"]
        self.assertEqual([(one["id"], one["line"]) for one in found], [("SML1530", 2)])
        two = "".join(link.format(*one) for one in wheels[:2])
        self.write("r.urdf", '<robot name="r"><link name="base"/>\n' + two + "</robot>\n")
        found = json.loads(self.expect(0, "--select", "SML1528,SML1530", "--format", "json", "r.urdf").stdout)["diagnostics"]
        self.assertEqual([one["id"] for one in found], ["SML1528"])


class UnitTensors(cli.CliTest):
    """One finding, but each of the links is named, weighed and repaired."""
    LINK = ('<link name="{0}"><inertial><mass value="0.5"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
            '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>\n')
    JOINT = '<joint name="j{0}" type="fixed"><parent link="base"/><child link="{0}"/><origin xyz="{1} 0 0"/></joint>\n'

    def setUp(self):
        super().setUp()
        names = [f"part{i}" for i in range(8)]
        self.text = ('<robot name="r">\n' + self.LINK.format("base") + "".join(map(self.LINK.format, names))
                     + "".join(self.JOINT.format(name, i + 1) for i, name in enumerate(names)) + "</robot>\n")
        self.write("r.urdf", self.text)

    def test_places(self):
        found = json.loads(self.expect(0, "--select", "SML1516", "--format", "json", "r.urdf").stdout)["diagnostics"]
        self.assertEqual([(one["id"], len(one["labels"])) for one in found], [("SML1516", 8)])
        self.assertIn("that of link `part7`", found[0]["labels"][7]["message"])
        shown = self.expect(0, "--select", "SML1516", "r.urdf").stdout
        self.assertIn("that of link `part4`", shown)
        self.assertNotIn("that of link `part5`", shown)
        self.assertIn("8 more links in this file", shown)

    def test_masses(self):
        self.assertEqual(self.expect(0, "--masses", "r.urdf").stdout.count("SML1516"), 9)

    def test_repair(self):
        done = self.run_tool("--fix-inertia", "--fix-only", "r.urdf")
        self.assertEqual(self.read("r.urdf"), self.text.replace('"1"', '"0.0008333333"'))
        self.assertIn("the inertia of link `part7` is the unit tensor, too; principal moments 1, 1, 1 become", done.stderr)


if __name__ == "__main__":
    cli.main()
