// SPDX-License-Identifier: BSD-3-Clause
// Draws frames, joint axes, centres of mass, inertias, names and a measured distance over the shapes.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Color,
  SphereGeometry,
  Vector3,
} from "three";

import { element } from "../common/dom.js";
import { copiesOf } from "./copies.js";
import { ellipsoidOf } from "./inertia.js";
import { isMovable, toMatrix } from "./motion.js";
import { Sensors } from "./sensors.js";
import { kOrder, paint } from "./shading.js";

const kAxisColors = [
  [0.9, 0.2, 0.2],
  [0.2, 0.7, 0.2],
  [0.25, 0.45, 1],
];
const kJointColor = [0.75, 0.2, 0.85];
const kBoneColor = [0.1, 0.5, 0.75];
const kMassColor = new Color(0.94, 0.63, 0);
const kInertiaColor = new Color(0.45, 0.3, 0.85);
const kSolidColor = new Color(0.1, 0.65, 0.45);
const kRulerColor = [0.95, 0.1, 0.45];
const kMostNames = 150;
const kMostRound = 500; // spheres: more of them have fewer sides

/** `count` groups of lines in the same colours; their ends can be moved. */
function linesOf(count, colors, order) {
  const geometry = new BufferGeometry();
  const points = new BufferAttribute(new Float32Array(count * colors.length * 3), 3).setUsage(
    DynamicDrawUsage,
  );
  const painted = new Float32Array(count * colors.length * 3);
  for (let i = 0; i < count * colors.length; i++) painted.set(colors[i % colors.length], 3 * i);
  geometry.setAttribute("position", points);
  geometry.setAttribute("color", new BufferAttribute(painted, 3));
  const lines = new LineSegments(
    geometry,
    new LineBasicMaterial({ vertexColors: true, depthTest: false, transparent: true }),
  );
  lines.frustumCulled = false;
  lines.renderOrder = order;
  lines.visible = false;
  return lines;
}

/** Unit spheres in one colour. */
function spheresOf(count, color, opacity, order) {
  const around = count <= kMostRound ? 16 : 8;
  const geometry = new SphereGeometry(1, around, (3 * around) / 4);
  const spheres = copiesOf(geometry, paint("UNLIT", { opacity, depthTest: false }), count);
  for (let index = 0; index < count; index++) spheres.setColorAt(index, color);
  spheres.renderOrder = order;
  return spheres;
}

/** Gives back what a drawn object has on the graphics card. */
export function free({ geometry, material }) {
  geometry.dispose();
  material.dispose();
}

const kForms = ["box", "sphere", "cylinder", "capsule", "plane", "mesh"];
const isShown = (shape) => kForms.some((form) => form in shape);

/** The links of robots of which a shape is missing, as {entity, link, parent}; roots have no parent. */
export function bonesOf(scene) {
  return scene.entities.flatMap(({ model, pose }, entity) => {
    const shapes = model?.links.flatMap(({ visuals, collisions }) => [
      ...(visuals ?? []),
      ...(collisions ?? []),
    ]);
    if (!model?.order.length || !pose || (shapes.length > 0 && shapes.every(isShown))) return [];
    return model.order.map((link) => ({
      entity,
      link,
      parent: model.joints[model.links[link].joint]?.parent,
    }));
  });
}

export class Overlays {
  constructor(scene, motion, stage, sizes) {
    this.motion = motion;
    this.stage = stage;
    this.entities = scene.entities;
    this.sizes = sizes; // of each entity, m: what is drawn on it is as large as it
    this.versions = "both"; // "old" or "new": nothing is drawn on entities of the other version
    this.frames = []; // {entity, link}, also of entities without links
    this.axes = []; // {entity, joint}
    this.masses = []; // {entity, link, local}
    this.inertias = []; // {entity, link, local}: what makes the ellipsoid of a unit sphere
    this.solids = []; // the same for the inertias of the shapes
    scene.entities.forEach((entity, index) => this.add(entity, index));
    this.bones = bonesOf(scene);
    this.parts = this.makeParts();
    this.sensors = new Sensors(scene, motion, sizes, (entity) => this.isShown(entity));
    this.ruler = linesOf(1, [kRulerColor, kRulerColor], kOrder.ruler);
    stage.scene.add(this.sensors.group, this.ruler);
    this.labels = element("div", { class: "labels", "aria-hidden": "true" });
    stage.host.append(this.labels);
    this.named = []; // [name, X_W]
    this.follow = () => this.placeNames();
    stage.afterDraw.push(this.follow);
  }

