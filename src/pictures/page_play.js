/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The readout and the controls of the page, and its beginning. */
const written = (v, q) => digits(v * q.f) + (q.unit ? " " + q.unit : "");

// What is less than a level is nothing but rounding.
function valueAt(field, k, i) {
  const v = field.at(k, i);
  return Math.abs(v) < field.step ? 0 : v;
}

function showTime() {
  const run = runs[0], T = run.time[state.shot], physical = unitsOf(run).t.unit;
  // Two runs at the same T have other times where their scales differ.
  const texts = runs.map((r) => unitsOf(r).t).map((q) =>
    q.unit ? (T * q.f).toFixed(4) + " " + q.unit : T.toFixed(4));
  const t = [...new Set(texts)].join(" | ");
  byId("time").textContent = (physical ? "t = " : "T = ") + t +
    "  (" + (state.shot + 1) + " of " + run.shots + ")";
  byId("scrub").value = state.shot;
  byId("scrub").setAttribute("aria-valuetext", "t = " + t);
}

function showValues(view) {
  const run = view.run, u = unitsOf(run), k = shotOf(run);
  if (!state.pointed) {
    view.values.textContent = "";
    return;
  }
  const i = nodeAt(run, state.pointed.x);
  const parts = ["x = " + written(run.x[i], u.x)];
  if (run.P) parts.push("p = " + written(valueAt(run.P, k, i), u.p));
  if (run.H) parts.push("h = " + written(valueAt(run.H, k, i), u.h));
  if (run.S) parts.push("roughness " + written(valueAt(run.S, k, i), u.h));
  if (isWarm(run)) parts.push(saidHeat(run, k, i));
  view.values.textContent = parts.join("   ");
  view.values.dataset.node = i;
}

let asked = false;
function redraw() {
  if (asked) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    showTime();
    for (const view of views) {
      drawRun(view);
      drawHeat(view);
      drawAreal(view);
      drawStress(view);
      drawElement(view);
      drawHistory(view);
      showValues(view);
    }
    document.body.dataset.drawn = state.shot;
  });
}

// ------------------------------------------------------------ the controls

function seek(k) {
  state.shot = Math.max(0, Math.min(runs[0].shots - 1, Math.round(k)));
  redraw();
}

let position = 0, clock = 0;
const perSecond = () => Math.max(5, runs[0].shots / 15) * state.speed;

function tick(now) {
  if (!state.playing) return;
  const last = runs[0].shots - 1;
  position += Math.min(now - clock, 250) / 1000 * perSecond();
  clock = now;
  if (position > last && state.loop) position = 0;
  if (position > last) {
    position = last;
    play(false);
  }
  if (Math.floor(position) !== state.shot) seek(Math.floor(position));
  requestAnimationFrame(tick);
}

function play(on) {
  state.playing = on;
  byId("play").textContent = on ? "❚❚ pause" : "▶ play";
  if (!on) return;
  position = state.shot >= runs[0].shots - 1 ? 0 : state.shot;
  clock = performance.now();
  requestAnimationFrame(tick);
}

function step(by) {
  play(false);
  seek(state.shot + by);
}

function choose(id, by) {
  const list = byId(id), n = list.options.length;
  list.selectedIndex = id === "speed"
    ? Math.max(0, Math.min(n - 1, list.selectedIndex + by))
    : (list.selectedIndex + by + n) % n;
  list.dispatchEvent(new Event("change"));
}

const keys = {
  " ": () => play(!state.playing),
  ArrowLeft: (e) => step(e.shiftKey ? -10 : -1),
  ArrowRight: (e) => step(e.shiftKey ? 10 : 1),
  Home: () => step(-Infinity),
  End: () => step(Infinity),
  "+": () => choose("speed", 1),
  "-": () => choose("speed", -1),
  z: () => choose("zoom", 1),
  u: () => choose("units", 1),
  l: () => byId("loop").click(),
  d: () => choose("depth", 1),
  f: () => choose("below", 1),
};

function onKey(event) {
  const tag = event.target.tagName;
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  if (tag === "SELECT" || tag === "BUTTON" && event.key === " ") return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (!keys[key]) return;
  keys[key](event);
  event.preventDefault();
}

function onPoint(view, event) {
  const { u, upper, w } = view.layout;
  const x = event.clientX - view.plot.getBoundingClientRect().left;
  const at = w.x0 + (x - upper.x) / upper.w * (w.x1 - w.x0);
  state.pointed = at >= w.x0 && at <= w.x1 ? { x: at } : null;
  redraw();
}

function onStrip(view, event) {
  if (event.type === "pointermove" && !(event.buttons & 1)) return;
  const { box, begin, end } = view.strip, run = runs[0];
  const x = event.clientX - view.history.getBoundingClientRect().left;
  const T = begin + (x - box.x) / box.w * (end - begin);
  let best = 0;
  for (let k = 1; k < run.shots; k++)
    if (Math.abs(run.time[k] - T) < Math.abs(run.time[best] - T)) best = k;
  play(false);
  seek(best);
}

function element(parent, name, kind) {
  const e = document.createElement(name);
  if (kind) e.className = kind;
  parent.appendChild(e);
  return e;
}

// What a gear pair, cam or bearing answers; nothing of another contact.
function tellAnswers(section, answers) {
  if (!answers.length) return;
  const list = element(section, "dl", "answers");
  for (const answer of answers) {
    element(list, "dt").textContent = answer.name;
    element(list, "dd").textContent = answer.text;
  }
}

