// SPDX-License-Identifier: BSD-3-Clause
// Draws all shapes of a scene in few draw calls: shapes with the same triangles are copies of one mesh.
import {
  Box3,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  Color,
  CylinderGeometry,
  LessDepth,
  LessEqualDepth,
  Matrix4,
  PlaneGeometry,
  SphereGeometry,
  Vector3,
} from "three";

import { copiesOf } from "./copies.js";
import { toMatrix } from "./motion.js";
import { paint } from "./shading.js";

export const Layer = { visuals: "visuals", collisions: "collisions", unseen: "unseen" };

const kWhite = [1, 1, 1, 1];
const kNoColor = [0.78, 0.79, 0.81, 1];
const kGroundColor = [0.55, 0.55, 0.52, 0.35];
const kUnseenColor = [0.6, 0.6, 0.62, 0.16];
const kCollisionColor = [0.95, 0.45, 0.05, 1];
const kSelected = new Color(0, 0.75, 0.85);
/** Of two versions over each other. People with colour blindness can tell these three colours apart. */
const kCompared = {
  new: { color: new Color(0.25, 0.5, 0.85), opacity: 1 },
  old: { color: new Color(0.84, 0.37, 0), opacity: 0.55 },
  selected: new Color(1, 0.95, 0.35),
};
const kTurn = Math.PI / 2; // the axis of a cylinder is y in three.js and z in URDF

/** The number of sides of round shapes. A wire frame with many sides would hide what is behind it. */
function aroundOf(scene) {
  const links = scene.entities.reduce((sum, { model }) => sum + (model?.order.length ?? 1), 0);
  return { visuals: links <= 100 ? 32 : links <= 500 ? 20 : 12, collisions: 12 };
}

/** Triangles of a mesh that have one colour, if the file gives colours; else the whole mesh. */
function partsOf(shape, meshes, layer) {
  const parts = meshes[shape.mesh]?.parts;
  if (!parts || shape.color || shape.texture !== undefined || layer !== Layer.visuals) return [shape];
  return parts.map((part) => ({ ...shape, part, color: part.color }));
}

/** A cube of 1 m. Pictures on its sides are upright. */
const makeBox = () => new BoxGeometry().rotateX(kTurn);

/** {key, make, scale, center}: the triangles that `make` returns, and their scale and centre in the shape's frame. */
function solidOf(shape, meshes, around) {
  const round = (key, make, scale) => ({ key: `${key} ${around}`, make: () => make().rotateX(kTurn), scale });
  if (shape.box) return { key: "box", make: makeBox, scale: shape.box };
  if (shape.sphere) {
    const [r] = shape.sphere;
    return round("sphere", () => new SphereGeometry(1, around, around / 2), [r, r, r]);
  }
  if (shape.cylinder) {
    const [r, length] = shape.cylinder;
    return round("cylinder", () => new CylinderGeometry(1, 1, 1, around), [r, r, length]);
  }
  if (shape.capsule) {
    const [r, length] = shape.capsule;
    return round(`capsule ${r} ${length}`, () => new CapsuleGeometry(r, length, around / 4, around));
  }
  if (shape.plane) return { key: "plane", make: () => new PlaneGeometry(), scale: [...shape.plane, 1] };
  if (shape.mesh !== undefined) {
    return {
      key: `mesh ${shape.mesh}${shape.part ? ` ${shape.part.first}` : ""}`,
      make: () => toGeometry(meshes[shape.mesh], shape.part),
      scale: shape.scale,
      flat: true,
    };
  }
  if (!shape.around) return null;
  const [low, high] = [new Vector3(...shape.around.slice(0, 3)), new Vector3(...shape.around.slice(3))];
  const center = low.clone().add(high).multiplyScalar(0.5).toArray();
  return { key: "box", make: makeBox, scale: high.sub(low).toArray(), center };
}

function toGeometry({ points, indices, texturePoints }, part) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  if (texturePoints) geometry.setAttribute("uv", new BufferAttribute(texturePoints, 2));
  geometry.setIndex(new BufferAttribute(part ? indices.subarray(part.first, part.end) : indices, 1));
  return geometry;
}

