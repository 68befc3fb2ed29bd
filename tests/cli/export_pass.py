# SPDX-License-Identifier: BSD-3-Clause
"""Converts every model of some folders once, in all ways, for the tests that judge the results (exported.py).

usage: export_pass.py CASES OUT FOLDER...; ends with 77, which CTest shows as skipped, when a folder is absent.

Each model has a folder in OUT:
  runs.json          its source; whether it has no errors; the exit code and the messages of each run; the errors of the
                     copy and of the SMURF made of the source; sums of the files of `new`
  source.urdf        a copy of the URDF, which is converted in place, and back: in_place.urdf
  new/               what urdf2smurf makes of it, twice
  out/NAME.urdf      the exports of that, or of a .smurf that lists a URDF, with the options of NAME
  again/NAME.urdf    the exports of these, with the same options
"""
import hashlib
import json
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402
import exported  # noqa: E402


class Pass:
    """The conversions of one model."""

    def __init__(self, tools, source, folder):
        self.tools, self.source, self.folder = tools, source, folder
        self.runs = {}
        self.force = ["--force"]

    def run(self, name, *command):
        done = self.tools.run(*command, cwd=self.folder)
        self.runs[name] = {"code": done.returncode, "messages": done.stderr}
        return done

    def errors(self, path):
        """(id, line) of each error, and whether it is in the URDF."""
        report = json.loads(self.tools.run("smurf-lint", path, "--format", "json", cwd=self.folder).stdout)
        return sorted((one["id"], one["line"], one["file"].lower().endswith(".urdf"))
                      for one in report["diagnostics"] if one["severity"] == "error")

    def convert(self):
        urdf = exported.listed_urdf(self.source)
        is_sound = not self.errors(self.source)
        self.force = [] if is_sound else ["--force"]
        record = {"source": str(urdf), "model": str(self.source), "is_sound": is_sound}
        if self.source.suffix != ".smurf":
            self.run("proved", "smurf2urdf", urdf, "--dry-run", "--prove")
            record.update(self.convert_urdf(urdf))
        else:
            self.export(self.source)
        (self.folder / "runs.json").write_text(json.dumps({**record, "runs": self.runs}))

    def convert_urdf(self, urdf):
        shutil.copyfile(urdf, self.folder / "source.urdf")
        # A file that cannot be read is refused even with --force.
        if self.run("readable", "smurf2urdf", urdf, "--force", "--dry-run").returncode != 0:
            return {"is_readable": False}
        # Without its meshes, the copy may have errors that the source has not; without neighbours, it lacks others.
        errors = self.errors("source.urdf")
        options = ("--quiet", *(["--force"] if errors else []))
        self.run("in place", "urdf2smurf", self.folder / "source.urdf", "--in-place", *options)
        self.run("back", "smurf2urdf", "source.smurf", "-o", "in_place.urdf", *options)
        self.run("repaired", "smurf2urdf", "in_place.urdf", "-o", "repaired.urdf", *options)
        new = ("urdf2smurf", urdf, "-o", "new", "--name", "robot", *self.force, "--quiet")
        sums = []
        for name, options in (("new", ()), ("new again", ("--overwrite",))):
            self.run(name, *new, *options)
            sums.append({path.name: hashlib.sha256(path.read_bytes()).hexdigest()
                         for path in sorted((self.folder / "new").rglob("*")) if path.is_file()})
        model = self.folder / "new/smurf/robot.smurf"
        if model.is_file():
            self.export(model)
        return {"model": str(model), "sums": sums, "errors": errors,
                "model_errors": self.errors(model) if model.is_file() else []}

    def export(self, model):
        for place in ("out", "again"):
            (self.folder / place).mkdir()
        for name, options in exported.OPTIONS.items():
            options = ("--quiet", "--prove", *self.force, *options)
            done = self.run(name, "smurf2urdf", model, "-o", f"out/{name}.urdf", *options)
            if done.returncode == 0 and name in exported.STABLE:
                self.run(f"{name} again", "smurf2urdf", f"out/{name}.urdf", "-o", f"again/{name}.urdf", *options)


def main():
    program, out = sys.argv[1], pathlib.Path(sys.argv[2])
    folders = [pathlib.Path(word).resolve() for word in sys.argv[3:]]
    shutil.rmtree(out, ignore_errors=True)
    for folder in folders:
        if not folder.is_dir():
            print(f"skipped: there is no {folder}")
            sys.exit(77)
    count = 0
    with cases.Cases(program) as tools:
        for folder in folders:
            for source in exported.sources(folder):
                place = out.resolve() / f"{count:04}"
                place.mkdir(parents=True)
                Pass(tools, source, place).convert()
                count += 1
    (out / "count").write_text(str(count))
    print(f"{count} models")
    sys.exit(0 if count else "no model was found")


if __name__ == "__main__":
    main()
