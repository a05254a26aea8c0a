#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures accuracy and CPU time of thirteen typical cases of users.

usage: users_bench.py [FOLDER] [CASE...]

Each case is run on several levels, with default steps and with steps of D. The
reference is a level that is finer by two (expensive cases: by one), with steps
of D. Errors are those of the central and minimum film thickness, the
coefficient of sliding friction and the maximum temperature rise. In transient
runs they are root mean squares over time relative to the mean. The CPU time is
that of the whole process with a file of the history, the minimum of three runs.

The point of the default settings is marked *. Its row also contains the CPU
time with the default result file, the lowest CPU time for an error of 1e-3 of
both film thicknesses and the friction (interpolated in logarithms between two
levels), and the CPU time of the default relative to that time. Results are
written to users.json and users.md.
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
TARGET = 1e-3
TARGET_OF = ("H_cen", "H_min", "mu")  # quantities that must reach the target

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

RAMP = """[load]
history = ramp
to = 1.5
start = 1
duration = 3
"""

# The references need most of the computing time.
CASES = {  # text, levels, number of levels from the last to the reference
    "smooth, steady": (STEEL.format(slip=0.2), range(5, 11), 2),
    "dent, rolling": (STEEL.format(slip=0) + DENT + "[time]\nend = 5\n",
                      range(5, 9), 2),
    "dent, sliding": (STEEL.format(slip=0.4) + DENT + "[time]\nend = 5\n",
                      range(5, 9), 2),
    "dent, load ramped": (STEEL.format(slip=0.4) + DENT + RAMP +
                          "[time]\nend = 5\n", range(5, 9), 2),
    "one ground surface": (STEEL.format(slip=0.2) + ROUGH.format(k=1) +
                           "[time]\nend = 3\n", range(5, 9), 2),
    "both ground": (STEEL.format(slip=0.2) + ROUGH.format(k=1) +
                    ROUGH.format(k=2) + "[time]\nend = 3\n", range(5, 9), 2),
    "hot, dent": (STEEL.format(slip=0.4) + DENT + WARM + "[time]\nend = 5\n",
                  range(5, 9), 1),
    "starved, dent": (
        STEEL.format(slip=0.2) + DENT + "[cavitation]\nmodel = conserving\n"
        "[supply]\nmodel = film\nthickness_1 = 0.15 um\n"
        "thickness_2 = 0.15 um\n[time]\nend = 5\n", range(5, 9), 2),
    "gear": (GEAR + OIL, range(5, 9), 1),
    # A run on level 10 takes one or two minutes.
    "cam": (CAM + OIL, range(7, 10), 1),
    "bearing": (BEARING + OIL, range(5, 9), 1),
    "coated, dent": (
        STEEL.format(slip=0.2).replace("modulus = 226 GPa\n", "") + DENT +
        "[body 1]\nmaterial = steel\n[body 2]\nmaterial = steel\n"
        "[coating 1]\nmaterial = dlc\nthickness = 3 um\n[time]\nend = 5\n",
        range(5, 9), 1),
    # On level 11 the steady solution does not converge.
    "mixed friction": (
        STEEL.format(slip=0.2).replace("3 m/s", "0.3 m/s") +
        "[boundary]\nlaw = exponential\nRq = 0.1 um\nslope = 0.05\n"
        "friction = 0.12\n", range(5, 9), 2),
}

# Columns of the history; keys of the summary of a steady contact.
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


def moves(text):
    return any(word in text for word in ("[time]", "[gear]", "[cam]"))


def in_meshes(text):
    """Returns the case with steps of D; None: its steps cannot be chosen."""
    if not moves(text) or "step = adaptive" in text:
        return None
    if "[time]\n" in text:
        return text.replace("[time]\n", "[time]\nstep = grid\n")
    return text + "[time]\nstep = grid\n"


def default_level(text, folder):
    case = os.path.join(folder, "a.ini")
    with open(case, "w", encoding="utf-8") as file:
        file.write(text)
    return json.loads(overroll("check", case, "--json"))["level"]


