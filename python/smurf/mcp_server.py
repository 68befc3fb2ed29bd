# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m smurf mcp [--root FOLDER] [--write FOLDER]: a server of the Model Context Protocol, on standard input.

An assistant checks, explains, converts, compares, weighs and pictures the robots below FOLDER (by default the current
one). Nothing is written unless --write names a folder below which results may be written and files may be fixed.
Needs the package `mcp` (pip install smurf-tools[mcp]).
"""
import argparse
import functools
import pathlib
import shutil
import subprocess
import sys
import tempfile
from typing import List, Optional

SECONDS = 120  # for one call of a program
LONGEST = 100_000  # characters of one answer

INSTRUCTIONS = """Checks robot models (URDF, xacro, SRDF, ros2_control, controllers, MoveIt, SMURF, scenes). Work in a loop: check,
change the file at the line of the first error as its help says, check again. `targets` names the programs that will load the
robot, such as gazebo:harmonic or mujoco; the answer says whether each loads it."""


class Refused(Exception):
    """What the assistant asked for is not allowed, or cannot be done."""


class Folder:
    """What may be read, and where results may be written."""

    def __init__(self, root, writable=None):
        self.root = pathlib.Path(root).resolve()
        self.writable = pathlib.Path(writable).resolve() if writable else None

    def readable(self, path):
        full = (self.root / path).resolve()
        if full != self.root and self.root not in full.parents:
            raise Refused(f"{path} is outside of the folder of this server")
        if not full.exists():
            raise Refused(f"there is no {path}")
        return str(full.relative_to(self.root)) or "."

    def for_output(self, path):
        full = (self.root / path).resolve()
        if self.writable is None:
            raise Refused("this server only reads; start it with --write FOLDER to write results below FOLDER")
        if self.writable not in full.parents:
            raise Refused(f"{path} is outside of the folder for results")
        return str(full)


class Programs:
    """Runs our programs in the folder of the server."""

    def __init__(self, folder, find):
        self.folder = folder
        self.find = find

    def run(self, name, *arguments):
        program = self.find(name)
        if program is None:
            raise Refused(f"the program {name} is not installed")
        try:
            done = subprocess.run([program, *arguments], cwd=self.folder.root, stdin=subprocess.DEVNULL, capture_output=True,
                                  timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired:
            raise Refused(f"{name} was stopped after {SECONDS} s") from None
        return done.returncode, done.stdout, done.stderr.decode(errors="replace")

    def text(self, name, *arguments, codes=(0, 1)):
        code, out, errors = self.run(name, *arguments)
        if code not in codes:
            raise Refused(errors.strip() or f"{name} ended with {code}")
        return out.decode(errors="replace")


def shortened(text):
    if len(text) <= LONGEST:
        return text
    return text[:LONGEST] + f"\n... and {len(text) - LONGEST} characters more: ask for a smaller folder or for one file"


def words_of(targets, arguments):
    words = ["--target", ",".join(targets)] if targets else []
    for name, value in (arguments or {}).items():
        words.append(f"{name}:={value}")
    return words


def checked(programs, path, targets, arguments):
    """The report as JSON; as lines of text where JSON would be too long."""
    words = words_of(targets, arguments)
    path = programs.folder.readable(path)
    text = programs.text("smurf-lint", "--format", "json", *words, "--", path)
    if len(text) <= LONGEST:
        return text
    return shortened(programs.text("smurf-lint", "--format", "concise", *words, "--", path))


def picture_of(programs, path, arguments):
    """(bytes, format): a drawing from above and from the side, as PNG where a program can make one."""
    path = programs.folder.readable(path)
    with tempfile.TemporaryDirectory(prefix="smurf-mcp-") as work:
        svg, png = pathlib.Path(work, "robot.svg"), pathlib.Path(work, "robot.png")
        programs.text("smurfs-flatten", "--format", "svg", "-q", "-o", str(svg), *words_of(None, arguments), "--", path, codes=(0,))
        chromium = shutil.which("chromium") or shutil.which("google-chrome")
        commands = [["rsvg-convert", "--width", "1200", "-o", png, svg]]
        if chromium:
            commands.append([chromium, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1200,900",
                             f"--user-data-dir={work}/profile", f"--screenshot={png}", svg.as_uri()])
        for command in commands:
            if shutil.which(command[0]) is None:
                continue
            subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS, check=False)
            if png.is_file():
                return png.read_bytes(), "png"
        return svg.read_bytes(), "svg+xml"


def make_server(folder, find):
    from mcp.server import MCPServer  # type: ignore[import]
    from mcp.server.mcpserver import Image  # type: ignore[import]
    from mcp.server.mcpserver.exceptions import ToolError  # type: ignore[import]

    programs = Programs(folder, find)
    server = MCPServer("smurf", instructions=INSTRUCTIONS)

    def tool(function):
        """Adds a tool. The assistant sees why a call was refused."""

        @functools.wraps(function)
        def call(*arguments, **named):
            try:
                return function(*arguments, **named)
            except Refused as reason:
                raise ToolError(str(reason)) from None

        return server.tool()(call)

    @tool
    def check(path: str = ".", targets: Optional[List[str]] = None, arguments: Optional[dict] = None) -> str:
        """Check a robot file or a folder. Returns JSON: findings with file, line, help and fixes, and a verdict for each target.
        `arguments` are values for the arguments of a xacro."""
        return checked(programs, path, targets, arguments)

    @tool
    def explain(what: str) -> str:
        """Explain a rule (SML1508) or a key of the format: reason, remedy, what each program does."""
        return shortened(programs.text("smurf-lint", f"--explain={what}"))

    @tool
    def masses(path: str) -> str:
        """Mass, volume, density and radius of gyration of every link."""
        return shortened(programs.text("smurf-lint", f"--masses={folder.readable(path)}"))

    @tool
    def diff(old: str, new: str) -> str:
        """What changed for the robot between two files, as JSON."""
        return shortened(programs.text("smurf-diff", "--format", "json", "--", folder.readable(old), folder.readable(new)))

    @tool
    def convert(path: str, format: str, output: Optional[str] = None) -> str:
        """Convert a robot or a scene: format urdf, mjcf, sdf, usda, dmd, gltf, json, ... Without `output`, returns the text; with
        it, writes the file, if this server may write. Losses come first."""
        target = ["-o", folder.for_output(output)] if output else []
        source = folder.readable(path)
        as_robot = format == "urdf" and not source.endswith((".smurfs", ".smurfa"))
        name, options = ("smurf2urdf", []) if as_robot else ("smurfs-flatten", ["--format", format])
        code, out, errors = programs.run(name, *options, *target, "--", source)
        if code != 0:
            raise Refused(errors.strip())
        return shortened(errors + out.decode(errors="replace"))

    @tool
    def picture(path: str, arguments: Optional[dict] = None) -> Image:
        """A drawing of a robot or scene from above and from the side, with axes and names."""
        data, kind = picture_of(programs, path, arguments)
        return Image(data=data, format=kind)

    if folder.writable is not None:

        @tool
        def fix(path: str, unsafe: bool = False) -> str:
            """Apply the fixes of the findings below the folder for results; `unsafe` includes fixes that guess."""
            options = ["--unsafe-fixes"] if unsafe else []
            return shortened(programs.text("smurf-lint", "--fix", *options, "--", folder.for_output(path)))

    return server


def main(arguments, find):
    parser = argparse.ArgumentParser(prog="python3 -m smurf mcp", description=__doc__.split("\n\n", 1)[1])
    parser.add_argument("--root", default=".", help="the folder whose robots are read")
    parser.add_argument("--write", help="the folder below which results may be written")
    options = parser.parse_args(arguments)
    try:
        server = make_server(Folder(options.root, options.write), find)
    except ImportError:
        print("smurf: the server needs the package `mcp`: pip install smurf-tools[mcp]", file=sys.stderr)
        return 2
    server.run()
    return 0
