# SPDX-License-Identifier: BSD-3-Clause
"""What MuJoCo builds of an MJCF that was a SMURF model in between, compared with what it built of the first file.

rebuilt_mjcf.py RECORDER FILE...    prints what MuJoCo builds of each file, as one line of JSON; RECORDER is the folder
of record.py
"""
import collections
import json
import math
import sys


def key(name, prefix=""):
    return name.removeprefix(prefix) if name else name


def near(a, b, tolerance=1e-6):
    if a is None or b is None:
        return a is b
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(near(x, y, tolerance) for x, y in zip(a, b))
    return math.isclose(a, b, rel_tol=tolerance, abs_tol=tolerance)


def touching(truth, prefix=""):
    """By body: the sliding frictions of the shapes that touch others."""
    found = collections.defaultdict(list)
    for one in truth["geoms"]:
        body = truth["bodies"][one["body"]]["name"]
        if (one["contype"] or one["conaffinity"]) and body:
            found[key(body, prefix)].append(one["friction"][0])
    return {body: sorted(numbers) for body, numbers in found.items()}


def servo(one, most=None):
    """Stiffness and damping about its joint, and the range of its force there, at most that of the joint; None: another
    kind of actuator."""
    gear = one["gear"][0]
    if one["transmission"] != "joint" or not gear or one["dynamics_type"]:
        return None
    if one["bias_type"] == 0:
        kind, stiffness, damping = "force", 0, 0
    elif one["bias_type"] == 1 and one["gain"][0] == -one["bias"][1]:
        kind, stiffness, damping = "position", one["gain"][0] * gear ** 2, -one["bias"][2] * gear ** 2
    elif one["bias_type"] == 1 and one["gain"][0] == -one["bias"][2] and not one["bias"][1]:
        kind, stiffness, damping = "velocity", 0, one["gain"][0] * gear ** 2
    else:
        return None
    force, control = one["force_range"], one.get("control_range")
    if kind == "force" and control:  # the larger command is cut
        ranged = [x * gear * one["gain"][0] for x in control]
        force = [max(ranged[0], force[0] * gear), min(ranged[1], force[1] * gear)] if force else ranged
    elif force:
        force = [x * gear for x in force]
    if most:
        force = [max(most[0], min(force)), min(most[1], max(force))] if force else most
    command = [x / gear for x in control] if control and kind == "position" else None
    return kind, stiffness, damping, sorted(force) if force else None, sorted(command) if command else None


# SMURF has these.
SENSORS = {"accelerometer", "gyro", "force", "torque", "touch", "rangefinder", "jointpos", "jointvel", "actuatorfrc",
           "jointactuatorfrc", "framepos", "framequat", "framelinvel", "frameangvel"}


def sensors(truth):
    found = collections.Counter(one["type"].lstrip("_") for one in truth["sensors"])
    found["actuatorfrc"] += found.pop("jointactuatorfrc", 0)
    return found


def differences(truth, again, prefix):
    """(aspect, what); `prefix` is before the names of the second one."""
    out = []
    joints = {key(one["name"], prefix): one for one in again["joints"] if one["name"]}
    for one in truth["joints"]:
        other = joints.get(one["name"])
        if other is None or one["type"] not in ("hinge", "slide"):
            continue
        for what in ("armature", "stiffness", "springref", "frictionloss", "damping"):
            if what == "springref" and not one["stiffness"]:
                continue
            if not near(one[what], other[what]):
                out.append((what, f"{one['name']}: {other[what]}, not {one[what]}"))
    found = {key(one["target"], prefix): one for one in again["actuators"]}
    driven = collections.Counter(one["target"] for one in truth["actuators"])
    most = {one["name"]: one["actuator_force_range"] for one in truth["joints"]}
    for one in truth["actuators"]:
        first = servo(one, most.get(one["target"]))
        if first is None or driven[one["target"]] > 1:
            continue
        other = found.get(one["target"])
        second = servo(other) if other else None
        if second is None:
            out.append(("actuator", f"{one['target']}: none"))
        elif first[0] != second[0]:
            out.append(("actuator", f"{one['target']}: of {second[0]}, not {first[0]}"))
        else:
            for what, a, b in zip(("stiffness", "damping", "force", "command"), first[1:], second[1:]):
                if not near(a, b):
                    out.append((f"actuator {what}", f"{one['target']}: {b}, not {a}"))
    before, after = sensors(truth), sensors(again)
    for kind in sorted(SENSORS):
        if after[kind] < before[kind]:
            out.append(("sensor", f"{kind}: {after[kind]}, not {before[kind]}"))
    if len(again["keyframes"]) < len(truth["keyframes"]):
        out.append(("keyframe", f"{len(again['keyframes'])}, not {len(truth['keyframes'])}"))
    first, second = touching(truth), touching(again, prefix)
    for body, frictions in first.items():
        is_whole = len(frictions) == len(second.get(body, []))  # otherwise shapes are lost, which is said
        if is_whole and not near(frictions, second[body]):
            out.append(("friction", f"{body}: {second[body]}, not {frictions}"))
    return out


def main():
    sys.path.insert(0, sys.argv[1])
    import record  # noqa: E402
    for file in sys.argv[2:]:
        print(json.dumps(record.mjcf_truth(file, True)))


if __name__ == "__main__":
    main()
