#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Stresses of a run: the run is not changed; groups in the file; the same bits
# after a stop; the same from stored pressure; rejected input.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 6
inlet = -4
faces = gap
[time]
end = 6.5
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4.6
[output]
every = 1
END
cp dent.ini plain.ini
cat >>dent.ini <<'END'
[body 1]
yield = 0.6
[stress]
every = 40
[fatigue]
limit_pressure = none
END

cat >compare.py <<'END'
import sys, h5py, numpy
a, b = (h5py.File(n, "r") for n in sys.argv[1:3])
for group in sys.argv[3:]:
    x, y = [], []
    for f, names in ((a, x), (b, y)):
        f[group].visititems(
            lambda n, o: names.append(n) if hasattr(o, "shape") else None)
    assert x == y and x, (group, x, y)
    for n, value in a[group].attrs.items():
        assert numpy.array_equal(value, b[group].attrs[n]), n
    for n in x:
        same = numpy.array_equal(a[group][n][...], b[group][n][...],
                                 equal_nan=True)
        assert same, group + "/" + n
END
cat >same.py <<'END'
import sys, h5py, numpy
a, b = (h5py.File(n, "r") for n in sys.argv[1:3])
for n in ("pressure", "film_thickness", "history/load"):
    assert numpy.array_equal(a[n][...], b[n][...]), n
END
cat >groups.py <<'END'
import sys, h5py, numpy
f = h5py.File(sys.argv[1], "r")
g, s = f["fatigue/surface_1"], f["stress/surface_1"]
depth, material = g["depth"][...], g["material"][...]
for n in ("circle_radius", "orthogonal_amplitude", "critical_plane_angle",
          "max_von_mises", "max_tresca", "max_hydrostatic", "amplitude"):
    assert g[n].shape == (len(depth), len(material)), n
    assert g[n].dims[0][0].name.endswith("depth"), n
R, tau = g["circle_radius"][...], g["orthogonal_amplitude"][...]
# the circle holds every plane; between the points of deep levels both are
# cubic, which differs where one has a kink
assert (R >= tau - 5e-3 * R.max()).all(), (tau - R).max() / R.max()
# free rolling without traction: compressive at every depth and time
assert (g["max_hydrostatic"][...] <= 1e-5 * f.attrs["scale_pressure"]).all()
assert g["complete"][...].all()
scale = f.attrs["scale_pressure"] if f.attrs["scaling"] == b"SI" else 1
smooth = g["circle_radius_smooth"][...].max() / scale
assert 0.22 < smooth < 0.27, smooth
assert s["tau_xz"].shape[1:] == (len(s["depth"]), len(s["x"]))
assert len(s["time"]) == 14, len(s["time"])
# Between the nodes that deep fields are made at too, sums over point loads:
# sigma_z = -2/pi sum P D z^3/r^4, whole to e^(-2 pi z/D); floats are stored
x, X, b = s["x"][...], f["x"][...], f.attrs["scale_length"]
b = b if f.attrs["scaling"] == b"SI" else 1
D = (X[1] - X[0]) / b
for row in (0, 5, len(s["time"]) - 1):
    k = numpy.argmin(abs(f["time"][...] - s["time"][row]))
    P = f["pressure"][k] / scale
    for j in numpy.nonzero(s["depth"][...] > 9 * D * b)[0]:
        z = s["depth"][j] / b
        r2 = ((x[:, None] - X[None, :]) / b)**2 + z**2
        sums = -2 / numpy.pi * (P * D * z**3 / r2**2).sum(axis=1)
        off = abs(s["sigma_z"][row][j] / scale - sums).max()
        assert off < 3e-6, (row, z / D, off)
x = s["sigma_z"][0][0] / scale            # just below the pressure
P = numpy.interp(s["x"][...], f["x"][...], f["pressure"][0]) / scale
assert abs(x + P).max() < 0.25, abs(x + P).max()
END

