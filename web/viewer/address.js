// SPDX-License-Identifier: BSD-3-Clause
// The view in the address of the page, so that a link shows the same: the selected thing, the joints that were moved,
// and the camera. Names are used instead of indices, because a later version of the model may have other indices.

const kMostJoints = 200; // browsers limit the length of an address

function movedJoints(scene, motion) {
  return scene.entities.flatMap((entity, index) => {
    const positions = motion.positions[index];
    const names = new Set([...entity.start.keys(), ...positions.keys()]);
    return [...names]
      .filter((name) => positions.get(name) !== entity.start.get(name))
      .map((name) => [entity.path, name, positions.get(name) ?? 0]);
  });
}

/** `camera`: position and target in metres, absent when the view is fitted. */
export function toHash(scene, motion, selected, camera) {
  const words = new URLSearchParams();
  const { entity, link } = selected ?? {};
  if (entity !== undefined) words.set("entity", scene.entities[entity].path);
  if (link !== undefined) words.set("link", scene.entities[entity].model.links[link].name);
  for (const joint of movedJoints(scene, motion).slice(0, kMostJoints))
    words.append("joint", JSON.stringify(joint));
  if (camera) words.set("camera", camera.map((number) => Number(number.toPrecision(5))).join(","));
  return `#${words}`;
}

/** [path, name, position], or nothing when somebody wrote something else. */
function jointOf(text) {
  try {
    const [path, name, position] = JSON.parse(text);
    return typeof name === "string" && Number.isFinite(position) ? [[path, name, position]] : [];
  } catch {
    return [];
  }
}

/** {entity, link, positions: Map of a Map for each moved entity, camera}; whatever names nothing is absent. */
export function fromHash(scene, hash) {
  const words = new URLSearchParams(hash.slice(1));
  const find = (path) => scene.entities.findIndex((each) => each.path === path);
  const entity = find(words.get("entity"));
  const link = scene.entities[entity]?.model?.links.findIndex(({ name }) => name === words.get("link"));
  const positions = new Map();
  for (const [path, name, position] of words.getAll("joint").flatMap(jointOf)) {
    const moved = find(path);
    if (!scene.entities[moved]?.model?.joints.some((joint) => joint.name === name)) continue;
    if (!positions.has(moved)) positions.set(moved, new Map(scene.entities[moved].start));
    positions.get(moved).set(name, position);
  }
  const camera = (words.get("camera") ?? "").split(",").map(Number);
  return {
    entity: entity >= 0 ? entity : undefined,
    link: link >= 0 ? link : undefined,
    positions,
    camera: camera.length === 6 && camera.every(Number.isFinite) ? camera : undefined,
  };
}