  /** Takes everything from the stage. */
  remove() {
    const { stage, sensors, ruler, labels } = this;
    const drawn = Object.values(this.parts).flatMap((part) => part.drawn ?? []);
    for (const each of [sensors.group, ruler, ...drawn]) each.removeFromParent();
    for (const each of [ruler, ...drawn, ...sensors.group.children]) free(each);
    labels.remove();
    stage.afterDraw.splice(stage.afterDraw.indexOf(this.follow), 1);
  }

  /** {make, move, drawn: what make() has made} by name. They are made and moved only while they are shown. */
  makeParts() {
    const axisColors = kAxisColors.flatMap((color) => [color, color]);
    return {
      frames: {
        make: () => linesOf(this.frames.length, axisColors, kOrder.frames),
        move: (lines) => this.moveFrames(lines),
      },
      axes: {
        make: () => linesOf(this.axes.length, [kJointColor, kJointColor], kOrder.axes),
        move: (lines) => this.moveAxes(lines),
      },
      skeleton: {
        make: () => linesOf(this.bones.length, [kBoneColor, kBoneColor], kOrder.axes),
        move: (lines) => this.moveBones(lines),
      },
      masses: {
        make: () => spheresOf(this.masses.length, kMassColor, 0.85, kOrder.masses),
        move: (balls) => this.moveMasses(balls),
      },
      inertias: {
        make: () => spheresOf(this.inertias.length, kInertiaColor, 0.35, kOrder.inertias),
        move: (ellipsoids) => this.moveInertias(ellipsoids, this.inertias),
      },
      solids: {
        make: () => spheresOf(this.solids.length, kSolidColor, 0.25, kOrder.inertias),
        move: (ellipsoids) => this.moveInertias(ellipsoids, this.solids),
      },
    };
  }

  /** Shows "frames", "axes", "skeleton", "masses", "inertias" or "solids", or hides them. */
  show(name, on) {
    const part = this.parts[name];
    if (!on && !part.drawn) return;
    if (!part.drawn) this.stage.scene.add((part.drawn = part.make()));
    part.drawn.visible = on;
    if (on) part.move(part.drawn);
  }

  add(entity, index) {
    if (!entity.pose) return;
    const { model } = entity;
    if (!model?.order.length) this.frames.push({ entity: index });
    for (const link of model?.order ?? []) {
      this.frames.push({ entity: index, link });
      const { mass, com, inertia, solid } = model.links[link];
      if (mass) this.masses.push({ entity: index, link, local: toMatrix(com) });
      const ellipsoid = mass && inertia && ellipsoidOf(mass, inertia);
      if (ellipsoid) this.inertias.push({ entity: index, link, local: toMatrix(com).multiply(ellipsoid) });
      const full = mass && solid && ellipsoidOf(mass, solid.inertia);
      if (full) this.solids.push({ entity: index, link, local: toMatrix(solid.com).multiply(full) });
    }
    model?.joints.forEach((joint, at) => {
      const child = model.links[joint.child];
      if (isMovable(joint) && child?.joint === at && !child.unplaced)
        this.axes.push({ entity: index, joint: at });
    });
  }

  worldOf({ entity, link }) {
    return link === undefined ? this.motion.entities[entity] : this.motion.links[entity][link];
  }

  isShown(entity) {
    return this.versions !== (this.entities[entity].old ? "new" : "old");
  }

  sizeOf(entity) {
    return this.isShown(entity) ? this.sizes[entity] : 0;
  }

  move() {
    for (const { drawn, move } of Object.values(this.parts)) if (drawn?.visible) move(drawn);
    this.sensors.move();
  }

