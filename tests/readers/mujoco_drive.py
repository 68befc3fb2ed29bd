# SPDX-License-Identifier: BSD-3-Clause
"""Runs MuJoCo worlds: mujoco_drive.py [hold=SECONDS] FILE...; prints one line of JSON per file and step.

Holds the start pose, then asks each motor of a position for 0.3 rad, or a tenth of its range, from the start. At the step of
the file and at twice it.
"""
import json
import sys

import mujoco

WARNINGS = (mujoco.mjtWarning.mjWARN_BADQACC, mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL)


def start_of(model):
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    return data


def run(model, data, seconds):
    """False if a value is not a number."""
    for _ in range(int(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
        if any(data.warning[one].number for one in WARNINGS):
            return False
    return True


def way_of(model, joint, position):
    """The way to go from a position: within the range, where the joint has one."""
    if not model.jnt_limited[joint]:
        return 0.3
    low, high = model.jnt_range[joint]
    tenth = 0.1 * (high - low)
    way = tenth if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_SLIDE else min(0.3, tenth)
    return way if position + way <= high else -way


def judge(path, factor, hold):
    model = mujoco.MjModel.from_xml_path(path)
    model.opt.timestep *= factor
    result = {"file": path, "factor": factor, "motors": 0, "missed": {}, "drift": {}, "is_finite": True}
    data = start_of(model)
    first = data.qpos.copy()
    if hold and not run(model, data, hold):
        result["is_finite"] = False
        return result
    for motor in range(model.nu):
        if model.actuator_biasprm[motor, 1] == 0:
            continue  # commands no position
        joint = model.actuator_trnid[motor, 0]
        name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, joint)
        at = model.jnt_qposadr[joint]
        result["motors"] += 1
        result["drift"][name] = abs(data.qpos[at] - first[at])
        moved = start_of(model)
        way = way_of(model, joint, moved.qpos[at])
        moved.ctrl[motor] = moved.qpos[at] + way
        if not run(model, moved, 2):
            result["is_finite"] = False
            return result
        reached = moved.qpos[at] - first[at]
        if abs(reached - way) > 0.02 * abs(way):
            result["missed"][name] = [way, reached]
    return result


def main():
    hold = 0.0
    for argument in sys.argv[1:]:
        if argument.startswith("hold="):
            hold = float(argument.removeprefix("hold="))
            continue
        for factor in (1, 2):
            print(json.dumps(judge(argument, factor, hold)), flush=True)


if __name__ == "__main__":
    main()
