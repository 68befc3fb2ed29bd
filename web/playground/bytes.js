// SPDX-License-Identifier: BSD-3-Clause
// Texts, base64 and streams of limited size.

const encoder = new TextEncoder();
const decoder = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });

export const bytesOf = (text) => encoder.encode(text);

/** Undefined if the bytes are not text. */
export function textOf(bytes) {
  try {
    return decoder.decode(bytes);
  } catch {
    return undefined;
  }
}

export function toBase64(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += 8192)
    text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}

export const fromBase64 = (text) => Uint8Array.from(atob(text), (character) => character.charCodeAt(0));

export function joined(parts) {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** The output of a stream for these bytes, at most `most` bytes, because a few bytes can unpack to gigabytes. */
export async function through(stream, bytes, most) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return joined(parts);
    size += value.length;
    if (size > most) {
      reader.cancel().catch(() => {});
      throw new Error(`unpacked, this has more than ${sizeOf(most)}`);
    }
    parts.push(value);
  }
}

/** A number of bytes for people. */
export function sizeOf(bytes) {
  const one = (number) => number.toLocaleString("en", { maximumFractionDigits: 1 });
  if (bytes < 1000) return `${bytes} bytes`;
  return bytes < 1e6 ? `${one(bytes / 1e3)} kB` : `${one(bytes / 1e6)} MB`;
}
