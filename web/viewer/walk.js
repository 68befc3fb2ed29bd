// SPDX-License-Identifier: BSD-3-Clause
// Walking through the scene: keys move the camera at a constant height, keys and dragging turn it.
import { Vector3 } from "three";

const kSpeed = 0.35; // of the radius of the scene, per second
const kFaster = 3;
const kTurn = 1.2; // rad/s
const kDrag = 0.004; // rad per pixel
const kSteepest = 1.5; // rad: straight up has no direction
const kLongest = 0.1; // s between two pictures: a slow computer makes short steps
/** By place on the keyboard: [ahead, to the right, turn to the left, look up]. */
const kKeys = new Map([
  ["KeyW", [1, 0, 0, 0]],
  ["KeyS", [-1, 0, 0, 0]],
  ["KeyD", [0, 1, 0, 0]],
  ["KeyA", [0, -1, 0, 0]],
  ["ArrowUp", [1, 0, 0, 0]],
  ["ArrowDown", [-1, 0, 0, 0]],
  ["ArrowLeft", [0, 0, 1, 0]],
  ["ArrowRight", [0, 0, -1, 0]],
  ["PageUp", [0, 0, 0, 1]],
  ["PageDown", [0, 0, 0, -1]],
]);

export const kWalkHelp =
  "W A S D and the arrows walk, dragging and Page Up or Down look around, Shift is faster, Escape ends it.";

export class Walk {
  constructor(stage) {
    this.stage = stage;
    this.held = new Set(); // keys, by their places
    this.isOn = false;
    stage.canvas.addEventListener("pointermove", (event) => this.drag(event));
    document.addEventListener("keyup", ({ code }) => this.held.delete(code));
    window.addEventListener("blur", () => this.held.clear());
  }

  start() {
    this.isOn = true;
    const ahead = this.stage.direction().negate();
    this.distance = ahead.length();
    ahead.normalize();
    this.heading = Math.atan2(ahead.y, ahead.x);
    this.pitch = Math.max(-kSteepest, Math.min(kSteepest, Math.asin(ahead.z)));
    this.stage.controls.enabled = false;
    this.stage.fitted = null;
  }

  stop() {
    if (!this.isOn) return;
    this.isOn = false;
    this.held.clear();
    this.stage.controls.enabled = true;
  }

  /** Whether the key is one of those that walk. */
  press({ code, shiftKey }) {
    if (!this.isOn || !kKeys.has(code)) return false;
    this.isFast = shiftKey;
    this.held.add(code);
    if (!this.isMoving) {
      this.isMoving = true;
      this.before = performance.now();
      requestAnimationFrame(() => this.step());
    }
    return true;
  }

  step() {
    const now = performance.now();
    const time = Math.min(kLongest, (now - this.before) / 1000);
    this.before = now;
    if (this.held.size === 0) {
      this.isMoving = false;
      this.stage.looked?.();
      return;
    }
    let [ahead, right, turn, up] = [0, 0, 0, 0];
    for (const code of this.held) {
      const parts = kKeys.get(code);
      ahead += parts[0];
      right += parts[1];
      turn += parts[2];
      up += parts[3];
    }
    const way = kSpeed * this.stage.radius * time * (this.isFast ? kFaster : 1);
    this.look(turn * kTurn * time, up * kTurn * time);
    const [cosine, sine] = [Math.cos(this.heading), Math.sin(this.heading)];
    this.stage.camera.position.x += way * (ahead * cosine + right * sine);
    this.stage.camera.position.y += way * (ahead * sine - right * cosine);
    this.show();
    requestAnimationFrame(() => this.step());
  }

  drag({ buttons, movementX, movementY }) {
    if (!this.isOn || buttons === 0) return;
    this.look(movementX * kDrag, movementY * kDrag);
    this.show();
    this.stage.looked?.();
  }

  look(turn, up) {
    this.heading += turn;
    this.pitch = Math.max(-kSteepest, Math.min(kSteepest, this.pitch + up));
  }

  show() {
    const { camera, controls } = this.stage;
    const flat = Math.cos(this.pitch);
    const ahead = new Vector3(
      flat * Math.cos(this.heading),
      flat * Math.sin(this.heading),
      Math.sin(this.pitch),
    );
    controls.target.copy(camera.position).addScaledVector(ahead, this.distance);
    camera.lookAt(controls.target);
    this.stage.draw();
  }
}
