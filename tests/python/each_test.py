# SPDX-License-Identifier: BSD-3-Clause
"""check_each() says what check() says, keeps nothing, and its records and reports cross processes."""
import hashlib
import importlib.util
import json
import os
import pathlib
import pickle
import random
import re
import signal
import subprocess
import sys
import time

import inputs  # noqa: F401
import pytest
import smurf

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "data-sets.md"
LINK = """<link name="l{i}"><inertial><mass value="{mass}"/>
  <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
  <visual><geometry><{shape}/></geometry></visual></link>
"""


def write_robots(folder, count, links=3):
    """Robots with and without faults, from one seed."""
    chance = random.Random(1)
    for number in range(count):
        parts = [LINK.format(i=i, mass=chance.choice(["1", "1", "1", "0", "-1", "x"]),
                             shape=chance.choice(['sphere radius="1"', 'sphere radius="1"', "ball", 'mesh filename="m.stl"']))
                 for i in range(links)]
        joints = [f'<joint name="j{i}" type="fixed"><parent link="l{i - 1}"/><child link="l{i}"/></joint>\n'
                  for i in range(1, links)]
        place = folder / f"{number:05}"
        place.mkdir(parents=True)
        (place / "robot.urdf").write_text(f'<robot name="r{number}">\n' + "".join(parts + joints) + "</robot>\n")


def test_each_is_what_a_check_says(tmp_path):
    write_robots(tmp_path, 60)
    (tmp_path / "part.xacro").write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro></robot>')
    records = list(smurf.check_each(tmp_path, targets=["mujoco", "drake"], jobs=3))
    assert len(records) == 60
    assert [record.path for record in records] == sorted(record.path for record in records)
    assert {record.ok for record in records} == {True, False}
    for record in records:
        report = smurf.check(record.path, targets=["mujoco", "drake"])
        assert [one.line for one in record.findings] == [str(one) for one in report]
        assert record.loads == {verdict.target: verdict.answer for verdict in report.targets}
        assert record.counts["errors"] == report.errors and record.ok == (report.errors == 0)
        assert pickle.loads(pickle.dumps(record)) == record
        bytes_of_robot = pathlib.Path(record.path).read_bytes()
        assert record.digest == hashlib.blake2b(bytes_of_robot, digest_size=32).hexdigest()
        model = smurf.load_model(record.path)
        assert (record.links, record.mass) == (len(model.links), sum(
            link.inertial.mass or 0 for link in model.links if link.inertial))
    assert list(smurf.check_each(tmp_path, jobs=1)) == list(smurf.check_each([tmp_path], jobs=2))
    left = {record.path for record in records[5:]}
    assert [record.path for record in smurf.check_each(tmp_path, skip=left)] == [record.path for record in records[:5]]
    first = smurf.check_each(tmp_path)
    assert next(first).path == records[0].path
    first.close()
    with pytest.raises(smurf.Error, match="nowhere"):
        smurf.check_each(tmp_path / "nowhere")
    with pytest.raises(TypeError):
        smurf.check_each(tmp_path, target=["mujoco"])
    with pytest.raises(ValueError):
        smurf.check_each(tmp_path, jobs=0)


def test_a_cache_changes_no_record(tmp_path):
    robots, cache = tmp_path / "robots", tmp_path / "cache"
    write_robots(robots, 30)
    (robots / "part.xacro").write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro></robot>')
    settings = {"targets": ["mujoco"], "jobs": 2}
    fresh = list(smurf.check_each(robots, **settings))
    assert list(smurf.check_each(robots, cache=cache, **settings)) == fresh
    file, = cache.glob("*.smurf-checks")
    lines = file.read_bytes().count(b"\n")
    assert lines >= 31
    for _ in range(2):
        assert list(smurf.check_each(robots, cache=str(cache), **settings)) == fresh
        assert file.read_bytes().count(b"\n") == lines  # nothing was checked again
    time.sleep(2.1)  # the stamps are then enough
    for _ in range(2):
        assert list(smurf.check_each(robots, cache=cache, **settings)) == fresh
    (robots / "00003" / "robot.urdf").write_text("<robot/>")
    changed = list(smurf.check_each(robots, **settings))
    assert changed != fresh
    assert list(smurf.check_each(robots, cache=cache, **settings)) == changed
    assert list(smurf.check_each(robots, cache=cache)) == list(smurf.check_each(robots))
    # An answer of another form, with the digest of the line.
    lines = file.read_bytes().splitlines(keepends=True)
    for text in (b"[1]\t", b'{"path":1}\t', b"{\t", b'{"findings":[{"place":{}}]}\t'):
        forged = [lines[0]]
        for line in lines[1:]:
            key = line[:32]
            check = hashlib.blake2b(key + text, digest_size=32).hexdigest()[:32].encode()
            forged.append(key + b" " + check + b" " + text + b"\n")
        file.write_bytes(b"".join(forged))
        assert list(smurf.check_each(robots, cache=cache, **settings)) == changed
    (tmp_path / "file").write_text("")
    with pytest.warns(RuntimeWarning, match="cannot write"):
        assert list(smurf.check_each(robots, cache=tmp_path / "file", **settings)) == changed


