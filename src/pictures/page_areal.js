/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The maps of a strip: pressure and film thickness in the plane of the contact,
 * a cross-hair, and the values along both of its lines.  Colours have one scale
 * for the whole run.
 */
async function arealOf(made) {
  const n = made.columns * made.rows, a = { ...made };
  a.x = doublesOf(made.x);
  a.y = doublesOf(made.y);
  for (const name of ["P", "H"])
    a[name] = await fieldOf(made[name], n, made.shots);
  a.cut = { x: 0, y: made.shown };
  return a;
}

const arealShot = (a, k) =>
  Math.min(a.shots - 1, Math.floor(k / a.every));

// The column or row nearest to a place; y repeats.
function nearestTo(list, at) {
  let best = 0;
  for (let i = 1; i < list.length; i++)
    if (Math.abs(list[i] - at) < Math.abs(list[best] - at)) best = i;
  return best;
}

// The colours of one map, y upwards; each cell is a pixel, which the browser
// smooths.
function sheetOfMap(a, field, k) {
  const image = new ImageData(a.columns, a.rows), d = image.data;
  const sheet = document.createElement("canvas");
  const most = field.value.length - 1, shades = [];
  for (let i = 0; i < 256; i++) shades.push(shadeOf(i / 255).map(Math.round));
  for (let j = 0; j < a.rows; j++)
    for (let i = 0; i < a.columns; i++) {
      const level = field.level[k * a.columns * a.rows + j * a.columns + i];
      const shade = shades[Math.round(255 * level / most)];
      const o = 4 * ((a.rows - 1 - j) * a.columns + i);
      d[o] = shade[0]; d[o + 1] = shade[1]; d[o + 2] = shade[2]; d[o + 3] = 255;
    }
  sheet.width = a.columns;
  sheet.height = a.rows;
  sheet.getContext("2d").putImageData(image, 0, 0);
  return sheet;
}

// Name and colours of a map in a row above it.
function drawArealScale(c, box, q, field) {
  const y = box.y - 15, wide = Math.min(110, box.w / 3);
  const last = field.value.length - 1;
  const low = digits(field.value[0] * q.f), high = digits(field.value[last] * q.f);
  c.textBaseline = "middle";
  c.textAlign = "left";
  c.fillStyle = colour.ink;
  c.fillText(fitted(c, q.name, box.w / 3), box.x, y + 5);
  c.textAlign = "right";
  c.fillStyle = colour.faint;
  c.fillText(high, box.x + box.w, y + 5);
  const right = box.x + box.w - c.measureText(high).width - 6;
  for (let i = 0; i < wide; i++) {
    c.fillStyle = "rgb(" + shadeOf(i / wide).map(Math.round).join() + ")";
    c.fillRect(right - wide + i, y, 1.5, 10);
  }
  c.fillStyle = colour.faint;
  c.fillText(low, right - wide - 6, y + 5);
}

function drawArealCut(c, box, places, values, look) {
  clipped(c, box, () => {
    c.beginPath();
    places.forEach((v, i) => c.lineTo(box.X(v), box.Y(values[i])));
    c.strokeStyle = look;
    c.lineWidth = 1.6;
    c.stroke();
  });
}

