// SPDX-License-Identifier: BSD-3-Clause
// A robot in an address: "#robot=" and its files as compressed JSON in base64url.
import { bytesOf, fromBase64, textOf, through, toBase64 } from "./bytes.js";
import { fromJson, kMostFiles, toJson } from "./files.js";

const kBegin = "#robot=";
const kMostUnpacked = 20e6; // bytes
/** Characters. Some programs cut longer addresses. */
export const kMostShared = 30000;

/** The part of an address that begins with "#". */
export async function toHash(files, targets) {
  const text = JSON.stringify({ files: toJson(files), targets });
  const packed = await through(new CompressionStream("deflate-raw"), bytesOf(text), Infinity);
  return kBegin + toBase64(packed).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** {files, targets}; undefined if the address has no robot. Throws if it is damaged. */
export async function fromHash(hash) {
  if (!hash.startsWith(kBegin)) return undefined;
  try {
    const packed = fromBase64(hash.slice(kBegin.length).replaceAll("-", "+").replaceAll("_", "/"));
    const text = textOf(await through(new DecompressionStream("deflate-raw"), packed, kMostUnpacked));
    const { files, targets } = JSON.parse(text);
    if (Object.keys(files).length > kMostFiles) throw new Error("too many files");
    return { files: fromJson(files), targets: [...targets].filter((name) => typeof name === "string") };
  } catch {
    throw new Error("the address is damaged: a part of it may have been cut off");
  }
}
