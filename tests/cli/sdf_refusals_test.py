# SPDX-License-Identifier: BSD-3-Clause
"""What libsdformat refuses in elements of SDF is an error here, at its place, and what it reads is none.

Each row was run with libsdformat 12.3: it refuses the first text, and loads the second.

sdf_refusals_test.py SMURF_LINT SDF_ANSWERS     the second program is not there without libsdformat 12
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from refusal_rows import RefusalRows  # noqa: E402

TOOL, ASKED = (pathlib.Path(one).resolve() for one in sys.argv[1:3])
MODEL = """<sdf version="1.9"><model name="m"><link name="a"><inertial><mass>1</mass></inertial>{link}</link>
<link name="b"><inertial><mass>1</mass></inertial></link>
<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>1</upper>
</limit></axis>{joint}</joint></model></sdf>"""
WORLD = '<sdf version="1.9"><world name="w">{world}</world></sdf>'
SHAPE = "<geometry><sphere><radius>1</radius></sphere></geometry>"


def collision(inner):
    return f'<collision name="c">{SHAPE}{inner}</collision>'


def visual(inner):
    return f'<visual name="v">{SHAPE}{inner}</visual>'


def sensor(kind, inner, outer=""):
    return f'<sensor name="s" type="{kind}">{outer}<{kind}>{inner}</{kind}></sensor>'


def friction(inner):
    return collision(f"<surface><friction><ode>{inner}</ode></friction></surface>")


def moment(value):
    return f"<inertial><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>{value}</ixy></inertia></inertial>"


def state(inner):
    return f'<state world_name="w">{inner}</state>'


ROWS = [  # the place, what is refused, and why; what loads
    ("link", friction("<mu>-1</mu>"), "`-1` in `mu` is outside", friction("<mu>0</mu>")),
    ("link", friction("<mu>1e999</mu>"), "too large or too small", friction("<mu>inf</mu>")),
    ("link", friction("<mu>1e-310</mu>"), "too large or too small", friction("<mu>true</mu>")),
    ("link", friction("<mu>m</mu>"), "`m` in `mu` is not a number", friction("<mu>1m</mu>")),
    ("link", friction("<fdir1>1 2</fdir1>"), "not 3 numbers", friction("<fdir1>1 2 3 4</fdir1>")),
    ("link", friction("<fdir1>1, 2, 3</fdir1>"), "not 3 numbers", friction("<fdir1>1e-310 2 3m</fdir1>")),
    ("link", friction("<fdir1>nan 2 3</fdir1>"), "not 3 numbers", friction("<fdir1>.1 2. 3</fdir1>")),
    ("link", collision("<max_contacts>.5</max_contacts>"), "not an integer", collision("<max_contacts>1.5</max_contacts>")),
    ("link", collision("<max_contacts>99999999999</max_contacts>"), "not an integer",
     collision("<max_contacts>-1</max_contacts>")),
    ("link", visual("<visibility_flags>x</visibility_flags>"), "not an integer",
     visual("<visibility_flags>99999999999</visibility_flags>")),
    ("link", visual("<material><diffuse>2 0 0 1</diffuse></material>"), "not a colour",
     visual("<material><diffuse>1 0 nan</diffuse></material>")),
    ("link", visual('<material><shader type="toon"/></material>'), "no type of shader",
     visual('<material><shader type="pixel"/></material>')),
    ("link", visual('<material><shader type="normal_map_object_space"/></material>'), "`shader` needs `<normal_map>`",
     visual('<material><shader type="normal_map_object_space"><normal_map>n.png</normal_map></shader></material>')),
    ("link", visual("<material><script><uri>u</uri></script></material>"), "`script` needs `<name>`",
     visual("<material><script><uri>u</uri><name>n</name></script></material>")),
    ("link", '<visual name="v"><geometry><mesh><uri>m</uri><submesh/></mesh></geometry></visual>', "`submesh` needs `<name>`",
     '<visual name="v"><geometry><mesh><uri>m</uri><submesh><name>n</name></submesh></mesh></geometry></visual>'),
    ("link", "<pose rotation_format='euler'>0 0 0 0 0 0</pose>", "not a pose", "<pose rotation_format='euler_rpy'>0 0 0 0 0 0</pose>"),
    ("link", "<pose>0 0 0 0 0 inf</pose>", "not a pose", "<pose>0 0 0 0 0 0m</pose>"),
    ("link", "<pose degrees='yes'>0 0 0 0 0 0</pose>", "not a truth value", "<pose degrees='TRUE'>0 0 0 0 0 0</pose>"),
    ("link", moment("nan"), "not finite", moment("0.1")),
    ("link", "<inertial><mass>nan</mass></inertial>", "not a number", "<inertial><mass>0</mass></inertial>"),
    ("link", sensor("camera", "<image><format>RGB8</format></image>"), "no format of pixels",
     sensor("camera", "<image><format>R8G8B8</format></image>")),
    ("link", sensor("camera", "<noise><type>white</type></noise>"), "no type of noise",
     sensor("camera", "<noise><type>Gaussian</type></noise>")),
    ("link", sensor("camera", "<clip><far>0.05</far></clip>"), "outside", sensor("camera", "<clip><far>0.1</far></clip>")),
    ("link", sensor("camera", "<horizontal_fov>7</horizontal_fov>"), "outside",
     sensor("camera", "<horizontal_fov>6</horizontal_fov>")),
    ("link", sensor("imu", '<angular_velocity><x><noise type="gaussian"><stddev>-1</stddev></noise></x></angular_velocity>'),
     "outside", sensor("imu", '<angular_velocity><x><noise type="white"><stddev>1</stddev></noise></x></angular_velocity>')),
    ("link", '<particle_emitter name="p" type="sphere"/>', "no type of emitter", '<particle_emitter name="p" type="box"/>'),
    ("link", "<battery><voltage>1</voltage></battery>", "`battery` needs `name`",
     '<battery name="b"><voltage>1</voltage></battery>'),
    ("joint", sensor("force_torque", "<frame>world</frame>"), "no frame", sensor("force_torque", "<frame>sensor</frame>")),
    ("joint", sensor("force_torque", "<measure_direction>up</measure_direction>"), "no direction",
     sensor("force_torque", "<measure_direction>child_to_parent</measure_direction>")),
    ("joint", sensor("force_torque", '<force><x><noise type="white"/></x></force>'), "no type of noise",
     sensor("force_torque", '<force><x><noise type="none"/></x></force>')),
    ("world", '<physics name="p"/>', "`physics` needs `type`", '<physics name="p" type="any"/>'),
    ("world", '<physics name="p" type="ode"><max_step_size>x</max_step_size></physics>', "not a number",
     '<physics name="p" type="ode"><max_step_size>0.1</max_step_size></physics>'),
    ("world", '<atmosphere type="isothermal"/>', "no type of atmosphere", '<atmosphere type="adiabatic"/>'),
    ("world", "<scene><fog><density>-1</density></fog></scene>", "outside", "<scene><fog><density>0</density></fog></scene>"),
    ("world", "<spherical_coordinates><surface_model>FLAT</surface_model></spherical_coordinates>", "no surface model",
     "<spherical_coordinates><surface_model>EARTH_WGS84</surface_model></spherical_coordinates>"),
    ("world", state('<light><pose>0 0 0 0 0 0</pose></light>'), "`light` needs `name`",
     state('<light name="l"><pose>0 0 0 0 0 0</pose></light>')),
    ("world", state('<model name="m"><joint name="j"/></model>'), "`joint` needs `<angle>`",
     state('<model name="m"><joint name="j"><angle axis="0">1</angle></joint></model>')),
    ("world", state("<sim_time>1</sim_time>"), "not 2 numbers", state("<sim_time>1 2</sim_time>")),
    ("world", '<model name="world"><link name="l"><inertial/></link></model>', "reserves",
     '<model name="w"><link name="l"><inertial/></link></model>'),
    ("world", '<light name="l" type="sun"/>', "no type of light", '<light name="l" type="point"/>'),
    ("world", '<light name="__l__" type="point"/>', "reserves", '<light name="l" type="point"/>'),
    # Frames of shapes are looked for only when a program asks, so a name of nothing is a warning.
    ("link", "<pose relative_to='c'/>", "no frame `c`", visual("<pose relative_to='c'/>")),
]


def text_of(place, inner):
    if place == "world":
        return WORLD.format(world=inner)
    text = MODEL.format(**{"link": "", "joint": "", place: inner})
    if inner.startswith("<inertial"):
        text = text.replace("<inertial><mass>1</mass></inertial>", "", 1)
    return text


# `b` hangs beside its frame, so a link without mass is between, and Gazebo would make one link of these two.
LOOP = """<sdf version="1.9"><model name="m"><link name="a"/><link name="b"><sensor name="s" type="imu"/></link>
<link name="c"><sensor name="s" type="imu"/></link>
<joint name="j" type="revolute"><pose>0 0 1 0 0 0</pose><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>
<joint name="k" type="fixed"><parent>b</parent><child>c</child></joint>
<joint name="l" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""
HIDDEN = """<sdf version="1.9"><model name="m"><include><uri>model://nothing</uri></include>
<joint name="j" type="fixed"><parent>nothing::a</parent><child>nothing::b</child></joint></model></sdf>"""


