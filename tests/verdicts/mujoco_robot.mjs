// SPDX-License-Identifier: BSD-3-Clause
// What run_reader.hpp says, with the WebAssembly build of MuJoCo: NODE_MODULES < list of files.
// The file being read is announced: what ends this process is said by who sees that.
import { readdirSync, readFileSync } from "node:fs";
import { basename, dirname } from "node:path";

const modules = process.argv[2];
const files = readFileSync(0, "utf8").split("\n").filter((line) => line);
const { default: load } = await import(`${modules}/@mujoco/mujoco/mujoco.js`);
let mujoco;

async function start() {
  let said = "";
  mujoco = await load({ print: () => {}, printErr: (text) => { said ||= text; } });
  mujoco.FS.mkdirTree("/robots");
  const folder = dirname(files[0]);
  for (const name of readdirSync(folder).filter((name) => !name.endsWith(".urdf"))) {
    mujoco.FS.writeFile(`/robots/${name}`, readFileSync(`${folder}/${name}`));
  }
}

const slice = (array, width, index) => [...array.slice(width * index, width * (index + 1))];
const TYPES = ["free", "ball", "slide", "hinge"];

/** Whether a limit holds is hidden in fields that cannot be read from here, but is written. */
function addLimits(robot, model) {
  mujoco.mj_saveLastXML("/robots/saved.xml", model);
  const text = mujoco.FS.readFile("/robots/saved.xml", { encoding: "utf8" });
  for (const [tag, name] of text.matchAll(/<joint name="([^"]*)"[^>]*>/g)) {
    robot[`limits:${name}`] = (tag.match(/ (range|limited|actuatorfrc\w+)="[^"]*"/g) ?? []).join("");
  }
}

/** Flat, as run_reader.hpp says. */
function describe(model) {
  const name = (kind, id) => mujoco.mj_id2name(model, mujoco.mjtObj[kind].value, id) ?? "";
  const robot = {};
  for (let i = 0; i < model.nbody; ++i) {
    const body = name("mjOBJ_BODY", i);
    robot[`links:${body}`] = name("mjOBJ_BODY", model.body_parentid[i]);
    robot[`poses:${body}`] = [...slice(model.body_pos, 3, i), ...slice(model.body_quat, 4, i)];
    robot[`masses:${body}`] = [model.body_mass[i], ...slice(model.body_ipos, 3, i)];
    robot[`inertias:${body}`] = [...slice(model.body_inertia, 3, i), ...slice(model.body_iquat, 4, i)];
  }
  for (let i = 0; i < model.njnt; ++i) {
    const joint = name("mjOBJ_JOINT", i), dof = model.jnt_dofadr[i];
    robot[`joints:${joint}`] = [TYPES[model.jnt_type[i]], name("mjOBJ_BODY", model.jnt_bodyid[i])];
    robot[`axes:${joint}`] = [...slice(model.jnt_axis, 3, i), ...slice(model.jnt_pos, 3, i)];
    robot[`dynamics:${joint}`] = [model.dof_damping[dof], model.dof_frictionloss[dof]].flat();
  }
  for (let i = 0; i < model.ngeom; ++i) {
    const moves = model.geom_contype[i] !== 0 || model.geom_conaffinity[i] !== 0;
    const mesh = model.geom_dataid[i] < 0 ? "" : name("mjOBJ_MESH", model.geom_dataid[i]);
    robot[`${moves ? "collisions" : "visuals"}:${name("mjOBJ_BODY", model.geom_bodyid[i])}:${i}`] = [
      model.geom_type[i], mesh, ...slice(model.geom_size, 3, i), ...slice(model.geom_pos, 3, i),
      ...slice(model.geom_quat, 4, i)];
    robot[`colours:${i}`] = slice(model.geom_rgba, 4, i);
  }
  for (let i = 0; i < model.neq; ++i) {
    robot[`mimics:${i}`] = [model.eq_type[i], model.eq_obj1id[i], model.eq_obj2id[i],
                            ...slice(model.eq_data, 11, i)];
  }
  addLimits(robot, model);
  return robot;
}

function read(file) {
  let model;
  try {
    // By its path: a text given as such is read from another folder.
    mujoco.FS.writeFile("/robots/robot.urdf", readFileSync(file));
    model = mujoco.MjModel.from_xml_path("/robots/robot.urdf");
    return { verdict: "takes", message: "", robot: describe(model) };
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw error;
    return { verdict: "refuses", message: String(error.message ?? error).split("\n")[0] };
  } finally {
    model?.delete();
  }
}

/** JSON has neither nan nor infinity, and both are to be told from what is absent. */
function plain(key, value) {
  return typeof value === "number" && !Number.isFinite(value) ? String(value) : value;
}

await start();
for (const file of files) {
  process.stdout.write(JSON.stringify({ file, verdict: "crashes", message: "ends the process" }) + "\n");
  let reading;
  try {
    reading = read(file);
  } catch (error) {
    reading = { verdict: "crashes", message: String(error.message).split("\n")[0] };
    await start();  // its memory is not to be trusted any more
  }
  process.stdout.write(JSON.stringify({ file, ...reading }, plain) + "\n");
}
