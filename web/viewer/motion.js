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

/** What moves a link below its parent: X_PJ, and the axis of unit length unless it does not move. */
function toMover({ pose, axis, type }) {
  const along = new Vector3(...(axis ?? []));
  const length = along.length();
  return {
    pose: toMatrix(pose),
    axis: length > 0 ? along.divideScalar(length) : null,
    slides: type === "prismatic",
  };
}

/** Sets a matrix to the motion of a joint. */
function setMotion(matrix, { axis, slides }, position) {
  if (!slides) return matrix.makeRotationAxis(axis, position);
  return matrix.makeTranslation(axis.x * position, axis.y * position, axis.z * position);
}

export class Motion {
  constructor(scene) {
    this.scene = scene;
    this.positions = scene.entities.map((entity) => new Map(entity.start));
    this.entities = scene.entities.map((entity) => (entity.pose ? toMatrix(entity.pose) : null));
    this.links = scene.entities.map(({ model, pose }) => {
      const links = model?.links.map(() => null) ?? [];
      for (const link of pose ? (model?.order ?? []) : []) links[link] = new Matrix4();
      return links;
    });
    this.joints = new Map(scene.models.map((model) => [model, model.joints.map(toMover)]));
    this.step = new Matrix4(); // of a joint; only moveLinks() uses it
    this.moved = new Set(); // entities since the last takeMoved()
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
    this.update(this.together(entity));
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
    const together = this.together(entity);
    for (const each of together) this.positions[each] = new Map(this.scene.entities[each].start);
    this.update(together);
  }

  /** The position of a joint; both arguments are indices. */
  position(entity, joint) {
    const { model } = this.scene.entities[entity];
    return positionOf(model, model.joints[joint], this.positions[entity]);
  }

  /** Moves the links of some entities, or of all, and of those that are fixed to a link of them. */
  update(changed = this.scene.order) {
    const all = new Set(changed);
    for (const index of this.scene.order) {
      const { pose, support, model } = this.scene.entities[index];
      if (support && all.has(support.entity)) all.add(index);
      if (!pose || !all.has(index)) continue;
      this.moved.add(index);
      const below = support && this.links[support.entity][support.link];
      if (below) this.entities[index].multiplyMatrices(below, this.supports[index]);
      if (model) this.moveLinks(index, model);
    }
  }

  /** The entities that have moved since the last call. */
  takeMoved() {
    const { moved } = this;
    this.moved = new Set();
    return moved;
  }

  moveLinks(index, model) {
    const links = this.links[index];
    const movers = this.joints.get(model);
    for (const at of model.order) {
      const { joint } = model.links[at];
      if (joint === undefined) {
        links[at].copy(this.entities[index]);
        continue;
      }
      this.frameOf(index, joint, links[at]);
      const position = movers[joint].axis ? this.position(index, joint) : 0;
      if (position !== 0) links[at].multiply(setMotion(this.step, movers[joint], position));
    }
  }

  /** X_WJ of a joint at position zero, in `frame`; the other arguments are indices. */
  frameOf(entity, joint, frame = new Matrix4()) {
    const { model } = this.scene.entities[entity];
    const above = this.links[entity][model.joints[joint].parent];
    return frame.multiplyMatrices(above, this.joints.get(model)[joint].pose);
  }
}
