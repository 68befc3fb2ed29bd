# SPDX-License-Identifier: BSD-3-Clause
"""Model.to_urdf() gives the bytes that smurf2urdf writes."""
import inputs
import pytest
import smurf

OPTIONS = [
    ([], {}),
    (["--prefix", "left_"], {"prefix": "left_"}),
    (["--mesh-uri", "absolute"], {"mesh_uri": "absolute"}),
    (["--mesh-uri", "file"], {"mesh_uri": "file"}),
    (["--mesh-uri", "keep", "--comments", "strip"], {"mesh_uri": "keep", "strip_comments": True}),
    (["--canonical"], {"canonical": True}),
    (["--collapse-fixed"], {"collapse_fixed": True}),
    (["--base", "fixed", "--vendor", "strip"], {"base": "fixed", "strip_extensions": True}),
    (["--apply", "materials,limits,dynamics"], {"apply": ["materials", "limits", "dynamics"]}),
]


@pytest.mark.parametrize("options, keywords", OPTIONS)
def test_models(options, keywords, tmp_path):
    compared = 0
    for path in sorted(inputs.FIXTURES.glob("models/**/*.smurf")):
        done = inputs.run("smurf2urdf", *options, path, cwd=tmp_path)
        assert done.returncode == 0, done.stderr.decode()
        with pytest.MonkeyPatch.context() as patch:
            patch.chdir(tmp_path)
            assert smurf.load_model(path).to_urdf(**keywords) == done.stdout
        compared += 1
    assert compared >= 2


def test_rules():
    """Both refuse the same models, and export the others alike."""
    exported = refused = 0
    for path in inputs.fixtures():
        if path.suffix != ".smurf":
            continue
        done = inputs.run("smurf2urdf", path)
        try:
            urdf = smurf.load_model(path).to_urdf()
        except (smurf.Error, ValueError):
            assert done.returncode != 0, path
            refused += 1
            continue
        assert done.returncode == 0, path
        assert urdf == done.stdout, path
        exported += 1
    assert exported > 200 and refused > 5


def test_output_folder(tmp_path):
    done = inputs.run("smurf2urdf", inputs.ARM, "-o", tmp_path / "out.urdf")
    assert done.returncode == 0
    assert smurf.load_model(inputs.ARM).to_urdf(output_folder=tmp_path) == (tmp_path / "out.urdf").read_bytes()


def test_force():
    path = inputs.FIXTURES / "rules/SML3101-unknown-joint/bad/model.smurf"
    model = smurf.load_model(path)
    assert model.to_urdf() == inputs.run("smurf2urdf", path).stdout  # it needs no motors
    with pytest.raises(smurf.Error) as raised:
        model.to_urdf(apply=["limits"])
    assert {finding.id for finding in raised.value.findings} == {"SML3101"}
    assert model.to_urdf(apply=["limits"], force=True) == inputs.run(
        "smurf2urdf", "--force", "--apply", "limits", path).stdout


@pytest.mark.parametrize("keywords", [
    {"mesh_uri": "package"}, {"base": "loose"}, {"apply": ["colours"]}, {"keep": ["no such link"]},
])
def test_wrong_values(keywords):
    with pytest.raises(ValueError):
        smurf.load_model(inputs.ARM).to_urdf(**keywords)


@pytest.mark.parametrize("keywords", [{"prefix": 1}, {"canonical": "yes"}, {"colour": True}, {"keep": 1}])
def test_wrong_types(keywords):
    with pytest.raises(TypeError):
        smurf.load_model(inputs.ARM).to_urdf(**keywords)