def test_reports_are_pickled(tmp_path):
    write_robots(tmp_path, 8)
    for robot in sorted(tmp_path.rglob("*.urdf")):
        report = smurf.check(robot, targets=["mujoco"])
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            again = pickle.loads(pickle.dumps(report, protocol))
            assert [str(one) for one in again] == [str(one) for one in report]
            assert (again.errors, again.warnings, again.infos, again.suppressed) == (
                report.errors, report.warnings, report.infos, report.suppressed)
            assert [(one.target, one.answer) for one in again.targets] == [
                (one.target, one.answer) for one in report.targets]
            for ours, theirs in zip(again, report):
                for name in ("id", "name", "severity", "message", "help", "notes", "pointer", "fix"):
                    assert getattr(ours, name) == getattr(theirs, name)
                assert str(ours.place) == str(theirs.place)
                assert pickle.loads(pickle.dumps(theirs, protocol)) == ours
                assert pickle.loads(pickle.dumps(theirs.place, protocol)) == ours.place


@pytest.mark.skipif(importlib.util.find_spec("pyarrow") is None, reason="pyarrow is not installed")
def test_batches(tmp_path):
    write_robots(tmp_path, 25)
    records = list(smurf.check_each(tmp_path, targets=["mujoco"]))
    batches = list(smurf.check_batches(tmp_path, targets=["mujoco"], size=10, cache=tmp_path / "cache"))
    assert list(smurf.check_batches(tmp_path, targets=["mujoco"], size=10, cache=tmp_path / "cache")) == batches
    assert [len(batch) for batch in batches] == [10, 10, 5]
    assert len({batch.schema for batch in batches}) == 1
    rows = [row for batch in batches for row in batch.to_pylist()]
    for row, record in zip(rows, records):
        assert (row["path"], row["ok"], row["loads_mujoco"]) == (record.path, record.ok, record.loads["mujoco"])
        assert {name: row[name] for name in record.counts} == record.counts
        assert (row["digest"], row["links"], row["mass"]) == (record.digest, record.links, record.mass)
        assert [(one["id"], one["line"], one["message"]) for one in row["findings"]] == [
            (one.id, one.place.line, one.message) for one in record.findings]


MEASURE = """
import resource, sys, smurf
peaks = []
for number, record in enumerate(smurf.check_each(sys.argv[1], jobs=2)):
    if number in (200, 1199):
        peaks.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
print(*peaks)
"""


def test_memory_does_not_grow(tmp_path):
    """With all sources kept, a thousand more robots would take 46 MB and more."""
    write_robots(tmp_path, 1200, links=100)
    done = subprocess.run([sys.executable, "-c", MEASURE, tmp_path], capture_output=True, text=True, timeout=600)
    early, late = map(int, done.stdout.split())  # kB
    assert late - early < 12000, f"{early} kB after 200 robots, {late} kB after 1,200"


def program(name, tmp_path):
    code = dict(re.findall(r"```python\n# (\w+\.py)[^\n]*\n(.*?)```", PAGE.read_text(), re.S))[name]
    path = tmp_path / name
    path.write_text(code)
    return path


def run(*command):
    done = subprocess.run([sys.executable, *command], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize(("name", "needs"), [("processes.py", "multiprocessing"), ("with_ray.py", "ray"),
                                             ("with_dask.py", "dask")])
def test_programs_of_the_page(name, needs, tmp_path):
    if importlib.util.find_spec(needs) is None:
        pytest.skip(f"{needs} is not installed")
    robots = tmp_path / "robots"
    write_robots(robots, 120)
    expected = "".join(f"{record.path} {record.loads['mujoco']}\n"
                       for record in smurf.check_each(robots, targets=["mujoco"]))
    assert run(program(name, tmp_path), robots) == expected


def test_a_stopped_run_goes_on(tmp_path):
    robots, whole, part = tmp_path / "robots", tmp_path / "whole", tmp_path / "part"
    write_robots(robots, 300)
    records = program("records.py", tmp_path)
    run(records, robots, whole)
    assert len(whole.read_text().splitlines()) == 300
    for lines in (3, 70, 150):
        part.unlink(missing_ok=True)
        with subprocess.Popen([sys.executable, records, robots, part]) as started:
            while started.poll() is None and (not part.exists() or part.read_bytes().count(b"\n") < lines):
                time.sleep(0.001)
            started.send_signal(signal.SIGKILL)
        with part.open("a") as cut:
            cut.write('{"path": "half')  # as a write that was cut off
        run(records, robots, part)
        assert part.read_bytes() == whole.read_bytes()
    assert json.loads(whole.read_text().splitlines()[0])["path"].endswith(os.path.join("00000", "robot.urdf"))
