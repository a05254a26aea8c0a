/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Temperatures under pressure and film, in degC: of both surfaces and of the
 * middle of the film, on one scale for the whole run.
 */
const ZERO_DEGC = 273.15; // K
const warm = [["T1", "surface 1", "surf. 1", "pressure"],
  ["T2", "surface 2", "surf. 2", "warm-2"],
  ["T3", "middle of the film", "middle", "min"]];

const isWarm = (run) => warm.some(([name]) => run[name]);
const degC = (run, name, k, i) => run[name].at(k, i) - ZERO_DEGC;

function warmRange() {
  let low = Infinity, high = -Infinity;
  for (const run of runs)
    for (const [name] of warm) {
      if (!run[name]) continue;
      low = Math.min(low, run[name].value[0]);
      high = Math.max(high, run[name].value[run[name].value.length - 1]);
    }
  const margin = Math.max(0.06 * (high - low), 0.1);
  return { y0: low - margin - ZERO_DEGC, y1: high + margin - ZERO_DEGC };
}

function drawHeat(view) {
  if (!view.heat) return;
  const { c, width, height } = prepare(view.heat);
  const run = view.run, k = shotOf(run), { u, w, a, b } = view.layout;
  const { y0, y1 } = warmRange();
  const axes = { x0: w.x0 * u.x.f, x1: w.x1 * u.x.f, y0, y1, from: y0,
    yName: "temperature, T (\u00b0C)" };
  const box = boxOf(58, 22, width - 68, height - 30, axes);
  const shown = warm.filter(([name]) => run[name]);
  drawAxes(c, box, axes);
  clipped(c, box, () => {
    for (const [name, , , line] of shown)
      drawCurve(c, box, run, a, b, u.x.f, (i) => degC(run, name, k, i),
        { line: colour[line], width: 2 });
  });
  drawLegend(c, box, shown.map(([, name, brief, line]) =>
    [name, colour[line], false, brief]));
  if (!state.pointed) return;
  const i = nodeAt(run, state.pointed.x);
  drawCross(c, run.x[i] * u.x.f, [box], shown.map(([name, , , line]) =>
    [box, degC(run, name, k, i), colour[line]]));
}

// "surface 1 92.64, surface 2 94.42, middle of the film 101.9 °C"
function saidHeat(run, k, i) {
  return warm.filter(([name]) => run[name]).map(([name, what]) =>
    what + " " + digits(degC(run, name, k, i))).join(", ") + " \u00b0C";
}
