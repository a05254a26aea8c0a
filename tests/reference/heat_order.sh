#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A dent rolls through a hot Eyring film. The lag of the viscosities behind the
# temperatures is of second order in dT: if the step is halved, the change of
# the minimum film thickness falls to a quarter. With the lag of one step of
# version 0.2.0 it falls to a half (measured ratio: 1.9). The bound is the
# geometric mean of both orders, sqrt(2 * 4).
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
speed_1 = 3.3 m/s
speed_2 = 2.7 m/s
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
p0 = 198 MPa
z = 0.68
rheology = eyring
eyring_stress = 5 MPa
[heat]
model = lobatto
temperature = 80 degC
[domain]
inlet = -4
outlet = 1.5
level = 6
order = 2
faces = gap
[feature dent]
surface = 1
shape = indent
depth = 0.4 um
width = 0.5
start = -4.6
[time]
scheme = characteristic
end = 4.6651785714285714
END

# film STEPS: the smallest film at the end, in steps of D/(STEPS/380)
film() {
    step=$(awk -v n="$1" 'BEGIN { printf "%.17g", 4.6651785714285714 / n }')
    expect 0 "$OVERROLL" run dent.ini --json --set time.step="$step"
    sed -n 's/^  "H_min": \([-0-9.e+]*\),*$/\1/p' out
}
whole=$(film 380)
half=$(film 760)
quarter=$(film 1520)
awk -v a="$whole" -v b="$half" -v c="$quarter" 'BEGIN {
    r = (a - b) / (b - c)
    printf "H_min %s, %s, %s: ratio %.2f\n", a, b, c, r
    exit !(c > 0 && r > 2.83 && r < 5.66)
}' || fail "H_min $whole, $half, $quarter: not of second order in the step"

# Corrections of fourth order beside the temperatures, at the steps of level 6:
# series LEVEL ORDER EVERY FILE, H_cen after each EVERY-th step.
series() {
    expect 0 "$OVERROLL" run dent.ini -q --force -o d.h5 \
        --set domain.level="$1" --set domain.order="$2"
    expect 0 "$OVERROLL" export d.h5 -q --force -o d.csv
    awk -F, -v every="$3" '
        NR == 1 { for (k = 1; k <= NF; k++)
                      if ($k ~ /^central_film_thickness/) column = k }
        NR > 1 && (NR - 2) % every == 0 { print $column }' d.csv >"$4"
}
series 6 2 1 second
series 6 4 1 fourth
series 8 2 4 truth
off() {
    paste "$1" truth | awk 'NF == 2 { e = $1 / $2 - 1; sum += e * e; n++ }
        END { printf "%.3g", sqrt(sum / n) }'
}
second=$(off second) fourth=$(off fourth)
echo "H_cen of level 6 off by $second of second order, $fourth of fourth"
awk -v a="$second" -v b="$fourth" 'BEGIN { exit !(b > 0 && b < 0.4 * a) }' ||
    fail "fourth order leaves $fourth of $second"
