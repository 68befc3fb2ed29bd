# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/fixtures lays out, and the mistakes that it reports."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent.parent / "scripts/fixtures"
RULE = "rules/lamp/SML1-x"
FILES = {
    "README.md": "", "models/arm/arm.urdf": "arm",
    "rules/lamp/base/lamp.urdf": "lamp", "rules/lamp/base/model.smurf": "model",
    f"{RULE}/base/lamp.yml": "motors", f"{RULE}/bad/parts/odd.yml": "odd", f"{RULE}/bad/model.smurf": "other model",
    f"{RULE}/bad.expected.txt": "report", f"{RULE}/targets": "mars",
    "rules/SML2-y/bad/robot.urdf": "bad", "rules/SML2-y/good/robot.urdf": "good",
    "rules/lamp/SML3-z/bad/lamp.yml": "z",
}
LAID_OUT = {
    "models/arm/arm.urdf": "arm",
    "rules/SML1-x/bad/lamp.urdf": "lamp", "rules/SML1-x/bad/lamp.yml": "motors",
    "rules/SML1-x/bad/model.smurf": "other model", "rules/SML1-x/bad/parts/odd.yml": "odd",
    "rules/SML1-x/good/lamp.urdf": "lamp", "rules/SML1-x/good/lamp.yml": "motors",
    "rules/SML1-x/good/model.smurf": "model", "rules/SML1-x/targets": "mars",
    "rules/SML2-y/bad/robot.urdf": "bad", "rules/SML2-y/good/robot.urdf": "good",
    "rules/SML3-z/bad/lamp.urdf": "lamp", "rules/SML3-z/bad/model.smurf": "model", "rules/SML3-z/bad/lamp.yml": "z",
    "rules/SML3-z/good/lamp.urdf": "lamp", "rules/SML3-z/good/model.smurf": "model",
}
# (more files, the mistake)
MISTAKES = [
    ({f"{RULE}/good/lamp.urdf": "lamp"}, f"{RULE}/good/lamp.urdf: delete it, its base has the same"),
    ({f"{RULE}/base/lamp.urdf": "lamp"}, f"{RULE}/base/lamp.urdf: delete it, the base around it has the same"),
    ({f"{RULE}/{case}/same.yml": "same" for case in ("bad", "good")},
     f"{RULE}/good/same.yml: move it to base, both cases have it"),
    ({f"{RULE}/base/rest.yml": "1", f"{RULE}/bad/rest.yml": "2", f"{RULE}/good/rest.yml": "3"},
     f"{RULE}/base/rest.yml: no case uses it"),
    ({"rules/lamp/notes.txt": ""}, "rules/lamp/notes.txt: belongs to no rule"),
    ({f"{RULE}/god/lamp.yml": "motors"}, f"{RULE}/god: expected bad, base, good"),
    ({"rules/box/SML2-y/bad/box.urdf": "", "rules/box/SML2-y/good/model.smurf": "1"},
     "rules/box/SML2-y: another folder has this rule"),
]


def read(folder):
    return {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*") if path.is_file()}


class FixturesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root, self.out = pathlib.Path(folder.name) / "fixtures", pathlib.Path(folder.name) / "out"
        self.write(FILES)

    def write(self, files):
        for name, text in files.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text)

    def lay_out(self):
        done = subprocess.run([sys.executable, SCRIPT, self.root, self.out], capture_output=True, text=True, check=False)
        self.assertEqual(done.stdout, "")
        return done.returncode, done.stderr

    def test_whole_folders(self):
        self.assertEqual(self.lay_out(), (0, ""))
        self.assertEqual(read(self.out), LAID_OUT)

    def test_changes(self):
        self.lay_out()
        before = {name: (self.out / name).stat().st_mtime_ns for name in LAID_OUT}
        (self.root / RULE / "bad/parts/odd.yml").unlink()
        (self.root / RULE / "bad/parts").rmdir()
        self.write({f"{RULE}/bad/parts": "now a file", "rules/lamp/base/lamp.urdf": "LAMP"})
        self.assertEqual(self.lay_out(), (0, ""))
        changed = {name: "LAMP" for name in LAID_OUT if name.endswith("/lamp.urdf")}
        changed["rules/SML1-x/bad/parts"] = "now a file"
        kept = set(LAID_OUT) - set(changed) - {"rules/SML1-x/bad/parts/odd.yml"}
        self.assertEqual(read(self.out), {**{name: LAID_OUT[name] for name in kept}, **changed})
        for name in kept:
            self.assertEqual((self.out / name).stat().st_mtime_ns, before[name], name)

    def test_mistakes(self):
        for files, mistake in MISTAKES:
            with self.subTest(mistake):
                self.setUp()
                self.lay_out()
                self.write(files)
                self.assertEqual(self.lay_out(), (1, f"fixtures/{mistake}\n"))
                self.assertEqual(read(self.out), LAID_OUT)


if __name__ == "__main__":
    unittest.main()
