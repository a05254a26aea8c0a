#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# export and info compared with h5py: every selection of rows, fields, units
# and formats gives the numbers of the file; other selections are rejected.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

sized_dent_case 4 1 0.1 1 -4.9 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 3
fields = pressure, film_thickness, roughness, viscosity, cavitated
END
expect 0 "$OVERROLL" run dent.ini -o a.h5 -q

cat >look.py <<'END'
import json
import subprocess
import sys
import h5py
import numpy

program = sys.argv[1]
f = h5py.File("a.h5", "r")
x, time = f["x"][...], f["time"][...]
b, t0 = f.attrs["scale_length"], f.attrs["scale_time"]
fields = ["pressure", "film_thickness", "roughness", "viscosity", "cavitated"]

def export(*options, comment=None, split=","):
    text = subprocess.run([program, "export", "a.h5", *options], check=True,
                          capture_output=True, text=True).stdout
    lines = [l for l in text.split("\n") if l.strip()]
    heads = lines[0]
    if comment:
        assert heads.startswith(comment + " "), heads
        heads = heads[2:]
    heads = heads.split(split)
    rows = [l for l in lines[1:] if l != lines[0]]
    return heads, numpy.array([[float(v) for v in l.split(split)]
                               for l in rows])

def same(a, b, tolerance=0):
    a, b = numpy.asarray(a), numpy.asarray(b)
    assert a.shape == b.shape, (a.shape, b.shape)
    assert (abs(a - b) <= tolerance * abs(b)).all(), abs(a - b).max()

def stored(k, unit=lambda name: 1.0):
    return numpy.column_stack([x / (b if unit("x") != 1 else 1)] + [
        f[n][k] / unit(n) for n in fields])

# Rows: by number, the last, the nearest in time (given in b/um), all
heads, rows = export("--snapshot", "2")
assert heads[:2] == ["x [m]", "pressure [Pa]"], heads
same(rows, stored(2))
same(export("--snapshot", "last")[1], stored(len(time) - 1))
T = time / t0
asked = 0.7 * T[4] + 0.3 * T[5]
same(export("--time", repr(asked))[1], stored(4))
same(export("--time", "1e9")[1], stored(len(time) - 1))
same(export("--time", f"{asked * t0 * 1e3!r} ms")[1], stored(4))
same(export("--at", f"{0.3 * b * 1e3!r}mm")[1], export("--at", "0.3")[1], 1e-12)
for options in ["--all"], ["--all", "--long"], ["--long"]:
    heads, rows = export(*options)
    assert heads[:3] == ["time [s]", "x [m]", "pressure [Pa]"], heads
    same(rows[:, 1:], numpy.vstack([stored(k) for k in range(len(time))]))
    same(rows[:, 0], numpy.repeat(time, len(x)))
heads, rows = export("--all", "--wide", "--field", "pressure")
assert len(heads) == 1 + len(time), heads
assert heads[0] == "x [m]" and heads[-1] == f"pressure(t={time[-1]:.9g}s) [Pa]"
same(rows, numpy.column_stack([x] + [p for p in f["pressure"]]))
assert export("--wide")[1].shape == (len(x), 1 + len(fields) * len(time))

# Units: the scales of the file, or none
scale = lambda name: f[name].attrs["scale"]
heads, rows = export("--snapshot", "2", "--units", "hertzian")
assert heads[:3] == ["x [b]", "pressure [ph]", "film_thickness [b^2/R]"], heads
same(rows[:, 0], x / b, 1e-14)
for k, name in enumerate(fields[:3]):
    same(rows[:, k + 1], f[name][2] / scale(name), 1e-14)
same(export("--snapshot", "2", "--units", "si")[1], stored(2))

# Fields alone, in the order asked for; other forms of the table
heads, rows = export("--snapshot", "1", "--field", "film_thickness",
                     "--field", "pressure")
