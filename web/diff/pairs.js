// SPDX-License-Identifier: BSD-3-Clause
// Pairs of old and new things: changed names, entities and joints.

const keyOf = (kind, name, owner, model) => JSON.stringify([model ?? null, kind, owner ?? "", name]);

/** The old names of the things of the new version. */
export class OldNames {
  constructor(differences) {
    this.names = new Map();
    this.taken = new Set(); // old names of renamed things
    for (const { change, kind, name, of, old_name: oldName, new_model: model } of differences) {
      if (change !== "renamed") continue;
      this.names.set(keyOf(kind, name, of, model), oldName);
      this.taken.add(keyOf(kind, oldName, of, model));
    }
  }

  /** `owner`: the `of` of a difference; `model`: its index in the new version, undefined for things of a scene. */
  find(kind, name, owner, model) {
    return this.names.get(keyOf(kind, name, owner, model)) ?? name;
  }

  /** The same; undefined for a new thing that has the old name of a renamed thing. */
  ofJoint(name, model) {
    const key = keyOf("joint", name, undefined, model);
    return this.names.get(key) ?? (this.taken.has(key) ? undefined : name);
  }

  /** The old path of an entity. Each part of the path may have been renamed. */
  ofPath(path) {
    const parts = path.split("/");
    for (let length = parts.length; length > 0; length--) {
      const old = this.names.get(keyOf("entity", parts.slice(0, length).join("/")));
      if (old !== undefined) return [old, ...parts.slice(length)].join("/");
    }
    return path;
  }
}

/** [[new entity, old entity]...], by index. Two single models are a pair even if their files have different names. */
function entitiesOf({ entities }, names) {
  const [fresh, old] = [false, true].map((isOld) =>
    [...entities.keys()].filter((index) => Boolean(entities[index].old) === isOld),
  );
  if (fresh.length === 1 && old.length === 1) return [[fresh[0], old[0]]];
  const byPath = new Map(old.map((index) => [entities[index].path, index]));
  return fresh
    .map((index) => [index, byPath.get(names.ofPath(entities[index].path))])
    .filter(([, other]) => other !== undefined);
}

/** The joints that move together: [{entity, other, joints: [[name, old name]...]}]; `other` is the old entity. */
export function pairsOf(scene, names) {
  return entitiesOf(scene, names).map(([entity, other]) => {
    const [model, old] = [entity, other].map((index) => scene.entities[index].model);
    const known = new Set(scene.models[old]?.joints.map(({ name }) => name));
    const joints = (scene.models[model]?.joints ?? [])
      .map(({ name }) => [name, names.ofJoint(name, model)])
      .filter(([name, oldName]) => name !== undefined && known.has(oldName));
    return { entity, other, joints };
  });
}
