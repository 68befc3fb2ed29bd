// SPDX-License-Identifier: BSD-3-Clause
// The axes of the world in a corner of the picture, turned as the camera looks: x red, y green, z blue.
import {
  AxesHelper,
  CanvasTexture,
  OrthographicCamera,
  Scene,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector2,
  Vector3,
} from "three";

const kSide = 76; // pixels
const kAxes = [
  ["x", "#e0433a", new Vector3(1.25, 0, 0)],
  ["y", "#3f9b3f", new Vector3(0, 1.25, 0)],
  ["z", "#3b78e0", new Vector3(0, 0, 1.25)],
];

function letter(text, color, at) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d");
  context.font = "bold 56px sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = color;
  context.fillText(text, 32, 32);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false }));
  sprite.scale.setScalar(0.9);
  sprite.position.copy(at);
  return sprite;
}

export class Corner {
  constructor() {
    const axes = new AxesHelper(1);
    axes.setColors(...kAxes.map(([, color]) => color));
    this.scene = new Scene();
    this.scene.add(axes, ...kAxes.map(([text, color, at]) => letter(text, color, at)));
    this.camera = new OrthographicCamera(-1.8, 1.8, 1.8, -1.8, 0, 10);
  }

  /** Draws over the picture of `camera`. */
  draw(renderer, camera) {
    camera.getWorldDirection(this.camera.position).multiplyScalar(-5);
    this.camera.quaternion.copy(camera.quaternion);
    renderer.autoClear = false;
    renderer.clearDepth();
    renderer.setViewport(0, 0, kSide, kSide);
    renderer.render(this.scene, this.camera);
    const { width, height } = renderer.getSize(new Vector2());
    renderer.setViewport(0, 0, width, height);
    renderer.autoClear = true;
  }
}
