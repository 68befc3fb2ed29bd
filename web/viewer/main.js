// SPDX-License-Identifier: BSD-3-Clause
// Reads the scene, shows it, and connects picture, tree, sliders and keys.
import { Vector3 } from "three";

import { byId, counted, element } from "../common/dom.js";
import { fromHash, toHash } from "./address.js";
import { Drag, jointAbove } from "./drag.js";
import { Host } from "./host.js";
import { Motion } from "./motion.js";
import { Overlays, bonesOf } from "./overlays.js";
import { Joints, massOf, short, showFacts } from "./panel.js";
import { readScene } from "./scene.js";
import { Layer, Shapes } from "./shapes.js";
import { Stage } from "./stage.js";
import { Textures } from "./textures.js";
import { Tree } from "./tree.js";
import { kWalkHelp, Walk } from "./walk.js";

const kWriteDelay = 300; // ms
const kWideFrame = 600; // pixels: there is room for sliders beside the picture
const host = new Host();
/** The page of a report shows the picture alone, beside its list. */
const isInFrame = window.parent !== window && !host.isWhole;

function tell(text) {
  byId("message").textContent = text;
  byId("message").hidden = text === "";
}

function makeStage() {
  try {
    return new Stage(byId("stage"));
  } catch {
    tell("This browser shows no WebGL, which the picture needs. The lists beside it work.");
    return null;
  }
}

function showTitle(scene) {
  document.title = scene.scene || "scene";
  byId("title").textContent = scene.scene || "scene";
  const models = scene.entities.filter((entity) => entity.model).map((entity) => entity.model);
  const links = models.reduce((sum, model) => sum + model.links.length, 0);
  const mass = models.reduce((sum, model) => sum + massOf(model.links), 0);
  const { length } = scene.entities;
  const words = [
    length === 1 ? "1 entity" : `${length.toLocaleString("en")} entities`,
    counted(links, "link"),
  ];
  if (mass > 0) words.push(`${Number(mass.toPrecision(4)).toLocaleString("en")} kg`);
  byId("counts").textContent = words.join(" · ");
}

function showUnseen(scene) {
  const sensors = scene.models.flatMap(({ sensors }) => sensors.filter(({ why }) => why));
  const counts = [
    [scene.unseen.length, "file"],
    [sensors.length, "sensor"],
  ].filter(([number]) => number > 0);
  byId("unseen").hidden = counts.length === 0;
  byId("unseen-count").textContent = counts.map(([number, what]) => counted(number, what)).join(", ");
  byId("unseen-boxes").hidden = scene.unseen.length === 0;
  byId("unseen-list").replaceChildren(
    ...scene.unseen.map(({ file, why, shapes }) =>
      element("li", {}, element("b", {}, file), ` ${why} (${counted(shapes, "shape")})`),
    ),
    ...sensors.map(({ name, type, why }) =>
      element("li", {}, element("b", {}, name), ` (${type || "sensor of no type"}): ${why}`),
    ),
  );
}

/** Why the stage is empty, or lacks something that the reader can do something about; "" when nothing is to be said. */
function whatIsMissing(scene, hasSolids) {
  const files = new Map();
  for (const { package: name } of scene.unseen) if (name) files.set(name, (files.get(name) ?? 0) + 1);
  if (files.size > 0) {
    const takesDrops = document.documentElement.dataset.drops !== undefined; // the playground
    return [...files]
      .map(([name, count]) => {
        const cure = takesDrops
          ? "Drop its folder on this page, too"
          : `Name its folder: --package ${name}=DIR`;
        return `${counted(count, "file")} of the package ${name} ${count === 1 ? "was" : "were"} not found. ${cure}`;
      })
      .join("\n");
  }
  if (hasSolids) return "";
  if (scene.unseen.length > 0)
    return `${counted(scene.unseen.length, "file")} cannot be shown: "Not shown", below the tree, says why.`;
  return "Nothing in this scene has a shape. Frames (A) show where things are.";
}

