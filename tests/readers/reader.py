# SPDX-License-Identifier: BSD-3-Clause
"""What smurfs-flatten writes, given to the programs it is meant for.

A test program is called with the tool and the scratch build folder: NAME_test.py TOOL BUILD.
It ends with 77, which CTest shows as skipped, when one of its readers is absent.
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
import cli  # noqa: E402

SCENES = {name: cli.FIXTURES / f"scenes/{path}.smurfs" for name, path in {
    "example": "example/example", "nested": "nested/outer", "showcase": "showcase/showcase",
}.items()}
NODE_MODULES = cli.ROOT / "build/readers/node_modules"
BUILD = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else pathlib.Path()


def needs_program(name):
    return unittest.skipUnless(shutil.which(name), f"{name} is not installed")


def needs_npm(name):
    return unittest.skipUnless(shutil.which("node") and (NODE_MODULES / name).is_dir(),
                               f"the npm package {name} is not installed")


def needs_built(name):
    """A small C++ program of this folder, which is built only where its library is installed."""
    return unittest.skipUnless((BUILD / name).exists(),
                               f"{name} was not built: its library is not installed")


class ReaderTest(cli.CliTest):
    def write_scene(self, scene, form, *arguments):
        """The result file. Losses are allowed; other tests check them."""
        output = self.folder / f"out.{form.rstrip('0123456789.')}"
        done = self.run_tool(scene, "--format", form, "-o", output, "--quiet", "--allow-outside", *arguments)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        return output

    def flat(self, scene):
        done = self.run_tool(scene, "--links", "--quiet", "--allow-outside")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def read_with(self, *command, **keywords):
        """Standard output of a reader, which must not print errors."""
        done = subprocess.run([str(part) for part in command], capture_output=True, timeout=600,
                              encoding="utf-8", errors="replace", check=False, **keywords)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def assert_same_pose(self, name, position, wxyz, flat, tolerance=1e-9):
        """`flat` is a pose of the flat JSON; the quaternion's sign does not matter."""
        distance = math.dist(position, flat["position"])
        self.assertLessEqual(distance, tolerance, f"{name}: {position} is not {flat['position']}")
        expected = [flat["orientation"][key] for key in "wxyz"]
        same = sum(a * b for a, b in zip(wxyz, expected))
        gap = math.sqrt(sum((a * math.copysign(1, same) - b) ** 2 for a, b in zip(wxyz, expected)))
        self.assertLessEqual(2 * gap, tolerance, f"{name}: {wxyz} is not {expected}")


def main():
    if len(sys.argv) < 3:
        sys.exit(f"usage: {sys.argv[0]} TOOL BUILD [unittest option]...")
    del sys.argv[2]  # BUILD
    cli.TOOL = str(pathlib.Path(sys.argv.pop(1)).absolute())
    result = unittest.main(module="__main__", exit=False).result
    if not result.wasSuccessful():
        sys.exit(1)
    sys.exit(77 if result.skipped else 0)
