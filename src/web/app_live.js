/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The steady contact, solved again whenever the case changes, and what is drawn
 * of it and of a run under way: by the functions that draw stored runs.
 */
let live = null;            // Program
let shown = null;           // { run, numbers }
let kept = null;            // the same, of the reference
let view = null;

// A state as the functions of page_draw.js want a run: one snapshot.
function runOfState(s, scales) {
  const run = { x: s.X, nodes: s.X.length, shots: 1, time: [s.T], history: {},
    hertz: [s.b, s.p], made: { units: unitsFrom(scales) } };
  for (const name of ["P", "H", "S", "F", "T1", "T2", "T3", "C"]) {
    const values = s[name];
    if (!values || name === "S" && values.every((v) => v === 0)) continue;
    run[name] = { step: 0, at: (k, i) => values[i],
      value: [values.reduce((a, b) => Math.min(a, b)),
        values.reduce((a, b) => Math.max(a, b))] };
  }
  return run;
}

const one = (name) => ({ f: 1, unit: "", name });
const inUnit = (f, unit, name) => ({ f, unit, name: `${name} (${unit})` });
function unitsFrom(c) {
  const units = [{ x: one("position, x (b)"), p: one("pressure, p (p_h)"),
    h: one("film thickness, h (b\u00b2/R)"), t: one("time, t (b/u_m)") }];
  if (c && c.half_width_m && c.film_scale_m)
    units.push({ x: inUnit(1e3 * c.half_width_m, "mm", "position, x"),
      p: inUnit(1e-9 * c.hertz_pressure_Pa, "GPa", "pressure, p"),
      h: inUnit(1e6 * c.film_scale_m, "\u00b5m", "film thickness, h"),
      t: inUnit(1e3 * c.time_scale_s, "ms", "time, t") });
  return units;
}

function showRun(run) {
  runs = [run];
  ranges = findRanges();
  const list = byId("units"), most = run.made.units.length;
  if (list.options.length !== most) {
    list.replaceChildren();
    for (let k = 0; k < most; k++)
      element(list, "option").textContent = k ? "SI" : "Hertzian";
    list.selectedIndex = most - 1;
  }
  state.units = list.selectedIndex;
  byId("heat").hidden = !isWarm(run);
  view = { run, plot: byId("plot"), heat: isWarm(run) ? byId("heat") : null,
    values: byId("values"), behind: kept && kept.run };
  redraw();
}

let asked = false;
function redraw() {
  if (asked || !view) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    if (!view.plot.clientWidth) return; // the player is shown
    drawRun(view);
    drawHeat(view);
    const run = view.run, u = unitsOf(run);
    view.values.textContent = "";
    if (state.pointed) {
      const i = nodeAt(run, state.pointed.x);
      const text = (v, q) => digits(v * q.f) + (q.unit ? " " + q.unit : "");
      view.values.textContent = ["x = " + text(run.x[i], u.x),
        "p = " + text(run.P.at(0, i), u.p), "h = " + text(run.H.at(0, i), u.h)]
        .concat(run.S ? ["roughness " + text(run.S.at(0, i), u.h)] : [],
          isWarm(run) ? [saidHeat(run, 0, i)] : []).join("   ");
    }
    drawMoes();
    document.body.dataset.drawn = Number(document.body.dataset.drawn || 0) + 1;
  });
}

// ------------------------------------------------------------- the numbers

// Name, key in SI, its factor and unit, key of the same in Hertzian units.
const ROWS = [
  ["central film thickness", "central_film_m", 1e6, "\u00b5m", "H_cen"],
  ["minimum film thickness", "min_film_located_m", 1e6, "\u00b5m", "H_min_located"],
  ["maximum pressure", "max_pressure_Pa", 1e-9, "GPa", "P_max"],
  ["maximum Hertzian pressure", "hertz_pressure_Pa", 1e-9, "GPa"],
  ["Hertzian half-width b", "half_width_m", 1e3, "mm"],
  ["lambda ratio", "lambda_ratio", 1, ""],
  ["asperity load share", "contact_share", 1, ""],
  ["sliding friction coefficient", "mu_slide", 1, ""],
  ["rolling friction coefficient", "mu_roll", 1, ""],
  ["friction force on surface 1", "F_1_N_per_m", 1, "N/m"],
  ["maximum film temperature rise", "T_max_rise", 1, "K"],
  ["starvation factor", "film_ratio", 1, ""],
  ["Moes' load number M", "M", 1, ""],
  ["Moes' lubricant number L", "L", 1, ""]];

