// SPDX-License-Identifier: BSD-3-Clause
// Loads a URDF with urdf-loader and prints the world pose of every link ("name x y z qw qx qy qz").
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(`${process.argv[2]}/`);
const { JSDOM } = require("jsdom");
globalThis.DOMParser = new JSDOM().window.DOMParser;
globalThis.document = new JSDOM().window.document;
globalThis.Document = new JSDOM().window.Document;
globalThis.Element = new JSDOM().window.Element;
const { default: URDFLoader } = await import(`${process.argv[2]}/urdf-loader/src/URDFLoader.js`);
const THREE = await import(`${process.argv[2]}/three/build/three.module.js`);

const loader = new URDFLoader();
loader.loadMeshCb = (...words) => words.at(-1)(new THREE.Object3D());
const robot = loader.parse(readFileSync(process.argv[3], "utf8"));
// A follower takes its place when its leader is set.
for (const joint of Object.values(robot.joints)) {
  if (joint.mimicJoints.length > 0) joint.setJointValue(0);
}
robot.updateMatrixWorld(true);
for (const [name, link] of Object.entries(robot.links)) {
  const p = new THREE.Vector3(), q = new THREE.Quaternion(), s = new THREE.Vector3();
  link.matrixWorld.decompose(p, q, s);
  console.log(["pose", name, p.x, p.y, p.z, q.w, q.x, q.y, q.z].join("\t"));
}
