// SPDX-License-Identifier: BSD-3-Clause
// The system calls of smurf.wasm, for the files of the machine (node_files.mjs) or files in memory (memory_files.mjs).
// Calls and layouts are those of Emscripten's C library; main.cpp verifies them.

/** An error like those that the functions of node:fs throw. */
export class FileError extends Error {
  constructor(code) {
    super(code);
    this.code = code;
  }
}

class Exit {
  constructor(code) {
    this.code = code;
  }
}

const kErrors = Object.fromEntries(
  ("OK 2BIG ACCES ADDRINUSE ADDRNOTAVAIL AFNOSUPPORT AGAIN ALREADY BADF BADMSG BUSY CANCELED CHILD CONNABORTED " +
   "CONNREFUSED CONNRESET DEADLK DESTADDRREQ DOM DQUOT EXIST FAULT FBIG HOSTUNREACH IDRM ILSEQ INPROGRESS INTR INVAL IO " +
   "ISCONN ISDIR LOOP MFILE MLINK MSGSIZE MULTIHOP NAMETOOLONG NETDOWN NETRESET NETUNREACH NFILE NOBUFS NODEV NOENT " +
   "NOEXEC NOLCK NOLINK NOMEM NOMSG NOPROTOOPT NOSPC NOSYS NOTCONN NOTDIR NOTEMPTY NOTRECOVERABLE NOTSOCK NOTSUP_ NOTTY " +
   "NXIO OVERFLOW OWNERDEAD PERM PIPE PROTO PROTONOSUPPORT PROTOTYPE RANGE ROFS SPIPE SRCH STALE TIMEDOUT TXTBSY XDEV")
    .split(" ").map((name, number) => ["E" + name, number]));
kErrors.ENOTSUP = kErrors.EOPNOTSUPP = 138;

function errnoOf(error) {
  if (error instanceof FileError || typeof error?.code === "string") return kErrors[error.code] ?? kErrors.EIO;
  throw error;
}

/** The flags of open(). */
export const Open = {
  write: 0o1, readWrite: 0o2, create: 0o100, exclusive: 0o200, noTerminal: 0o400, truncate: 0o1000, append: 0o2000,
  nonBlocking: 0o4000, folder: 0o200000, noFollow: 0o400000, path: 0o10000000, nameless: 0o20000000,
};

const kCurrentFolder = -100;
const kRemoveFolder = 0x200;
const kNoFollow = 0x100;
const kEntrySize = 280;
/** main() adds this to its exit code, to distinguish it from that of abort(). */
const kEnded = 64;
/** The exit code of a run that failed. */
export const kFailed = 2;

export class Host {
  #memory;
  #view;
  #lists = new Map();

  /** `files` has the interface of node:fs; `args` begins with the name of the tool. */
  constructor(files, args, environment) {
    this.files = files;
    this.args = args.map((text) => this.#encode(text));
    this.environment = Object.entries(environment).map(([name, value]) => this.#encode(`${name}=${value}`));
  }

  /** Runs the program to its end, and returns its exit code. */
  run(module) {
    const imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      (imports[from] ??= {})[name] = this.#bind(from, name);
    }
    const instance = new WebAssembly.Instance(module, imports);
    this.#memory = instance.exports.memory;
    try {
      instance.exports._start();
      return kFailed;
    } catch (error) {
      if (error instanceof Exit) return error.code >= kEnded ? error.code - kEnded : kFailed;
      this.#complain(error);
      return kFailed;
    }
  }

  #complain(error) {
    const reason = error instanceof RangeError ? "the files are nested too deeply for this JavaScript engine" : String(error);
    const text = new TextEncoder().encode(`${new TextDecoder().decode(this.args[0].subarray(0, -1))}: ${reason}\n`);
    this.files.write(2, text, null);
  }

