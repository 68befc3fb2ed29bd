// SPDX-License-Identifier: BSD-3-Clause
// The program that shows the page and knows the file behind it: an editor, or the page of `smurf-view --watch`.
//
// Messages to the page: {scene: JSON of a newer version}, {select: name of a link}, {problem: text, "" when there is none}.
// Messages from the page: {selected: name of a link, entity: its path}, {problem: true} when the problem is clicked.
import { byId } from "../common/dom.js";
import { readScene } from "./scene.js";

const kWhole = "smurf-view"; // the name of a frame that shows the whole page

export class Host {
  constructor() {
    const editor = window.acquireVsCodeApi?.();
    /** Whether the page is shown with its lists, although it is in a frame. */
    this.isWhole = Boolean(editor) || window.name === kWhole;
    /** VS Code removes window.parent from pages that it shows, and lets nobody else send messages to them. */
    this.isHost = (source) => Boolean(editor) || source === window.parent || source === window;
    this.send = editor
      ? (message) => editor.postMessage(message)
      : (message) => this.isWhole && window.parent.postMessage(message, "*");
  }

  connect(viewer) {
    if (!this.isWhole) return;
    window.addEventListener("message", ({ data, source }) => {
      if (!this.isHost(source)) return;
      if (typeof data?.scene === "string") viewer.replaceScene(readScene(data.scene));
      if (typeof data?.problem === "string") this.showProblem(data.problem);
      if (typeof data?.select === "string") this.select(viewer, data.select);
    });
    byId("problem").addEventListener("click", () => this.send({ problem: true }));
    this.send({ isReady: true });
  }

  /** Of several robots with such a link, the one that is selected, else the first. */
  select(viewer, name) {
    const { entities } = viewer.scene;
    const linkIn = (entity) => entities[entity]?.model?.links.findIndex((link) => link.name === name) ?? -1;
    const wanted = [viewer.selected?.entity, ...entities.keys()].find((entity) => linkIn(entity) >= 0);
    if (wanted !== undefined) viewer.select(wanted, linkIn(wanted));
  }

  showProblem(text) {
    byId("problem").textContent = text;
    byId("problem").hidden = text === "";
  }

  tellSelected(scene, selected) {
    if (selected?.link === undefined) return;
    const { path, model } = scene.entities[selected.entity];
    this.send({ selected: model.links[selected.link].name, entity: path });
  }
}