function colorOf(shape, layer) {
  if (layer === Layer.collisions) return kCollisionColor;
  if (layer === Layer.unseen) return kUnseenColor;
  if (shape.texture !== undefined) return shape.color ?? kWhite;
  return shape.color ?? (shape.plane ? kGroundColor : kNoColor);
}

function materialOf({ layer, alpha: opacity, solid, old }, image) {
  // What did not change is at the same depth in both versions, and is shown as the new one.
  const depthFunc = old ? LessDepth : LessEqualDepth;
  if (layer === Layer.collisions) return paint("UNLIT", { opacity, depthFunc, wireframe: true });
  // A mirrored mesh is inside out. The offset keeps the wires of a collision visible on a visual of the same surface.
  const isThin = solid.flat || solid.key === "plane";
  const depth = old ? 4 : 1;
  const behind = { depthFunc, polygonOffset: true, polygonOffsetFactor: depth, polygonOffsetUnits: depth };
  return paint(solid.flat ? "FLAT" : "SMOOTH", { opacity, isThin, image, ...behind });
}

/** A plane, or a heightmap, which is shown as its bounding box. */
const isGround = ({ shape, layer, link }) =>
  shape.plane !== undefined || (layer === Layer.unseen && link === undefined);

export class Shapes {
  /** Adds all shapes to the three.js object `root`. `textures`: those of the scene, which may be loaded later. */
  constructor(scene, motion, root, textures) {
    this.scene = scene;
    this.motion = motion;
    this.textures = textures;
    this.geometries = new Map();
    this.batches = new Map();
    this.around = aroundOf(scene);
    this.solids = []; // {entity, link, layer, shape, local, color, batch, index}
    this.solidsOf = scene.entities.map(() => []);
    this.hidden = new Set(); // layers
    this.versions = "both";
    scene.entities.forEach((entity, index) => {
      if (!entity.pose) return;
      for (const shape of entity.shapes) this.add(shape, Layer.visuals, index);
      for (const link of entity.model?.order ?? []) {
        const { visuals, collisions } = entity.model.links[link];
        for (const shape of visuals) this.add(shape, Layer.visuals, index, link);
        for (const shape of collisions) this.add(shape, Layer.collisions, index, link);
      }
    });
    for (const batch of this.batches.values()) this.build(batch, root);
    this.isCompared = scene.entities.some(({ old }) => old);
    if (this.isCompared) this.paint(() => false);
    this.update();
    this.move(scene.entities.keys());
  }

  /** Takes all shapes from the stage. */
  remove() {
    for (const { mesh } of this.batches.values()) {
      mesh.removeFromParent();
      mesh.material.dispose();
    }
    for (const geometry of this.geometries.values()) geometry.dispose();
  }

  add(shape, wanted, entity, link) {
    for (const part of partsOf(shape, this.scene.meshes, wanted)) this.addPart(part, wanted, entity, link);
  }

  addPart(shape, wanted, entity, link) {
    const solid = solidOf(shape, this.scene.meshes, this.around[wanted]);
    if (!solid) return;
    const layer = wanted === Layer.visuals && shape.around ? Layer.unseen : wanted;
    const [r, g, b, a] = colorOf(shape, layer).map((part) => Math.min(1, Math.max(0, part)));
    const old = this.scene.entities[entity].old === true;
    const { texture } = shape;
    const key = `${layer} ${solid.key} ${a} ${old} ${texture}`;
    if (!this.batches.has(key)) this.batches.set(key, { layer, solid, alpha: a, old, texture, solids: [] });
    const batch = this.batches.get(key);
    const local = toMatrix(shape.pose);
    if (solid.center) local.multiply(new Matrix4().makeTranslation(...solid.center));
    if (solid.scale) local.scale(new Vector3(...solid.scale));
    const color = new Color(r, g, b);
    const made = { entity, link, layer, shape, local, color, batch, index: batch.solids.length };
    batch.solids.push(made);
    this.solids.push(made);
    this.solidsOf[entity].push(made);
  }

