// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes zip files. Does not trust the names and sizes in them.
import { bytesOf, joined, textOf, through } from "./bytes.js";

const kEnd = 0x06054b50;
const kEntry = 0x02014b50;
const kLocal = 0x04034b50;
const kEndSize = 22;
const kLongestComment = 0xffff;
const kUtf8 = 0x0800;
const kEncrypted = 1;
const kLinkMode = 0o120000;
const kFirstDay = 0x21; // 1 January 1980, so that results do not depend on the clock

const kSums = Uint32Array.from({ length: 256 }, (_, byte) => {
  let sum = byte;
  for (let bit = 0; bit < 8; ++bit) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
  return sum;
});

function sumOf(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) sum = kSums[(sum ^ byte) & 0xff] ^ (sum >>> 8);
  return (sum ^ 0xffffffff) >>> 0;
}

const viewOf = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

function endOf(view) {
  const first = Math.max(0, view.byteLength - kEndSize - kLongestComment);
  for (let at = view.byteLength - kEndSize; at >= first; --at)
    if (view.getUint32(at, true) === kEnd) return at;
  throw new Error("this is no zip file");
}

function entryAt(bytes, view, at) {
  const short = (offset) => view.getUint16(at + offset, true);
  const long = (offset) => view.getUint32(at + offset, true);
  if (long(0) !== kEntry) throw new Error("its list of files is broken");
  const name = bytes.subarray(at + 46, at + 46 + short(28));
  return {
    name: textOf(name) ?? new TextDecoder("latin1").decode(name),
    flags: short(8),
    method: short(10),
    sum: long(16),
    packed: long(20),
    size: long(24),
    isLink: ((long(38) >>> 16) & 0o170000) === kLinkMode,
    local: long(42),
    next: at + 46 + short(28) + short(30) + short(32),
  };
}

async function contentOf(bytes, view, entry, most) {
  if (entry.flags & kEncrypted) throw new Error(`'${entry.name}' is encrypted`);
  if (view.getUint32(entry.local, true) !== kLocal)
    throw new Error(`'${entry.name}' is not where it should be`);
  const begin =
    entry.local + 30 + view.getUint16(entry.local + 26, true) + view.getUint16(entry.local + 28, true);
  const packed = bytes.subarray(begin, begin + entry.packed);
  if (entry.method !== 0 && entry.method !== 8)
    throw new Error(`'${entry.name}' is packed in an unknown way`);
  const content =
    entry.method === 0
      ? packed.slice()
      : await through(new DecompressionStream("deflate-raw"), packed, Math.min(most, entry.size));
  if (content.length !== entry.size || sumOf(content) !== entry.sum)
    throw new Error(`'${entry.name}' is damaged`);
  return content;
}

/** Throws if there are more than `most` files. */
function checkCount(count, most) {
  if (count > most) throw new Error(`it has more than ${most.toLocaleString("en")} files`);
}

/**
 * The files by their names in the zip file, at most `most` bytes in total. Skips folders, links and names that are not
 * wanted.
 */
export async function unzip(bytes, most, mostFiles = Infinity, isWanted = () => true) {
  const view = viewOf(bytes);
  const files = new Map();
  try {
    const end = endOf(view);
    let at = view.getUint32(end + 16, true);
    let left = most;
    for (let count = view.getUint16(end + 10, true); count > 0; --count) {
      const entry = entryAt(bytes, view, at);
      at = entry.next;
      if (entry.name.endsWith("/") || entry.isLink || !isWanted(entry.name)) continue;
      // Some programs read the first of two files, others the last.
      if (files.has(entry.name)) throw new Error(`it has two files named '${entry.name}'`);
      checkCount(files.size + 1, mostFiles);
      const content = await contentOf(bytes, view, entry, left);
      left -= content.length;
      if (left < 0) throw new Error("its files are too large");
      files.set(entry.name, content);
    }
  } catch (error) {
    if (error instanceof RangeError) throw new Error("it is cut off");
    if (error instanceof TypeError) throw new Error("a packed file in it is damaged");
    throw error;
  }
  return files;
}

/** `fields`: [[number of bytes, value]] */
function record(...fields) {
  const bytes = new Uint8Array(fields.reduce((sum, [size]) => sum + size, 0));
  const view = viewOf(bytes);
  let at = 0;
  for (const [size, value] of fields) {
    if (size === 2) view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += size;
  }
  return bytes;
}

/** A zip file with these files, uncompressed. */
export function zip(files) {
  const parts = [];
  const list = [];
  let at = 0;
  for (const [path, content] of files) {
    const name = bytesOf(path);
    const common = [
      ...[
        [2, kUtf8],
        [2, 0],
        [2, 0],
        [2, kFirstDay],
      ],
      ...[
        [4, sumOf(content)],
        [4, content.length],
        [4, content.length],
        [2, name.length],
        [2, 0],
      ],
    ];
    list.push(
      record([4, kEntry], [2, 20], [2, 20], ...common, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]),
      name,
    );
    const head = record([4, kLocal], [2, 20], ...common);
    parts.push(head, name, content);
    at += head.length + name.length + content.length;
  }
  const size = list.reduce((sum, part) => sum + part.length, 0);
  const count = files.size;
  const end = record([4, kEnd], [2, 0], [2, 0], [2, count], [2, count], [4, size], [4, at], [2, 0]);
  return joined([...parts, ...list, end]);
}
