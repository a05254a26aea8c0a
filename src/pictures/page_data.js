/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The data of the page: base64, inflate, differences, levels.  pack.h says how
 * it was made.  The page is data, draw, areal, heat, stress, element and play, in
 * this order, in one function.
 */
function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// The browser inflates, which it does while other things go on.
async function inflate(from, size) {
  const stream = new Blob([from]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  const to = new Uint8Array(await new Response(stream).arrayBuffer());
  if (to.length !== size) throw new Error("damaged data");
  return to;
}

// A field: levels, as differences from what the neighbours in x and in time
// foretell, low bytes first, then high bytes.  Level to value: a table.
async function fieldOf(made, nodes, shots) {
  const n = nodes * shots, bytes = await inflate(bytesOf(made.data), 2 * n);
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

async function runOf(made) {
  const run = { made, nodes: made.nodes, shots: made.snapshots };
  run.x = doublesOf(made.x);
  run.time = doublesOf(made.time);
  if (made.hertz) run.hertz = doublesOf(made.hertz);
  for (const name of ["P", "H", "S", "F", "T1", "T2", "T3", "C"])
    if (made[name]) run[name] = await fieldOf(made[name], run.nodes, run.shots);
  if (made.areal) run.areal = await arealOf(made.areal);
  if (made.stress) run.stress = await stressOf(made.stress, run.shots);
  if (made.material) run.material = materialOf(made.material);
  if (made.element) run.element = elementOf(made.element);
  run.history = {};
  for (const name of ["time", "H_min", "H_cen", "P_max"])
    if (made.history[name]) run.history[name] = doublesOf(made.history[name]);
  return run;
}
