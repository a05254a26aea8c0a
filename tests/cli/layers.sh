#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Layers on both bodies in a transient sliding run with heat and stresses:
# bodies exchanged; film thickness recalculated from the stored images; a
# killed run resumes to the same digits.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

oil='[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[heat]
model = lobatto
temperature = 80 degC
[domain]
level = 6
order = 2
[time]
end = 4
[output]
every = 20
checkpoint = 1 ms
[stress]
surface = both'
steel='modulus = 206 GPa
conductivity = 46 W/m.K
heat_capacity = 460 J/kg.K
density = 7850 kg/m3'
carbon='thickness = 3 um
modulus = 259 GPa
conductivity = 1 W/m.K
heat_capacity = 1040 J/kg.K
density = 2070 kg/m3'
nickel='thickness = 10 um
modulus = 180 GPa
conductivity = 80 W/m.K
heat_capacity = 440 J/kg.K
density = 8900 kg/m3'
# put FIRST SECOND SPEED OTHER: the case in which body FIRST has both layers.
put() {
    printf '%s\n' '[contact]' 'load = 300 kN/m' 'radius = 8 mm' \
        "speed_$1 = 3.6 m/s" "speed_$2 = 2.4 m/s" "$oil" \
        '[body 1]' "$steel" '[body 2]' "$steel" \
        "[coating $1]" "$carbon" "[coating $1b]" "$nickel" \
        "[coating $2]" "$nickel" '[feature dent]' 'shape = dent' \
        'depth = 1 um' 'width = 0.6' 'start = -2' "surface = $1"
}
put 1 2 >upper.ini
put 2 1 >lower.ini
for case in upper lower; do
    expect 0 "$OVERROLL" run "$case.ini" -o "$case.h5" -q --json
    cp out "$case.json"
done
expect 0 "$PYTHON" - <<'END'
import json
import h5py
import numpy as np
a, b = (h5py.File(n + ".h5") for n in ("upper", "lower"))
for name in ("pressure", "film_thickness"):
    u, v = a[name][...], b[name][...]
    assert abs(u - v).max() < 1e-9 * abs(u).max(), name
one, two = (json.load(open(n + ".json")) for n in ("upper", "lower"))
for x, y in (("T_1_max_rise", "T_2_max_rise"), ("T_2_max_rise", "T_1_max_rise"),
             ("mu_1", "mu_2"), ("mu_2", "mu_1"),
             ("von_mises_max", "von_mises_max")):
    assert abs(one[x] / two[y] - 1) < 1e-7, (x, one[x], two[y])
# carbon keeps the heat of its surface
assert one["T_1_max_rise"] > 2 * one["T_2_max_rise"]

# The film of the stored pressure, in boxes, by the stored images; and not by
# the logarithm alone.
c = a["coating"]
assert 0 < c.attrs["image_error"] < 1e-7
b, p, h = (a.attrs["scale_" + n] for n in ("length", "pressure", "height"))
X, P, H = (a["x"][...] / b, a["pressure"][-1] / p,
           a["film_thickness"][-1] / h)
D = X[1] - X[0]
def mean(x, depth):
    def integral(x):
        arc = depth * np.arctan(x / depth) if depth > 0 else 0
        return x / 2 * np.log(x * x + depth * depth) - x + arc
    return integral(x + D / 2) - integral(x - D / 2)
apart = X[:, None] - X[None, :]
bare = mean(apart, 0)
K = c.attrs["softness_top"] * bare
for depth, weight in zip(c["image_depth"][...] / b, c["image_weight"][...]):
    K += weight * mean(apart, depth)
off, off_bare = (H - (X**2 / 2 - k @ P / np.pi) for k in (K, bare))
assert np.ptp(off) < 1e-9, np.ptp(off)
assert np.ptp(off_bare) > 1e-3
END

"$OVERROLL" run upper.ini -o cut.h5 -q &
pid=$!
tries=0
while { [ ! -e cut.h5 ] || [ ! -e cut.h5.restart ]; } &&
    [ "$tries" -lt 500 ]; do
    sleep 0.01
    tries=$((tries + 1))
done
sleep 0.1
kill -9 "$pid" 2>/dev/null || :
wait "$pid" 2>/dev/null || :
expect 0 "$OVERROLL" resume cut.h5 -q
content upper.h5 >1.txt
content cut.h5 >2.txt
cmp 1.txt 2.txt || fail 'the resumed run differs'