def solve(text, level, folder):
    """Returns CPU seconds, times, and the compared quantities."""
    case, out = os.path.join(folder, "a.ini"), os.path.join(folder, "a.h5")
    with open(case, "w", encoding="utf-8") as file:
        file.write(text + f"[domain]\nlevel = {level}\n"
                          "[output]\nevery = 1000000000\nfields = pressure\n")
    begun = seconds()
    timed = moves(text)
    summary = json.loads(overroll("run", case, "-o", out, "--force", "-q",
                                  "--json") if timed else
                         overroll("steady", case, "--json"))
    cost = seconds() - begun
    if not timed:
        return cost, [0.0], {what: [summary[key]] for what, (_, key) in
                             WHAT.items() if summary.get(key) is not None}
    rows = csv.reader(io.StringIO(overroll("export", out)))
    names = [name.split(" [")[0] for name in next(rows)]
    columns = dict(zip(names, zip(*[[float(v or "nan") for v in row]
                                    for row in rows])))
    series = {what: columns[name] for what, (name, _) in WHAT.items()
              if name in columns and all(map(math.isfinite, columns[name]))}
    if "T" in series:
        series["T"] = [T - 333.15 for T in series["T"]]
    return cost, columns["time"], series


def seconds_with_file(text, folder):
    """Returns CPU seconds of the case with its default result file."""
    case, out = os.path.join(folder, "a.ini"), os.path.join(folder, "a.h5")
    with open(case, "w", encoding="utf-8") as file:
        file.write(text)
    costs = []
    for _ in range(3):
        begun = seconds()
        overroll("run", case, "-o", out, "--force", "-q")
        costs.append(seconds() - begun)
    return min(costs)


def at(T, series, t):
    k = max(1, min(len(T) - 1, bisect.bisect_left(T, t)))
    share = (t - T[k - 1]) / (T[k] - T[k - 1])
    return series[k - 1] + share * (series[k] - series[k - 1])


def error(T, series, T_true, true):
    """Returns the relative root mean square error over the times T."""
    mean = sum(map(abs, true)) / len(true)
    if len(T) == 1:
        return abs(series[0] - true[0]) / mean
    end = min(T[-1], T_true[-1])
    off = [(at(T_true, true, t) - v)**2 for t, v in zip(T, series) if t <= end]
    return math.sqrt(sum(off) / len(off)) / mean


def worst(point):
    return max(point[what] for what in TARGET_OF if what in point)


def least_cost(points):
    """Interpolates the CPU time for an error of TARGET between two levels.
    None: no point has such an error."""
    costs = []
    for step in {p["step"] for p in points}:
        of = [p for p in points if p["step"] == step]
        for before, now in zip([None] + of[:-1], of):
            off = worst(now)
            if off > TARGET:
                continue
            cost = now["seconds"]
            if before and worst(before) > off:
                share = math.log(TARGET / worst(before)) / \
                    math.log(off / worst(before))
                cost = before["seconds"] * (cost / before["seconds"])**share
            costs.append(cost)
            break
    return min(costs, default=None)


def point_of(text, step, level, truth, folder):
    T_true, true = truth
    cost, T, series = min((solve(text, level, folder) for _ in range(3)),
                          key=lambda solved: solved[0])
    return {"level": level, "step": step, "seconds": cost, **{
        what: error(T, series[what], T_true, true[what])
        for what in true if what in series and any(true[what])}}


def measure(name):
    text, levels, above = CASES[name]
    finest, meshes = levels[-1] + above, in_meshes(text)
    with tempfile.TemporaryDirectory() as folder:
        filed = seconds_with_file(text, folder)
        _, *truth = solve(meshes or text, finest, folder)
        points, default = [], default_level(text, folder)
        for step, case in ("default", text), ("mesh", meshes):
            for level in levels if case else ():
                try:
                    points.append(point_of(case, step, level, truth, folder))
                except SystemExit as why:  # e.g. film too thin for the grid
                    print(f"    level {level}: {why}", flush=True)
                    continue
                print("   ", points[-1], flush=True)
    return {"case": name, "truth_level": finest, "points": points,
            "default": default, "seconds_with_file": filed,
            "seconds_for_1e-3": least_cost(points)}


def cell(point, what):
    return f"{point[what]:.1e}" if what in point else ""


def table(results):
    lines = ["| case | level | step | CPU s | H_cen | H_min | mu | T | "
             "with file | all to 1e-3 | times that |", "|---|---|---|---|---|"
             "---|---|---|---|---|---|"]
    for r in results:
        least = r["seconds_for_1e-3"]
        for k, p in enumerate(r["points"]):
            chosen = p["level"] == r["default"] and p["step"] == "default"
            times = " |  | "
            if chosen:
                times = f"{r['seconds_with_file']:.2g} s | " + (
                    f"{least:.2g} s | {p['seconds'] / least:.1f}"
                    if least else "finer | ")
            lines.append(
                f"| {'' if k else r['case']} | {p['level']}"
                f"{'*' if chosen else ''} | {p['step']} | "
                f"{p['seconds']:.2g} | " +
                " | ".join(cell(p, what) for what in WHAT) + f" | {times} |")
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
