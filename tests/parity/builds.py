# SPDX-License-Identifier: BSD-3-Clause
"""The builds of the tools that are compared with the native one. A job is a tool, its arguments and its folder."""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "wasm"))
from built import skip_without  # noqa: E402

WINE = shutil.which("wine64", path=os.environ["PATH"] + ":/usr/lib/wine")
QEMU = "qemu-aarch64-static"
ENVIRONMENT = {"PATH": os.environ["PATH"], "NO_COLOR": "1"}


def sum_of(data):
    return hashlib.sha256(data).hexdigest()


class Native:
    """Programs of this machine, in a folder."""

    def __init__(self, folder):
        self.folder = folder

    def command(self, tool):
        return [self.folder / tool]

    environment = ENVIRONMENT

    def run_alone(self, job):
        tool, arguments, folder = job
        return subprocess.run([*self.command(tool), *arguments], cwd=folder, env=self.environment, capture_output=True,
                              check=False, stdin=subprocess.DEVNULL)

    def run(self, job):
        """The exit code and the sums of both outputs."""
        done = self.run_alone(job)
        return [done.returncode, sum_of(self.shared(done.stdout)), sum_of(self.shared(done.stderr))]

    @staticmethod
    def shared(data):
        """The output without the parts that differ from system to system."""
        return data


def skip_without_program(emulator, program, tools, script):
    if emulator is None or not program.exists():
        print(f"SKIPPED: {script} builds what is tested here")
        sys.exit(77)
    if program.stat().st_mtime < (tools / "smurf-lint").stat().st_mtime:
        print(f"SKIPPED: the programs are older than the native tools; {script} builds them again")
        sys.exit(77)


class Emulated(Native):
    """Programs for arm64, which qemu runs."""

    tools = ("smurf-lint", "smurf2urdf", "urdf2smurf", "smurfs-flatten", "smurf-diff")

    def command(self, tool):
        return [QEMU, self.folder / tool]

    @staticmethod
    def skip_without(tools, folder):
        skip_without_program(shutil.which(QEMU), folder / "smurf-lint", tools, "scripts/arm64")


class Windows(Native):
    """Programs for Windows, run by wine, where the root of this machine is the drive Z."""

    tools = Emulated.tools

    def __init__(self, folder):
        super().__init__(folder)
        self.home = tempfile.TemporaryDirectory(prefix="smurf-wine-", ignore_cleanup_errors=True)
        self.environment = ENVIRONMENT | {"WINEPREFIX": self.home.name, "WINEDEBUG": "-all", "HOME": self.home.name, "LC_ALL": "C.UTF-8",
                                          "WINEDLLOVERRIDES": "mscoree,mshtml="}
        self.run_alone(("smurf-lint", ["--version"], "/"))  # on its first run, wine makes its folders and prints that
        # While one program waits, wine keeps its services; it would start them again for each run, which takes seconds.
        self.waiting = subprocess.Popen([WINE, "cmd"], env=self.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL)
        self.waiting.stdout.readline()  # else the first run may start the services, which then keep its output open

    def command(self, tool):
        return [WINE, self.folder / f"{tool}.exe"]

    @staticmethod
    def shared(data):
        return data.replace(b"/Z:/", b"/")

    @staticmethod
    def skip_without(tools, folder):
        skip_without_program(WINE, folder / "smurf-lint.exe", tools, "scripts/windows")


class WebAssembly(Native):
    """The npm package; one process runs one job after the other."""

    tools = ("smurf-lint", "smurf2urdf", "urdf2smurf", "smurfs-flatten")
    skip_without = staticmethod(skip_without)

    def __init__(self, folder):
        super().__init__(folder)
        self.process = subprocess.Popen(["node", HERE / "run_jobs.mjs", folder], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True)

    def command(self, tool):
        return ["node", self.folder / "bin" / f"{tool}.mjs"]

    def run(self, job):
        tool, arguments, folder = job
        self.process.stdin.write(json.dumps({"tool": tool, "args": arguments, "folder": str(folder)}) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())


BUILDS = {"arm64": Emulated, "windows": Windows, "wasm": WebAssembly}
