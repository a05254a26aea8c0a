#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# plot --kind stribeck: of a study over speed whose surfaces touch.
. "$TOP/tests/support/cli.sh"
need gnuplot

cat >study.ini <<'END'
[set]
contact.load = 300 kN/m
contact.radius = 8 mm
contact.modulus = 226 GPa
contact.slide_to_roll = 0.3
lubricant.viscosity = 40 mPa.s
lubricant.alpha = 20 1/GPa
lubricant.rheology = eyring
lubricant.eyring_stress = 5 MPa
domain.level = 4
boundary.law = exponential
boundary.slope = 0.03
boundary.friction = 0.11
[product]
boundary.Rq = 200 nm, 500 nm
contact.mean_speed = 1 m/s, 3 m/s, 10 m/s
[study]
results = no
END
expect 0 "$OVERROLL" sweep study.ini -q
expect 0 "$OVERROLL" plot study.ini --kind stribeck -o curve.svg \
    --script curve.gp
for words in 'Rq = 200 nm' 'Rq = 500 nm' 'of the film alone' \
    'coefficient of friction' 'share of the load on metal'; do
    grep -q "$words" curve.svg curve.gp || fail "no '$words'"
done
# each line has its three speeds, slowest first, share falling
expect 0 "$OVERROLL" sweep study.ini -q --collect table.csv
expect 0 "$OVERROLL" plot table.csv --kind stribeck --lines none -o one.svg
refuses "no column 'speed'" plot study.ini --kind stribeck --lines speed \
    -o none.svg
refuses 'wants a study over contact.mean_speed' plot study.ini \
    --kind stribeck --against viscosity -o none.svg
sed '/^boundary/d' study.ini >bare.ini
expect 0 "$OVERROLL" sweep bare.ini -q
refuses 'no contact_share' plot bare.ini --kind stribeck -o none.svg
