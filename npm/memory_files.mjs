// SPDX-License-Identifier: BSD-3-Clause
// Files in memory, for host.mjs: the folder `kHere` contains all files of a run.
import { FileError, Open } from "./host.mjs";

// Deep enough that a path two folders up is still in the project; the tools read nothing outside of it.
const kHere = "/in/the/memory/files";
/** In bytes. Every path is resolved part by part: with 3,000 folders, that takes more than ten minutes. */
const kLongestPath = 1024;
const kLongestName = 255;
const kFolderMode = 0o040755;
const kFileMode = 0o100644;
const encoder = new TextEncoder();
const decoder = new TextDecoder();

function normalized(path) {
  const parts = [];
  for (const part of (path.startsWith("/") ? path : `${kHere}/${path}`).split("/")) {
    if (part === "..") parts.pop();
    else if (part !== "" && part !== ".") parts.push(part);
  }
  return "/" + parts.join("/");
}

/** What is written elsewhere would be lost, because only the files of the folder are handed back. */
function checkInside(path) {
  if (!normalized(path).startsWith(`${kHere}/`)) throw new FileError("EACCES");
}

const above = (path) => path.slice(0, Math.max(path.lastIndexOf("/"), 1));

/** A file has `bytes`, a folder does not. */
class Node {
  static #count = 0;
  constructor(bytes) {
    this.bytes = bytes;
    this.number = ++Node.#count;
  }
}

export class MemoryFiles {
  #nodes = new Map([["/", new Node(null)]]);
  #open = new Map();
  #input;
  #outputs = { 1: [], 2: [] };

  /** `files` maps relative paths to texts or bytes. */
  constructor(files, input = "") {
    this.#input = { node: new Node(bytesOf(input)), at: 0 };
    this.#makeFolders(kHere);
    // Of a Map, a list or a text, the entries are no files.
    if (files instanceof Map || Array.isArray(files) || typeof files === "string") {
      throw new TypeError("the files are not an object that maps paths to texts or bytes");
    }
    for (const [name, content] of Object.entries(files)) {
      const path = normalized(name);
      const size = (text) => encoder.encode(text).length;
      if (name.includes("\0") || size(path) > kLongestPath || path.split("/").some((part) => size(part) > kLongestName)) {
        throw new TypeError(`'${name.slice(0, 80)}' is not a path that a file can have: it contains a NUL, or is too long`);
      }
      if (name.startsWith("/") || !path.startsWith(`${kHere}/`)) {
        throw new TypeError(`'${name}' is not a path in the folder of the files: write it without a leading '/' or '..'`);
      }
      this.#makeFolders(above(path));
      if (this.#nodes.get(path)?.bytes === null) throw new TypeError(`'${name}' is a folder of other files`);
      if (this.#nodes.has(path)) throw new TypeError(`'${name}' names the same file as another path`);
      this.#nodes.set(path, new Node(bytesOf(content)));
    }
    this.before = this.#contents();
  }

  #makeFolders(path) {
    if (path !== "/") this.#makeFolders(above(path));
    const node = this.#nodes.get(path);
    if (node === undefined) this.#nodes.set(path, new Node(null));
    else if (node.bytes !== null) throw new TypeError(`'${path.slice(kHere.length + 1)}' is a file, and a folder of others`);
  }

  #contents() {
    const files = [...this.#nodes].filter(([path, node]) => node.bytes !== null && path.startsWith(kHere + "/"));
    return new Map(files.map(([path, node]) => [path.slice(kHere.length + 1), node.bytes]));
  }

  /** New and changed files. */
  changes() {
    return Object.fromEntries([...this.#contents()].filter(([name, bytes]) => this.before.get(name) !== bytes));
  }

  output(fd) {
    const parts = this.#outputs[fd];
    const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
      all.set(part, at);
      at += part.length;
    }
    return all;
  }

  encode(text) { return encoder.encode(text); }
  decode(bytes) { return decoder.decode(bytes); }
  folder() { return kHere; }
  below(folder, path) { return `${this.#file(folder).path}/${path}`; }

  #node(path) {
    const node = this.#nodes.get(normalized(path));
    if (node !== undefined && !(path.endsWith("/") && node.bytes !== null)) return node;
    throw new FileError(node === undefined ? "ENOENT" : "ENOTDIR");
  }

  #file(fd) {
    if (fd === 0) return this.#input;
    const file = this.#open.get(fd);
    if (file === undefined) throw new FileError("EBADF");
    return file;
  }