// The value of a row and its unit; null: the contact has none.
function valueOfRow(row, n) {
  const [, key, f, unit, bare] = row;
  if (typeof n[key] === "number")
    return [Math.abs(n[key]) < 1e-14 ? 0 : n[key] * f, unit];
  return bare && typeof n[bare] === "number" ? [n[bare], ""] : null;
}

function showNumbers(n) {
  const list = byId("numbers");
  list.replaceChildren();
  for (const row of ROWS) {
    const value = valueOfRow(row, n);
    if (!value) continue;
    element(list, "dt").textContent = row[0];
    const cell = element(list, "dd");
    cell.textContent = digits(value[0]) + (value[1] ? " " + value[1] : "");
    cell.dataset.key = row[1];
    const before = kept && valueOfRow(row, kept.numbers);
    element(list, "dd").textContent = before && before[0] &&
      before[1] === value[1]
      ? (value[0] >= before[0] ? "+" : "\u2212") +
        digits(Math.abs(100 * (value[0] / before[0] - 1))) + " %" : "";
  }
  byId("numbers").dataset.solved =
    Number(byId("numbers").dataset.solved || 0) + 1;
}

const LEFT_OUT =
  /(is (?:left out of|held .* in) a steady solution); .*$/;
function showNotes(lines, inTime) {
  const notes = byId("notes");
  notes.replaceChildren();
  for (const line of lines) {
    const warning = line.startsWith("warning: ");
    element(notes, "li", warning ? "warning" : "").textContent =
      (warning ? line.slice(9) : line).replace(LEFT_OUT,
        inTime ? "$1; press run in time" : "$&");
  }
}

// Moes's chart of the central film: curves of his formula for values of L, and
// the contact as it was solved; H sqrt(U) = h/R = (8/pi) M sqrt(U) (h R/b^2).
function moesFilm(M, L) {
  const ri = 2.45 / M, ei = 2.05 * M ** -0.2, rp = 1.05 * L ** (2 / 3);
  const ep = 1.31 * M ** -0.125 * L ** 0.75;
  const s = (7 + 8 * Math.exp(-2 * ei / ri)) / 5;
  return ((ri ** (7 / 3) + ei ** (7 / 3)) ** (3 * s / 7) +
    (rp ** -3.5 + ep ** -3.5) ** (-2 * s / 7)) ** (1 / s);
}

function drawMoes() {
  const n = shown && shown.numbers;
  if (!n || !n.M || !(n.L >= 0) || !n.H_cen ||
      !byId("moes").clientWidth) return;
  const { c, width, height } = prepare(byId("moes"));
  const lg = Math.log10, at = [n].concat(kept ? [kept.numbers] : [])
    .filter((one_) => one_.M && one_.H_cen)
    .map((one_) => [lg(one_.M), lg(8 / Math.PI * one_.M * one_.H_cen)]);
  const axes = { x0: Math.min(0, ...at.map((p) => p[0] - 0.2)),
    x1: Math.max(3, ...at.map((p) => p[0] + 0.2)),
    y0: Math.min(-0.5, ...at.map((p) => p[1] - 0.2)),
    y1: Math.max(1.6, ...at.map((p) => p[1] + 0.2)),
    xName: "log10 M", yName: "log10 of Moes' film number" };
  axes.from = axes.y0;
  const box = boxOf(58, 22, width - 68, height - 64, axes);
  drawAxes(c, box, axes);
  clipped(c, box, () => {
    for (const L of [0, 2.5, 5, 10, 20, 40]) {
      c.beginPath();
      for (let k = 0; k <= 60; k++) {
        const x = axes.x0 + (axes.x1 - axes.x0) * k / 60;
        c.lineTo(box.X(x), box.Y(lg(moesFilm(10 ** x, Math.max(L, 1e-6)))));
      }
      c.strokeStyle = colour.hertz;
      c.lineWidth = 1;
      c.stroke();
      c.fillStyle = colour.faint;
      c.textAlign = "right";
      c.textBaseline = "bottom";
      c.fillText("L = " + L, box.x + box.w - 4, box.Y(lg(moesFilm(10 **
        (axes.x1 - 0.2), Math.max(L, 1e-6)))) - 1);
    }
    at.forEach(([x, y], k) => {
      c.fillStyle = k ? colour.rough : colour.min;
      c.beginPath();
      c.arc(box.X(x), box.Y(y), 5, 0, 7);
      c.fill();
    });
  });
  drawLegend(c, box, [["central film thickness by Moes' formula; dot: this contact",
    colour.hertz, false, "Moes' formula; dot: here"]]);
}

