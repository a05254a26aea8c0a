/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The picture as a file, PNG or SVG: drawn again by the functions that draw the
 * page, on white, in light colours, at the size that it has there.
 */
const xml = (text) => String(text).replace(/[&<>"]/g,
  (c) => "&#" + c.charCodeAt(0) + ";");
const round = (v) => String(Math.round(100 * v) / 100);

// A 2D context as far as the page uses one, which writes SVG.
class SvgContext {
  constructor() {
    this.out = [];
    this.path = "";
    this.clips = 0;
    this.at = { fillStyle: "#000", strokeStyle: "#000", lineWidth: 1, dash: [],
      textAlign: "left", textBaseline: "alphabetic", open: 0, move: "" };
    this.stack = [];
    const at = () => this.at;
    for (const name of ["fillStyle", "strokeStyle", "lineWidth", "textAlign",
      "textBaseline"])
      Object.defineProperty(this, name, { get: () => at()[name],
        set: (v) => { at()[name] = v; } });
    this.ruler = document.createElement("canvas").getContext("2d");
  }
  put(text) { this.out.push(text); }
  setTransform() {}
  clearRect() {}
  measureText(text) {
    this.ruler.font = this.font;
    return this.ruler.measureText(text);
  }
  setLineDash(dash) { this.at.dash = dash; }
  save() {
    this.stack.push(this.at);
    this.at = { ...this.at, open: 0 };
  }
  restore() {
    this.put("</g>".repeat(this.at.open));
    this.at = this.stack.pop();
  }
  group(attribute) {
    this.put("<g " + attribute + ">");
    this.at.open++;
  }
  translate(x, y) {
    this.group('transform="translate(' + round(x) + " " + round(y) + ')"');
  }
  rotate(angle) {
    this.group('transform="rotate(' + round(angle * 180 / Math.PI) + ')"');
  }
  beginPath() { this.path = ""; }
  moveTo(x, y) { this.path += "M" + round(x) + " " + round(y); }
  lineTo(x, y) {
    this.path += (this.path ? "L" : "M") + round(x) + " " + round(y);
  }
  closePath() { this.path += "Z"; }
  rect(x, y, w, h) {
    this.path += "M" + round(x) + " " + round(y) + "h" + round(w) + "v" +
      round(h) + "h" + round(-w) + "Z";
  }
  arc(x, y, r) { // whole circles alone are drawn
    const d = "a" + round(r) + " " + round(r) + " 0 1 0 ";
    this.path += "M" + round(x - r) + " " + round(y) + d + round(2 * r) + " 0" +
      d + round(-2 * r) + " 0Z";
  }
  clip() {
    const name = "c" + ++this.clips;
    this.put('<clipPath id="' + name + '"><path d="' + this.path +
      '"/></clipPath>');
    this.group('clip-path="url(#' + name + ')"');
  }
  fill() {
    if (this.at.fillStyle !== "transparent")
      this.put('<path fill="' + xml(this.at.fillStyle) + '" d="' + this.path +
        '"/>');
  }
  fillRect(x, y, w, h) {
    this.beginPath();
    this.rect(x, y, w, h);
    this.fill();
  }
  stroke() {
    const dash = this.at.dash.length ? '" stroke-dasharray="' +
      this.at.dash.join(" ") : "";
    this.put('<path fill="none" stroke="' + xml(this.at.strokeStyle) +
      '" stroke-width="' + this.at.lineWidth + dash + '" d="' + this.path +
      '"/>');
  }
  fillText(text, x, y) {
    const anchor = { left: "start", center: "middle", right: "end" };
    const down = { top: 0.8, middle: 0.35, bottom: -0.2, alphabetic: 0 };
    this.put('<text fill="' + xml(this.at.fillStyle) + '" text-anchor="' +
      anchor[this.at.textAlign] + '" x="' + round(x) + '" y="' +
      round(y + 12 * down[this.at.textBaseline]) + '">' + xml(text) +
      "</text>");
  }
}

// What is shown: the contact with its temperatures, or the curve of a study.
function drawPictures(canvasOf) {
  const root = document.documentElement, before = view;
  const drawn = [];
  const take = (canvas) => {
    const made = canvasOf(canvas.clientWidth, canvas.clientHeight);
    drawn.push(made);
    return made;
  };
  const pointed = state.pointed;
  root.classList.add("paper");
  readColours();
  state.pointed = null;
  try {
    view = { ...view, plot: take(view.plot),
      heat: view.heat && take(view.heat) };
    drawRun(view);
    drawHeat(view);
  } finally {
    root.classList.remove("paper");
    view = before;
    state.pointed = pointed;
    readColours();
    redraw();
  }
  return drawn;
}

function svgOfPicture() {
  const drawn = drawPictures((clientWidth, clientHeight) => {
    const context = new SvgContext();
    return { clientWidth, clientHeight, context, getContext: () => context };
  });
  const width = drawn[0].clientWidth;
  const height = drawn.reduce((sum, d) => sum + d.clientHeight, 0);
  let at = 0;
  const parts = drawn.map((d, k) => {
    const inside = d.context.out.join("\n").replace(/(id="|url\(#)c/g,
      "$1c" + k + "-");
    const part = '<g transform="translate(0 ' + at + ')">' + inside + "</g>";
    at += d.clientHeight;
    return part;
  });
  return '<svg xmlns="http://www.w3.org/2000/svg" width="' + width +
    '" height="' + height + '" viewBox="0 0 ' + width + " " + height +
    '" font-family="sans-serif" font-size="12" stroke-linejoin="round">\n' +
    '<rect width="100%" height="100%" fill="#fff"/>\n' + parts.join("\n") +
    "\n</svg>\n";
}

// Twice as fine as a plain screen at least.
function pngOfPicture() {
  const drawn = drawPictures((clientWidth, clientHeight) => {
    const canvas = document.createElement("canvas");
    for (const [name, value] of [["clientWidth", clientWidth],
      ["clientHeight", clientHeight]])
      Object.defineProperty(canvas, name, { value });
    return canvas;
  });
  const whole = document.createElement("canvas");
  whole.width = drawn[0].width;
  whole.height = drawn.reduce((sum, d) => sum + d.height, 0);
  const c = whole.getContext("2d");
  c.fillStyle = "#fff";
  c.fillRect(0, 0, whole.width, whole.height);
  let at = 0;
  for (const d of drawn) {
    c.drawImage(d, 0, at);
    at += d.height;
  }
  return new Promise((resolve) => whole.toBlob(resolve, "image/png"));
}
