/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The stresses below the film: colours of one scale for the whole run, white
 * lines every 0.1 p_h, a dark one at the largest value of the smooth contact, a
 * cross at the largest of the snapshot, dots where the mesh begins to be seen,
 * straight lines where one layer ends and the next begins.
 */
const palette = [[27, 16, 68], [59, 58, 140], [42, 122, 152], [69, 168, 130],
  [201, 207, 82], [255, 243, 176]];
const deepestShown = 1.5; // on a linear scale, in b

async function stressOf(made, shots) {
  const n = made.columns * made.rows;
  const field = await fieldOf(made, n, shots);
  return { ...made, at: field.at, z: doublesOf(made.z),
    worst: doublesOf(made.worst),
    layers: made.layers ? doublesOf(made.layers) : [] };
}

// What yielding left in the material at the end of the run, which moves with
// its surface.
function materialOf(made) {
  return { ...made, z: doublesOf(made.z), place: doublesOf(made.place),
    fields: made.fields.map((f) => ({ ...f, data: doublesOf(f.data) })) };
}

// What is drawn below snapshot k: the stress, or a map of the material where
// that is now.
function sheetOf(run, k) {
  const m = run.material, f = m && m.fields[state.below - 1];
  if (!f) return run.stress;
  return { columns: m.columns, rows: m.rows, x0: m.place[k] + m.x0,
    x1: m.place[k] + m.x1, z: m.z, name: f.name, pure: f.pure, low: f.low,
    high: f.high, step: (f.high - f.low) / 8, at: (shot, i) => f.data[i] };
}

function shadeOf(part) {
  const p = Math.max(0, Math.min(1, part)) * (palette.length - 1);
  const k = Math.min(palette.length - 2, Math.floor(p)), t = p - k;
  return palette[k].map((v, i) => v + t * (palette[k + 1][i] - v));
}

// Row, as a fraction, of a depth: the rows are geometric.
const rowOf = (s, z) => (s.rows - 1) * Math.log(Math.max(z, s.z[0]) / s.z[0]) /
  Math.log(s.z[s.rows - 1] / s.z[0]);

// Linear between columns and between rows; NaN beside the field.
function stressAt(s, k, x, z) {
  const c = (s.columns - 1) * (x - s.x0) / (s.x1 - s.x0), r = rowOf(s, z);
  if (c < 0 || c > s.columns - 1 || r > s.rows - 1 + 1e-9) return NaN;
  const i = Math.min(s.columns - 2, Math.floor(c));
  const j = Math.min(s.rows - 2, Math.floor(r)), n = s.columns;
  const u = c - i, v = r - j;
  return (1 - v) * ((1 - u) * s.at(k, j * n + i) + u * s.at(k, j * n + i + 1)) +
    v * ((1 - u) * s.at(k, j * n + n + i) + u * s.at(k, j * n + n + i + 1));
}

// From depth to y and back, linear or logarithmic.
function depthScale(s, y, h) {
  if (state.depth !== "log")
    return { Y: (z) => y + h * z / deepestShown,
      Z: (v) => (v - y) / h * deepestShown };
  const a = Math.log(s.z[0]), b = Math.log(s.z[s.rows - 1]);
  return { Y: (z) => y + h * (Math.log(z) - a) / (b - a),
    Z: (v) => Math.exp(a + (v - y) / h * (b - a)) };
}

function paintField(c, box, s, k) {
  const w = Math.round(box.w), h = Math.round(box.h);
  const image = new ImageData(w, h), d = image.data;
  const sheet = document.createElement("canvas");
  for (let j = 0; j < h; j++) {
    const z = box.Z(box.y + j + 0.5);
    for (let i = 0; i < w; i++) {
      const v = stressAt(s, k, box.xAt(box.x + i + 0.5), z);
      if (isNaN(v)) continue;
      const shade = shadeOf((v - s.low) / (s.high - s.low)), o = 4 * (j * w + i);
      d[o] = shade[0]; d[o + 1] = shade[1]; d[o + 2] = shade[2]; d[o + 3] = 255;
    }
  }
  sheet.width = w;
  sheet.height = h;
  sheet.getContext("2d").putImageData(image, 0, 0);
  c.drawImage(sheet, box.x, box.y, w, h);
}

