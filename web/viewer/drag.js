// SPDX-License-Identifier: BSD-3-Clause
// Dragging a link moves the joint above it: the joint takes the position at which the grabbed point is nearest to the
// pointer.
import { Vector3 } from "three";

import { isMovable } from "./motion.js";
import { spanOf } from "./panel.js";

const kSteps = 4; // of Newton's method for each move of the pointer
const kSmall = 1e-3; // rad or m, for the slope
const kLongest = 0.6; // rad: the slope says nothing about what is farther
const kLeastSlope = 2; // pixels per rad or m: below it, the point moves towards the viewer

/** The nearest joint above a link that can be moved by itself, or undefined. */
export function jointAbove(model, link) {
  for (let at = link; at !== undefined; at = model.joints[model.links[at].joint]?.parent) {
    const joint = model.joints[model.links[at].joint];
    if (!joint || model.links[at].unplaced) return undefined;
    const [low, high] = spanOf(joint);
    if (isMovable(joint) && joint.leader === undefined && low < high) return joint;
  }
  return undefined;
}

export class Drag {
  /** `point`: of the link, in the world. */
  constructor({ stage, motion, joints }, entity, link, point) {
    Object.assign(this, { stage, motion, joints, entity, link });
    this.joint = jointAbove(motion.scene.entities[entity].model, link);
    this.local = point.clone().applyMatrix4(motion.links[entity][link].clone().invert());
  }

  /** `x`, `y`: of the pointer, in pixels of the picture. */
  move(x, y) {
    const [low, high] = spanOf(this.joint);
    for (let step = 0; step < kSteps; step++) {
      const position = this.motion.position(this.entity, this.joint.index);
      const wanted = Math.min(high, Math.max(low, position + this.stepTowards(x, y)));
      if (Math.abs(wanted - position) < 1e-6) return;
      this.joints.moveBy(this.joint, wanted);
    }
  }

  stepTowards(x, y) {
    const links = this.motion.links[this.entity];
    const below = links[this.joint.child];
    const point = this.local.clone().applyMatrix4(links[this.link]);
    const along = new Vector3(...this.joint.axis).transformDirection(below);
    const slides = this.joint.type === "prismatic";
    const speed = slides
      ? along
      : along.clone().cross(point.clone().sub(new Vector3().setFromMatrixPosition(below)));
    const here = this.stage.toPage(point);
    const there = this.stage.toPage(point.addScaledVector(speed, kSmall));
    if (!here || !there) return 0;
    const slope = [(there[0] - here[0]) / kSmall, (there[1] - here[1]) / kSmall];
    const square = slope[0] ** 2 + slope[1] ** 2;
    if (square < kLeastSlope ** 2) return 0;
    const change = ((x - here[0]) * slope[0] + (y - here[1]) * slope[1]) / square;
    return slides ? change : Math.min(kLongest, Math.max(-kLongest, change));
  }
}
