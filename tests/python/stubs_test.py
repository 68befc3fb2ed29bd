# SPDX-License-Identifier: BSD-3-Clause
"""The stubs match the module, and the sources compile."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys

import document_stubs
import pytest
import smurf

PACKAGE = pathlib.Path(smurf.__file__).parent
# Bases and names of types that only the stubs have; and what pybind11 makes of every class: a metaclass of
# its own, and an __init__ that accepts all arguments and raises an error. Members are compared despite that.
ALLOWED = r"smurf(\._\w+)?\.[A-Z_]\w+(\.__\w+__)?"


def test_sources_compile(tmp_path):
    environment = {**os.environ, "PYTHONPYCACHEPREFIX": str(tmp_path)}
    subprocess.run([sys.executable, "-m", "compileall", "-q", PACKAGE], check=True, env=environment)
    compile((PACKAGE / "_smurf.pyi").read_text(), "_smurf.pyi", "exec")


def test_names():
    """Every class and attribute of the module is in the stubs."""
    stub = (PACKAGE / "_smurf.pyi").read_text()
    classes = dict(re.findall(r"^class (\w+)(.*?)(?=^class |^def |\Z)", stub, re.M | re.S))
    inherited = "".join(text for name, text in classes.items() if name.startswith("_"))
    for name in smurf.__all__:
        item = getattr(smurf, name)
        if not isinstance(item, type) or name in ("Error", "Urdf"):
            continue
        for member in vars(item):
            if not member.startswith("_"):
                assert f"def {member}(" in classes[name] + inherited, f"{name}.{member}"


def test_docstrings():
    """They are those of the module."""
    stub = (PACKAGE / "_smurf.pyi").read_text()
    assert document_stubs.documented(stub, smurf) == stub, "run document_stubs.py python/smurf/_smurf.pyi"
    assert stub.count('"""') > 300


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="mypy is not installed")
def test_stubs(tmp_path):
    allowed = tmp_path / "allowed"
    allowed.write_text(ALLOWED + "\nsmurf.missing\n")  # the name of an exception, while it is handled
    done = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "--ignore-unused-allowlist", "--allowlist", allowed, "smurf"],
        capture_output=True, text=True, cwd=tmp_path,
        env={**os.environ, "MYPYPATH": str(PACKAGE.parent), "MYPY_CACHE_DIR": str(tmp_path)})
    assert done.returncode == 0, done.stdout + done.stderr


USE = """
import smurf
arm = smurf.load_model("arm.smurf", ignore=["SML1"])
for finding in arm.check():
    print(finding.place.line, finding.message)
limit = arm.joint("elbow").limit
upper: float = 0.0 if limit is None or limit.upper is None else limit.upper
X = arm.forward_kinematics({"elbow": upper})["hand"]
print(X @ X, arm.motors[0].places["joint"].file)
urdf: bytes = arm.to_urdf(prefix="left_")
print([loss.id for loss in arm.to_urdf().losses])
"""


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="mypy is not installed")
def test_use(tmp_path):
    """A correct program has types, and a wrong program causes an error."""
    def mypy(text):
        (tmp_path / "use.py").write_text(text)
        return subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", "use.py"], capture_output=True, text=True, cwd=tmp_path,
            env={**os.environ, "MYPYPATH": str(PACKAGE.parent), "MYPY_CACHE_DIR": str(tmp_path)})
    done = mypy(USE)
    assert done.returncode == 0, done.stdout + done.stderr
    wrong = mypy(USE + "arm.joint(3)\narm.colour\n")
    assert wrong.returncode == 1 and wrong.stdout.count("error:") == 2, wrong.stdout
