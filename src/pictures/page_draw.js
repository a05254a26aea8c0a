/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the page knows and how it is drawn.  All numbers inside are Hertzian;
 * units are applied where something is written.
 */
const byId = (id) => document.getElementById(id);
const state = {
  shot: 0, playing: false, speed: 1, loop: true, zoom: "contact", units: 0,
  depth: "linear",
  below: 0, // the stress; then what yielding left behind
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
    "hertz", "min", "warm-2", "tip"])
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

// The name of an axis on a side of that length: "pressure, p (GPa)", or where
// that is too long, "p (GPa)".
function fitted(c, name, length) {
  return c.measureText(name).width <= length ? name
    : name.slice(name.lastIndexOf(", ") + 1).trim();
}

// Grid, numbers and names of a box whose edges are x0..x1 and y0..y1 in drawn
// units; numbers on y only from zero, or from `from`, on.
function drawAxes(c, box, axes) {
  const from = axes.from ?? 0, span = axes.y1 - from;
  const dx = niceStep(axes.x1 - axes.x0, box.w / 70);
  const dy = niceStep(span, Math.max(2, box.h * span /
                                        (axes.y1 - axes.y0) / 32));
  c.lineWidth = 1;
  c.strokeStyle = colour.grid;
  c.fillStyle = colour.faint;
  c.textBaseline = "middle";
  c.textAlign = "right";
  for (let k = Math.ceil(from / dy); k * dy <= axes.y1 + 1e-4 * span; k++) {
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
    c.fillText(fitted(c, axes.xName, box.w), box.x + box.w / 2,
      box.y + box.h + 36);
  }
  c.save();
  c.translate(box.x - 50, box.y + box.h / 2);
  c.rotate(-Math.PI / 2);
  c.textBaseline = "middle";
  c.fillText(fitted(c, axes.yName, box.h), 0, 0);
  c.restore();
}

// What stands for what, in a row above a box; an entry's short name and closer
// ones where the row would not fit.
function drawLegend(c, box, entries) {
  const wide = (short, line, gap) => entries.reduce((sum, e) =>
    sum + line + 5 + gap + c.measureText(short && e[3] || e[0]).width, -gap);
  const looks = [[false, 20, 18], [false, 14, 8], [true, 14, 8], [true, 8, 5]];
  const [short, line, gap] = looks.find((l) => wide(...l) <= box.w - 4) ||
    looks[3];
  let x = box.x + 4;
  c.textAlign = "left";
  c.textBaseline = "middle";
  for (const [name, stroke, dash, brief] of entries) {
    const text = short && brief || name;
    c.strokeStyle = stroke;
    c.lineWidth = 2;
    c.setLineDash(dash ? [4, 3] : []);
    c.beginPath();
    c.moveTo(x, box.y - 9);
    c.lineTo(x + line, box.y - 9);
    c.stroke();
    c.setLineDash([]);
    c.fillStyle = colour.ink;
    c.fillText(text, x + line + 5, box.y - 9);
    x += line + 5 + c.measureText(text).width + gap;
  }
}

// How tall the roughness is, in a strip without numbers: a bar of round length
// at the right.
function drawBar(c, box, l) {
  const span = -l.H.y0, length = niceStep(span * 0.6, 1.2);
  const x = box.x + box.w - 8, y = box.Y(l.H.y0) - 6, top = y - box.h * length /
    (l.H.y1 - l.H.y0);
  c.strokeStyle = colour.ink;
  c.lineWidth = 1.5;
  c.beginPath();
  c.moveTo(x - 3, top); c.lineTo(x + 3, top);
  c.moveTo(x, top); c.lineTo(x, y);
  c.moveTo(x - 3, y); c.lineTo(x + 3, y);
  c.stroke();
  c.fillStyle = colour.ink;
  c.textAlign = "right";
  c.textBaseline = "middle";
  c.fillText(digits(length) + (l.u.h.unit ? " " + l.u.h.unit : ""), x - 6,
             (top + y) / 2);
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
  const trace = () => {
    c.beginPath();
    for (let i = a; i < b; i++)
      c.lineTo(box.X(run.x[i] * f),
               Math.max(top, Math.min(low, box.Y(valueAt(i)))));
  };
  trace();
  if (look.area) {
    c.lineTo(box.X(run.x[b - 1] * f), box.Y(look.base));
    c.lineTo(box.X(run.x[a] * f), box.Y(look.base));
    c.closePath();
    c.fillStyle = look.area;
    c.fill();
    trace();
  }
  c.strokeStyle = look.line;
  c.lineWidth = look.width;
  c.stroke();
}