expect 0 "$OVERROLL" run plain.ini -o plain.h5 -q
expect 0 "$OVERROLL" run dent.ini -o dent.h5 --json
# A complete run is told of once more, its stresses too
stresses() {
    sed -n '/"tau_max"/,$p' out | grep -v '"\(seconds\|output\|warnings\)"'
}
stresses >first
[ "$(grep -c max first)" -ge 6 ] || fail "$(cat out)"
cksum dent.h5* >sums
expect 0 "$OVERROLL" resume dent.h5 --json
contains err 'already complete'
stresses | cmp - first || fail "told again: $(stresses | diff - first)"
cksum dent.h5* | cmp - sums || fail 'a complete file was touched'
rm dent.h5*
expect 0 "$OVERROLL" run dent.ini -o dent.h5
contains out '^maximum shear stress .* p_h .*Z = .*, T = '
contains out '^equivalent raceway length .* from Z = .* downward'
contains out '^Stresses below surface 1, from Z = '
expect 0 "$PYTHON" same.py plain.h5 dent.h5
expect 0 "$PYTHON" groups.py dent.h5
expect 0 "$OVERROLL" info dent.h5

# The same bits after a stop, and after two
expect 0 "$OVERROLL" run dent.ini -o short.h5 -q --set time.end=3.1
expect 0 "$OVERROLL" resume short.h5 -q --set time.end=5
expect 0 "$OVERROLL" resume short.h5 -q --set time.end=6.5
expect 0 "$PYTHON" compare.py dent.h5 short.h5 fatigue stress

# From the stored pressure: the same numbers, other constants
expect 0 "$OVERROLL" run dent.ini -o again.h5 --json
cp out run.json
expect 0 "$OVERROLL" stress again.h5 --json
expect 0 "$PYTHON" - run.json out <<'END'
import json, sys
a, b = (json.load(open(n)) for n in sys.argv[1:3])
for k in ("tau_max", "X_tau_max", "Z_tau_max", "T_tau_max", "von_mises_max",
          "R_max", "xi_R_max", "Z_R_max", "equivalent_length", "least_depth"):
    assert abs(a[k] - b[k]) <= 1e-6 * max(1, abs(a[k])), (k, a[k], b[k])
assert a["surface_R_max"] == 1 and a["least_depth"] > 0
END
for criterion in orthogonal critical-plane von-mises tresca; do
    expect 0 "$OVERROLL" stress dent.h5 --set fatigue.criterion=$criterion
    contains out '^equivalent raceway length .* from Z = '
done
expect 0 "$OVERROLL" stress dent.h5 --set fatigue.limit_pressure=0.9 \
    --set fatigue.raceway=1000
contains out '^utilization of the fatigue limit .*limit 0.225 p_h, circle'
contains out '^life ratio .* from Z = '

# Dang Van's line, by the second pass: without the hydrostatic stress it is
# the circle, with it less
expect 0 "$OVERROLL" run dent.ini -o line.h5 --json --set output.every=2 \
    --set fatigue.criterion=dang-van --set fatigue.alpha=0
cp out line.json
expect 0 "$OVERROLL" stress line.h5 --json --set fatigue.criterion=circle
expect 0 "$PYTHON" - line.json out line.h5 <<'END'
import json, sys, h5py
a, b = (json.load(open(n)) for n in sys.argv[1:3])
g = h5py.File(sys.argv[3])["fatigue/surface_1"]
A, R = g["amplitude"][...], g["circle_radius"][...]
# circles of extents are low by 0.5 % at the most; at depths that snapshots
# see only four times in their depth, by 1 % more
assert (abs(A - R) < 0.03 * R.max()).all(), abs(A - R).max() / R.max()
END

# Both surfaces; a dent that is not on the other one strikes it all the same
expect 0 "$OVERROLL" run dent.ini -o both.h5 -q --set stress.surface=both \
    --set contact.slide_to_roll=0.3 --set 'body 2.poisson=0.25'
