#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a file says once and a writer says again and again takes bounded memory, and is refused or lost by its name.

repeated_names_test.py FOLDER_OF_TOOLS [unittest option]...

The inputs have some 200 kB. Memory is not measured with sanitizers.
"""
import pathlib
import sys
import tempfile
import unittest

import cost
import inputs

TOOLS = None
HALF = 100_000  # bytes
LINK = '<link name="b"/>'
SHAPE = '<geometry><sphere radius="1"/></geometry>'
MODEL = "modelname: r\nfiles: [r.urdf, s.yml]\n"
TOO_LARGE = "with this entity the scene, written out, has more than"


def repeat(text):
    return inputs.repeat(text, HALF, "@")


def robot(inside):
    return f'<robot name="r">{inside}</robot>'


def with_annotations(text, urdf=robot(LINK)):
    return {"r.smurf": MODEL, "r.urdf": urdf, "s.yml": text}


class RepeatedNames(unittest.TestCase):
    def run_tool(self, files, *command, codes=(0, 1)):
        """Returns the messages and the result."""
        with tempfile.TemporaryDirectory(prefix="smurf-repeated-") as name:
            folder = pathlib.Path(name)
            (folder / ".git").mkdir()
            for path, text in files.items():
                (folder / path).write_text(text)
            tool = TOOLS / command[0]
            run = cost.Run([tool, *command[1:], "-o", "out"], folder)
            said = run.said.decode(errors="replace")
            self.assertIn(run.code, codes, said[-500:])
            if not cost.has_sanitizer(tool):
                self.assertLess(run.megabytes, cost.MEGABYTES)
            out = folder / "out"
            return said, out.read_text() if out.exists() else ""

    def flatten(self, files, form, main, **how):
        return self.run_tool(files, "smurfs-flatten", "--force", "--format", form, main, **how)

    def assert_too_large(self, files, form):
        said, written = self.flatten(files, form, "s.smurfs", codes=(1,))
        self.assertIn(TOO_LARGE, said)
        self.assertEqual(written, "")

    def test_names_that_get_a_long_prefix(self):
        scene = "smurfs:\n- {name: " + "e" * HALF + ", type: urdf, file: r.urdf}\n"
        for form, inside in (
            ("urdf", repeat('<material name="m@"><color rgba="0 0 0 1"/></material>') + LINK),
            ("urdf", LINK + repeat('<gazebo reference="b"/>')),
            ("urdf", LINK + repeat('<transmission name="t@"><joint name="j"/></transmission>')),
            ("mjcf", '<link name="b">' + repeat(f'<collision name="c@">{SHAPE}</collision>') + "</link>"),
        ):
            with self.subTest(inside=inside[:60]):
                self.assert_too_large({"s.smurfs": scene, "r.urdf": robot(inside)}, form)

    def test_sensors_of_many_instances(self):
        scene = "smurfs:\n" + repeat("- {name: e@, type: smurf, file: r.smurf}\n")
        cameras = "sensors:\n" + repeat("- {name: s@, type: CameraSensor, link: b}\n")
        rays = "sensors:\n- {name: s, type: RaySensor, link: b, width: 1000}\n"
        for form, sensors in (("sdf", cameras), ("mjcf", cameras), ("mjcf", rays)):
            with self.subTest(form=form, sensors=sensors[:60]):
                self.assert_too_large({"s.smurfs": scene, **with_annotations(sensors)}, form)

    def test_a_few_instances_with_sensors_are_written(self):
        scene = "smurfs:\n" + "".join(f"- {{name: e{i}, type: smurf, file: r.smurf}}\n" for i in range(10))
        rays = "sensors:\n- {name: s, type: RaySensor, link: b, width: 1000}\n"
        _, written = self.flatten({"s.smurfs": scene, **with_annotations(rays)}, "mjcf", "s.smurfs", codes=(0,))
        self.assertEqual(written.count("<rangefinder "), 10_000)

    def test_rays_of_many_scans(self):
        sensors = "sensors:\n" + repeat("- {name: s@, type: RaySensor, link: b, width: 1000}\n")
        said, written = self.flatten(with_annotations(sensors), "mjcf", "r.smurf", codes=(0,))
        count = sensors.count("RaySensor")
        rays = written.count("<rangefinder ")
        self.assertTrue(20_000 <= rays <= 40_000, rays)
        self.assertIn(f"{count - rays // 1000} sensors", said)

    def test_rays_in_gazebo(self):
        scan = ('<sensor name="s@" type="ray"><ray><scan><horizontal><samples>1000</samples><min_angle>-1</min_angle>'
                "<max_angle>1</max_angle></horizontal></scan></ray></sensor>")
        said, written = self.flatten(
            {"r.urdf": robot(f'{LINK}<gazebo reference="b">{repeat(scan)}</gazebo>')}, "mjcf", "r.urdf", codes=(0,))
        self.assertLessEqual(written.count("<rangefinder "), 40_000)
        self.assertIn("elements in <gazebo> (`s3", said)

    def test_long_names_of_sensors_with_many_readings(self):
        joint = '<link name="c"/><joint name="j" type="continuous"><parent link="b"/><child link="c"/></joint>'
        for keys in ("type: RaySensor, link: b, width: 1000",
                     "type: JointPosition, id: [" + "j, " * (HALF // 4) + "j]"):
            with self.subTest(keys=keys[:60]):
                said, written = self.flatten(
                    with_annotations("sensors:\n- {name: " + "s" * HALF + f", {keys}}}\n", robot(LINK + joint)),
                    "mjcf", "r.smurf", codes=(0,))
                self.assertIn("1 sensor", said)
                self.assertNotIn("<sensor>", written)

    def test_settings_of_a_sensor(self):
        """Each ray of a scan is a sensor of MuJoCo; the lost settings are those of the annotation."""
        sensors = "sensors:\n- {name: s, type: RaySensor, link: b, width: 1000, a: 1, c: 2}\n"
        said, _ = self.flatten(with_annotations(sensors), "mjcf", "r.smurf", codes=(0,))
        self.assertRegex(said, r"\b2 sensor settings")

    def test_settings_of_a_sensor_with_a_long_name(self):
        urdf = robot(LINK + '<gazebo reference="b"><sensor name="' + "s" * HALF + '" type="imu">'
                     + repeat("<k@>1</k@>") + "</sensor></gazebo>")
        for form in ("mjcf", "html"):
            with self.subTest(form=form):
                said, _ = self.flatten({"r.urdf": urdf}, form, "r.urdf", codes=(0, 2))
                if form == "mjcf":
                    self.assertIn("`k0 of sss", said)

    def test_long_texture_of_many_visuals(self):
        urdf = robot('<material name="m"><texture filename="' + "t" * HALF + '.png"/></material><link name="b">'
                     + repeat(f'<visual>{SHAPE}<material name="m"/></visual>') + "</link>")
        self.flatten({"r.urdf": urdf}, "html", "r.urdf", codes=(0, 2))
        said, _ = self.flatten({"r.urdf": urdf}, "sdf", "r.urdf", codes=(1,))
        self.assertIn("written out, has more than", said)

    def test_keys_of_a_sensor_with_a_long_name(self):
        sensors = "sensors:\n- {name: " + "s" * HALF + ", type: CameraSensor, link: b, " + repeat("k@: 1, ") + "}\n"
        said, _ = self.run_tool(with_annotations(sensors), "smurf2urdf", "--force", "--sensors", "gazebo", "r.smurf")
        self.assertNotIn("s" * 1000, "".join(line for line in said.splitlines() if "has no place" in line))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} FOLDER_OF_TOOLS [unittest option]...")
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
