// SPDX-License-Identifier: BSD-3-Clause
// What run_reader.hpp says, with urdf-loader: NODE_MODULES < list of files. Meshes are not opened:
// where they are missing, it goes on without them.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const modules = process.argv[2];
const files = readFileSync(0, "utf8").split("\n").filter((line) => line);
const require = createRequire(`${modules}/`);
const { JSDOM } = require("jsdom");
const { window } = new JSDOM();
for (const name of ["DOMParser", "document", "Document", "Element"]) globalThis[name] = window[name];
const { default: URDFLoader } = await import(`${modules}/urdf-loader/src/URDFLoader.js`);
const THREE = await import(`${modules}/three/build/three.module.js`);
console.warn = console.error = console.log = () => {};

const pose = (object) => [...object.position.toArray(), ...object.quaternion.toArray()];

function shapesOf(holder) {
  return holder.children.map((shape) => [shape.geometry?.type ?? shape.userData.path ?? shape.type,
                                         ...Object.values(shape.geometry?.parameters ?? {}).slice(0, 3),
                                         pose(shape), shape.scale.toArray()]);
}

/** Flat, as run_reader.hpp says. */
function describe(robot) {
  const out = { "name:": robot.robotName ?? robot.name };
  robot.updateMatrixWorld(true);
  for (const [name, link] of Object.entries(robot.links)) {
    out[`links:${name}`] = link.parent?.urdfName ?? "";
    link.children.filter((child) => child.isURDFVisual || child.isURDFCollider).forEach((child, i) => {
      out[`${child.isURDFVisual ? "visuals" : "collisions"}:${name}:${i}`] = [pose(child), shapesOf(child)];
      const material = child.children[0]?.material;
      if (child.isURDFVisual && material) {
        out[`colours:${name}:${i}`] = [...material.color.toArray(), material.opacity, material.name];
      }
    });
  }
  for (const [name, joint] of Object.entries(robot.joints)) {
    out[`joints:${name}`] = [joint.jointType, joint.parent?.urdfName ?? "",
                             joint.children.find((child) => child.isURDFLink)?.urdfName ?? ""];
    out[`poses:${name}`] = pose(joint);
    if (joint.axis) out[`axes:${name}`] = joint.axis.toArray();
    out[`limits:${name}`] = Object.values(joint.limit);
    if (joint.mimicJoint) out[`mimics:${name}`] = [joint.mimicJoint, joint.multiplier, joint.offset];
  }
  return out;
}

function read(file) {
  const loader = new URDFLoader();
  loader.parseCollision = true;
  loader.loadMeshCb = (path, ...rest) => {
    const mesh = new THREE.Object3D();
    mesh.userData.path = path.split("/").at(-1);
    rest.at(-1)(mesh);
  };
  try {
    return { verdict: "takes", message: "", robot: describe(loader.parse(readFileSync(file, "utf8"))) };
  } catch (error) {
    return { verdict: "refuses", message: String(error.message).split("\n")[0] };
  }
}

/** JSON has neither nan nor infinity, and both are to be told from what is absent. */
function plain(key, value) {
  return typeof value === "number" && !Number.isFinite(value) ? String(value) : value;
}

for (const file of files) {
  process.stdout.write(JSON.stringify({ file, verdict: "crashes", message: "ends the process" }) + "\n");
  process.stdout.write(JSON.stringify({ file, ...read(file) }, plain) + "\n");
}