// ---------------------------------------------------------------- solving

let wanted = false, busy = false, heavy = false;
// How much slower this machine is than the one that the program's own estimates
// were made for, compiled natively: measured once.
let slower = 6;
const NATIVE = 0.0019; // s, of the contact below
async function measurePace() {
  for (let k = 0; k < 3; k++) {
    const answer = await live.call(["solve", "pace.ini", "--steady", "--json"],
      { files: { "pace.ini": "[contact]\nM = 20\nL = 10\n[domain]\n" +
        "level = 7\n" } });
    if (answer.out)
      slower = Math.max(3, JSON.parse(answer.out).seconds / NATIVE);
  }
}

const HEAVY = 2; // s: such a steady contact is not solved at every change
const LONG = 60; // s: such a run, study or contact is asked for

function clock(seconds) {
  const s = Math.round(seconds);
  return s < 60 ? Math.max(s, 1) + " s" : s < 7200
    ? Math.floor(s / 60) + " min " + s % 60 + " s"
    : digits(Math.round(s / 360) / 10) + " h";
}

function ask(text) {
  const box = byId("ask");
  box.firstElementChild.textContent = text;
  box.hidden = false;
  byId("yes").focus();
  return new Promise((resolve) => {
    const end = (answer) => () => { box.hidden = true; resolve(answer); };
    byId("yes").onclick = end(true);
    byId("no").onclick = end(false);
  });
}

const mayTake = async (seconds, what) => !(seconds > LONG) ||
  ask(what + " takes about " + clock(seconds) + " here.");

// What takes longer than a second can be stopped, whatever it is.
let watched = 0;
async function watch(work) {
  const show = setTimeout(() => { byId("stop").hidden = false; }, 1000);
  watched++;
  try {
    return await work();
  } finally {
    clearTimeout(show);
    watched--;
    byId("stop").hidden = !marching && !watched;
  }
}

async function check() {
  const text = textOfCase();
  const files = { "case.ini": text };
  const given = await live.call(["entries", "case.ini"], { files });
  if (given.ended) return null;
  if (text !== textOfCase()) return null;
  if (given.code === 0) entries = JSON.parse(given.out).entries;
  const answer = given.code ? given
    : await live.call(["check", "case.ini", "--json"], { files });
  if (answer.ended || text !== textOfCase()) return null;
  drawTabs();
  if (!byId("form").contains(document.activeElement)) drawForm();
  if (answer.code) {
    const lines = said(answer);
    showTrouble(lines.find((l) => /^case\.ini:/.test(l)) ||
      lines[lines.length - 1] || "the program ended");
    byId("run").disabled = true;
    byId("live").classList.add("stale"); // of the last case that was right
    return null;
  }
  showTrouble("");
  byId("live").classList.remove("stale");
  const about = JSON.parse(answer.out);
  about.notes = said(answer);
  about.seconds = slower * (about.estimated_seconds || 0);
  about.runs = about.transient || about.passes > 1;
  byId("run").disabled = !about.runs || marching;
  byId("run").title = about.runs ? "" : "set time.end (section time): this " +
    "case is steady";
  return about;
}

