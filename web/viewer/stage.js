// SPDX-License-Identifier: BSD-3-Clause
// The picture: camera, ground, and what is under the pointer. It is drawn only when something changes.
import {
  Box3,
  GridHelper,
  Group,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import { element } from "../common/dom.js";
import { Corner } from "./corner.js";
import { Shadow } from "./shadow.js";

const kDragged = 5; // pixels that a click may move
const kFarthest = 1e9; // m
const kMargin = 1.1; // around what is fitted into the view
const kShadowPause = 200; // ms between two shadows without a graphics card

/** The largest length of at most `length` that is 1, 2 or 5 times a power of ten. */
function roundStep(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].map((factor) => factor * power).find((step) => step <= length) ?? power;
}

function cornersOf({ min, max }) {
  const corners = [];
  for (const x of [min.x, max.x])
    for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) corners.push(new Vector3(x, y, z));
  return corners;
}

/**
 * With smooth edges where there is a graphics card; without one, they double the time to draw. `isSoft`: there is none.
 */
function makeCanvas() {
  const make = (antialias) => {
    const canvas = element("canvas");
    const context = canvas.getContext("webgl2", { alpha: true, antialias });
    return { canvas, context, isSoft: !antialias };
  };
  const plain = make(false);
  if (!plain.context) throw new Error("no WebGL");
  const info = plain.context.getExtension("WEBGL_debug_renderer_info");
  const card = plain.context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : plain.context.RENDERER);
  if (/swiftshader|llvmpipe|software|basic render/i.test(card)) return plain;
  plain.context.getExtension("WEBGL_lose_context")?.loseContext();
  return make(true);
}

