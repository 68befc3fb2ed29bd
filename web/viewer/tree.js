// SPDX-License-Identifier: BSD-3-Clause
// Shows entities, their links and sensors as an ARIA tree: arrows move and open, Enter selects.
import { byId, counted, element } from "../common/dom.js";

const kOpenAtOnce = 60; // rows
const kDeepest = 60; // groups in groups: browsers do not lay out thousands of them
const kIndented = 7; // levels: deeper rows would have no room for their names
const kWhole = 24; // letters of a name that is shown in one piece
const kEnd = 9; // letters that are always shown of a longer one
const kMostFound = 100; // rows of a search

/** A name of which, in a narrow row, beginning and end can be read: names of CAD programs differ at their ends. */
function named(name) {
  const cut = name.length > kWhole ? name.length - kEnd : name.length;
  const end = cut < name.length ? element("span", { class: "end" }, name.slice(cut)) : undefined;
  return element("span", { class: "name" }, element("span", {}, name.slice(0, cut)), end);
}

export class Tree {
  constructor(host, onSelect) {
    this.host = host;
    this.onSelect = onSelect;
    host.setAttribute("role", "tree");
    host.addEventListener("keydown", (event) => this.onKey(event));
    byId("tree-search").addEventListener("input", () => this.search(byId("tree-search").value));
  }

  show(scene) {
    const { host } = this;
    this.scene = scene;
    this.rows = new Map(); // by key
    this.selected = undefined;
    this.nodes = scene.entities.map((entity, index) => this.entityRow(entity, index));
    host.replaceChildren(...this.nodes);
    byId("tree-search").value = "";
    const count = scene.entities.reduce(
      (sum, { model }) => sum + 1 + (model?.links.length ?? 0) + (model?.sensors.length ?? 0),
      0,
    );
    byId("tree-search").hidden = count <= kOpenAtOnce;
    if (count <= kOpenAtOnce) for (const row of [...host.children]) this.open(row.firstChild, true, true);
    else if (scene.entities.length === 1) this.openWidely(host.firstChild.firstChild);
    const first = host.querySelector("[role=treeitem]");
    if (first) first.tabIndex = 0;
  }

  /** Shows the entities, links and sensors whose names contain the text, as a list; the tree for no text. */
  search(text) {
    const wanted = text.trim().toLowerCase();
    if (wanted === "") {
      this.host.replaceChildren(...this.nodes);
      this.select(this.selected?.entity, this.selected?.link, this.selected?.sensor);
      return;
    }
    const found = [];
    this.scene.entities.forEach(({ path, type, model }, entity) => {
      found.push([path || type, { entity }]);
      model?.links.forEach(({ name }, link) => found.push([name, { entity, link }]));
      for (const sensor of model?.sensors ?? [])
        found.push([sensor.name, { entity, link: sensor.link, sensor }]);
    });
    const fitting = found.filter(([name]) => name.toLowerCase().includes(wanted));
    const rows = fitting.slice(0, kMostFound).map(([name, thing]) => {
      const row = element("div", {
        role: "treeitem",
        class: "line",
        tabindex: "-1",
        "aria-level": 1,
        title: name,
      });
      row.append(element("span", { class: "arrow", "aria-hidden": "true" }), named(name));
      row.addEventListener("click", () => this.onSelect(thing.entity, thing.link, thing.sensor));
      return Object.assign(row, thing, { below: [] });
    });
    const more = fitting.length - rows.length;
    this.host.replaceChildren(...rows);
    if (rows.length > 0) rows[0].tabIndex = 0;
    else this.host.append(element("p", { class: "empty" }, "no name contains this"));
    if (more > 0) this.host.append(element("p", { class: "empty" }, `and ${counted(more, "other")}`));
  }

  static key(entity, link, sensor) {
    const key = link === undefined ? `${entity}` : `${entity} ${link}`;
    return sensor ? `${key} sensor ${sensor.index}` : key;
  }

  entityRow(entity, index) {
    const note = entity.pose ? entity.type : "has no known place";
    const model = entity.model;
    const below = model?.root >= 0 ? [{ link: model.root }] : [];
    return this.row(entity.path || entity.type, note, { entity: index }, below, 1);
  }

  /**
   * A node with its row for {entity, link, sensor}, of which the latter two may be absent. The group of rows for what is
   * below, [{link, sensor}...], is added when it is opened.
   */
  row(name, note, { entity, link, sensor }, below, level) {
    const row = element(
      "div",
      {
        role: "treeitem",
        class: "line",
        tabindex: "-1",
        "aria-selected": "false",
        "aria-level": level,
        title: name,
      },
      element("span", { class: "arrow", "aria-hidden": "true" }),
      named(name),
    );
    if (note) row.append(element("span", { class: "note" }, note));
    Object.assign(row, { entity, link, sensor, below, level });
    if (below.length > 0) row.setAttribute("aria-expanded", "false");
    row.addEventListener("click", (event) => {
      if (event.target.className === "arrow") this.open(row, row.getAttribute("aria-expanded") !== "true");
      else this.onSelect(entity, link, sensor);
    });
    this.rows.set(Tree.key(entity, link, sensor), row);
    return element("div", { role: "none", class: "node" }, row);
  }

