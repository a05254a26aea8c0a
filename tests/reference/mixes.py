#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Combinations of physical models, compared with the independent model.py.

usage: mixes.py fixed [EVERY] | random SEED COUNT

$OVERROLL runs each case and stores every step; the model computes the same
times.  The maximum differences over all nodes and steps are printed: of P in
p_h, and of H relative to H, or to H_cen where H is smaller.

Both have the same discrete equations.  The remaining differences are the
stopping tolerance (1e-11 of the flow), rounding, and approximations of the
program: elastic layers by images (one layer: within 1e-9 of A, `check` prints
the error), and Carreau's model by its table (at most 1e-3 of the flow).  The
deformation integrals have order 16 and range 32, which are exact on these
grids.
"""
import math
import os
import random
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

from model import Layer, Model, Ramp

OVERROLL = os.environ.get("OVERROLL", "build/overroll")


def text_of(case, folder):
    """Returns the text of the case file."""
    conserving = "film" in case or case.get("conserving")
    lines = [f"[contact]\nM = {case['M']!r}\nL = {case['L']!r}",
             f"slide_to_roll = {case.get('slide', 0.0)!r}",
             "[domain]", f"level = {case['level']}", "order = 2", "faces = gap",
             f"inlet = {case.get('inlet', -4.0)!r}",
             f"outlet = {case.get('outlet', 1.5)!r}",
             "[time]", f"scheme = {case.get('scheme', 'upstream2')}",
             f"end = {case['end']!r}", f"step = {case['step']!r}",
             "[solver]", f"tolerance = {case.get('tolerance', 1e-11)!r}",
             "[paper]", "mlmi_order = 16", "mlmi_range = 32",
             "[output]", f"file = {folder}/a.h5", "every = 1",
             "fields = pressure, film_thickness"
             + (", oil_content" if conserving else "")]
    if case.get("eyring"):
        lines += ["[lubricant]", "rheology = eyring",
                  f"eyring_number = {case['eyring']!r}"]
    if case.get("boundary"):
        a1, decay, layer, layer_decay = case["boundary"]
        lines += ["[boundary]", "law = exponential", f"amplitude = {a1!r}",
                  f"decay = {decay!r}", f"layer = {layer!r}"]
        lines += [f"layer_decay = {layer_decay!r}"] if layer else []
    if case.get("coats"):
        lines += ["[contact]", "scale = substrate"]
        for body in (1, 2):
            lines += [f"[body {body}]", "modulus = 206 GPa", "poisson = 0.3"]
        for body, (d, E, nu) in case["coats"].items():
            lines += [f"[coating {body}]", f"thickness = {d!r}",
                      f"modulus = {E!r} GPa", f"poisson = {nu!r}"]
    if case.get("carreau"):
        lines += ["[lubricant]", "rheology = carreau", "carreau_form = stress",
                  f"carreau_number = {case['carreau'][0]!r}",
                  f"carreau_n = {case['carreau'][1]!r}"]
    if conserving:
        lines += ["[cavitation]", "model = conserving"]
    if "film" in case:
        lines += ["[supply]", "model = film",
                  f"thickness_1 = {case['film'][0]!r}",
                  f"thickness_2 = {case['film'][1]!r}"]
    for name in ("load", "speed", "sliding", "radius"):
        if name in case:
            lines += [f"[{name}]", case[name].lines()]
    if "radius" in case:
        lines += ["curvature = " + ("rides" if case.get("rides")
                                    else "imposed")]
    for k, f in enumerate(case.get("features", [])):
        kind, size = ("dent", "depth") if f["depth"] > 0 else ("bump", "height")
        lines += [f"[feature f{k}]", f"shape = {kind}",
                  f"surface = {f['surface']}", f"{size} = {abs(f['depth'])!r}",
                  f"width = {f['width']!r}", f"start = {f['start']!r}"]
    return "\n".join(lines + case.get("more", [])) + "\n"


def run(case):
    """Runs the program and returns times, P, H and q."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "a.ini")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text_of(case, folder))
        done = subprocess.run([OVERROLL, "run", path, "-q"], text=True,
                              capture_output=True)
        if done.returncode:
            raise RuntimeError(f"exit code {done.returncode}: "
                               f"{done.stderr.strip()[-400:]}")
        with h5py.File(os.path.join(folder, "a.h5")) as f:
            g = f["snapshots"] if "snapshots" in f else f
            out = {name: np.array(g[name], dtype=float) for name in g
                   if isinstance(g[name], h5py.Dataset)}
    return out