export class Stage {
  constructor(host) {
    this.host = host;
    const { isSoft, ...made } = makeCanvas();
    this.renderer = new WebGLRenderer(made);
    /** Pixels of the picture in one of the page: without a graphics card, more take too long to draw. */
    this.mostPixels = isSoft ? 1 : 2;
    this.shadowPause = isSoft ? kShadowPause : 0;
    this.canvas = this.renderer.domElement;
    host.prepend(this.canvas);
    this.scene = new Scene();
    this.root = new Group();
    this.scene.add(this.root);
    this.shadow = new Shadow();
    this.scene.add(this.shadow.mesh);
    this.camera = new PerspectiveCamera(40, 1, 0.01, 1000);
    this.camera.up.set(0, 0, 1);
    this.isYUp = false;
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("start", () => (this.isHeld = true));
    this.controls.addEventListener("end", () => (this.isHeld = false));
    this.controls.addEventListener("change", () => {
      if (this.isHeld) this.fitted = null; // a click alone changes nothing
      this.draw();
    });
    this.corner = new Corner();
    this.afterDraw = [];
    this.radius = 1;
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(this.mostPixels, window.devicePixelRatio));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.fitted) this.fit(this.fitted, this.direction());
    this.draw();
  }

  /** Draws once, with the next frame of the screen. */
  draw() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      this.isAsked = false;
      this.drawShadow();
      this.renderer.render(this.scene, this.camera);
      this.corner.draw(this.renderer, this.camera);
      for (const follow of this.afterDraw) follow();
    });
  }

  /** After shapes have moved, or were shown or hidden. */
  touch() {
    this.shadow.isStale = true;
    this.draw();
  }

  drawShadow() {
    if (!this.shadow.isStale || !this.boxOfShadow || this.isYUp) return;
    const left = (this.shadowAt ?? -Infinity) + this.shadowPause - performance.now();
    if (left > 0) {
      setTimeout(() => this.draw(), left);
      return;
    }
    this.shadow.place(this.boxOfShadow(), this.grid.position.z); // joints may have moved parts far away
    this.shadow.draw(this.renderer, this.root);
    this.shadowAt = performance.now();
  }

  /** Calls back with a picture of what is shown, as PNG without a background. */
  takePicture(callback) {
    this.renderer.render(this.scene, this.camera);
    this.canvas.toBlob(callback, "image/png");
  }

  /** Turns the picture so that z points up, as in ROS, or y, as in many mesh files. The coordinates stay as they are. */
  setUp(isY) {
    this.isYUp = isY;
    this.camera.up.set(0, Number(isY), Number(!isY));
    // The controls read the axis only once, when they are made.
    this.controls._quat.setFromUnitVectors(this.camera.up, new Vector3(0, 1, 0));
    this.controls._quatInverse.copy(this.controls._quat).invert();
    this.shadow.mesh.visible &&= !isY;
  }

  /** Puts the grid around a box, in the horizontal plane of the world, or below the box. */
  setGround(box, isBelow) {
    const [across, up] = this.isYUp ? ["z", "y"] : ["y", "z"];
    const size = box.isEmpty() ? 2 : Math.max(box.max.x - box.min.x, box.max[across] - box.min[across], 0.2);
    const step = roundStep(size / 4);
    const cells = 2 * Math.ceil(size / step);
    this.grid?.dispose();
    this.grid?.removeFromParent();
    this.grid = new GridHelper(cells * step, cells, 0x808890, 0x808890);
    if (!this.isYUp) this.grid.rotateX(Math.PI / 2);
    this.grid.material.transparent = true;
    this.grid.material.opacity = 0.28;
    this.grid.material.depthWrite = false;
    const center = box.isEmpty() ? new Vector3() : box.getCenter(new Vector3());
    const onGrid = (value) => Math.round(value / step) * step;
    this.grid.position.x = onGrid(center.x);
    this.grid.position[across] = onGrid(center[across]);
    this.grid.position[up] = isBelow && !box.isEmpty() ? box.min[up] : 0;
    this.scene.add(this.grid);
    this.shadow.isStale = true;
  }

  /** Brings a whole box into view. `from` points from the box to the camera. */
  fit(box, from = this.isYUp ? new Vector3(1, 0.9, 1.5) : new Vector3(1, -1.5, 0.9)) {
    this.fitted = box; // as long as nobody turns the view
    const around = box.isEmpty() ? new Box3(new Vector3(-1, -1, 0), new Vector3(1, 1, 1)) : box;
    const sphere = around.getBoundingSphere(new Sphere());
    this.radius = Math.max(sphere.radius, 1e-6);
    const half = (this.camera.fov / 2) * (Math.PI / 180);
    const back = from.clone().normalize();
    this.camera.position.copy(sphere.center).add(back);
    this.camera.lookAt(sphere.center);
    const [right, up] = [new Vector3(), new Vector3()];
    this.camera.matrix
      .makeRotationFromQuaternion(this.camera.quaternion)
      .extractBasis(right, up, new Vector3());
    const tangent = Math.tan(half);
    let distance = 1e-6;
    for (const corner of cornersOf(around)) {
      const offset = corner.sub(sphere.center);
      const across = Math.abs(offset.dot(right)) / (tangent * this.camera.aspect);
      const needed = kMargin * Math.max(across, Math.abs(offset.dot(up)) / tangent);
      distance = Math.max(distance, offset.dot(back) + needed);
    }
    this.controls.target.copy(sphere.center);
    this.camera.position.copy(sphere.center).addScaledVector(back, distance);
    this.setDepths(distance);
    this.controls.update();
    this.draw();
  }

  /** Position and target of the camera in metres, as six numbers; undefined while the view is fitted. */
  view() {
    return this.fitted ? undefined : [...this.camera.position, ...this.controls.target];
  }

  /** Shows what view() has returned. */
  look(view) {
    const [position, target] = [new Vector3().fromArray(view), new Vector3().fromArray(view, 3)];
    const distance = position.distanceTo(target);
    if (!(distance > 0 && distance < kFarthest)) return;
    this.fitted = null;
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    this.setDepths(distance);
    this.controls.update();
    this.draw();
  }

  /** Calls back when somebody has turned, moved or zoomed the view. */
  onLook(callback) {
    this.looked = callback;
    this.controls.addEventListener("end", callback);
  }

  setDepths(distance) {
    this.camera.near = distance / 500;
    this.camera.far = 200 * distance;
    this.camera.updateProjectionMatrix();
  }

  direction() {
    return this.camera.position.clone().sub(this.controls.target);
  }

  /** Moves the camera around its target by two angles in radians, and scales its distance. */
  turn(around, up, zoom = 1) {
    this.fitted = null;
    const { target } = this.controls;
    const offset = this.direction();
    const { x, y, z } = offset;
    const seen = new Spherical().setFromCartesianCoords(...(this.isYUp ? [x, y, z] : [y, z, x]));
    seen.theta += around;
    seen.phi = Math.min(Math.PI - 0.01, Math.max(0.01, seen.phi + up));
    seen.radius *= zoom;
    const turned = new Vector3().setFromSpherical(seen);
    if (!this.isYUp) turned.set(turned.z, turned.x, turned.y);
    this.camera.position.copy(target).add(turned);
    this.controls.update();
    this.draw();
    this.looked?.();
  }

  /** Calls back with the solid that is clicked and the point in the world, or with nothing. */
  onPick(callback) {
    let down = null;
    this.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
    this.canvas.addEventListener("pointerup", (event) => {
      const moved = down ? Math.hypot(event.clientX - down[0], event.clientY - down[1]) : Infinity;
      if (event.button === 0 && moved < kDragged) callback(...this.hitAt(event));
    });
  }

  /** `grab` gets what is under the pointer that is pressed, and returns {move(x, y)} if it can be dragged. */
  onGrab(grab) {
    let held;
    const place = ({ clientX, clientY }) => {
      const { left, top } = this.canvas.getBoundingClientRect();
      return [clientX - left, clientY - top];
    };
    // Before the controls, which would turn the view.
    this.host.addEventListener(
      "pointerdown",
      (event) => {
        held = event.button === 0 && event.target === this.canvas ? grab(...this.hitAt(event)) : undefined;
        if (!held) return;
        this.controls.enabled = false;
        this.canvas.setPointerCapture(event.pointerId);
      },
      true,
    );
    this.host.addEventListener("pointermove", (event) => held?.move(...place(event)));
    for (const end of ["pointerup", "pointercancel"])
      this.host.addEventListener(end, () => {
        if (held) this.controls.enabled = true;
        held = undefined;
      });
  }

  hitAt({ clientX, clientY }) {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const ray = new Raycaster();
    this.camera.updateMatrixWorld(); // it may have moved since the last picture
    ray.setFromCamera(
      new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height),
      this.camera,
    );
    const meshes = this.root.children.filter((mesh) => mesh.visible && mesh.userData.solids);
    const hits = ray.intersectObjects(meshes, false);
    const hit =
      hits.find(({ object, instanceId }) => !object.userData.solids[instanceId].shape.plane) ?? hits[0];
    return hit ? [hit.object.userData.solids[hit.instanceId], hit.point] : [];
  }

  /** The place of a world point in pixels of the picture; null behind the camera. */
  toPage(point) {
    const seen = point.clone().project(this.camera);
    if (seen.z > 1 || seen.z < -1) return null;
    return [((seen.x + 1) / 2) * this.host.clientWidth, ((1 - seen.y) / 2) * this.host.clientHeight];
  }
}
