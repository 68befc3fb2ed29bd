// SPDX-License-Identifier: BSD-3-Clause
// A soft shadow on the ground, as of a wide light above: the shapes are drawn from above into a small picture, whose
// smaller copies are spread over the ground. It shows where a robot touches the ground.
import {
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  ShaderMaterial,
  WebGLRenderTarget,
} from "three";

const kSize = 128; // pixels of the picture from above
const kMargin = 1.5; // of the box, for the soft rim
const kLift = 1e-3; // of the size: over a floor of the scene

const kVertex = `
varying vec2 at;
void main() {
  at = uv;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const kFragment = `
uniform sampler2D seen;
varying vec2 at;
void main() {
  float cover = 0.45 * textureLod(seen, at, 2.0).a + 0.35 * textureLod(seen, at, 3.0).a + 0.2 * textureLod(seen, at, 4.0).a;
  gl_FragColor = vec4(0.04, 0.06, 0.09, 0.42 * cover);
}`;

export class Shadow {
  constructor() {
    this.target = new WebGLRenderTarget(kSize, kSize, {
      generateMipmaps: true,
      minFilter: LinearMipmapLinearFilter,
      magFilter: LinearFilter,
    });
    this.camera = new OrthographicCamera();
    this.mesh = new Mesh(
      new PlaneGeometry(),
      new ShaderMaterial({
        vertexShader: kVertex,
        fragmentShader: kFragment,
        uniforms: { seen: { value: this.target.texture } },
        transparent: true,
        depthWrite: false,
        polygonOffset: true,
        polygonOffsetFactor: -1,
        polygonOffsetUnits: -1,
      }),
    );
    this.mesh.renderOrder = -1;
    this.isStale = true;
  }

  /** Puts the shadow of what is in the box on a plane at a height. */
  place(box, height) {
    this.mesh.visible = !box.isEmpty();
    if (box.isEmpty()) return;
    const size = kMargin * Math.max(box.max.x - box.min.x, box.max.y - box.min.y, 1e-6);
    const top = Math.max(box.max.z, height) + size;
    const [x, y] = [(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2];
    Object.assign(this.camera, { left: -size / 2, right: size / 2, top: size / 2, bottom: -size / 2 });
    Object.assign(this.camera, { near: 0, far: top - Math.min(box.min.z, height) + size });
    this.camera.position.set(x, y, top);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.mesh.position.set(x, y, height + kLift * size);
    this.mesh.scale.set(size, size, 1);
    this.isStale = true;
  }

  /** Draws the picture from above, of what casts a shadow. */
  draw(renderer, root) {
    this.isStale = false;
    const hidden = root.children.filter(({ visible, userData }) => visible && !userData.castsShadow);
    for (const mesh of hidden) mesh.visible = false;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(root, this.camera);
    renderer.setRenderTarget(null);
    for (const mesh of hidden) mesh.visible = true;
  }
}
