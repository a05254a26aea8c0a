/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A run in time, its player, files in and out, links, and the beginning.
 */
let marcher = null;         // Program
let marching = false, paused = false, stopped = false;
let result = null;          // { files, names, h5, html } of the last run

function marchingNow(on) {
  marching = on;
  for (const id of ["stop", "progress"]) byId(id).hidden = !on;
  byId("pause").hidden = !on;
  byId("run").disabled = on;
  if (!on) byId("left").textContent = "";
}

// Of several passes, each has a file of its own.
const RESULTS = ["result.h5", "result-*.h5"];

// One stretch, to the end, a pause or a stop; the file holds all so far.
async function march(args, files, clear) {
  let from = null;
  return marcher.call(args, { files, stops: true, clear, keep: RESULTS,
    state: (s) => {
      if (!marching || paused) return;
      from = from || s;
      const done = s.fraction - from.fraction;
      byId("progress").value = s.fraction;
      byId("left").textContent = Math.floor(100 * s.fraction) + " %" +
        (done > 0.005 ? ", " + clock((s.seconds - from.seconds) *
          (1 - s.fraction) / done) + " left" : "");
      byId("left").dataset.states = Number(byId("left").dataset.states || 0) + 1;
      showRun(runOfState(s, scales));
    } });
}

let scales = null, carryOn = null;

async function runInTime() {
  const about = await check();
  if (!about || !about.runs) return;
  if (!await mayTake(about.seconds, "This run")) return;
  showPlayer(false);
  scales = about;
  stopped = paused = false;
  marchingNow(true);
  byId("pause").textContent = "❚❚ pause";
  byId("status").textContent = "running";
  let answer = await march(["solve", "case.ini", "-o", "result.h5", "--json"],
    { "case.ini": textOfCase() }, ["result*"]);
  while (paused && !stopped && !answer.ended) {
    byId("status").textContent = "paused at " + byId("left").textContent;
    byId("pause").disabled = false;
    await new Promise((resolve) => { carryOn = resolve; });
    carryOn = null;
    if (stopped) break;
    paused = false;
    byId("pause").textContent = "❚❚ pause";
    byId("status").textContent = "running";
    answer = await march(["solve", "result.h5", "--resume", "--json"], {}, []);
  }
  await runEnded(answer);
}

async function runEnded(answer) {
  const lines = said(answer);
  if (answer.ended || !answer.files["result.h5"]) {
    showTrouble(answer.ended ? "" : lines.pop() || "the run failed");
    byId("status").textContent = "stopped";
    marchingNow(false);
    return;
  }
  const files = Object.keys(answer.files).filter((name) =>
    /^result-\d+\.h5$/.test(name))
    .sort((a, b) => parseInt(a.slice(7), 10) - parseInt(b.slice(7), 10));
  result = { files: answer.files, names: files.length ? files : ["result.h5"] };
  const list = byId("pass");
  list.replaceChildren();
  result.names.forEach((name, k) => {
    const option = element(list, "option");
    option.value = name;
    option.textContent = k + 1;
  });
  list.parentElement.hidden = result.names.length < 2;
  list.value = result.names[result.names.length - 1];
  marchingNow(false);
  const trouble = await play(list.value);
  const summary = answer.out && JSON.parse(answer.out);
  if (summary) showNumbers(summary);
  showNotes([...lines, ...trouble]);
  byId("status").textContent = stopped ? "stopped" : "ready";
}

// Lets view's page play a file of the last run; messages, if it cannot.
async function play(name) {
  byId("status").textContent = "making the player";
  const page = await marcher.call(["view", name, "-o", "player.html"],
    { files: { [name]: result.files[name] }, keep: ["player.html"],
      drop: ["player.html"] });
  byId("status").textContent = "ready";
  result.h5 = result.files[name];
  result.html = page.files["player.html"] || null;
  if (!result.html) return said(page);
  byId("player").srcdoc = new TextDecoder().decode(result.html);
  showPlayer(true);
  return [];
}

