# SPDX-License-Identifier: BSD-3-Clause
"""The command line of smurf-lint: exit codes, streams, reports, and which files are checked."""
import fcntl
import json
import os
import pathlib
import resource
import shutil
import signal
import struct
import subprocess
import sys
import termios
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402
from cli import ARM_MOTORS as MOTORS, ARM_SMURF as SMURF  # noqa: E402

URDF = '<?xml version="1.0"?>\n' + cli.ARM_URDF
BROKEN_URDF = URDF.replace('child link="forearm"', 'child link="forarm"')
BROKEN_MOTORS = MOTORS.replace("joint: elbow", "joint: elbwo")


def suggested(finding):
    """The help of a finding in JSON if it suggests a name, and is not only the remedy of the rule."""
    text = finding.get("help", "")
    return text if text.startswith("did you mean") else None


class LintTest(cli.CliTest):
    def write_model(self, folder="arm", motors=MOTORS, urdf=URDF):
        self.write(f"{folder}/smurf/arm.smurf", SMURF)
        self.write(f"{folder}/smurf/arm_motors.yml", motors)
        self.write(f"{folder}/urdf/arm.urdf", urdf)

    def findings(self, *arguments, code=1, **keywords):
        """(file, id) of what the JSON report lists."""
        report = json.loads(self.expect(code, "--format", "json", *arguments, **keywords).stdout)
        return [(d["file"], d["id"]) for d in report["diagnostics"]]


MORE = ("\nsmurf-lint --explain SML3101, or "
        "https://smurf-tools.github.io/smurf/0.1.0/rules/SML3101/\n")


class LostFiles(LintTest):
    """A file without any effect is an error, so that a CI run with the usual options fails."""

    def test_scenes(self):
        entity = "- {name: a, type: urdf, file: r.urdf}\n"
        self.write("r.urdf", '<robot name="r"><link name="a"/></robot>')
        for key, id_ in (("entites", "SML4005"), ("entitys", "SML4005"), ("smurfss", "SML4005")):
            self.write("s.smurfs", f"{key}:\n{entity}")
            self.assertIn(f"error[{id_}]", self.expect(1, "s.smurfs").stdout)
            self.write("s.smurfs", f"entities:\n{entity}{key}:\n{entity}")
            self.assertNotIn("error", self.run_tool("s.smurfs").stdout)

    def test_sections(self):
        entry = "- {name: elbow, joint: elbow, type: PID, maxEffort: 1.0, maxSpeed: 1.0}\n"
        for key, id_ in (("motor", "SML2015"), ("Motors", "SML2016"), ("motros", "SML2016")):
            self.write_model(motors=f"{key}:\n{entry}")
            self.assertIn(f"error[{id_}]", self.expect(1, "arm/smurf/arm.smurf").stdout)
        self.write_model(motors=f"motor:\n{entry}materials: [{{name: m}}]\n")
        self.assertIn("error[SML2015]", self.expect(1, "arm/smurf/arm.smurf").stdout)
        self.write_model(motors=f"motors:\n{entry}sensor:\n- {{name: s, type: Joint6DOF, link: base}}\n")
        self.assertNotIn("error[SML2015]", self.run_tool("arm/smurf/arm.smurf").stdout)


class BrokenMeshes(LintTest):
    def test_a_mesh_of_a_visual_and_a_collision_is_judged_as_both(self):
        """MuJoCo drops visuals, but not the same mesh in a collision."""
        self.write("m.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0")
        shapes = "".join(f'<{kind}><geometry><mesh filename="m.stl"/></geometry></{kind}>' for kind in ("visual", "collision"))
        self.write("r.urdf", f'<robot name="r"><link name="l">{shapes}</link></robot>')
        self.assertRegex(self.expect(1, "--target", "mujoco", "r.urdf").stdout, "mujoco +fails to load")


