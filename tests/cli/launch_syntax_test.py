# SPDX-License-Identifier: BSD-3-Clause
"""Is a launch file in Python that SML4213 calls broken one that Python does not parse?

usage: launch_syntax_test.py SMURF_LINT SHARED    own launch files; with SHARED, those of its workspaces, too

One bracket or quote is taken out of each file at a time, or doubled. Python's own parser is the judge: never a finding
where it parses, and nearly always one where a bracket or a text does not end.
"""
import ast
import json
import pathlib
import random
import subprocess
import sys
import tempfile

FIXTURES = pathlib.Path(__file__).resolve().parent.parent.parent / "fixtures"
A_FOLDER = 50  # the linter looks at 60 launch files around a robot
PACKAGE = """<package format="3"><name>bot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">A</maintainer><license>BSD</license><buildtool_depend>ament_cmake</buildtool_depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
OWN = """from launch import LaunchDescription
ROBOT = r'C:\\robots'
TEXT = '''a ( in
a long text'''
LONG = 'one \\
line'
WORDS = {"left": [1, (2, 3)], 'right': "it's"}
def generate_launch_description():
    # a comment with ( and '
    name = f"{WORDS['left'][0]}{{" + f'{WORDS}'
    return LaunchDescription([x for x in (1, 2)])
"""


def parses(text):
    try:
        ast.parse(text)
        return True
    except (SyntaxError, ValueError):
        return False


def variants(text, number, chance):
    """The text, and copies of it with one bracket or quote less, or one more."""
    places = [i for i, c in enumerate(text) if c in "()[]{}'\""]
    yield text
    yield text.replace("\n", "\r\n")
    for at in chance.sample(places, min(number, len(places))):
        yield text[:at] + text[at + 1:]
        yield text[:at] + text[at] + text[at:]


def reported(tool, texts):
    """Which of the texts have a finding SML4213."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "package.xml").write_text(PACKAGE)
        (folder / "robot.urdf").write_text('<robot name="r"><link name="a"/></robot>\n')
        (folder / "launch").mkdir()
        for i, text in enumerate(texts):
            (folder / f"launch/f{i:03}.launch.py").write_bytes(text.encode())
        done = subprocess.run([tool, "--format", "json", "."], cwd=folder, capture_output=True, text=True)
        found = json.loads(done.stdout)["diagnostics"]
        return {int(one["file"][len("launch/f"):][:3]) for one in found if one["id"] == "SML4213"}


def main():
    tool = str(pathlib.Path(sys.argv[1]).resolve())
    shared = pathlib.Path(sys.argv[2])
    chance = random.Random(4213)
    sources = [OWN] + [p.read_text() for p in sorted(FIXTURES.glob("rules/**/SML42*/good/launch/*.py"))]
    others = sorted(shared.glob("workspaces/*/**/*.launch.py")) if shared.is_dir() else []
    if not others:
        print(f"{shared}: no workspaces there; own launch files only")
    sources += [p.read_text(errors="replace") for p in chance.sample(others, min(60, len(others)))]
    texts = list(dict.fromkeys(one for text in sources for one in variants(text, 12, chance)))
    refused = missed = 0
    for i in range(0, len(texts), A_FOLDER):
        part = texts[i:i + A_FOLDER]
        found = reported(tool, part)
        for j, text in enumerate(part):
            if parses(text):
                assert j not in found, f"Python parses this, and SML4213 is reported:\n{text}"
            else:
                refused += 1
                missed += j not in found
    print(f"{len(texts)} files, {refused} that Python does not parse, {missed} of them without a finding")
    assert refused > 100 and missed <= 0.1 * refused


main()
