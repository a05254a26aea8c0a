#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What a profile bears that the mesh leaves out of it: its Rq is that of the
# waves shorter than two meshes, level by level; the rest is on the mesh.
. "$TOP/tests/support/cli.sh"
need_python json

cat >un.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 6.84 mm
modulus = 227 GPa
slide_to_roll = 0.3
mean_speed = 1 m/s
viscosity = 10 mPa.s
alpha = 20 1/GPa
[lubricant]
rheology = eyring
eyring_stress = 5 MPa
[domain]
inlet = -4
outlet = 1.5
level = 7
[time]
end = 0.5
[boundary]
law = profile
of = unresolved
friction = 0.11
[feature fine]
surface = 1
shape = profile
file = fine.csv
level = none
taper = 0
extend = periodic
start = -4
END
"$PYTHON" - <<'END'
import math
import random
random.seed(5)
n, dx, waves = 2000, 0.1, range(5, 400, 5)         # um: from 40 down to 0.5
heights = [0.0] * n
with open("spectrum", "w") as spectrum:
    for k in waves:
        a, phase = 0.1 / k, random.uniform(0, 6.28)
        print(n * dx / k, a, file=spectrum)
        for i in range(n):
            heights[i] += a * math.cos(2 * math.pi * k * i / n + phase)
with open("fine.csv", "w") as out:
    print("x [um];z [um]", file=out)
    for i in range(n + 1):
        print(f"{i * dx:.1f};{heights[i % n]:.6f}", file=out)
END
for level in 6 7 8; do
    expect 0 "$OVERROLL" check un.ini --level "$level"
    sed -n 's/.*of both surfaces  *composite Rq \([^ ]*\) .*/\1/p' out \
        >"Rq.$level"
done
expect 0 "$OVERROLL" check un.ini --json
expect 0 "$PYTHON" - <<'END'
import json
import math
about = json.load(open("out"))
b, film = about["half_width_m"] * 1e6, about["film_scale_m"] * 1e6
waves = [[float(v) for v in line.split()] for line in open("spectrum")]
for level in (6, 7, 8):
    D = 5.5 / (7 * 2**level) * b
    left = math.sqrt(sum(a * a / 2 for l, a in waves if l < 2 * D)) / film
    told = float(open(f"Rq.{level}").read())
    # heights between nodes lack some of the waves that are little longer
    print(level, told / left)
    assert -0.02 < told / left - 1 < 0.25, (level, told, left)
END
expect 0 "$OVERROLL" run un.ini -o un.h5 --json -q
share=$(sed -n 's/.*"contact_share_max": \([^,]*\).*/\1/p' out)
awk -v share="$share" 'BEGIN { exit !(share >= 0 && share < 0.9) }' ||
    fail "share $share"
refuses 'the grid resolves the profiles completely' check un.ini --level 11
expect 0 "$OVERROLL" check un.ini --level 11 --set 'boundary.layer=3 nm'
refuses 'running-in requires boundary.of = all' check un.ini \
    --set 'boundary.wear_1=1e-8 mm3/Nm' --set boundary.passes=1000