class XacroIncludes(LintTest):
    def test_what_to_write_for_a_file_that_is_missing(self):
        self.write("lamp/package.xml", "<package><name>lamp</name></package>")
        self.write("lamp/parts.xacro", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>')
        for include, help_text in (("$(find lamp)/Parts.xacro", "write `parts.xacro`: case matters"),
                                   ("$(find lamp)/bulb.xacro", "add the file, or correct the path"),
                                   ("bulb.xacro", "correct the path; it is relative to `lamp/r.urdf.xacro`")):
            self.write("lamp/r.urdf.xacro", '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
                                            f'<xacro:include filename="{include}"/><link name="a"/></robot>')
            self.assertIn(f"= help: {help_text}\n", self.expect(1, "lamp/r.urdf.xacro").stdout)


class CalmReports(LintTest):
    """The report for people: the worst findings first, and not too many."""

    def write_robot(self, name, joints):
        """Every joint has no effort (an error) and an axis that is not of unit length (less)."""
        joint = ('<link name="l{0}"/><joint name="{2}{0}" type="revolute"><parent link="base"/><child link="l{0}"/>'
                 '<axis xyz="0 0 2"/><limit lower="0" upper="1" velocity="1"{1}/></joint>')
        self.write(name + ".urdf", '<robot name="r"><link name="base"/>' + "".join(
            joint.format(i, "" if i % 2 else ' effort="1"', name) for i in range(joints)) + "</robot>")

    def test_a_large_report_is_short(self):
        for i in range(40):
            self.write_robot(f"robot{i:02}_", 30)
        done = self.expect(1, "--severity", "SML1502=info", ".")
        lines = done.stdout.splitlines()
        self.assertLess(len(lines), 60)
        severities = [line.split("[")[0] for line in lines if line.startswith(("error[", "warning[", "info["))]
        self.assertEqual(severities, sorted(severities))
        self.assertEqual(severities[0], "error")
        self.assertNotIn("info", severities)
        self.assertEqual(lines[0], "all 40 robots have errors (robot00_.urdf, robot01_.urdf, robot02_.urdf and 37")
        self.assertEqual(lines[3], "robot00_.urdf: 15 errors")
        self.assertIn("`robot00_11`, `robot00_13` and 8 more in this file; --all shows them", lines)
        self.assertEqual(lines.count("... and the same in 39 more files: robot01_.urdf, robot02_.urdf, robot03_.urdf"), 2)
        self.assertIn("The most frequent findings:", lines)
        self.assertIn(" 600  error    SML1404 limit-incomplete", lines)
        self.assertNotIn("SML1502", done.stdout)  # an info, which is not shown
        self.assertIn("40 infos are not shown; --min-severity info shows them", lines)
        self.assertTrue(lines[-1].startswith("smurf-lint --explain SML1404, or https://"), lines[-1])
        everything = self.expect(1, "--all", ".").stdout
        self.assertEqual(everything.count("error[SML1404]"), 600)
        self.assertNotIn("more of", everything)
        self.assertIn("found 600 errors, 1200 warnings and 40 infos in 40 files (40 models)", lines)

    def test_a_kind_is_one_block_for_all_files(self):
        """Messages differ in names. Another remedy is another finding."""
        for i, (meant, size) in enumerate((("hip", 9), ("hip", 9), ("knee", 9), ("toe", 0), ("toe", 9))):
            self.write(f"r{i}.urdf", f'<robot name="r"><link name="{meant}{i}s"><visual><geometry><sphere radius="{size}"/>'
                       f'</geometry></visual></link><link name="part{i}"/><joint name="j{i}" type="fixed">'
                       f'<parent link="{meant}{i}s"/><child link="prt{i}"/></joint></robot>')
        done = self.expect(1, ".").stdout
        self.assertEqual(done.count("error[SML1201]"), 5, done)  # each has its own fix
        for i in range(5):
            self.write(f"r{i}.urdf", f'<robot name="r"><link name="a{i}"/><link name="b{i}"/><joint name="j{i}" type="fixed">'
                       f'<parent link="a{i}"/><child link="quite another {i}"/></joint></robot>')
        done = self.expect(1, ".").stdout
        self.assertEqual(done.count("error[SML1201]"), 1, done)
        self.assertIn("... and the same in 4 more files: r1.urdf, r2.urdf, r3.urdf and 1 more; --all\nshows them\n", done)
        self.assertIn("found 5 errors", done.replace("found 10 errors", "found 5 errors"))
        self.assertEqual(self.expect(1, "--all", ".").stdout.count("error[SML1201]"), 5)

    def test_what_differs_in_names_only_is_shown_once(self):
        self.write_robot("arm", 10)  # 5 errors and 10 warnings
        done = self.expect(1, "arm.urdf")
        self.assertEqual(done.stdout.count("error[SML1404]"), 1)
        self.assertIn("... and the same for `arm3`, `arm5`, `arm7` and `arm9` in this file; --all shows\nthem\n", done.stdout)
        self.assertEqual(done.stdout.count("warning[SML1422]"), 1)

    def test_what_another_remedy_writes_is_shown(self):
        self.write("r.urdf", '<robot name="r"><link name="arm_a"/><link name="arm_b"/><link name="arm_c"/>' + "".join(
            f'<joint name="{name}" type="fixed"><parent link="arm_a"/><child link="{child}"/></joint>'
            for name, child in (("j", "arm_bb"), ("k", "arm_cc"))) + "</robot>")
        done = self.expect(1, "r.urdf").stdout
        self.assertEqual(done.count("error[SML1201]"), 1, done)
        self.assertIn("did you mean `arm_b`?", done)
        self.assertIn("... and the same for `arm_cc` (`arm_c`) in this file", done)

    def test_findings_without_names_are_told_by_their_lines(self):
        self.write("r.urdf", '<robot name="r"><link name="a">' + 3 * (
            '<visual><geometry>\n<box size="0 0 0"/></geometry></visual>') + "</link></robot>")
        self.assertIn("... and the same in lines 3 and 4; --all shows them\n", self.expect(1, "r.urdf").stdout)

    def test_the_worst_file_is_first(self):
        for i in range(9):
            self.write(f"a{i}.urdf", '<robot name="r"><link name="a"><inertial><mass value="-1"/><inertia ixx="1" ixy="0" '
                                     'ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>')
        self.write("z.urdf", '<robot name="r"><link name="a"/><joint name="j" type="fixed"><parent link="a"/></joint></robot>')
        done = self.expect(1, ".").stdout
        self.assertTrue(done.startswith("all 10 robots have errors (a0.urdf, a1.urdf, a2.urdf and 7 more)\n\nz.urdf: "), done)

    def test_which_robots_are_fine_comes_first(self):
        """What comments or a baseline suppress does not count."""
        def first():
            return " ".join(self.run_tool(".").stdout.split("\n\n")[0].split())

        self.write_robot("a", 0)
        self.write_robot("b", 0)
        self.assertTrue(first().startswith("no findings"), first())
        self.write_robot("c", 1)
        self.write_robot("d", 2)
        self.assertEqual(first(), "4 robots: 2 are fine (a.urdf and b.urdf), 1 has warnings (c.urdf), 1 has errors (d.urdf)")
        self.run_tool("d.urdf", "--baseline", "known.yaml", "--generate-baseline")
        self.assertEqual(" ".join(self.run_tool(".", "--baseline", "known.yaml").stdout.split("\n\n")[0].split()),
                         "4 robots: 3 are fine (a.urdf, b.urdf and d.urdf), 1 has warnings (c.urdf)")

    def test_min_severity(self):
        self.write_robot("arm", 4)
        whole = json.loads(self.expect(1, "--format", "json", "arm.urdf").stdout)
        self.assertGreater(whole["summary"]["warning"], 0)
        least = json.loads(self.expect(1, "--min-severity", "error", "--format", "json", "arm.urdf").stdout)
        self.assertEqual(least["diagnostics"], [d for d in whole["diagnostics"] if d["severity"] == "error"])
        self.assertEqual((least["summary"]["warning"], least["summary"]["error"]),
                         (0, whole["summary"]["error"]))
        self.expect(1, "--fail-on", "info", "--select", "SML1422", "arm.urdf")
        self.expect(0, "--fail-on", "info", "--select", "SML1422", "--min-severity", "error", "arm.urdf")


class Verdict(LintTest):
    def test_sound_model(self):
        done = self.expect(0, cli.FIXTURES / "models/arm/smurf/arm.smurf")
        self.assertRegex(done.stdout, r"^no findings in \d+ files \(1 model\)\n$")

    def test_broken_model(self):
        self.write_model(motors=BROKEN_MOTORS)
        done = self.expect(1, "arm/smurf/arm.smurf")
        self.assertIn("error[SML3101]: ", done.stdout)
        self.assertIn(" --> arm/smurf/arm_motors.yml:3:10\n", done.stdout)
        self.assertIn("3 |   joint: elbwo\n  |          ^^^^^", done.stdout)
        self.assertTrue(done.stdout.endswith("found 1 error in 3 files (1 model)\n"
                                             "1 fixable with `--fix --unsafe-fixes`\n" + MORE), done.stdout)

    def test_threshold(self):
        self.write_model(motors=BROKEN_MOTORS)
        model = "arm/smurf/arm.smurf"
        self.expect(0, "--fail-on", "never", model)
        self.expect(0, "--exit-zero", model)
        self.expect(0, "--ignore", "SML3101", model)
        self.expect(0, "--ignore", "unknown-joint,SML4", model)
        self.expect(0, "--select=SML1", model)
        self.expect(0, "--severity", "unknown-joint=warning", model)
        self.expect(1, "--severity", "SML3=warning", "--fail-on=warning", model)
        self.expect(1, "--severity", "SML3101=info", "--fail-on=info", model)
        self.expect(0, "--severity", "SML3101=warning", "--max-warnings", "1", model)
        self.expect(1, "--severity", "SML3101=warning", "--max-warnings", "0", model)
        self.expect(0, "--severity", "SML3101=warning", "--max-warnings", "0", "--exit-zero", model)

    def test_exit_zero_does_not_hide_failure(self):
        self.write_model()
        done = self.expect(2, "--exit-zero", "absent.smurf", "arm")
        self.assertEqual(done.stderr,
                         "smurf-lint: cannot read 'absent.smurf': No such file or directory\n")
        self.assertEqual(done.stdout, "no findings in 3 files (1 model)\n")



class Targets(LintTest):
    """--target: the arm's elbow has a limit without effort, which urdfdom refuses."""

    def setUp(self):
        super().setUp()
        links = "".join(
            f'<link name="{name}"><inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" '
            'iyy="0.1" iyz="0" izz="0.1"/></inertial></link>\n' for name in ("base", "forearm"))
        self.write("arm.urdf", f"""<robot name="arm">
{links}<joint name="elbow" type="revolute">
  <parent link="base"/><child link="forearm"/><axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" velocity="1"/>
</joint>
</robot>
""")

    def test_severity_is_that_of_the_targets(self):
        self.assertIn("error[SML1404]", self.expect(1, "arm.urdf").stdout)
        self.assertIn("error[SML1404]", self.expect(1, "--target", "ros", "arm.urdf").stdout)
        self.assertIn("warning[SML1404]", self.expect(0, "--target=drake", "arm.urdf").stdout)
        self.expect(1, "--target", "drake", "--severity", "SML1404=error", "arm.urdf")

    def test_report_ends_with_the_verdicts(self):
        done = self.expect(1, "--target", "mujoco, ros,pybullet,ros", "arm.urdf")
        end = done.stdout.split("(1 model)\n")[1]
        self.assertEqual(end, """
mujoco    loads
ros       fails to load (1)
          arm.urdf:6:4: refuses the file (SML1404)
pybullet  loads, with losses (1)
          arm.urdf:6:4: reads 0: the joint has no force (SML1404)

smurf-lint --explain SML1404, or https://smurf-tools.github.io/smurf/0.1.0/rules/SML1404/
""")
        self.assertIn("= note: ros: refuses the file\n", done.stdout)

    def test_report_for_programs(self):
        done = self.expect(1, "--target", "ros,mujoco", "--format", "json", "arm.urdf")
        targets = json.loads(done.stdout)["targets"]
        self.assertEqual(targets["mujoco"], {"verdict": "takes", "refusals": 0, "unknown": 0,
                                             "losses": 0, "ignored": 0, "in_baseline": 0})
        self.assertEqual(targets["ros"]["verdict"], "refuses")
        self.assertEqual(targets["ros"]["first"]["id"], "SML1404")
        self.assertEqual(targets["ros"]["first"]["line"], 6)
        self.assertNotIn("targets", json.loads(
            self.expect(1, "--format", "json", "arm.urdf").stdout))

    def test_a_mesh_that_only_mars_finds(self):
        shutil.copytree(cli.FIXTURES / "models/arm", self.folder / "arm")
        (self.folder / "arm/meshes/upper_arm.obj").unlink()
        done = self.expect(1, "--target", "mars,ros,dart", "arm")
        self.assertIn("finds `arm/meshes/upper_arm.bobj`", done.stdout)
        self.assertRegex(done.stdout, r"\nmars +loads")
        # The missing mesh, and two paths without a package, which RViz does not open.
        self.assertRegex(done.stdout, r"\nros +loads, with losses \(3\)\n.*RViz")
        self.assertRegex(done.stdout, r"\ndart +fails to load")

    def test_meshes_of_a_folder_that_only_mars_finds(self):
        shutil.copytree(cli.FIXTURES / "models/arm", self.folder / "arm")
        shutil.move(self.folder / "arm/urdf/arm.urdf", self.folder / "arm/arm.urdf")
        main = self.folder / "arm/smurf/arm.smurf"
        main.write_text(main.read_text().replace("../urdf/arm.urdf", "../arm.urdf"))
        done = self.expect(1, "--select", "SML1604", "arm/smurf/arm.smurf")
        self.assertEqual(done.stdout.count("error[SML1604]"), 1, done.stdout)
        self.assertIn("other files that the URDF names in this folder are missing, too", done.stdout)
        self.assertIn("MARS, from the .smurf, finds `arm/meshes/", done.stdout)

    def test_targets_are_applied_once(self):
        folders = [one for one in sorted((cli.FIXTURES / "rules").glob("SML1*/bad"))]
        for target in ("mars", "ros", "mujoco"):
            reports = [json.loads(self.expect(1, "--isolated", "--target", target, "--format", "json", *options,
                                              *folders).stdout)["diagnostics"]
                       for options in ([], ["--no-ignores"])]
            self.assertEqual(*reports)
            for one in reports[0]:
                self.assertEqual(len(one.get("notes", [])), len(set(one.get("notes", []))), one)

    def test_help_is_that_of_the_targets(self):
        folder = cli.FIXTURES / "rules/SML1915-mimic-unread/bad"
        def helps(targets):
            done = self.expect(0, "--isolated", "--target", targets, "--select", "SML1915", "--format", "json", folder)
            return [one["help"] for one in json.loads(done.stdout)["diagnostics"]]
        self.assertEqual(helps("pinocchio"), ["read the robot with `buildModelFromUrdf(file, mimic=True)`"])
        several, = helps("pinocchio,pybullet")
        self.assertRegex(several, "^for pinocchio: read the robot .*; for pybullet: couple the joints")
        self.assertEqual(helps("mujoco"), [])  # which reads `mimic` today

    def test_verdict_is_about_the_file_whatever_is_let_pass(self):
        self.expect(0, "--target", "ros", "--baseline", "b.yaml", "--generate-baseline", "arm.urdf")
        done = self.expect(0, "--target", "ros", "--baseline", "b.yaml", "arm.urdf")
        self.assertIn("ros  fails to load (1, in the baseline)\n", done.stdout)
        text = self.read("arm.urdf")
        self.write("arm.urdf", text.replace("<robot", "<!-- smurf-lint: ignore-file[SML1404] -->\n<robot"))
        done = self.expect(0, "--target", "ros", "arm.urdf")
        self.assertIn("ros  fails to load (1, ignored by a comment)\n", done.stdout)

    def test_slip_is_what_it_leaves_out(self):
        self.write("slip.urdf", self.read("arm.urdf").replace("velocity=", 'efrot="1" velocity='))
        done = self.expect(1, "--target", "ros", "slip.urdf")
        self.assertIn("[SML1107]", done.stdout)
        self.assertIn("ros  fails to load (1)\n", done.stdout)

    def test_unreadable_file_is_not_taken(self):
        done = self.expect(2, "--target", "ros,mujoco", "absent.urdf")
        self.assertNotIn("loads", done.stdout)

    def test_unknown_target(self):
        done = self.expect(2, "--target", "ros,mujuco", "arm.urdf")
        self.assertEqual(done.stdout, "")
        self.assertIn("there is no target 'mujuco'; did you mean 'mujoco'? (`--target help`", done.stderr)
        page = self.expect(0, "--target", "help").stdout
        self.assertRegex(page, r"(?s)\n  mujoco +MuJoCo, [^\n]*mujoco:3.*mujoco:4\.0")


class Fixes(LintTest):
    """The case of a joint's type (SML1401) has a safe fix, an unknown joint (SML3101) an unsafe one."""

    def test_safe_fix(self):
        urdf = URDF.replace('type="continuous"', 'type="Continuous"')
        self.write_model(urdf=urdf, motors=BROKEN_MOTORS)
        os.chmod(self.folder / "arm/urdf/arm.urdf", 0o640)
        done = self.expect(1, "--fix", "arm")
        self.assertIn("error[SML3101]", done.stdout)
        self.assertNotIn("SML1401", done.stdout)
        self.assertTrue(done.stdout.endswith(
            "fixed 1 finding at 1 place in 1 file\n1 fixable with `--fix --unsafe-fixes`\n" + MORE), done.stdout)
        self.assertEqual(self.read("arm/urdf/arm.urdf"), URDF)
        self.assertEqual((self.folder / "arm/urdf/arm.urdf").stat().st_mode & 0o777, 0o640)
        self.assertEqual(self.read("arm/smurf/arm_motors.yml"), BROKEN_MOTORS)

    def test_no_fix_lists_a_file_twice(self):
        """`arm_motors.yml` resembles the missing names, but the model lists it already."""
        self.write("a.smurf", "files: [a.urdf, a_motor2.yml, a_motors.yml, a_motor3.yml]\n")
        self.write("a.urdf", '<robot name="a"><link name="l"/></robot>\n')
        self.write("a_motors.yml", "motors: []\n")
        done = self.run_tool("--diff", "--unsafe-fixes", "a.smurf")
        self.assertEqual(done.stdout, "")
        self.write("a_motor4.yml", "motors: []\n")
        done = self.run_tool("--diff", "--unsafe-fixes", "a.smurf")
        self.assertIn("a_motor4.yml", done.stdout)

    def test_unsafe_fix_keeps_every_other_byte(self):
        before = BROKEN_MOTORS.replace("elbwo", "'elbwo'  # half right").replace("\n", "\r\n")
        self.write_model(motors="\ufeff" + before)
        done = self.expect(0, "--fix", "--unsafe-fixes", "arm")
        self.assertIn("fixed 1 finding at 1 place in 1 file\n", done.stdout)
        after = (self.folder / "arm/smurf/arm_motors.yml").read_bytes().decode()
        self.assertEqual(after, "\ufeff" + before.replace("elbwo", "elbow"))
        self.assertIn("no findings", self.expect(0, "--fix", "--unsafe-fixes", "arm").stdout)

    def test_a_finding_that_stands_for_many_places(self):
        link = '<link name="{}"/><joint name="j{}" type="fixed"><axis xyz="0 0 1"/><parent link="{}"/><child link="{}"/></joint>'
        self.write("r.urdf", '<robot name="r"><link name="l0"/>' + "".join(
            link.format(f"l{i + 1}", i, f"l{i}", f"l{i + 1}") for i in range(5)) + "</robot>")
        before = self.read("r.urdf")
        # It is an info, which only --min-severity shows: nobody would know why the axes are gone.
        done = self.expect(0, "--fix", "r.urdf")
        self.assertNotIn("fixed", done.stdout)
        self.assertNotIn("fixable", done.stdout)
        self.assertEqual(self.read("r.urdf"), before)
        self.assertEqual(self.expect(0, "--diff", "r.urdf").stdout, "")
        self.assertIn("1 fixable with `--fix`", self.expect(0, "--min-severity", "info", "r.urdf").stdout)
        self.assertIn("fixed 1 finding at 5 places in 1 file\n",
                      self.expect(0, "--fix", "--min-severity", "info", "r.urdf").stdout)

    def test_fix_only(self):
        self.write_model(motors=BROKEN_MOTORS, urdf=URDF.replace('type="continuous"', 'type="Continuous"'))
        self.assertEqual(self.expect(0, "--fix-only", "arm").stdout, "")
        self.assertEqual(self.read("arm/urdf/arm.urdf"), URDF)

    def test_fixes_that_take_too_much(self):
        """Some fixes are applied, a message states this, and the next run continues."""
        self.write_model(motors="motors:\n" + "- {nam: elbow, jont: elbow}\n" * 9)
        limits = "--limit", "rechecked-bytes=20000,findings=4"
        path = self.folder / "arm/smurf/arm_motors.yml"
        before, left = path.read_bytes(), [18]
        while left[-1] > 0 and len(left) < 9:
            done = self.run_tool("--fix", "--unsafe-fixes", *limits, "arm")
            text = path.read_text()
            left.append(text.count("nam:") + text.count("jont:"))
            self.assertLess(left[-1], left[-2])
            said = ("smurf-lint: not all fixes were applied: the others need more than 20000 bytes to be checked; run "
                    "smurf-lint again after these are written, or raise the limit with `--limit rechecked-bytes=N`\n")
            self.assertEqual((done.returncode, done.stderr), (2, said) if left[-1] > 0 else (1, ""))
        self.assertGreater(len(left), 2)
        path.write_bytes(before)
        done = self.expect(2, "--diff", "--unsafe-fixes", *limits, "arm")
        self.assertIn("+- {name: elbow, joint: elbow}\n", done.stdout)
        self.assertEqual(path.read_bytes(), before)

    def test_diff_changes_nothing(self):
        self.write_model(motors=BROKEN_MOTORS.rstrip("\n"))
        self.assertEqual(self.expect(0, "--diff", "arm").stdout, "")
        done = self.expect(1, "--diff", "--unsafe-fixes", "arm")
        self.assertEqual(done.stdout, """--- a/arm/smurf/arm_motors.yml
+++ b/arm/smurf/arm_motors.yml
@@ -1,6 +1,6 @@
 motors:
 - name: elbow
-  joint: elbwo
+  joint: elbow
   type: PID
   maxEffort: 1.0
   maxSpeed: 1.0
\\ No newline at end of file
""")
        self.expect(0, "--diff", "--unsafe-fixes", "--exit-zero", "arm")
        patch = self.folder / "fix.diff"
        patch.write_text(done.stdout)
        subprocess.run(["git", "apply", str(patch)], cwd=self.folder, check=True)
        self.assertEqual(self.read("arm/smurf/arm_motors.yml"), MOTORS.rstrip("\n"))

    def test_no_fix_makes_another_mistake(self):
        """The nearest name may be the only impossible one."""
        robot = ('<robot name="r"><link name="a"/><link name="xb"/><joint name="j" type="continuous"><parent link="{}"/>'
                 '<child link="{}"/>{}</joint></robot>\n')
        for name, ends in (("child", ("a", "aa", "")), ("parent", ("xbb", "xb", "")), ("mimic", ("a", "xb", '<mimic joint="jj"/>'))):
            self.write("r.urdf", robot.format(*ends))
            before = [d["id"] for d in json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"]]
            self.run_tool("--fix-only", "--unsafe-fixes", "r.urdf")
            after = [d["id"] for d in json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"]]
            self.assertEqual(after, before, name)
        self.write("r.urdf", robot.format("a", "xb", ""))
        pose = "modelname: r\nfiles: [r.urdf]\nposes:\n- {name: p, joints: {jj: 90, j: 1}}\n"
        self.write("r.smurf", pose)
        self.run_tool("--fix-only", "--unsafe-fixes", "r.smurf")
        self.assertEqual(self.read("r.smurf"), pose)
        self.write("r.smurf", pose.replace(", j: 1", ""))
        self.run_tool("--fix-only", "--unsafe-fixes", "r.smurf")
        self.assertEqual(self.read("r.smurf"), pose.replace("jj: 90, j: 1", "j: 90"))

    def test_no_suggestion_is_the_thing_itself(self):
        """What is meant is another thing, also where both are equally near."""
        joint = ('<joint name="{0}" type="continuous"><parent link="{1}"/><child link="{2}"/>{3}</joint>')
        mimic = '<mimic joint="{}"/>'

        def robot(wrong, *names):
            links = "".join(f'<link name="l{i}"/>' for i in range(len(names) + 1))
            return f'<robot name="r">{links}' + "".join(
                joint.format(name, f"l{i}", f"l{i + 1}", mimic.format(wrong) if i == 0 else "")
                for i, name in enumerate(names)) + "</robot>"

        for text, meant in ((robot("right_fingr", "right_finger", "drive"), None),
                            (robot("Panda_finger_joint2", "panda_finger_joint2", "panda_finger_joint1"), "panda_finger_joint1"),
                            (robot("finger_joi", "finger_joint", "finger_joing"), "finger_joing")):
            self.write("r.urdf", text)
            found = [d for d in json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"]
                     if d["id"] == "SML1432"]
            self.assertEqual([suggested(d) for d in found], [f"did you mean `{meant}`?" if meant else None])
        self.write("r.urdf", robot("b", "a", "b"))
        motor = "- {{name: {0}, joint: {0}, type: DC, maxEffort: 1, maxSpeed: 1{1}}}\n"
        self.write("r.smurf", "files: [r.urdf]\nmotors:\n" + motor.format("a", ", mimic_motor: drive") + motor.format("b", ""))
        self.write("r.urdf", self.read("r.urdf").replace('name="a"', 'name="driver"'))
        self.write("r.smurf", self.read("r.smurf").replace("name: a, joint: a", "name: driver, joint: driver"))
        before = self.read("r.smurf")
        self.run_tool("--fix-only", "--unsafe-fixes", "r.smurf")
        self.assertEqual(self.read("r.smurf"), before)
        scene = ("entities:\n- {name: table, type: urdf, file: r.urdf, parent: \"tabel::l0\"}\n"
                 "- {name: lamp, type: urdf, file: r.urdf, anchor: \"lmap::l0\"}\n")
        self.write("s.smurfs", scene)
        self.run_tool("--fix-only", "--unsafe-fixes", "s.smurfs")
        self.assertEqual(self.read("s.smurfs"), scene)
        # A ring: from the end of the chain back to its middle.
        chain = "".join(joint.format(f"j{i}", f"link_{c}", f"link_{d}", "") for i, (c, d) in
                        enumerate([("a", "b"), ("b", "c"), ("c", "d")]))
        links = "".join(f'<link name="link_{c}"/>' for c in "abcd")
        for end in ('<parent link="link_a"/>', '<child link="link_d"/>'):
            wrong = end.replace("link_", "linkk_").replace("a\"", "c\"").replace("d\"", "b\"")
            self.write("r.urdf", f'<robot name="r">{links}{chain.replace(end, wrong)}</robot>')
            self.run_tool("--fix-only", "--unsafe-fixes", "r.urdf")
            ids = [d["id"] for d in json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"]]
            self.assertIn("SML1201", ids)

    def test_diff_of_many_lines(self):
        """Changes at the ends, adjacent, separate, and more than are compared at once."""
        plain, wrong = "<link name='a{}'/>\n", "<link name='a{}&'/>\n"
        for number, pattern in enumerate(["1" * 400, "10" * 300, "1" + "0" * 9 + "1", "100001100000001" * 40, "0" * 50 + "1"]):
            for equal in (False, True):
                lines = [(wrong if one == "1" else plain).format("" if equal else i) for i, one in enumerate(pattern)]
                before = "<robot name='r'>\n" + "".join(lines) + "</robot>"
                name = f"many{number}{equal}.urdf"
                self.write(name, before)
                (self.folder / "fix.diff").write_text(self.expect(1, "--diff", name).stdout)
                subprocess.run(["git", "apply", "fix.diff"], cwd=self.folder, check=True)
                self.assertEqual(self.read(name), before.replace("&", "&amp;"))

    def test_diff_beside_a_byte_order_mark(self):
        """A byte order mark in an unchanged line, and in a changed one."""
        for name, line in (("same", "<robot name='r'>\n"), ("changed", "<!-- a -- b --><robot name='r&'>\n")):
            before = "\ufeff" + line + "<link name='a&'/>\n</robot>\n"
            self.write(f"{name}.urdf", before)
            (self.folder / "fix.diff").write_text(self.expect(1, "--diff", f"{name}.urdf").stdout, encoding="utf-8")
            subprocess.run(["git", "apply", "fix.diff"], cwd=self.folder, check=True)
            self.assertEqual(self.read(f"{name}.urdf"), before.replace("&", "&amp;"))

    def test_standard_input(self):
        broken = URDF.replace('type="continuous"', 'type="Continuous"')
        done = self.run_tool("--fix", "-", stdin=broken)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stdout, URDF)
        self.assertIn("fixed 1 finding", done.stderr)
        done = self.run_tool("--fix-only", "-", stdin=broken)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, URDF, ""))

    def test_an_unreadable_path_remains_a_failure(self):
        self.write_model(motors=BROKEN_MOTORS)
        done = self.run_tool("--fix", "--unsafe-fixes", "arm", "absent.urdf")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(self.read("arm/smurf/arm_motors.yml"), MOTORS)


class PartsOfModels(LintTest):
    MESH = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"

    def test_a_mesh_stands_for_the_models_that_use_it(self):
        visual = '<visual><geometry><mesh filename="../meshes/a.stl"/></geometry></visual>'
        self.write_model(urdf=URDF.replace("</robot>", f'<link name="loose">{visual}</link></robot>'))
        self.write("arm/meshes/a.stl", self.MESH)
        self.write("arm/meshes/b.stl", self.MESH)
        self.assertIn(("arm/urdf/arm.urdf", "SML1204"), self.findings("arm/meshes/a.stl"))
        self.expect_reason("no model near 'arm/meshes/b.stl' uses it", "arm/meshes/b.stl")

    def test_only_listed(self):
        self.write_model(motors=BROKEN_MOTORS)
        self.write("arm/smurf/other.yml", "motors: 3\n")
        self.write("arm/meshes/b.stl", self.MESH)
        unlisted = ["arm/smurf/other.yml", "arm/meshes/b.stl"]
        self.expect(1, "arm/smurf/other.yml")
        self.assertEqual(self.expect(0, "--only-listed", *unlisted).stdout, "no findings in 0 files\n")
        self.assertEqual(self.findings("--only-listed", *unlisted, "arm/smurf/arm_motors.yml"),
                         [("arm/smurf/arm_motors.yml", "SML3101")])

    def expect_reason(self, text, *arguments):
        self.assertEqual(self.expect(2, *arguments).stderr, f"smurf-lint: {text}\n")


class WhatMayPass(LintTest):
    def test_comments(self):
        self.write_model(motors=BROKEN_MOTORS.replace("elbwo", "elbwo  # smurf-lint: ignore[SML3101] old name"))
        self.assertTrue(self.expect(0, "arm").stdout.endswith("no findings in 3 files (1 model)\n1 suppressed\n"))
        self.assertIn("error[SML3101]", self.expect(1, "--no-ignores", "arm").stdout)
        report = json.loads(self.expect(0, "--format", "json", "arm").stdout)
        self.assertEqual(report["summary"]["suppressed"], 1)

    def test_a_rule_that_does_not_run_is_not_unused(self):
        self.write_model(motors=BROKEN_MOTORS.replace("elbwo", "elbwo  # smurf-lint: ignore[SML3101]"))
        self.assertIn("no findings", self.expect(0, "--ignore", "SML3101", "arm").stdout)

    def test_what_could_not_be_found_is_not_unused(self):
        comment = "# smurf-lint: ignore[{}]\n"
        for rules, arguments in (("SML31", ["--select", "SML3102"]),   # only one rule of the family has run
                                 ("SML7", []),                         # readers that are no target
                                 ("SML6301", []), ("SML8001", [])):    # of other tools
            self.write_model(motors=comment.format(rules) + MOTORS)
            self.assertEqual(self.findings(*arguments, "arm", code=0), [], rules)
        # Without its model, an annotation file does not know any joint.
        self.write("alone.yml", comment.format("SML3101") + MOTORS)
        self.assertEqual(self.findings("alone.yml", code=0), [])
        # The same applies to a model with a missing file.
        self.write_model(motors=comment.format("SML3102") + MOTORS)
        self.write("arm/smurf/arm.smurf", SMURF + "- absent.yml\n")
        self.assertEqual(self.findings("arm"), [("arm/smurf/arm.smurf", "SML2001")])

    def test_unused_comment_is_removed_by_fix(self):
        noise = MOTORS.replace("- name", "# smurf-lint: ignore[SML3101]\n- name")
        noise = noise.replace("type: PID", "type: PID  # smurf-lint: ignore[SML4101, SML3102] why")
        self.write_model(motors=noise)
        self.assertIn("warning[SML9103]", self.expect(0, "arm").stdout)
        self.expect(0, "--fix", "arm")
        self.assertEqual(self.read("arm/smurf/arm_motors.yml"), MOTORS)

    def test_baseline(self):
        self.write_model(motors=BROKEN_MOTORS)
        baseline = ["--baseline", "robots.yaml"]
        done = self.expect(0, *baseline, "--generate-baseline", "arm")
        self.assertEqual(done.stdout, "wrote 1 finding to robots.yaml\n")
        self.assertTrue(self.read("robots.yaml").endswith(
            "arm/smurf/arm_motors.yml:\n  SML3101:\n  - /motors/name=elbow/joint\n"), self.read("robots.yaml"))
        self.assertIn("1 suppressed", self.expect(0, *baseline, "arm").stdout)
        from_inside = self.expect(0, "--baseline", "../../robots.yaml", "arm.smurf", cwd=self.folder / "arm/smurf")
        self.assertIn("1 suppressed", from_inside.stdout)
        self.expect(1, "arm")

    def test_infos_are_recorded_on_request_only(self):
        self.write("a.urdf", FixedJoint.URDF)
        record = ["--baseline", "b.yaml", "--generate-baseline", "a.urdf"]
        self.assertGreater(len(self.findings("a.urdf", "--min-severity", "info", code=0)), 0)
        self.assertRegex(self.expect(0, *record).stdout,
                         r"^wrote 0 findings to b.yaml, without \d+ infos? \(--min-severity info records (it|them)\)\n$")
        self.assertNotIn("a.urdf", self.read("b.yaml"))
        for request in (["--min-severity", "info"], ["--all"], ["--fail-on", "info"]):
            self.assertRegex(self.expect(0, *request, *record).stdout, r"^wrote [1-9]\d* findings? to b.yaml\n$")
            self.assertIn("a.urdf", self.read("b.yaml"))

    def test_baseline_outlives_moves_and_does_not_hide_new_faults(self):
        self.write_model(motors=BROKEN_MOTORS)
        baseline = ["--baseline", "robots.yaml"]
        self.expect(0, *baseline, "--generate-baseline", "arm")
        new = "motors:\n# first\n- name: wrist\n  joint: wrst\n  type: PID\n"
        self.write_model(motors=new + BROKEN_MOTORS.split("\n", 1)[1])
        done = self.expect(1, *baseline, "arm")
        self.assertIn("wrst", done.stdout)
        self.assertNotIn("elbwo", done.stdout)

    def test_stale_and_malformed_baseline(self):
        self.write_model(motors=BROKEN_MOTORS)
        baseline = ["--baseline", "robots.yaml"]
        self.expect(0, *baseline, "--generate-baseline", "arm")
        self.write_model()
        self.assertIn("info[SML9105]", self.expect(0, *baseline, "--all", "arm").stdout)
        self.expect(0, *baseline, "--generate-baseline", "arm")
        self.assertNotIn("SML9105", self.expect(0, *baseline, "arm").stdout)
        for text in ("- a\n", "a: b\n", "a: {SML3101: x}\n", "a: {SML3101: [{}]}\n"):
            self.write("robots.yaml", text)
            self.assertIn("error[SML9104]", self.expect(1, *baseline, "arm").stdout, text)
        self.expect_complaint("cannot read 'absent.yaml': No such file or directory",
                              "--baseline", "absent.yaml", "arm")


class FixedJoint(LintTest):
    URDF = """<robot name="r">
  <link name="a"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
    <dynamics damping="1"/>
  </joint>
  <link name="b"/>
</robot>
"""

    def test_only_the_axis_is_deleted_safely(self):
        """Authors who fix a joint temporarily want its limits back later."""
        self.write("a.urdf", self.URDF)
        self.expect(0, "--fix", "--min-severity", "info", "a.urdf")
        text = (self.folder / "a.urdf").read_text()
        self.assertNotIn("<axis", text)
        self.assertIn("<limit", text)
        self.assertIn("<dynamics", text)
        self.expect(0, "--fix", "--unsafe-fixes", "--min-severity", "info", "a.urdf")
        self.assertNotIn("<limit", (self.folder / "a.urdf").read_text())


class ConfigurationInBaseline(LintTest):
    def test_mistakes_in_the_configuration_are_never_recorded(self):
        self.write_model()
        self.write(".smurf-lint.yaml", "severty: {SML1501: warning}\ntargets: [gazbo]\n")
        baseline = ["--baseline", "b.yaml"]
        self.expect(0, *baseline, "--generate-baseline", ".")
        self.assertNotIn("SML9", (self.folder / "b.yaml").read_text().split("\n", 2)[2])
        found = self.expect(1, *baseline, ".").stdout
        self.assertIn("SML9001", found)
        self.assertIn("SML9002", found)

    def test_entries_of_older_baselines_have_no_effect(self):
        self.write_model()
        self.write(".smurf-lint.yaml", "severty: {SML1501: warning}\n")
        self.write("b.yaml", ".smurf-lint.yaml:\n  SML9001:\n  - \"\"\n")
        self.assertIn("SML9001", self.expect(1, "--baseline", "b.yaml", ".").stdout)


class Suggestions(LintTest):
    LINKS = "".join(f'<link name="{name}"/>' for name in ("base", "FL_propeller", "FR_propeller", "top_propeller", "mast"))

    def help_of(self, child, parent="base"):
        joint = '<joint name="{1}_joint" type="continuous"><parent link="{0}"/><child link="{1}"/><axis xyz="0 0 1"/></joint>'
        joints = "".join(joint.format(*names) for names in
                         (("base", "FL_propeller"), ("base", "FR_propeller"), (parent, child)))
        self.write("r.urdf", f'<robot name="r">{self.LINKS}{joints}</robot>')
        report = json.loads(self.expect(1, "--select", "SML1201", "--format", "json", "r.urdf").stdout)
        [found] = report["diagnostics"]
        return suggested(found), int("fix" in found)

    def test_a_child_is_a_link_without_a_joint(self):
        self.assertEqual(self.help_of("Z_propeller"), ("did you mean `top_propeller`, to which no joint leads?", 1))
        self.assertEqual(self.help_of("mst"), ("did you mean `mast`?", 1))
        self.assertEqual(self.help_of("bse"), (None, 0))  # the joint would lead to its own parent

    def test_a_renamed_link_is_one_finding(self):
        links = "".join(f'<link name="{name}"/>' for name in ("base_link", "a", "b", "c", "d"))
        joints = "".join(f'<joint name="to_{name}" type="fixed"><parent link="base"/><child link="{name}"/></joint>' for name in "abcd")
        self.write("r.urdf", f'<robot name="r">{links}{joints}</robot>')
        found = [one for one in json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"] if one["id"] == "SML1201"]
        self.assertEqual(len(found), 1, found)
        self.assertEqual(found[0]["help"], "did you mean `base_link`, which no joint names?")
        self.assertIn("3 more joints name it: joint `to_b`, joint `to_c`, joint `to_d`", found[0]["notes"])
        self.run_tool("--fix-only", "--unsafe-fixes", "r.urdf")
        self.assertEqual(self.read("r.urdf").count('"base_link"'), 5)
        self.assertEqual(self.read("r.urdf").count('"base"'), 0)

    def test_a_renamed_joint_is_shown_once(self):
        """Eight places name it; all are in reports for programs, and are fixed."""
        shutil.copytree(cli.FIXTURES / "models/arm", self.folder / "arm")
        urdf = self.read("arm/urdf/arm.urdf").replace('<joint name="joint2_shoulder"', '<joint name="joint2_sholder"')
        self.write("arm/urdf/arm.urdf", urdf)
        said = self.expect(1, "arm").stdout
        self.assertLess(len(said.splitlines()), 25)
        self.assertEqual(said.count("error[") + said.count("warning["), 1)
        self.assertIn("7 more findings in 3 files have this cause: `--all` shows where else `joint2_shoulder` is named", said)
        line = urdf[:urdf.index('"joint2_sholder"')].count("\n") + 1
        self.assertIn(f"Or was it renamed by mistake? Then write `joint2_shoulder` at arm/urdf/arm.urdf:{line} [unsafe fix]", said)
        self.assertEqual(self.expect(1, "--all", "arm").stdout.count("did you mean `joint2_sholder`?"), 8)
        self.assertEqual(len(json.loads(self.run_tool("--format", "json", "arm").stdout)["diagnostics"]), 8)
        # Two findings are shown one by one.
        self.write("arm/smurf/arm_submechanisms.yml", "submechanisms: []\n")
        self.write("arm/smurf/arm_sensors.yml", "sensors: []\n")
        self.assertNotIn("have this cause", self.expect(1, "arm").stdout)

    def test_no_motors_are_one_finding(self):
        shutil.copytree(cli.FIXTURES / "models/arm", self.folder / "arm")
        self.write("arm/smurf/arm_motors.yml", "motors: []\n")
        report = json.loads(self.run_tool("--format", "json", "arm").stdout)
        found = [one for one in report["diagnostics"] if one["id"] == "SML3105"]
        self.assertEqual([one["notes"] for one in found], [["the model has no motor, and 10 names of motors"]])

    def test_what_is_no_text(self):
        for begin, what in ((b"PK\x03\x04x", "a zip archive"), (b"\x1f\x8b\x08", "a gzip archive"), (b"\x89PNG\r\n", "a PNG image")):
            (self.folder / "r.urdf").write_bytes(begin)
            [found] = json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"]
            self.assertEqual((found["id"], found["message"]), ("SML0003", f"`r.urdf` is {what}, and not a text file"))
            self.assertTrue(found["help"])

    def test_a_package_without_package_xml(self):
        shape = '<collision><geometry><mesh filename="package://go2/{}"/></geometry></collision>'
        robot = '<robot name="r"><link name="a">{}</link><link name="b">{}</link></robot>'
        (self.folder / "go2/collisions").mkdir(parents=True)
        shutil.copy(cli.FIXTURES / "models/arm/meshes/forearm_hull.stl", self.folder / "go2/collisions/base.stl")
        for first, rule, words in (("collisions/Base.STL", "SML1605", "write `package://go2/collisions/base.stl`"),
                                   ("collisions/bse.stl", "SML1604", "did you mean `base.stl`?")):
            self.write("go2/urdf/r.urdf", robot.format(shape.format(first), shape.format("collisions/base.stl")))
            report = json.loads(self.run_tool("--format", "json", "--select", "SML16", "go2/urdf/r.urdf").stdout)
            self.assertEqual([(one["id"], one["help"]) for one in report["diagnostics"]], [(rule, words)])
        self.write("go2/urdf/r.urdf", robot.format(shape.format("other/x.stl"), shape.format("collisions/base.stl")))
        self.assertIn("the folder `go2` above the URDF does not contain it", self.run_tool("go2/urdf/r.urdf").stdout)

    def test_a_robot_of_macros_only(self):
        self.write("r.urdf", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"></robot>')
        found = json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"]
        self.assertEqual([one["id"] for one in found], ["SML1115"])
        self.assertIn("a xacro file that only defines macros makes an empty robot", found[0]["notes"])

    def test_a_configuration_that_is_not_there_ends_the_run(self):
        self.write("r.urdf", '<robot name="r"><link name="l"/></robot>')
        done = self.run_tool("--config", "nothing.yaml", "r.urdf")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("cannot read 'nothing.yaml': No such file", done.stderr)

    def test_a_file_of_another_program(self):
        self.write("tsconfig.json", "{}\n")
        done = self.run_tool("tsconfig.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("it has no section of SMURF", done.stderr)

    def test_a_placeholder_that_xacro_files_include(self):
        """empty.urdf of Clearpath: no finding that is shown, unless it is not only comments."""
        self.write("r.urdf", "<robot>\n  <!-- Included by default. -->\n</robot>\n")
        found = json.loads(self.expect(0, "--format", "json", "r.urdf").stdout)["diagnostics"]
        self.assertEqual([(one["id"], one["severity"]) for one in found], [("SML1115", "info")])
        for text in ("<robot/>", "<robot><!-- a --><material name='a'/></robot>"):
            self.write("r.urdf", text)
            found = json.loads(self.expect(1, "--format", "json", "r.urdf").stdout)["diagnostics"]
            self.assertEqual({(one["id"], one["severity"]) for one in found} & {("SML1102", "error"), ("SML1115", "error")},
                             {("SML1102", "error"), ("SML1115", "error")})

    def test_foreign_elements_say_where_they_belong(self):
        self.write("r.urdf", '<robot name="r"><link name="l"><gazebo reference="l"/><insert_block name="b"/><density/></link></robot>')
        found = json.loads(self.run_tool("--select", "SML1106", "--format", "json", "r.urdf").stdout)["diagnostics"]
        self.assertEqual([one["help"] for one in found], [
            'move it to `robot`, as `<gazebo reference="NAME">` with the name of the link: Gazebo reads it only there',
            "write `xacro:insert_block`: without the prefix, xacro copies it",
            "correct the name; foreign data belongs under `robot` or needs a prefix"])

    def test_a_placeholder_is_no_other_unit(self):
        """0.0001 three times: as if it were in lb in2. Moments with more digits than two were computed in some unit."""
        link = ('<robot name="r"><link name="l"><inertial><mass value="0.005"/><inertia ixx="{0}" ixy="0" ixz="0" iyy="{0}" iyz="0" izz="{0}"/></inertial>'
                '<collision><geometry><sphere radius="0.005"/></geometry></collision></link></robot>')
        for moment, wanted in ((0.0001, "it looks like a placeholder; compute it from the geometry and the mass, in kg m2"), (0.000171, "is it in lb in2?"),
                               (0.00017, "compute the inertia from the geometry and the mass, in kg m2")):
            self.write("r.urdf", link.format(moment))
            found = json.loads(self.run_tool("--select", "SML1518", "--format", "json", "r.urdf").stdout)["diagnostics"]
            self.assertEqual([one["help"] for one in found], [wanted])

    def test_load_yaml_of_an_empty_argument(self):
        self.write("r.xacro", """<robot name="r" xmlns:xacro="x"><xacro:arg name="file" default=""/><xacro:property name="f" value="$(arg file)"/>
            <xacro:property name="y" value="${load_yaml(f)}"/><link name="${y['a']}"/></robot>""")
        done = self.expect(1, "r.xacro").stdout
        self.assertIn("error[SML3310]: the name of the YAML file is empty", done)
        self.assertIn("give the argument that names the file a value: `NAME:=PATH`", done)
        self.write("r.xacro", """<robot name="r" xmlns:xacro="x"><xacro:arg name="file" default=""/><xacro:include filename="$(arg file)"/></robot>""")
        done = self.expect(1, "r.xacro").stdout
        self.assertIn("error[SML3310]: the name of the included file is empty", done)
        self.assertIn("info[SML3310]", self.expect(0, "--min-severity", "info", ".").stdout)  # a launch file may give it

    def test_robots_that_share_a_macro_share_its_finding(self):
        """The names in the messages differ."""
        self.write("parts.xacro", """<robot xmlns:xacro="x"><xacro:macro name="arm" params="p"><link name="${p}arm"/>
            <gazebo reference="${p}amr_of_old"/></xacro:macro></robot>""")
        for name in "ab":
            self.write(name + ".urdf.xacro", f"""<robot name="{name}" xmlns:xacro="x"><xacro:include filename="parts.xacro"/>
                <xacro:arm p="{name}_"/></robot>""")
        shown = self.run_tool("--select", "SML1445", ".").stdout
        self.assertEqual(shown.count("warning[SML1445]"), 1, shown)
        self.assertIn("`a_amr_of_old`", shown)
        self.assertIn("... and the same in 1 more robot\n", shown)
        self.assertIn("found 2 warnings", shown)
        self.assertEqual(self.run_tool("--select", "SML1445", "--all", ".").stdout.count("warning[SML1445]"), 2)

    def test_an_inertia_in_other_units(self):
        link = '<robot name="r"><link name="l"><inertial><mass value="{}"/><inertia ixx="{}" ixy="0" ixz="0" iyy="{}" iyz="0" izz="{}"/></inertial></link></robot>'
        for mass, moment, wanted in ((6921, 24480, ""), (6921, 99480, "are these g and g mm2? write kg and kg m2"),
                                     (0.5, 6700, "is this kg mm2? write kg m2"), (500, 1e-4, "is the mass in g? write kg")):
            self.write("r.urdf", link.format(mass, moment, moment, moment))
            found = [one for one in json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"] if one["id"] == "SML1523"]
            self.assertEqual([one["help"] for one in found], [wanted] if wanted else [])
        zero = link.format(1, 0, 0, 0).replace('ixy="0"', 'ixy="1e-35"')
        self.write("r.urdf", zero)
        ids = {one["id"] for one in json.loads(self.run_tool("--format", "json", "r.urdf").stdout)["diagnostics"]}
        self.assertIn("SML1511", ids)
        self.assertNotIn("SML1512", ids)

    def test_of_equally_near_names_none_is_suggested(self):
        self.assertEqual(self.help_of("mast", "FX_propeller"), (None, 0))
        self.assertEqual(self.help_of("mast", "FL_propelller"), ("did you mean `FL_propeller`?", 1))

    def test_a_motor_often_has_the_name_of_its_joint(self):
        self.write_model(motors=MOTORS.replace("joint: elbow", "joint: arm9_x"))
        report = json.loads(self.expect(1, "--select", "SML3101", "--format", "json", ".").stdout)
        self.assertEqual([d["help"] for d in report["diagnostics"]], ["did you mean `elbow`, which no motor drives?"])


class Explanations(LintTest):
    def test_elements(self):
        text = self.expect(0, "--explain", "mesh").stdout
        self.assertTrue(text.startswith("mesh: element of a URDF."), text)
        self.assertIn("scale", text)

    def test_attributes(self):
        for name, value in (("multiplier", "a number"), ("k_velocity", "a number"), ("mesh.scale", "three numbers"),
                            ("quat_xyzw", "four numbers"), ("filename", "a text")):
            self.assertIn(f"\nValue: {value}", self.expect(0, "--explain", name).stdout, name)

    def test_everything_fits_a_terminal(self):
        for arguments in (["--list-rules"], ["--explain", "SML1"], ["--limit", "help"], ["--help"]):
            for line in self.expect(0, *arguments).stdout.splitlines():
                self.assertLessEqual(len(line), 80, line)

    def explain(self, what):
        return self.expect(0, "--explain", what).stdout

    def test_families(self):
        for prefix in ("SML31", "31"):
            lines = self.explain(prefix).splitlines()
            self.assertGreater(len(lines), 10)
            self.assertTrue(all(line.startswith(("SML31", " ")) for line in lines), lines)
        self.assertEqual(self.explain("3101"), self.explain("SML3101"))

    def test_sections(self):
        self.assertIn("number, at least 0, in rad/s or m/s; default 0", self.explain("motors"))
        self.assertEqual(self.explain("joints"), self.explain("joint"))
        self.assertIn("\nrotation\n", self.explain("entity"))
        self.assertIn("can also have the keys of `node`", self.explain("collision"))
        for line in self.explain("sensors").splitlines():
            self.assertLessEqual(len(line), 80)

    def test_comment_is_told_the_rule_it_names(self):
        self.write("m.yml", "# smurf-lint: ignore SML1501 because\nmotors: []\n")
        self.assertIn("write `smurf-lint: ignore[SML1501] reason`", self.expect(0, "m.yml").stdout)
        self.write("m.yml", "# smurf-lint: ignore this\nmotors: []\n")
        self.assertIn("write `smurf-lint: ignore[ID] reason`", self.expect(0, "m.yml").stdout)


class JunitAgreesWithTheExitCode(LintTest):
    def test_failures_decide(self):
        self.write("m.yml", "materials:\n- name: x\n  diffuseColor: {r: 1, g: 0, b: 0}\n")  # a warning
        for code, options in ((0, []), (1, ["--fail-on", "warning"]), (0, ["--fail-on", "never"]),
                              (1, ["--max-warnings", "0"]), (0, ["--max-warnings", "1"])):
            with self.subTest(options):
                report = self.expect(code, *options, "--format", "junit", "m.yml").stdout
                self.assertIn(f' failures="{code}"', report)
                self.assertIn("SML4115", report)


class Usage(LintTest):
    def test_mistakes(self):
        for text, arguments in (
                ("unknown option '--formt'; did you mean '--format'?", ["--formt", "json"]),
                ("unknown option '-Q' (see --help)", ["-Q"]),
                ("unknown option '--selct'; did you mean '--select'?", ["--selct=SML1"]),
                ("--format needs a value: FORMAT[=FILE]", ["--format"]),
                ("--format needs a value: FORMAT[=FILE]", ["--format", "--quiet"]),
                ("--format: 'jsn' is not one of full, concise, json, jsonl, sarif, github, gitlab, junit, html, auto; did you mean 'json'?",
                 ["--format=jsn"]),
                ("--format: there is no file name after '='", ["--format=json="]),
                ("--color: 'allways' is not one of auto, always, never; did you mean 'always'?",
                 ["--color", "allways"]),
                ("--select: there is no rule 'unknown-jont'; did you mean 'unknown-joint'?",
                 ["--select", "SML1,unknown-jont"]),
                ("--ignore: there is no rule 'sml3101'; did you mean 'SML3101'?",
                 ["--ignore=sml3101"]),
                ("--severity: 'SML3101' is not ID=LEVEL", ["--severity", "SML3101"]),
                ("--severity: 'fatal' is not one of error, warning, info",
                 ["--severity", "SML3101=fatal"]),
                ("--max-warnings: '-1' is not a whole number of at least 0",
                 ["--max-warnings=-1"]),
                ("--jobs: '0' is not a whole number of at least 1", ["-j0"]),
                ("--package: 'arm' is not NAME=DIR", ["--package", "arm"]),
                ("--quiet takes no value", ["--quiet=false"]),
                ("there is no rule, section, element or key 'SLM3101'; did you mean 'SML3101'?", ["--explain", "SLM3101"]),
                ("there is no rule, section, element or key 'x'", ["--explain", "x"]),
                ("there is no rule, section, element or key 'sensrs'; did you mean 'sensors'?", ["--explain", "sensrs"]),
                ("unknown option '--gener'; did you mean '--generate-baseline'?", ["--gener"]),
                ("--severity: 'warn' is not one of error, warning, info; did you mean 'warning'?",
                 ["--severity", "SML3101=warn"]),
                ("two reports go to standard output; give one a separate file: "
                 "--format json=FILE", ["--format", "full", "--format", "json"]),
                ("two reports go to 'a'; give one a separate file: --format json=FILE",
                 ["--format", "full=a", "--format", "json=a"]),
                ("standard input can be read only once", ["-", "-"]),
                ("--diff shows what --fix would change; leave out --fix", ["--diff", "--fix"]),
                ("--unsafe-fixes needs --fix, --fix-only or --diff", ["--unsafe-fixes"]),
                ("cannot read '--x': No such file or directory", ["--", "--x"]),
                ("cannot read 'a\\u001bb': No such file or directory", ["a\x1bb"]),
        ):
            with self.subTest(arguments):
                done = self.expect(2, *arguments)
                # A run that continues after an unreadable path still reports.
                self.assertIn(done.stdout, ("", "no findings in 0 files\n"))
                self.assertEqual(done.stderr.count("\n"), 1)
                self.assertTrue(done.stderr.startswith("smurf-lint: " + text), done.stderr)

    def test_help_and_version(self):
        page = self.expect(0, "--help").stdout
        self.assertEqual(self.expect(0, "-h").stdout, page)
        self.assertLessEqual(max(map(len, page.splitlines())), 80)
        for word in ("Examples:", "--stdin-filename PATH", "-o, --output FILE", "Exit codes:"):
            self.assertIn(word, page)
        self.assertRegex(self.expect(0, "--version").stdout, r"^smurf-lint \d+\.\d+\.\d+\n$")

    def test_last_value_wins_and_clusters(self):
        self.write_model(motors=BROKEN_MOTORS)
        done = self.expect(0, "-qj4", "--fail-on=error", "--fail-on=never", "arm")
        self.assertNotIn("found", done.stdout)


class Rules(LintTest):
    def test_keys_are_explained(self):
        """From the tables: keys of YAML files, settings, and attributes of URDF."""
        for name, parts in (("motors.maxEffort", ["`maxEffort` (motor)", "N m"]),
                            ("limit.effort", ["`effort` (limit)", "Largest torque or force", "N m or N"]),
                            ("entities.position", ["`position` (entity)", "in m", "Absent, it is"]),
                            ("config.targets", ["`targets` (configuration)"]),
                            ("joint.type", ["`prismatic`"])):
            page = self.expect(0, "--explain", name).stdout
            for part in parts:
                self.assertIn(part, page)
        self.assertGreater(self.expect(0, "--explain", "name").stdout.count("`name` ("), 5)

    def test_every_rule_is_explained(self):
        rules = json.loads(self.expect(0, "--list-rules=json").stdout)
        self.assertGreater(len(rules), 50)
        self.assertEqual([r["id"] for r in rules], sorted(r["id"] for r in rules))
        lines = self.expect(0, "--list-rules").stdout.splitlines()
        self.assertEqual([line[:7] for line in lines if not line.startswith(" ")], [r["id"] for r in rules])
        for rule in rules:
            page = self.expect(0, "--explain", rule["id"]).stdout
            self.assertTrue(page.startswith(f"{rule['id']} {rule['name']} ({rule['severity']}"))
            for heading in ("Why it matters|What readers make of it", "What to do", "Sources"):
                self.assertRegex(page, f"\n({heading})\n")
            self.assertLessEqual(max(map(len, page.splitlines())), 80, rule["id"])
        self.assertEqual(self.expect(0, "--explain", rules[-1]["name"]).stdout, page)


class Reports(LintTest):
    def test_json(self):
        self.write_model(motors=BROKEN_MOTORS)
        text = self.expect(1, "--format", "json", "arm/smurf/arm.smurf").stdout
        report = json.loads(text)
        self.assertEqual(list(report), ["schema_version", "tool", "summary", "diagnostics"])
        self.assertEqual(report["schema_version"], "1.0")
        self.assertEqual(report["tool"]["name"], "smurf-lint")
        self.assertEqual(report["summary"], {"error": 1, "warning": 0, "info": 0, "suppressed": 0,
                                             "files": 3, "models": 1, "scenes": 0})
        found = report["diagnostics"][0]
        place = {key: found[key] for key in ("id", "name", "severity", "file", "line", "column",
                                             "end_line", "end_column", "pointer")}
        self.assertEqual(place, {"id": "SML3101", "name": "unknown-joint", "severity": "error",
                                 "file": "arm/smurf/arm_motors.yml", "line": 3, "column": 10,
                                 "end_line": 3, "end_column": 15, "pointer": "/motors/0/joint"})
        self.expect_complaint("unknown option '--report' (see --help)", "--report", "json", "arm/smurf/arm.smurf")

    def test_several_reports(self):
        self.write_model(motors=BROKEN_MOTORS)
        done = self.expect(1, "--format", "concise", "--format", "json=a.json", "--format",
                           "full=a.txt", "arm")
        self.assertRegex(done.stdout,
                         r"^arm/smurf/arm_motors\.yml:3:10: error\[SML3101\] .*\n$")
        self.assertEqual(json.loads(self.read("a.json"))["summary"]["error"], 1)
        self.assertIn("error[SML3101]: ", self.read("a.txt"))

    def test_statistics_and_quiet(self):
        self.write_model(motors=BROKEN_MOTORS)
        counts = "1  error    SML3101 unknown-joint\n"
        self.assertEqual(self.expect(1, "--statistics", "arm").stdout,
                         counts + "\nfound 1 error in 3 files (1 model)\n"
                         "1 fixable with `--fix --unsafe-fixes`\n")
        self.assertEqual(
            self.expect(1, "--statistics", "--format=concise", "arm").stdout, counts)
        self.assertNotIn("found", self.expect(1, "-q", "arm").stdout)

    def test_same_output_every_time(self):
        for name in ("b", "a", "c"):
            self.write_model(name, motors=BROKEN_MOTORS)
        first = self.expect(1, ".").stdout
        self.assertEqual(first.count("error[SML3101]"), 1)
        self.assertIn("... and the same in 2 more files: b/smurf/arm_motors.yml and\nc/smurf/arm_motors.yml; ", first)
        self.assertEqual(self.expect(1, "-j", "8", ".").stdout, first)
        self.assertEqual(self.expect(1, "c", "a", "b").stdout, first)
        self.assertEqual(self.expect(1, environment={"LC_ALL": "de_DE.UTF-8"}).stdout, first)

    def test_color(self):
        self.write_model(motors=BROKEN_MOTORS)

        def is_colored(*arguments, **environment):
            return "\x1b[" in self.expect(1, *arguments, "arm", environment=environment).stdout

        self.assertFalse(is_colored())
        self.assertTrue(is_colored("--color", "always"))
        self.assertTrue(is_colored("--color", "always", NO_COLOR="1"))
        self.assertTrue(is_colored(FORCE_COLOR="1"))
        self.assertFalse(is_colored(FORCE_COLOR="0"))
        self.assertFalse(is_colored(FORCE_COLOR="1", NO_COLOR="1"))
        self.assertFalse(is_colored("--color", "never", FORCE_COLOR="1"))
        self.assertFalse(is_colored("--color=always", "--format=json"))
        self.expect(1, "-o", "plain.txt", "arm", environment={"FORCE_COLOR": "1"})
        self.assertNotIn("\x1b[", self.read("plain.txt"))


class Files(LintTest):
    def test_output_replaces_a_file_and_keeps_its_mode(self):
        self.write_model()
        self.write("report.txt", "old")
        (self.folder / "report.txt").chmod(0o640)
        self.assertEqual(self.expect(0, "-o", "report.txt", "arm").stdout, "")
        self.assertEqual(self.read("report.txt"), "no findings in 3 files (1 model)\n")
        self.assertEqual((self.folder / "report.txt").stat().st_mode & 0o777, 0o640)
        self.assertEqual(sorted(os.listdir(self.folder)), ["arm", "report.txt"])

    def test_output_through_a_link_and_to_standard_output(self):
        self.write_model()
        self.write("real/report.txt", "old")
        (self.folder / "link.txt").symlink_to("real/report.txt")
        self.expect(0, "-o", "link.txt", "arm")
        self.assertTrue((self.folder / "link.txt").is_symlink())
        self.assertIn("no findings", self.read("real/report.txt"))
        self.assertIn("no findings", self.expect(0, "-o", "-", "arm").stdout)
        self.expect(0, "-o", "/dev/null", "arm")
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())

    def test_output_that_cannot_be_written(self):
        self.write_model()
        self.write("report.txt", "old")
        for path, reason in (("arm", "Is a directory"),
                             ("arm/", "Is a directory"),
                             ("absent/report.txt", "there is no folder 'absent'"),
                             ("report.txt/x", "Not a directory"),
                             ("/dev/full", "No space left on device")):
            with self.subTest(path):
                self.expect_complaint(f"cannot write '{path}': {reason}", "-o", path, "arm")
        self.assertEqual(self.read("report.txt"), "old")

    def test_a_failed_write_leaves_the_old_file(self):
        self.write_model(motors=BROKEN_MOTORS)
        self.write("report.txt", "old")

        def allow_small_files_only():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (16, 16))

        self.expect_complaint("cannot write 'report.txt': File too large", "-o", "report.txt",
                              "arm", preexec_fn=allow_small_files_only)
        self.assertEqual(self.read("report.txt"), "old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["arm", "report.txt"])

    def test_standard_output_that_cannot_be_written(self):
        self.write_model()
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = self.run_tool("arm", stdout=full)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, "smurf-lint: cannot write standard output: "
                                      "No space left on device\n")
        reading, writing = os.pipe()
        os.close(reading)
        done = self.run_tool("--help", stdout=writing)
        os.close(writing)
        self.assertEqual((done.returncode, done.stderr), (2, ""))
        done = self.run_tool("arm", preexec_fn=lambda: os.close(1))
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr,
                         "smurf-lint: cannot write standard output: Bad file descriptor\n")


class Inputs(LintTest):
    def test_folder(self):
        self.write_model("b", motors=BROKEN_MOTORS)
        self.write_model("a", urdf=BROKEN_URDF)
        self.write_model(".hidden", motors=BROKEN_MOTORS)
        self.write("loose/x.urdf", BROKEN_URDF)
        self.assertEqual(self.findings("."), [("a/urdf/arm.urdf", "SML1201"),
                                              ("b/smurf/arm_motors.yml", "SML3101"),
                                              ("loose/x.urdf", "SML1201")])
        self.assertEqual(self.findings(), self.findings("."))
        self.assertEqual(self.findings("b"), [("b/smurf/arm_motors.yml", "SML3101")])
        done = self.expect(1, ".")
        self.assertIn("in 7 files (3 models)\n", done.stdout)

    def test_links_are_followed_once(self):
        self.write_model("arm", motors=BROKEN_MOTORS)
        (self.folder / "arm/loop").symlink_to("..")
        (self.folder / "again").symlink_to("arm")
        (self.folder / "same.smurf").symlink_to("arm/smurf/arm.smurf")
        (self.folder / "dangling").symlink_to("nowhere")
        self.assertEqual(self.findings("."), [("arm/smurf/arm_motors.yml", "SML3101")])
        (self.folder / "lost.smurf").symlink_to("nowhere.smurf")
        done = self.expect(2, ".")
        self.assertEqual(done.stderr, "smurf-lint: cannot read 'lost.smurf': "
                                      "No such file or directory\n")

    def test_json_of_other_programs(self):
        self.write("tsconfig.json", '{"compilerOptions": {"strict": true}}')
        self.expect_complaint("cannot check 'tsconfig.json': it has no section of SMURF, such as `motors`, and no model lists it",
                              "tsconfig.json")
        self.write("motors.json", '{"motors": []}')
        self.expect(0, "motors.json")

    def test_yaml_of_other_programs(self):
        self.write("ci.yml", "name: CI\non: push\njobs: {}\n")
        self.expect_complaint("cannot check 'ci.yml': it has no section of SMURF, such as `motors`, and no model lists it",
                              "ci.yml")
        self.expect(0, "--only-listed", "ci.yml")  # as hooks do
        for text in ("motors: []\n", "'motors' : []\n", "{lights: []}\n"):
            self.write("a.yml", text)
            self.expect(0, "a.yml")
        self.write("a.yml", "# a draft\n")
        self.assertIn("the annotation file is empty", self.expect(1, "a.yml").stdout)
        self.write("jobs.json", '{"type": "array"}')
        self.write(".smurf-lint.yaml", "schemas: {sections: {jobs: jobs.json}}\n")
        self.assertIn("SML4301", self.expect(1, "ci.yml").stdout)

    def test_a_package_folder_without_the_file(self):
        urdf = '<robot name="r"><link name="l"><visual><geometry><mesh filename="package://arm/m.obj"/></geometry></visual></link></robot>'
        self.write("arm/urdf/r.urdf", urdf)
        self.write("other/r.urdf", urdf)
        self.assertIn("the folder `arm` above the URDF does not contain it", self.expect(0, "arm").stdout)
        self.assertIn("in no folder above the URDF", self.expect(0, "other").stdout)

    def test_merge_conflicts(self):
        urdf = '<robot name="r">\n<<<<<<< HEAD\n<link name="a"/>\n=======\n<link name="b"/>\n>>>>>>> b\n</robot>\n'
        self.write("r.urdf", urdf)
        self.assertIn("error[SML1001]: a merge conflict left its markers here\n --> r.urdf:2:1\n", self.expect(1, "r.urdf").stdout)

    def test_scenes_as_newcomers_write_them(self):
        self.write_model()
        for text, helps in (
                ("entities:\n- arm/smurf/arm.smurf\n", ["write `{name: NAME, file: FILE}`"]),
                ("- {name: a, file: arm/smurf/arm.smurf}\n", ["write `entities:` above the list"]),
                ("entities:\n- {name: a, type: Robot, path: arm/smurf/arm.smurf}\n", ["did you mean `smurf`?"]),
                ("entities:\n- {name: a, type: model, file: arm/urdf/arm.urdf}\n", ["did you mean `urdf`?"])):
            self.write("s.smurfs", text)
            report = json.loads(self.run_tool("s.smurfs", "--format", "json").stdout)
            self.assertEqual([d.get("help") for d in report["diagnostics"] if d["severity"] != "info"], helps, text)

    def test_where_standard_input_looks_for_files(self):
        urdf = '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.obj"/></geometry></visual></link></robot>'
        remark = "paths start at the current folder; --stdin-filename PATH sets another place\n"
        self.assertIn(remark, self.expect(1, "-", stdin=urdf).stdout)
        self.assertNotIn(remark, self.expect(1, "-", "--stdin-filename", "a/b.urdf", stdin=urdf).stdout)
        self.assertNotIn(remark, self.expect(0, "-", stdin=urdf.replace("<visual>", "<!--").replace("</visual>", "-->")).stdout)

    def test_sections_are_explained_before_rules_that_had_their_name(self):
        self.assertTrue(self.expect(0, "--explain", "scene").stdout.startswith("scene: a mapping"))
        for name in ("smurf", "model"):
            self.assertTrue(self.expect(0, "--explain", name).stdout.startswith("main file: "))
        self.assertTrue(self.expect(0, "--explain", "scene-unread").stdout.startswith("SML7100"))

    def test_a_level_of_other_linters(self):
        self.expect_complaint("--severity: 'off' is not one of error, warning, info; to switch it off: --ignore SML1501",
                              "--severity", "SML1501=off", ".")

    def test_a_configuration_is_no_model(self):
        self.write(".smurf-lint.yaml", "targets: [ros]\n")
        self.assertEqual(self.expect(0, ".smurf-lint.yaml").stdout, "no findings in 1 file\n")
        self.write(".smurf-lint.yaml", "targets: [ros, gazbo]\n")
        self.assertIn("there is no target `gazbo`", self.expect(1, ".smurf-lint.yaml").stdout)
        self.assertEqual(self.expect(2, ".").stdout.count("no findings"), 0)

    def test_subcommands(self):
        for word, instead in (("check", "leave the word out"), ("fix", "write --fix"), ("rule", "write --explain"),
                              ("help", "write --help")):
            self.assertIn(f"cannot read '{word}': No such file or directory; smurf-lint has no subcommands: {instead}",
                          self.expect(2, word, ".").stderr)
        self.assertIn("; to read about a rule, write --explain SML1501", self.expect(2, "SML1501").stderr)

    def test_nothing_to_check(self):
        self.write("notes/readme.txt", "")
        done = self.expect(2, "notes")
        self.assertEqual(done.stderr, "smurf-lint: no .smurf, .smurfs, .smurfa, .urdf or .xacro file in "
                                      "'notes'\n")
        self.assertEqual(self.expect(2).stderr, "smurf-lint: no .smurf, .smurfs, .smurfa, .urdf or .xacro "
                                                "file in '.'\n")

    def test_xacro_roots_of_a_folder(self):
        head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        self.write("robot/lib/arm.xacro", head.replace(' name="r"', "") +
                   '<xacro:macro name="arm" params="name">\n<link name="${name}"/>\n<link name="${name}"/></xacro:macro></robot>')
        self.write("robot/a.urdf.xacro", head + '<xacro:include filename="lib/arm.xacro"/>\n<xacro:arm name="a"/></robot>')
        self.write("robot/.hidden/c.xacro", head)
        self.write("robot/part.xacro", head.replace(' name="r"', "") + '<link name="${prefix}a"/></robot>')
        done = self.expect(1, "robot", "--select", "SML1301,SML33")
        self.assertIn("robot/a.urdf.xacro:2:18", done.stdout)  # the literal that both links get
        self.assertIn("in `arm`, called here with name=a", done.stdout)
        self.assertIn("(1 model)\n", done.stdout)
        report = json.loads(self.expect(1, "robot", "--format", "json", "--select", "SML1301").stdout)
        self.assertNotIn("xacro", report["summary"])
        finding, = report["diagnostics"]
        self.assertEqual(finding["file"], "robot/a.urdf.xacro")

    def test_values_of_arguments_in_launch_files(self):
        self.write("arm/package.xml", "<package><name>arm</name></package>")
        self.write("arm/urdf/arm.urdf.xacro", '<robot name="$(arg name)" xmlns:xacro="x"><link name="$(arg side)_$(arg kind)"/></robot>')
        self.write("arm/launch/view.launch", '<launch><arg name="side" default="left"/><arg name="name" default="$(env X)"/></launch>')
        self.write("arm/launch/view.launch.py", 'DeclareLaunchArgument(\n  "name", default_value="gantry")')
        self.write("arm/CMakeLists.txt", "xacro_add_xacro_file(urdf/arm.urdf.xacro arm.urdf side:=right)")
        done = self.expect(1, "arm/urdf/arm.urdf.xacro", "--select", "SML33")
        for text in ("also without a value: `side`, `kind`", "`side` is `left` in `arm/launch/view.launch`",
                     "`name` is `gantry` in `arm/launch/view.launch.py`", "`side` is `right` in `arm/CMakeLists.txt`",
                     "`name:=gantry side:=right kind:=VALUE`"):
            self.assertIn(text, " ".join(done.stdout.split()).replace(" = note: ", " "), text)

    def test_a_relative_path_at_another_place(self):
        self.write("lib/d.yaml", "mass: 1\n")
        self.write("lib/lib.xacro", """<robot xmlns:xacro="x"><xacro:macro name="arm" params="">
<xacro:property name="d" value="${xacro.load_yaml('d.yaml')}"/><link name="${d['mass']}"/></xacro:macro></robot>""")
        self.write("a.urdf.xacro", '<robot name="r" xmlns:xacro="x"><xacro:include filename="lib/lib.xacro"/><xacro:arm/></robot>')
        done = self.expect(1, "a.urdf.xacro", "--select", "SML33")
        self.assertIn("a relative path belongs to the file that is processed, `a.urdf.xacro`, so `lib/d.yaml` is not found",
                      " ".join(done.stdout.split()).replace(" = note: ", " "))

    def test_a_text_that_should_be_a_number(self):
        self.write("d.yaml", "mass: 1e-3\n")
        self.write("a.urdf.xacro", """<robot name="r" xmlns:xacro="x"><xacro:property name="d" value="${xacro.load_yaml('d.yaml')}"/>
<link name="${2 * 1.5 * d['mass']}"/></robot>""")
        done = self.expect(1, "a.urdf.xacro", "--select", "SML33")
        self.assertIn("d.yaml:1:7", done.stdout)
        self.assertIn("write `1.0e-3`; in YAML 1.1", done.stdout)

    def test_a_part_is_judged_in_its_robots(self):
        self.enter_workspace()  # its robots are looked for in the whole repository, up to a limit
        self.write("robot/package.xml", "<package><name>r</name></package>")
        self.write("robot/lib/arm.xacro", '<robot xmlns:xacro="x"><xacro:macro name="arm" params="name">\n'
                   '<link name="${name}"/>\n<link name="${name}"/></xacro:macro></robot>')
        self.write("robot/a.urdf.xacro", '<robot name="r" xmlns:xacro="x"><xacro:include filename="lib/arm.xacro"/>\n'
                   '<xacro:arm name="a"/></robot>')
        done = self.expect(1, "--only-listed", "robot/lib/arm.xacro", "--select", "SML1301")
        self.assertIn("--> robot/a.urdf.xacro:2:18", done.stdout)
        # Named alone, it is a part.
        self.assertIn("no findings", self.expect(0, "robot/lib/arm.xacro", "--select", "SML1301").stdout)

    def test_rename_in_xacro(self):
        self.write("lib.xacro", '<robot xmlns:xacro="x"><xacro:macro name="arm" params="name">\n<link name="${name}"/>\n'
                   '<joint name="${name}_joint" type="fixed"><parent link="base"/><child link="${name}"/></joint>\n'
                   '</xacro:macro></robot>\n')
        self.write("a.urdf.xacro", '<robot name="r" xmlns:xacro="x"><xacro:include filename="lib.xacro"/>\n'
                   '<link name="base"/><xacro:arm name="a"/><xacro:arm name="b"/></robot>\n')
        before = {name: self.read(name) for name in ("lib.xacro", "a.urdf.xacro")}
        self.expect(0, "--rename", "link:base=chassis", "a.urdf.xacro")
        for name, text in before.items():
            self.assertEqual(self.read(name), text.replace('"base"', '"chassis"'))
        self.expect(0, "--rename", "link:chassis=base", "a.urdf.xacro")
        self.assertEqual({name: self.read(name) for name in before}, before)
        for new in ("joint:a_joint=x", "link:base=7", "link:base=${x}", "link:base=true"):
            self.assertIn("nothing was renamed", self.expect(2, "--rename", new, "a.urdf.xacro").stderr)
        self.assertEqual({name: self.read(name) for name in before}, before)

    def test_xacro_arguments(self):
        self.write("a.urdf.xacro", '<robot name="r" xmlns:xacro="x"><link name="$(arg side)_arm"/></robot>')
        done = self.expect(1, "a.urdf.xacro", "--select", "SML33")
        self.assertIn("error[SML3313]: the argument `side` has no value here", done.stdout)
        self.expect(0, "a.urdf.xacro", "side:=left", "--select", "SML33")

    def test_one_cause_in_several_calls(self):
        self.write("a.urdf.xacro", """<robot name="r" xmlns:xacro="x">
<xacro:macro name="wheel" params="name mass">
  <link name="${name}"><inertial><mass value="${mass}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="${name}_joint" type="fixed"><parent link="base"/><child link="${name}"/></joint>
</xacro:macro>
<xacro:property name="m" value="-2"/>
<link name="base"/>
<xacro:wheel name="left" mass="${m}"/>
<xacro:wheel name="right" mass="${m}"/>
<xacro:wheel name="rear" mass="-1"/>
</robot>
""")
        done = self.expect(1, "a.urdf.xacro", "--select", "SML1509", "--format", "json")
        found = [(one["line"], one["column"]) for one in json.loads(done.stdout)["diagnostics"]]
        self.assertEqual(found, [(6, 33), (10, 32)])
        self.assertIn("also in 1 other place of the robot, from calls at a.urdf.xacro:9", done.stdout)

    def test_links_that_lead_out_are_not_followed(self):
        self.write("robot/plain.urdf", URDF)
        (self.folder / "links").mkdir()
        for target in ("../robot", "../nowhere"):  # the message must not reveal which of them exists
            (self.folder / "links/robot").unlink(missing_ok=True)
            (self.folder / "links/robot").symlink_to(target)
            self.assertEqual(self.expect(2, "links").stderr,
                             "smurf-lint: no .smurf, .smurfs, .smurfa, .urdf or .xacro file in 'links'; symbolic links that lead out "
                             "of the folder are not followed: name what to check there\n")

    def test_links_that_lead_out_are_counted(self):
        self.write("robot/plain.urdf", URDF)
        self.write("elsewhere/other.urdf", URDF)
        self.assertNotIn("links", self.expect(0, "robot", "--format", "json").stdout)
        for number, told in enumerate(("1 symbolic link that leads out of the folder was not followed",
                                       "2 symbolic links that lead out of the folder were not followed")):
            (self.folder / f"robot/link{number}").symlink_to("../elsewhere")
            self.assertEqual(self.expect(0, "robot").stdout.splitlines()[-1], told + "; name what to check there")
            report = json.loads(self.expect(0, "robot", "--format", "json").stdout)
            self.assertEqual(report["summary"]["links"], number + 1)
        self.write("robot/.smurf-lintignore", "link0\n")
        self.assertEqual(json.loads(self.expect(0, "robot", "--format", "json").stdout)["summary"]["links"], 1)

    def test_unreadable_inputs(self):
        self.write_model(motors=BROKEN_MOTORS)
        os.mkfifo(self.folder / "pipe.smurf")
        self.write("part.stl", "solid")
        done = self.expect(2, "absent.smurf", "pipe.smurf", "part.stl", "arm")
        self.assertEqual(done.stderr.splitlines(), [
            "smurf-lint: cannot read 'absent.smurf': No such file or directory",
            "smurf-lint: cannot read 'pipe.smurf': is not a regular file",
            "smurf-lint: no model near 'part.stl' uses it"])
        self.assertIn("error[SML3101]", done.stdout)

    def test_a_part_is_checked_with_the_models_that_list_it(self):
        self.write_model(motors=BROKEN_MOTORS)
        for part in ("arm/urdf/arm.urdf", "arm/smurf/arm_motors.yml"):
            with self.subTest(part):
                self.assertEqual(self.findings(part), [("arm/smurf/arm_motors.yml", "SML3101")])
        # Another model with the same URDF, in the parent folder.
        self.write("arm/second.smurf", "modelname: second\nfiles:\n- urdf/arm.urdf\n"
                                       "- second_motors.yml\n")
        self.write("arm/second_motors.yml", BROKEN_MOTORS)
        self.assertEqual(self.findings("arm/urdf/arm.urdf"),
                         [("arm/second_motors.yml", "SML3101"),
                          ("arm/smurf/arm_motors.yml", "SML3101")])
        self.assertEqual(self.findings("arm/second_motors.yml"),
                         [("arm/second_motors.yml", "SML3101")])
        self.assertEqual(self.findings("arm/urdf/arm.urdf", "arm/smurf/arm.smurf", "arm"),
                         self.findings("arm/urdf/arm.urdf"))

    def test_a_part_without_a_model_is_checked_alone(self):
        self.write("alone.urdf", BROKEN_URDF)
        self.write("alone.yml", "motors: [\n")
        self.assertEqual(self.findings("alone.urdf"), [("alone.urdf", "SML1201")])
        self.assertEqual(self.findings("alone.yml"), [("alone.yml", "SML0010")])
        # Findings that need the model are not reported.
        self.write("motors.yml", BROKEN_MOTORS)
        self.assertEqual(self.findings("motors.yml", code=0), [])

    def test_standard_input(self):
        self.write_model()
        self.assertEqual(self.findings("-", stdin=BROKEN_URDF), [("stdin.urdf", "SML1201")])
        xacro = BROKEN_URDF.replace("<robot ", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" ', 1)
        self.assertEqual(self.findings("-", stdin=xacro), [("stdin.urdf.xacro", "SML1201")])
        sdf = '<?xml version="1.0"?>\n<!-- <robot> -->\n<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>'
        self.assertEqual(self.findings("-", stdin=sdf, code=0), [("stdin.sdf", "SML9315")])
        mjcf = '<mujoco><worldbody><body><geom type="sphere"/></body></worldbody></mujoco>'
        self.assertEqual(self.findings("-", stdin=mjcf), [("stdin.xml", "SML9301")])
        self.assertEqual(
            self.findings("--stdin-filename", "arm/smurf/arm_motors.yml", "-",
                          stdin=BROKEN_MOTORS),
            [("arm/smurf/arm_motors.yml", "SML3101")])
        self.assertEqual(
            self.findings("--stdin-filename", "arm/smurf/new.smurf", "-",
                          stdin=SMURF + "- absent.yml\n"),
            [("arm/smurf/new.smurf", "SML2001")])
        self.expect_complaint("standard input is not XML; say what it is with --stdin-filename "
                              "PATH", "-q", "-", stdin=SMURF)

    def test_packages(self):
        self.write("meshes/a.stl", "")
        mesh = URDF.replace('<link name="base"/>',
                            '<link name="base"><visual><geometry><mesh filename='
                            '"package://arm/meshes/b.stl"/></geometry></visual></link>')
        self.write("a.urdf", mesh)
        self.assertIn(("a.urdf", "SML1604"), self.findings("--package", "arm=.", "a.urdf"))

    def test_scene(self):
        self.write_model(motors=BROKEN_MOTORS)
        self.write("cell.smurfs", "entities:\n- name: one\n  type: smurf\n"
                                  "  file: arm/smurf/arm.smurf\n  position: [0, 0, 0]\n"
                                  "  rotation: [1, 0, 0, 0]\n")
        expected = ("arm/smurf/arm_motors.yml", "SML3101")
        self.assertEqual(self.findings("cell.smurfs").count(expected), 1)
        self.assertEqual(self.findings(".").count(expected), 1)
        self.assertIn("(1 model, 1 scene)\n", self.expect(1, ".").stdout)


class Dumps(LintTest):
    """--dump-model; tests/schema and tests/python check its contents for all fixtures."""

    def dump(self, path, code=0, *options):
        done = self.run_tool("--dump-model", path, *options)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout), done.stderr

    def test_model(self):
        self.write_model()
        dump, said = self.dump("arm/smurf/arm.smurf")
        model = dump["model"]
        self.assertEqual(said, "")
        self.assertEqual([file["kind"] for file in model["files"]], ["main", "urdf", "annotation"])
        self.assertEqual(model["joints"][0]["axis"], [0, 0, 1])
        self.assertEqual(model["joints"][0]["limit"], {"effort": 1, "velocity": 1})
        self.assertEqual(model["annotations"]["motors"], [
            {"source": {"file": "arm/smurf/arm_motors.yml", "line": 2, "column": 3},
             "values": {"name": "elbow", "joint": "elbow", "type": "PID", "maxEffort": 1, "maxSpeed": 1}}])

    def test_values_as_tables_understand_them(self):
        self.write("arm_more.yml", "sensors:\n- {name: a, type: 7, id: [b], rate: '3', more: [1, {x: ~}]}\n"
                                   "- &e {name: c, rate: 2}\n- *e\nmine: {a: .inf, a: 2, b: true}\n")
        model = self.dump("arm_more.yml", 1)[0]["model"]
        self.assertEqual([entry["values"] for entry in model["annotations"]["sensors"]],
                         [{"name": "a", "type": "7", "id": ["b"], "more": [1, {"x": None}]},
                          {"name": "c", "rate": 2}, {"name": "c", "rate": 2}])
        self.assertEqual([(one["name"], one["value"]) for one in model["custom"]],
                         [("mine", {"a": ".inf", "b": True})])

    def test_what_keeps_it_from_being_read(self):
        self.write_model()
        (self.folder / "arm/urdf/arm.urdf").unlink()
        dump, said = self.dump("arm/smurf/arm.smurf", 1)
        self.assertFalse(dump["model"]["is_complete"])
        self.assertNotIn("links", dump["model"])
        self.assertRegex(said, r"arm\.smurf:3:3: error\[SML2001\]")
        self.dump("arm/smurf/arm.smurf", 0, "--exit-zero")

    def test_rules_are_not_run(self):
        self.write_model(motors=BROKEN_MOTORS)
        self.assertEqual(self.dump("arm/smurf/arm.smurf")[1], "")

    def test_scene_and_archive(self):
        dump, _ = self.dump(cli.FIXTURES / "scenes/nested/outer.smurfs")
        table = dump["scene"]["instances"][1]
        self.assertEqual((table["path"], table["parent"]), ("cell/Table", {"instance": "Base", "link": "flange"}))
        self.write_model()
        with zipfile.ZipFile(self.folder / "arm.zsmurf", "w") as archive:
            for name in ("smurf/arm.smurf", "smurf/arm_motors.yml", "urdf/arm.urdf"):
                archive.write(self.folder / "arm" / name, name)
        self.assertEqual(len(self.dump("arm.zsmurf")[0]["model"]["joints"]), 1)

    def test_nothing_from_outside(self):
        self.write("secret.yml", "motors:\n- {name: secret, joint: secret}\n")
        self.write_model("a/b/c/arm")
        self.write("a/b/c/arm/smurf/arm.smurf", SMURF + "- ../../../../../secret.yml\n")
        (self.folder / "a/b/c/.git").mkdir()
        done = self.run_tool("--dump-model", "smurf/arm.smurf", cwd=self.folder / "a/b/c/arm")
        self.assertNotIn("secret\"", done.stdout)
        self.assertIn("outside of the project", done.stderr)

    def test_size(self):
        self.write_model()
        self.expect_complaint("what is in 'arm/smurf/arm.smurf' has more than 1000 bytes of JSON; raise the limit "
                              "with `--limit scene-bytes=N`", "--dump-model", "arm/smurf/arm.smurf",
                              "--limit", "scene-bytes=1000")

    def test_mistakes(self):
        self.expect_complaint("cannot read 'no.smurf': No such file or directory", "--dump-model", "no.smurf")
        self.write("notes.txt", "")
        self.expect_complaint("'notes.txt' is not a model, scene, URDF or annotation file", "--dump-model", "notes.txt")


class JsonAnnotations(LintTest):
    def test_alone_and_listed(self):
        self.write("arm_motors.json", '{"motors": [{"name": "elbow", "joint": "elbow", "type": "PIDD"}]}')
        self.assertIn(("arm_motors.json", "SML4101"), self.findings("arm_motors.json"))
        self.assertNotIn(("arm_motors.json", "SML1001"), self.findings("arm_motors.json"))


class Terminal(LintTest):
    def test_long_lines_are_cut_on_a_terminal_only(self):
        self.write_model(motors=MOTORS.replace(
            "joint: elbow", "joint: elbwo # " + "long " * 40))
        self.assertIn("long " * 39 + "long\n", self.expect(1, "arm").stdout)
        try:
            primary, secondary = os.openpty()
        except OSError as error:  # a chroot without /dev/pts
            self.skipTest(f"no pseudo terminal: {error}")
        fcntl.ioctl(secondary, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 60, 0, 0))
        process = subprocess.Popen([cli.TOOL, "arm"], stdout=secondary, cwd=self.folder,
                                   env={**os.environ, "TERM": "xterm"})
        os.close(secondary)
        shown = b""
        try:
            while chunk := os.read(primary, 4096):
                shown += chunk
        except OSError:
            pass  # the error on Linux when the other end is closed
        os.close(primary)
        self.assertEqual(process.wait(60), 1)
        line = next(part for part in shown.decode().splitlines() if "joint: elbwo" in part)
        self.assertTrue(line.endswith("..."), line)
        self.assertIn("\x1b[1;31merror[SML3101]", shown.decode())


if __name__ == "__main__":
    cli.main()
