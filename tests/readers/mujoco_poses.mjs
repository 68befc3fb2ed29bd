// SPDX-License-Identifier: BSD-3-Clause
// What mujoco_poses.cpp does, with the WebAssembly build of a later MuJoCo.
import { readFileSync } from "node:fs";

const { default: load } = await import(`${process.argv[2]}/@mujoco/mujoco/mujoco.js`);
const mujoco = await load();
const model = mujoco.MjModel.from_xml_string(readFileSync(process.argv[3], "utf8"));
const data = new mujoco.MjData(model);
if (model.nkey > 0) mujoco.mj_resetDataKeyframe(model, data, 0);
mujoco.mj_forward(model, data);
for (let i = 1; i < model.nbody; ++i) {
  const name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY.value, i);
  console.log(["pose", name, ...data.xpos.slice(3 * i, 3 * i + 3),
               ...data.xquat.slice(4 * i, 4 * i + 4)].join("\t"));
}
for (let step = 0; step < 100; ++step) mujoco.mj_step(model, data);
if (!data.qpos.every(Number.isFinite)) process.exit(1);
