# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lsp in Kate, started by the snippet of docs/editors.md, on a screen that nobody sees: what is asserted is the
title of the window and what Kate has written.

kate_test.py SMURF-LSP   Ends with 77, which CTest shows as skipped, without Kate and its screen. Not for every push,
                         because keys go to a window that may not be ready when the machine is busy.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from neovim_test import ROOT, snippet  # noqa: E402

TOOL = None
PROGRAMS = ["kate", "Xvfb", "xdotool", "dbus-run-session"]
SECONDS = 600  # s to wait for something, however busy the machine is


class Kate(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-lsp-")).resolve()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        shutil.copytree(ROOT / "fixtures/models/arm", self.folder / "arm")
        self.motors = self.folder / "arm/smurf/arm_motors.yml"
        self.urdf = self.folder / "arm/urdf/arm.urdf"
        config = self.folder / "config"
        (config / "kate/lspclient").mkdir(parents=True)
        (config / "kate/lspclient/settings.json").write_text(snippet("json"))
        # Kate asks before it starts a server for the first time.
        (config / "katerc").write_text(f"[General]\nShow welcome view for new window=false\n"
                                       f"[lspclient]\nAllowedServerCommandLines={pathlib.Path(TOOL).absolute()}\n")
        self.environment = {
            **os.environ, "HOME": str(self.folder), "XDG_CONFIG_HOME": str(config),
            "XDG_DATA_HOME": str(self.folder / "data"), "XDG_RUNTIME_DIR": str(self.folder),
            "QT_QPA_PLATFORM": "xcb", "PATH": f"{pathlib.Path(TOOL).resolve().parent}:{os.environ['PATH']}"}
        self.start_screen()

    def start_screen(self):
        reader, writer = os.pipe()
        screen = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1000x700x24"],
                                  pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        self.addCleanup(screen.wait)
        self.addCleanup(screen.terminate)
        with os.fdopen(reader) as number:
            self.environment["DISPLAY"] = ":" + number.readline().strip()

    def start_kate(self):
        kate = subprocess.Popen(["dbus-run-session", "kate", "-b", "-n", "--startanon", self.motors],
                                env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(kate.wait)
        self.addCleanup(kate.terminate)
        self.wait("a window", lambda: "arm_motors.yml" in self.title())

    def wait(self, what, condition):
        end = time.monotonic() + SECONDS
        while not condition():
            self.assertLess(time.monotonic(), end, f"{what} is missing; the title is {self.title()!r}")
            time.sleep(0.3)

    def xdotool(self, *words):
        done = subprocess.run(["xdotool", *words], env=self.environment, capture_output=True, text=True, check=False)
        return done.stdout.strip()

    def title(self):
        return self.xdotool("search", "--onlyvisible", "--name", ".", "getwindowname", "%@")

    def press(self, *keys):
        for key in keys:
            self.xdotool("key", "--clearmodifiers", key)
            time.sleep(0.4)

    def type(self, text):
        self.xdotool("type", "--delay", "40", text)
        time.sleep(0.8)

    def run_action(self, name):
        self.press("ctrl+alt+i")
        self.type(name)
        self.press("Return")

    def go_to(self, line):
        self.press("ctrl+g")
        self.type(str(line))
        self.press("Return", "End")

    def line_of(self, text):
        return self.motors.read_text().split(text)[0].count("\n") + 1

    def test_jump_and_rename(self):
        self.start_kate()
        line = self.line_of("joint: joint1_waist")

        def has_jumped():
            self.go_to(line)
            self.run_action("Go to Definition")
            time.sleep(1)
            return "arm.urdf" in self.title()
        self.wait("the jump", has_jumped)
        self.run_action("Rename")
        time.sleep(1)
        self.press("ctrl+a")
        self.type("waist")
        self.press("Return")

        def is_renamed():
            # Without a window manager, the focus does not return when the dialog is closed.
            self.xdotool("search", "--onlyvisible", "--name", "arm.urdf", "windowfocus")
            self.press("ctrl+l")  # saves all
            return '<joint name="waist"' in self.urdf.read_text()
        self.wait("the new name", is_renamed)
        for path in (self.motors, self.folder / "arm/smurf/arm_sensors.yml"):
            self.wait(f"the new name in {path.name}", lambda path=path: re.search(r"\bwaist\b", path.read_text()))


if __name__ == "__main__":
    TOOL = sys.argv.pop(1)
    for program in PROGRAMS:
        if shutil.which(program) is None:
            print(f"skipped: {program} is not installed; the packages are kate, xvfb, xdotool and dbus")
            sys.exit(77)
    unittest.main()