// Where a value is crossed, cell by cell: each edge gives a point, and the
// points of a cell are joined.
function drawContour(c, box, s, k, value, look) {
  const n = s.columns, X = (i) => box.X(s.x0 + i * (s.x1 - s.x0) / (n - 1));
  c.beginPath();
  for (let j = 0; j + 1 < s.rows; j++)
    for (let i = 0; i + 1 < n; i++) {
      const corner = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const v = corner.map(([a, b]) => s.at(k, b * n + a) - value);
      const points = [];
      for (let e = 0; e < 4; e++) {
        const f = (e + 1) % 4;
        if (v[e] < 0 === v[f] < 0) continue;
        const t = v[e] / (v[e] - v[f]), [a, b] = corner[e], [p, q] = corner[f];
        const ln = Math.log(s.z[b]) * (1 - t) + Math.log(s.z[q]) * t;
        points.push([X(a + t * (p - a)), box.Y(Math.exp(ln))]);
      }
      for (let e = 0; e + 1 < points.length; e += 2) {
        c.moveTo(...points[e]);
        c.lineTo(...points[e + 1]);
      }
    }
  c.strokeStyle = look.line;
  c.lineWidth = look.width;
  c.stroke();
}

function drawWorst(c, box, s, k) {
  const x = box.X(s.worst[3 * k]), y = box.Y(s.worst[3 * k + 1]);
  c.strokeStyle = "#e02020";
  c.lineWidth = 2.5;
  c.beginPath();
  c.moveTo(x - 6, y - 6); c.lineTo(x + 6, y + 6);
  c.moveTo(x - 6, y + 6); c.lineTo(x + 6, y - 6);
  c.stroke();
}

function drawLayers(c, box, depths) {
  c.strokeStyle = "#ffffff";
  c.lineWidth = 2;
  c.beginPath();
  for (const z of depths) {
    c.moveTo(box.x, box.Y(z));
    c.lineTo(box.x + box.w, box.Y(z));
  }
  c.stroke();
}

function drawDepths(c, box, s, u) {
  const log = state.depth === "log", ticks = [];
  if (log)
    for (let e = -6; e <= 6; e++) ticks.push(10 ** e);
  else {
    const step = niceStep(deepestShown * u.x.f, box.h / 32);
    for (let v = 0; v <= deepestShown * u.x.f * 1.0001; v += step) ticks.push(v);
  }
  c.fillStyle = colour.faint;
  c.textAlign = "right";
  c.textBaseline = "middle";
  for (const tick of ticks) {
    const y = box.Y(tick / u.x.f);
    if (y < box.y - 1 || y > box.y + box.h + 1) continue;
    c.fillText(digits(tick), box.x - 6, y);
  }
  c.fillStyle = colour.ink;
  c.save();
  c.translate(box.x - 46, box.y + box.h / 2);
  c.rotate(-Math.PI / 2);
  c.textAlign = "center";
  c.fillText("depth" + (u.x.unit ? ", " + u.x.unit : ""), 0, 0);
  c.restore();
}