async function solveSteady(about) {
  const text = textOfCase();
  let last = null;
  const answer = await live.call(["solve", "case.ini", "--steady", "--json"],
    { files: { "case.ini": text }, state: (s) => { last = s; } });
  if (answer.ended) return;
  if (!last || !answer.out) {
    showTrouble(said(answer).pop() || "no solution");
    return;
  }
  const numbers = JSON.parse(answer.out);
  shown = { run: runOfState(last, numbers), numbers, text };
  if (marching) return;
  showRun(shown.run);
  showNumbers(numbers);
  showNotes([...new Set([...about.notes, ...said(answer)])], about.transient);
}

// The newest case counts: what comes while one is solved waits, and of those
// that wait the last alone is solved.
let halted = false, forced = false, steadySeconds = 0;
async function follow(force) {
  wanted = true;
  forced = forced || force;
  if (busy) return;
  busy = true;
  await watch(async () => {
    while (wanted) {
      wanted = halted = false;
      byId("status").textContent = "solving";
      const about = await check();
      const now = forced;
      forced = false;
      if (about) {
        steadySeconds = about.runs ? slower * about.nodes * 2e-5
          : about.seconds;
        heavy = steadySeconds > HEAVY;
        byId("solve").hidden = !heavy;
        if (!heavy || now && await mayTake(steadySeconds, "This contact"))
          await solveSteady(about);
        else if (now) halted = true;
      }
      byId("status").textContent = halted ? "stopped" : !about ? "ready"
        : heavy && !now ? "press solve: about " + clock(steadySeconds)
        : "ready";
    }
  });
  busy = false;
}

let pause_ = 0;
function changeCase(later) {
  notice = "";
  drawLines(0);
  drawTabs();
  if (!later) drawForm();
  if (!sliding) drawSliders();
  clearTimeout(pause_);
  pause_ = setTimeout(() => follow(false), later ? 350 : 0);
}

// ---------------------------------------------------------------- sliders

const SLIDING = ["contact", "lubricant", "heat", "gear", "cam",
  "roller_bearing", "supply", "contact_law"];
const SLIDERS = 30; // at most
let sliding = false;

function slidingKeys() {
  return parseCase(textOfCase()).filter((p) => p.key &&
    SLIDING.includes(p.head) && measured(p.value) &&
    table.keys.some((k) => k.section === p.head && k.key === p.key &&
      k.type === "number" && !k.choices.length));
}

function drawSliders() {
  const box = byId("sliders"), which = byId("which"), before = which.value;
  box.replaceChildren();
  which.replaceChildren();
  for (const p of slidingKeys().slice(0, SLIDERS)) {
    const option = element(which, "option");
    option.value = option.textContent = p.head + "." + p.key;
    const m = measured(p.value), row = element(box, "label", "slider");
    const key = table.keys.find((k) => k.section === p.head && k.key === p.key);
    element(row, "span").textContent = p.key;
    const range = element(row, "input"), out = element(row, "output");
    range.type = "range";
    range.dataset.key = p.head + "." + p.key;
    // Fourfold to either side; what may be zero or less moves evenly.
    const even = m.number <= 0 || key.minimum < 0;
    const reach = Math.abs(m.number) || 1;
    range.min = even ? m.number - 2 * reach : -1;
    range.max = even ? m.number + 2 * reach : 1;
    range.step = even ? reach / 50 : 0.01;
    range.value = even ? m.number : 0;
    const tell = (v) => {
      out.textContent = digits(v) + (m.unit ? " " + m.unit : "");
    };
    tell(m.number);
    range.oninput = () => {
      const v = even ? Number(range.value) : m.number * 4 ** Number(range.value);
      const text = String(Number(v.toPrecision(4)));
      sliding = true;
      setValue(p.head, p.key, text + (m.unit ? " " + m.unit : ""));
      tell(Number(text));
      changeCase();
      sliding = false;
    };
  }
  if ([...which.options].some((o) => o.value === before)) which.value = before;
  byId("study").hidden = !which.options.length;
  fillStudy();
}

