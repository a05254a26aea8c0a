#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Fatigue limits by depth from a file: a constant limit is equal to
# limit_pressure; otherwise the utilization is recalculated from the stored
# amplitudes; rejected input.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

cat >case.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
speed_1 = 3.0 m/s
speed_2 = 3.0 m/s
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
[domain]
level = 6
[time]
end = 6.5
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4.6
[output]
every = 1
[stress]
[fatigue]
END
printf 'depth [um], limit [MPa]\n20, 250\n' >same.csv
printf 'limit [MPa], depth [um]\n500, 20\n420, 150 # case\n60, 250\n60, 900\n' \
    >hard.csv
expect 0 "$OVERROLL" check case.ini --set fatigue.limit_table=hard.csv
contains out 'limit by depth, 500 MPa at 20 um to 60 MPa at 900 um'
expect 0 "$OVERROLL" run case.ini -o dent.h5 --json \
    --set fatigue.limit_table=hard.csv
cp out hard.json

cat >share.py <<'END'
import json, h5py, numpy
g = h5py.File("dent.h5", "r")["fatigue/surface_1"]
told = json.load(open("hard.json"))
# Hertz, of 300 kN/m, R = 8 mm, E' = 226 GPa
b = (8 * 300e3 * 8e-3 / (numpy.pi * 226e9)) ** 0.5
z, A = g["depth"][...], g["amplitude"][...]
limit = numpy.interp(z * 1e6, [20, 150, 250, 900], [500, 420, 60, 60]) * 1e6
share = (A / limit[:, None])[z >= g.attrs["least_depth"] * b * (1 - 1e-6)]
share = share[:, g["complete"][...] != 0]
assert abs(share.max() / told["utilisation"] - 1) < 1e-6
assert abs(share.max() / g.attrs["utilisation"] - 1) < 1e-6
# the core is used more than the case, though its stresses are smaller
assert g.attrs["used_depth"] * b >= 250e-6 > g.attrs["worst_depth"] * b
END
expect 0 "$PYTHON" share.py

# The limit of a pressure of 1 GPa, a quarter of it, at all depths.
expect 0 "$OVERROLL" stress dent.h5 --json \
    --set fatigue.limit_table="$PWD/same.csv"
cp out same.json
expect 0 "$OVERROLL" run case.ini -o plain.h5 --json \
    --set fatigue.limit_pressure='1 GPa'
expect 0 "$PYTHON" - same.json out <<'END'
import json, sys
a, b = (json.load(open(n)) for n in sys.argv[1:3])
for k in ("utilisation", "equivalent_length", "limit"):
    assert abs(a[k] - b[k]) <= 1e-4 * abs(b[k]), (k, a[k], b[k])
END

refused() {
    said=$1
    shift
    expect 2 "$OVERROLL" check case.ini "$@"
    contains err "$said"
}
printf 'depth [um], limit [MPa]\n20, 250\n20, 240\n' >twice.csv
printf 'depth [um], limit [MPa]\n20, 0\n' >zero.csv
printf '20, 250\n' >bare.csv
printf 'depth [um], limit [MPa]\n' >empty.csv
refused 'twice.csv:3: the depth must increase: 20 follows 20' \
    --set fatigue.limit_table=twice.csv
refused 'zero.csv:2: depths must be at least 0, and limits must be' \
    --set fatigue.limit_table=zero.csv
refused 'must name the units' --set fatigue.limit_table=bare.csv
refused 'has no points' --set fatigue.limit_table=empty.csv
refused 'limit_table: no.csv: cannot be opened' --set fatigue.limit_table=no.csv
refused 'limit_pressure is also set' --set fatigue.limit_table=same.csv \
    --set fatigue.limit_pressure='1 GPa'

# Residual stresses by depth: the same at all depths is residual_x = residual_y;
# Dang Van's amplitude with alpha is more by alpha times their hydrostatic part,
# 2/3 of the table's stress there
printf 'depth [um], stress [MPa]\n10, -300\n900, -300\n' >even.csv
printf 'depth [um], stress [MPa]\n0, 400\n200, 100\n900, 50\n' >deep.csv
vary() { # NAME SET...
    name=$1
    shift
    expect 0 "$OVERROLL" run case.ini -o "$name.h5" --json --force \
        --set fatigue.criterion=dang-van --set fatigue.alpha=0.3 "$@"
    cp out "$name.json"
}
vary without
vary both --set fatigue.residual_x='-300 MPa' \
    --set fatigue.residual_y='-300 MPa'
vary even --set fatigue.residual_table=even.csv
vary deep --set fatigue.residual_table=deep.csv
cat >residual.py <<'END'
import h5py, numpy
def of(name):
    g = h5py.File(name + ".h5", "r")["fatigue/surface_1"]
    return g["depth"][...], g["amplitude"][...]
both, even = of("both")[1], of("even")[1]
assert numpy.abs(both - even).max() <= 1e-6 * numpy.abs(both).max()
z, without = of("without")
z, deep = of("deep")
wanted = 0.3 * 2 / 3 * numpy.interp(z * 1e6, [0, 200, 900], [400, 100, 50])
more = (deep - without) / 1e6
assert numpy.abs(both - without).max() > 40e6
kept = without > 0.02e9
assert numpy.abs(more - wanted[:, None])[kept].max() < 0.02, \
    numpy.abs(more - wanted[:, None])[kept].max()
END
expect 0 "$PYTHON" residual.py
expect 2 "$OVERROLL" check case.ini --set fatigue.residual_table=deep.csv \
    --set fatigue.residual_x='1 GPa'
contains err 'residual_x: has no effect beside residual_table'
printf 'depth [um], stress [MPa]\n20, 250\n20, 240\n' >twice.csv
refused 'twice.csv:3: the depth must increase: 20 follows 20' \
    --set fatigue.residual_table=twice.csv