/** Whether a solid belongs to {entity, link, shape}, of which the latter two may be absent. */
function isOf(solid, thing) {
  if (!thing || solid.entity !== thing.entity) return false;
  return (
    (thing.link === undefined || solid.link === thing.link) && (!thing.shape || solid.shape === thing.shape)
  );
}

class Viewer {
  constructor(scene) {
    this.versions = "both";
    this.stage = makeStage();
    this.joints = new Joints(() => this.move());
    this.tree = new Tree(byId("tree"), (entity, link, sensor) => {
      this.select(entity, link, undefined, sensor);
      host.tellSelected(this.scene, this.selected);
    });
    this.setScene(scene);
    if (this.stage) this.setUpStage();
    this.setUpTools();
    window.addEventListener("hashchange", () => this.readHash());
    this.readHash();
  }

  setScene(scene) {
    this.scene = scene;
    this.motion = new Motion(scene);
    this.isSingle = scene.entities.filter(({ old }) => !old).length === 1;
    this.selected = undefined;
    showTitle(scene);
    showUnseen(scene);
    if (this.stage) this.fillStage();
    this.joints.use(scene, this.motion);
    this.tree.show(scene);
    if (this.stage) tell("");
    if (scene.entities.length === 0) {
      tell("The scene is empty: it has no entities.");
      byId("tree").replaceChildren(element("p", { class: "empty" }, "no entities"));
    } else if (this.shapes) {
      tell(whatIsMissing(scene, this.shapes.solids.length > 0));
    }
    this.showFacts();
    this.joints.show(scene.entities.findIndex((entity) => entity.model && entity.pose));
  }

  /** Shows a newer version of the scene; camera, joints, selection and layers stay as they are. */
  replaceScene(scene) {
    const kept = this.hash();
    this.measured &&= [];
    this.setScene(scene);
    for (const [id, , , show] of this.layers ?? [])
      if (id !== "walk" && id !== "ruler") show(byId(id).getAttribute("aria-pressed") === "true");
    this.readHash(kept);
    this.stage?.draw();
  }

  fillStage() {
    this.shapes?.remove();
    this.overlays?.remove();
    const isFirst = !this.shapes;
    this.textures = new Textures(
      this.scene.textures,
      (texture) => {
        this.shapes.load(texture);
        this.stage.draw();
      },
      (texture) => this.addUnseen(texture),
    );
    this.shapes = new Shapes(this.scene, this.motion, this.stage.root, this.textures);
    const all = this.boxOfAll();
    this.stage.setGround(all, this.isSingle);
    this.stage.boxOfShadow = () => this.shapes.boxAround();
    this.overlays = new Overlays(this.scene, this.motion, this.stage, this.sizes());
    if (isFirst || this.stage.fitted) this.stage.fit(all, isFirst ? undefined : this.stage.direction());
  }

  setUpStage() {
    this.walk = new Walk(this.stage);
    this.stage.onGrab((solid, point) => this.grab(solid, point));
    this.stage.onLook(() => this.writeHashSoon());
    this.stage.onPick((solid, point) => {
      if (this.measured) this.measure(point);
      else this.select(solid?.entity, solid?.link);
      host.tellSelected(this.scene, this.selected);
    });
    this.layers = [
      [
        "visuals",
        "Visuals",
        "v",
        (on) => [Layer.visuals, Layer.unseen].forEach((layer) => this.shapes.show(layer, on)),
      ],
      ["collisions", "Collisions", "c", (on) => this.shapes.show(Layer.collisions, on)],
      ["frames", "Frames", "a", (on) => this.overlays.show("frames", on)],
      ["axes", "Joint axes", "j", (on) => this.overlays.show("axes", on)],
      ["masses", "Centres of mass", "m", (on) => this.overlays.show("masses", on)],
      [
        "inertias",
        "Inertias",
        "i",
        (on) => ["inertias", "solids"].forEach((name) => this.overlays.show(name, on)),
      ],
      ["sensors", "Sensors", "r", (on) => this.showSensors(on)],
      ["skeleton", "Skeleton", "k", (on) => this.overlays.show("skeleton", on)],
      ["names", "Names", "n", (on) => this.showNames(on)],
      ["ground", "Grid", "g", (on) => (this.stage.grid.visible = on)],
      ["up", "Y is up", "u", (on) => this.setUp(on)],
      ["ruler", "Measure", "d", (on) => this.startMeasuring(on), "modes"],
      ["walk", "Walk", "w", (on) => this.startWalking(on), "modes"],
    ];
    document.documentElement.classList.toggle("compared", isInFrame && this.shapes.isCompared);
    if (
      isInFrame &&
      this.scene.entities.some(({ model }) => model?.joints.some(({ type }) => type !== "fixed"))
    )
      this.layers.push([
        "moves",
        "Joints",
        "s",
        (on) => document.documentElement.classList.toggle("with-joints", on),
        "layers",
      ]);
  }