  open(path, flags) {
    const whole = normalized(path);
    const writes = (flags & (Open.write | Open.readWrite)) !== 0;
    let node = this.#nodes.get(whole);
    if (flags & Open.nameless) throw new FileError("ENOTSUP");
    if (node !== undefined && flags & Open.create && flags & Open.exclusive) throw new FileError("EEXIST");
    if (node === undefined) {
      if (!(flags & Open.create)) throw new FileError("ENOENT");
      checkInside(path);
      if (this.#node(above(whole)).bytes !== null) throw new FileError("ENOTDIR");
      this.#nodes.set(whole, (node = new Node(new Uint8Array(0))));
    }
    if (node.bytes === null && writes) throw new FileError("EISDIR");
    if (node.bytes !== null && flags & Open.folder) throw new FileError("ENOTDIR");
    if (writes && flags & Open.truncate) node.bytes = new Uint8Array(0);
    let fd = 3;
    while (this.#open.has(fd)) ++fd;
    this.#open.set(fd, { node, path: whole, at: flags & Open.append ? node.bytes.length : 0 });
    return fd;
  }

  close(fd) {
    if (fd > 2) this.#open.delete(fd);
  }

  read(fd, bytes, position) {
    const file = this.#file(fd);
    if (file.node.bytes === null) throw new FileError("EISDIR");
    const at = position ?? file.at;
    const part = file.node.bytes.subarray(at, at + bytes.length);
    bytes.set(part);
    if (position === null) file.at += part.length;
    return part.length;
  }

  write(fd, bytes, position) {
    if (fd === 1 || fd === 2) {
      this.#outputs[fd].push(bytes.slice());
      return bytes.length;
    }
    const file = this.#file(fd);
    const at = position ?? file.at;
    const grown = new Uint8Array(Math.max(file.node.bytes.length, at + bytes.length));
    grown.set(file.node.bytes);
    grown.set(bytes, at);
    file.node.bytes = grown;
    if (position === null) file.at += bytes.length;
    return bytes.length;
  }

  #status(node) {
    const mode = node.bytes === null ? kFolderMode : kFileMode;
    const size = node.bytes?.length ?? 0;
    return { dev: 1, ino: node.number, mode, nlink: 1, uid: 0, gid: 0, size, atimeMs: 0, mtimeMs: 0, ctimeMs: 0 };
  }

  stat(path) { return this.#status(this.#node(path)); }
  lstat(path) { return this.stat(path); }

  fstat(fd) {
    const status = fd === 1 || fd === 2 ? this.#status(new Node(new Uint8Array(0))) : this.#status(this.#file(fd).node);
    if (fd <= 2) status.mode = 0o010600;  // a pipe
    return status;
  }

  list(fd) {
    const folder = this.#file(fd).path;
    const prefix = folder === "/" ? folder : `${folder}/`;
    return [...this.#nodes]
      .filter(([path]) => path !== folder && path.startsWith(prefix) && !path.includes("/", prefix.length))
      .map(([path, node]) => ({ name: path.slice(prefix.length), type: node.bytes === null ? 4 : 8 }));
  }

  readlink(path) {
    this.#node(path);
    throw new FileError("EINVAL");  // there are no links
  }

  rename(from, to) {
    checkInside(to);
    const node = this.#node(from);
    if (node.bytes === null) throw new FileError("EPERM");
    this.#nodes.delete(normalized(from));
    this.#nodes.set(normalized(to), node);
  }

  link(from, to) {
    checkInside(to);
    if (this.#nodes.has(normalized(to))) throw new FileError("EEXIST");
    this.#nodes.set(normalized(to), this.#node(from));
  }

  unlink(path) {
    if (this.#node(path).bytes === null) throw new FileError("EISDIR");
    this.#nodes.delete(normalized(path));
  }

  rmdir(path) {
    const whole = normalized(path);
    if (this.#node(path).bytes !== null) throw new FileError("ENOTDIR");
    if ([...this.#nodes.keys()].some((one) => one.startsWith(`${whole}/`))) throw new FileError("ENOTEMPTY");
    this.#nodes.delete(whole);
  }

  mkdir(path) {
    const whole = normalized(path);
    if (this.#nodes.has(whole)) throw new FileError("EEXIST");
    checkInside(path);
    if (this.#node(above(whole)).bytes !== null) throw new FileError("ENOTDIR");
    this.#nodes.set(whole, new Node(null));
  }

  chmod() {}
  chown() {}
  sync() {}
  wait() {}
  isTerminal() { return false; }
}

function bytesOf(content) {
  if (typeof content === "string") return encoder.encode(content);
  if (content instanceof Uint8Array) return content;
  if (content instanceof ArrayBuffer) return new Uint8Array(content);
  throw new TypeError("the content of a file is a string, a Uint8Array or an ArrayBuffer");
}