expect 0 "$PYTHON" - both.h5 <<'END'
import sys, h5py
f = h5py.File(sys.argv[1])["fatigue"]
assert f["surface_2"].attrs["poisson"] == 0.25
assert f["surface_1"].attrs["poisson"] == 0.3
assert (f["surface_2/circle_radius"][...] > 0).any()
END

# Pictures
if command -v gnuplot >/dev/null; then
    for kind in stress risk depth; do
        expect 0 "$OVERROLL" plot dent.h5 --kind $kind -o $kind.svg
        contains $kind.svg '<svg'
    done
    expect 0 "$OVERROLL" plot dent.h5 --kind stress --field tau_xz \
        --depth log --at 4.6 -o tau.svg
    refuses 'no stress .sigma_q' plot dent.h5 --kind stress --field sigma_q \
        -o no.svg
    refuses 'no fatigue/surface_1; run the case with' plot plain.h5 \
        --kind risk -o no.svg
fi

# What cannot be
expect 0 "$OVERROLL" run plain.ini -o coarse.h5 -q --set output.every=8
expect 0 "$OVERROLL" stress coarse.h5
contains out 'from Z = 0.39'
refuses 'depth_min = 0.1: .* set every = 2$' stress coarse.h5 \
    --set stress.depth_min=0.1
refuses 'fatigue. needs .stress' run plain.ini --set fatigue.alpha=0.2
refuses 'stands still|does not move' run dent.ini --set contact.slide_to_roll=-2
refuses 'FROM, TO' run dent.ini --set stress.window=1
refuses "body 3.* must be .body 1. or" run dent.ini \
    --set 'body 3.poisson=0.2'
refuses 'less than D/2|of travel' run dent.ini --set stress.depth_min=0.001
expect 0 "$OVERROLL" check dent.ini -v
contains out '^#   stress grid .* MB'
contains out '^#   fatigue .*circle: no limit; smooth'
contains out '^\[fatigue\]'
"$OVERROLL" check dent.ini -v >checked.ini
expect 0 "$OVERROLL" check checked.ini
"$OVERROLL" check plain.ini -v >checked.ini
if grep -qE '^.(stress|fatigue)' checked.ini; then
    fail 'check prints sections that are not there'
fi

# A step that spoils the depths is told with its own key and line, by check as
# by run, with one that does.
cat >depths.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = -1.8
[domain]
level = 5
[time]
end = 4
step = 0.4
[stress]
END
for verb in check run; do
    refuses '^depths.ini:9: step: 0.4 b.* from 3.04 b only.* a step of 0.328' \
        $verb depths.ini
    expect 0 "$OVERROLL" $verb depths.ini --set time.step=0.328 -q
done
# The step that is named is another than the one that is given.
refuses 'step: 0.025 .* stress.depth_min = 0.05; use a step of 0.00657' run \
    depths.ini --set stress.depth_min=0.05 --set time.step=0.025

# Dang Van's second pass has no meaning without time: said before the solve
grep -v '^end' dent.ini >steady.ini
refuses 'criterion = dang-van needs a run in time' run steady.ini \
    -o steady.h5 --set fatigue.criterion=dang-van --set fatigue.alpha=0.3

# A strong dent (1.5 um deep, 0.6 b wide, with shoulders): the worst point of
# the material is at its trailing shoulder, some 0.25 b behind its centre, by
# 7 % above the smooth contact even 8 meshes deep.
expect 0 "$OVERROLL" init roller -o strong.ini
expect 0 "$OVERROLL" run strong.ini -o strong.h5 --set domain.level=7 \
    --set feature.dent.depth='1.5 um' --set feature.dent.shoulder='0.25 um' \
    --set output.every=100 --set stress.surface=1 \
    --set fatigue.limit_pressure=none
contains out 'shear path radius R .* at xi = -0\.2[0-9]*, trailing side'
