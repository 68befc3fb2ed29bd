// SPDX-License-Identifier: BSD-3-Clause
// The picture of both versions over each other: the viewer's page in a frame. It selects the subject of a difference.
import { byId, element } from "../common/dom.js";
import { loadViewer, sceneIn, thingsOf } from "../common/viewer.js";
import { pairsOf } from "./pairs.js";

const kVersions = [
  ["both", "Both", "1"],
  ["old", "Old", "2"],
  ["new", "New", "3"],
];
const kLists = { visual: "visuals", collision: "collisions" };
const kLink = "link ";

const swatch = (kind, text) =>
  element("span", {}, element("span", { class: `swatch ${kind}`, "aria-hidden": "true" }), text);

export class Picture {
  /** `page` is the viewer's page, undefined when there is no picture; `names` is an OldNames. */
  constructor(page, names) {
    this.page = page;
    this.names = names;
    if (!page) return;
    this.scene = sceneIn(page);
    this.things = new Map();
    this.oldModels = this.scene.models.findIndex(({ old }) => old);
    this.buttons = kVersions.map(([version, label, key]) =>
      element(
        "button",
        { type: "button", title: `${label} (${key})`, onclick: () => this.compare(version) },
        label,
      ),
    );
    byId("versions").append(...this.buttons);
    byId("picture").hidden = false;
    document.body.classList.add("split");
    this.compare("both");
    this.viewer();
  }

  get isOpen() {
    return Boolean(this.page);
  }

  keys() {
    if (!this.isOpen) return {};
    return Object.fromEntries(kVersions.map(([version, , key]) => [key, () => this.compare(version)]));
  }

  viewer() {
    this.loaded ??= loadViewer(this.page).then((viewer) => {
      for (const { entity, other, joints } of pairsOf(this.scene, this.names))
        viewer.motion.pair(entity, other, joints);
      byId("viewer").contentDocument.addEventListener("keydown", (event) => this.onKey(event));
      return viewer;
    });
    return this.loaded;
  }

  /** Passes on the keys that are pressed in the frame. */
  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input, select")) return;
    this.keys()[event.key]?.();
  }

  /** Shows "both" versions, or the "old" or the "new" one. */
  async compare(versions) {
    this.versions = versions;
    kVersions.forEach(([version], index) =>
      this.buttons[index].setAttribute("aria-pressed", String(version === versions)),
    );
    const colours = [swatch("new", "new, solid"), swatch("old", "old, translucent")];
    const told = versions === "both" ? colours : [element("span", {}, "in its own colours")];
    byId("legend").replaceChildren(...told, swatch("selected", "selected"));
    const viewer = await this.viewer();
    viewer.showVersions(versions);
    if (this.chosen) this.select(viewer);
  }

  /** The things of a model in one version; without `model`, those of the whole scene. */
  thingsIn(isOld, model) {
    const key = `${isOld} ${model}`;
    const index = isOld && model !== undefined ? this.oldModels + model : model;
    const isWanted = (entity) =>
      Boolean(entity.old) === isOld && (model === undefined || entity.model === index);
    if (!this.things.has(key)) this.things.set(key, thingsOf(this.scene, isWanted));
    return this.things.get(key);
  }

  /** The name of a link or joint in a version. `isOld`: the given name is that of the old version. */
  nameIn(version, difference, kind, name, owner) {
    const { change, new_model: model } = difference;
    if (version === "new" || change === "removed") return name;
    return this.names.find(kind, name, owner, model);
  }

  /** The selection in a version: {entity, link, list, shape}; undefined when the picture does not show the subject. */
  find(difference, version) {
    const { change, kind, of } = difference;
    if (!this.page || change === (version === "new" ? "removed" : "added")) return undefined;
    const isOld = version === "old";
    const things = this.thingsIn(isOld, difference[`${version}_model`]);
    const name = this.nameIn(version, difference, kind, difference.name, of);
    if (of?.startsWith(kLink)) {
      const link = things.link?.get(this.nameIn(version, difference, "link", of.slice(kLink.length)));
      return link && { ...link, ...this.shapeOf(link, difference, name) };
    }
    if (kind === "entity") return things.entity?.get(name);
    if (difference.new_model === undefined && difference.old_model === undefined) return undefined;
    if (kind === "robot" || kind === "model") return things.entity && { entity: this.firstOf(things) };
    const kinds = things[kind] ? [kind] : ["link", "joint", "motor", "sensor"];
    const known = kinds.find((each) => things[each]?.has(name));
    return known && things[known].get(name);
  }

  firstOf(things) {
    return [...things.entity.values()][0].entity;
  }

  /** Finds a visual or collision by its name, or by its number among those without name. */
  shapeOf({ entity, link }, { kind, number = 1 }, name) {
    const list = kLists[kind];
    if (!list) return {};
    const shapes = this.scene.models[this.scene.entities[entity].model].links[link][list];
    const nameless = [...shapes.keys()].filter((index) => shapes[index].name === undefined);
    const shape = name ? shapes.findIndex((each) => each.name === name) : (nameless[number - 1] ?? -1);
    return shape < 0 ? {} : { list, shape };
  }

  isShown(difference) {
    return Boolean(this.find(difference, "new") ?? this.find(difference, "old"));
  }

  /** The selections for the chosen difference, in the shown version if possible: [{entity, link, shape}...]. */
  chosenIn(viewer) {
    const order = this.versions === "old" ? ["old", "new"] : ["new", "old"];
    const found = order.map((version) => this.find(this.chosen, version));
    const isOld = order[found[0] ? 0 : 1] === "old";
    byId("pictured").textContent = `${this.chosen.subject}${isOld ? ", in the old version" : ""}`;
    return found.filter(Boolean).map(({ entity, link, list, shape }) => {
      const solid = list && viewer.scene.entities[entity].model.links[link][list][shape];
      return { entity, link, shape: solid };
    });
  }

  select(viewer) {
    const [{ entity, link, shape }] = this.chosenIn(viewer);
    viewer.select(entity, link, shape);
  }

  async show(difference) {
    if (!this.isShown(difference)) return;
    this.chosen = difference;
    if (this.versions !== "both" && !this.find(difference, this.versions)) await this.compare("both");
    const viewer = await this.viewer();
    const [{ entity, link, shape }, other] = this.chosenIn(viewer);
    viewer.goTo(entity, link, shape, this.versions === "both" ? other : undefined);
  }
}
