// SPDX-License-Identifier: BSD-3-Clause
// Prints the sensors of an MJCF as mujoco_sensors.cpp does, with the WebAssembly build of a later MuJoCo.
import { readFileSync } from "node:fs";

const [modules, file, steps] = process.argv.slice(2);
const { default: load } = await import(`${modules}/@mujoco/mujoco/mujoco.js`);
const mujoco = await load();
mujoco.FS.writeFile("/scene.xml", readFileSync(file));
const model = mujoco.MjModel.from_xml_path("/scene.xml");
const data = new mujoco.MjData(model);
if (model.nkey > 0) mujoco.mj_resetDataKeyframe(model, data, 0);
mujoco.mj_forward(model, data);
for (let step = 0; step < Number(steps ?? 0); ++step) mujoco.mj_step(model, data);
for (let i = 0; i < model.nsensor; ++i) {
  const name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_SENSOR.value, i);
  const begin = model.sensor_adr[i];
  const values = data.sensordata.slice(begin, begin + model.sensor_dim[i]);
  console.log(["sensor", name, model.sensor_type[i], ...values].join("\t"));
}