  /** Which axis of the world points up. One can only walk where it is z. */
  setUp(isY) {
    if (this.stage.isYUp === isY) return;
    if (this.walk.isOn) byId("walk").click();
    byId("walk").disabled = isY;
    this.stage.setUp(isY);
    const all = this.boxOfAll();
    const { visible } = this.stage.grid;
    this.stage.setGround(all, this.isSingle);
    this.stage.grid.visible = visible;
    this.stage.fit(all);
    this.writeHashSoon();
  }

  /** Lets a selected link be dragged, which moves the joint above it. */
  grab(solid, point) {
    if (this.measured || this.walk.isOn || solid?.link === undefined || !this.isSelected(solid))
      return undefined;
    if (!jointAbove(this.scene.entities[solid.entity].model, solid.link)) return undefined;
    return new Drag(this, solid.entity, solid.link, point);
  }

  /** The box around all shapes, and around the joints of robots that lack shapes. */
  boxOfAll() {
    const box = this.shapes.boxAround();
    for (const { entity, link } of bonesOf(this.scene))
      box.expandByPoint(new Vector3().setFromMatrixPosition(this.motion.links[entity][link]));
    return box;
  }

  /** The diagonal of each entity's bounding box. */
  sizes() {
    const whole = this.stage ? this.boxOfAll() : null;
    const length = (box) => (box.isEmpty() ? 0 : box.min.distanceTo(box.max));
    const sizeOf = (solids) => length(this.shapes.boxAround(solids)) || length(whole) / 10 || 1;
    return this.shapes.solidsOf.map(sizeOf);
  }

  setUpTools() {
    const hasVisuals = this.shapes?.has(Layer.visuals) || this.shapes?.has(Layer.unseen);
    const isOn = new Set(["ground", "visuals", ...(hasVisuals ? [] : ["collisions"])]);
    if (this.overlays?.bones.length > 0) isOn.add("skeleton");
    if (window.innerWidth >= kWideFrame) isOn.add("moves");
    const keys = new Map([
      ["f", () => this.fit()],
      ["Escape", () => (this.walk?.isOn ? byId("walk").click() : this.select())],
    ]);
    for (const [id, label, key, show, place = "layers"] of this.layers ?? []) {
      const title = `${label} (${key.toUpperCase()})`;
      const button = element("button", { type: "button", id, title }, element("span", {}, label));
      if (place === "layers") button.append(element("kbd", { "aria-hidden": "true" }, key.toUpperCase()));
      const set = (on) => {
        button.setAttribute("aria-pressed", on);
        show(on);
        this.stage.touch();
      };
      const toggle = () => set(button.getAttribute("aria-pressed") !== "true");
      button.addEventListener("click", toggle);
      keys.set(key, toggle);
      byId(place).append(button);
      set(isOn.has(id));
    }
    this.setUpMenu();
    this.setUpPanels(keys);
    byId("picture").hidden = !this.stage;
    byId("picture").addEventListener("click", () => this.savePicture());
    keys.set("p", () => this.savePicture());
    byId("fit").addEventListener("click", () => this.fit());
    document.addEventListener("keydown", (event) => this.onKey(event, keys));
  }