  moveMasses(balls) {
    const [ball, size] = [new Matrix4(), new Vector3()];
    this.masses.forEach((mass, index) => {
      size.setScalar(0.012 * this.sizeOf(mass.entity));
      ball.multiplyMatrices(this.worldOf(mass), mass.local).scale(size);
      balls.setMatrixAt(index, ball);
    });
    balls.showPlaces();
  }

  moveInertias(ellipsoids, inertias) {
    const [ellipsoid, none] = [new Matrix4(), new Vector3()];
    inertias.forEach((inertia, index) => {
      ellipsoid.multiplyMatrices(this.worldOf(inertia), inertia.local);
      if (!this.isShown(inertia.entity)) ellipsoid.scale(none);
      ellipsoids.setMatrixAt(index, ellipsoid);
    });
    ellipsoids.showPlaces();
  }

  /** Shows a line between two points of the world; without them, none. */
  setRuler(from, to) {
    this.ruler.visible = Boolean(to);
    if (!to) return;
    const points = this.ruler.geometry.getAttribute("position");
    points.setXYZ(0, ...from);
    points.setXYZ(1, ...to);
    points.needsUpdate = true;
  }

  moveFrames(lines) {
    const points = lines.geometry.getAttribute("position");
    const [origin, end] = [new Vector3(), new Vector3()];
    this.frames.forEach((frame, index) => {
      const world = this.worldOf(frame);
      const length = 0.12 * this.sizeOf(frame.entity);
      for (let axis = 0; axis < 3; axis++) {
        origin.setFromMatrixPosition(world);
        end.setFromMatrixColumn(world, axis).multiplyScalar(length).add(origin);
        origin.toArray(points.array, 3 * (6 * index + 2 * axis));
        end.toArray(points.array, 3 * (6 * index + 2 * axis + 1));
      }
    });
    points.needsUpdate = true;
  }

  /** A line from each link to the one above it. */
  moveBones(lines) {
    const points = lines.geometry.getAttribute("position");
    const end = new Vector3();
    this.bones.forEach(({ entity, link, parent }, index) => {
      for (const [at, of] of [link, parent ?? link].entries()) {
        end.setFromMatrixPosition(this.motion.links[entity][this.isShown(entity) ? of : link]);
        end.toArray(points.array, 3 * (2 * index + at));
      }
    });
    points.needsUpdate = true;
  }

  moveAxes(lines) {
    const points = lines.geometry.getAttribute("position");
    this.axes.forEach(({ entity, joint }, index) => {
      const { axis } = this.motion.scene.entities[entity].model.joints[joint];
      const world = this.motion.frameOf(entity, joint);
      const origin = new Vector3().setFromMatrixPosition(world);
      const along = new Vector3(...axis).transformDirection(world).multiplyScalar(0.16 * this.sizeOf(entity));
      points.setXYZ(2 * index, ...origin.clone().sub(along));
      points.setXYZ(2 * index + 1, ...origin.clone().add(along));
    });
    points.needsUpdate = true;
  }

  /** `named`: [[name, function that returns the world pose]...]. */
  setNames(named) {
    this.named = named.slice(0, kMostNames);
    this.labels.replaceChildren(...this.named.map(([name]) => element("span", {}, name)));
    this.stage.draw();
  }

  /** Leaves out a name that would cover another one. */
  placeNames() {
    const taken = [];
    const size = this.named.map((_, index) => this.labels.children[index].offsetWidth);
    this.named.forEach(([, world], index) => {
      const label = this.labels.children[index];
      const at = this.stage.toPage(new Vector3().setFromMatrixPosition(world()));
      const box = at && [at[0] - size[index] / 2, at[1] - 22, at[0] + size[index] / 2, at[1] - 4];
      const isFree =
        box &&
        taken.every(
          (other) => box[0] > other[2] || box[2] < other[0] || box[1] > other[3] || box[3] < other[1],
        );
      label.style.visibility = isFree ? "visible" : "hidden";
      if (!isFree) return;
      taken.push(box);
      label.style.transform = `translate(${box[0]}px, ${box[1]}px)`;
    });
  }
}