function viewOf(run, number) {
  const section = element(byId("runs"), "section");
  const view = { run };
  if (runs.length > 1 || run.made.about) {
    const head = element(section, "h2");
    head.textContent = runs.length > 1 ? run.made.name + " " : "";
    const about = element(head, "span");
    run.made.about.split("p_h").forEach((part, k) => {
      if (k) {
        about.append("p");
        element(about, "sub").textContent = "h";
      }
      about.append(part);
    });
  }
  tellAnswers(section, run.made.answers.slice(0, -1));
  view.plot = element(section, "canvas", "plot");
  view.plot.setAttribute("role", "img");
  view.plot.setAttribute("aria-label", "pressure and film against x");
  if (isWarm(run)) {
    view.heat = element(section, "canvas", "heat");
    view.heat.setAttribute("role", "img");
    view.heat.setAttribute("aria-label", "temperatures against x");
  }
  if (run.stress && run.material && !byId("below").options.length) {
    for (const name of [run.stress.name.replace(/_/g, " "),
      ...run.material.fields.map((field) => field.name)]) {
      const option = element(byId("below"), "option");
      option.value = byId("below").options.length - 1;
      option.textContent = name;
    }
    byId("belows").hidden = false;
  }
  if (run.stress) {
    view.stress = element(section, "canvas", "stress");
    view.stress.setAttribute("role", "img");
    view.stress.setAttribute("aria-label", "stress below the film");
    view.stress.addEventListener("pointermove", (e) => onStress(view, e));
    view.stress.addEventListener("pointerdown", (e) => onStress(view, e));
    byId("depths").hidden = false;
  }
  addAreal(view, section);
  view.values = element(section, "output");
  view.values.id = "values" + number;
  view.history = element(section, "canvas", "history");
  view.history.setAttribute("role", "img");
  view.history.setAttribute("aria-label", "history of film and pressure");
  if (run.element) {
    view.element = element(section, "canvas", "element");
    view.element.setAttribute("role", "img");
    view.element.setAttribute("aria-label",
      "the element to scale, and what its contact goes through");
  }
  for (const canvas of view.heat ? [view.plot, view.heat] : [view.plot]) {
    canvas.addEventListener("pointermove", (e) => onPoint(view, e));
    canvas.addEventListener("pointerdown", (e) => onPoint(view, e));
    canvas.addEventListener("pointerleave", (e) => {
      if (e.pointerType === "mouse") state.pointed = null;
      redraw();
    });
  }
  view.history.addEventListener("pointerdown", (e) => onStrip(view, e));
  view.history.addEventListener("pointermove", (e) => onStrip(view, e));
  return view;
}

function connect() {
  // One run without scales makes both Hertzian.
  const most = Math.min(...runs.map((run) => run.made.units.length));
  for (let k = 0; k < most; k++) {
    const option = element(byId("units"), "option");
    option.value = k;
    option.textContent = k ? "SI" : "Hertzian";
  }
  state.units = most - 1;
  byId("units").selectedIndex = state.units;
  byId("scrub").max = runs[0].shots - 1;
  byId("scrub").addEventListener("input", (e) => {
    play(false);
    seek(Number(e.target.value));
  });
  byId("play").onclick = () => play(!state.playing);
  byId("first").onclick = () => step(-Infinity);
  byId("back").onclick = () => step(-1);
  byId("next").onclick = () => step(1);
  byId("last").onclick = () => step(Infinity);
  byId("loop").onchange = (e) => { state.loop = e.target.checked; };
  byId("speed").onchange = (e) => { state.speed = Number(e.target.value); };
  byId("depth").onchange = (e) => { state.depth = e.target.value; redraw(); };
  byId("below").onchange = (e) => {
    state.below = Number(e.target.value);
    redraw();
  };
  byId("zoom").onchange = (e) => { state.zoom = e.target.value; redraw(); };
  byId("units").onchange = (e) => {
    state.units = Number(e.target.value);
    redraw();
  };
  document.addEventListener("keydown", onKey);
  window.addEventListener("resize", redraw);
  window.matchMedia("(prefers-color-scheme: dark)")
    .addEventListener("change", () => { readColours(); redraw(); });
}

// The page opens at the time of the minimum film thickness.
function shotOfMinimum(run) {
  const h = run.history;
  let at = 0, shot = 0;
  if (!h || !h.H_min || !h.H_min.length) return 0;
  for (let i = 1; i < h.H_min.length; i++)
    if (!(h.H_min[at] <= h.H_min[i])) at = i;
  for (let k = 1; k < run.shots; k++)
    if (Math.abs(run.time[k] - h.time[at]) <
        Math.abs(run.time[shot] - h.time[at])) shot = k;
  return shot;
}

async function begin() {
  const made = JSON.parse(byId("data").textContent);
  runs = await Promise.all(made.runs.map(runOf));
  ranges = findRanges();
  if (runs.length > 1) byId("runs").classList.add("two");
  if (runs.some((run) => isWarm(run) || run.stress || run.areal))
    byId("runs").classList.add("more");
  byId("precision").textContent = made.precision;
  views = runs.map(viewOf);
  connect();
  readColours();
  seek(shotOfMinimum(runs[0]));
}

begin().catch((error) => {
  byId("trouble").hidden = false;
  byId("trouble").textContent =
    "This page cannot show its data: " + error.message;
  throw error;
});
