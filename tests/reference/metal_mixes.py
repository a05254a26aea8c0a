#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic bodies with other models, compared with model.py and metal.py.

usage: metal_mixes.py fixed [EVERY] | random SEED COUNT

$OVERROLL runs each case and stores every step.  The model computes the same
times with its own discretization of the bodies, in elements of 1.4 and of 0.7
mesh sizes of the film.  While all stresses are far below yield, films and
pressures are equal except for the stopping tolerance.  For the whole run the
differences from the finer model are printed:

    P           maximum difference over nodes and steps, p_h
    H           difference relative to H, or to H_cen where H is smaller
    profile     maximum difference of the plastic displacement of the surface,
                relative to its maximum
    cumulative  root mean square difference of the accumulated plastic strain,
                relative to its root mean square
    residual_x, _y  the same for residual stresses

They refer to the bodies after the last step.  Maps begin at a depth of 2 D,
because none of the grids resolves a surface above steep strains.  The
difference between the two models is printed too, and is the maximum allowed
difference. Errors are of second order in mesh size and layers, with different
constants: for an error e D^2 the models differ by 1.5 e D^2, the finer one has
an error of 0.5 e D^2, and overroll, whose layers are one mesh size thick,
about e D^2.
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

from metal import Law, Metal
from mixes import band, dent, text_of, unknowns
from model import Layer, Model, Ramp

OVERROLL = os.environ.get("OVERROLL", "build/overroll")
E_BODY, NU = 206.0, 0.3
WINDOW = 1.6
COARSE, FINE = 1.4, 0.7    # element size relative to the mesh size of the film
NEAR = 0.8                 # all is elastic below this fraction of yield


class Yielding(Model):
    """A contact whose gap includes the plastic deformation of both bodies."""

    def __init__(self, case, metals):
        super().__init__(case)
        self.metals = metals
        self.found = None    # T, and gap at T with the present deformation

    def at(self, surface, T):
        """Returns X of the material's origin, the centre of its first
        feature."""
        sign = 0.5 if surface == 1 else -0.5
        start = next(f["start"] for f in self.c["features"]
                     if f["surface"] == surface)
        return start + self.speed.way(T) + sign * self.slid(T)

    def gap(self, T):
        if not self.found or self.found[0] != T:
            gap = super().gap(T)
            for surface, metal in self.metals.items():
                gap += metal.sinking(self.X - self.at(surface, T))
            self.found = T, gap
        return self.found[1]

    def flow(self, P, T):
        self.found = None
        return max(metal.flow(P, self.X, self.at(surface, T))
                   for surface, metal in self.metals.items())


def plastic(case):
    """Returns the lines of [plastic] in the case."""
    y = case["yields"]
    bodies = [] if "coats" in case else [
        f"[body {body}]\nmodulus = {E_BODY!r} GPa\npoisson = {NU!r}"
        for body in (1, 2)]
    lines = bodies + ["[stress]", f"surface = {y['surface']}", "traction = no",
              "[plastic]", f"surface = {y['surface']}",
              f"hardening = {y['law']}", f"yield = {y['Y']!r}",
              f"depth_max = {y['depth']!r}", "layers = 200",
              f"window = {-WINDOW!r}, {WINDOW!r}", "iterations = 1000"]
    if y["law"] == "swift":
        return lines + ["swift = 945 MPa, 20, 0.121"]
    return lines + [f"modulus = {y['modulus']!r}"]


def law_of(y, unit):
    """Returns the hardening law in the units of the model. `unit` is the
    strain p_h/E*."""
    if y["law"] != "swift":
        return Law(y["law"], y["Y"], y["modulus"] * unit)
    # Y = B (C + microstrain)^n at zero strain
    C, n = 20e-6 / unit, 0.121
    return Law("swift", y["Y"], swift=(y["Y"] / C**n, C, n))