assert heads == ["x [m]", "film_thickness [m]", "pressure [Pa]"], heads
same(rows[:, 1:], numpy.column_stack([f["film_thickness"][1],
                                      f["pressure"][1]]))
for form, comment in ("gnuplot", "#"), ("matlab", "%"):
    same(export("--snapshot", "1", "--format", form, comment=comment,
                split=" ")[1], stored(1))

# In time at given places: linear between the nodes
places = [-3.9, 0.0, 0.123, x[10] / b, 1.5]
for place in places:
    heads, rows = export("--at", repr(place), "--field", "pressure")
    wanted = [numpy.interp(place * b, x, f["pressure"][k])
              for k in range(len(time))]
    same(rows[:, 0], time)
    assert abs(rows[:, 1] - wanted).max() <= 1e-12 * f["pressure"][...].max()
assert len(export("--at", "0", "--at", "1", "--field", "pressure")[0]) == 3

# History
heads, rows = export()
for k, head in enumerate(heads):
    column = f["history"][head.split(" ")[0]][...]
    assert ((rows[:, k] == column) | numpy.isnan(column)).all(), head

# info
about = json.loads(subprocess.run([program, "info", "a.h5", "--json"],
                                  check=True, capture_output=True).stdout)
assert about["status"] == "complete" and about["reason"] == ""
assert about["snapshots"] == len(time) and about["fields"] == fields
assert about["steps"] == len(rows) and about["nodes"] == len(x)
assert about["M"] == 20 and about["T_end"] == 1 and about["progress"] == 1
same(about["half_width_m"], b)
H = f["history/min_film_thickness"]
same(about["extremes"]["min_film_thickness"]["min"],
     H[...].min() / H.attrs["scale"], 1e-14)
same(about["extremes"]["min_film_thickness"]["T_max"],
     f["history/time"][H[...].argmax()] / t0, 1e-14)
assert about["cycles_total"] == f["history/cycles"][...].sum()
assert about["steps_marked"] == 0 and "[feature dent]" in about["case"]
END
expect 0 "$PYTHON" look.py "$OVERROLL"

# The case itself
expect 0 "$OVERROLL" info a.h5 -v
contains out '^\[feature dent\]'

# Files: once, and none is left of what was refused
expect 0 "$OVERROLL" export a.h5 -o a.csv --all
refuses 'a.csv: exists already' export a.h5 -o a.csv
expect 0 "$OVERROLL" export a.h5 -o a.csv --force
expect 0 "$OVERROLL" export a.h5
cmp out a.csv || fail '-o writes another thing'
refuses '^overroll: --at 9: must be a position in b from -4' \
    export a.h5 --at 9 -o n.csv
[ ! -e n.csv ] || fail 'an empty file is left'
refuses 'no snapshot 999: must be 0 to' export a.h5 --snapshot 999
refuses 'no snapshot -1' export a.h5 --snapshot -1
refuses "'x' is not a number" export a.h5 --time x
refuses "has no field 'pres'" export a.h5 --snapshot 0 --field pres
refuses 'long and --wide exclude' export a.h5 --long --wide
refuses 'stored, hertzian or si' export a.h5 --units inch
refuses 'csv, gnuplot or matlab' export a.h5 --format xls
refuses 'nowhere/a.csv: cannot be written: No such file' \
    export a.h5 -o nowhere/a.csv

# Without scales there is no SI
printf '[contact]\nM = 20\nL = 10\n[domain]\nlevel = 3\n' >bare.ini
expect 0 "$OVERROLL" run bare.ini -o bare.h5 -q
refuses 'does not know|scale' export bare.h5 --units si
# ... but kinds: what the numbers are in is known
expect 0 "$OVERROLL" export bare.h5 --snapshot 0
contains out '^x \[b\],pressure \[ph\],film_thickness \[b\^2/R\],roughness'
expect 0 "$OVERROLL" export bare.h5 --units hertzian
contains out 'central_film_thickness \[b\^2/R\],central_pressure \[ph\]'
