# SPDX-License-Identifier: BSD-3-Clause
"""--cache: what it keeps changes no record. Each test compares with a run without it; where a record comes from, it knows from
marks that it writes into the cache, with the digest that a line needs.
"""
import hashlib
import json
import os
import pathlib
import random
import shutil
import signal
import struct
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "hostile"))
import callgrind  # noqa: E402
import cli  # noqa: E402

SETTLED = 2.1  # s after which a file that changes gets another stamp, for certain
HEADER = b"smurf-lint cache 1\n"
XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


def robot(name, mass="1", inside=""):
    return (f'<robot name="{name}">\n<link name="base"><inertial><mass value="{mass}"/>'
            '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>\n'
            f"{inside}</link>\n</robot>\n")


def mesh(name):
    return f'<visual><geometry><mesh filename="{name}"/></geometry></visual>\n'


def stl(size):
    """Two triangles."""
    corners = [(0, 0, 0), (size, 0, 0), (0, size, 0), (0, 0, 0), (0, size, 0), (size, 0, 0)]
    data = b"\0" * 80 + struct.pack("<I", 2)
    for i in range(2):
        data += struct.pack("<3f", 0, 0, 1 - 2 * i) + b"".join(struct.pack("<3f", *c) for c in corners[3 * i:3 * i + 3]) + b"\0\0"
    return data