function showPlayer(on) {
  byId("played").hidden = !on;
  byId("live").hidden = on;
  if (!on && shown && !marching) {
    showRun(shown.run);
    showNumbers(shown.numbers);
  }
}

function pause() {
  if (carryOn) {
    carryOn();
    return;
  }
  paused = true;
  byId("pause").textContent = "▶ go on";
  byId("pause").disabled = true;
  marcher.ask();
}

// At its next step; a program that does not look is ended.
function stop() {
  if (!marching) {
    halted = true;
    live.end();
    return;
  }
  stopped = true;
  if (carryOn) {
    carryOn();
    return;
  }
  marcher.ask();
  const id = marcher.next - 1, program = marcher;
  setTimeout(() => { if (program.waiting.has(id)) program.end(); }, 3000);
}

// ---------------------------------------------------------------- profiles

async function takeFile(file) {
  const name = file.name.replace(/[^A-Za-z0-9._-]/g, "_").replace(/^\.+/, "") ||
    "profile";
  if (file.size > 64e6) {
    showTrouble(name + ": more than 64 MB is not taken here");
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (/\.ini$/i.test(name)) {
    byId("text").value = new TextDecoder().decode(bytes);
    changeCase();
    return;
  }
  dropped[name] = bytes;
  await measureProfile(name, []);
}

async function measureProfile(name, options) {
  const answer = await live.call(["profile", name, "--convert", "clean.csv",
    "--force", ...options], { keep: ["clean.csv"],
    drop: ["clean.csv"] });
  const box = element(byId("measured"), "div", "measure");
  element(box, "strong").textContent = name;
  if (answer.code) {
    element(box, "p").textContent = said(answer).join("\n");
    const form = element(box, "form", "choices");
    for (const [option, words] of [["--unit-x", "um mm nm m"],
      ["--unit-z", "um nm mm m"], ["--spacing", ""]]) {
      const label = element(form, "label");
      label.textContent = option.slice(2) + " ";
      const field = element(label, words ? "select" : "input");
      field.name = option;
      if (!words) field.placeholder = "1 um";
      for (const word of words ? ["", ...words.split(" ")] : [])
        element(field, "option").textContent = word;
    }
    element(form, "button").textContent = "read it";
    form.onsubmit = (event) => {
      event.preventDefault();
      box.remove();
      measureProfile(name, [...new FormData(form)].filter(([, v]) => v).flat());
    };
    return;
  }
  element(box, "pre").textContent = answer.out.trim().split("\n").slice(1)
    .join("\n"); // without the name
  drawProfile(element(box, "canvas"), answer.files["clean.csv"]);
  for (const surface of ["1", "2"]) {
    const put = element(box, "button");
    put.textContent = "put on surface " + surface;
    put.onclick = () => putProfile(name, surface, options);
  }
}

function putProfile(name, surface, options) {
  const where = "feature " + name.replace(/\..*$/, "").replace(/\W/g, "_");
  removeSection(where);
  for (const [key, value] of [["surface", surface], ["shape", "profile"],
    ["file", name], ...optionsAsKeys(options)]) setValue(where, key, value);
  chosen = where;
  changeCase();
}

const optionsAsKeys = (options) => options.reduce((pairs, word, k) => k % 2
  ? pairs : [...pairs, [word.slice(2).replace("-", "_"), options[k + 1]]], []);

function drawProfile(canvas, bytes) {
  if (!bytes) return;
  const points = new TextDecoder().decode(bytes).split("\n")
    .map((line) => line.split(/[,;\t ]+/).map(Number))
    .filter((p) => p.length > 1 && p.every((v) => isFinite(v)));
  if (points.length < 2) return;
  const { c, width, height } = prepare(canvas);
  const of = (k, pick) => points.reduce((m, p) => pick(m, p[k]), points[0][k]);
  const [x0, x1, y0, y1] = [of(0, Math.min), of(0, Math.max), of(1, Math.min),
    of(1, Math.max)];
  c.beginPath();
  for (const [x, z] of points)
    c.lineTo((x - x0) / (x1 - x0 || 1) * width,
      height - 4 - (z - y0) / (y1 - y0 || 1) * (height - 8));
  c.strokeStyle = colour.rough;
  c.lineWidth = 1.2;
  c.stroke();
}

// ---------------------------------------------------------------- downloads

async function download(what) {
  byId("download").value = "";
  if (what === "case") save("case.ini", textOfCase(), "text/plain");
  if (what === "svg" || what === "png") {
    if (!byId("played").hidden) showPlayer(false);
    if (!view) showTrouble("there is no picture yet");
    else if (what === "png")
      save("contact.png", await pngOfPicture(), "image/png");
    else save("contact.svg", svgOfPicture(), "image/svg+xml");
  }
  if (what === "html") {
    if (result && result.html) save("run.html", result.html, "text/html");
    else showTrouble("there is no run in time yet");
  }
  if (what === "h5" || what === "csv") {
    const file = await resultFile();
    if (!file) return;
    if (what === "h5") save("result.h5", file, "application/x-hdf5");
    else {
      const last = byId("played").hidden ? ["--snapshot", "last"] : [];
      const answer = await live.call(["export", "result.h5", "--units", "si",
        "--format", "csv", ...last], { files: { "result.h5": file } });
      if (answer.code) showTrouble(said(answer).pop());
      else save("result.csv", answer.out, "text/csv");
    }
  }
}

// Of the run that is shown, or of the steady contact: the case without an end
// of time and without passes.
async function resultFile() {
  if (!byId("played").hidden && result && result.h5) return result.h5;
  const text = textOfCase(), lines = text.split("\n");
  for (const p of parseCase(text))
    if (p.head === "passes" || p.head === "time" && p.key === "end")
      lines[p.line] = "";
  const answer = await live.call(["solve", "case.ini", "-o", "steady.h5",
    "--json"], { files: { "case.ini": lines.join("\n") }, clear: ["steady*"],
    keep: ["steady.h5"] });
  if (answer.files["steady.h5"]) return answer.files["steady.h5"];
  showTrouble(said(answer).pop() || "no result");
  return null;
}

// -------------------------------------------------------------------- links

async function copyLink() {
  const packed = new Uint8Array(await new Response(new Blob([textOfCase()])
    .stream().pipeThrough(new CompressionStream("deflate"))).arrayBuffer());
  const code = btoa(String.fromCharCode(...packed)).replace(/\+/g, "-")
    .replace(/\//g, "_").replace(/=+$/, "");
  history.replaceState(null, "", "#case=" + code);
  byId("status").textContent = "the link is in the address";
  try {
    await navigator.clipboard.writeText(location.href);
    byId("status").textContent = "the link is copied";
  } catch (error) { /* the address has it */ }
}

// At most 64 kB of text, which only the program reads as a case.
async function linkedCase() {
  const m = /^#case=([-\w]+)$/.exec(location.hash);
  if (!m) return null;
  try {
    const bytes = bytesOf(m[1].replace(/-/g, "+").replace(/_/g, "/"));
    const reader = new Blob([bytes]).stream()
      .pipeThrough(new DecompressionStream("deflate")).getReader();
    const parts = [];
    for (let size = 0; ;) {
      const { done, value } = await reader.read();
      if (done) break;
      size += value.length;
      if (size > 65536) throw new Error("longer than a case");
      parts.push(value);
    }
    return await new Blob(parts).text();
  } catch (error) {
    notice = "the link contains no case: " + error.message;
    return null;
  }
}

// ---------------------------------------------------------------- beginning

const KINDS = ["roller", "discs", "hot", "gear", "cam", "bearing", "starved",
  "indented", "coated", "numbers", "strip"];
const kinds = {}, helpOf = {}; // text of each; what its help has of it

// What is written here has a name of the page's own.
async function readKinds() {
  const help = (await live.call(["init", "--help"])).out;
  for (const m of help.matchAll(/^ {2}(\w+) +(\w.*?)( \(default\))?$/gm))
    helpOf[m[1]] = m[2];
  for (const kind of KINDS) {
    kinds[kind] = (await live.call(["init", kind])).out.split("\n")
      .filter((line) => !/^file = .*\.h5/.test(line) &&
        !/^# overroll check THIS/.test(line)).join("\n");
    noteUnits(kinds[kind]);
  }
}

function startFrom(kind) {
  byId("text").value = kinds[kind];
  chosen = null;
  changeCase();
}

function connectPage() {
  const list = byId("kind");
  for (const kind of KINDS) {
    const option = element(list, "option");
    option.value = kind;
    option.textContent = kind + (helpOf[kind] ? ": " + helpOf[kind] : "");
  }
  list.onchange = () => startFrom(list.value);
  byId("run").onclick = runInTime;
  byId("pause").onclick = pause;
  byId("stop").onclick = stop;
  byId("solve").onclick = () => follow(true);
  byId("link").onclick = copyLink;
  byId("pass").onchange = (e) => play(e.target.value);
  byId("back").onclick = () => showPlayer(false);
  byId("keep").onclick = () => {
    kept = kept ? null : shown;
    byId("keep").textContent = kept ? "forget the reference"
      : "keep as reference";
    if (shown) {
      showRun(shown.run);
      showNumbers(shown.numbers);
    }
  };
  byId("download").onchange = (e) => download(e.target.value);
  byId("vary").onclick = vary;
  byId("which").onchange = fillStudy;
  byId("zoom").onchange = (e) => { state.zoom = e.target.value; redraw(); };
  byId("units").onchange = (e) => {
    state.units = e.target.selectedIndex;
    redraw();
  };
  byId("text").oninput = () => changeCase(true);
  byId("text").onscroll = () => {
    byId("lines").scrollTop = byId("text").scrollTop;
  };
  for (const kind of ["pointermove", "pointerdown"])
    byId("plot").addEventListener(kind, (event) => {
      if (!view || !view.layout) return;
      const { upper, w } = view.layout;
      const x = event.clientX - byId("plot").getBoundingClientRect().left;
      const at = w.x0 + (x - upper.x) / upper.w * (w.x1 - w.x0);
      state.pointed = at >= w.x0 && at <= w.x1 ? { x: at } : null;
      redraw();
    });
  byId("plot").addEventListener("pointerleave", () => {
    state.pointed = null;
    redraw();
  });
  byId("file").onchange = async (e) => {
    for (const file of e.target.files) await takeFile(file);
  };
  document.addEventListener("dragover", (e) => {
    e.preventDefault();
    document.body.classList.add("over");
  });
  document.addEventListener("dragleave", () =>
    document.body.classList.remove("over"));
  document.addEventListener("drop", async (e) => {
    e.preventDefault();
    document.body.classList.remove("over");
    for (const file of e.dataTransfer.files) await takeFile(file);
  });
  const again = () => { readColours(); redraw(); drawStudy(); };
  window.addEventListener("resize", again);
  window.matchMedia("(prefers-color-scheme: dark)")
    .addEventListener("change", again);
  window.addEventListener("hashchange", async () => {
    const text = await linkedCase();
    if (text === null) {
      showTrouble("");
      return;
    }
    byId("text").value = text;
    changeCase();
  });
}

async function begin() {
  await unpack();
  live = new Program();
  marcher = new Program();
  table = JSON.parse((await live.call(["keys"])).out);
  byId("version").textContent = "overroll " + table.version + ".";
  await measurePace();
  await readKinds();
  readColours();
  connectPage();
  const given = JSON.parse(byId("given").textContent);
  const linked = await linkedCase() ?? (given && given.case);
  if (given && given.page) {
    result = { h5: null, html: given.page };
    byId("player").srcdoc = given.page;
    showPlayer(true);
  }
  if (linked) {
    byId("text").value = linked;
    chosen = null;
    changeCase();
  } else {
    const trouble = notice;
    startFrom(KINDS[0]);
    notice = trouble;
  }
  // For the console: overroll(["help", "units"]).then(...).
  window.overroll = (args, more) => live.call(args, more);
  document.body.dataset.ready = "1";
}

begin().catch((error) => {
  byId("status").textContent = "";
  byId("trouble").hidden = false;
  byId("trouble").textContent = "This page cannot begin: " + error.message;
  throw error;
});