  /** The menu of layers closes when something else is clicked, and with Escape. */
  setUpMenu() {
    const [button, list] = [byId("show"), byId("layers")];
    const open = (isOpen) => {
      button.setAttribute("aria-expanded", isOpen);
      list.hidden = !isOpen && !isInFrame;
    };
    open(false);
    button.addEventListener("click", () => open(list.hidden));
    document.addEventListener("pointerdown", ({ target }) => byId("menu").contains(target) || open(false));
    byId("menu").addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || list.hidden) return;
      open(false);
      button.focus();
      event.stopPropagation();
    });
  }

  /** The lists at the sides fold. */
  setUpPanels(keys) {
    for (const [id, name, key] of [
      ["show-tree", "without-tree", "["],
      ["show-panel", "without-panel", "]"],
    ]) {
      const toggle = () => {
        const isOff = document.documentElement.classList.toggle(name);
        byId(id).setAttribute("aria-pressed", !isOff);
      };
      byId(id).addEventListener("click", toggle);
      keys.set(key, toggle);
    }
  }

  savePicture() {
    this.stage?.takePicture((picture) => {
      const href = URL.createObjectURL(picture);
      element("a", { href, download: `${document.title.replace(/\.[a-z.]+$/i, "")}.png` }).click();
      setTimeout(() => URL.revokeObjectURL(href), 60_000);
    });
  }

  onKey(event, keys) {
    const isTyping = event.target.matches("input, select, textarea");
    if (event.ctrlKey || event.metaKey || event.altKey || (isTyping && event.key !== "Escape")) return;
    if (this.walk?.press(event)) return void event.preventDefault();
    const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    const zooms = { "+": 0.9, "=": 0.9, "-": 1 / 0.9 };
    if (keys.has(event.key)) keys.get(event.key)();
    else if (this.stage && event.target === byId("stage") && turns[event.key])
      this.stage.turn(...turns[event.key]);
    else if (this.stage && zooms[event.key]) this.stage.turn(0, 0, zooms[event.key]);
    else return;
    event.preventDefault();
  }

  showLayer(layer) {
    this.press(layer === Layer.collisions ? "collisions" : "visuals");
  }

  /** Shows what the button shows. */
  press(id) {
    const button = byId(id);
    if (button?.getAttribute("aria-pressed") === "false") button.click();
  }

  showFacts() {
    const { entity, sensor } = this.selected ?? {};
    const length = sensor && this.overlays?.sensors.lengthOf(entity, sensor);
    showFacts(this.scene, this.motion, this.selected, length);
  }

  startWalking(isOn) {
    if (isOn) this.walk.start();
    if (isOn || this.walk.isOn) tell(isOn ? kWalkHelp : "");
    if (isOn) byId("stage").focus({ preventScroll: true });
    else this.walk.stop();
  }

  startMeasuring(isOn) {
    if (isOn || this.measured) tell(isOn ? "Click two points to measure their distance." : "");
    this.measured = isOn ? [] : undefined;
    this.overlays.setRuler();
  }

  measure(point) {
    if (!point) return;
    if (this.measured.length === 2) this.measured = [];
    this.measured.push(point);
    const [from, to] = this.measured;
    this.overlays.setRuler(from, to);
    this.stage.draw();
    const along = to && to.clone().sub(from);
    tell(
      to
        ? `${short(along.length())} m: ${["x", "y", "z"].map((axis) => `${axis} ${short(along[axis])}`).join(", ")}`
        : "Click the second point.",
    );
  }

  /** Shows the names of the selected entity's links, or those of all entities. */
  showNames(on = this.namesAreOn) {
    this.namesAreOn = on;
    const { entities } = this.scene;
    const chosen = this.selected?.entity ?? (this.isSingle ? 0 : undefined);
    const { model } = entities[chosen] ?? {};
    const ofLinks = () =>
      model.order.map((link) => [model.links[link].name, () => this.motion.links[chosen][link]]);
    const ofEntities = () =>
      entities.flatMap(({ path, pose }, index) =>
        pose && this.overlays.isShown(index) ? [[path, () => this.motion.entities[index]]] : [],
      );
    const named = model?.order.length ? ofLinks() : ofEntities();
    if (this.overlays.sensors.group.visible) named.unshift(...this.overlays.sensors.names());
    this.overlays.setNames(on ? named : []);
  }

  showSensors(on) {
    this.overlays.sensors.show(on);
    if (this.namesAreOn) this.showNames();
  }

  /** Lists a texture that the browser cannot decode. */
  addUnseen(texture) {
    const shapes = this.shapes.solids.filter(({ shape }) => shape.texture === texture).length;
    const { file } = this.scene.textures[texture];
    this.scene.unseen.push({ file, why: "is damaged", shapes });
    showUnseen(this.scene);
  }

  move() {
    this.shapes?.move(this.motion.takeMoved());
    this.overlays?.move();
    this.stage?.touch();
    this.showFacts();
    this.writeHashSoon();
  }

  isSelected(solid) {
    return isOf(solid, this.selected);
  }

  /** `shape`: one of the link; undefined: all of them. `sensor`: one that is on the link. */
  select(entity, link, shape, sensor) {
    this.selected = entity === undefined ? undefined : { entity, link, shape, sensor };
    this.tree.select(entity, link, sensor);
    if (sensor) this.press("sensors");
    this.overlays?.sensors.select(this.selected);
    this.showFacts();
    if (entity !== undefined) this.joints.show(entity);
    const { model } = this.scene.entities[entity] ?? {};
    this.joints.choose(link === undefined ? undefined : jointAbove(model, link));
    this.shapes?.paint((solid) => this.isSelected(solid));
    if (this.namesAreOn) this.showNames();
    this.stage?.draw();
    this.writeHash();
  }

  /** Brings the selected thing into view, or the whole scene. */
  fit() {
    if (!this.stage) return;
    if (this.walk.isOn) byId("walk").click();
    const chosen = this.selected
      ? this.shapes.boxAround(this.shapes.solids.filter((solid) => this.isSelected(solid)))
      : null;
    this.stage.fit(chosen && !chosen.isEmpty() ? chosen : this.boxOfAll(), this.stage.direction());
    this.writeHashSoon();
  }

  /** Shows "both" versions, or the "old" or the "new" one. */
  showVersions(versions) {
    this.versions = versions;
    if (!this.stage) return;
    this.shapes.compare(versions);
    this.shapes.paint((solid) => this.isSelected(solid));
    this.overlays.versions = versions;
    this.overlays.move();
    this.showNames();
    this.stage.touch();
  }

  /**
   * Selects a thing, and shows it with what is around it, and with the same thing of another version, {entity, link,
   * shape}.
   */
  goTo(entity, link, shape, other) {
    this.select(entity, link, shape);
    if (!this.stage) return;
    const { solids } = this.shapes;
    if (shape) solids.filter((solid) => this.isSelected(solid)).forEach(({ layer }) => this.showLayer(layer));
    const box = this.shapes.boxAround(solids.filter((solid) => this.isSelected(solid) || isOf(solid, other)));
    if (box.isEmpty()) return void this.fit();
    const all = this.shapes.boxAround();
    const margin = Math.max(box.min.distanceTo(box.max), all.min.distanceTo(all.max) / 10);
    this.stage.fit(box.expandByScalar(margin).intersect(all), this.stage.direction());
  }

  /** What is selected and moved, and the camera, for readHash(). */
  hash() {
    return toHash(this.scene, this.motion, this.selected, this.stage?.view());
  }

  writeHash() {
    clearTimeout(this.writing);
    if (window.parent !== window) return; // it has no address of its own
    history.replaceState(null, "", this.hash());
  }

  /** Browsers limit how often the address may change. */
  writeHashSoon() {
    clearTimeout(this.writing);
    this.writing = setTimeout(() => this.writeHash(), kWriteDelay);
  }

  readHash(hash = location.hash) {
    const { entity, link, positions, camera } = fromHash(this.scene, hash);
    for (const [moved, values] of positions) this.joints.set(moved, values);
    if (camera) this.stage?.look(camera);
    if (entity !== undefined) this.select(entity, link);
  }
}

document.documentElement.classList.toggle("in-frame", isInFrame);
const scene = readScene(byId("scene").textContent);
window.smurfViewer = new Viewer(scene);
host.connect(window.smurfViewer);
document.documentElement.dataset.ready = "true";
