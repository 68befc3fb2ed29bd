# SPDX-License-Identifier: BSD-3-Clause
"""--masses and --fix-inertia of smurf-lint."""
import csv
import io

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

    def test_nearest(self):
        done = self.run_tool("--fix-inertia=nearest", "--diff", "r.urdf")
        self.assertIn("principal moments -0.00013, 0.0067, 0.0067 become", done.stderr)

    def test_mistakes(self):
        self.expect_complaint("--fix-inertia: 'heavy' is not mass, mesh, box, nearest or density:VALUE",
                              "--fix-inertia=heavy", "r.urdf")
        self.expect_complaint(
            "--fix-inertia cannot be combined with --fix, --rename or --generate-baseline",
            "--fix-inertia", "--fix", "r.urdf")


if __name__ == "__main__":
    cli.main()
