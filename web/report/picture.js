// SPDX-License-Identifier: BSD-3-Clause
// The robot or scene beside the list: the viewer's page in a frame. It selects the link or joint of a finding.
import { byId } from "../common/dom.js";

/** What a page of the viewer shows: its data, in which there is no "<". */
const sceneIn = (page) => JSON.parse(page.match(/id="scene" [^>]*>([^<]*)/)[1]);

/** Names of what is shown, by kind, with the {entity, link} to select. The first of a name counts. */
function thingsOf({ entities, models, meshes }) {
  const things = {};
  const add = (kind, name, thing) => {
    things[kind] ??= new Map();
    if (name !== undefined && !things[kind].has(name)) things[kind].set(name, thing);
  };
  entities.forEach((entity, index) => {
    if (!entity.pose) return;
    add("entity", entity.path, { entity: index });
    add("entity", entity.path.split("/").at(-1), { entity: index });
    const { links = [], joints = [], devices = [] } = models[entity.model] ?? {};
    const addLink = (kind, name, link) => {
      if (links[link] && !links[link].unplaced) add(kind, name, { entity: index, link });
    };
    links.forEach(({ name, visuals, collisions }, link) => {
      addLink("link", name, link);
      for (const { mesh } of [...visuals, ...collisions])
        if (mesh !== undefined) addLink("mesh", meshes[mesh].file, link);
    });
    for (const { name, child } of joints) addLink("joint", name, child);
    for (const { kind, name, link } of devices) addLink(kind, name, link);
  });
  return things;
}

/** Names that a finding mentions, those of its place first: [[kind or "", name]]. */
function namesIn({
  file,
  pointer = "",
  names = "",
  message,
  caret = "",
  labels = [],
  help = "",
  notes = [],
}) {
  const found = [["mesh", file]];
  for (const [, kind, name] of pointer.matchAll(/\/(link|joint)\[@name='([^']*)'\]/g))
    found.push([kind, name]);
  for (const [, name] of names.matchAll(/name=([^/]*)/g)) found.push(["", name]);
  const texts = [caret, message, ...labels.map((label) => label.message), ...notes, help];
  for (const [, name] of texts.join("\n").matchAll(/`([^`]+)`/g)) found.push(["", name]);
  return found;
}

export class Picture {
  /** `page`: the viewer's; undefined: there is no picture. */
  constructor(page) {
    this.page = page;
    this.things = page && thingsOf(sceneIn(page));
    byId("close").addEventListener("click", () => this.close());
  }

  get isOpen() {
    return !byId("picture").hidden;
  }

  /** What to select for a finding: {kind, name, entity, link}; undefined when it is about nothing that is shown. */
  find(finding) {
    if (!this.things) return undefined;
    for (const [kind, name] of namesIn(finding)) {
      const kinds = kind ? [kind] : ["link", "joint", "entity", "motor", "sensor"];
      const known = kinds.find((each) => this.things[each]?.has(name));
      if (known) return { kind: known, name, ...this.things[known].get(name) };
    }
    return undefined;
  }

  /** The viewer in the frame, which is loaded when it is first needed. */
  viewer() {
    this.loaded ??= new Promise((done) => {
      const frame = byId("viewer");
      frame.addEventListener("load", () => done(frame.contentWindow.smurfViewer), { once: true });
      frame.srcdoc = this.page;
    });
    return this.loaded;
  }

  open(text) {
    if (!this.isOpen) this.before = document.activeElement;
    byId("picture").hidden = false;
    byId("pictured").textContent = text;
    document.body.classList.add("split");
    return this.viewer();
  }

  async show(finding) {
    const thing = this.find(finding);
    if (!thing) return;
    const viewer = await this.open(`${thing.kind} ${thing.name}`);
    viewer.goTo(thing.entity, thing.link);
  }

  close() {
    byId("picture").hidden = true;
    document.body.classList.remove("split");
    this.before?.focus();
  }
}
