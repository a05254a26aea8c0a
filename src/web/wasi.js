/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The system that the program sees: wasi_snapshot_preview1 with files in
 * memory.  A file is {bytes, size, time}; directories are names alone.
 */
"use strict";

const ERROR = { BADF: 8, EXIST: 20, INVAL: 28, ISDIR: 31, NOENT: 44, NOSYS: 52,
  NOTDIR: 54, NOTEMPTY: 55 };
const REGULAR = 4, DIRECTORY = 3, CHARACTER = 2;

class Exit extends Error {
  constructor(code) {
    super("exit " + code);
    this.code = code;
  }
}

class Files {
  constructor() {
    this.of = new Map();
    this.folders = new Set([""]);
  }
  write(path, content) {
    const bytes = typeof content === "string"
      ? new TextEncoder().encode(content) : new Uint8Array(content);
    this.of.set(path, { bytes, size: bytes.length, time: Date.now() });
  }
  read(path) {
    const file = this.of.get(path);
    return file && file.bytes.slice(0, file.size);
  }
  isFolder(path) { return this.folders.has(path); }
  names(folder) {
    const start = folder ? folder + "/" : "";
    return [...this.of.keys(), ...this.folders].filter((name) => name &&
      name.startsWith(start) && !name.slice(start.length).includes("/"))
      .map((name) => [name.slice(start.length),
        this.isFolder(name) ? DIRECTORY : REGULAR]);
  }
}

function reserve(file, size) {
  if (size <= file.bytes.length) return;
  const more = new Uint8Array(Math.max(size, 2 * file.bytes.length, 4096));
  more.set(file.bytes.subarray(0, file.size));
  file.bytes = more;
}

function resize(file, size) {
  reserve(file, size);
  if (size < file.size) file.bytes.fill(0, size, file.size);
  file.size = size;
}

