#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hot films in time, compared with the independent model of hot.py.

usage: hot_mixes.py fixed [EVERY] | random SEED COUNT

$OVERROLL runs each case with steps of D and stores all steps; the model
computes the same times.  The maximum differences over the run are printed: of
P in p_h; of H relative to H, or to H_cen where H is smaller; of the friction
coefficient; of the temperatures of film and surfaces.  Temperatures are
compared at pressures above 0.05 p_h, because both models are inaccurate for
backflow out of the inlet.  They are relative to the maximum rise, but at least
to 5 K: a film that hardly slides is heated and cooled by compression within a
few nodes. The first steps are omitted, because the temperatures of the steady
starts differ (overroll: first order in D, model: second order).

The model's film is exact.  The remaining difference is of first order in D and
dT (departure points, lag, a steady start without backflow; at level 5 it is
half of that at level 4).  It includes overroll's approximation for sliding and
pressure gradient that thin a film of nonuniform temperature: 2e-3 of p_h and
5e-4 of the film thickness.  Cases with `dowson` have this approximation in the
model too.
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

from hot import Hot
from mixes import dent
from model import Ramp

OVERROLL = os.environ.get("OVERROLL", "build/overroll")
INLET, OUTLET = -4.0, 1.5
E_STEEL = 206e9 / (1 - 0.3**2)     # E' of two steel bodies
STEEL = (46.0, 460.0, 7850.0)
OIL = (0.14, 2000.0, 870.0)

# Maximum differences of P, H, friction and temperatures, of first order in D =
# 0.025 b. Random contacts have shorter inlets and steeper dents.
BAND = np.array([2e-2, 5e-3, 5e-3, 2.5e-2])


def mesh(case):
    return (OUTLET - INLET) / (7 * 2**case["level"])


def text_of(case, folder):
    """Returns the text of the case file."""
    given = case["physical"]
    lines = ["[contact]", f"load = {given['load']!r} N/m",
             f"radius = {given['radius']!r} m",
             *([] if "coat" in given else
               [f"modulus = {given['modulus']!r} Pa"]),
             f"viscosity = {given['viscosity']!r} Pa.s",
             f"alpha = {given['alpha']!r} 1/Pa",
             f"speed_1 = {given['speed_1']!r} m/s",
             f"speed_2 = {given['speed_2']!r} m/s",
             "[domain]", f"level = {case['level']}", "order = 2", "faces = gap",
             f"inlet = {INLET!r}", f"outlet = {OUTLET!r}",
             "[time]", "scheme = upstream2", f"step = {mesh(case)!r}",
             f"end = {case['end']!r}",
             "[lubricant]", "rheology = eyring",
             f"eyring_stress = {given['eyring_stress']!r} Pa",
             "[cavitation]", "model = conserving",
             "[heat]", "model = lobatto", "points = 7",
             f"temperature = {given['temperature']!r} K",
             "[solver]", "tolerance = 1e-11",
             "[output]", f"file = {folder}/a.h5", "every = 1",
             "fields = pressure, film_thickness, oil_content, "
             "temperature_1, temperature_2, temperature_middle"]
    if "coat" in given:
        lines += ["[contact]", "scale = substrate"]
        for body in (1, 2):
            lines += [f"[body {body}]", "modulus = 206 GPa", "poisson = 0.3"]
    for body, (d, k, c, rho) in given.get("coat", {}).items():
        lines += [f"[coating {body}]",
                  f"thickness = {d!r} m", "modulus = 206 GPa", "poisson = 0.3",
                  f"conductivity = {k!r} W/m.K",
                  f"heat_capacity = {c!r} J/kg.K", f"density = {rho!r} kg/m3"]
    if "arriving" in case:
        lines += ["[supply]", "model = film",
                  f"thickness_1 = {case['arriving'][0]!r} m",
                  f"thickness_2 = {case['arriving'][1]!r} m"]
    if "load" in case:
        lines += ["[load]", case["load"].lines()]
    for k, f in enumerate(case.get("features", [])):
        kind, size = ("dent", "depth") if f["depth"] > 0 else ("bump", "height")
        lines += [f"[feature f{k}]", f"shape = {kind}",
                  f"surface = {f['surface']}", f"{size} = {abs(f['depth'])!r}",
                  f"width = {f['width']!r}", f"start = {f['start']!r}"]
    return "\n".join(lines) + "\n"


def run(case):
    """Runs the program and returns its results, dimensionless, with
    temperature rises."""
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
            out = {name: np.array(f[name]) / f[name].attrs["scale"]
                   for name in f if isinstance(f[name], h5py.Dataset)}
            out["mu"] = np.array(
                f["history/sliding_friction_coefficient"])
    for name in ("temperature_1", "temperature_2", "temperature_middle"):
        out[name] = out[name] - case["physical"]["temperature"]
    return out


