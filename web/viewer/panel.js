// SPDX-License-Identifier: BSD-3-Clause
// Shows facts about the selected thing, and sliders for its joints.
import { Euler } from "three";

import { byId, counted, element } from "../common/dom.js";
import { ellipsoidOf } from "./inertia.js";
import { isMovable, toMatrix } from "./motion.js";

const kMoments = ["xx", "xy", "xz", "yy", "yz", "zz"];
const kMostSliders = 100; // at first: thousands take seconds to lay out
const kFewJoints = 8; // are found without a search
const kDegrees = 180 / Math.PI;

/** 1234.5678 as "1234.57": as many digits as people read. */
export function short(value) {
  if (value === 0 || !Number.isFinite(value)) return String(value ?? "unknown");
  if (Math.abs(value) < 5e-7) return "0";
  return String(Number(value.toPrecision(Math.abs(value) < 1e4 ? 5 : 7)));
}

export const massOf = (links) => links.reduce((sum, link) => sum + (link.mass ?? 0), 0);

function linksBelow(model, link) {
  const below = [link];
  for (const at of below) below.push(...model.links[at].children);
  return below.map((at) => model.links[at]);
}

/** [[term, value]...] for a pose in the world. */
function poseFacts(matrix) {
  if (!matrix) return [["World pose", "not known"]];
  const { elements } = matrix;
  const { x, y, z } = new Euler().setFromRotationMatrix(matrix, "ZYX"); // URDF's roll, pitch and yaw
  return [
    ["World position", `${[...elements.slice(12, 15)].map(short).join(", ")} m`],
    ["Roll, pitch, yaw", `${[x, y, z].map((angle) => short(angle * kDegrees)).join(", ")}°`],
  ];
}

function rangeOf({ lower, upper }, unit) {
  if (lower === undefined && upper === undefined) return "no limits";
  return `${short(lower ?? 0)} to ${short(upper ?? 0)} ${unit}`;
}

function jointFacts(model, joint) {
  if (!joint) return [];
  const isTurning = joint.type !== "prismatic";
  const facts = [["Joint above", `${joint.name} (${joint.type || "of no type"})`]];
  if (!isMovable(joint)) return facts;
  facts.push(["Axis", joint.axis.map(short).join(", ")], ["Limits", rangeOf(joint, isTurning ? "rad" : "m")]);
  const leader = model.joints[joint.leader];
  if (leader) facts.push(["Follows", `${short(joint.multiplier)} × ${leader.name} + ${short(joint.offset)}`]);
  const units = { effort: isTurning ? "N m" : "N", velocity: isTurning ? "rad/s" : "m/s" };
  units.damping = isTurning ? "N m s/rad" : "N s/m";
  units.friction = units.effort;
  for (const [key, unit] of Object.entries(units)) {
    if (joint[key] !== undefined)
      facts.push([key[0].toUpperCase() + key.slice(1), `${short(joint[key])} ${unit}`]);
  }
  return facts;
}

function linkFacts(entity, link, matrix) {
  const { model } = entity;
  const { mass, inertia, solid, visuals, collisions, joint, sensors } = model.links[link];
  const facts = [
    ["Link of", entity.title],
    ["Mass", mass === undefined ? "none" : `${short(mass)} kg`],
  ];
  const below = linksBelow(model, link);
  if (below.length > 1)
    facts.push(["With all below", `${short(massOf(below))} kg in ${counted(below.length, "link")}`]);
  facts.push(...poseFacts(matrix), ...jointFacts(model, model.joints[joint]));
  const entriesOf = (tensor) => tensor.map((value, at) => `${kMoments[at]} ${short(value)}`).join(", ");
  if (inertia) facts.push(["Inertia, kg m²", entriesOf(inertia)]);
  if (solid) facts.push(["Of its full shapes (green)", entriesOf(solid.inertia)]);
  if (mass && inertia && !ellipsoidOf(mass, inertia))
    facts.push(["Its ellipsoid", "none: no body has such moments"]);
  facts.push(["Shapes", `${counted(visuals.length, "visual")}, ${counted(collisions.length, "collision")}`]);
  const names = [...visuals, ...collisions].map((shape) => shape.name).filter(Boolean);
  if (names.length > 0) facts.push(["Names of shapes", names.join(", ")]);
  for (const sensor of sensors) facts.push(["Sensor", `${sensor.name} (${sensor.type})`]);
  return facts;
}

const degrees = (angle) => `${short(angle * kDegrees)}°`;

/** [[term, value]...] for a fan of rays [lowest, highest, number]. */
function fanFacts(term, [lowest, highest, count]) {
  if (count === 1 && lowest === highest && lowest === 0) return [];
  return [[term, `${degrees(lowest)} to ${degrees(highest)}, ${counted(count, "ray")}`]];
}