  /** Opens or closes a row. Its links get rows when it is opened for the first time. */
  open(row, isOpen, isDeep = false) {
    if (row.below.length === 0) return;
    row.nodes ??= this.addBelow(row);
    if (row.group) {
      row.group.hidden = !isOpen;
      row.setAttribute("aria-expanded", isOpen);
    } else {
      this.openBeside(row, isOpen);
    }
    if (isDeep) for (const node of row.nodes) this.open(node.firstChild, isOpen, true);
  }

  /** Opens rows level by level until enough of them are visible. */
  openWidely(first) {
    const rows = [first];
    let shown = 1;
    for (const row of rows) {
      if (shown + row.below.length > kOpenAtOnce) return;
      shown += row.below.length;
      this.open(row, true);
      rows.push(...(row.nodes ?? []).map((node) => node.firstChild));
    }
  }

  addBelow(row) {
    const { model } = this.scene.entities[row.entity];
    const nodes = row.below.map(({ link, sensor }) => {
      const { name, children, sensors } = model.links[link];
      const below = [
        ...sensors.map((each) => ({ link, sensor: each })),
        ...children.map((each) => ({ link: each })),
      ];
      const node = sensor
        ? this.row(sensor.name, sensor.type, { entity: row.entity, link, sensor }, [], row.level + 1)
        : this.row(name, "", { entity: row.entity, link }, below, row.level + 1);
      node.firstChild.above = row;
      return node;
    });
    if (row.level < kDeepest) {
      row.group = element("div", { role: "group", class: row.level > kIndented ? "deep" : "" }, ...nodes);
      row.after(row.group);
    } else {
      row.parentElement.after(...nodes);
    }
    return nodes;
  }

  /** As open(), for a row at the greatest depth, whose rows below are its siblings on the page. */
  openBeside(row, isOpen) {
    const rows = [row];
    for (const each of rows) {
      each.setAttribute("aria-expanded", isOpen);
      for (const node of each.nodes) {
        node.hidden = !isOpen;
        if (!isOpen && node.firstChild.getAttribute("aria-expanded") === "true") rows.push(node.firstChild);
      }
    }
  }

  select(entity, link, sensor) {
    this.selected?.setAttribute("aria-selected", "false");
    this.selected = undefined;
    if (entity === undefined) return;
    if (link !== undefined) this.reveal(entity, link, sensor);
    this.selected = this.rows.get(Tree.key(entity, link, sensor));
    if (!this.selected) return;
    this.selected.setAttribute("aria-selected", "true");
    this.focusable(this.selected);
    this.selected.querySelector(".name").scrollIntoView({ block: "nearest", inline: "nearest" });
  }

  reveal(entity, link, sensor) {
    const { model } = this.scene.entities[entity];
    if (model.links[link].unplaced) return; // it has no row, and may be in a ring
    const way = [];
    for (let at = link; at !== undefined; at = model.joints[model.links[at].joint]?.parent) way.unshift(at);
    this.open(this.rows.get(Tree.key(entity)), true);
    for (const at of sensor ? way : way.slice(0, -1)) this.open(this.rows.get(Tree.key(entity, at)), true);
  }

  focusable(row) {
    for (const other of this.host.querySelectorAll("[tabindex='0']")) other.tabIndex = -1;
    if (row) row.tabIndex = 0;
  }

  onKey(event) {
    const row = event.target.closest("[role=treeitem]");
    if (!row) return;
    const shown = [...this.host.querySelectorAll("[role=treeitem]")].filter(
      (each) => each.offsetParent !== null,
    );
    const at = shown.indexOf(row);
    const isOpen = row.getAttribute("aria-expanded") === "true";
    const go = (other) => {
      if (!other) return;
      this.focusable(other);
      other.focus();
    };
    const keys = {
      ArrowDown: () => go(shown[at + 1]),
      ArrowUp: () => go(shown[at - 1]),
      Home: () => go(shown[0]),
      End: () => go(shown.at(-1)),
      ArrowRight: () => (isOpen ? go(shown[at + 1]) : this.open(row, true)),
      ArrowLeft: () => (isOpen ? this.open(row, false) : go(row.above)),
      Enter: () => this.onSelect(row.entity, row.link, row.sensor),
      " ": () => this.onSelect(row.entity, row.link, row.sensor),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key]();
  }
}
