# SPDX-License-Identifier: BSD-3-Clause
"""Failures while a tool writes: afterwards, all files are old or all are new, and a line gives the
reason.

Usage: robust_writing_test.py FOLDER_OF_TOOLS [unittest option]...
"""
import functools
import os
import pathlib
import resource
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest

FIXTURES = pathlib.Path(__file__).resolve().parent.parent.parent / "build/fixtures"
TOOLS = None
NOBODY = 65534
PADDING = "<!-- " + 40000 * "x" + " -->"
FIXABLE = f"""<robot name="r">
  {PADDING}
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="Fixed">
    <parent link="a"/><child link="b"/>
  </joint>
</robot>
"""
BASELINE = "# Findings that smurf-lint suppresses: file, rule, place. Written by\n{}\n"
# The command of each tool that writes into the folder `target`, and the files that exist before.
JOBS = {
    "smurf2urdf": (["in/smurf/arm.smurf", "-o", "target/arm.urdf"], {"arm.urdf": "old"}),
    "smurf2urdf with an SRDF": (
        ["in/smurf/arm.smurf", "-o", "target/arm.urdf", "--srdf", "target/arm.srdf"],
        {"arm.urdf": "old", "arm.srdf": "old"}),
    "smurf2urdf with a report": (
        ["in/smurf/arm.smurf", "--loss-report", "target/lost.json", "-o", "copy.urdf"],
        {"lost.json": "old"}),
    "urdf2smurf": (["in/urdf/arm.urdf", "-o", "target", "--overwrite"],
                   {"smurf/arm.smurf": "old", "smurf/arm_joint.yml": "old", "urdf/arm.urdf": "old"}),
    "smurfs-flatten": (["scene/example.smurfs", "--format", "urdf", "-o", "target/scene.urdf"],
                       {"scene.urdf": "old"}),
    "smurfs-flatten as glTF": (["scene/example.smurfs", "--format", "gltf", "-o", "target/scene.gltf"],
                               {"scene.gltf": "old"}),
    "smurf-lint": (["--fix", "target/fixable.urdf"], {"fixable.urdf": FIXABLE}),
    "smurf-lint with a baseline": (
        ["--baseline", "target/known.yaml", "--generate-baseline", "--quiet", "faulty.urdf"],
        {"known.yaml": BASELINE}),
    "smurf-lint with a report": (["-o", "target/report.json", "--format", "json", "--exit-zero", "faulty.urdf"],
                                 {"report.json": "old"}),
    "smurf-load-check": (["--time", "0.05", "--trace", "target/poses.csv", "in/smurf/arm.smurf"],
                         {"poses.csv": "old"}),
}


def can_mount():
    done = subprocess.run(["unshare", "-rm", "mount", "-t", "tmpfs", "none", "/mnt"],
                          capture_output=True, check=False) if shutil.which("unshare") else None
    return done is not None and done.returncode == 0


def temporary_name(process, number=0):
    """Of a file that a process writes; containers and machines have numbers of their own."""
    space = os.readlink("/proc/self/ns/pid").strip("pid:[]")
    boot = pathlib.Path("/proc/sys/kernel/random/boot_id").read_text(encoding="utf-8")[:8]
    return f".smurf-{process}-{space}x{boot}-{number}.tmp"


def can_be_nameless(folder):
    """Some file systems do not support files without a name."""
    try:
        os.close(os.open(folder, os.O_TMPFILE | os.O_WRONLY, 0o600))
    except OSError:
        return False
    return True


def for_each_job(test):
    """Calls test(self, job, files) with the files in `target`, as one subtest each."""
    @functools.wraps(test)
    def run(self):
        for job, (_, files) in JOBS.items():
            with self.subTest(job):
                self.prepare(files)
                test(self, job, files)
    return run


class WritingTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-write-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.folder.chmod(0o755)
        shutil.copytree(FIXTURES / "models/arm", self.folder / "in")
        shutil.copytree(FIXTURES / "scenes/example", self.folder / "scene")
        (self.folder / "faulty.urdf").write_text(
            '<robot name="r">' + "".join(f'<link nam="l{i}"/>' for i in range(200)) + "</robot>")
        self.target = self.folder / "target"

    def prepare(self, files):
        shutil.rmtree(self.target, ignore_errors=True)
        for path, text in files.items():
            (self.target / path).parent.mkdir(parents=True, exist_ok=True)
            (self.target / path).write_text(text)

    def command(self, job):
        return [str(TOOLS / job.split()[0]), *JOBS[job][0]]

    def run_job(self, job, *wrapper, **keywords):
        return subprocess.run([*wrapper, *self.command(job)], cwd=self.folder, timeout=600,
                              encoding="utf-8", capture_output=True, check=False, **keywords)

    @staticmethod
    def texts(folder):
        return {str(path.relative_to(folder)): path.read_text()
                for path in folder.rglob("*") if path.is_file()}

    def assert_refused(self, done, reason):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, f"cannot write '[^']+': {reason}")
        self.assertNotIn("Traceback", done.stderr)

    @unittest.skipUnless(can_mount(), "no file system can be mounted here")
    @for_each_job
    def test_full_disk(self, job, files):
        script = ("mount -t tmpfs -o size=64k none target && cp -r old/. target && "
                  "head -c $((60 * 1024 - $(du -sk target | cut -f1) * 1024)) /dev/zero "
                  "> target/filler; rm -rf after; \"$@\"; code=$?; rm target/filler; "
                  "cp -r target after; exit $code")
        shutil.rmtree(self.folder / "old", ignore_errors=True)
        shutil.move(self.target, self.folder / "old")
        self.target.mkdir()
        done = self.run_job(job, "unshare", "-rm", "sh", "-c", script, "sh")
        self.assert_refused(done, "No space left on device")
        self.assertEqual(self.texts(self.folder / "after"), files)

    @for_each_job
    def test_file_too_large(self, job, files):
        for size in (0, 1, 600):
            done = self.run_job(job, preexec_fn=lambda size=size: resource.setrlimit(
                resource.RLIMIT_FSIZE, (size, size)))
            self.assert_refused(done, "File too large")
            self.assertEqual(self.texts(self.target), files)

    @for_each_job
    def test_read_only_folder(self, job, files):
        user = {"user": NOBODY} if os.geteuid() == 0 else {}
        folders = [self.target, *[p for p in self.target.rglob("*") if p.is_dir()]]
        for folder in folders:
            folder.chmod(0o555)
        done = self.run_job(job, **user)
        for folder in folders:
            folder.chmod(0o755)
        self.assert_refused(done, "Permission denied")
        self.assertEqual(self.texts(self.target), files)

    @unittest.skipUnless(shutil.which("strace"), "strace is not installed")
    @unittest.skipUnless(can_be_nameless(tempfile.gettempdir()), "every file has a name here")
    @for_each_job
    def test_killed_in_the_middle_of_a_write(self, job, files):
        """kill -9 prevents cleaning up, so there must be nothing to clean up."""
        done = self.run_job(job, "strace", "-f", "-qq", "-e", "trace=fsync", "-e", "inject=fsync:signal=KILL")
        self.assertEqual(done.returncode, -signal.SIGKILL, done.stderr)
        self.assertEqual(self.texts(self.target), files)
        self.assertEqual(self.run_job(job).returncode, 0)

    @unittest.skipUnless(shutil.which("strace"), "strace is not installed")
    def test_interrupted_at_any_step(self):
        """Ctrl-C and SIGTERM wait until the set is complete, or all steps are undone: no file is left over or alone."""
        fault = '<robot name="r{}"><link name="a"/><link name="b"/><joint name="j" type="Fixed"><parent link="a"/><child link="b"/></joint></robot>'
        files = {f"r{i}.urdf": fault.format(i) for i in range(12)}
        for call in ("fsync", "linkat", "renameat", "unlinkat"):
            for step in (1, 7, 12):
                with self.subTest(call, step=step):
                    self.prepare(files)
                    done = subprocess.run(["strace", "-f", "-qq", "-e", f"trace={call}", "-e", f"inject={call}:signal=TERM:when={step}",
                                           TOOLS / "smurf-lint", "-q", "--fix", "--unsafe-fixes", "."], cwd=self.target,
                                          capture_output=True, timeout=600, check=False)
                    self.assertIn(done.returncode, (-signal.SIGTERM, 0), done.stderr)
                    left = self.texts(self.target)
                    self.assertEqual(sorted(left), sorted(files))
                    self.assertIn(sum("Fixed" in text for text in left.values()), (0, 12))

    @for_each_job
    def test_killed_at_any_time(self, job, files):
        self.assertEqual(self.run_job(job).returncode, 0)
        new = self.texts(self.target)
        for step in range(8):
            self.prepare(files)
            with subprocess.Popen(self.command(job), cwd=self.folder,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
                try:
                    run.wait(timeout=0.002 + 0.003 * step)
                except subprocess.TimeoutExpired:
                    run.kill()
            for path, text in self.texts(self.target).items():
                if not pathlib.Path(path).name.startswith(".smurf-"):
                    self.assertIn(text, (files.get(path), new.get(path)), path)

    @for_each_job
    def test_existing_files_keep_their_mode_and_links_stay_links(self, job, files):
        real = self.folder / "real"
        if job == "urdf2smurf":  # writes files with names that others chose, so links are not followed
            return
        first, *others = files
        shutil.rmtree(real, ignore_errors=True)
        real.mkdir()
        shutil.move(self.target / first, real / "file")
        (self.target / first).symlink_to(real / "file")
        (real / "file").chmod(0o640)
        for other in others:
            (self.target / other).chmod(0o600)
        self.assertEqual(self.run_job(job).returncode, 0)
        self.assertTrue((self.target / first).is_symlink())
        self.assertNotEqual((real / "file").read_text(), files[first])
        self.assertEqual(stat.S_IMODE((real / "file").stat().st_mode), 0o640)
        for other in others:
            self.assertEqual(stat.S_IMODE((self.target / other).stat().st_mode), 0o600)
            self.assertNotEqual((self.target / other).read_text(), files[other])

    @for_each_job
    def test_left_overs_of_another_run_are_no_hindrance(self, job, files):
        """A killed process may have had any number, including that of this process."""
        for folder in {(self.target / path).parent for path in files}:
            for number in range(2):
                (folder / temporary_name("$$", number)).write_text("left over")
        rename = ("for f in $(find target -name '.smurf-*'); do mv \"$f\" "
                  "\"$(echo \"$f\" | sed \"s/[$][$]/$$/\")\"; done; exec \"$@\"")
        done = self.run_job(job, "sh", "-c", rename, "sh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual(self.texts(self.target)[next(iter(files))],
                            next(iter(files.values())))

    @for_each_job
    def test_left_overs_of_a_killed_run_are_removed(self, job, files):
        with subprocess.Popen(["true"]) as ended:
            ended.wait()
        kept = {temporary_name(os.getpid()), ".smurf-notes.tmp", f".smurf-{ended.pid}-other-0.tmp"}
        for folder in {(self.target / path).parent for path in files}:
            for name in {temporary_name(ended.pid), *kept}:
                (folder / name).write_text("left over")
        self.assertEqual(self.run_job(job).returncode, 0)
        self.assertEqual({path.name for path in self.target.rglob(".smurf-*")}, kept)

    @for_each_job
    def test_refused_result(self, job, files):
        """A mesh is missing in the source and in the result, which is refused only because of an option."""
        if job.split()[0] not in ("smurf2urdf", "urdf2smurf"):
            return
        (self.folder / "in/meshes/forearm.obj").unlink(missing_ok=True)
        done = subprocess.run([*self.command(job), "--fail-on", "error"], cwd=self.folder, timeout=600,
                              encoding="utf-8", capture_output=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("1 error: see smurf-lint", done.stderr)
        self.assertIn("nothing was written", done.stderr)
        self.assertEqual(self.texts(self.target), files)

    @unittest.skipUnless(shutil.which("strace"), "strace is not installed")
    def test_an_edit_meanwhile_is_kept(self):
        """An editor saves the file while --fix runs: in place, or as a new file."""
        other = FIXABLE.replace('name="r"', 'name="saved"')
        for names, saves_in_place in ((["a.urdf"], True), (["a.urdf", "b.urdf"], False)):
            with self.subTest(names):
                self.prepare({name: FIXABLE for name in names})
                with subprocess.Popen(["strace", "-f", "-qq", "-e", "trace=fsync", "-e",
                                       "inject=fsync:delay_enter=1500000", TOOLS / "smurf-lint", "--fix", *names],
                                      cwd=self.target, stderr=subprocess.PIPE, stdout=subprocess.PIPE,
                                      encoding="utf-8") as run:
                    time.sleep(0.7)
                    if saves_in_place:
                        (self.target / "a.urdf").write_text(other)
                    else:
                        (self.target / "new").write_text(other)
                        (self.target / "new").rename(self.target / "a.urdf")
                    _, errors = run.communicate()
                self.assertEqual(run.returncode, 2, errors)
                self.assertRegex(errors, "cannot write '.*a.urdf': another program has changed it meanwhile")
                self.assertEqual((self.target / "a.urdf").read_text(), other)
                for name in names[1:]:
                    self.assertEqual((self.target / name).read_text(), FIXABLE)
                self.assertEqual(sorted(path.name for path in self.target.iterdir()), names)

    def test_every_way_to_name_a_place(self):
        """Each tool writes the same wherever it is run, and however the place is named."""
        work = self.folder / "work"
        (work / "inner").mkdir(parents=True)
        (work / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>\n')
        (work / "broken.urdf").write_text(FIXABLE)
        (work / "arm.smurf").write_text("modelname: r\nfiles: [r.urdf]\n")
        (work / "s.smurfs").write_text("entities:\n- {name: e, type: urdf, file: r.urdf, anchor: world}\n")
        commands = {
            "urdf2smurf --in-place {}r.urdf": ["r.smurf"],
            "urdf2smurf {}r.urdf -o {}.": ["smurf/r.smurf", "urdf/r.urdf"],
            "urdf2smurf --flat {}r.urdf -o {}flat": ["flat/r.smurf", "flat/r.urdf"],
            "smurf2urdf {}arm.smurf -o {}out.urdf --srdf {}out.srdf": ["out.urdf", "out.srdf"],
            "smurfs-flatten {}s.smurfs -o {}out.json": ["out.json"],
            "smurfs-flatten {}s.smurfs -o {}out.sdf --copy-assets {}assets": ["out.sdf"],
            "smurf-lint --fix {}broken.urdf": ["broken.urdf"],
            "smurf-lint --exit-zero -o {}report.json --format json {}r.urdf": ["report.json"],
            "smurf-lint --baseline {}known.yaml --generate-baseline {}r.urdf": ["known.yaml"],
            "smurf-diff -o {}diff.json --format json {}r.urdf {}broken.urdf": ["diff.json"],
        }
        ways = [(".", ""), (".", "./"), ("inner", "../"), ("..", "copy/"), (".", f"{work}/"), ("/", f"{work}/"),
                (".", "inner/../")]
        for command, outputs in commands.items():
            program, *arguments = command.split()
            for cwd, way in ways:
                with self.subTest(command=command, cwd=cwd, way=way):
                    copy = self.folder / "copy"
                    shutil.rmtree(copy, ignore_errors=True)
                    shutil.copytree(work, copy)
                    words = [word.format(way.replace(str(work), str(copy))) for word in arguments]
                    done = subprocess.run([TOOLS / program, *words], cwd=copy / cwd, capture_output=True, encoding="utf-8",
                                          check=False)
                    self.assertIn(done.returncode, (0, 1) if program == "smurf-diff" else (0,), done.stderr)
                    for name in outputs:
                        self.assertTrue((copy / name).is_file(), f"{name}: {done.stderr}")
                    self.assertEqual([path.name for path in copy.rglob(".smurf-*")], [])

    def test_runs_at_once(self):
        """All end well; the folder has the files of one of them."""
        command = [TOOLS / "urdf2smurf", self.folder / "in/urdf/arm.urdf", "-o", "out", "--overwrite"]
        for _ in range(5):
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            runs = [subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, encoding="utf-8")
                    for _ in range(20)]
            errors = [run.communicate()[1] for run in runs]
            self.assertEqual([text for run, text in zip(runs, errors) if run.returncode != 0], [])

    def test_closed_pipe(self):
        commands = {"smurf2urdf": ["in/smurf/arm.smurf"],
                    "urdf2smurf": ["in/urdf/arm.urdf", "-o", "target", "--dry-run"],
                    "smurfs-flatten": ["scene/example.smurfs"],
                    "smurf-load-check": ["--time", "0.01", "in/smurf/arm.smurf"],
                    "smurf-lint": ["--list-rules"]}
        for tool, arguments in commands.items():
            with self.subTest(tool):
                reading, writing = os.pipe()
                os.close(reading)
                done = subprocess.run([TOOLS / tool, *arguments], cwd=self.folder, timeout=600,
                                      stdout=writing, stderr=subprocess.PIPE, encoding="utf-8",
                                      check=False)
                os.close(writing)
                self.assertEqual(done.returncode, 2)
                self.assertNotIn("cannot write", done.stderr)  # the reader has stopped reading

    def test_full_device(self):
        for tool, arguments in {"smurf2urdf": ["in/smurf/arm.smurf"],
                                "smurfs-flatten": ["scene/example.smurfs"],
                                "smurf-load-check": ["--time", "0.01", "in/smurf/arm.smurf"],
                                "smurf-lint": ["in/smurf/arm.smurf"]}.items():
            for output in ([], ["-o", "/dev/full"]):
                with self.subTest(tool, output=output), open("/dev/full", "w") as full:
                    done = subprocess.run([TOOLS / tool, *arguments, *output], cwd=self.folder,
                                          timeout=600, stdout=full, stderr=subprocess.PIPE,
                                          encoding="utf-8", check=False)
                    self.assertEqual(done.returncode, 2)
                    self.assertIn("No space left on device", done.stderr)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} FOLDER_OF_TOOLS [unittest option]...")
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
