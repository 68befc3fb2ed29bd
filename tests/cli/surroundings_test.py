# SPDX-License-Identifier: BSD-3-Clause
"""Are the faults of small packages with one fault each found, and their cured twins calm?

usage: surroundings_test.py SMURF_LINT SHARED    cases: SHARED/surroundings; skipped without them
"""
import pathlib
import re
import subprocess
import sys
import os

LEAST_FOUND = 109
MOST_ALARMS = 0


def main():
    tool, shared = map(pathlib.Path, sys.argv[1:3])
    runner = shared / "surroundings" / "run.py"
    if not runner.exists():
        print(f"skipped: {runner} is not there")
        sys.exit(77)
    done = subprocess.run([sys.executable, str(runner), "--list"], capture_output=True, text=True,
                          env=dict(os.environ, BIN=str(tool.resolve().parent)))
    rows = re.findall(r"(?m)^(\d+) \d (found|MISSED) (calm|ALARM)", done.stdout)
    found = sum(row[1] == "found" for row in rows)
    alarms = [row[0] for row in rows if row[2] == "ALARM"]
    print(f"{found} of {len(rows)} found, alarms in {alarms}")
    assert len(rows) >= 100, done.stdout + done.stderr
    assert found >= LEAST_FOUND, [row[0] for row in rows if row[1] == "MISSED"]
    assert len(alarms) <= MOST_ALARMS, alarms


main()
