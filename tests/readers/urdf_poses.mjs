// SPDX-License-Identifier: BSD-3-Clause
// What robot_poses.hpp says, with urdf-loader: NODE_MODULES FILE...
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [modules, ...files] = process.argv.slice(2);
const require = createRequire(`${modules}/`);
const { JSDOM } = require("jsdom");
globalThis.DOMParser = new JSDOM().window.DOMParser;
globalThis.document = new JSDOM().window.document;
globalThis.Document = new JSDOM().window.Document;
globalThis.Element = new JSDOM().window.Element;
const { default: URDFLoader } = await import(`${modules}/urdf-loader/src/URDFLoader.js`);
const THREE = await import(`${modules}/three/build/three.module.js`);

function printLinks(what, robot) {
  robot.updateMatrixWorld(true);
  for (const [name, link] of Object.entries(robot.links)) {
    const p = new THREE.Vector3(), q = new THREE.Quaternion(), s = new THREE.Vector3();
    link.matrixWorld.decompose(p, q, s);
    console.log([what, name, p.x, p.y, p.z, q.w, q.x, q.y, q.z].join("\t"));
  }
}

function positionOfJoint(name) {
  return 0.05 * (Buffer.from(name).reduce((sum, byte) => sum + byte, 0) % 8) + 0.1;
}

/** False when the reader refuses the file. */
function printRobot(file) {
  const loader = new URDFLoader();
  loader.loadMeshCb = (...words) => words.at(-1)(new THREE.Object3D());
  let robot;
  try {
    robot = loader.parse(readFileSync(file, "utf8"));
  } catch {
    return false;
  }
  const leaders = Object.values(robot.joints).filter((joint) => !joint.mimicJoint);
  // A follower takes its place when its leader is set.
  for (const joint of leaders) {
    if (joint.mimicJoints.length > 0) joint.setJointValue(0);
  }
  printLinks("pose", robot);
  for (const joint of leaders) {
    if (!["revolute", "continuous", "prismatic"].includes(joint.jointType)) continue;
    joint.ignoreLimits = true;
    joint.setJointValue(positionOfJoint(joint.urdfName));
  }
  printLinks("moved", robot);
  return true;
}

for (const file of files) {
  console.log(`file\t${file}`);
  console.log(printRobot(file) ? "end" : "refused");
}