def unknowns(model, out, k):
    """Returns the model's unknowns from the program's snapshot, used only as
    an initial guess."""
    P, H = out["pressure"][k], out["film_thickness"][k]
    x = P[1:-1].copy()
    x -= np.where(P > 0, 0, model.rho(P) * H - out["oil_content"][k])[1:-1]
    H0 = (H - model.gap(out["time"][k]) + model.K @ P)[model.n // 2]
    return np.append(x, H0)


def apart(case):
    """Returns the maximum differences of P, H, friction and temperatures."""
    out = run(case)
    model = Hot(case)
    centre = np.argmin(np.abs(model.X))
    worst = np.zeros(4)
    for k, (P, H, T, mu) in enumerate(model.march(
            lambda k: unknowns(model, out, k), out["time"])):
        found = [np.abs(out["pressure"][k] - P).max(),
                 (np.abs(out["film_thickness"][k] - H) /
                  np.maximum(H, H[centre])).max(),
                 abs(mu / abs(out["mu"][k]) - 1),
                 max(np.abs(out[name][k] - t)[P > 0.05].max() for name, t in
                     (("temperature_1", T[0]), ("temperature_2", T[-1]),
                      ("temperature_middle", T[8]))) / max(T.max(), 5.0)]
        if k < 4:
            found[3] = 0
        worst = np.maximum(worst, found)
        if os.environ.get("MIXES"):
            print(k, *(f"{v:.1e}" for v in found), f"{T.max():.2f} K")
    return worst


BASE = dict(level=5, end=0.8, conserving=True, physical=dict(
    load=120e3, radius=0.01, modulus=226e9, viscosity=0.02, alpha=20e-9,
    speed_1=12.0, speed_2=8.0, eyring_stress=5e6, oil=OIL, body=[STEEL, STEEL],
    temperature=353.0, expansion=6.5e-4, S0=1.1))
FIXED = {
    "heat, eyring, starved, dent": dict(
        BASE, arriving=(300e-9, 250e-9), features=[dent(1, 0.02, 0.8, -1.5)]),
    "the same film, thinned alike": dict(
        BASE, arriving=(300e-9, 250e-9), features=[dent(1, 0.02, 0.8, -1.5)],
        dowson=True),
    "heat, eyring, starved, load, dent on the slower surface": dict(
        BASE, arriving=(200e-9, 300e-9), load=Ramp(1.0, 1.3, 0.1, 0.9),
        features=[dent(2, 0.02, 0.8, -1.5)]),
    "heat in a layer, eyring, starved, dent": dict(
        BASE, physical=dict(
            BASE["physical"], modulus=E_STEEL,
            coat={1: (2e-6, 1.5, 1000.0, 2000.0),
                  2: (5e-6, 5.0, 800.0, 5000.0)}),
        arriving=(300e-9, 250e-9), features=[dent(1, 0.02, 0.8, -1.5)]),
    "heat, eyring, flooded, load, dent": dict(
        BASE, load=Ramp(1.0, 0.8, 0.1, 0.9),
        features=[dent(1, 0.02, 0.8, -1.5)]),
}


def drawn(seed):
    """Draws a random case whose surfaces move fast in the same direction."""
    r = random.Random(seed)
    um, slip = r.uniform(8, 15), r.uniform(-0.6, 0.6)
    case = dict(BASE, physical=dict(
        BASE["physical"], load=r.uniform(80e3, 250e3),
        viscosity=math.exp(r.uniform(math.log(0.01), math.log(0.03))),
        eyring_stress=r.uniform(3e6, 8e6), speed_1=um * (1 + slip / 2),
        speed_2=um * (1 - slip / 2)))
    if r.random() < 0.7:
        case["arriving"] = (r.uniform(100e-9, 300e-9),
                            r.uniform(100e-9, 300e-9))
    if r.random() < 0.5:
        case["load"] = Ramp(1.0, r.uniform(0.7, 1.3), r.uniform(0, 0.3),
                            r.uniform(0.5, 0.9))
    case["features"] = [dent(r.choice([1, 2]), r.uniform(0.005, 0.03),
                             r.uniform(0.6, 1.2), r.uniform(-2, -1.2))]
    return case


def report(name, case, band):
    """Prints the differences and returns true if they are within the band."""
    begun = time.process_time()
    try:
        worst = apart(case)
        found = "P {:.1e}, H {:.1e}, friction {:.1e}, T {:.1e}".format(*worst)
        right = (worst < band).all()
    except (RuntimeError, ArithmeticError) as why:
        found, right = str(why), False
    print(f"{'  ' if right else '! '}{name}: {found} "
          f"({time.process_time() - begun:.1f} s)", flush=True)
    return right


def main(arguments):
    every = int(arguments[1]) if len(arguments) == 2 else 1
    cases, band = dict(list(FIXED.items())[every - 1::every]), BAND
    if arguments[:1] == ["random"]:
        seed, count = int(arguments[1]), int(arguments[2])
        print(f"seeds {seed} to {seed + count - 1}")
        cases = {f"seed {s}": drawn(s) for s in range(seed, seed + count)}
        band = 2 * BAND
    wrong = [name for name, case in cases.items()
             if not report(name, case, band)]
    if wrong:
        raise SystemExit(f"{len(wrong)} of {len(cases)} differ")


if __name__ == "__main__":
    main(sys.argv[1:])