function drawOneMap(view, c, left, wide, name) {
  const run = view.run, a = run.areal, { u, w } = view.layout;
  const k = arealShot(a, shotOf(run)), field = a[name], q = name === "P" ? u.p : u.h;
  const look = name === "P" ? colour.pressure : colour.film;
  const f = u.x.f, height = view.areal.clientHeight, W = a.width;
  const x0 = Math.max(w.x0, a.x[0]), x1 = Math.min(w.x1, a.x[a.columns - 1]);
  const y0 = a.y[0], y1 = y0 + W, cut = a.cut;
  const tall = Math.round(0.44 * height), low = Math.round(0.15 * height);
  const box = boxOf(left + 58, 24, wide - 68, tall,
    { x0: x0 * f, x1: x1 * f, y0: y0 * f, y1: y1 * f });
  const i = nearestTo(a.x, cut.x), j = nearestTo(a.y, cut.y);
  const yName = u.x.name.replace("x (", "y (");
  drawAxes(c, box, { x0: x0 * f, x1: x1 * f, from: y0 * f, y0: y0 * f,
    y1: y1 * f, xName: "", yName });
  clipped(c, box, () => {
    const dx = (a.x[a.columns - 1] - a.x[0]) / (a.columns - 1) / 2;
    const from = box.X((a.x[0] - dx) * f);
    const to = box.X((a.x[a.columns - 1] + dx) * f);
    const dy = (a.rows > 1 ? a.y[1] - a.y[0] : W) / 2;
    const top = box.Y((a.y[a.rows - 1] + dy) * f), base = box.Y((y0 - dy) * f);
    const sheet = sheetOfMap(a, field, k);
    c.imageSmoothingEnabled = true;
    c.drawImage(sheet, from, top, to - from, base - top);
    // The period closes above the last line.
    c.drawImage(sheet, from, top - (base - top), to - from, base - top);
    c.strokeStyle = "#ffffff";
    c.lineWidth = 1;
    c.setLineDash([4, 3]);
    c.beginPath();
    c.moveTo(box.x, box.Y(a.y[j] * f)); c.lineTo(box.x + box.w, box.Y(a.y[j] * f));
    c.moveTo(box.X(a.x[i] * f), box.y); c.lineTo(box.X(a.x[i] * f), box.y + box.h);
    c.stroke();
    c.setLineDash([]);
  });
  drawArealScale(c, box, q, field);
  const last = field.value.length - 1, at = (col, row) =>
    field.at(k, row * a.columns + col) * q.f;
  const from = name === "P" ? 0 : field.value[0] * q.f, high = field.value[last] * q.f;
  const margin = 0.06 * (high - from);
  const axes = { y0: from - (from ? margin : 0), from: from - (from ? margin : 0),
    y1: high + margin, yName: q.name };
  const along = boxOf(box.x, box.y + tall + 24, box.w, low,
    { ...axes, x0: x0 * f, x1: x1 * f });
  drawAxes(c, along, { ...axes, x0: x0 * f, x1: x1 * f, xName: u.x.name });
  drawArealCut(c, along, Array.from(a.x, (v) => v * f),
    Array.from(a.x, (v, col) => at(col, j)), look);
  const across = boxOf(box.x, along.y + low + 54, box.w, low,
    { ...axes, x0: y0 * f, x1: y1 * f });
  drawAxes(c, across, { ...axes, x0: y0 * f, x1: y1 * f, xName: yName });
  drawArealCut(c, across, [...Array.from(a.y, (v) => v * f), y1 * f],
    [...Array.from(a.y, (v, row) => at(i, row)), at(i, 0)], look);
  return box;
}

function drawAreal(view) {
  if (!view.areal) return;
  const { c, width } = prepare(view.areal), a = view.run.areal;
  const half = width > 640;
  view.maps = half ? [drawOneMap(view, c, 0, width / 2, "P"),
    drawOneMap(view, c, width / 2, width / 2, "H")]
    : [drawOneMap(view, c, 0, width, "H")];
  const k = arealShot(a, shotOf(view.run)), u = unitsOf(view.run);
  const i = nearestTo(a.x, a.cut.x), j = nearestTo(a.y, a.cut.y);
  const n = j * a.columns + i;
  view.areal.dataset.cut = [a.x[i], a.y[j], a.P.at(k, n), a.H.at(k, n)].join(" ");
  view.arealValues.textContent = "cross-hair: x = " + written(a.x[i], u.x) +
    "   y = " + written(a.y[j], u.x) + "   p = " + written(a.P.at(k, n), u.p) +
    "   h = " + written(a.H.at(k, n), u.h) +
    (a.coarser ? "   (" + a.coarser + ")" : "");
}

function onAreal(view, event) {
  if (event.type === "pointermove" && !(event.buttons & 1) &&
      event.pointerType !== "mouse") return;
  const edge = view.areal.getBoundingClientRect(), { u } = view.layout;
  const x = event.clientX - edge.left, y = event.clientY - edge.top;
  const box = view.maps.find((b) => x >= b.x && x <= b.x + b.w &&
    y >= b.y && y <= b.y + b.h);
  if (!box) return;
  const origin = box.X(0), base = box.Y(0);
  view.run.areal.cut = { x: (x - origin) / (box.X(1) - origin) / u.x.f,
    y: (y - base) / (box.Y(1) - base) / u.x.f };
  redraw();
}

function addAreal(view, section) {
  if (!view.run.areal) return;
  view.areal = element(section, "canvas", "areal");
  view.areal.setAttribute("role", "img");
  view.areal.setAttribute("aria-label",
    "maps of pressure and film thickness, with cuts along and across");
  view.arealValues = element(section, "output");
  view.areal.addEventListener("pointermove", (e) => onAreal(view, e));
  view.areal.addEventListener("pointerdown", (e) => onAreal(view, e));
}
