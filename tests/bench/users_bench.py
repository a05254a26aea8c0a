#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Accuracy per CPU second of twelve cases as users have them.

usage: users_bench.py [FOLDER] [CASE...]

Each is run on level after level, all else by default, and compared with the
level two above the last (one of a cam, whose turn is long): errors of the
central film, the smallest film, the coefficient of sliding friction and the
rise of temperature, in runs their root mean square over time relative to the
mean; CPU seconds are those of the whole process, files and start included.  The
default's point, level 8, is marked *; beside the table stands what a central
film right to 1e-3 costs at least, by a line in logarithms between two levels.
Writes users.json and users.md.
"""
import bisect
import csv
import io
import json
import math
import os
import resource
import subprocess
import sys
import tempfile

OVERROLL = os.path.abspath(os.environ.get("OVERROLL", "build/overroll"))
DEFAULT = 8
ASKED = 1e-3

STEEL = """[contact]
hertz_pressure = 1 GPa
radius = 12 mm
modulus = 226 GPa
mean_speed = 3 m/s
slide_to_roll = {slip}
[lubricant]
viscosity = 30 mPa.s
alpha = 18 1/GPa
rheology = eyring
eyring_stress = 5 MPa
limiting_shear = 0.08
"""
DENT = """[feature d]
shape = dent
depth = 0.4 um
width = 0.6
start = -3
"""
ROUGH = """[feature g{k}]
surface = {k}
shape = roughness
Rq = 0.05 um
length = 10
shortest = 0.25
seed = {k}
start = 2
grow = 1
"""
WARM = "[heat]\nmodel = lobatto\ntemperature = 60 degC\n"
OIL = STEEL[STEEL.index("[lubricant]"):]
GEAR = """[gear]
teeth_1 = 25
teeth_2 = 57
module = 2.5 mm
face = 20 mm
speed = 3000 rpm
torque = 80 N.m
[contact]
modulus = 226 GPa
"""
CAM = """[cam]
follower = flat
base_radius = 26 mm
face = 12 mm
speed = 1000 rpm
law = 4567
lift = 6 mm
rise = 70 deg
spring = 30 N/mm
preload = 250 N
mass = 100 g
[contact]
modulus = 226 GPa
[time]
step = adaptive
"""
BEARING = """[roller_bearing]
roller = 10 mm
rollers = 14
length = 9.6 mm
inner = 54.991 mm
clearance = 41 um
load = 4450 N
speed_inner = 1000 rpm
contact = inner
[contact]
modulus = 226 GPa
[cavitation]
model = conserving
[time]
end = 10
"""

# The truth takes most of all time.
CASES = {  # text, levels, the truth above the last of them
    "smooth, steady": (STEEL.format(slip=0.2), range(5, 11), 2),
    "dent, rolling": (STEEL.format(slip=0) + DENT + "[time]\nend = 5\n",
                      range(6, 10), 2),
    "dent, sliding": (STEEL.format(slip=0.4) + DENT + "[time]\nend = 5\n",
                      range(6, 10), 2),
    "one ground surface": (STEEL.format(slip=0.2) + ROUGH.format(k=1) +
                           "[time]\nend = 3\n", range(6, 10), 2),
    "both ground": (STEEL.format(slip=0.2) + ROUGH.format(k=1) +
                    ROUGH.format(k=2) + "[time]\nend = 3\n", range(6, 10), 2),
    "hot, dent": (STEEL.format(slip=0.4) + DENT + WARM + "[time]\nend = 5\n",
                  range(6, 9), 2),
    "starved, dent": (
        STEEL.format(slip=0.2) + DENT + "[cavitation]\nmodel = conserving\n"
        "[supply]\nmodel = film\nthickness_1 = 0.15 um\n"
        "thickness_2 = 0.15 um\n[time]\nend = 5\n", range(6, 10), 2),
    "gear": (GEAR + OIL, range(5, 9), 2),
    "cam": (CAM + OIL, range(5, 8), 1),
    "bearing": (BEARING + OIL, range(6, 9), 2),
    "coated, dent": (
        STEEL.format(slip=0.2).replace("modulus = 226 GPa\n", "") + DENT +
        "[body 1]\nmaterial = steel\n[body 2]\nmaterial = steel\n"
        "[coating 1]\nmaterial = dlc\nthickness = 3 um\n[time]\nend = 5\n",
        range(6, 9), 2),
    "mixed friction": (
        STEEL.format(slip=0.2).replace("3 m/s", "0.3 m/s") +
        "[boundary]\nlaw = exponential\nRq = 0.1 um\nslope = 0.05\n"
        "friction = 0.12\n", range(5, 8), 1),
}

# Columns of the history; of a steady contact keys of its summary.
WHAT = {"H_cen": ("central_film_thickness", "H_cen"),
        "H_min": ("min_film_thickness", "H_min_located"),
        "mu": ("sliding_friction_coefficient", "mu_slide"),
        "T": ("max_film_temperature", "T_max_rise")}


def seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def overroll(*arguments):
    done = subprocess.run([OVERROLL, *arguments], text=True,
                          capture_output=True)
    if done.returncode not in (0, 3):
        raise SystemExit(done.stderr.strip())
    return done.stdout


def solve(text, level, folder):
    """CPU seconds, and times and values of what is compared."""
    case, out = os.path.join(folder, "a.ini"), os.path.join(folder, "a.h5")
    with open(case, "w", encoding="utf-8") as file:
        file.write(text + f"[domain]\nlevel = {level}\n"
                          "[output]\nevery = 1000000000\nfields = pressure\n")
    begun = seconds()
    timed = any(word in text for word in ("[time]", "[gear]", "[cam]"))
    said = json.loads(overroll("run", case, "-o", out, "--force", "-q",
                               "--json") if timed else
                      overroll("steady", case, "--json"))
    took = seconds() - begun
    if not timed:
        return took, [0.0], {what: [said[key]] for what, (_, key) in
                             WHAT.items() if said.get(key) is not None}
    rows = csv.reader(io.StringIO(overroll("export", out)))
    names = [name.split(" [")[0] for name in next(rows)]
    columns = dict(zip(names, zip(*[[float(v or "nan") for v in row]
                                    for row in rows])))
    series = {what: columns[name] for what, (name, _) in WHAT.items()
              if name in columns and all(map(math.isfinite, columns[name]))}
    if "T" in series:
        series["T"] = [T - 333.15 for T in series["T"]]
    return took, columns["time"], series


def at(T, series, t):
    k = max(1, min(len(T) - 1, bisect.bisect_left(T, t)))
    share = (t - T[k - 1]) / (T[k] - T[k - 1])
    return series[k - 1] + share * (series[k] - series[k - 1])


def error(T, series, T_true, true):
    """Relative, the root mean square over the times of the coarser one."""
    mean = sum(map(abs, true)) / len(true)
    if len(T) == 1:
        return abs(series[0] - true[0]) / mean
    end = min(T[-1], T_true[-1])
    off = [(at(T_true, true, t) - v)**2 for t, v in zip(T, series) if t <= end]
    return math.sqrt(sum(off) / len(off)) / mean


def least_cost(points):
    """Of ASKED, between two levels; None where none is so good."""
    for before, now in zip([None] + points[:-1], points):
        if now["H_cen"] <= ASKED:
            if before is None or before["H_cen"] <= now["H_cen"]:
                return now["seconds"]
            share = math.log(ASKED / before["H_cen"]) / \
                math.log(now["H_cen"] / before["H_cen"])
            return before["seconds"] * (now["seconds"] /
                                        before["seconds"])**share
    return None


def measure(name):
    text, levels, above = CASES[name]
    finest = levels[-1] + above
    with tempfile.TemporaryDirectory() as folder:
        _, T_true, true = solve(text, finest, folder)
        points = []
        for level in levels:
            try:
                took, T, series = solve(text, level, folder)
            except SystemExit as why:  # a film too thin for the mesh, say
                print(f"    level {level}: {why}", flush=True)
                continue
            points.append({"level": level, "seconds": took, **{
                what: error(T, series[what], T_true, true[what])
                for what in true if what in series and any(true[what])}})
            print("   ", points[-1], flush=True)
    return {"case": name, "truth_level": finest, "points": points,
            "seconds_for_1e-3": least_cost(points)}


def cell(point, what):
    return f"{point[what]:.1e}" if what in point else ""


def table(results):
    lines = ["| case | level | CPU s | H_cen | H_min | mu | T | "
             "H_cen to 1e-3 |", "|---|---|---|---|---|---|---|---|"]
    for r in results:
        for k, p in enumerate(r["points"]):
            mark = "*" if p["level"] == DEFAULT else ""
            cost = r["seconds_for_1e-3"]
            said = "" if k else f"{cost:.2g} s" if cost else "finer"
            lines.append(
                f"| {'' if k else r['case']} | {p['level']}{mark} | "
                f"{p['seconds']:.2g} | " +
                " | ".join(cell(p, what) for what in WHAT) + f" | {said} |")
    return "\n".join(lines) + "\n"


def main(folder, names):
    results = []
    for name in names or CASES:
        print(name, flush=True)
        results.append(measure(name))
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "users.json"), "w",
              encoding="utf-8") as file:
        json.dump(results, file, indent=1)
    with open(os.path.join(folder, "users.md"), "w", encoding="utf-8") as file:
        file.write(table(results))
    print(table(results))


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "build/bench", sys.argv[2:])