  build(batch, root) {
    const { layer, solid, texture } = batch;
    if (!this.geometries.has(solid.key)) this.geometries.set(solid.key, solid.make());
    const geometry = this.geometries.get(solid.key);
    const material = materialOf(batch, texture === undefined ? undefined : this.textures.empty);
    batch.mesh = copiesOf(geometry, material, batch.solids.length);
    const castsShadow = layer === Layer.visuals && solid.key !== "plane";
    batch.mesh.userData = { layer, solids: batch.solids, castsShadow };
    batch.solids.forEach(({ color }, index) => batch.mesh.setColorAt(index, color));
    root.add(batch.mesh);
  }

  worldOf({ entity, link }) {
    return link === undefined ? this.motion.entities[entity] : this.motion.links[entity][link];
  }

  /** Moves the shapes of these entities to where their links are now. */
  move(entities) {
    const matrix = new Matrix4();
    const moved = new Set();
    for (const entity of entities) {
      for (const solid of this.solidsOf[entity]) {
        const { mesh } = solid.batch;
        mesh.setMatrixAt(solid.index, matrix.multiplyMatrices(this.worldOf(solid), solid.local));
        moved.add(mesh);
      }
    }
    for (const mesh of moved) mesh.showPlaces();
  }

  show(layer, isShown) {
    if (isShown) this.hidden.delete(layer);
    else this.hidden.add(layer);
    this.update();
  }

  /** Shows "both" versions, each in a colour of its own, or the "old" or the "new" one as it is. */
  compare(versions) {
    this.versions = versions;
    this.update();
  }

  /** Shows a texture that was loaded. */
  load(texture) {
    for (const batch of this.batches.values())
      if (batch.texture === texture) batch.mesh.material.uniforms.image.value = this.textures.all[texture];
  }

  update() {
    for (const { layer, old, alpha, mesh } of this.batches.values()) {
      mesh.visible = !this.hidden.has(layer) && this.versions !== (old ? "new" : "old");
      const isMixed = this.isCompared && this.versions === "both";
      const opacity = isMixed ? Math.min(alpha, kCompared[old ? "old" : "new"].opacity) : alpha;
      mesh.material.uniforms.opacity.value = opacity;
      mesh.material.uniforms.imageOpacity.value = isMixed ? 0 : 1;
      Object.assign(mesh.material, { transparent: opacity < 1, depthWrite: opacity === 1 });
    }
  }

  colorOf(solid) {
    const isMixed = this.isCompared && this.versions === "both";
    return isMixed && !isGround(solid) ? kCompared[solid.batch.old ? "old" : "new"].color : solid.color;
  }

  has(layer) {
    return this.solids.some((solid) => solid.layer === layer);
  }

  /** Gives the shapes for which `chosen(solid)` is true another colour, and all others their own. */
  paint(chosen) {
    const mixed = new Color();
    for (const solid of this.solids) {
      mixed.copy(this.colorOf(solid));
      if (chosen(solid)) {
        if (this.isCompared) mixed.copy(kCompared.selected);
        else mixed.lerp(kSelected, 0.8);
      }
      solid.batch.mesh.setColorAt(solid.index, mixed);
    }
    for (const { mesh } of this.batches.values()) mesh.showColors();
  }

  /** Encloses these shapes. The ground is left out unless there is nothing else. */
  boxAround(solids = this.solids) {
    const all = new Box3();
    const ground = new Box3();
    const box = new Box3();
    const matrix = new Matrix4();
    for (const solid of solids) {
      const geometry = this.geometries.get(solid.batch.solid.key);
      if (!geometry.boundingBox) geometry.computeBoundingBox();
      box.copy(geometry.boundingBox).applyMatrix4(matrix.multiplyMatrices(this.worldOf(solid), solid.local));
      if (Number.isFinite(box.min.x + box.max.x)) (isGround(solid) ? ground : all).union(box);
    }
    return all.isEmpty() ? ground : all;
  }
}
