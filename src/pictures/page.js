/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plays a run.  In order: the data (base64, inflate, differences), what the
 * page knows, drawing, the readout, the controls.
 *
 * All numbers inside are Hertzian; units are applied where something is
 * written.
 */
"use strict";
(function () {

// ---------------------------------------------------------------- the data

function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// Inflate (RFC 1951) of a zlib stream into `size` bytes: own code, so that
// the page needs nothing of its browser.
const LENGTHS = [], DISTANCES = [];
(function () {
  let length = 3, distance = 1;
  for (let k = 0; k < 28; k++) {
    const extra = k < 8 ? 0 : (k >> 2) - 1;
    LENGTHS.push([length, extra]);
    length += 1 << extra;
  }
  LENGTHS.push([258, 0]);
  for (let k = 0; k < 30; k++) {
    const extra = k < 4 ? 0 : (k >> 1) - 1;
    DISTANCES.push([distance, extra]);
    distance += 1 << extra;
  }
})();
const ORDER = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1,
  15];

// Canonical code: a table over 15 bits, code length in the low 4 bits.
function tableOf(lengths) {
  const count = new Uint16Array(16), next = new Uint16Array(16);
  const table = new Uint16Array(1 << 15);
  for (const n of lengths) if (n) count[n]++;
  for (let n = 1; n < 16; n++) next[n] = (next[n - 1] + count[n - 1]) << 1;
  lengths.forEach((n, symbol) => {
    if (!n) return;
    let code = next[n]++, turned = 0;
    for (let b = 0; b < n; b++, code >>= 1) turned = turned << 1 | code & 1;
    for (let k = turned; k < 1 << 15; k += 1 << n) table[k] = symbol << 4 | n;
  });
  return table;
}

function inflate(from, size) {
  const to = new Uint8Array(size);
  let at = 2, held = 0, bits = 0, out = 0;
  function need(n) {
    while (bits < n) {
      held |= (at < from.length ? from[at] : 0) << bits;
      at++;
      bits += 8;
    }
  }
  function take(n) {
    if (!n) return 0;
    need(n);
    const value = held & ((1 << n) - 1);
    held >>>= n;
    bits -= n;
    return value;
  }
  function symbol(table) {
    need(15);
    const entry = table[held & 0x7fff], n = entry & 15;
    if (!n) throw new Error("damaged data");
    held >>>= n;
    bits -= n;
    return entry >> 4;
  }
  function dynamic() {
    const literals = take(5) + 257, distances = take(5) + 1;
    const given = take(4) + 4;
    const first = new Array(19).fill(0), lengths = [];
    for (let k = 0; k < given; k++) first[ORDER[k]] = take(3);
    const table = tableOf(first);
    while (lengths.length < literals + distances) {
      const s = symbol(table);
      if (s < 16) lengths.push(s);
      else {
        const value = s === 16 ? lengths[lengths.length - 1] : 0;
        let n = s === 16 ? 3 + take(2) : s === 17 ? 3 + take(3) : 11 + take(7);
        while (n--) lengths.push(value);
      }
    }
    return [tableOf(lengths.slice(0, literals)),
      tableOf(lengths.slice(literals))];
  }
  function fixed() {
    const lengths = [];
    for (let k = 0; k < 288; k++)
      lengths.push(k < 144 ? 8 : k < 256 ? 9 : k < 280 ? 7 : 8);
    return [tableOf(lengths), tableOf(new Array(30).fill(5))];
  }
  function block(tables) {
    for (;;) {
      let s = symbol(tables[0]);
      if (s < 256) {
        to[out++] = s;
        continue;
      }
      if (s === 256) return;
      const length = LENGTHS[s - 257][0] + take(LENGTHS[s - 257][1]);
      s = symbol(tables[1]);
      const back = DISTANCES[s][0] + take(DISTANCES[s][1]);
      if (back > out || out + length > size) throw new Error("damaged data");
      for (let k = 0; k < length; k++, out++) to[out] = to[out - back];
    }
  }
  function stored() {
    // Whole bytes may have been read ahead.
    at -= bits >> 3;
    held = bits = 0;
    const n = from[at] | from[at + 1] << 8;
    at += 4;
    to.set(from.subarray(at, at + n), out);
    out += n;
    at += n;
  }
  for (let last = 0; !last;) {
    last = take(1);
    const kind = take(2);
    if (kind === 0) stored();
    else if (kind === 1) block(fixed());
    else if (kind === 2) block(dynamic());
    else throw new Error("damaged data");
  }
  if (out !== size) throw new Error("damaged data");
  return to;
}

// A field: levels, as differences from what the neighbours in x and in time
// foretell, low bytes first, then high bytes.  Level to value: a table.
function fieldOf(made, nodes, shots) {
  const n = nodes * shots, bytes = inflate(bytesOf(made.data), 2 * n);
  const level = new Uint16Array(n), value = new Float64Array(made.levels);
  for (let i = 0; i < n; i++) {
    const z = bytes[i] | bytes[n + i] << 8, d = z >> 1 ^ -(z & 1);
    const x = i % nodes, left = x ? level[i - 1] : 0;
    const before = i >= nodes ? level[i - nodes] : 0;
    const both = x && i >= nodes ? level[i - nodes - 1] : 0;
    level[i] = left + before - both + d;
  }
  for (let k = 0; k < made.levels; k++)
    value[k] = made.bend ? made.bend * Math.sinh(k * made.step)
                         : made.from + k * made.step;
  return { level, value, step: made.bend ? 0 : made.step,
    at: (k, i) => value[level[k * nodes + i]] };
}

function doublesOf(base64) {
  return new Float64Array(bytesOf(base64).buffer);
}

function runOf(made) {
  const run = { made, nodes: made.nodes, shots: made.snapshots };
  run.x = doublesOf(made.x);
  run.time = doublesOf(made.time);
  for (const name of ["P", "H", "S"])
    if (made[name]) run[name] = fieldOf(made[name], run.nodes, run.shots);
  run.history = {};
  for (const name of ["time", "H_min", "H_cen", "P_max"])
    if (made.history[name]) run.history[name] = doublesOf(made.history[name]);
  return run;
}

// ----------------------------------------------------- what the page knows

const byId = (id) => document.getElementById(id);
const state = {
  shot: 0, playing: false, speed: 1, loop: true, zoom: "contact", units: 0,
  pointed: null, // { run, x } in Hertzian units
};
let runs = [], views = [], ranges = null, colour = {};

function largest(field, run, from, to) {
  let high = 0;
  for (let i = 0; i < run.nodes; i++) {
    if (run.x[i] < from || run.x[i] > to) continue;
    for (let k = 0; k < run.shots; k++) high = Math.max(high, field.at(k, i));
  }
  return high;
}

function findRanges() {
  const r = { from: Infinity, to: -Infinity, P: 1, H: 0, low: 0, high: 0 };
  for (const run of runs) {
    r.from = Math.min(r.from, run.x[0]);
    r.to = Math.max(r.to, run.x[run.nodes - 1]);
    if (run.P) r.P = Math.max(r.P, largest(run.P, run, -9, 9));
    if (run.H) r.H = Math.max(r.H, largest(run.H, run, -0.9, 0.9));
    if (run.S) {
      r.low = Math.min(r.low, run.S.value[0]);
      r.high = Math.max(r.high, run.S.value[run.S.value.length - 1]);
    }
  }
  if (!r.H) r.H = 1;
  return r;
}

function window_() {
  const r = ranges;
  const w = { x0: r.from, x1: r.to, P: 1.1 * r.P, H: 1.6 * r.H };
  if (state.zoom === "contact") {
    w.x0 = Math.max(-1.8, r.from);
    w.x1 = Math.min(1.4, r.to);
  } else if (state.zoom === "film") {
    w.x0 = Math.max(-1.15, r.from);
    w.x1 = Math.min(1.15, r.to);
    w.H = 1.1 * r.H;
  } else if (state.zoom === "exit") {
    w.x0 = 0.5;
    w.x1 = Math.min(1.15, r.to);
    w.H = 1.1 * r.H;
  } else {
    w.H = 4 * r.H;
  }
  if (!(w.x1 > w.x0)) [w.x0, w.x1] = [r.from, r.to];
  return w;
}

const unitsOf = (run) => run.made.units[Math.min(state.units,
                                                 run.made.units.length - 1)];

// The snapshot of a run that is nearest to the time shown.
function shotOf(run) {
  if (run === runs[0]) return state.shot;
  const T = runs[0].time[state.shot];
  let low = 0, high = run.shots - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (run.time[middle] > T) high = middle; else low = middle;
  }
  return T - run.time[low] <= run.time[high] - T ? low : high;
}

