# SPDX-License-Identifier: BSD-3-Clause
"""Progress on a terminal: a line that is erased again, for long runs only, and never elsewhere."""
import os
import pathlib
import pty
import subprocess
import time
import unittest

import cli

ERASED = b"\r\x1b[K"
ENOUGH = 1.5  # seconds; progress shows after one
BALL = """<robot name="ball"><link name="ball"><inertial><mass value="1"/>
<inertia ixx="0.004" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.004"/></inertial>
<collision><geometry><sphere radius="0.1"/></geometry></collision></link></robot>
"""


class ProgressTest(cli.CliTest):
    def long_run(self):
        """The arguments of a run of some seconds, and its number of files."""
        if pathlib.Path(cli.TOOL).name == "smurf-load-check":
            self.write("a.urdf", BALL)
            self.write("b.urdf", BALL)
            return ["--time", "3600", "--time-limit", "1", "."], 2
        links = "".join(f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="l{i}"/>'
                        f'<child link="l{i + 1}"/></joint>' for i in range(15_000))
        words, count = ["-j", "1", "."], 0
        while True:  # twice as many until the run is long enough on this machine
            for number in range(count, max(16, 2 * count)):
                self.write(f"{number}.urdf", f'<robot name="r">{links}<link name="l15000"/></robot>')
            count = max(16, 2 * count)
            start = time.monotonic()
            self.run_tool(*words)
            if time.monotonic() - start > ENOUGH:
                return words, count

    def on_terminal(self, *words, **variables):
        """The output on standard error, a terminal."""
        shown, terminal = pty.openpty()
        self.addCleanup(os.close, shown)
        environment = {k: v for k, v in os.environ.items() if k != "CI"}
        with subprocess.Popen([cli.TOOL, *words], cwd=self.folder, stderr=terminal, stdout=subprocess.DEVNULL,
                              env={**environment, "TERM": "xterm", **variables}) as run:
            os.close(terminal)
            text = b""
            try:
                while part := os.read(shown, 4096):
                    text += part
            except OSError:  # the signal for the end of a terminal on Linux
                pass
            run.wait()
        return text

    def test_a_long_run(self):
        words, count = self.long_run()
        text = self.on_terminal(*words)
        self.assertRegex(text, rb"checked \d+ of %d" % count)
        self.assertTrue(text.endswith(ERASED), text)
        self.assertNotIn(b"\n", text)
        self.assertEqual(self.on_terminal(*words, CI="true"), b"")
        self.assertEqual(self.on_terminal(*words, TERM="dumb"), b"")
        self.assertEqual(self.run_tool(*words).stderr, "")

    def test_a_short_run(self):
        self.write("a.urdf", BALL)
        self.write("b.urdf", BALL)
        self.assertEqual(self.on_terminal("."), b"")


if __name__ == "__main__":
    cli.main()