// The colours and their ends, in a row above the box, with the largest value;
// less of it where the row would not fit.
function drawScale(c, box, s, k, u) {
  const y = box.y - 15, name = s.name.replace(/_/g, " ");
  const f = s.pure ? 1 : u.p.f;
  const unit = s.pure ? "" : " " + (u.p.unit || "p_h");
  const said = (v) => digits(v * f) + unit;
  const most = said(s.worst ? s.worst[3 * k + 2] : s.high);
  const ends = digits(s.low * f) + " to " + said(s.high);
  const remedy = s.unresolved ? s.unresolved[k] : "";
  const looks = remedy ? [[name + ", largest " + most + ", not resolved (" +
    remedy + ")", 110], [name + " to " + most + ", not resolved", 50],
  [most + ", not resolved", 20]] : [[name + ", largest " + most, 110], [name + " to " + most, 110],
    [name + " to " + most, 50], [name + " to " + most, 20]];
  const room = box.w - 30 - c.measureText(ends).width;
  const [text, wide] = looks.find(([t, bar]) =>
    c.measureText(t).width + bar <= room) || looks[looks.length - 1];
  box.free = room - wide - c.measureText(text).width;
  c.textBaseline = "middle";
  c.fillStyle = colour.ink;
  c.textAlign = "left";
  c.fillText(text, box.x + 4, y + 5);
  for (let i = 0; i < wide; i++) {
    c.fillStyle = "rgb(" + shadeOf(i / wide).map(Math.round).join() + ")";
    c.fillRect(box.x + box.w - wide - 4 + i, y, 1.5, 10);
  }
  c.fillStyle = colour.faint;
  c.textAlign = "right";
  c.fillText(ends, box.x + box.w - wide - 10, y + 5);
}

function drawStress(view) {
  if (!view.stress) return;
  const { c, width, height } = prepare(view.stress);
  const run = view.run, k = shotOf(run), s = sheetOf(run, k);
  const { u, w } = view.layout;
  const box = { x: 58, y: 22, w: width - 68, h: height - 30 };
  box.X = (x) => box.x + box.w * (x - w.x0) / (w.x1 - w.x0);
  box.xAt = (v) => w.x0 + (v - box.x) / box.w * (w.x1 - w.x0);
  Object.assign(box, depthScale(s, box.y, box.h));
  view.below = box;
  clipped(c, box, () => {
    paintField(c, box, s, k);
    const step = !s.worst ? s.step
      : Math.max(s.high, -s.low) > 0.6 ? 0.2 : 0.1;
    for (let v = step; v < 12 * step; v += step)
      for (const sign of s.low < 0 ? [-1, 1] : [1])
        if (v <= Math.max(s.high, -s.low))
          drawContour(c, box, s, k, sign * v,
            { line: "rgba(255, 255, 255, .8)", width: 0.7 });
    drawLayers(c, box, run.stress.layers);
    if (!s.worst) return;
    for (const sign of s.low < 0 && s.high > 0 ? [-1, 1] : [s.low < 0 ? -1 : 1])
      drawContour(c, box, s, k, sign * s.smooth, { line: "#101418", width: 1.6 });
    c.strokeStyle = "#ffffff";
    c.setLineDash([2, 3]);
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(box.x, box.Y(s.least)); c.lineTo(box.x + box.w, box.Y(s.least));
    c.stroke();
    c.setLineDash([]);
    drawWorst(c, box, s, k);
  });
  drawDepths(c, box, s, u);
  drawScale(c, box, s, k, u);
  view.stress.dataset.free = box.free;
  view.stress.dataset.unresolved = s.unresolved ? s.unresolved[k] : "";
  view.stress.dataset.below = s.name;
  view.stress.dataset.layers = [...run.stress.layers].map(box.Y).join(" ");
  if (s.worst) view.stress.dataset.worst = [...s.worst.slice(3 * k, 3 * k + 3)].join(" ");
}

function onStress(view, event) {
  const box = view.below, k = shotOf(view.run), s = sheetOf(view.run, k);
  const edge = view.stress.getBoundingClientRect(), { u } = view.layout;
  const x = box.xAt(event.clientX - edge.left);
  const z = box.Z(event.clientY - edge.top), v = stressAt(s, k, x, z);
  if (isNaN(v) || z < 0) return;
  view.stress.dataset.pointed = [x, z, v].join(" ");
  view.values.textContent = "x = " + written(x, u.x) + "   depth = " +
    written(z, u.x) + "   " + s.name.replace(/_/g, " ") + " = " +
    (s.pure ? digits(v) : written(v, u.p));
}