// Four digits.
function digits(v) {
  const size = Math.abs(v);
  const text = size === 0 ? "0"
    : size >= 1e5 || size < 1e-4 ? v.toExponential(3)
    : Number(v.toPrecision(4)).toString();
  return text.replace("-", "\u2212");
}

// ----------------------------------------------------------------- drawing

function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["page", "ink", "faint", "rule", "grid", "accent",
    "pressure", "pressure-area", "film", "film-area", "rough", "rough-area",
    "hertz", "min", "tip"])
    colour[name] = style.getPropertyValue("--" + name).trim();
}

// A canvas made as sharp as the screen; its context in CSS pixels.
function prepare(canvas) {
  const sharp = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  const w = Math.round(width * sharp), h = Math.round(height * sharp);
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
  }
  const c = canvas.getContext("2d");
  c.setTransform(sharp, 0, 0, sharp, 0, 0);
  c.clearRect(0, 0, width, height);
  c.font = "12px " + getComputedStyle(document.body).fontFamily;
  c.lineJoin = "round";
  return { c, width, height };
}

function niceStep(span, most) {
  const least = span / most, power = 10 ** Math.floor(Math.log10(least));
  const digit = least / power;
  return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

// Grid, numbers and names of a box whose edges are x0..x1 and y0..y1 in drawn
// units; numbers on y only from zero on.
function drawAxes(c, box, axes) {
  const dx = niceStep(axes.x1 - axes.x0, box.w / 70);
  const dy = niceStep(axes.y1, Math.max(2, box.h * axes.y1 /
                                           (axes.y1 - axes.y0) / 32));
  c.lineWidth = 1;
  c.strokeStyle = colour.grid;
  c.fillStyle = colour.faint;
  c.textBaseline = "middle";
  c.textAlign = "right";
  for (let k = 0; k * dy <= axes.y1 * 1.0001; k++) {
    const y = Math.round(box.Y(k * dy)) + 0.5;
    c.beginPath(); c.moveTo(box.x, y); c.lineTo(box.x + box.w, y); c.stroke();
    c.fillText(digits(k * dy), box.x - 6, y);
  }
  c.textAlign = "center";
  c.textBaseline = "top";
  for (let k = Math.ceil(axes.x0 / dx); k <= axes.x1 / dx + 1e-6; k++) {
    const x = Math.round(box.X(k * dx)) + 0.5;
    c.beginPath(); c.moveTo(x, box.y); c.lineTo(x, box.y + box.h); c.stroke();
    if (axes.xName) c.fillText(digits(k * dx), x, box.y + box.h + 5);
  }
  c.strokeStyle = colour.rule;
  c.beginPath();
  c.moveTo(box.x + 0.5, box.y);
  c.lineTo(box.x + 0.5, Math.round(box.y + box.h) + 0.5);
  c.lineTo(box.x + box.w, Math.round(box.y + box.h) + 0.5);
  c.stroke();
  c.fillStyle = colour.ink;
  if (axes.xName) {
    c.textBaseline = "bottom";
    c.fillText(axes.xName, box.x + box.w / 2, box.y + box.h + 36);
  }
  c.save();
  c.translate(box.x - 46, box.y + box.h / 2);
  c.rotate(-Math.PI / 2);
  c.textBaseline = "middle";
  c.fillText(axes.yName, 0, 0);
  c.restore();
}

// What stands for what, in a row above a box.
function drawLegend(c, box, entries) {
  let x = box.x + 4;
  c.textAlign = "left";
  c.textBaseline = "middle";
  for (const [name, stroke, dash] of entries) {
    c.strokeStyle = stroke;
    c.lineWidth = 2;
    c.setLineDash(dash ? [4, 3] : []);
    c.beginPath();
    c.moveTo(x, box.y - 9);
    c.lineTo(x + 20, box.y - 9);
    c.stroke();
    c.setLineDash([]);
    c.fillStyle = colour.ink;
    c.fillText(name, x + 25, box.y - 9);
    x += 25 + c.measureText(name).width + (box.w < 500 ? 8 : 18);
  }
}

function boxOf(x, y, w, h, axes) {
  return { x, y, w, h,
    X: (v) => x + w * (v - axes.x0) / (axes.x1 - axes.x0),
    Y: (v) => y + h - h * (v - axes.y0) / (axes.y1 - axes.y0) };
}

function clipped(c, box, draw) {
  c.save();
  c.beginPath(); c.rect(box.x, box.y, box.w, box.h); c.clip();
  draw();
  c.restore();
}

// A curve through nodes a..b-1; with an area down to the level `base`.
function drawCurve(c, box, run, a, b, f, valueAt, look) {
  const top = box.y - 4 * box.h, low = box.y + 5 * box.h;
  c.beginPath();
  for (let i = a; i < b; i++) {
    const x = box.X(run.x[i] * f);
    const y = Math.max(top, Math.min(low, box.Y(valueAt(i))));
    if (i === a) c.moveTo(x, y); else c.lineTo(x, y);
  }
  if (look.area) {
    const edge = new Path2D();
    c.save();
    c.lineTo(box.X(run.x[b - 1] * f), box.Y(look.base));
    c.lineTo(box.X(run.x[a] * f), box.Y(look.base));
    c.closePath();
    c.fillStyle = look.area;
    c.fill();
    c.restore();
    for (let i = a; i < b; i++)
      edge.lineTo(box.X(run.x[i] * f),
                  Math.max(top, Math.min(low, box.Y(valueAt(i)))));
    c.strokeStyle = look.line;
    c.lineWidth = look.width;
    c.stroke(edge);
    return;
  }
  c.strokeStyle = look.line;
  c.lineWidth = look.width;
  c.stroke();
}

function drawHertz(c, box, u) {
  c.beginPath();
  for (let k = 0; k <= 90; k++) {
    const angle = Math.PI * k / 90;
    c.lineTo(box.X(-Math.cos(angle) * u.x.f), box.Y(Math.sin(angle) * u.p.f));
  }
  c.strokeStyle = colour.hertz;
  c.lineWidth = 1.2;
  c.setLineDash([4, 3]);
  c.stroke();
  c.setLineDash([]);
}

function layout(view, width, height) {
  const run = view.run, u = unitsOf(run), w = window_();
  const gap = 0.1 * w.H, span = Math.min(ranges.high - ranges.low, 1.2 * w.H);
  const bottom = run.S && ranges.high > ranges.low ? -2.2 * gap - span : 0;
  const left = 58, right = 10, inner = width - left - right;
  const tall = height - 22 - 24 - 42;
  const upper = Math.round(tall * 0.45);
  const P = { x0: w.x0 * u.x.f, x1: w.x1 * u.x.f, y0: 0, y1: w.P * u.p.f,
    yName: u.p.name };
  const H = { x0: P.x0, x1: P.x1, y0: bottom * u.h.f, y1: w.H * u.h.f,
    xName: u.x.name, yName: u.h.name };
  return { u, w, gap, bottom, P, H,
    upper: boxOf(left, 22, inner, upper, P),
    lower: boxOf(left, 22 + upper + 24, inner, tall - upper, H) };
}

function drawRun(view) {
  const { c, width, height } = prepare(view.plot);
  const run = view.run, k = shotOf(run), l = layout(view, width, height);
  const { u, w, upper, lower } = l;
  let a = 0, b = run.nodes;
  while (a + 2 < b && run.x[a + 1] <= w.x0) a++;
  while (b > a + 2 && run.x[b - 2] >= w.x1) b--;
  view.layout = l;
  drawAxes(c, upper, l.P);
  drawAxes(c, lower, l.H);
  clipped(c, upper, () => {
    if (run.P)
      drawCurve(c, upper, run, a, b, u.x.f, (i) => run.P.at(k, i) * u.p.f,
        { area: colour["pressure-area"], line: colour.pressure, base: 0,
          width: 2 });
    drawHertz(c, upper, u);
  });
  clipped(c, lower, () => {
    if (run.H)
      drawCurve(c, lower, run, a, b, u.x.f, (i) => run.H.at(k, i) * u.h.f,
        { area: colour["film-area"], line: colour.film, base: 0,
          width: 2 });
    if (run.S && l.bottom < 0)
      drawCurve(c, lower, run, a, b, u.x.f,
        (i) => (run.S.at(k, i) - ranges.high - l.gap) * u.h.f,
        { area: colour["rough-area"], line: colour.rough, base: l.H.y0,
          width: 1.2 });
    c.strokeStyle = colour.rule;
    c.lineWidth = 1;
    const zero = Math.round(lower.Y(0)) + 0.5;
    c.beginPath();
    c.moveTo(lower.x, zero);
    c.lineTo(lower.x + lower.w, zero);
    c.stroke();
  });
  drawLegend(c, upper, [["pressure", colour.pressure],
    ["Hertzian", colour.hertz, true]]);
  drawLegend(c, lower, [["film", colour.film]].concat(
    run.S && l.bottom < 0 ? [["roughness (undeformed)", colour.rough]] : []));
  if (state.pointed) drawPointer(c, view, k);
}

function nodeAt(run, x) {
  let low = 0, high = run.nodes - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (run.x[middle] > x) high = middle; else low = middle;
  }
  return x - run.x[low] <= run.x[high] - x ? low : high;
}