def unknowns(model, out, k):
    """Returns the model's unknowns from the program's snapshot, used only as
    an initial guess."""
    P, H = out["pressure"][k], out["film_thickness"][k]
    x = P[1:-1].copy()
    if model.conserving:
        full = model.rho(P) * H
        x -= np.where(P > 0, 0, full - out["oil_content"][k])[1:-1]
    parts = [x]
    total = P
    if model.wall:
        parts.append(model.touching(H)[1:-1])
        total = P + np.concatenate([[0], parts[1], [0]])
    T = out["time"][k]
    H0 = (H - model.gap(T) + model.K @ total)[model.n // 2]
    return np.concatenate(parts + [[H0]])


def apart(case):
    """Returns the maximum differences of P and of H relative to H_cen."""
    out = run(case)
    if "coats" in case:
        case["layers"] = [(0.5, Layer(d, E, nu, 206.0, 0.3))
                          for d, E, nu in case["coats"].values()]
    model = Model(case)
    worst_P = worst_H = 0.0
    for k, state in enumerate(model.march(
            lambda k: unknowns(model, out, k), out["time"])):
        P, bears, H = state[:3]
        worst_P = max(worst_P, np.abs(out["pressure"][k] - P).max())
        # H is large downstream of the constriction: relative error
        worst_H = max(worst_H, (np.abs(out["film_thickness"][k] - H) /
                                np.maximum(H, H[model.n // 2])).max())
        if os.environ.get("MIXES"):
            print(k, out["time"][k], worst_P, worst_H)
    return worst_P, worst_H


def dent(surface=1, depth=0.03, width=0.8, start=-2.0):
    return dict(surface=surface, depth=depth, width=width, start=start)


SMOOTH = dict(M=20.0, L=10.0, level=4, end=1.5, step=0.05)
WIDE = dict(SMOOTH, inlet=-4.0, outlet=4.0)
FIXED = {
    "eyring, conserved oil, dent, slip, load": dict(
        SMOOTH, slide=0.5, eyring=0.3, conserving=True,
        load=Ramp(1.0, 1.3, 0.1, 0.9), features=[dent()]),
    "eyring, starved, dents on both, slip, load": dict(
        SMOOTH, slide=0.5, eyring=0.3, conserving=True, film=(0.04, 0.02),
        load=Ramp(1.0, 0.8, 0.2, 0.9),
        features=[dent(), dent(2, 0.02, 0.7, -1.4)]),
    "load, radius and speed, dent": dict(
        SMOOTH, slide=-0.6, load=Ramp(1.0, 1.4, 0.1, 0.8),
        speed=Ramp(1.0, 0.7, 0.1, 0.7), radius=Ramp(1.0, 1.3, 0.0, 0.9),
        features=[dent()]),
    "a radius that rides, eyring, load, dent": dict(
        SMOOTH, slide=0.4, eyring=0.5, rides=True,
        radius=Ramp(1.0, 1.05, 0.0, 1.2), load=Ramp(1.0, 1.2, 0.0, 1.0),
        features=[dent(2)]),
    "sliding through zero, unequal layers of oil, eyring, load": dict(
        SMOOTH, sliding=Ramp(1.0, -0.8, 0.0, 1.2), eyring=0.3,
        conserving=True, film=(0.045, 0.015), load=Ramp(1.0, 1.3, 0.1, 0.7),
        features=[dent()]),
    "speed and sliding through zero, eyring, dent": dict(
        WIDE, end=2.0, sliding=Ramp(0.5, -0.5, 0.0, 1.0), eyring=0.3,
        speed=Ramp(1.0, -0.8, 0.1, 1.5), features=[dent()]),
    "first order, eyring, load, dent": dict(
        SMOOTH, scheme="upstream1", slide=0.5, eyring=0.4,
        load=Ramp(1.0, 1.3, 0.1, 0.9), features=[dent()]),
    "surfaces that touch, boundary layer, eyring, load, dent": dict(
        SMOOTH, slide=0.5, eyring=0.3, boundary=(3.0, 0.02, 0.01, 0.003),
        load=Ramp(1.0, 1.3, 0.1, 0.7), features=[dent()]),
    "coated bodies, eyring, load, dent": dict(
        SMOOTH, slide=0.4, eyring=0.3, coats={1: (0.3, 400.0, 0.2),
                                              2: (0.2, 80.0, 0.35)},
        load=Ramp(1.0, 1.3, 0.1, 0.9), features=[dent()]),
    "carreau, load, dent": dict(
        SMOOTH, end=0.6, slide=0.5, carreau=(0.3, 0.5),
        load=Ramp(1.0, 1.2, 0.0, 0.6), features=[dent()]),
}


def drawn(seed):
    """Draws a random case without physical models that cannot be combined."""
    r = random.Random(seed)

    def ramp(low, high, first=1.0):
        return Ramp(first, r.uniform(low, high), r.uniform(0, 0.3),
                    r.uniform(0.4, 0.9))
    case = dict(M=math.exp(r.uniform(math.log(6), math.log(60))),
                L=r.uniform(3, 12), level=4, step=r.choice([0.025, 0.05, 0.08]),
                end=1.2, slide=r.uniform(-1.5, 1.5))
    touches = r.random() < 0.2
    if r.random() < 0.6 or touches:
        case["eyring"] = math.exp(r.uniform(math.log(0.1), 0))
    if not touches and r.random() < 0.4:
        case["conserving"] = True
        if r.random() < 0.5:
            film = r.uniform(0.2, 0.8) * 1.3 * case["M"]**-0.12 * \
                case["L"]**0.75 * math.pi / (8 * case["M"])
            part = r.uniform(0.2, 0.8)
            case["film"] = (film * part, film * (1 - part))
            case["slide"] = r.uniform(-0.6, 0.6)
    elif r.random() < 0.25:
        case.update(outlet=4.0, speed=ramp(-1.0, -0.3))
    if "speed" not in case and "film" not in case and r.random() < 0.4:
        case["speed"] = ramp(0.6, 1.5)
    if r.random() < 0.5:
        case["load"] = ramp(0.7, 1.4)
    if r.random() < 0.3:
        case["radius"] = ramp(0.8, 1.3)
    if r.random() < 0.3:
        case["sliding"] = ramp(-1.0, 1.0, case["slide"])
    if r.random() < 0.2 and "conserving" not in case:
        case["scheme"] = "upstream1"
    if touches:
        decay = r.uniform(0.1, 0.5) / case["M"]
        case["boundary"] = (r.uniform(0.5, 5), decay, 0.0, 0.0)
    if r.random() < 0.3:
        case["coats"] = {body: (r.uniform(0.1, 1), r.uniform(70, 450),
                                r.uniform(0.15, 0.4))
                         for body in r.sample([1, 2], r.choice([1, 2]))}
    case["features"] = [
        dent(r.choice([1, 2]), r.uniform(-0.1, 0.5) / case["M"],
             r.uniform(0.6, 1.2), r.uniform(-2.5, -1.2))
        for _ in range(r.choice([0, 1, 1, 2]))]
    return case


def band(case):
    """Returns the allowed difference: approximations of the program (see
    above), or the stopping tolerance."""
    if case.get("carreau"):
        return 1e-3
    return 1e-7 if case.get("coats") else 1e-9


def report(name, case):
    """Prints the differences and returns true if they are within the band."""
    begun = time.process_time()
    try:
        P, H = apart(case)
        found = f"P within {P:.1e}, H {H:.1e}"
        right = max(P, H) < band(case)
    except (RuntimeError, ArithmeticError) as why:
        found, right = str(why), False
    print(f"{'  ' if right else '! '}{name}: {found} "
          f"({time.process_time() - begun:.1f} s)", flush=True)
    return right


def main(arguments):
    if arguments[:1] == ["random"]:
        seed, count = int(arguments[1]), int(arguments[2])
        print(f"seeds {seed} to {seed + count - 1}")
        mixes = {f"seed {s}": drawn(s) for s in range(seed, seed + count)}
    else:
        every = int(arguments[1]) if len(arguments) > 1 else 1
        mixes = dict(list(FIXED.items())[every - 1::every])
    wrong = [name for name, case in mixes.items() if not report(name, case)]
    if wrong:
        raise SystemExit(f"{len(wrong)} of {len(mixes)} differ")


if __name__ == "__main__":
    main(sys.argv[1:])
