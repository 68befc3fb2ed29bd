// SPDX-License-Identifier: BSD-3-Clause
// A small shader for instances. Without a graphics card, the materials of three.js take seconds to compile and several
// times as long to draw.
import { DoubleSide, FrontSide, ShaderMaterial } from "three";

const kVertex = `
varying vec3 color;
varying vec3 seen; // in the frame of the camera
#ifdef SMOOTH
varying vec3 direction;
#endif
#ifdef TEXTURED
varying vec2 place; // in the image
#endif

void main() {
#ifdef TEXTURED
  place = uv;
#endif
  color = instanceColor;
  vec4 point = viewMatrix * (instanceMatrix * vec4(position, 1.0));
  seen = point.xyz;
#ifdef SMOOTH
  mat3 scaled = mat3(instanceMatrix); // normals are scaled the other way around
  vec3 squares = vec3(dot(scaled[0], scaled[0]), dot(scaled[1], scaled[1]), dot(scaled[2], scaled[2]));
  direction = mat3(viewMatrix) * (scaled * (normal / squares));
#endif
  gl_Position = projectionMatrix * point;
}`;

// The light comes from above and behind the viewer's left shoulder, and also brightens what faces away from it. Colours
// are not converted: they are sRGB from the scene to the screen.
const kFragment = `
uniform float opacity;
varying vec3 color;
varying vec3 seen;
#ifdef SMOOTH
varying vec3 direction;
#endif
#ifdef TEXTURED
uniform sampler2D image;
uniform float imageOpacity;
varying vec2 place;
#endif

void main() {
  vec3 surface = color;
#ifdef TEXTURED
  vec4 texel = texture2D(image, place);
  surface = mix(color, color * texel.rgb, texel.a * imageOpacity);
#endif
#ifdef UNLIT
  float light = 1.0;
#else
#ifdef SMOOTH
  vec3 normal = normalize(direction);
#else
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
#endif
  float light = 0.78 + 0.34 * dot(normal, vec3(-0.43, 0.64, 0.64));
#endif
  gl_FragColor = vec4(surface * light, opacity);
}`;

/** `look`: "SMOOTH", "FLAT" (needs no normals) or "UNLIT". `image`: a texture, for shapes with coordinates. */
export function paint(look, { opacity = 1, isThin = false, image, ...rest } = {}) {
  return new ShaderMaterial({
    vertexShader: kVertex,
    fragmentShader: kFragment,
    uniforms: { opacity: { value: opacity }, image: { value: image }, imageOpacity: { value: 1 } },
    defines: { [look]: "", ...(image && { TEXTURED: "" }) },
    transparent: opacity < 1,
    depthWrite: opacity === 1,
    side: isThin ? DoubleSide : FrontSide,
    ...rest,
  });
}