class Cache(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.enter_workspace()
        self.options = ["--cache", "../cache"]

    def records(self, *arguments, **how):
        done = self.expect(None, "--format", "jsonl", *arguments, **how)
        return done.stdout

    def check(self, *arguments, **how):
        """The paths of the records that come from the cache; all records must be those of a run without it."""
        cached = self.records(*self.options, *arguments, **how)
        fresh = self.records(*arguments, **how)
        self.assertEqual(cached.replace('"DIGEST"', '"digest"'), fresh)
        return {json.loads(line)["path"] for line in cached.splitlines() if '"DIGEST"' in line}

    def cache_files(self):
        return list((self.folder / "../cache").glob("*.smurf-checks"))

    def mark(self):
        """Marks all records in the cache."""
        for path in self.cache_files():
            lines = path.read_bytes().splitlines(keepends=True)
            self.assertEqual(lines[0], HEADER)
            for i, line in enumerate(lines[1:], 1):
                key, _, text = line.rstrip(b"\n").split(b" ", 2)
                text = text.replace(b'"digest"', b'"DIGEST"')
                lines[i] = b" ".join([key, hashlib.blake2b(key + text, digest_size=32).hexdigest()[:32].encode(), text]) + b"\n"
            path.write_bytes(b"".join(lines))

    def fill(self, *arguments, **how):
        """Checks, and marks the records; `arguments` are then found in the cache."""
        self.assertEqual(self.check(*arguments, **how), set())
        self.mark()

    def test_a_second_run_reads_the_cache(self):
        for i in range(5):
            self.write(f"r{i}/robot.urdf", robot(f"r{i}", mass="-1" if i % 2 else "1"))
        self.write("parts/part.xacro", f'<robot {XACRO}><xacro:macro name="m" params="a"><link name="${{a}}"/></xacro:macro></robot>')
        everything = {f"r{i}/robot.urdf" for i in range(5)}
        for jobs in (1, 3):
            shutil.rmtree(self.folder / "../cache", ignore_errors=True)
            self.fill("-j", jobs, ".")
            self.assertEqual(self.check("-j", jobs, "."), everything)  # the files may change again: their bytes were compared
            time.sleep(SETTLED)
            self.assertEqual(self.check("-j", jobs, "."), everything)
            size = self.cache_files()[0].stat().st_size
            self.assertEqual(self.check("-j", jobs, "."), everything)  # by their stamps
            self.assertEqual(self.cache_files()[0].stat().st_size, size)
        self.assertEqual(self.read("../cache/.gitignore"), "*\n")
        # The exit code is that of all robots, as configured.
        self.expect(1, "--format", "jsonl", *self.options, ".")
        self.expect(0, "--format", "jsonl", *self.options, "--exit-zero", ".")
        self.expect(0, "--format", "jsonl", *self.options, "r0/robot.urdf")
        self.write("r0/.smurf-lint.yaml", "max_warnings: 0\n")
        for _ in range(2):
            code = self.run_tool("--format", "jsonl", "r0").returncode
            self.expect(code, "--format", "jsonl", *self.options, "r0")
        whole = self.records(".")
        self.expect(None, *self.options, "--resume", "../r.jsonl", ".")
        self.assertEqual(self.read("../r.jsonl"), whole)

    def test_each_change_is_seen(self):
        self.write("same/robot.urdf", robot("same"))
        self.write("mesh/robot.urdf", robot("mesh", inside=mesh("part.stl")))
        self.write("mesh/part.stl", stl(1))
        self.write("missing/robot.urdf", robot("missing", inside=mesh("absent.stl")))
        self.write("include/robot.urdf.xacro",
                   f'<robot name="x" {XACRO}><xacro:include filename="../lib/size.xacro"/><link name="${{n}}"/></robot>')
        self.write("lib/size.xacro", f'<robot {XACRO}><xacro:property name="n" value="one"/></robot>')
        self.write("named/robot.urdf", robot("named", inside=mesh("package://things/part.stl")))
        self.write("links/robot.urdf", robot("links", inside=mesh("part.stl")))
        self.write("links/real.stl", stl(1))
        (self.folder / "links/part.stl").symlink_to("real.stl")
        self.write("touched/robot.urdf", robot("touched"))
        self.write("beside/robot.urdf", robot("beside"))
        self.write("config/robot.urdf", robot("config", mass="-1"))
        self.write("config/.smurf-lint.yaml", "ignore: [SML1655]\n")
        self.write("archive/arm.smurf", cli.ARM_SMURF.replace("../urdf/", ""))
        self.write("archive/arm.urdf", cli.ARM_URDF)
        self.write("archive/arm_motors.yml", cli.ARM_MOTORS)
        time.sleep(SETTLED)
        self.fill(".")
        everything = self.check(".")
        self.assertEqual(len(everything), 11)

        def changes(*paths):
            """These robots are checked again, and the others are not."""
            known = self.check(".")
            self.assertEqual(everything - known, set(paths))
            self.mark()
            self.assertEqual(self.check("."), everything)

        self.write("mesh/part.stl", stl(2))
        changes("mesh/robot.urdf")
        self.write("missing/absent.stl", stl(1))
        changes("missing/robot.urdf")
        self.write("lib/size.xacro", self.read("lib/size.xacro").replace("one", "two"))
        changes("include/robot.urdf.xacro")
        # A package elsewhere, which was looked for: others have looked at the folder as well.
        self.write("things/package.xml", cli.package("things"))
        self.write("things/part.stl", stl(1))
        self.assertNotIn("named/robot.urdf", self.check("."))
        self.mark()
        # The same bytes at another place, and one that may not be read.
        self.write("links/other.stl", stl(1))
        (self.folder / "links/part.stl").unlink()
        (self.folder / "links/part.stl").symlink_to("other.stl")
        changes("links/robot.urdf")
        self.write("../../outside.stl", stl(1))
        (self.folder / "links/part.stl").unlink()
        (self.folder / "links/part.stl").symlink_to(self.folder / "../../outside.stl")
        changes("links/robot.urdf")
        # The same size and time.
        path = self.folder / "touched/robot.urdf"
        before = path.stat()
        self.write("touched/robot.urdf", robot("touched", mass="2"))
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
        changes("touched/robot.urdf")
        # Another time, and the same bytes.
        os.utime(path)
        changes()
        # A file that belongs to the robot appears, and goes again.
        self.write("beside/robot.srdf", '<robot name="beside"><group name="g"><link name="absent"/></group></robot>')
        changes("beside/robot.urdf")
        (self.folder / "beside/robot.srdf").unlink()
        changes("beside/robot.urdf")
        # A configuration is read for all: each record says what all targets do.
        self.write("config/.smurf-lint.yaml", "targets: [mujoco]\n")
        self.assertEqual(self.check("."), set())
        self.mark()
        self.write("same/.smurf-lint.yaml", "targets: [drake]\n")
        self.assertEqual(self.check("."), set())

    def test_settings_and_surroundings_are_other_keys(self):
        self.write("robot.urdf", robot("r", mass="-1", inside=mesh("package://things/part.stl")))
        self.write("x.urdf.xacro", f'<robot name="x" {XACRO}><xacro:arg name="n" default="a"/><link name="$(arg n)$(optenv SIZE b)"/></robot>')
        self.write("../ros/things/package.xml", cli.package("things"))
        self.write("../ros/things/part.stl", stl(1))
        self.expect(0, "--baseline", "../known.yaml", "--generate-baseline", "robot.urdf")
        files = ["robot.urdf", "x.urdf.xacro"]
        self.fill(*files)
        self.assertEqual(self.check(*files), set(files))
        for options in (["--target", "mujoco"], ["--select", "SML1"], ["--ignore", "SML13"], ["--severity", "SML13=info"],
                        ["--min-severity", "error"], ["--isolated"], ["--no-ignores"], ["--baseline", "../known.yaml"], ["--allow-outside"],
                        ["--limit", "xml-depth=50"], ["--package", "things=../ros/things"], ["n:=c"], ["--max-seconds", "50"],
                        ["--xacro-env", "SIZE"]):
            self.assertEqual(self.check(*options, *files), set(), options)
            self.mark()
            self.assertEqual(self.check(*options, *files), set(files), options)
        self.expect(0, "--baseline", "../known.yaml", "--generate-baseline", "x.urdf.xacro")
        self.assertEqual(self.check("--baseline", "../known.yaml", *files), set())
        for name, value, options in (("ROS_PACKAGE_PATH", self.folder / "../ros", []), ("AMENT_PREFIX_PATH", self.folder, []),
                                     ("SIZE", "d", ["--xacro-env", "SIZE"]), ("SIZE", "e", ["--xacro-env", "SIZE"])):
            how = {"environment": {name: str(value)}}
            self.assertEqual(self.check(*options, *files, **how), set(), name)
            self.mark()
            self.assertEqual(self.check(*options, *files, **how), set(files), name)
        self.assertEqual(self.check(*files, environment={"SIZE": "d"}), set(files))  # it may not be read
        # Another folder, with the same names in it.
        self.options = ["--cache", self.folder / "../cache"]
        (self.folder / "deep").mkdir()
        for name in files:
            shutil.copy(self.folder / name, self.folder / "deep")
        self.assertEqual(self.check(*files, cwd=self.folder / "deep"), set())
        # Another project: less may be read.
        (self.folder / "deep/.git").mkdir()
        self.mark()
        self.assertEqual(self.check("deep"), set())

    def test_what_took_too_long_is_not_kept(self):
        work = "len([0 for j in range(9000) if [0 for i in range(90000) if 0]])"
        self.write("slow/robot.urdf.xacro", f'<robot name="r" {XACRO}><link name="${{{work}}}"/></robot>')
        self.write("fast/robot.urdf", robot("r"))
        options = ["--limit", "xacro-steps=9000000000", "--max-seconds", "1", "."]
        self.fill(*options)
        self.assertEqual(self.check(*options), {"fast/robot.urdf"})

    def test_standard_input_is_not_kept(self):
        for mass in "12":
            self.assertIn(f'"mass":{mass}', self.records(*self.options, "--stdin-filename", "r.urdf", "-", stdin=robot("r", mass)))

    def test_damage_and_strangers(self):
        for i in range(6):
            self.write(f"r{i}/robot.urdf", robot(f"r{i}", mass=str(i)))
        self.write("r0/odd\tna\x01me\n.stl", stl(1))
        self.write("r1/robot.urdf", robot("r1", inside=mesh("odd&#9;na&#10;me.stl")))
        self.check(".")
        place = self.cache_files()[0]
        good = place.read_bytes()
        chance = random.Random(1)
        for number in range(60):
            damaged = bytearray(good)
            for _ in range(chance.choice([1, 5, 50])):
                damaged[chance.randrange(len(HEADER), len(damaged))] = chance.randrange(256)
            if number % 3 == 0:
                damaged = damaged[:chance.randrange(len(damaged))]
            place.write_bytes(damaged)
            self.check(".")
        # What is true of one robot is not of another: keys are exchanged, with the right digests.
        lines = good.splitlines(keepends=True)[1:]
        texts = [line.split(b" ", 2) for line in lines]
        for (key, _, _), (_, _, text) in zip(texts, texts[1:] + texts[:1]):
            text = text.rstrip(b"\n").replace(b'"digest"', b'"DIGEST"')
            lines.append(key + b" " + hashlib.blake2b(key + text, digest_size=32).hexdigest()[:32].encode() + b" " + text + b"\n")
        # Answers and questions that nobody has written.
        for text in (b"", b"\t", b"{}\x01n\t", b"[]\t", b'{"errors":"x"}\x01n\t', b"a\tb\tc\td\te\t", b"a\tb\tc\td\tc=\t", b"\x01", b"{}\x01\t\x01"):
            lines.append(key + b" " + hashlib.blake2b(key + text, digest_size=32).hexdigest()[:32].encode() + b" " + text + b"\n")
            place.write_bytes(HEADER + b"".join(lines[-1:]))
            self.check(".")
        # Another program's file, as far as its name says.
        place.write_bytes(good)
        self.mark()
        place.rename(place.with_name("0123456789abcdef.smurf-checks"))
        self.assertEqual(self.check("."), set())

    def test_what_is_no_cache_is_left_alone(self):
        self.write("robot.urdf", robot("r"))
        self.check(".")
        place = self.cache_files()[0]

        def complains(text, *options):
            done = self.run_tool("--format", "jsonl", *(options or self.options), ".")
            self.assertEqual(done.returncode, 0)
            self.assertEqual(done.stdout, self.records("."))
            self.assertIn(text, done.stderr)
            self.assertIn("--cache", done.stderr)

        for other in (b"<robot/>\n", b"smurf-lint cache 2\n", b"\n", b"\0" * 100):
            place.write_bytes(other)
            complains("is no file of a cache; delete it")
            self.assertEqual(place.read_bytes(), other)
        place.unlink()
        text = self.read("robot.urdf")
        place.symlink_to(self.folder / "robot.urdf")
        complains("cannot write")
        self.assertEqual(self.read("robot.urdf"), text)
        place.unlink()
        place.mkdir()
        complains("is no file of a cache")
        place.rmdir()
        os.mkfifo(place)
        complains("is no file of a cache")
        complains("cannot write", "--cache", "robot.urdf")
        complains("cannot write", "--cache", "robot.urdf/x")
        self.assertEqual(self.read("robot.urdf"), text)
        for other in ([], ["--format", "json"], ["--format", "sarif=x.sarif"]):
            self.expect_complaint("--cache keeps only the records of --format jsonl: write --format jsonl or --resume FILE, or leave --cache out",
                                  *self.options, *other, ".")

    def test_a_cache_that_cannot_be_written_is_read(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everything")
        self.write("one/robot.urdf", robot("r"))
        self.fill(".")
        self.cache_files()[0].chmod(0o400)
        self.write("other/robot.urdf", robot("o"))
        done = self.run_tool("--format", "jsonl", *self.options, ".")
        self.assertIn('"DIGEST"', done.stdout)
        self.assertIn("cannot write", done.stderr)

    def test_it_may_lie_between_the_robots_or_be_a_link(self):
        for i in range(3):
            self.write(f"robots/r{i}/robot.urdf", robot(f"r{i}"))
        for options in (["--cache", "robots"], ["--cache", "robots/r0"], ["--cache", "robots/a/b"]):
            self.options = options
            self.check("robots")
            self.check("robots")
            for path in (self.folder / "robots").rglob("*.smurf-checks"):
                path.unlink()
        self.assertFalse((self.folder / "robots/.gitignore").exists())  # the folder was there before
        (self.folder / "real").mkdir()
        (self.folder / "link").symlink_to("real")
        self.options = ["--cache", "link"]
        self.check("robots")
        self.assertEqual(len(list((self.folder / "real").glob("*.smurf-checks"))), 1)

    def test_processes_at_once_and_kills(self):
        for i in range(60):
            self.write(f"r{i:02}/robot.urdf", robot(f"r{i}", mass=str(i)))
        fresh = self.records(".")
        command = [cli.TOOL, "--format", "jsonl", "-j", "2", *map(str, self.options), "."]
        chance = random.Random(2)
        for _ in range(12):
            running = [subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, text=True) for _ in range(3)]
            time.sleep(chance.uniform(0, 0.05))
            running[0].send_signal(signal.SIGKILL)
            if chance.random() < 0.3:
                self.write(f"r{chance.randrange(60):02}/robot.urdf", robot("new", mass=str(chance.random())))
                fresh = None
            for process in running:
                out = process.communicate()[0]
                if process is not running[0] and fresh:
                    self.assertEqual(out, fresh)
            fresh = self.records(".")
            self.assertEqual(self.records(*self.options, "."), fresh)
        self.mark()
        self.assertEqual(len(self.check(".")), 60)

    def test_what_is_superseded_does_not_stay(self):
        self.write("r/robot.urdf", robot("r"))
        self.write("s/robot.urdf", robot("s"))
        self.check(".")
        place = self.cache_files()[0]
        lines = place.read_bytes()
        place.write_bytes(lines + lines.splitlines(keepends=True)[1] * 10000)
        self.assertGreater(place.stat().st_size, 5 << 20)
        self.mark()
        self.assertEqual(len(self.check(".")), 2)
        self.assertLess(place.stat().st_size, 10000)
        self.assertEqual(len(self.check(".")), 2)
        self.assertEqual([path.name for path in place.parent.iterdir() if path.suffix == ".new"], [])

    def test_a_second_run_costs_a_fifth(self):
        if shutil.which("valgrind") is None:
            self.skipTest("no valgrind; scripts/setup --dev installs it")
        links = "".join(f'<link name="l{i}"/>\n<joint name="j{i}" type="fixed"><parent link="base"/><child link="l{i}"/></joint>\n'
                        for i in range(250))
        for i in range(20):
            self.write(f"r{i}/robot.urdf", robot(f"r{i}").replace("</robot>", links + "</robot>"))
        time.sleep(SETTLED)
        first, second = (callgrind.instructions(pathlib.Path(cli.TOOL), "--format", "jsonl", "-o", "/dev/null", *self.options, ".", cwd=self.folder)
                         for _ in range(2))
        self.assertLess(second, first / 5)


if __name__ == "__main__":
    cli.main()
