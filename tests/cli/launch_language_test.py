# SPDX-License-Identifier: BSD-3-Clause
"""Does smurf-lint see in launch files what launch says when it executes them? (fixtures/launch/language.tsv)

usage: launch_language_test.py SMURF_LINT

Each row is a launch file in a package with a robot. A row that launch executes must have no finding of SML4213 or SML4202;
a row at which launch raises an error must have one, unless the table says why it is not seen.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

TABLE = pathlib.Path(__file__).resolve().parent.parent.parent / "fixtures" / "launch" / "language.tsv"
A_FOLDER = 50  # the linter looks at 60 launch files around a robot
PACKAGE = """<package format="3"><name>bot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">A</maintainer><license>BSD</license><buildtool_depend>ament_cmake</buildtool_depend>
<exec_depend>rviz2</exec_depend><export><build_type>ament_cmake</build_type></export></package>
"""
PYTHON = """import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import (DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription, LogInfo, OpaqueFunction,
                            SetEnvironmentVariable, SetLaunchConfiguration, TimerAction)
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('a', default_value='x'),
        %s,
    ])
"""
WHOLE = {"py": PYTHON, "xml": "<launch>%s</launch>\n", "yaml": "launch:\n%s\n"}


def rows():
    for line in TABLE.read_text().splitlines():
        if line.startswith("#"):
            continue
        form, text, answer, *unseen = line.split("\t")
        yield form, text.replace("\\n", "\n").replace("\\\\", "\\"), answer, bool(unseen)


def found_in(tool, chosen):
    """The messages of each of these rows."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "launch").mkdir()
        (folder / "package.xml").write_text(PACKAGE)
        (folder / "robot.urdf").write_text('<robot name="r"><link name="a"/></robot>\n')
        for i, (form, text, _, _) in enumerate(chosen):
            (folder / "launch" / f"f{i:03}.launch.{form}").write_text(WHOLE[form] % text)
        run = subprocess.run([tool, "--isolated", "--format", "json", "--select", "SML4213,SML4202", "."], cwd=folder,
                             capture_output=True, text=True)
        assert run.returncode in (0, 1), run.stdout + run.stderr
        messages = [[] for _ in chosen]
        for one in json.loads(run.stdout)["diagnostics"]:
            messages[int(pathlib.Path(one["file"]).name[1:4])].append(one["message"])
        return messages


def main():
    table = list(rows())
    assert len(table) > 150, f"the table has only {len(table)} rows"
    wrong = []
    for begin in range(0, len(table), A_FOLDER):
        chosen = table[begin:begin + A_FOLDER]
        for (form, text, answer, unseen), messages in zip(chosen, found_in(sys.argv[1], chosen)):
            if bool(messages) != (answer != "-" and not unseen):
                wrong.append(f"{form}: {text}\n  launch: {answer}; smurf-lint: {messages or '-'}")
    assert not wrong, "\n".join([f"{len(wrong)} of {len(table)} rows differ:", *wrong])
    print(f"{len(table)} launch files, {sum(row[2] != '-' for row in table)} of them with an error")


main()
