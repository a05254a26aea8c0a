/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The program, in two workers: one answers at once (checks, the steady
 * contact), the other marches in time.  What a worker is asked for comes as a
 * promise of {code, out, err, files}.
 */
const element = (parent, name, kind) => {
  const e = document.createElement(name);
  if (kind) e.className = kind;
  parent.appendChild(e);
  return e;
};

let module_ = null;     // WebAssembly.Module
const dropped = {};     // files that the user has put here, by name

class Program {
  constructor() { this.begin(); }
  begin() {
    const text = byId("worker").textContent;
    const url = URL.createObjectURL(new Blob([text],
      { type: "text/javascript" }));
    this.worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.waiting = new Map();
    this.next = 1;
    this.worker.onmessage = (event) => this.hear(event.data);
    this.worker.postMessage({ module: module_ });
  }
  hear(answer) {
    const asked = this.waiting.get(answer.id);
    if (!asked) return;
    if (answer.state) {
      if (asked.state) asked.state(answer.state);
      return;
    }
    this.waiting.delete(answer.id);
    if (asked.flag) URL.revokeObjectURL(asked.flag);
    asked.resolve(answer);
  }
  // `state` takes the film as it comes; `files` lie in the program's folder.
  call(args, { files = {}, keep = [], drop = [], clear = [], state = null,
    stops = false }
    = {}) {
    const id = this.next++;
    const flag = stops ? URL.createObjectURL(new Blob(["go on"])) : "";
    this.flag = flag;
    return new Promise((resolve) => {
      this.waiting.set(id, { resolve, state, flag });
      this.worker.postMessage({ id, args, keep, drop, clear, flag, states: !!state,
        files: { ...dropped, ...files } });
    });
  }
  // At its next step; what the file holds stays.
  ask() {
    if (this.flag) URL.revokeObjectURL(this.flag);
  }
  // At once, whatever it does; what it holds is lost.
  end() {
    this.worker.terminate();
    const waiting = [...this.waiting.values()];
    this.begin();
    for (const asked of waiting)
      asked.resolve({ code: 1, out: "", err: "stopped", files: {},
        ended: true });
  }
}

async function unpack() {
  const packed = byId("program").textContent.trim();
  const bytes = await (await new Response(new Blob([bytesOf(packed)]).stream()
    .pipeThrough(new DecompressionStream("gzip")))).arrayBuffer();
  byId("program").remove();
  module_ = await WebAssembly.compile(bytes);
}

// What the program said, without its name before each line.
const said = (answer) => (answer.err || answer.trouble || "").trim().split("\n")
  .map((line) => line.replace(/^overroll: /, "")).filter(Boolean);

function save(name, content, type) {
  const a = document.createElement("a");
  a.href = URL.createObjectURL(new Blob([content], { type }));
  a.download = name;
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 10000);
}
