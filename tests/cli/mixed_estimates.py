#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `check` estimates of mixed contacts next to their runs.

mixed_estimates.py PROGRAM SEED COUNT: random contacts with lambda ratios of 0.1
to 8.  Fails where the numbers of overroll-case(5), MEASURED ACCURACY, do not
hold.
"""
import json
import math
import random
import re
import subprocess
import sys


def log_between(r, a, b):
    return math.exp(r.uniform(math.log(a), math.log(b)))


def case(seed):
    r = random.Random(seed)
    law = r.choice(["exponential", "exponential", "greenwood-tripp"])
    slope = f"slope = {r.uniform(.01, .04):.4f}\n" if law[0] == "e" else ""
    return f"""[contact]
hertz_pressure = {r.uniform(.5, 1.8):.4f} GPa
radius = {log_between(r, 5, 30):.4f} mm
modulus = 226 GPa
mean_speed = {log_between(r, .3, 7):.4f} m/s
slide_to_roll = {r.choice([-1, 1]) * log_between(r, .03, 1):.4f}
[lubricant]
viscosity = {log_between(r, 10, 110):.3f} mPa.s
alpha = {r.uniform(15, 24):.3f} 1/GPa
rheology = eyring
eyring_stress = {r.uniform(4, 9):.3f} MPa
limiting_shear = 0.08
[boundary]
law = {law}
Rq = {log_between(r, .05, 1):.4f} um
{slope}friction = 0.11
"""


def numbers(program, text):
    """The lambda ratio, estimated over computed share, and by how much the
    computed friction is outside the estimated range; None where a run fails."""
    with open("mixed.ini", "w", encoding="utf-8") as file:
        file.write(text)
    said = subprocess.run([program, "check", "mixed.ini"], check=True,
                          capture_output=True, text=True).stdout
    run = subprocess.run([program, "run", "mixed.ini", "--json"],
                         capture_output=True, text=True)
    ratio = float(re.search(r"#   lambda ratio +([\d.]+):", said)[1])
    if run.returncode or not 0.1 < ratio < 8:
        return None
    made = json.loads(run.stdout)
    low, high = map(float, re.search(
        r"friction coefficient +([\d.e-]+) to ([\d.e-]+) for", said).groups())
    mu, share = abs(made["mu_slide"]), made["contact_share"]
    outside = max(low / mu - 1, 1 - high / mu)
    return ratio, share / made["contact_share_estimate"], outside, \
        max(abs(low / mu - 1), abs(high / mu - 1))


def main():
    program, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    rows = [numbers(program, case(seed + k)) for k in range(count)]
    rows = sorted(row for row in rows if row)
    for row in rows:
        print("lambda %.2f: share %.2f times the estimate, friction outside "
              "the range by %.3f" % row[:3])
    full = sorted(row[3] for row in rows if row[0] > 2)
    wrong = [row for row in rows if row[0] < 3 and not 0.7 <= row[1] <= 1.7]
    wrong += [row for row in rows if row[0] <= 2 and row[2] > 0.07]
    few = max(1, len(full) // 5)
    assert len(rows) > 0.6 * count and len(full) > 2, rows
    assert not wrong, wrong
    assert full[-1] < 0.3 and full[-1 - few] < 0.1, full


if __name__ == "__main__":
    main()