// Oil as high as it stands on either wall, half of it on each.
function drawOil(c, box, run, a, b, k, u) {
  const half = (i) => run.F.at(k, i) * run.H.at(k, i) / 2;
  c.beginPath(); // one for both: where two areas meet, a line would show
  for (const [from, to] of [[() => 0, half],
    [(i) => run.H.at(k, i) - half(i), (i) => run.H.at(k, i)]]) {
    const Y = (v) => Math.max(box.y - 4 * box.h, box.Y(v * u.h.f));
    c.moveTo(box.X(run.x[a] * u.x.f), Y(from(a)));
    for (let i = a + 1; i < b; i++)
      c.lineTo(box.X(run.x[i] * u.x.f), Y(from(i)));
    for (let i = b; i-- > a;) c.lineTo(box.X(run.x[i] * u.x.f), Y(to(i)));
    c.closePath();
  }
  c.fillStyle = colour["film-area"];
  c.fill();
}

function drawHertz(c, box, u, run, k) {
  const b = run.hertz ? run.hertz[2 * k] : 1;
  const P = run.hertz ? run.hertz[2 * k + 1] : 1;
  c.beginPath();
  for (let k = 0; k <= 90; k++) {
    const angle = Math.PI * k / 90;
    c.lineTo(box.X(-b * Math.cos(angle) * u.x.f),
      box.Y(P * Math.sin(angle) * u.p.f));
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
  let a = 0, b = run.nodes;
  while (a + 2 < b && run.x[a + 1] <= w.x0) a++;
  while (b > a + 2 && run.x[b - 2] >= w.x1) b--;
  return { u, w, a, b, gap, bottom, P, H,
    upper: boxOf(left, 22, inner, upper, P),
    lower: boxOf(left, 22 + upper + 24, inner, tall - upper, H) };
}

// What surfaces bear where they touch, and a mark at each node that does.
function drawContact(c, box, run, a, b, k, u) {
  const least = 1e-3;
  drawCurve(c, box, run, a, b, u.x.f, (i) => run.C.at(k, i) * u.p.f,
    { area: "transparent", line: colour.film, base: 0, width: 1.5 });
  c.fillStyle = colour.film;
  for (let i = a; i <= b; i++)
    if (run.C.at(k, i) > least)
      c.fillRect(box.X(run.x[i] * u.x.f) - 1, box.Y(0) - 4, 2, 4);
}

// Another contact's curve, faint, behind that of a run.
function drawBehind(c, box, behind, u, f, field) {
  if (!behind || !behind[field]) return;
  drawCurve(c, box, behind, 0, behind.nodes, u.x.f,
    (i) => behind[field].at(0, i) * f, { line: colour.faint, width: 1.2 });
}

function drawRun(view) {
  const { c, width, height } = prepare(view.plot);
  const run = view.run, k = shotOf(run), l = layout(view, width, height);
  const { u, a, b, upper, lower } = l;
  view.layout = l;
  drawAxes(c, upper, l.P);
  drawAxes(c, lower, l.H);
  clipped(c, upper, () => {
    if (run.P)
      drawCurve(c, upper, run, a, b, u.x.f, (i) => run.P.at(k, i) * u.p.f,
        { area: colour["pressure-area"], line: colour.pressure, base: 0,
          width: 2 });
    drawBehind(c, upper, view.behind, u, u.p.f, "P");
    drawHertz(c, upper, u, run, k);
    if (run.C) drawContact(c, upper, run, a, b, k, u);
  });
  clipped(c, lower, () => {
    const oil = run.H && run.F;
    if (oil) drawOil(c, lower, run, a, b, k, u);
    if (run.H)
      drawCurve(c, lower, run, a, b, u.x.f, (i) => run.H.at(k, i) * u.h.f,
        { area: oil ? "transparent" : colour["film-area"], line: colour.film,
          base: 0, width: 2 });
    drawBehind(c, lower, view.behind, u, u.h.f, "H");
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
  const rough = run.S && l.bottom < 0;
  if (rough) drawBar(c, lower, l);
  drawLegend(c, upper, [["pressure", colour.pressure],
    ["Hertzian", colour.hertz, true]].concat(
    run.C ? [["where surfaces touch", colour.film, false, "touch"]] : []));
  drawLegend(c, lower, [[run.F ? "film, its oil shaded" : "film", colour.film,
    false, "film"]].concat(
    rough ? [["roughness (undeformed)", colour.rough, false, "roughness"]]
      : []));
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

// A line through boxes at x and dots on it: [box, value, colour].
function drawCross(c, at, boxes, dots) {
  const x = boxes[0].X(at);
  if (x < boxes[0].x || x > boxes[0].x + boxes[0].w) return;
  c.strokeStyle = colour.faint;
  c.lineWidth = 1;
  c.beginPath();
  for (const box of boxes) {
    c.moveTo(x, box.y); c.lineTo(x, box.y + box.h);
  }
  c.stroke();
  for (const [box, value, fill] of dots) {
    const y = box.Y(value);
    if (y < box.y) continue;
    c.fillStyle = fill;
    c.beginPath(); c.arc(x, y, 3.5, 0, 7); c.fill();
  }
}

function drawPointer(c, view, k) {
  const run = view.run, { u, upper, lower } = view.layout;
  const i = nodeAt(run, state.pointed.x), dots = [];
  for (const [field, box, f, fill] of [[run.P, upper, u.p.f, colour.pressure],
    [run.H, lower, u.h.f, colour.film]])
    if (field) dots.push([box, field.at(k, i) * f, fill]);
  drawCross(c, run.x[i] * u.x.f, [upper, lower], dots);
}

// An axis at the right of a box: `high` at the height of `left` on the other.
function drawRightAxis(c, box, high, left, name) {
  const step = niceStep(high, Math.max(2, box.h / 32)), x = box.x + box.w;
  c.fillStyle = colour.pressure;
  c.textAlign = "left";
  c.textBaseline = "middle";
  for (let k = 0; k * step <= high * (1 + 1e-4); k++)
    c.fillText(digits(k * step), x + 6, box.Y(k * step / high * left));
  c.save();
  c.translate(x + 46, box.y + box.h / 2);
  c.rotate(-Math.PI / 2);
  c.textAlign = "center";
  c.fillText(fitted(c, name, box.h), 0, 0);
  c.restore();
}

// The history: film thickness on the left axis, maximum pressure on the right
// one, the shown time as a line.
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
  const box = boxOf(58, 20, width - 122, height - 60, axes);
  view.strip = { box, begin, end };
  drawAxes(c, box, axes);
  if (h.P_max) drawRightAxis(c, box, P * u.p.f, H * u.h.f, u.p.name);
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
  drawLegend(c, box, [
    ["minimum film thickness", colour.min, false, "min."],
    ["central film thickness", colour.film, false, "central"],
    ["maximum pressure", colour.pressure, false, "max. p"]]);
  const x = box.X(run.time[shotOf(run)] * u.t.f);
  c.strokeStyle = colour.ink;
  c.lineWidth = 2;
  c.beginPath(); c.moveTo(x, box.y - 2); c.lineTo(x, box.y + box.h); c.stroke();
}
