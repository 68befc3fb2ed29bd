// SPDX-License-Identifier: BSD-3-Clause
// Draws what sensors see: the fields of view of cameras, the rays of scans, and a small mark for each sensor.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from "three";

import { toMatrix } from "./motion.js";
import { kOrder } from "./shading.js";

const kColor = [0.05, 0.6, 0.5];
const kSelected = [0.95, 0.35, 0.05];
const kAxes = [
  [0.9, 0.2, 0.2],
  [0.2, 0.7, 0.2],
  [0.25, 0.45, 1],
];
const kReach = 0.6; // of the size of the entity: nothing is drawn farther from the sensor
const kMark = 0.015; // of the size of the entity
/** step: between the points of an arc; rays and levels: of a fan that are drawn, its ends among them. */
const kFine = { step: Math.PI / 36, rays: 13, levels: 5 };
const kCoarse = { step: Math.PI / 12, rays: 5, levels: 2 };
const kMostFine = 60; // sensors

/** Evenly spaced angles of a fan [lowest, highest, count], at most `most` of them and both ends. */
function anglesOf([lowest, highest, count], most) {
  const number = Math.min(count, most);
  if (number === 1) return [(lowest + highest) / 2];
  return Array.from({ length: number }, (_, i) => lowest + ((highest - lowest) * i) / (number - 1));
}

/** Points on an arc, close enough to look round. */
const arcOf = ([lowest, highest], step) =>
  anglesOf([lowest, highest, Math.ceil((highest - lowest) / step) + 1], Infinity);

const along = (across, up, length) => [
  length * Math.cos(up) * Math.cos(across),
  length * Math.cos(up) * Math.sin(across),
  length * Math.sin(up),
];

/** What is drawn of a sensor, in its frame: pairs of points, and triangles between them. */
class Drawing {
  constructor(detail) {
    this.detail = detail;
    this.ends = [];
    this.colors = []; // of the ends; undefined for the colour of the sensor
    this.triangles = [];
  }

  line(from, to, color) {
    this.ends.push(from, to);
    this.colors.push(color, color);
  }

  /** A line through the points, and the surface between it and the sensor. */
  edge(points, isClosed) {
    points.forEach((point, i) => {
      if (i === 0 && !isClosed) return;
      const before = points.at(i - 1);
      this.line(before, point);
      this.triangles.push([0, 0, 0], before, point);
    });
  }

  mark(size) {
    const tips = [0, 1, 2].flatMap((axis) =>
      [1, -1].map((sign) => [0, 1, 2].map((at) => (at === axis ? sign * size : 0))),
    );
    tips.forEach((tip, i) => {
      for (const other of tips.slice(2 * Math.floor(i / 2) + 2)) this.line(tip, other);
    });
    kAxes.forEach((color, axis) =>
      this.line(
        [0, 0, 0],
        tips[2 * axis].map((part) => 3 * part),
        color,
      ),
    );
  }

  /** The near and far rectangles of a frustum, its edges, and a triangle above its upper side. */
  camera([width, height], near, far) {
    const corners = (distance) => {
      const [y, z] = [distance * Math.tan(width / 2), distance * Math.tan(height / 2)];
      return [
        [distance, y, z],
        [distance, -y, z],
        [distance, -y, -z],
        [distance, y, -z],
      ];
    };
    const ends = corners(far);
    this.edge(ends, true);
    const starts = corners(near);
    starts.forEach((point, i) => {
      this.line(starts.at(i - 1), point);
      this.line(point, ends[i]);
    });
    const top = [far, 0, ends[0][2] + 0.4 * ends[0][1]];
    this.line(ends[0], top);
    this.line(top, ends[1]);
  }

  scan(across, up, near, far) {
    const { step } = this.detail;
    const levels = anglesOf(up, this.detail.levels);
    const rays = anglesOf(across, this.detail.rays);
    for (const level of levels) {
      for (const ray of rays) this.line(along(ray, level, near), along(ray, level, far));
      if (across[2] > 1) this.edge(arcOf(across, step).map((ray) => along(ray, level, far)));
    }
    if (levels.length > 1)
      for (const ray of [rays[0], rays.at(-1)])
        this.edge(arcOf(up, step).map((level) => along(ray, level, far)));
  }
}