function drawPointer(c, view, k) {
  const run = view.run, { u, upper, lower } = view.layout;
  const i = nodeAt(run, state.pointed.x), x = upper.X(run.x[i] * u.x.f);
  if (x < upper.x || x > upper.x + upper.w) return;
  c.strokeStyle = colour.faint;
  c.lineWidth = 1;
  c.beginPath();
  c.moveTo(x, upper.y); c.lineTo(x, upper.y + upper.h);
  c.moveTo(x, lower.y); c.lineTo(x, lower.y + lower.h);
  c.stroke();
  for (const [field, box, f, fill] of [[run.P, upper, u.p.f, colour.pressure],
    [run.H, lower, u.h.f, colour.film]]) {
    if (!field) continue;
    const y = box.Y(field.at(k, i) * f);
    if (y < box.y) continue;
    c.fillStyle = fill;
    c.beginPath(); c.arc(x, y, 3.5, 0, 7); c.fill();
  }
}

// The strip: films on the left scale, pressure on its own, the time shown as
// a line.
function drawHistory(view) {
  const { c, width, height } = prepare(view.history);
  const run = view.run, h = run.history, u = unitsOf(run);
  if (!h.time) return;
  const end = Math.max(runs[0].time[runs[0].shots - 1],
    h.time[h.time.length - 1]);
  const begin = Math.min(runs[0].time[0], h.time[0]);
  const high = (v) => v ? v.reduce((m, x) => x > m ? x : m, 0) : 0;
  const H = 1.08 * Math.max(high(h.H_cen), high(h.H_min)) || 1;
  const P = 1.08 * high(h.P_max) || 1;
  const axes = { x0: begin * u.t.f, x1: (end > begin ? end : begin + 1) * u.t.f,
    y0: 0, y1: H * u.h.f, xName: u.t.name, yName: u.h.name };
  const box = boxOf(58, 20, width - 68, height - 60, axes);
  view.strip = { box, begin, end };
  drawAxes(c, box, axes);
  for (const [v, f, line] of [[h.P_max, H / P * u.h.f, colour.pressure],
    [h.H_cen, u.h.f, colour.film], [h.H_min, u.h.f, colour.min]]) {
    if (!v) continue;
    c.beginPath();
    for (let i = 0; i < v.length; i++)
      c.lineTo(box.X(h.time[i] * u.t.f), box.Y(v[i] * f));
    c.strokeStyle = line;
    c.lineWidth = 1.5;
    c.stroke();
  }
  drawLegend(c, box, [["minimum film", colour.min],
    ["central film", colour.film],
    ["max. p to " + digits(P * u.p.f) + " " + u.p.unit, colour.pressure]]);
  const x = box.X(run.time[shotOf(run)] * u.t.f);
  c.strokeStyle = colour.ink;
  c.lineWidth = 2;
  c.beginPath(); c.moveTo(x, box.y - 2); c.lineTo(x, box.y + box.h); c.stroke();
}