/** `length`: how far the field of view is drawn, m. */
function sensorFacts(
  entity,
  { type, link, pose, camera, across, up, nearest, farthest, why },
  world,
  length,
) {
  const facts = [
    ["Sensor of", entity.title],
    ["On the link", entity.model.links[link].name],
    ["Type", type || "none"],
  ];
  if (camera) facts.push(["Field of view", `${degrees(camera[0])} wide, ${degrees(camera[1])} high`]);
  if (across) facts.push(...fanFacts("To the sides", across), ...fanFacts("Up and down", up));
  if (nearest !== undefined) facts.push(["Nearest", `${short(nearest)} m`]);
  if (farthest !== undefined) facts.push(["Farthest", `${short(farthest)} m`]);
  if ((camera || across) && !(farthest <= length)) facts.push(["Drawn up to", `${short(length)} m`]);
  if (why) facts.push(["Not shown", why]);
  return [...facts, ...poseFacts(world?.clone().multiply(toMatrix(pose)))];
}

function entityFacts(entity, matrix, entities) {
  const facts = [["Type", entity.type]];
  if (entity.model) {
    const { links, joints, file, order } = entity.model;
    facts.push(["File", file], ["Mass", `${short(massOf(links))} kg`]);
    facts.push(
      ["Links", `${links.length}`],
      ["Joints", `${joints.length}, ${joints.filter(isMovable).length} movable`],
    );
    if (order.length < links.length)
      facts.push(["Not shown", `${counted(links.length - order.length, "link")} apart from the root`]);
  } else {
    facts.push(["Shapes", `${entity.shapes.length}`]);
  }
  facts.push(...poseFacts(matrix));
  if (entity.anchored) facts.push(["Fixed to", "the world"]);
  const { anchor, parent } = entity;
  const nameOf = ({ entity: other, link }) =>
    `${entities[other].path}, ${entities[other].model.links[link].name}`;
  if (anchor) facts.push(["Fixed to", nameOf(anchor)]);
  else if (parent) facts.push(["Placed on", nameOf(parent)]);
  return facts;
}

/**
 * `selected`: {entity, link} by index, and a sensor. It may lack the latter two, or be undefined. `length`: how far the
 * field of view of the sensor is drawn, m.
 */
export function showFacts(scene, motion, selected, length) {
  const host = byId("facts");
  if (!selected) {
    host.replaceChildren(
      element(
        "p",
        { class: "empty" },
        document.documentElement.classList.contains("in-frame")
          ? "Nothing is selected. Click a shape."
          : "Nothing is selected. Click a shape, or a row of the tree.",
      ),
    );
    return;
  }
  const entity = scene.entities[selected.entity];
  const { link, sensor } = selected;
  const isLink = link !== undefined;
  const world = isLink && motion.links[selected.entity][link];
  const factsOfLink = () =>
    sensor ? sensorFacts(entity, sensor, world, length) : linkFacts(entity, link, world);
  const facts = isLink
    ? factsOfLink()
    : entityFacts(entity, motion.entities[selected.entity], scene.entities);
  const list = element("dl");
  for (const [word, value] of facts) list.append(element("dt", {}, word), element("dd", {}, value));
  host.replaceChildren(
    element("h3", {}, sensor?.name ?? (isLink ? entity.model.links[link].name : entity.title)),
    list,
  );
}

/** With as many digits as a slider can set. */
const round = (value) =>
  short(Math.abs(value) >= 10 ? Math.round(value * 10) / 10 : Math.round(value * 1000) / 1000);

/** The range of a slider. A joint without limits gets half a turn, or one metre, each way. */
export function spanOf(joint) {
  const free = joint.type === "prismatic" ? 1 : Math.PI;
  const isFree = joint.type === "continuous" || (joint.lower === undefined && joint.upper === undefined);
  const [low, high] = isFree ? [-free, free] : [joint.lower ?? 0, joint.upper ?? 0];
  return low <= high ? [low, high] : [high, low];
}

export class Joints {
  constructor(onMove) {
    this.onMove = onMove;
    byId("poses").addEventListener("change", () => this.takePose(byId("poses").value));
    byId("reset").addEventListener("click", () => this.takePose("start"));
    byId("joint-search").addEventListener("input", () => this.fill());
    this.isInDegrees = true;
    byId("unit").addEventListener("click", () => {
      this.isInDegrees = !this.isInDegrees;
      byId("unit").textContent = this.isInDegrees ? "deg" : "rad";
      this.fill();
      this.choose(this.chosen);
    });
  }

  use(scene, motion) {
    this.scene = scene;
    this.motion = motion;
    this.entity = undefined;
    this.taken = new Map(); // the pose of each entity, "" when it was moved by hand
    this.model = undefined;
    this.movable = [];
    this.rows = [];
    this.choose();
  }

