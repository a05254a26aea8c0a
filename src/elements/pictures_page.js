/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A gear pair, cam or bearing to scale, beside what its contact goes through;
 * where the contact is at the time shown.
 */
const elementColours = ["pressure", "film", "rough", "min", "warm-2", "film",
  "faint", "page", "ink"];

// "t (ms)" of gnuplot's enhanced text
const plain = (label) => label.replace(/\{\/:Italic ([^}]*)\}/g, "$1");

function elementOf(made) {
  const number = (v) => v ? doublesOf(v) : new Float64Array(0);
  const placed = (o) => ({ ...o, x: number(o.x), y: number(o.y) });
  return { ...placed(made), at: number(made.at),
    panels: made.panels.map((p) =>
      ({ ...p, curves: p.curves.slice(0, -1).map(placed) })) };
}

function drawElementCurve(c, box, curve) {
  const stroke = colour[elementColours[curve.colour]];
  c.strokeStyle = c.fillStyle = stroke;
  c.lineWidth = 0.75 * curve.width;
  if (curve.mark === "points" || curve.mark === "cross") {
    const letters = curve.letters.split(" ");
    for (let i = 0; i < curve.x.length; i++) {
      const x = box.X(curve.x[i]), y = box.Y(curve.y[i]);
      c.beginPath(); c.arc(x, y, 1.2 * curve.width, 0, 7); c.fill();
      c.textAlign = "left";
      c.textBaseline = "bottom";
      c.fillText(letters[i] || "", x + 4, y - 2);
    }
    return;
  }
  c.setLineDash(curve.mark === "dotted" ? [2, 3] : []);
  c.beginPath();
  let pen = false;
  for (let i = 0; i < curve.x.length; i++) {
    const there = !Number.isNaN(curve.x[i]);
    if (there && pen) c.lineTo(box.X(curve.x[i]), box.Y(curve.y[i]));
    else if (there) c.moveTo(box.X(curve.x[i]), box.Y(curve.y[i]));
    pen = there;
  }
  c.stroke();
  c.setLineDash([]);
}

// The shorter axis grows until both have one scale.
function equalAxes(p, w, h) {
  const ux = (p.x1 - p.x0) / w, uy = (p.y1 - p.y0) / h;
  const dx = Math.max(0, (uy - ux) * w / 2);
  const dy = Math.max(0, (ux - uy) * h / 2);
  return { ...p, x0: p.x0 - dx, x1: p.x1 + dx, y0: p.y0 - dy, y1: p.y1 + dy };
}

function drawElementPanel(c, p, x, y, w, h, named) {
  const range = p.equal ? equalAxes(p, w, h) : p;
  const axes = { ...range, from: range.y0, yName: plain(p.yName),
    xName: named ? plain(p.xName) : "" };
  const box = boxOf(x, y, w, h, axes);
  drawAxes(c, box, axes);
  clipped(c, box, () => {
    for (const curve of p.curves) drawElementCurve(c, box, curve);
  });
  drawLegend(c, box, p.curves.filter((curve) => curve.label).map((curve) =>
    [curve.label, colour[elementColours[curve.colour]], curve.mark === "dotted",
      curve.label.split(" ").slice(-1)[0]]));
  return box;
}

// Where the contact is: a point in the drawing, an upright in the others.
function markContact(c, view, element, boxes) {
  const run = view.run, T = run.time[shotOf(run)];
  const at = element.begin + element.unit * T * element.seconds;
  let i = 0;
  while (i + 1 < element.at.length && element.at[i + 1] <= at) i++;
  c.strokeStyle = c.fillStyle = colour.ink;
  c.lineWidth = 2;
  c.beginPath();
  c.arc(boxes[0].X(element.x[i]), boxes[0].Y(element.y[i]), 5, 0, 7);
  c.stroke();
  for (const box of boxes.slice(1)) {
    const x = Math.min(box.X(at), box.x + box.w);
    c.beginPath(); c.moveTo(x, box.y); c.lineTo(x, box.y + box.h); c.stroke();
  }
}

function drawElement(view) {
  if (!view.element) return;
  const { c, width, height } = prepare(view.element), e = view.run.element;
  const wide = width > 640, boxes = [], n = e.panels.length - 1;
  const tall = wide ? height : 0.5 * height;
  boxes.push(drawElementPanel(c, e.panels[0], 58, 22,
    (wide ? 0.5 * width : width) - 68, tall - 64, true));
  const x = wide ? 0.5 * width + 58 : 58, top = wide ? 0 : tall;
  const each = ((wide ? height : 0.5 * height) - 20) / n;
  for (let k = 0; k < n; k++)
    boxes.push(drawElementPanel(c, e.panels[k + 1], x, top + k * each + 22,
      width - x - 10, each - 44, k + 1 === n));
  if (e.at.length) markContact(c, view, e, boxes);
}
