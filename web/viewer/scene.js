// SPDX-License-Identifier: BSD-3-Clause
// Reads the scene that smurfs-flatten wrote into the page (libsmurf/src/write/pages/viewer_data.cpp). Units are m, rad and kg.
//
// scene: name of its file
// models: [{name, file, old, links, joints, poses, devices, sensors}]
//   links: [{name, joint: the one above, unplaced, mass, com: pose, inertia: [xx, xy, xz, yy, yz, zz], solid: {com, inertia} of the
//     shapes when they are filled with the mass, visuals, collisions}]
//   joints: [{name, type, parent, child: links, pose, axis, lower, upper, effort, velocity, damping, friction,
//     leader: the joint that it mimics, multiplier, offset}]
//   poses: [{name, positions}]
//   devices: [{kind: motor or sensor, name, link: that it moves or is on}]
//   sensors: [{name, type, link, pose: on the link, camera: [width, height] of the field of view, across and up: [lowest angle,
//     highest, number of rays] of a scan, nearest, farthest, why: something of it is not shown}]; x is ahead, z is up
// entities: [{path, type, old, model, pose: in the world, anchored: to the world, anchor or parent: {entity, link, pose},
//   positions, shapes}]
// meshes: [{file, points: float32, indices: uint16, or uint32 when wide, parts: [{first: index, color}] when the file has
//   colours, texturePoints: two float32 for each point, where shapes with a texture use it}], numbers in base64
// textures: [{file, type: image/png or image/jpeg, bytes}], bytes in base64
// unseen: [{file, why, shapes: how many, package: the one of the file, when no folder of it was found}]
//
// old: true for the old one of two versions of a scene; its models and entities follow those of the new one
// Links, joints, entities, models, meshes and textures are named by their place in these lists. Whatever is unknown is absent.
// pose: [x, y, z, w, x, y, z], a position and a unit quaternion; absent where it changes nothing.
// positions: of joints by their names
// shapes: [{name, pose, color: [r, g, b, a], texture, and one of box: size, sphere: [radius], cylinder or capsule: [radius, length],
//   plane: size, mesh with scale, around: the corners of a box around what is not shown}]

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/** Names come from files, and a plain object has members of its own, such as "constructor". */
const toMap = (positions) => new Map(Object.entries(positions));

function addTree(model) {
  for (const link of model.links) Object.assign(link, { children: [], sensors: [] });
  model.sensors.forEach((sensor, index) => {
    sensor.index = index;
    sensor.name ||= `${sensor.type || "sensor"}, without name`;
    model.links[sensor.link]?.sensors.push(sensor);
  });
  model.links.forEach((link, index) => {
    const joint = model.joints[link.joint];
    if (joint && !link.unplaced) model.links[joint.parent].children.push(index);
  });
  model.root = model.links.findIndex((link) => link.joint === undefined && !link.unplaced);
  model.order = model.root < 0 ? [] : [model.root];
  for (const index of model.order) model.order.push(...model.links[index].children);
}

/** Entities after what they are fixed to. A cycle of anchors is cut, and its entities do not move along. */
function orderOf(entities) {
  const order = [];
  const state = new Uint8Array(entities.length); // 1: on the way, 2: in the order
  entities.forEach((_, start) => {
    const way = [];
    let at = start;
    while (at !== undefined && state[at] === 0) {
      state[at] = 1;
      way.push(at);
      const next = entities[at].support?.entity;
      if (next !== undefined && state[next] === 1) entities[at].support = undefined;
      at = entities[at].support?.entity;
    }
    for (const index of way.reverse()) {
      state[index] = 2;
      order.push(index);
    }
  });
  return order;
}

/** Marks that reorder the text after them, so that a name looks like another one; as such or as an escape of JSON. */
const kReordering = /\p{Bidi_Control}|\\u(?:061c|200[ef]|202[a-e]|206[6-9])/iu;

const withVisibleMarks = (key, value) =>
  typeof value === "string"
    ? value.replace(/\p{Bidi_Control}/gu, (mark) => `\\u${mark.codePointAt(0).toString(16).padStart(4, "0")}`)
    : value;

export function readScene(text) {
  const scene = JSON.parse(text, kReordering.test(text) ? withVisibleMarks : undefined);
  for (const model of scene.models) {
    model.links.forEach((link, index) => (link.name ??= `link ${index + 1}, without name`));
    model.joints.forEach((joint, index) => {
      joint.index = index;
      joint.name ??= `joint ${index + 1}, without name`;
    });
    for (const pose of model.poses) pose.positions = toMap(pose.positions);
    addTree(model);
  }
  for (const entity of scene.entities) {
    entity.title = `${entity.path || entity.type}${entity.old ? " (old)" : ""}`;
    entity.start = toMap(entity.positions);
    entity.support = entity.anchor ?? entity.parent;
    entity.model = scene.models[entity.model];
  }
  scene.order = orderOf(scene.entities);
  for (const texture of scene.textures) texture.bytes = bytesOf(texture.bytes);
  for (const mesh of scene.meshes) {
    mesh.points = new Float32Array(bytesOf(mesh.points));
    mesh.indices = mesh.wide
      ? new Uint32Array(bytesOf(mesh.indices))
      : new Uint16Array(bytesOf(mesh.indices));
    if (mesh.texturePoints) mesh.texturePoints = new Float32Array(bytesOf(mesh.texturePoints));
    mesh.parts?.forEach((part, i) => (part.end = mesh.parts[i + 1]?.first ?? mesh.indices.length));
  }
  return scene;
}
