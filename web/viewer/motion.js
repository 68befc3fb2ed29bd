// SPDX-License-Identifier: BSD-3-Clause
// Forward kinematics in double precision, as in libsmurf/src/link/kinematics.cpp.
import { Matrix4, Quaternion, Vector3 } from "three";

const kLongestChain = 64; // of joints that mimic joints that mimic

export function toMatrix(pose) {
  const matrix = new Matrix4();
  if (!pose) return matrix;
  const [x, y, z, qw, qx, qy, qz] = pose;
  return matrix.compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw), new Vector3(1, 1, 1));
}

export const isMovable = (joint) => joint.axis !== undefined;

/** The position of a joint. A mimic joint follows its leader unless `positions` has a value for it. */
export function positionOf(model, joint, positions) {
  let factor = 1;
  let sum = 0;
  for (let step = 0; step < kLongestChain; step++) {
    if (positions.has(joint.name)) return sum + factor * positions.get(joint.name);
    if (joint.leader === undefined) return sum;
    sum += factor * joint.offset;
    factor *= joint.multiplier;
    joint = model.joints[joint.leader];
  }
  return sum;
}

function motionOf(joint, position) {
  const axis = new Vector3(...joint.axis);
  if (position === 0 || axis.length() === 0) return new Matrix4();
  axis.normalize();
  if (joint.type !== "prismatic") return new Matrix4().makeRotationAxis(axis, position);
  return new Matrix4().makeTranslation(axis.multiplyScalar(position));
}

export class Motion {
  constructor(scene) {
    this.scene = scene;
    this.positions = scene.entities.map((entity) => new Map(entity.start));
    this.entities = scene.entities.map((entity) => (entity.pose ? toMatrix(entity.pose) : null));
    this.links = scene.entities.map((entity) => entity.model?.links.map(() => null) ?? []);
    this.joints = new Map(); // X_PJ of every joint, by model
    for (const model of scene.models) {
      this.joints.set(
        model,
        model.joints.map((joint) => toMatrix(joint.pose)),
      );
    }
    this.twins = new Map(); // of an entity, in the other version: {entity, joints}
    this.supports = scene.entities.map((entity) => toMatrix(entity.support?.pose));
    this.update();
  }

  /** Lets entities of two versions move together. `joints`: pairs of the names of their joints. */
  pair(entity, other, joints) {
    this.twins.set(entity, { entity: other, joints: new Map(joints) });
    this.twins.set(other, { entity, joints: new Map(joints.map(([name, twin]) => [twin, name])) });
  }

  /** The entity, and the one that moves with it. */
  together(entity) {
    return this.twins.has(entity) ? [entity, this.twins.get(entity).entity] : [entity];
  }

  set(entity, positions) {
    this.positions[entity] = new Map(positions);
    this.moveTwin(entity);
    this.update();
  }

  /** Joints that only the twin has stay where they are. */
  moveTwin(entity) {
    const twin = this.twins.get(entity);
    if (!twin) return;
    const names = new Set(twin.joints.values());
    const kept = [...this.positions[twin.entity]].filter(([name]) => !names.has(name));
    const moved = [...this.positions[entity]].filter(([name]) => twin.joints.has(name));
    this.positions[twin.entity] = new Map([
      ...kept,
      ...moved.map(([name, position]) => [twin.joints.get(name), position]),
    ]);
  }

  reset(entity) {
    for (const each of this.together(entity)) this.positions[each] = new Map(this.scene.entities[each].start);
    this.update();
  }

  /** The position of a joint; both arguments are indices. */
  position(entity, joint) {
    const { model } = this.scene.entities[entity];
    return positionOf(model, model.joints[joint], this.positions[entity]);
  }

  /** Moves all entities, because one may be fixed to a link of another. */
  update() {
    for (const index of this.scene.order) {
      const entity = this.scene.entities[index];
      if (!entity.pose) continue;
      const below = entity.support && this.links[entity.support.entity][entity.support.link];
      if (below) this.entities[index] = below.clone().multiply(this.supports[index]);
      if (entity.model) this.moveLinks(index, entity.model);
    }
  }

  moveLinks(index, model) {
    const links = this.links[index];
    for (const at of model.order) {
      const joint = model.joints[model.links[at].joint];
      links[at] = joint ? this.frameOf(index, model.links[at].joint) : this.entities[index].clone();
      if (joint && isMovable(joint))
        links[at].multiply(motionOf(joint, this.position(index, model.links[at].joint)));
    }
  }

  /** X_WJ of a joint at position zero; both arguments are indices. */
  frameOf(entity, joint) {
    const { model } = this.scene.entities[entity];
    return this.links[entity][model.joints[joint].parent].clone().multiply(this.joints.get(model)[joint]);
  }
}
