// SPDX-License-Identifier: BSD-3-Clause
// The files of the machine, for host.mjs.
import fs from "node:fs";
import tty from "node:tty";

import { FileError, Open } from "./host.mjs";

const isWindows = process.platform === "win32";
/** Linux has a path for an open folder that stays valid when the folder is renamed. */
const hasNames = process.platform === "linux" && fs.existsSync("/proc/self/fd");

/** Drives become folders of the root, because all other paths are relative here. */
function fromHere(path) {
  const text = path.replaceAll("\\", "/");
  return /^[A-Za-z]:/.test(text) ? "/" + text : text;
}
const toHere = (path) => (isWindows ? path.replace(/^\/([A-Za-z]:)/, "$1") : path);

function flagsOf(flags) {
  const known = fs.constants;
  const pairs = [
    [Open.write, known.O_WRONLY], [Open.readWrite, known.O_RDWR], [Open.create, known.O_CREAT],
    [Open.exclusive, known.O_EXCL], [Open.noTerminal, known.O_NOCTTY], [Open.truncate, known.O_TRUNC],
    [Open.append, known.O_APPEND], [Open.nonBlocking, known.O_NONBLOCK], [Open.folder, known.O_DIRECTORY],
    [Open.noFollow, known.O_NOFOLLOW], [Open.path, hasNames ? Open.path : 0],
  ];
  return pairs.reduce((sum, [flag, value]) => (flags & flag ? sum | (value ?? 0) : sum), 0);
}

function typeOf(entry) {
  if (entry.isDirectory()) return 4;
  if (entry.isSymbolicLink()) return 10;
  return entry.isFile() ? 8 : 0;
}

export class NodeFiles {
  #paths = new Map();
  #nextFolder = 1 << 20;  // descriptors of folders, on systems that cannot open folders

  // File names are bytes; names that are not UTF-8 must not be changed.
  encode(text) { return isWindows ? Buffer.from(text) : Buffer.from(text, "latin1"); }
  decode(bytes) { return Buffer.from(bytes).toString(isWindows ? "utf8" : "latin1"); }
  #name(path) { return isWindows ? toHere(path) : Buffer.from(path, "latin1"); }

  folder() {
    return isWindows ? fromHere(process.cwd()) : Buffer.from(process.cwd()).toString("latin1");
  }

  below(folder, path) {
    return hasNames ? `/proc/self/fd/${folder}/${path}` : `${this.#paths.get(folder)}/${path}`;
  }

  open(path, flags, mode) {
    if (flags & Open.nameless) throw new FileError("ENOTSUP");
    let fd;
    if (isWindows && fs.statSync(this.#name(path), { throwIfNoEntry: false })?.isDirectory()) fd = this.#nextFolder++;
    else fd = fs.openSync(this.#name(path), flagsOf(flags), mode);
    this.#paths.set(fd, path);
    return fd;
  }

  close(fd) {
    this.#paths.delete(fd);
    if (fd < 1 << 20) fs.closeSync(fd);
  }

  read(fd, bytes, position) {
    for (;;) {
      try {
        return fs.readSync(fd, bytes, 0, bytes.length, position);
      } catch (error) {
        if (error.code === "EOF") return 0;  // a closed pipe of Windows
        if (error.code !== "EAGAIN") throw error;
        this.wait(10);
      }
    }
  }

  write(fd, bytes, position) { return fs.writeSync(fd, bytes, 0, bytes.length, position); }

  stat(path) { return fs.statSync(this.#name(path), { bigint: true }); }

  lstat(path) {
    const status = fs.lstatSync(this.#name(path), { bigint: true });
    // Linux reports the size 64 for each of these links, and longer targets would be cut.
    if (path.startsWith("/proc/self/fd/")) status.size = 4096n;
    return status;
  }

  fstat(fd) {
    return fd < 1 << 20 ? fs.fstatSync(fd, { bigint: true }) : this.stat(this.#paths.get(fd));
  }

  list(fd) {
    const name = hasNames ? Buffer.from(`/proc/self/fd/${fd}`) : this.#name(this.#paths.get(fd));
    return fs.readdirSync(name, { withFileTypes: true, encoding: isWindows ? "utf8" : "latin1" })
      .map((entry) => ({ name: entry.name, type: typeOf(entry) }));
  }

  readlink(path) {
    const target = fs.readlinkSync(this.#name(path), { encoding: "buffer" });
    return isWindows ? Buffer.from(fromHere(target.toString())) : target;
  }

  rename(from, to) { fs.renameSync(this.#name(from), this.#name(to)); }
  link(from, to) { fs.linkSync(this.#name(from), this.#name(to)); }
  unlink(path) { fs.unlinkSync(this.#name(path)); }
  rmdir(path) { fs.rmdirSync(this.#name(path)); }
  mkdir(path, mode) { fs.mkdirSync(this.#name(path), mode); }
  chmod(fd, mode) { fs.fchmodSync(fd, mode); }
  chown(fd, user, group) { fs.fchownSync(fd, user >>> 0, group >>> 0); }
  sync(fd) { fs.fsyncSync(fd); }
  isTerminal(fd) { return tty.isatty(fd); }
  wait(milliseconds) { Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, milliseconds); }
}

/** The arguments and environment variables of the program. */
export function ownBytes(text) {
  return isWindows ? fromHere(text) : Buffer.from(text).toString("latin1");
}
