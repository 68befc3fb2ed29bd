// SPDX-License-Identifier: BSD-3-Clause
// Images on shapes. They are decoded from bytes in the page, which its content security policy allows without more.
import { DataTexture, RepeatWrapping, Texture } from "three";

const kMostPixels = 4096; // on a side: larger images are made smaller, since graphics cards have limits

/** Nothing of it is seen: the colour of the shape shows through. */
function clear() {
  const texture = new DataTexture(new Uint8Array(4), 1, 1);
  texture.needsUpdate = true;
  return texture;
}

async function decode({ bytes, type }) {
  // Rows from below, as textures have them, and colours as they are.
  const look = { imageOrientation: "flipY", colorSpaceConversion: "none", premultiplyAlpha: "none" };
  const image = await createImageBitmap(new Blob([bytes], { type }), look);
  const side = Math.max(image.width, image.height);
  if (side <= kMostPixels) return image;
  const [resizeWidth, resizeHeight] = [image.width, image.height].map((length) =>
    Math.max(1, Math.round((length * kMostPixels) / side)),
  );
  return createImageBitmap(image, { resizeWidth, resizeHeight, premultiplyAlpha: "none" });
}

export class Textures {
  /** `onLoad` is called with the index of each image that can be shown, `onFail` with that of each other. */
  constructor(images, onLoad, onFail) {
    this.empty = clear();
    this.all = images.map(() => this.empty);
    /** Fulfilled when all images are decoded. */
    this.ready = Promise.all(
      images.map(async (image, index) => {
        try {
          const texture = new Texture(await decode(image));
          texture.flipY = false;
          texture.wrapS = texture.wrapT = RepeatWrapping;
          texture.needsUpdate = true;
          this.all[index] = texture;
          onLoad(index);
        } catch {
          onFail(index);
        }
      }),
    );
  }
}
