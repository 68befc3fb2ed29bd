// SPDX-License-Identifier: BSD-3-Clause
// Draws copies of the same triangles, each with a matrix and a colour of its own, in one draw call.
//
// Copies of few triangles are merged into one geometry, whose shader reads the matrices from a texture. As instances each
// of them would cost a draw call where there is no graphics card: drawing thousands of boxes takes four times as long.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  FloatType,
  InstancedMesh,
  Matrix4,
  Mesh,
  RGBAFormat,
  Sphere,
} from "three";

import { kPlaceRow } from "./shading.js";

const kMostOfOne = 300; // vertices of a copy: the cost of a draw call is that of about a hundred
const kMostOfAll = 1_000_000; // vertices: each has up to 36 bytes
const kTexels = 4; // of a copy: the columns of its matrix

class Instances extends InstancedMesh {
  /** Draws the copies where setMatrixAt() has put them. */
  showPlaces() {
    this.instanceMatrix.needsUpdate = true;
    this.boundingSphere = this.boundingBox = null; // picking asks for it
  }

  /** Draws the colours that setColorAt() has set. */
  showColors() {
    this.instanceColor.needsUpdate = true;
  }
}

/** The triangles of a geometry, `count` times. An attribute has the number of the copy. */
function repeat(geometry, count) {
  const { index } = geometry;
  const size = geometry.getAttribute("position").count;
  const merged = new BufferGeometry();
  for (const [name, { array, itemSize }] of Object.entries(geometry.attributes)) {
    const all = new Float32Array(count * array.length);
    for (let copy = 0; copy < count; copy++) all.set(array, copy * array.length);
    merged.setAttribute(name, new BufferAttribute(all, itemSize));
  }
  const numbers = new Float32Array(count * size);
  const indices = new Uint32Array(count * index.count);
  for (let copy = 0; copy < count; copy++) {
    numbers.fill(copy, copy * size, (copy + 1) * size);
    for (let i = 0; i < index.count; i++) indices[copy * index.count + i] = copy * size + index.array[i];
  }
  merged.setAttribute("copy", new BufferAttribute(numbers, 1));
  return merged.setIndex(new BufferAttribute(indices, 1));
}

class Merged extends Mesh {
  constructor(geometry, material, count) {
    super(repeat(geometry, count), material);
    this.count = count;
    const height = Math.max(1, Math.ceil((kTexels * count) / kPlaceRow));
    this.places = new Float32Array(4 * kPlaceRow * height);
    this.texture = new DataTexture(this.places, kPlaceRow, height, RGBAFormat, FloatType);
    material.defines.MERGED = "";
    material.uniforms.places = { value: this.texture };
    this.one = new Mesh(geometry, material);
    this.boundingSphere = null; // three.js sorts what it draws by the centres
  }

  computeBoundingSphere() {
    const { geometry, matrixWorld } = this.one;
    if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
    this.boundingSphere = new Sphere();
    const sphere = new Sphere();
    for (let index = 0; index < this.count; index++)
      this.boundingSphere.union(
        sphere.copy(geometry.boundingSphere).applyMatrix4(this.getMatrixAt(index, matrixWorld)),
      );
  }

  // The last components of the columns are 0, 0, 0 and 1 in all matrices. The texture has the colour in the first three.
  setMatrixAt(index, { elements }) {
    for (let column = 0; column < 16; column += 4)
      for (let row = 0; row < 3; row++) this.places[16 * index + column + row] = elements[column + row];
  }

  getMatrixAt(index, matrix) {
    matrix.fromArray(this.places, 16 * index);
    matrix.elements[3] = matrix.elements[7] = matrix.elements[11] = 0;
    matrix.elements[15] = 1;
    return matrix;
  }

  setColorAt(index, { r, g, b }) {
    [r, g, b].forEach((part, at) => (this.places[16 * index + 4 * at + 3] = part));
  }

  showPlaces() {
    this.texture.needsUpdate = true;
    this.boundingSphere = null;
  }

  showColors() {
    this.texture.needsUpdate = true;
  }

  /** As for instances: what is hit says which copy it is. */
  raycast(ray, hits) {
    const found = [];
    for (let index = 0; index < this.count; index++) {
      this.getMatrixAt(index, this.one.matrixWorld);
      this.one.raycast(ray, found);
      for (const hit of found) hits.push({ ...hit, object: this, instanceId: index });
      found.length = 0;
    }
  }
}

/**
 * `count` copies of a geometry that has an index. setMatrixAt(), getMatrixAt() and setColorAt() are those of InstancedMesh;
 * showPlaces() and showColors() draw what was set.
 */
export function copiesOf(geometry, material, count) {
  const size = geometry.getAttribute("position").count;
  const isMerged = size <= kMostOfOne && size * count <= kMostOfAll;
  const copies = new (isMerged ? Merged : Instances)(geometry, material, count);
  copies.frustumCulled = false; // its own bounding box says nothing about where the copies are
  return copies;
}