def run(case):
    """Runs the program. Returns snapshots by name, and the plastic state of
    each surface by its number."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "a.ini")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text_of(dict(case, more=plastic(case)), folder))
        done = subprocess.run([OVERROLL, "run", path, "-q"], text=True,
                              capture_output=True)
        if done.returncode:
            raise RuntimeError(f"exit code {done.returncode}: "
                               f"{done.stderr.strip()[-400:]}")
        with h5py.File(os.path.join(folder, "a.h5")) as f:
            g = f["snapshots"] if "snapshots" in f else f
            out = {name: np.array(g[name], dtype=float) for name in g
                   if isinstance(g[name], h5py.Dataset)}
            for name, g in f["plastic"].items():
                out[int(name[-1])] = {key: np.array(g[key]) for key in g} | \
                    dict(g.attrs)
    return out


def metals(case, out, share):
    """Returns the bodies with elements of `share` mesh sizes of the film."""
    y = case["yields"]
    D = (case.get("outlet", 1.5) - case.get("inlet", -4)) / \
        (7 * 2**case["level"])
    found = {}
    for surface in (1, 2):
        if surface not in out:
            continue
        where = {"half_width": y.get("half_width")}
        if not where["half_width"]:
            xi = out[surface]["material"]
            half = (xi[1] - xi[0]) / 2
            where = {"window": (xi[0] - half, xi[-1] + half, xi[0])}
        found[surface] = Metal(
            NU, law_of(y, float(out[surface]["strain_unit"])), share * D,
            0.8 * share * D, 1 + 0.1 * share, y["depth"], **where)
    return found


def march(case, out, share):
    """Returns P and H of all steps, the number of steps far below yield, and
    the bodies at the last step."""
    if "coats" in case:
        case = dict(case, layers=[(0.5, Layer(d, E, nu, E_BODY, NU))
                                  for d, E, nu in case["coats"].values()])
    model = Yielding(case, metals(case, out, share))
    P_all, H_all, near = [], [], []
    for k, state in enumerate(model.march(
            lambda k: unknowns(model, out, k), out["time"])):
        P, bears, H = state[:3]
        P_all.append(P)
        H_all.append(H)
        if k + 1 < len(out["time"]):
            near.append(model.flow(P + bears, out["time"][k]))
    elastic = next((k for k, share in enumerate(near) if share > NEAR), -1)
    return np.array(P_all), np.array(H_all), elastic, model.metals


def over_film(a, H):
    """Returns a divided by H, or by H_cen where H is smaller."""
    return np.abs(a) / np.maximum(H, H[:, [H.shape[1] // 2]])


def laid(theirs, name, metal):
    """Interpolates a map of the program to the centres of the elements."""
    xi, z = theirs["material"], theirs["depth"]
    rows = np.array([np.interp(metal.mid, xi, row) for row in theirs[name]])
    return np.array([np.interp(metal.depth, z, column)
                     for column in rows.T]).T


def maps(metal, unit):
    """Returns plastic strains and residual stresses by their names in
    files."""
    s = metal.whole(metal.residual(metal.e), metal.e)
    return {"cumulative": metal.all * unit, "residual_x": s[..., 0],
            "residual_y": s[..., 1]}


def apart(a, b, metal, from_depth):
    """Returns the root mean square difference relative to that of b, from a
    depth downward."""
    area = np.where(metal.depth > from_depth, metal.thick, 0)[:, None]
    return math.sqrt(((a - b)**2 * area).sum() / (b * b * area).sum())


def between(coarse, fine, name, unit):
    """Interpolates a map of the coarse model to the elements of the fine
    one."""
    a = {"material": coarse.mid, "depth": coarse.depth,
         name: maps(coarse, unit)[name]}
    return laid(a, name, fine)


def compared(case):
    """Returns, by name, the difference between program and finer model, and
    between both models, also before the first plastic flow."""
    out = run(case)
    P, H = out["pressure"], out["film_thickness"]
    P1, H1, _, coarse = march(case, out, COARSE)
    P2, H2, first, fine = march(case, out, FINE)
    start = slice(0, first + 1)
    elastic = max(np.abs(P - P2)[start].max(),
                  over_film(H - H2, H2)[start].max())
    found = {"P": (np.abs(P - P2).max(), np.abs(P1 - P2).max()),
             "H": (over_film(H - H2, H2).max(), over_film(H1 - H2, H2).max())}
    # neither model resolves the uppermost layers
    shallow = 2 * fine[next(iter(fine))].h / FINE
    for surface, metal in fine.items():
        theirs, other = out[surface], coarse[surface]
        if not metal.all.any() or not other.all.any():
            raise RuntimeError(f"too little flows in surface {surface}")
        unit = float(theirs["strain_unit"])
        xi = theirs["material"]
        w = metal.sinking(xi)
        sunk = theirs["profile_before"] - theirs["profile_after"]
        most = np.abs(w).max()
        found[f"profile {surface}"] = (
            np.abs(sunk - w).max() / most,
            np.abs(other.sinking(xi) - w).max() / most)
        for name, a in maps(metal, unit).items():
            found[f"{name} {surface}"] = (
                apart(laid(theirs, name, metal), a, metal, shallow),
                apart(between(other, metal, name, unit), a, metal, shallow))
    return elastic, found


BASE = dict(M=20.0, L=10.0, level=5, step=0.05, end=1.6, tolerance=3e-10,
            features=[dent(1, -0.15, 0.8, -1.4)])
LINEAR = dict(surface=1, law="linear", Y=0.6, modulus=5.0, depth=0.55,
              half_width=0.75)
# The smooth contact deforms plastically if the yield stress is below 0.56 p_h.
SMOOTH = dict(law="linear", Y=0.52, modulus=5.0, depth=1.4)
FIXED = {
    "linear hardening, eyring, slip, load": dict(
        BASE, slide=0.3, eyring=0.3, load=Ramp(1.0, 1.15, 0.1, 0.9),
        yields=LINEAR),
    "kinematic hardening of surface 2, conserved oil, speed": dict(
        BASE, slide=-0.3, conserving=True, speed=Ramp(1.0, 0.8, 0.2, 0.9),
        features=[dent(2, -0.15, 0.8, -1.4)],
        yields=dict(LINEAR, surface=2, law="kinematic", modulus=60.0)),
    "both yield by swift's law, radius": dict(
        BASE, radius=Ramp(1.0, 1.1, 0.1, 0.9),
        features=[dent(1, -0.1, 0.8, -1.4), dent(2, -0.07, 0.8, -1.3)],
        yields=dict(LINEAR, surface="both", law="swift")),
    "a smooth contact yields, linear hardening, slip": dict(
        BASE, level=4, step=0.1, end=1.5, slide=0.2,
        features=[dent(1, -0.02, 0.8, -1.5)],
        yields=dict(SMOOTH, surface=1)),
    "swift's law below a body with a layer, starved": dict(
        BASE, coats={2: (0.2, 120.0, 0.35)}, conserving=True,
        film=(0.04, 0.03), yields=dict(LINEAR, law="swift")),
}


def drawn(seed):
    """Draws a random case. In three of four cases bumps deform plastically and
    the smooth contact does not (yield stress from 0.56 p_h on); elements are
    placed around the bump."""
    r = random.Random(seed)

    def ramp(low, high, first=1.0):
        return Ramp(first, r.uniform(low, high), r.uniform(0, 0.3),
                    r.uniform(0.4, 0.9))
    surface = r.choice([1, 2])
    width = r.uniform(0.7, 1.0)
    case = dict(BASE, M=math.exp(r.uniform(math.log(15), math.log(50))),
                L=r.uniform(8, 12), slide=r.uniform(-0.4, 0.4))
    # the pressure that flattens a bump is 2 pi/width times its height
    case["features"] = [dent(surface, -r.uniform(1.0, 1.3) * width / 6, width,
                             -1.4)]
    case["yields"] = dict(LINEAR, surface=surface, Y=r.uniform(0.6, 0.7),
                          law=r.choice(["linear", "kinematic", "swift"]),
                          modulus=math.exp(r.uniform(1.4, 4.1)))
    if r.random() < 0.25:
        case.update(level=4, step=0.1, features=[dent(surface, -0.02, width,
                                                      -1.5)])
        case["yields"] = dict(SMOOTH, surface=surface, Y=r.uniform(0.5, 0.53),
                              law=r.choice(["linear", "kinematic"]),
                              modulus=math.exp(r.uniform(1.4, 4.1)))
    if r.random() < 0.6:
        case["eyring"] = math.exp(r.uniform(math.log(0.1), 0))
    if r.random() < 0.3:
        case["conserving"] = True
    if r.random() < 0.4:
        case["load"] = ramp(0.9, 1.2)
    if r.random() < 0.3:
        case["speed"] = ramp(0.8, 1.2)
    if r.random() < 0.3:
        case["radius"] = ramp(0.9, 1.2)
    return case


def report(name, case):
    """Prints the differences and returns true if they are within the band."""
    begun = time.process_time()
    try:
        elastic, found = compared(case)
        right = elastic < band(case) and \
            all(off < most for off, most in found.values())
        text = f"elastic {elastic:.0e}, " + ", ".join(
            f"{'' if off < most else '! '}{key} {off:.1e} of {most:.1e}"
            for key, (off, most) in found.items())
    except (RuntimeError, ArithmeticError) as why:
        text, right = str(why), False
    print(f"{'  ' if right else '! '}{name}: {text} "
          f"({time.process_time() - begun:.0f} s)", flush=True)
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
