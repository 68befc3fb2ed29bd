# SPDX-License-Identifier: BSD-3-Clause
"""smurf.check() reports the same findings as smurf-lint, with the same words and in the same order."""
import json

import inputs
import pytest
import smurf


def lines(output):
    """Findings of `--format concise`, without the summary."""
    return [line for line in output.decode(errors="replace").splitlines() if "[SML" in line]


def differences(files):
    found = 0
    faults = []
    for path in files:
        expected = lines(inputs.run("smurf-lint", "--format", "concise", path).stdout)
        actual = [str(finding) for finding in smurf.check(path)]
        found += len(expected)
        if actual != expected:
            faults.append("\n".join([f"{path}: Python", *actual, "smurf-lint", *expected]))
    return faults, found


def test_fixtures():
    faults, found = differences(inputs.fixtures())
    assert not faults, "\n\n".join(faults[:5])
    assert found > 300


def test_loaded_models_and_scenes():
    """Loads and then checks, twice."""
    for path in inputs.fixtures():
        load = smurf.load_scene if inputs.is_scene(path) else smurf.load_model
        # What was loaded has no companions, such as SRDFs (SML35, SML37 and SML38), no plugins.xml (SML3616), and no package
        # around it: unused meshes (SML1666), launch files (SML3907, SML42), what is installed (SML44) and the files that name
        # its frames (SML45).
        expected = [str(finding) for finding in smurf.check(path)
                    if finding.id[:5] not in ("SML35", "SML37", "SML38", "SML42", "SML44", "SML45")
                    and finding.id not in ("SML1666", "SML3907") and "] the package " not in str(finding)]
        try:
            loaded = load(path)
        except smurf.Error as error:
            assert set(map(str, error.findings)) <= set(expected), path
            continue
        for _ in range(2):
            assert [str(finding) for finding in loaded.check()] == expected, path


def test_targets():
    path = inputs.FIXTURES / "rules/SML1604-mesh-missing/bad"
    path = next(p for p in (path / "model.smurf", path / "robot.urdf") if p.exists())
    done = inputs.run("smurf-lint", "--target", "ros,mujoco", "--format", "json", path)
    expected = json.loads(done.stdout)
    report = smurf.check(path, targets=["ros", "mujoco"])
    actual = json.loads(report.to_json())
    actual.pop("tool"), expected.pop("tool")
    assert actual == expected
    assert [verdict.target for verdict in report.targets] == ["ros", "mujoco"]


def test_json_report():
    for path in inputs.fixtures()[::7]:
        expected = json.loads(inputs.run("smurf-lint", "--format", "json", path).stdout)
        report = smurf.check(path)
        actual = json.loads(report.to_json())
        actual.pop("tool"), expected.pop("tool")
        assert actual == expected, path
        for finding, entry in zip(report, actual["diagnostics"]):
            assert finding.id == entry["id"] and finding.name == entry["name"]
            assert finding.severity == entry["severity"] and finding.message == entry["message"]
            place = finding.place
            assert (place.line, place.column) == (entry["line"], entry["column"])
            assert (place.end_line, place.end_column) == (entry["end_line"], entry["end_column"])
            assert place.file == entry["file"]
            assert finding.notes == entry.get("notes", [])
            assert finding.help == entry.get("help", "")
            if finding.fix:
                assert finding.fix["is_safe"] == (entry["fix"]["applicability"] == "safe")
                assert finding.fix["edits"] == entry["fix"]["edits"]


@pytest.mark.parametrize("options, keywords", [
    (["--ignore", "SML1"], {"ignore": "SML1"}),
    (["--select", "SML3,SML4"], {"select": ["SML3", "SML4"]}),
    (["--severity", "SML3=warning"], {"severities": {"SML3": "warning"}}),
    (["--allow-outside"], {"allow_outside": True}),
    (["--isolated", "--no-ignores"], {"isolated": True, "no_ignores": True}),
])
def test_options(options, keywords):
    for path in inputs.fixtures()[::11]:
        expected = lines(inputs.run("smurf-lint", "--format", "concise", *options, path).stdout)
        assert [str(finding) for finding in smurf.check(path, **keywords)] == expected, path


def test_unsaved_texts(tmp_path):
    session = smurf.Session()
    path = tmp_path / "arm.urdf"
    session.set_text(path, '<robot name="a"><link name="l"/></robot>')
    before = [finding.id for finding in session.check(path)]
    session.set_text(path, '<robot name="a"><link name="l"/><link name="l"/></robot>')
    after = [finding.id for finding in session.check(path)]
    assert len(after) > len(before)
    session.set_text(path, '<robot name="a"><link name="l"/></robot>')
    assert [finding.id for finding in session.check(path)] == before
    session.clear_text(path)
    assert [finding.id for finding in session.check(path)] == ["SML0001"]
