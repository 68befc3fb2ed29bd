// SPDX-License-Identifier: BSD-3-Clause
// A small shader for copies. Without a graphics card, the materials of three.js take seconds to compile and several
// times as long to draw.
import { DoubleSide, FrontSide, ShaderMaterial } from "three";

/** Texels of a row of the texture with the matrices of merged copies. */
export const kPlaceRow = 1024;
/** What is drawn over what, of the things that are drawn over the shapes. */
export const kOrder = { inertias: 1, masses: 2, views: 3, axes: 4, frames: 5, ruler: 6, rays: 7 };

const kVertex = `
varying vec3 color;
varying vec3 seen; // in the frame of the camera
#ifdef SMOOTH
varying vec3 direction;
#endif
#ifdef TEXTURED
varying vec2 inImage;
#endif
#ifdef MERGED
attribute float copy;
uniform highp sampler2D places; // the columns of the matrices; where these have zeros, it has the colours
#endif

void main() {
#ifdef TEXTURED
  inImage = uv;
#endif
#ifdef MERGED
  int first = 4 * int(copy);
  ivec2 at = ivec2(first % ${kPlaceRow}, first / ${kPlaceRow});
  mat4 place = mat4(
    texelFetch(places, at, 0),
    texelFetch(places, at + ivec2(1, 0), 0),
    texelFetch(places, at + ivec2(2, 0), 0),
    texelFetch(places, at + ivec2(3, 0), 0)
  );
  color = vec3(place[0].w, place[1].w, place[2].w);
  place[0].w = place[1].w = place[2].w = 0.0;
  place[3].w = 1.0;
#else
  mat4 place = instanceMatrix;
  color = instanceColor;
#endif
  vec4 point = viewMatrix * (place * vec4(position, 1.0));
  seen = point.xyz;
#ifdef SMOOTH
  mat3 scaled = mat3(place); // normals are scaled the other way around
  vec3 squares = vec3(dot(scaled[0], scaled[0]), dot(scaled[1], scaled[1]), dot(scaled[2], scaled[2]));
  direction = mat3(viewMatrix) * (scaled * (normal / squares));
#endif
  gl_Position = projectionMatrix * point;
}`;

// The light comes from above and behind the viewer's left shoulder, and also brightens what faces away from it. White is
// never as bright as the screen can be, black has a sheen, and both have a rim, so their forms are visible before any
// sky. Colours are not converted: they are sRGB from the scene to the screen.
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
varying vec2 inImage;
#endif

void main() {
  vec3 surface = color;
#ifdef TEXTURED
  vec4 texel = texture2D(image, inImage);
  surface = mix(color, color * texel.rgb, texel.a * imageOpacity);
#endif
#ifdef UNLIT
  vec3 lit = surface;
#else
#ifdef SMOOTH
  vec3 normal = normalize(direction);
#else
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
#endif
  float towards = dot(normal, vec3(-0.43, 0.64, 0.64));
  float rim = 1.0 - abs(dot(normal, normalize(seen)));
  vec3 lit = surface * (0.62 + 0.26 * towards) + 0.02 + 0.09 * max(towards, 0.0);
  lit = mix(lit, vec3(0.42), 0.35 * rim * rim * rim);
#endif
  gl_FragColor = vec4(lit, opacity);
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
