/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A worker with the program in it.  Messages {id, args, files, keep}: runs the
 * command line `args`; `files`, by name, are put where it finds them first, and
 * those named in `keep` come back; those in `clear` are
 * removed before, those in `drop` after.  While it runs, states of the film go to the
 * page, and the page asks it to stop by withdrawing the address `flag`, which
 * is all that reaches a worker at work.
 */
const files = new Files();
let made = null, program = null, printed = null, flag = "", posting = null;
let next = 0, asked = 0, stopping = false, begun = 0;

const QUIET = 100, LOOK = 150; // ms between two states, two looks at the flag
const FIELDS = ["X", "P", "H", "S", "F", "T1", "T2", "T3", "C"]; // of page.c
let passed = []; // fields of the state that is being passed on
const NODES = 2000; // of a state under way: more are more than a screen shows

function withdrawn() {
  const request = new XMLHttpRequest();
  try {
    request.open("GET", flag, false);
    request.send();
    return request.status !== 200 && request.status !== 0;
  } catch (error) {
    return true;
  }
}

const page = {
  stop() {
    if (stopping || !flag || performance.now() < asked) return stopping ? 1 : 0;
    stopping = withdrawn();
    asked = performance.now() + LOOK;
    return stopping ? 1 : 0;
  },
  wants: () => posting && performance.now() >= next ? 1 : 0,
  field(k, n, where) {
    if (posting) passed.push([FIELDS[k],
      new Float64Array(program.memory.buffer, where, n).slice()]);
  },
  state(T, fraction, b, p) {
    if (!posting) return;
    const state = { T, fraction, b, p,
      seconds: (performance.now() - begun) / 1000 };
    const stride = fraction < 1 ? Math.ceil(passed[0][1].length / NODES) : 1;
    for (const [name, values] of passed)
      state[name] = values.filter((_, i) => i % stride === 0);
    passed = [];
    postMessage({ id: posting, state });
    next = performance.now() + QUIET;
  },
};

function start() {
  const wasi = makeWasi(files, (fd, bytes) => printed[fd - 1].push(bytes));
  const instance = new WebAssembly.Instance(made,
    { wasi_snapshot_preview1: wasi.calls, page });
  program = instance.exports;
  wasi.attach(program.memory);
  program._initialize();
}

function call(args) {
  const words = ["overroll", ...args].map((a) => new TextEncoder().encode(a));
  const size = words.reduce((sum, w) => sum + w.length + 1, 0);
  const list = program.page_alloc(4 * (words.length + 1) + size);
  let at = list + 4 * (words.length + 1);
  const bytes = new Uint8Array(program.memory.buffer);
  const view = new DataView(program.memory.buffer);
  words.forEach((word, k) => {
    view.setUint32(list + 4 * k, at, true);
    bytes.set(word, at);
    bytes[at + word.length] = 0;
    at += word.length + 1;
  });
  view.setUint32(list + 4 * words.length, 0, true);
  const code = program.page_main(words.length, list);
  program.page_free(list);
  return code;
}

const textOf = (pieces) => {
  const decoder = new TextDecoder();
  return pieces.map((p) => decoder.decode(p, { stream: true })).join("");
};

// Files by a name, in which a star stands for anything.
const named = (pattern) => [...files.of.keys()].filter((name) => {
  const [head, tail] = pattern.split("*");
  return tail === undefined ? name === pattern
    : name.startsWith(head) && name.endsWith(tail);
});

function run(message) {
  const answer = { id: message.id, files: {} };
  printed = [[], []];
  flag = message.flag || "";
  if (flag && withdrawn()) flag = ""; // not to be asked here: it can be ended
  stopping = false;
  posting = message.states ? message.id : null;
  next = asked = 0;
  begun = performance.now();
  for (const pattern of message.clear || [])
    for (const name of named(pattern)) files.of.delete(name);
  for (const [name, content] of Object.entries(message.files || {}))
    files.write(name, content);
  try {
    if (!program) start();
    answer.code = call(message.args);
  } catch (error) {
    if (error instanceof Exit) {
      answer.code = error.code;
    } else {
      answer.code = 1;
      answer.trouble = String(error.message || error);
    }
    program = null; // begun anew: what it held is lost, files stay
  }
  answer.out = textOf(printed[0]);
  answer.err = textOf(printed[1]);
  answer.stopped = stopping;
  answer.memory = program ? program.memory.buffer.byteLength : 0;
  const parts = [];
  for (const pattern of message.keep || [])
    for (const name of named(pattern)) {
      answer.files[name] = files.read(name);
      parts.push(answer.files[name].buffer);
    }
  for (const name of message.drop || []) files.of.delete(name);
  postMessage(answer, parts);
}

onmessage = (event) => {
  if (event.data.module) made = event.data.module;
  else run(event.data);
};