class Refusals(RefusalRows, unittest.TestCase):
    ROWS = ROWS

    def findings(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "robot.sdf")
            file.write_text(text, encoding="utf-8")
            done = subprocess.run([TOOL, "--format", "json", file], capture_output=True, text=True, check=False)
        return json.loads(done.stdout)["diagnostics"]

    def errors(self, place, inner):
        return [one["message"] for one in self.findings(text_of(place, inner))
                if one["severity"] == "error" and one["id"].startswith("SML931")]

    def test_names_of_a_model_that_is_not_there(self):
        """The missing file is the cause, and no name in it is a fault of its own."""
        self.assertEqual([one["id"] for one in self.findings(HIDDEN)], ["SML9312"])

    def test_links_that_only_a_urdf_merges(self):
        """Gazebo reads the SDF itself, so what it would make of the URDF is an info."""
        found = [one for one in self.findings(LOOP) if one["id"] == "SML1447"]
        self.assertTrue(found)
        self.assertEqual({one["severity"] for one in found}, {"info"}, found)

    def test_parts_that_later_versions_ignore(self):
        old = "<axis><xyz>0 0 1</xyz><use_parent_model_frame>{}</use_parent_model_frame>"
        for version, value, is_said in (("1.9", 1, True), ("1.9", 0, False), ("1.6", 1, False), ("1.4", 0, True)):
            text = MODEL.format(link="", joint="").replace("<axis><xyz>0 0 1</xyz>", old.format(value))
            found = [one["message"] for one in self.findings(text.replace('"1.9"', f'"{version}"'))
                     if "use_parent_model_frame" in one["message"]]
            self.assertEqual(len(found), int(is_said), (version, value, found))

    @unittest.skipUnless(ASKED.is_file(), "there is no libsdformat 12")
    def test_as_libsdformat(self):
        texts = [(row[0], one, loads) for row in ROWS for one, loads in ((row[1], False), (row[3], True))]
        with tempfile.TemporaryDirectory() as folder:
            files = [pathlib.Path(folder, f"{i}.sdf") for i in range(len(texts))]
            for file, (place, inner, _) in zip(files, texts, strict=True):
                file.write_text(text_of(place, inner), encoding="utf-8")
            done = subprocess.run([ASKED, *files], capture_output=True, text=True, check=True, timeout=120)
        for line, (_, inner, loads) in zip(done.stdout.splitlines(), texts, strict=True):
            with self.subTest(inner):
                self.assertEqual(line.split("\t")[1] == "loads", loads, line)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
