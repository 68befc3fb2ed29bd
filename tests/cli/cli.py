# SPDX-License-Identifier: BSD-3-Clause
"""Runs a tool as its users do: in a separate folder, with given files, checking every stream.

A test program is called with the tool first: NAME_test.py TOOL [unittest option]...
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import formats  # noqa: E402

# A model of two links with a motor, in three files.
ARM_URDF = """<robot name="arm">
  <link name="base"/>
  <link name="forearm">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <joint name="elbow" type="continuous">
    <parent link="base"/>
    <child link="forearm"/>
    <axis xyz="0 0 1"/>
    <limit effort="1" velocity="1"/>
  </joint>
</robot>
"""
ARM_SMURF = "modelname: arm\nfiles:\n- ../urdf/arm.urdf\n- arm_motors.yml\n"
ARM_MOTORS = "motors:\n- name: elbow\n  joint: elbow\n  type: PID\n  maxEffort: 1.0\n  maxSpeed: 1.0\n"

TOOL = None
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FIXTURES = ROOT / "build/fixtures"  # by scripts/fixtures


def package(name, *needs):
    """The package.xml of a package of ROS 2."""
    lines = "".join(f"  <depend>{need}</depend>\n" for need in needs)
    return (f'<package format="3">\n  <name>{name}</name>\n{lines}'
            "  <export><build_type>ament_cmake</build_type></export>\n</package>\n")


def is_sanitized(program):
    """Whether the tool was built with AddressSanitizer, which needs several times as much memory."""
    word = b"__asan_init"
    before = b""
    # Reads in parts, because memory used here would be included in that of the tools.
    with open(program, "rb") as file:
        while part := file.read(1 << 20):
            if word in before + part:
                return True
            before = part[-len(word):]
    return False


class CliTest(unittest.TestCase):
    """Each test has an empty current folder, self.folder."""

    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def enter_workspace(self):
        """Moves the current folder down into a repository of its own: packages are also looked for in the folders beside it,
        and names in the whole repository, where other tests have theirs.
        """
        self.folder = self.folder / "workspace/src"
        (self.folder / ".git").mkdir(parents=True)

    def leave_repository(self):
        """Moves the current folder out of the build folder, into a place without a repository or package around it."""
        outside = pathlib.Path(tempfile.mkdtemp(prefix="smurf-cli-", dir="/tmp"))
        self.addCleanup(shutil.rmtree, outside, ignore_errors=True)
        self.folder = shutil.copytree(self.folder, outside, dirs_exist_ok=True)

    def write(self, path, text):
        target = self.folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        data = text if isinstance(text, bytes) else text.encode()
        target.write_bytes(data)

    def read(self, path):
        return (self.folder / path).read_text()

    def run_tool(self, *arguments, stdin="", environment=None, stdout=subprocess.PIPE, cwd=None, **keywords):
        """The finished process; its streams are text."""
        variables = {k: v for k, v in os.environ.items()
                     if k not in ("NO_COLOR", "FORCE_COLOR", "TERM", "GITHUB_ACTIONS")}
        variables.update(environment or {})
        return subprocess.run(
            [TOOL, *map(str, arguments)], input=stdin, encoding="utf-8", errors="replace",
            stdout=stdout, stderr=subprocess.PIPE, cwd=cwd or self.folder, env=variables, timeout=600,
            check=False, **keywords)

    def formats(self):
        return formats.listed(self.run_tool("--format", "help").stdout)

    def expect(self, code, *arguments, **keywords):
        """Runs and checks the exit code (None: 0 or 1); with 0 and 1, standard error contains only the messages of
        converters, which continue indented."""
        done = self.run_tool(*arguments, **keywords)
        self.assertIn(done.returncode, (0, 1) if code is None else (code,),
                      f"{arguments}\nstdout:\n{done.stdout}\nstderr:\n{done.stderr}")
        if code != 2:
            wrote = f"{pathlib.Path(TOOL).name}: wrote "
            self.assertEqual([line for line in done.stderr.splitlines() if not line.startswith((wrote, "  "))], [])
        return done

    def expect_complaint(self, text, *arguments, **keywords):
        """Exit code 2, nothing on standard output, and this line on standard error."""
        done = self.expect(2, *arguments, **keywords)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr, f"{pathlib.Path(TOOL).name}: {text}\n")


def main():
    global TOOL
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} TOOL [unittest option]...")
    TOOL = str(pathlib.Path(sys.argv.pop(1)).absolute())
    unittest.main(module="__main__")
