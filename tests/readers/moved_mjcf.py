# SPDX-License-Identifier: BSD-3-Clause
"""Moves an MJCF, and what it is after it was a SMURF model, for a second with the same commands, and compares what MuJoCo
measures. Contacts are off, since SMURF has no settings for those of MuJoCo; the settings of the solver are those of the first
file, since a robot has none.

moved_mjcf.py RECORDER FIRST WRITTEN PREFIX...    prints one line of JSON for each three; RECORDER is the folder of record.py,
PREFIX is before the names of the written file
"""
import json
import random
import sys

import mujoco
import numpy as np

SENSORS = {"accelerometer", "gyro", "force", "torque", "rangefinder", "jointpos", "jointvel", "actuatorfrc", "jointactuatorfrc",
           "framepos", "framequat", "framelinvel", "frameangvel"}
SAME_OPTIONS = ("timestep", "integrator", "cone", "jacobian", "solver",
                "noslip_iterations", "impratio", "disableflags", "enableflags", "density", "viscosity")


def names(model, kind, count):
    return [mujoco.mj_id2name(model, kind, i) or "" for i in range(count)]


def paired(one, other, prefix):
    """Indices of the joints of both, by name; a free joint by that of its body. None if one of them has no partner."""
    def keys(model, prefix):
        joints = names(model, mujoco.mjtObj.mjOBJ_JOINT, model.njnt)
        bodies = names(model, mujoco.mjtObj.mjOBJ_BODY, model.nbody)
        return [(bodies[model.jnt_bodyid[i]] if model.jnt_type[i] == 0 else joints[i]).removeprefix(prefix) or f"joint_{i}"
                for i in range(model.njnt)]
    found = {key: i for i, key in enumerate(keys(other, prefix))}
    first = keys(one, "")
    if any(key not in found for key in first):
        return None
    return [(i, found[key]) for i, key in enumerate(first)]


def command(one, two, joints, data, other):
    """Commands within the ranges of the actuators; a motor of SMURF is commanded with what its joint does or feels."""
    numbers = random.Random(1)
    driven = {int(two.actuator_trnid[v][0]): v for v in range(two.nu)}
    for u in range(one.nu):
        low, high = one.actuator_ctrlrange[u] if one.actuator_ctrllimited[u] else (-1, 1)
        data.ctrl[u] = (low + high) / 2 + (high - low) / 4 * numbers.uniform(-1, 1)
        v = driven.get(joints.get(int(one.actuator_trnid[u][0])))
        if v is None or one.actuator_trntype[u] > 1:
            continue
        gear = one.actuator_gear[u][0]
        is_force = one.actuator_biastype[u] == 0
        other.ctrl[v] = data.ctrl[u] * (gear * one.actuator_gainprm[u][0] if is_force else 1 / gear)


def measured(model, data):
    found = {}
    for s in range(model.nsensor):
        kind = mujoco.mjtSensor(int(model.sensor_type[s])).name.removeprefix("mjSENS_").lower()
        if kind not in SENSORS:
            continue
        value = data.sensordata[model.sensor_adr[s]:model.sensor_adr[s] + model.sensor_dim[s]].copy()
        if kind == "framequat" and value[np.argmax(abs(value))] < 0:
            value = -value
        found.setdefault(kind.removeprefix("joint") if kind == "jointactuatorfrc" else kind, []).append(value)
    return found


def compared(one, two, prefix):
    """The kinds of sensors that measure something else at the start, by number; and the largest distance in m between
    bodies of one name after a second."""
    pairs = paired(one, two, prefix)
    if pairs is None:
        return {"skipped": "a joint of the first file is another one in the second"}
    for model in (one, two):
        model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    for name in SAME_OPTIONS:
        if hasattr(one.opt, name):
            setattr(two.opt, name, getattr(one.opt, name))
    two.opt.gravity[:], two.opt.wind[:] = one.opt.gravity, one.opt.wind
    for model in (one, two):  # to the end: some files stop after one iteration
        model.opt.iterations, model.opt.tolerance = 100, 1e-12
        model.opt.ls_iterations, model.opt.ls_tolerance = 50, 0.01
    first, second = mujoco.MjData(one), mujoco.MjData(two)
    first.qpos[:] = one.key_qpos[0] if one.nkey else one.qpos0
    for i, k in pairs:
        a, b, size = one.jnt_qposadr[i], two.jnt_qposadr[k], 7 if one.jnt_type[i] == 0 else 1
        second.qpos[b:b + size] = first.qpos[a:a + size]
    command(one, two, dict(pairs), first, second)
    mujoco.mj_forward(one, first)
    mujoco.mj_forward(two, second)
    others = measured(two, second)
    values = {}
    for kind, all_of_kind in measured(one, first).items():
        lost = sum(not any(np.allclose(value, other, rtol=1e-3, atol=1e-5) for other in others.get(kind, []))
                   for value in all_of_kind)
        if lost:
            values[kind] = lost
    for _ in range(round(1 / one.opt.timestep)):
        mujoco.mj_step(one, first)
        mujoco.mj_step(two, second)
    bodies = {name.removeprefix(prefix): i for i, name in enumerate(names(two, mujoco.mjtObj.mjOBJ_BODY, two.nbody))}
    way = max((float(abs(first.xpos[i] - second.xpos[bodies[name]]).max())
               for i, name in enumerate(names(one, mujoco.mjtObj.mjOBJ_BODY, one.nbody)) if name in bodies), default=0)
    return {"values": values, "way": way}


def main():
    sys.path.insert(0, sys.argv[1])
    import record  # noqa: E402
    files = sys.argv[2:]
    for first, written, prefix in zip(files[::3], files[1::3], files[2::3]):
        models = [record.compile_mjcf(path, True)[0] for path in (first, written)]
        print(json.dumps({"skipped": "MuJoCo does not load it"} if None in models else compared(*models, prefix)), flush=True)


if __name__ == "__main__":
    main()
