// SPDX-License-Identifier: BSD-3-Clause
// What mujoco_poses.cpp does, with the WebAssembly build of a later MuJoCo. Files that the model
// names, relative to it, follow; it sees no others.
import { dirname, join } from "node:path";
import { readFileSync } from "node:fs";

const [modules, file, ...named] = process.argv.slice(2);
const { default: load } = await import(`${modules}/@mujoco/mujoco/mujoco.js`);
const mujoco = await load();
mujoco.FS.mkdirTree("/model/scene");
for (const path of named) {
  const target = join("/model/scene", path);
  mujoco.FS.mkdirTree(dirname(target));
  mujoco.FS.writeFile(target, readFileSync(join(dirname(file), path)));
}
mujoco.FS.writeFile("/model/scene/scene.xml", readFileSync(file));
const model = mujoco.MjModel.from_xml_path("/model/scene/scene.xml");
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