export class Sensors {
  /** `sizes`: the diagonal of each entity; `isShown(entity)`. */
  constructor(scene, motion, sizes, isShown) {
    this.motion = motion;
    this.isShown = isShown;
    this.all = []; // {entity, link, sensor, local, near, far, and drawing once they are drawn}
    scene.entities.forEach(({ model, pose }, entity) => {
      if (!pose) return;
      model?.sensors.forEach((sensor) => {
        if (sensor.link === undefined || !motion.links[entity][sensor.link]) return;
        const reach = kReach * sizes[entity];
        const far = Math.min(reach, sensor.farthest > 0 ? sensor.farthest : Infinity);
        const near = sensor.nearest > 0 && sensor.nearest < far ? sensor.nearest : 0;
        const local = toMatrix(sensor.pose);
        this.all.push({ entity, link: sensor.link, sensor, local, size: sizes[entity], near, far });
      });
    });
    this.group = new Group();
    this.group.visible = false;
  }

  /** They are drawn when they are shown for the first time: a scene may have thousands. */
  show(on) {
    this.group.visible = on;
    if (on && !this.lines) this.draw();
    this.move();
  }

  draw() {
    const detail = this.all.length <= kMostFine ? kFine : kCoarse;
    for (const one of this.all) {
      const { camera, across, up } = one.sensor;
      one.drawing = new Drawing(detail);
      one.drawing.mark(kMark * one.size);
      if (camera) one.drawing.camera(camera, one.near, one.far);
      else if (across) one.drawing.scan(across, up, one.near, one.far);
    }
    this.lines = new LineSegments(
      this.geometry("ends"),
      new LineBasicMaterial({ vertexColors: true, depthTest: false, transparent: true }),
    );
    this.faces = new Mesh(
      this.geometry("triangles"),
      new MeshBasicMaterial({
        vertexColors: true,
        transparent: true,
        opacity: 0.13,
        depthWrite: false,
        side: DoubleSide,
      }),
    );
    this.lines.renderOrder = kOrder.rays;
    this.faces.renderOrder = kOrder.views;
    for (const part of [this.lines, this.faces]) {
      part.frustumCulled = false;
      this.group.add(part);
    }
    this.select(this.selected);
  }

  /** Room for all points of the drawings of this kind: "ends" or "triangles". */
  geometry(kind) {
    const count = this.all.reduce((sum, { drawing }) => sum + drawing[kind].length, 0);
    const geometry = new BufferGeometry();
    for (const name of ["position", "color"])
      geometry.setAttribute(
        name,
        new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage),
      );
    return geometry;
  }

  move() {
    if (!this.group.visible) return;
    const point = new Vector3();
    for (const [part, kind] of [
      [this.lines, "ends"],
      [this.faces, "triangles"],
    ]) {
      const points = part.geometry.getAttribute("position");
      let next = 0;
      for (const { entity, link, local, drawing } of this.all) {
        const world = this.motion.links[entity][link].clone().multiply(local);
        const scale = this.isShown(entity) ? 1 : 0;
        for (const [x, y, z] of drawing[kind])
          points.setXYZ(next++, ...point.set(x, y, z).multiplyScalar(scale).applyMatrix4(world));
      }
      points.needsUpdate = true;
    }
  }

  /** Marks the sensors of a link, or one of them. Without arguments, none. */
  select(selected) {
    this.selected = selected;
    if (!this.lines) return;
    const { entity, link, sensor } = selected ?? {};
    const isChosen = (one) =>
      one.entity === entity && one.link === link && (!sensor || one.sensor === sensor);
    const [lines, faces] = [this.lines, this.faces].map((part) => part.geometry.getAttribute("color"));
    let [end, corner] = [0, 0];
    for (const one of this.all) {
      const color = isChosen(one) ? kSelected : kColor;
      for (const own of one.drawing.colors) lines.setXYZ(end++, ...(own ?? color));
      for (let i = 0; i < one.drawing.triangles.length; i++) faces.setXYZ(corner++, ...color);
    }
    lines.needsUpdate = faces.needsUpdate = true;
  }

  /** How far the field of view of a sensor is drawn, m. */
  lengthOf(entity, sensor) {
    return this.all.find((one) => one.entity === entity && one.sensor === sensor)?.far;
  }

  /** [[name, function that returns the world pose]...] */
  names() {
    return this.all
      .filter(({ entity }) => this.isShown(entity))
      .map(({ entity, link, local, sensor }) => [
        sensor.name,
        () => this.motion.links[entity][link].clone().multiply(local),
      ]);
  }
}
