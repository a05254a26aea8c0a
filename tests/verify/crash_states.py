# SPDX-License-Identifier: GPL-3.0-or-later
"""Creates folders as they may be on disk after a crash of the machine.

usage: crash_states.py LOG BEFORE OUT COUNT SEED

LOG is the output of recorder.c, and BEFORE a folder with the (synced) files
before the run. COUNT folders OUT/0, OUT/1, ... are written. Each is a random
possible state at a random operation:

- Each page (4096 bytes) of a file has the contents of the last sync or of any
  later write. The same applies to the length of the file. Unwritten parts of a
  page are zero.
- Each change of a name since the last sync of the folder is done or not. In
  half of the states, all changes up to a random one are done.

The probability of old pages and names is drawn for each state, from 0 to 1.
"""
import os
import random
import struct
import sys

(CREATE, OPEN, CLOSE, WRITE, CUT, SYNC, SYNC_NAMES, RENAME,
 UNLINK) = range(1, 10)
PAGE = 4096


class File:
    def __init__(self, data=b""):
        self.now = bytearray(data)
        self.sync()

    def sync(self):
        self.synced = bytes(self.now)
        self.pages = {}  # number: contents since the last sync
        self.lengths = []

    def note(self, first, last):
        for k in range(first // PAGE, (last + PAGE - 1) // PAGE):
            was = bytes(self.now[k * PAGE:(k + 1) * PAGE])
            self.pages.setdefault(k, []).append(was.ljust(PAGE, b"\0"))
        self.lengths.append(len(self.now))

    def write(self, at, data):
        self.now.extend(bytes(max(0, at + len(data) - len(self.now))))
        self.now[at:at + len(data)] = data
        self.note(at, at + len(data))

    def cut(self, length):
        was = len(self.now)
        del self.now[length:]
        self.now.extend(bytes(length - len(self.now)))
        self.note(min(was, length), max(was, length))

    def crashed(self, chance, old):
        """Creates one state; `old` is the probability that a page or name is
        the synced one."""
        length = len(self.synced)
        if self.lengths and chance.random() >= old:
            length = chance.choice([self.lengths[-1]] * 3 + self.lengths)
        data = bytearray(self.synced[:length].ljust(length, b"\0"))
        for k, versions in self.pages.items():
            if chance.random() >= old and k * PAGE < length:
                page = chance.choice([versions[-1]] * 3 + versions)
                data[k * PAGE:(k + 1) * PAGE] = page[:length - k * PAGE]
        return data


class Folder:
    def __init__(self, path):
        self.names = {}
        for name in os.listdir(path):
            with open(os.path.join(path, name), "rb") as f:
                self.names[name] = File(f.read())
        self.open = {}
        self.sync()

    def sync(self):
        self.synced = dict(self.names)
        self.changes = []

    def change(self, *change):
        self.changes.append(change)
        apply(self.names, change)

    def crashed(self, chance):
        old = chance.choice([0, 0.1, 0.5, 0.9, 1, chance.random()])
        names = dict(self.synced)
        upto = chance.randint(0, len(self.changes))
        ordered = chance.random() < 0.5
        for k, change in enumerate(self.changes):
            if k < upto if ordered else chance.random() >= old:
                apply(names, change)
        return {n: f.crashed(chance, old) for n, f in names.items()}


def apply(names, change):
    gone, name, file = change
    if gone:
        names.pop(gone, None)
    if name:
        names[name] = file


def text(data):
    return [os.path.basename(n.decode()) for n in data.split(b"\0")[:-1]]


def play(folder, what, fd, at, data):
    if what in (CREATE, OPEN):
        name = text(data)[0]
        if what == CREATE:
            folder.change(None, name, File())
        folder.open[fd] = folder.names[name]
        if what == OPEN and at:
            folder.open[fd].cut(0)
    elif what == CLOSE:
        del folder.open[fd]
    elif what == WRITE:
        folder.open[fd].write(at, data)
    elif what == CUT:
        folder.open[fd].cut(at)
    elif what == SYNC:
        folder.open[fd].sync()
    elif what == SYNC_NAMES:
        folder.sync()
    elif what == RENAME:
        old, new = text(data)
        folder.change(old, new, folder.names[old])
    elif what == UNLINK:
        folder.change(text(data)[0], None, None)


def read_log(path):
    with open(path, "rb") as f:
        log = f.read()
    at = 0
    while at < len(log):
        what, fd, where, size = struct.unpack_from("<4q", log, at)
        at += 32
        yield what, fd, where, log[at:at + size]
        at += size


def main(log, before, out, count, seed):
    chance = random.Random(int(seed))
    operations = list(read_log(log))
    moments = sorted(chance.randint(1, len(operations))
                     for _ in range(int(count)))
    folder, done = Folder(before), 0
    for k, moment in enumerate(moments):
        for operation in operations[done:moment]:
            play(folder, *operation)
        done = moment
        os.makedirs("%s/%d" % (out, k))
        for name, data in folder.crashed(chance).items():
            with open("%s/%d/%s" % (out, k, name), "wb") as f:
                f.write(data)
    print("%d operations, %d of them syncs" % (
        len(operations), sum(o[0] in (SYNC, SYNC_NAMES) for o in operations)))


main(*sys.argv[1:])
