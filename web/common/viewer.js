// SPDX-License-Identifier: BSD-3-Clause
// The viewer's page in a frame beside a list: loads it, and finds what it shows by name.
import { byId } from "./dom.js";

/** The data of a page of the viewer. They contain no "<". */
export const sceneIn = (page) => JSON.parse(page.match(/id="scene" [^>]*>([^<]*)/)[1]);

/** The names of the shown things, by kind, with the {entity, link} to select. Of equal names, the first is used. */
export function thingsOf({ entities, models, meshes }, isWanted = () => true) {
  const things = {};
  const add = (kind, name, thing) => {
    things[kind] ??= new Map();
    if (name !== undefined && !things[kind].has(name)) things[kind].set(name, thing);
  };
  entities.forEach((entity, index) => {
    if (!entity.pose || !isWanted(entity)) return;
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

/** Resolves to the viewer in the frame. The list is drawn first, because loading a large robot takes seconds. */
export function loadViewer(page) {
  return new Promise((done) => {
    const frame = byId("viewer");
    frame.addEventListener("load", () => done(frame.contentWindow.smurfViewer), { once: true });
    requestAnimationFrame(() => setTimeout(() => (frame.srcdoc = page)));
  });
}
