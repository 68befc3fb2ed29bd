# SPDX-License-Identifier: BSD-3-Clause
"""smurf2urdf, smurfs-flatten and the module give the same bytes, losses and refusals.

All of them print what smurf/conversion.hpp decides; npm runs the programs themselves (tests/parity).
"""
import json
import re
import resource
import signal

import inputs
import pytest
import smurf

FORMATS = ("json", "sdf", "mjcf")
AT_THE_END = re.compile(r"(; see --force)?; nothing was written$")


def as_json(losses):
    """Findings of the module as --loss-report has them."""
    return [{"id": one.id, "message": one.message, "file": one.place.file, "line": one.place.line,
             "column": one.place.column, "end_line": one.place.end_line, "end_column": one.place.end_column,
             "pointer": one.pointer} for one in losses]


def reason_of(refusal):
    """Without the path, which the module normalises."""
    return re.sub(r"^([\w-]+: )?'[^']*' ", "", refusal)


def by_program(tool, path, folder, *options):
    """The bytes and the losses, or the reason of the refusal."""
    report = folder / "losses.json"
    report.unlink(missing_ok=True)
    done = inputs.run(tool, path, "--loss-report", report, *options)
    if done.returncode == 1:
        return AT_THE_END.sub("", reason_of(done.stderr.decode().splitlines()[-1]))
    assert done.returncode == 0, (path, done.stderr)
    losses = json.loads(report.read_text())["losses"]
    for one in losses:
        del one["class"]
    return done.stdout, losses


def by_module(thing, path, name):
    """The same; without the name of a format, a URDF."""
    try:
        if name is None:
            urdf = thing.to_urdf()
            return bytes(urdf), as_json(urdf.losses)
        export = thing.write(name)
        return export.text.encode(), as_json(export.losses)
    except smurf.Error as refused:
        return reason_of(refused.args[0].splitlines()[0])


def compare(paths, folder):
    """The numbers of results and of refusals."""
    exported = refused = 0
    for path in paths:
        try:
            thing = (smurf.load_scene if inputs.is_scene(path) else smurf.load_model)(path)
        except smurf.Error:  # there is nothing in the file
            thing = None
        for name in (*FORMATS, *([] if inputs.is_scene(path) else [None])):
            tool, options = ("smurfs-flatten", ["--format", name]) if name else ("smurf2urdf", [])
            expected = by_program(tool, path, folder, *options)
            is_refused = isinstance(expected, str)
            same = is_refused if thing is None else by_module(thing, path, name) == expected
            assert same, (tool, options, path, expected)
            exported += not is_refused
            refused += is_refused
    return exported, refused


def test_fixtures(tmp_path):
    exported, refused = compare(inputs.fixtures(), tmp_path)
    assert exported > 2000 and refused > 200


def test_options(tmp_path):
    """The same refusals of options, and of losses that options would bring."""
    for words, keywords in ((["--base", "fixed"], {"base": "fixed"}), (["--apply", "all"], {"apply": [
            "materials", "limits", "dynamics", "mimic"]}), (["--collapse-fixed"], {"collapse_fixed": True})):
        expected = by_program("smurf2urdf", inputs.ARM, tmp_path, *words)
        urdf = smurf.load_model(inputs.ARM).to_urdf(**keywords)
        assert (bytes(urdf), as_json(urdf.losses)) == expected
    expected = by_program("smurf2urdf", inputs.ARM, tmp_path, "--collapse-fixed", "--keep", "no_such_link")
    with pytest.raises(ValueError) as refused:
        smurf.load_model(inputs.ARM).to_urdf(collapse_fixed=True, keep=["no_such_link"])
    assert str(refused.value).split("' ", 1)[1] == expected


def test_losses_are_kept(tmp_path):
    urdf = smurf.load_model(inputs.ARM).to_urdf()
    assert isinstance(urdf, bytes) and isinstance(urdf, smurf.Urdf) and len(urdf.losses) > 50
    urdf.save(tmp_path / "arm.urdf")
    assert (tmp_path / "arm.urdf").read_bytes() == urdf


def test_a_file_is_saved_as_a_whole(tmp_path):
    urdf = smurf.load_model(inputs.ARM).to_urdf()
    place, link = tmp_path / "arm.urdf", tmp_path / "link.urdf"
    place.write_bytes(b"before")
    place.chmod(0o640)
    link.symlink_to(place)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    signal_before = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        with pytest.raises(OSError):
            urdf.save(place)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, signal_before)
    assert place.read_bytes() == b"before" and sorted(tmp_path.iterdir()) == [place, link]
    urdf.save(link)
    assert link.is_symlink() and place.read_bytes() == urdf and place.stat().st_mode & 0o777 == 0o640
    for saved in (urdf, smurf.load_model(inputs.ARM).write("mjcf")):
        with pytest.raises(TypeError):
            saved.save(1)  # an open file
        saved.save("/dev/null")
