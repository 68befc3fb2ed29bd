// SPDX-License-Identifier: BSD-3-Clause
// What belongs together in both versions: names that were changed, entities and joints.

const keyOf = (kind, name, owner, model) => JSON.stringify([model ?? null, kind, owner ?? "", name]);

/** The names in the old version of what the new one has. */
export class OldNames {
  constructor(differences) {
    this.names = new Map();
    this.taken = new Set(); // old names of what was renamed
    for (const { change, kind, name, of, old_name: oldName, new_model: model } of differences) {
      if (change !== "renamed") continue;
      this.names.set(keyOf(kind, name, of, model), oldName);
      this.taken.add(keyOf(kind, oldName, of, model));
    }
  }

  /** `owner`: as `of` of a difference; `model`: index in the new version, absent for what belongs to a scene. */
  find(kind, name, owner, model) {
    return this.names.get(keyOf(kind, name, owner, model)) ?? name;
  }

  /** The same, undefined for something new that has got the old name of something else. */
  ofJoint(name, model) {
    const key = keyOf("joint", name, undefined, model);
    return this.names.get(key) ?? (this.taken.has(key) ? undefined : name);
  }

  /** The path of an entity, of which each part may have another name. */
  ofPath(path) {
    const parts = path.split("/");
    for (let length = parts.length; length > 0; length--) {
      const old = this.names.get(keyOf("entity", parts.slice(0, length).join("/")));
      if (old !== undefined) return [old, ...parts.slice(length)].join("/");
    }
    return path;
  }
}

/** [[entity of the new version, of the old one]...] by index. Two models are a pair whatever their files are called. */
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

/** [{entity, other, joints: [[name, old name]...]}]: what moves together; entities of both versions by index. */
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