// `out(fd, text bytes)` takes what is printed.
function makeWasi(files, out) {
  let memory = null;
  const open = [{ kind: CHARACTER }, { kind: CHARACTER }, { kind: CHARACTER },
    { kind: DIRECTORY, path: "" }];
  const view = () => new DataView(memory.buffer);
  const bytes = (at, n) => new Uint8Array(memory.buffer, at, n);
  const text = (at, n) => new TextDecoder().decode(bytes(at, n).slice());
  const put32 = (at, v) => view().setUint32(at, v, true);
  const put64 = (at, v) => view().setBigUint64(at, BigInt(v), true);

  function resolve(fd, at, n) {
    const parts = [];
    const start = open[fd] && open[fd].path ? open[fd].path + "/" : "";
    for (const part of (start + text(at, n)).split("/")) {
      if (part === "..") parts.pop();
      else if (part && part !== ".") parts.push(part);
    }
    return parts.join("/");
  }
  function putStat(at, entry) {
    bytes(at, 64).fill(0);
    view().setUint8(at + 16, entry.kind);
    put64(at + 8, entry.file ? entry.file.number : 1);
    put64(at + 24, 1);
    put64(at + 32, entry.file ? entry.file.size : 0);
    const time = BigInt(Math.round(entry.file ? entry.file.time : 0)) *
      1000000n;
    for (const k of [40, 48, 56]) put64(at + k, time);
    return 0;
  }
  let numbers = 2;
  function numbered(file) {
    file.number = file.number || numbers++;
    return file;
  }
  function newFd(entry) {
    let fd = 4;
    while (open[fd]) fd++;
    open[fd] = entry;
    return fd;
  }
  function* pieces(list, count) {
    for (let k = 0; k < count; k++) {
      const v = view();
      yield bytes(v.getUint32(list + 8 * k, true),
        v.getUint32(list + 8 * k + 4, true));
    }
  }
  function readAt(file, position, list, count) {
    let n = 0;
    for (const to of pieces(list, count)) {
      const from = file.bytes.subarray(position + n,
        Math.max(position + n, Math.min(file.size, position + n + to.length)));
      to.set(from);
      n += from.length;
      if (from.length < to.length) break;
    }
    return n;
  }
  function writeAt(file, position, list, count) {
    let n = 0;
    for (const from of pieces(list, count)) {
      if (position + n + from.length > file.size)
        resize(file, position + n + from.length);
      file.bytes.set(from, position + n);
      n += from.length;
    }
    file.time = Date.now();
    return n;
  }
  const withFile = (act) => (fd, ...more) => {
    const entry = open[fd];
    if (!entry) return ERROR.BADF;
    if (!entry.file) return entry.kind === DIRECTORY ? ERROR.ISDIR
      : ERROR.BADF;
    return act(entry, ...more);
  };
  const calls = {
    args_sizes_get: (n, size) => (put32(n, 0), put32(size, 0), 0),
    args_get: () => 0,
    environ_sizes_get: (n, size) => (put32(n, 0), put32(size, 0), 0),
    environ_get: () => 0,
    clock_res_get: (id, at) => (put64(at, 1000), 0),
    clock_time_get(id, precision, at) {
      const ms = id === 0 ? Date.now() : performance.now();
      put64(at, Math.round(ms * 1e6));
      return 0;
    },
    fd_advise: () => 0,
    fd_allocate: withFile((entry, from, n) => {
      const size = Number(from) + Number(n);
      if (size > entry.file.size) resize(entry.file, size);
      return 0;
    }),
    fd_close(fd) {
      if (!open[fd]) return ERROR.BADF;
      open[fd] = null;
      return 0;
    },
    fd_datasync: () => 0,
    fd_sync: () => 0,
    fd_fdstat_get(fd, at) {
      if (!open[fd]) return ERROR.BADF;
      bytes(at, 24).fill(0);
      view().setUint8(at, open[fd].kind);
      view().setUint16(at + 2, open[fd].append ? 1 : 0, true);
      view().setBigUint64(at + 8, 0x1fffffffn, true);
      view().setBigUint64(at + 16, 0x1fffffffn, true);
      return 0;
    },
    fd_fdstat_set_flags: () => 0,
    fd_filestat_get: (fd, at) => open[fd] ? putStat(at, open[fd]) : ERROR.BADF,
    fd_filestat_set_size: withFile((entry, size) =>
      (resize(entry.file, Number(size)), 0)),
    fd_filestat_set_times: () => 0,
    fd_pread: withFile((entry, list, count, from, at) =>
      (put32(at, readAt(entry.file, Number(from), list, count)), 0)),
    fd_pwrite: withFile((entry, list, count, from, at) =>
      (put32(at, writeAt(entry.file, Number(from), list, count)), 0)),
    fd_prestat_get(fd, at) {
      if (fd !== 3) return ERROR.BADF;
      put32(at, 0);
      put32(at + 4, 1);
      return 0;
    },
    fd_prestat_dir_name: (fd, at) => (bytes(at, 1)[0] = 47, 0),
    fd_read(fd, list, count, at) {
      const entry = open[fd];
      if (!entry) return ERROR.BADF;
      const n = entry.file
        ? readAt(entry.file, entry.position, list, count) : 0;
      if (entry.file) entry.position += n;
      put32(at, n);
      return 0;
    },
    fd_readdir(fd, at, length, cookie, used) {
      const names = files.names(open[fd].path);
      let n = 0;
      for (let k = Number(cookie); k < names.length && n < length; k++) {
        const name = new TextEncoder().encode(names[k][0]);
        const row = new Uint8Array(24 + name.length), v = new DataView(row.buffer);
        v.setBigUint64(0, BigInt(k + 1), true);
        v.setBigUint64(8, BigInt(k + 2), true);
        v.setUint32(16, name.length, true);
        v.setUint8(20, names[k][1]);
        row.set(name, 24);
        bytes(at + n, Math.min(row.length, length - n))
          .set(row.subarray(0, length - n));
        n += Math.min(row.length, length - n);
      }
      put32(used, n);
      return 0;
    },
    fd_renumber(fd, to) {
      open[to] = open[fd];
      open[fd] = null;
      return 0;
    },
    fd_seek(fd, by, from, at) {
      const entry = open[fd];
      if (!entry) return ERROR.BADF;
      if (!entry.file) return 70; // a stream
      const start = [0, entry.position, entry.file.size][from];
      entry.position = start + Number(by);
      put64(at, entry.position);
      return 0;
    },
    fd_tell: withFile((entry, at) => (put64(at, entry.position), 0)),
    fd_write(fd, list, count, at) {
      const entry = open[fd];
      if (!entry) return ERROR.BADF;
      let n = 0;
      if (entry.file) {
        if (entry.append) entry.position = entry.file.size;
        n = writeAt(entry.file, entry.position, list, count);
        entry.position += n;
      } else {
        for (const piece of pieces(list, count)) {
          out(fd, piece.slice());
          n += piece.length;
        }
      }
      put32(at, n);
      return 0;
    },
    path_create_directory(fd, at, n) {
      const path = resolve(fd, at, n);
      if (files.isFolder(path) || files.of.has(path)) return ERROR.EXIST;
      files.folders.add(path);
      return 0;
    },
    path_filestat_get(fd, follow, at, n, to) {
      const path = resolve(fd, at, n), file = files.of.get(path);
      if (file) return putStat(to, { kind: REGULAR, file: numbered(file) });
      return files.isFolder(path) ? putStat(to, { kind: DIRECTORY })
        : ERROR.NOENT;
    },
    path_filestat_set_times: () => 0,
    path_link(fd, follow, at, n, to, toAt, toN) {
      const file = files.of.get(resolve(fd, at, n));
      const path = resolve(to, toAt, toN);
      if (!file) return ERROR.NOENT;
      if (files.of.has(path)) return ERROR.EXIST;
      files.of.set(path, file);
      return 0;
    },
    path_open(fd, follow, at, n, how, rights, inheriting, flags, to) {
      const path = resolve(fd, at, n);
      const create = how & 1, folder = how & 2, anew = how & 4, cut = how & 8;
      let file = files.of.get(path);
      if (files.isFolder(path)) {
        if (create && anew) return ERROR.EXIST;
        if (rights & 64n && !folder) return ERROR.ISDIR;
        put32(to, newFd({ kind: DIRECTORY, path }));
        return 0;
      }
      if (folder) return file ? ERROR.NOTDIR : ERROR.NOENT;
      if (file && create && anew) return ERROR.EXIST;
      if (!file && !create) return ERROR.NOENT;
      if (!file) {
        if (!files.isFolder(path.split("/").slice(0, -1).join("/")))
          return ERROR.NOENT;
        files.write(path, "");
        file = files.of.get(path);
      }
      if (cut) resize(file, 0);
      put32(to, newFd({ kind: REGULAR, file: numbered(file), position: 0,
        append: flags & 1 }));
      return 0;
    },
    path_readlink: () => ERROR.INVAL,
    path_remove_directory(fd, at, n) {
      const path = resolve(fd, at, n);
      if (!files.isFolder(path)) return ERROR.NOENT;
      if (files.names(path).length) return ERROR.NOTEMPTY;
      files.folders.delete(path);
      return 0;
    },
    path_rename(fd, at, n, to, toAt, toN) {
      const from = resolve(fd, at, n), file = files.of.get(from);
      if (!file) return ERROR.NOENT;
      files.of.delete(from);
      files.of.set(resolve(to, toAt, toN), file);
      return 0;
    },
    path_unlink_file(fd, at, n) {
      return files.of.delete(resolve(fd, at, n)) ? 0 : ERROR.NOENT;
    },
    poll_oneoff: (from, to, n, used) => (put32(used, n), 0),
    proc_exit(code) { throw new Exit(code); },
    random_get(at, n) {
      for (let k = 0; k < n; k += 65536)
        crypto.getRandomValues(bytes(at + k, Math.min(65536, n - k)));
      return 0;
    },
    sched_yield: () => 0,
  };
  const missing = { get: (has, name) => has[name] || (() => ERROR.NOSYS) };
  return { calls: new Proxy(calls, missing),
    attach(its) { memory = its; } };
}
