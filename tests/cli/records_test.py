# SPDX-License-Identifier: BSD-3-Clause
"""--format jsonl and --resume: a line for each robot, which says what a check of that robot alone says."""
import hashlib
import json
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

LINK = '<link name="l{i}"><inertial><mass value="{mass}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>\n'


def robot(number, links):
    chance = random.Random(number)
    parts = [LINK.format(i=i, mass=chance.choice(["0.5", "2", "-1", "x"])) for i in range(links)]
    joints = [f'<joint name="j{i}" type="fixed"><parent link="l{i - 1}"/><child link="l{i}"/></joint>\n' for i in range(1, links)]
    return f'<robot name="r{number}">\n' + "".join(parts + joints) + "</robot>\n"


class Records(cli.CliTest):
    def write_robots(self, count, links=3):
        for number in range(count):
            self.write(f"robots/{number:05}/robot.urdf", robot(number, links))

    def records(self, *options):
        done = self.expect(None, "--isolated", "--format", "jsonl", *options)
        self.assertTrue(done.stdout.endswith("\n"), done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_a_record_is_the_report_of_the_robot(self):
        self.write_robots(20)
        self.write("robots/part.xacro",
                   '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro></robot>')
        records = self.records("--target", "mujoco,drake", "robots")
        self.assertEqual([one["path"] for one in records], sorted(str(p) for p in self.relative("robots", "*.urdf")))
        self.assertEqual({one["ok"] for one in records}, {True, False})
        for one in records:
            alone = json.loads(self.expect(None, "--isolated", "--target", "mujoco,drake", "--format", "json", one["path"]).stdout)
            self.assertEqual(one["findings"], alone["diagnostics"])
            self.assertEqual(one["loads"], {name: target["verdict"] for name, target in alone["targets"].items()})
            self.assertEqual(one["counts"]["errors"], alone["summary"]["error"])
            self.assertEqual(one["ok"], alone["summary"]["error"] == 0)
            self.assertEqual(one["links"], 3)
            self.assertEqual(one["digest"], hashlib.blake2b((self.folder / one["path"]).read_bytes(), digest_size=32).hexdigest())
        for jobs in (1, 3):
            self.assertEqual(self.records("--target", "mujoco,drake", "-j", jobs, "robots"), records)

    def relative(self, folder, pattern):
        return [path.relative_to(self.folder) for path in (self.folder / folder).rglob(pattern)]

    def test_mass_is_the_sum_and_a_scene_has_none(self):
        self.write("a.urdf", '<robot name="a">' + LINK.format(i=0, mass="0.5") + LINK.format(i=1, mass="2") +
                   '<joint name="j" type="fixed"><parent link="l0"/><child link="l1"/></joint></robot>')
        self.write("s.smurfs", 'smurfs: "1.0"\nentities:\n  - {name: a, type: urdf, file: a.urdf, position: [0, 0, 0]}\n')
        by_path = {one["path"]: one for one in self.records("a.urdf", "s.smurfs")}
        self.assertEqual(by_path["a.urdf"]["mass"], 2.5)
        self.assertNotIn("mass", by_path["s.smurfs"])

    def test_exit_code_is_that_of_all(self):
        self.write("a.urdf", robot(1, 1).replace('"x"', '"1"').replace('"-1"', '"1"'))
        self.expect(0, "--isolated", "--format", "jsonl", "a.urdf")
        self.write("b.urdf", "<robot/>")
        self.expect(1, "--isolated", "--format", "jsonl", "a.urdf", "b.urdf")
        self.expect(0, "--isolated", "--format", "jsonl", "--exit-zero", "a.urdf", "b.urdf")
        self.expect(2, "--isolated", "--format", "jsonl", "a.urdf", "absent.urdf")

    def test_a_stopped_run_goes_on(self):
        self.write_robots(200, 30)
        whole = self.folder / "whole.jsonl"
        self.expect(1, "--isolated", "--format", f"jsonl={whole}", "robots")
        part = self.folder / "part.jsonl"
        command = [cli.TOOL, "--isolated", "-j", "2", "--resume", str(part), "robots"]
        stops = 0
        while stops < 3:
            running = subprocess.Popen(command, cwd=self.folder)
            size = part.stat().st_size if part.exists() else 0
            while running.poll() is None and (not part.exists() or part.stat().st_size < size + 5000):
                time.sleep(0.001)
            running.send_signal(signal.SIGKILL)
            running.wait()
            stops += 1
        self.assertTrue(part.read_bytes())
        with part.open("ab") as file:
            file.write(b'{"path":"robots/0')  # as a stop within a line leaves it
        self.expect(None, "--isolated", "--resume", part, "robots")
        self.assertEqual(part.read_bytes(), whole.read_bytes())
        self.expect(1, "--isolated", "--resume", part, "robots")  # nothing is left to check; the exit code is that of all
        self.assertEqual(part.read_bytes(), whole.read_bytes())

    def test_other_files_are_not_overwritten(self):
        self.write_robots(2)
        text = (self.folder / "robots/00000/robot.urdf").read_text()
        for option in ("--resume", "--format=jsonl"):
            place = "robots/00000/robot.urdf"
            done = self.expect(2, "--isolated", *(("--resume", place) if option == "--resume" else (f"{option}={place}",)), "robots")
            self.assertIn("another file", done.stderr)
            self.assertEqual((self.folder / place).read_text(), text)
        self.expect(1, "--isolated", "--resume", "r.jsonl", "robots")
        self.write("robots/00002/robot.urdf", text)
        done = self.expect(2, "--isolated", "--target", "drake", "--resume", "r.jsonl", "robots")
        self.assertIn("was written without a target", done.stderr)
        self.assertIn("cannot", self.expect(2, "--isolated", "--resume", "absent/r.jsonl", "robots").stderr)

    def test_a_text_that_is_no_record_is_kept(self):
        self.write_robots(1)
        record = '{"path":"x","loads":{},"counts":{"errors":%s},"findings":[]}\n'
        texts = ["<robot/>", "one line without its end", '{"paths":["x"]', "no record\n", record % '"x"', record % "-1", record % "[]",
                 record % "1" + "a line of somebody"]
        for text in texts:
            self.write("r.jsonl", text)
            done = self.expect(2, "--isolated", "--resume", "r.jsonl", "robots")
            self.assertIn("is no record of --format jsonl", done.stderr)
            self.assertEqual(self.read("r.jsonl"), text)
        for text in ("", '{"pa', record % "0", record % "0" + '{"path":"rob'):
            self.write("r.jsonl", text)
            self.expect(None, "--isolated", "--resume", "r.jsonl", "robots")
            self.assertTrue(self.read("r.jsonl").startswith(text[:text.rfind("\n") + 1]))

    def test_options_that_it_excludes(self):
        for options in (["--fix"], ["--format", "json=x.json"], ["--watch"], ["--generate-baseline"]):
            self.expect(2, "--format", "jsonl", *options, ".")
        self.expect(2, "--resume", "r.jsonl", "--format", "json", ".")

    def test_memory_does_not_grow_with_the_robots(self):
        def peak(count):
            self.write_robots(count, 40)
            subprocess.run(["/bin/sh", "-c", '"$@" > /dev/null || true', "sh", cli.TOOL, "--isolated", "-j", "2", "--format", "jsonl", "robots"],
                           cwd=self.folder, check=True)
            return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss  # KiB, the highest so far

        few, many = peak(100), peak(1000)
        self.assertLess(many - few, 900 * 2)  # the list of files; their texts and findings would be 40 KiB each

    def test_the_list_of_a_data_set_is_small(self):
        self.write("robot.urdf", '<robot name="r"><link name="l"/></robot>\n')

        def peak(folder, count):
            for number in range(count):
                place = self.folder / folder / f"{number:06}"
                place.mkdir(parents=True)
                os.link(self.folder / "robot.urdf", place / "robot.urdf")
            with (self.folder / "records.jsonl").open("w") as records:
                subprocess.run([cli.TOOL, "--isolated", "-j", "2", "--format", "jsonl", folder], cwd=self.folder, stdout=records, check=True)
            with (self.folder / "records.jsonl").open() as records:
                self.assertEqual(sum(1 for _ in records), count)
            return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss  # KiB, the highest so far

        # What is remembered about the last thousands of folders does not grow between the two.
        few, many = peak("few", 9_000), peak("many", 18_000)
        self.assertLess((many - few) * 1024 / 9_000, 600)  # bytes for each robot

    def test_without_a_robot_there_are_no_records(self):
        self.write("parameters/controllers.yaml", "controller_manager:\n  ros__parameters:\n    update_rate: 100\n")
        self.expect(0, "--isolated", "parameters")  # it is a companion, which other reports are about
        for options in (["--format", "jsonl=r.jsonl"], ["--resume", "r.jsonl"], ["--format", "jsonl=r.jsonl", "--cache", "cache"]):
            done = self.expect(2, "--isolated", *options, "parameters")
            self.assertIn("no robot or scene in 'parameters'", done.stderr)
            self.assertIn("leave out --format jsonl", done.stderr)
            self.assertFalse((self.folder / "r.jsonl").exists())
        self.write("parts/part.xacro",
                   '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro></robot>')
        done = self.expect(2, "--isolated", "--format", "jsonl", "parts", "parameters")
        self.assertEqual(done.stdout, "")
        self.assertIn("no robot or scene in the named files and folders", done.stderr)
        self.write("robots/robot.urdf", '<robot name="r"><link name="l"/></robot>')
        self.expect(0, "--isolated", "--format", "jsonl", "robots", "parts", "parameters")
        self.expect(0, "--isolated", "--resume", "r.jsonl", "robots", "parameters")
        self.expect(0, "--isolated", "--resume", "r.jsonl", "robots", "parameters")  # nothing is left to check


if __name__ == "__main__":
    cli.main()