  #bind(from, name) {
    const isWasi = from === "wasi_snapshot_preview1";
    const call = isWasi ? this.#wasi[name] : this.#calls[name];
    if (call === undefined) return () => (isWasi ? kErrors.ENOSYS : -kErrors.ENOSYS);
    return (...args) => {
      try {
        return call(...args) ?? 0;
      } catch (error) {
        if (error instanceof Exit) throw error;
        return isWasi ? errnoOf(error) : -errnoOf(error);
      }
    };
  }

  // When the memory grows, earlier views of it become invalid.
  get #data() {
    if (this.#view?.buffer !== this.#memory.buffer) this.#view = new DataView(this.#memory.buffer);
    return this.#view;
  }

  #bytes(at, size) { return new Uint8Array(this.#memory.buffer, at >>> 0, size >>> 0); }

  #encode(text) { return this.files.encode(text + "\0"); }

  #text(at) {
    const rest = new Uint8Array(this.#memory.buffer, at >>> 0);
    return this.files.decode(rest.subarray(0, rest.indexOf(0)));
  }

  /** A path relative to an open folder. */
  #path(folder, at) {
    const path = this.#text(at);
    if (path === "") throw new FileError("ENOENT");
    return folder === kCurrentFolder || path.startsWith("/") ? path : this.files.below(folder, path);
  }

  #setStatus(at, status) {
    const data = this.#data;
    const seconds = (time) => Math.floor(Number(time) / 1000) | 0;
    at >>>= 0;
    data.setUint32(at, Number(BigInt.asUintN(32, BigInt(status.dev))), true);
    data.setUint32(at + 12, Number(status.mode), true);
    data.setUint32(at + 16, Number(status.nlink), true);
    data.setUint32(at + 20, Number(status.uid), true);
    data.setUint32(at + 24, Number(status.gid), true);
    data.setBigInt64(at + 40, BigInt(status.size), true);
    data.setInt32(at + 56, seconds(status.atimeMs), true);
    data.setInt32(at + 64, seconds(status.mtimeMs), true);
    data.setInt32(at + 72, seconds(status.ctimeMs), true);
    data.setBigUint64(at + 80, BigInt.asUintN(64, BigInt(status.ino)), true);
  }

  #setList(at, texts, sizeAt) {
    for (const text of texts) {
      this.#data.setUint32(at, sizeAt, true);
      this.#bytes(sizeAt, text.length).set(text);
      at += 4;
      sizeAt += text.length;
    }
  }

  #setSizes(countAt, sizeAt, texts) {
    this.#data.setUint32(countAt, texts.length, true);
    this.#data.setUint32(sizeAt, texts.reduce((sum, text) => sum + text.length, 0), true);
  }

  /** Reads into, or writes from, the buffers at `at`. Ends at the first buffer that is not filled. */
  #transfer(at, count, doneAt, position, work) {
    let done = 0;
    for (let i = 0; i < count; ++i) {
      const size = this.#data.getUint32(at + 8 * i + 4, true);
      if (size === 0) continue;
      const here = work(this.#bytes(this.#data.getUint32(at + 8 * i, true), size), position === null ? null : position + done);
      done += here;
      if (here < size) break;
    }
    this.#data.setUint32(doneAt, done, true);
  }

  #addEntries(fd, at, size) {
    if (!this.#lists.has(fd)) this.#lists.set(fd, { next: 0, names: this.files.list(fd) });
    const list = this.#lists.get(fd);
    let used = 0;
    for (; list.next < list.names.length && used + kEntrySize <= size; ++list.next, used += kEntrySize) {
      const { name, type } = list.names[list.next];
      const text = this.#encode(name).subarray(0, 256);
      this.#data.setBigUint64(at + used, 1n, true);
      this.#data.setBigInt64(at + used + 8, BigInt(list.next + 1), true);
      this.#data.setUint16(at + used + 16, kEntrySize, true);
      this.#data.setUint8(at + used + 18, type);
      this.#bytes(at + used + 19, text.length).set(text);
    }
    return used;
  }

  #setText(at, size, text) {
    this.#bytes(at, Math.min(size, text.length)).set(text.subarray(0, size));
    return Math.min(size, text.length);
  }

  #calls = {
    emscripten_notify_memory_growth: () => {},
    __syscall_openat: (folder, path, flags, more) =>
      this.files.open(this.#path(folder, path), flags, more ? this.#data.getUint32(more, true) : 0),
    __syscall_stat64: (path, to) => this.#setStatus(to, this.files.stat(this.#path(kCurrentFolder, path))),
    __syscall_lstat64: (path, to) => this.#setStatus(to, this.files.lstat(this.#path(kCurrentFolder, path))),
    __syscall_fstat64: (fd, to) => this.#setStatus(to, this.files.fstat(fd)),
    __syscall_fstatat64: (folder, path, to, flags) => {
      const whole = this.#path(folder, path);
      this.#setStatus(to, flags & kNoFollow ? this.files.lstat(whole) : this.files.stat(whole));
    },
    __syscall_getdents64: (fd, to, size) => this.#addEntries(fd, to, size),
    __syscall_readlink: (path, to, size) => this.#setText(to, size, this.files.readlink(this.#path(kCurrentFolder, path))),
    __syscall_readlinkat: (folder, path, to, size) => this.#setText(to, size, this.files.readlink(this.#path(folder, path))),
    __syscall_rename: (from, to) => this.files.rename(this.#path(kCurrentFolder, from), this.#path(kCurrentFolder, to)),
    __syscall_renameat: (fromFolder, from, toFolder, to) =>
      this.files.rename(this.#path(fromFolder, from), this.#path(toFolder, to)),
    __syscall_linkat: (fromFolder, from, toFolder, to) =>
      this.files.link(this.#path(fromFolder, from), this.#path(toFolder, to)),
    __syscall_unlink: (path) => this.files.unlink(this.#path(kCurrentFolder, path)),
    __syscall_rmdir: (path) => this.files.rmdir(this.#path(kCurrentFolder, path)),
    __syscall_unlinkat: (folder, path, flags) => {
      const whole = this.#path(folder, path);
      if (flags & kRemoveFolder) this.files.rmdir(whole);
      else this.files.unlink(whole);
    },
    __syscall_mkdir: (path, mode) => this.files.mkdir(this.#path(kCurrentFolder, path), mode),
    __syscall_mkdirat: (folder, path, mode) => this.files.mkdir(this.#path(folder, path), mode),
    __syscall_faccessat: (folder, path) => { this.files.stat(this.#path(folder, path)); },
    __syscall_fchmod: (fd, mode) => this.files.chmod(fd, mode),
    __syscall_fchown32: (fd, user, group) => this.files.chown(fd, user, group),
    __syscall_getcwd: (to, size) => {
      const text = this.#encode(this.files.folder());
      if (text.length > size) throw new FileError("ERANGE");
      this.#setText(to, size, text);
      return text.length;
    },
    __syscall_poll: (_list, _count, wait) => this.files.wait(wait < 0 ? 10 : wait),
  };

  #wasi = {
    args_sizes_get: (count, size) => this.#setSizes(count, size, this.args),
    args_get: (list, texts) => this.#setList(list, this.args, texts),
    environ_sizes_get: (count, size) => this.#setSizes(count, size, this.environment),
    environ_get: (list, texts) => this.#setList(list, this.environment, texts),
    proc_exit: (code) => { throw new Exit(code); },
    clock_time_get: (_clock, _precision, to) =>
      this.#data.setBigUint64(to, BigInt(Date.now()) * 1000000n, true),
    fd_read: (fd, list, count, done) =>
      this.#transfer(list, count, done, null, (bytes, at) => this.files.read(fd, bytes, at)),
    fd_pread: (fd, list, count, position, done) =>
      this.#transfer(list, count, done, Number(position), (bytes, at) => this.files.read(fd, bytes, at)),
    fd_write: (fd, list, count, done) =>
      this.#transfer(list, count, done, null, (bytes, at) => this.files.write(fd, bytes, at)),
    fd_close: (fd) => {
      this.#lists.delete(fd);
      this.files.close(fd);
    },
    fd_sync: (fd) => this.files.sync(fd),
    fd_fdstat_get: (fd, to) => {
      this.#bytes(to, 24).fill(0);
      const kTerminal = 2;
      const kFile = 4;
      this.#data.setUint8(to, this.files.isTerminal(fd) ? kTerminal : kFile);
    },
  };
}