// -------------------------------------------------------------- one key

function fillStudy() {
  const [where, key] = byId("which").value.split(".");
  const m = key && measured(valueOf(where, key));
  if (!m) return;
  const unit = m.unit ? " " + m.unit : "";
  byId("from").value = Number((m.number / 2).toPrecision(3)) + unit;
  byId("to").value = Number((m.number * 2).toPrecision(3)) + unit;
}

let curve = null;
async function studyPoints(name, a, b, n) {
  const text = textOfCase(), points = [], even = a.number * b.number <= 0;
  for (let k = 0; k < n && !halted; k++) {
    const part = k / (n - 1);
    const v = even ? a.number + (b.number - a.number) * part
      : a.number * (b.number / a.number) ** part;
    byId("status").textContent = "value " + (k + 1) + " of " + n;
    const answer = await live.call(["solve", "case.ini", "--steady", "--json",
      "--set", name + "=" + v + (a.unit ? " " + a.unit : "")],
      { files: { "case.ini": text } });
    const numbers = answer.out && JSON.parse(answer.out);
    if (numbers && numbers.converged) points.push([v, numbers]);
    if (!numbers && !answer.ended)
      showTrouble(name + " = " + digits(v) + ": " + (said(answer).pop() || ""));
  }
  return points;
}

async function vary() {
  const name = byId("which").value;
  const a = measured(byId("from").value), b = measured(byId("to").value);
  const n = Math.max(2, Math.min(20, Number(byId("count").value) || 2));
  if (!a || !b || a.unit !== b.unit) {
    showTrouble("one key, several values: from and to must be numbers with " +
      "the same unit");
    return;
  }
  if (!await mayTake(n * steadySeconds, "This study")) return;
  byId("vary").disabled = true;
  halted = false;
  const points = await watch(() => studyPoints(name, a, b, n));
  byId("vary").disabled = false;
  byId("status").textContent = halted ? "stopped" : "ready";
  curve = { key: name.split(".")[1], unit: a.unit, points };
  drawStudy();
}

function drawStudy() {
  if (!curve || curve.points.length < 2 || !byId("study").open) return;
  const canvas = byId("curve");
  canvas.hidden = false;
  if (!canvas.clientWidth) return; // the player is shown
  canvas.dataset.points = curve.points.length;
  const { c, width, height } = prepare(canvas);
  const si = curve.points.every(([, n]) => typeof n.central_film_m === "number");
  const films = si ? [["central_film_m", colour.film], ["min_film_located_m", colour.min]]
    : [["H_cen", colour.film], ["H_min_located", colour.min]];
  const f = si ? 1e6 : 1, x = curve.points.map((p) => p[0]);
  const most = Math.max(...curve.points.map(([, n]) => n[films[0][0]] * f));
  const axes = { x0: Math.min(...x), x1: Math.max(...x), y0: 0, y1: 1.1 * most,
    xName: curve.key + (curve.unit ? ` (${curve.unit})` : ""),
    yName: `film thickness, h (${si ? "\u00b5m" : "b\u00b2/R"})` };
  const box = boxOf(58, 22, width - 72, height - 64, axes);
  drawAxes(c, box, axes);
  for (const [name, line] of films) {
    c.beginPath();
    for (const [v, n] of curve.points) c.lineTo(box.X(v), box.Y(n[name] * f));
    c.strokeStyle = line;
    c.lineWidth = 2;
    c.stroke();
    c.fillStyle = line;
    for (const [v, n] of curve.points) {
      c.beginPath();
      c.arc(box.X(v), box.Y(n[name] * f), 3, 0, 7);
      c.fill();
    }
  }
  drawLegend(c, box, [["central film thickness", colour.film],
    ["minimum film thickness", colour.min]]);
}