  show(entity, isWhole = false) {
    if (this.entity === entity && !isWhole) return;
    this.choose(); // the row is that of another entity
    this.entity = entity;
    this.model = this.scene.entities[entity]?.model;
    this.movable = this.model?.joints.filter(isMovable) ?? [];
    byId("joint-tools").hidden = this.movable.length === 0;
    byId("joint-search").hidden = this.movable.length <= kFewJoints;
    byId("joint-search").value = "";
    byId("joints-of").textContent =
      this.model && this.scene.entities.length > 1 ? ` of ${this.scene.entities[entity].title}` : "";
    this.isWhole = isWhole;
    this.fill();
    const poses = [
      element("option", { value: "start" }, "Start"),
      element("option", { value: "zero" }, "all at zero"),
    ];
    this.model?.poses.forEach((pose, index) => poses.push(element("option", { value: index }, pose.name)));
    byId("poses").replaceChildren(
      element("option", { value: "", disabled: true, hidden: true }, "moved by hand"),
      ...poses,
    );
    byId("poses").value = this.taken.get(entity) ?? "start";
    this.update();
  }

  /** The rows of the joints whose names contain the searched text. */
  fill() {
    const wanted = byId("joint-search").value.trim().toLowerCase();
    const found = this.movable.filter(({ name }) => name.toLowerCase().includes(wanted));
    const shown = this.isWhole ? found : found.slice(0, kMostSliders);
    this.rows = shown.map((joint) => this.row(joint, joint.index));
    const lines = this.rows.map(({ line }) => line);
    const why = this.model ? "No joint of this model moves." : "Select a model to move its joints.";
    if (this.movable.length === 0) lines.push(element("p", { class: "empty" }, why));
    else if (found.length === 0) lines.push(element("p", { class: "empty" }, "No joint has such a name."));
    if (shown.length < found.length) {
      const all = `Show all ${counted(found.length, "joint")}`;
      lines.push(element("button", { type: "button", onclick: () => this.show(this.entity, true) }, all));
    }
    byId("sliders").replaceChildren(...lines);
    this.update();
  }

  /** Shows the slider of a joint beside what is selected, too; of none without one. */
  choose(joint) {
    this.chosen = joint;
    const host = byId("selected-joint");
    this.chosenRow = joint && this.row(joint, joint.index);
    if (joint)
      host.replaceChildren(
        this.chosenRow.line,
        element("p", {}, "Drag the link in the picture to move this joint."),
      );
    else host.replaceChildren();
    this.update();
  }

  /** {text: of the unit, factor: from radians or metres} */
  unitOf(joint) {
    if (joint.type === "prismatic") return { text: "m", factor: 1 };
    return this.isInDegrees ? { text: "°", factor: kDegrees } : { text: "rad", factor: 1 };
  }

  row(joint, index) {
    const [min, max] = spanOf(joint);
    const { text, factor } = this.unitOf(joint);
    const words = text === "°" ? "degrees" : text;
    const isLed = joint.leader !== undefined;
    const moveTo = (value) => {
      if (Number.isFinite(value)) this.moveBy(joint, Math.min(max, Math.max(min, value)));
    };
    const disabled = isLed || min === max;
    const slider = element("input", {
      type: "range",
      ...{ min, max, step: "any", disabled, "aria-label": `${joint.name}, rad or m` },
      oninput: () => moveTo(slider.valueAsNumber),
    });
    const number = element("input", {
      type: "number",
      ...{ step: "any", disabled, "aria-label": `${joint.name}, ${words}` },
      onchange: () => moveTo(number.valueAsNumber / factor),
    });
    const isFree = joint.type === "continuous" || (joint.lower === undefined && joint.upper === undefined);
    const [from, to] = isFree ? ["", "no limits"] : [round(min * factor), round(max * factor)];
    const ends = isLed
      ? ["", `= ${short(joint.multiplier)} × ${this.model.joints[joint.leader].name}`]
      : [from, to];
    const line = element(
      "div",
      { class: "joint" },
      element("span", { class: "name", title: `${joint.name} (${joint.type})` }, joint.name),
      element("span", { class: "value" }, number, element("span", { class: "note" }, text)),
      element("span", { class: "slide" }, element("span", {}, ends[0]), slider, element("span", {}, ends[1])),
    );
    return { line, slider, number, index, factor };
  }

  moveBy(joint, value) {
    const positions = new Map(this.motion.positions[this.entity]);
    positions.set(joint.name, value);
    this.set(this.entity, positions);
  }

  /** Moves the joints of an entity, whether it is shown or not. */
  set(entity, positions) {
    this.motion.set(entity, positions);
    for (const each of this.motion.together(entity)) this.taken.set(each, "");
    if (entity === this.entity) {
      byId("poses").value = "";
      this.update();
    }
    this.onMove();
  }

  takePose(name) {
    if (name === "start") this.motion.reset(this.entity);
    else this.motion.set(this.entity, name === "zero" ? new Map() : this.model.poses[name].positions);
    for (const each of this.motion.together(this.entity))
      this.taken.set(each, each === this.entity ? name : "");
    byId("poses").value = name;
    this.update();
    this.onMove();
  }

  update() {
    if (!this.model) return;
    for (const { slider, number, index, factor } of [
      ...this.rows,
      ...(this.chosenRow ? [this.chosenRow] : []),
    ]) {
      const position = this.motion.position(this.entity, index);
      slider.value = position;
      if (document.activeElement !== number) number.value = round(position * factor);
    }
  }
}