// ------------------------------------------------------------- the readout

const written = (v, q) => digits(v * q.f) + (q.unit ? " " + q.unit : "");

// What is less than a level is nothing but rounding.
function valueAt(field, k, i) {
  const v = field.at(k, i);
  return Math.abs(v) < field.step ? 0 : v;
}

function showTime() {
  const run = runs[0], u = unitsOf(run), T = run.time[state.shot];
  const t = u.t.unit ? (T * u.t.f).toFixed(4) + " " + u.t.unit : T.toFixed(4);
  byId("time").textContent = (u.t.unit ? "t = " : "T = ") + t +
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

function viewOf(run, number) {
  const section = element(byId("runs"), "section");
  const view = { run };
  if (runs.length > 1 || run.made.about) {
    const head = element(section, "h2");
    head.textContent = runs.length > 1 ? run.made.name + " " : "";
    element(head, "span").textContent = run.made.about;
  }
  view.plot = element(section, "canvas", "plot");
  view.plot.setAttribute("role", "img");
  view.plot.setAttribute("aria-label", "pressure and film against x");
  view.values = element(section, "output");
  view.values.id = "values" + number;
  view.history = element(section, "canvas", "history");
  view.history.setAttribute("role", "img");
  view.history.setAttribute("aria-label", "history of film and pressure");
  view.plot.addEventListener("pointermove", (e) => onPoint(view, e));
  view.plot.addEventListener("pointerdown", (e) => onPoint(view, e));
  view.plot.addEventListener("pointerleave", (e) => {
    if (e.pointerType === "mouse") state.pointed = null;
    redraw();
  });
  view.history.addEventListener("pointerdown", (e) => onStrip(view, e));
  view.history.addEventListener("pointermove", (e) => onStrip(view, e));
  return view;
}

function connect() {
  const most = Math.max(...runs.map((run) => run.made.units.length));
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

function begin() {
  const made = JSON.parse(byId("data").textContent);
  runs = made.runs.map(runOf);
  ranges = findRanges();
  if (runs.length > 1) byId("runs").className = "two";
  byId("precision").textContent = made.precision;
  views = runs.map(viewOf);
  connect();
  readColours();
  redraw();
}

try {
  begin();
} catch (error) {
  byId("trouble").hidden = false;
  byId("trouble").textContent =
    "This page cannot show its data: " + error.message;
  throw error;
}

})();
