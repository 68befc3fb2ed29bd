#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""execute_notebook.py NOTEBOOK: runs its cells and stores what they print, return and draw, as Jupyter does.

Needs matplotlib, and Chromium for the robots in 3D: they are stored as pictures, because sites that show notebooks leave
out frames. PYTHONPATH must lead to the module.
"""
import ast
import base64
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile

os.environ["MPLBACKEND"] = "Agg"
import matplotlib.pyplot as plt  # noqa: E402


def lines(text):
    return text.splitlines(keepends=True)


def picture_of_page(page):
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "page.html").write_text(page)
        subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu-sandbox", "--enable-unsafe-swiftshader", "--use-angle=swiftshader",
             "--hide-scrollbars", "--window-size=900,480", "--virtual-time-budget=8000", "--screenshot=picture.png", "page.html"],
            cwd=folder, check=True, stderr=subprocess.DEVNULL)
        return pathlib.Path(folder, "picture.png").read_bytes()


def data_of(value):
    """What a notebook shows of the value of a cell."""
    data = {"text/plain": lines(repr(value))}
    if hasattr(value, "write"):  # a robot
        data["image/png"] = base64.b64encode(picture_of_page(value.write("html").text)).decode()
    elif getattr(value, "_repr_html_", lambda: None)() is not None:
        data["text/html"] = lines(value._repr_html_())
    return data


def run(code, names):
    """The outputs of a cell."""
    tree = ast.parse(code)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed, outputs = io.StringIO(), []
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines(printed.getvalue())})
    for number in plt.get_fignums():
        file = io.BytesIO()
        plt.figure(number).savefig(file, format="png", dpi=72, metadata={"Software": None})
        outputs.append({"data": {"image/png": base64.b64encode(file.getvalue()).decode()}, "metadata": {}, "output_type": "display_data"})
    plt.close("all")
    if value is not None:
        outputs.append({"data": data_of(value), "metadata": {}, "output_type": "execute_result"})
    return outputs


def execute(path):
    notebook = json.loads(path.read_text())
    os.chdir(path.parent)
    names, count = {}, 0
    for cell in notebook["cells"]:
        if cell["cell_type"] != "code":
            continue
        count += 1
        cell["execution_count"] = count
        cell["outputs"] = run("".join(cell["source"]), names)
        for output in cell["outputs"]:
            if output["output_type"] == "execute_result":
                output["execution_count"] = count
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    execute(pathlib.Path(sys.argv[1]).resolve())
