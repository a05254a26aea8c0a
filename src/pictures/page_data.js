/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The data of the page: base64, inflate, differences, levels.  pack.h says how
 * it was made.  The page is data, draw and play, in this order, in one function.
 */
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
