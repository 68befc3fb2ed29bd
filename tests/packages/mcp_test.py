# SPDX-License-Identifier: BSD-3-Clause
"""The server of the Model Context Protocol, driven by the client of the package `mcp`: mcp_test.py BIN_FOLDER

Runs with the Python of build/readers/python, where `scripts/setup --python-readers` has installed that package.
"""
import asyncio
import json
import os
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PYTHON = ROOT / "build/readers/python/bin/python"
ROBOT = """<robot name="arm">
  <link name="base"><inertial><mass value="2"/><inertia ixx="0.3" iyy="0.3" izz="0.3" ixy="0" ixz="0" iyz="0"/></inertial><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="forearm"/>
  <joint name="elbow" type="fixed"><parent link="base"/><child link="foream"/></joint>
</robot>
"""


async def text_of(client, tool, **arguments):
    """(whether it is an error, the text)"""
    answer = await client.call_tool(tool, arguments)
    return answer.is_error, "".join(part.text for part in answer.content if part.type == "text")


async def talk(binaries, folder, *options):
    from mcp import Client, StdioServerParameters
    from mcp.client.stdio import stdio_client

    parameters = StdioServerParameters(
        command=sys.executable, args=["-m", "smurf", "mcp", "--root", str(folder), *options],
        env={"PYTHONPATH": str(ROOT / "python"), "PATH": f"{binaries}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1"})
    async with Client(stdio_client(parameters)) as client:
        return await (writing if options else reading)(client, folder)


async def reading(client, folder):
    tools = {tool.name for tool in (await client.list_tools()).tools}
    assert tools == {"check", "explain", "masses", "diff", "convert", "picture"}, tools
    failed, text = await text_of(client, "check", path="arm.urdf", targets=["ros", "mujoco"])
    report = json.loads(text)
    assert not failed and any("foream" in one["message"] for one in report["diagnostics"]), text
    (folder / "fixed.urdf").write_text(ROBOT.replace("foream", "forearm"))
    failed, text = await text_of(client, "check", path="fixed.urdf")
    assert not failed and not [one for one in json.loads(text)["diagnostics"] if one["severity"] == "error"], text
    assert "SML1204" in (await text_of(client, "explain", what="SML1204"))[1]
    assert "mass kg" in (await text_of(client, "masses", path="fixed.urdf"))[1]
    failed, text = await text_of(client, "diff", old="arm.urdf", new="fixed.urdf")
    assert not failed and json.loads(text), text
    failed, text = await text_of(client, "convert", path="fixed.urdf", format="mjcf")
    assert not failed and "<mujoco" in text, text
    picture = (await client.call_tool("picture", {"path": "fixed.urdf"})).content[0]
    assert picture.type == "image" and len(picture.data) > 1000, picture
    for tool, arguments, reason in (("check", {"path": "../outside.urdf"}, "outside of the folder"),
                                    ("check", {"path": "/etc/passwd"}, "outside of the folder"),
                                    ("check", {"path": "absent.urdf"}, "there is no absent.urdf"),
                                    ("check", {"path": "arm.urdf", "targets": ["rosx"]}, "no target 'rosx'"),
                                    ("convert", {"path": "fixed.urdf", "format": "mjcf", "output": "a.xml"}, "only reads")):
        failed, text = await text_of(client, tool, **arguments)
        assert failed and reason in text, (tool, arguments, text)
    assert sorted(path.name for path in folder.iterdir()) == ["arm.urdf", "fixed.urdf"]


async def writing(client, folder):
    failed, text = await text_of(client, "fix", path="arm.urdf", unsafe=True)
    assert not failed and (folder / "arm.urdf").read_text() == ROBOT.replace("foream", "forearm"), text
    failed, text = await text_of(client, "convert", path="arm.urdf", format="mjcf", output="arm.xml")
    assert not failed and (folder / "arm.xml").is_file(), text
    failed, text = await text_of(client, "convert", path="arm.urdf", format="mjcf", output="../arm.xml")
    assert failed and "outside" in text, text


def main():
    try:
        import mcp  # noqa: F401
    except ImportError:
        if PYTHON.is_file() and pathlib.Path(sys.prefix).resolve() != PYTHON.parents[1].resolve():
            os.execv(PYTHON, [str(PYTHON), *sys.argv])
        print("skipped: the package mcp is not installed; scripts/setup --python-readers installs it")
        return 77
    binaries = pathlib.Path(sys.argv[1]).resolve()
    for options in ([], ["--write"]):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name).resolve()
            (folder / "arm.urdf").write_text(ROBOT)
            asyncio.run(talk(binaries, folder, *options, *([name] if options else [])))
    print("the client checked, explained, weighed, compared, converted, pictured and fixed a robot")
    return 0


if __name__ == "__main__":
    sys.exit(main())
