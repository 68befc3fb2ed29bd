// SPDX-License-Identifier: BSD-3-Clause
// The picture beside the list: the viewer's page in a frame. It selects the link or joint of a finding.
import { byId } from "../common/dom.js";
import { loadViewer, sceneIn, thingsOf } from "../common/viewer.js";

const kInertials = "SML15"; // rules about them: the picture shows both ellipsoids, as written and of the shapes

/** The names in a finding, those of its place first: [[kind or "", name]]. */
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
  /** `page` is the viewer's page; undefined when there is no picture. */
  constructor(page) {
    this.page = page;
    this.things = page && thingsOf(sceneIn(page));
    byId("close").addEventListener("click", () => this.close());
  }

  get isOpen() {
    return !byId("picture").hidden;
  }

  /** The selection for a finding: {kind, name, entity, link}; undefined when the picture does not show its subject. */
  find(finding) {
    if (!this.things) return undefined;
    for (const [kind, name] of namesIn(finding)) {
      const kinds = kind ? [kind] : ["link", "joint", "entity", "motor", "sensor"];
      const known = kinds.find((each) => this.things[each]?.has(name));
      if (known) return { kind: known, name, ...this.things[known].get(name) };
    }
    return undefined;
  }

  /** The viewer in the frame. Loads it at the first call. */
  viewer() {
    this.loaded ??= loadViewer(this.page);
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
    if (finding.id.startsWith(kInertials)) viewer.press("inertias");
  }

  /** The view of the picture in the notation of its address; undefined while it is closed or loading. */
  get hash() {
    return this.isOpen ? byId("viewer").contentWindow?.smurfViewer?.hash() : undefined;
  }

  /** Closes the picture. False if it was closed before. */
  close() {
    if (!this.isOpen) return false;
    byId("picture").hidden = true;
    document.body.classList.remove("split");
    this.before?.focus();
    return true;
  }
}
