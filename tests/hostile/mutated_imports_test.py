# SPDX-License-Identifier: BSD-3-Clause
"""Files of MJCF and SDF with faults that are made by a program: no crash, no hang, no use of much memory, and an error where a
number, a name or a tag is broken. mutated_imports_test.py FOLDER_OF_PROGRAMS"""
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile
import unittest

BIN = pathlib.Path(sys.argv[1]).absolute()
FIXTURES = pathlib.Path(__file__).resolve().parents[2] / "build/fixtures/rules"
MUTANTS = 60  # of each language
MEMORY = 2 << 30  # of addresses; a program uses a tenth of it
SECONDS = 20  # 2 s, on a machine that does nothing else
VALUES = ["", "0", "-1", "nan", "inf", "1e308", "99999999999999999999", "x", "1 2", "1 2 3 4 5 6 7 8", "world", "__model__",
          "a::b::c", "../../../etc/passwd", "model://", "https://example.org/y", "0x10", "1,5", "%s%n", "\u00fc" * 50, "A" * 5000]


def change_value(text, rng):
    found = list(re.finditer(r'="([^"]*)"', text))
    if not found:
        return text
    one = rng.choice(found)
    return text[:one.start(1)] + rng.choice(VALUES) + text[one.end(1):]


def change_text(text, rng):
    found = [one for one in re.finditer(r">([^<]+)<", text) if one[1].strip()]
    if not found:
        return change_value(text, rng)
    one = rng.choice(found)
    return text[:one.start(1)] + rng.choice(VALUES) + text[one.end(1):]


def delete_tag(text, rng):
    found = list(re.finditer(r"<[^>]*>", text))
    if not found:
        return text
    one = rng.choice(found)
    return text[:one.start()] + text[one.end():]


def repeat_element(text, rng):
    found = list(re.finditer(r"<[^<>/]*/>|<(\w+)\b[^<>]*>[^<]*</\1>", text))
    if not found:
        return text
    one = rng.choice(found) if found else None
    return text[:one.end()] + one[0] * rng.choice([1, 50]) + text[one.end():] if one else text


def rename(text, rng):
    found = list(re.finditer(r"[< ](\w+)[ =>]", text))
    if not found:
        return text
    one, other = rng.choice(found), rng.choice(found)
    return text[:one.start(1)] + other[1] + text[one.end(1):]


def cut(text, rng):
    return text[:rng.randrange(len(text))]


def nest(text, rng):
    found = list(re.finditer(r"<(\w+)\b[^<>]*>(?:(?!<\1\b).)*?</\1>", text, re.S))
    if not found:
        return text
    one, other = rng.choice(found), rng.choice(found)
    at = text.find(">", other.start()) + 1
    return text[:at] + one[0] * 3 + text[at:]


CHANGES = [change_value, change_text, delete_tag, repeat_element, rename, cut, nest]


class MutatedTest(unittest.TestCase):
    def run_all(self, suffix):
        files = sorted(FIXTURES.glob(f"SML93*/*/robot.{suffix}"))
        self.assertGreater(len(files), 4)
        rng = random.Random(suffix)
        with tempfile.TemporaryDirectory() as folder:
            path, out = pathlib.Path(folder, "robot." + suffix), pathlib.Path(folder, "robot.urdf")
            for number in range(MUTANTS):
                text = rng.choice(files).read_text(encoding="utf-8")
                for _ in range(rng.choice([1, 1, 2, 4])):
                    text = rng.choice(CHANGES)(text, rng) or text
                path.write_text(text, encoding="utf-8")
                out.unlink(missing_ok=True)
                for command in (["smurf2urdf", path, "-o", out], ["smurf-lint", path], ["smurfs-flatten", path, "--links"]):
                    done = subprocess.run([BIN / command[0], *command[1:]], capture_output=True, text=True, check=False,
                                          timeout=SECONDS, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
                    self.assertIn(done.returncode, (0, 1), f"{number}: {command[0]} on {text}: {done.stderr}")
                    if done.returncode == 1 and command[0] != "smurf-lint":
                        self.assertTrue(done.stderr.strip(), text)

    def test_mjcf(self):
        self.run_all("mjcf")

    def test_sdf(self):
        self.run_all("sdf")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
