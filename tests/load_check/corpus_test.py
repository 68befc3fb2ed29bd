# SPDX-License-Identifier: BSD-3-Clause
"""Real models and scenes that nobody here wrote: a verdict for each, in time, and always the same.

Whether a model is sound is also judged here, by other means than the tool's: sound ones pass all
stages, and what the tool says in BUILD and STILL of the others agrees.

usage: corpus_test.py SMURF-LOAD-CHECK CORPUS; exits with 77 (skipped) without that folder.
"""
import collections
import json
import math
import pathlib
import resource
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

SUFFIXES = (".smurf", ".smurfs", ".smurfa", ".urdf")
MOST_SECONDS = 30  # s of processor time: the tool ends stages after 10, and has to read the files, on any machine
SLOW = 2  # s of processor time, above which a model is not run again
MOVING = ("revolute", "continuous", "prismatic", "floating", "planar")
NO_FIGURES = {"SML6001", "SML6002"}
# In DROP, these three have no verdict: an assertion of ODE fails in dxLDLTRemove(), and 10 s are not enough.
KNOWN = {("nao.urdf", "SML6001"), ("tiago.urdf", "SML6002"), ("tiago_dual.urdf", "SML6002")}
# Rules that must not fire for a model with sound links and limits; overlaps are separate faults.
OF_FAULTS = {"SML1501", "SML1502", "SML1504", "SML1508", "SML1509", "SML1511", "SML1512", "SML1513",
             "SML6301", "SML6302", "SML6401", "SML6402"}


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def check(tool, path):
    begin = processor_time()
    done = subprocess.run([tool, "--format", "json", path.name], cwd=path.parent,
                          capture_output=True, check=False)
    return done, processor_time() - begin


def principal_moments(inertia):
    """Eigenvalues of a symmetric 3 x 3 matrix, by the trigonometric formula; ascending."""
    xx, xy, xz, yy, yz, zz = inertia
    off = xy * xy + xz * xz + yz * yz
    mean = (xx + yy + zz) / 3
    spread = math.sqrt(((xx - mean) ** 2 + (yy - mean) ** 2 + (zz - mean) ** 2 + 2 * off) / 6)
    if spread == 0:
        return [mean] * 3
    a, b, c = (xx - mean) / spread, (yy - mean) / spread, (zz - mean) / spread
    d, e, f = xy / spread, xz / spread, yz / spread
    half = (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)) / 2
    angle = math.acos(max(-1.0, min(1.0, half))) / 3
    high = mean + 2 * spread * math.cos(angle)
    low = mean + 2 * spread * math.cos(angle + 2 * math.pi / 3)
    return [low, 3 * mean - high - low, high]


def faults(path):
    """The faults of the masses and limits of a URDF, link by link; None if this test cannot judge
    the robot."""
    try:
        robot = ElementTree.parse(path).getroot()
    except ElementTree.ParseError:
        return None
    joints = robot.findall("joint")
    if robot.tag != "robot" or not robot.findall("link"):
        return None
    found = collections.Counter()
    try:
        for link in robot.findall("link"):
            inertial = link.find("inertial")
            above = [j for j in joints if j.find("child").get("link") == link.get("name")]
            if inertial is None:
                found["no inertial"] += bool(above and above[0].get("type") in MOVING)
                continue
            mass = float(inertial.find("mass").get("value"))
            inertia = inertial.find("inertia")
            low, middle, high = principal_moments(
                [float(inertia.get("i" + k)) for k in ("xx", "xy", "xz", "yy", "yz", "zz")])
            found["mass"] += not mass > 0
            found["inertia"] += not low > 1e-12 * high
            found["triangle"] += high > (low + middle) * 1.005
        for joint in joints:
            limit = joint.find("limit")
            if joint.get("type") in ("revolute", "prismatic") and limit is not None:
                lower, upper = float(limit.get("lower", 0)), float(limit.get("upper", 0))
                offset = 0.0
                if joint.find("mimic") is not None:
                    offset = float(joint.find("mimic").get("offset", 0))
                found["limits"] += not lower <= offset <= upper
    except (AttributeError, TypeError, ValueError):
        return None
    return +found


def judge(path, report):
    """Disagreements of the tool with faults()."""
    found = {d["id"] for d in report["diagnostics"]}
    own = faults(path)
    if own is None or not all(c["stages"] for c in report["checks"]):
        return "unjudged", []
    wrong = [f"{rule}: no figures" for rule in sorted(found & NO_FIGURES) if (path.name, rule) not in KNOWN]
    if set(own) == {"limits"}:
        # It starts at the nearest allowed position, so that joints do not jump.
        wrong += [f"{s['stage']} {s['verdict']} though only zero is outside limits"
                  for c in report["checks"] for s in c["stages"]
                  if s["stage"] in ("STILL", "HANG") and s["verdict"] in ("fail", "skipped", "none")]
    if own:
        return "faulty", wrong
    wrong += [f"{rule} on a sound model" for rule in sorted(found & OF_FAULTS)]
    if "SML6501" not in found:
        wrong += ["fails" for c in report["checks"] if c["verdict"] == "fail"]
    return "overlapping" if found & {"SML6201", "SML6501"} else "sound", wrong


def main(tool, folder):
    corpus = pathlib.Path(folder)
    if not corpus.is_dir():
        print(f"skipped: there is no corpus in {corpus}")
        return 77
    failures, times = [], []
    verdicts, rules, kinds = (collections.Counter() for _ in range(3))
    for path in sorted(p for p in corpus.rglob("*") if p.suffix.lower() in SUFFIXES):
        name = path.relative_to(corpus)
        done, seconds = check(tool, path)
        times.append((seconds, str(name)))
        try:
            report = json.loads(done.stdout)
        except ValueError:
            report = None
        if done.returncode not in (0, 1) or report is None or not report["checks"]:
            failures.append(f"{name}: exit {done.returncode}, {done.stderr[:200]}")
            continue
        if seconds > MOST_SECONDS:
            failures.append(f"{name}: {seconds:.1f} s of processor time")
        if seconds < SLOW and check(tool, path)[0].stdout != done.stdout:
            failures.append(f"{name}: two runs differ")
        rules.update({d["id"] for d in report["diagnostics"]})
        verdicts.update(c["verdict"] if c["stages"] else "not run" for c in report["checks"])
        if path.suffix.lower() == ".urdf":
            kind, wrong = judge(path, report)
            kinds[kind] += 1
            failures += [f"{name}: {what}" for what in wrong]
    print(f"{len(times)} files, verdicts {dict(verdicts)}")
    print(f"URDFs as judged here: {dict(kinds)}")
    times.sort()
    print(f"processor time: median {times[len(times) // 2][0]:.2f} s, "
          f"slowest {times[-1][0]:.1f} s ({times[-1][1]})")
    print("files by rule:", dict(sorted(rules.items())))
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
