#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The verdicts of smurf-lint on damaged robots, held against what readers did (executed.tsv).

usage: verdicts_test.py CASES [--list READER WHAT]

For each reader are counted, and may not become more than BOUNDS:
  all-clears  we print "loads", with losses or without; it refuses the file or crashes
  alarms      we print "fails to load"; it takes the file
  not-known   we print "not known"
  others      we print no more losses than for the undamaged robot; it makes another robot of a file
              that can mean nothing but the undamaged one
--list prints the cases of one count: --list mujoco alarms.
"""
import argparse
import collections
import json
import pathlib
import sys
import tempfile

import damage
import executed
import robot

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases as drivers  # noqa: E402

TARGETS = {"ros": "urdfdom", "gazebo": "libsdformat", "dart": "DART", "mujoco": "MuJoCo", "pybullet": "Bullet"}
WITH_OBJ = {"drake": "Drake"}  # see executed.with_obj
COUNTS = ("all-clears", "alarms", "not-known", "others")
