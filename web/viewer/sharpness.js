// SPDX-License-Identifier: BSD-3-Clause
// How many pixels are drawn: fewer while a scene moves that is too slow to draw, all of them when it stands still.

const kSlow = 45; // ms a picture
const kPause = 250; // ms: pictures further apart are no movement
const kLeast = 0.4; // of the full width

export class Sharpness {
  /** Calls back when the number has changed. */
  constructor(onChange) {
    this.onChange = onChange;
    this.factor = 1;
    this.last = 0;
    this.slow = 0;
  }

  ratio() {
    return this.factor * Math.min(2, window.devicePixelRatio);
  }

  onPicture() {
    const now = performance.now();
    const time = now - this.last;
    this.last = now;
    clearTimeout(this.timer);
    if (this.factor < 1) this.timer = setTimeout(() => this.set(1), kPause);
    this.slow = time > kSlow && time < 4 * kPause ? this.slow + 1 : 0;
    if (this.slow < 3 || this.factor <= kLeast) return;
    this.slow = 0;
    this.set(Math.max(kLeast, 0.7 * this.factor));
  }

  set(factor) {
    this.factor = factor;
    this.onChange();
  }
}
