# SPDX-License-Identifier: BSD-3-Clause
"""The notebook and the examples of the documentation run unchanged; the notebook has its outputs."""
import json
import os
import pathlib
import re
import subprocess
import sys

import inputs
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(code, folder):
    return subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, timeout=600,
                          env={**os.environ, "MPLBACKEND": "Agg", "MPLCONFIGDIR": str(folder)})


def test_notebook(tmp_path):
    pytest.importorskip("matplotlib")
    notebook = json.loads((ROOT / "python/examples/robots.ipynb").read_text())
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert all(cell["outputs"] for cell in cells)  # execute_notebook.py writes them
    pictures = [output["data"]["image/png"] for cell in cells for output in cell["outputs"] if "image/png" in output.get("data", {})]
    assert len(pictures) >= 3 and all(len(picture) > 10_000 for picture in pictures)
    printed = [text for cell in cells for output in cell["outputs"] for text in output.get("text", [])]
    code = "\n".join("".join(cell["source"]) for cell in cells)
    code = code.replace("../../fixtures", str(inputs.FIXTURES))
    done = run(code + "\nfigure.savefig('scene.png')\n", tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == "".join(printed)
    assert (tmp_path / "scene.png").stat().st_size > 10_000


def test_documentation(tmp_path):
    """The programs of docs/python.md and the README, on the files they name."""
    pages = [(ROOT / page).read_text() for page in ("docs/python.md", "README.md")]
    programs = [program.replace('"arm.smurf"', repr(str(inputs.ARM)))
                for page in pages for program in re.findall(r"```python\n(.*?)```", page, re.S)]
    assert len(programs) >= 4
    for program in programs:
        done = run(program, inputs.FIXTURES)
        assert done.returncode == 0, program + done.stderr
        assert len(program.splitlines()) <= 24
