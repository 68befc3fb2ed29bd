// SPDX-License-Identifier: BSD-3-Clause
// Reads dropped or chosen files, folders and zip files.
import { sizeOf } from "./bytes.js";
import { cleaned, kMostFiles } from "./files.js";
import { unzip } from "./zip.js";

const kMostBytes = 200e6;
const kLeftOut = /(^|\/)(\.git|\.hg|\.svn|__MACOSX|\.DS_Store)(\/|$)/;

const tooMany = () => new Error(`more than ${kMostFiles.toLocaleString("en")} files; open a smaller folder`);

const ask = (method) => new Promise((done, failed) => method(done, failed));

/** Adds the [path, File] of an entry and of all entries below it. */
async function addEntry(entry, found) {
  if (kLeftOut.test(entry.fullPath)) return;
  if (entry.isFile) {
    found.push([entry.fullPath, await ask((done, failed) => entry.file(done, failed))]);
    if (found.length > kMostFiles) throw tooMany();
    return;
  }
  const reader = entry.createReader();
  for (;;) {
    const some = await ask((done, failed) => reader.readEntries(done, failed));
    if (some.length === 0) return;
    for (const each of some) await addEntry(each, found);
  }
}

/** [[path, File]] of a drop. Get the entries before the first await, because browsers clear them then. */
export async function dropped({ items }) {
  const entries = [...items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  const found = [];
  for (const entry of entries) await addEntry(entry, found);
  return found;
}

/** [[path, File]] of chosen files. */
export const chosen = (files) => [...files].map((file) => [file.webkitRelativePath || file.name, file]);

/** The files by path. A single zip file is unpacked. */
export async function contentsOf(found) {
  const size = found.reduce((sum, [, file]) => sum + file.size, 0);
  if (size > kMostBytes)
    throw new Error(`${sizeOf(size)} are too much; at most ${sizeOf(kMostBytes)} can be opened`);
  const read = async (file) => new Uint8Array(await file.arrayBuffer());
  const isZip = found.length === 1 && /\.zip$/i.test(found[0][0]);
  const contents = isZip
    ? await unzip(await read(found[0][1]), kMostBytes, kMostFiles, (name) => !kLeftOut.test(name))
    : new Map(await Promise.all(found.map(async ([path, file]) => [path, await read(file)])));
  const files = new Map();
  for (const [path, bytes] of contents) {
    if (kLeftOut.test(path)) continue;
    const name = cleaned(path);
    if (files.has(name)) throw new Error(`it has two files named '${name}'`);
    files.set(name, bytes);
  }
  if (files.size > kMostFiles) throw tooMany();
  return files;
}
