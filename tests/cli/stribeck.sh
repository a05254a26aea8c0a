#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# plot --kind stribeck for a study over speed with mixed lubrication.
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
for words in 'Rq = 200 nm' 'Rq = 500 nm' 'fluid friction' \
    'coefficient of friction' 'asperity load share'; do
    grep -q "$words" curve.svg curve.gp || fail "no '$words'"
done
# each line has its three speeds, slowest first, share falling
expect 0 "$OVERROLL" sweep study.ini -q --collect table.csv
expect 0 "$OVERROLL" plot table.csv --kind stribeck --lines none -o one.svg
refuses "no column 'speed'" plot study.ini --kind stribeck --lines speed \
    -o none.svg
refuses 'needs a study over contact.mean_speed' plot study.ini \
    --kind stribeck --against viscosity -o none.svg
sed '/^boundary/d' study.ini >bare.ini
expect 0 "$OVERROLL" sweep bare.ini -q
refuses 'no contact_share' plot bare.ini --kind stribeck -o none.svg

# what touches, node by node: its integral is the share of pi/2
cat >touch.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 6.84 mm
modulus = 227 GPa
slide_to_roll = 0.3
mean_speed = 2 m/s
viscosity = 10 mPa.s
alpha = 20 1/GPa
[lubricant]
rheology = eyring
eyring_stress = 5 MPa
[domain]
level = 4
[time]
end = 0.1
[boundary]
law = exponential
Rq = 194 nm
slope = 0.03
friction = 0.11
END
expect 0 "$OVERROLL" steady touch.ini -q --json \
    --set 'contact.mean_speed=0.1 mm/s'
sed -n 's/.*"contact_share_estimate": \([^,]*\).*/\1/p' out |
    awk '{ exit !($1 > 0.99 && $1 <= 1) }' ||
    fail "estimated share: $(grep share_est out)"
expect 0 "$OVERROLL" run touch.ini -o touch.h5 -q --json
share=$(sed -n 's/.*"contact_share": \([^,]*\).*/\1/p' out)
expect 0 "$OVERROLL" export touch.h5 --snapshot last --units hertzian \
    --field contact_pressure
awk -F, -v share="$share" 'NR > 1 { if (NR > 2) sum += ($2 + last) / 2 * \
    ($1 - x); x = $1; last = $2 } END { off = sum / (atan2(0, -1) / 2) / share
    exit !(off > 0.999 && off < 1.001) }' out || fail "no share of $share"
# What the oil carries and what metal bears are the load.
expect 0 "$OVERROLL" export touch.h5 --snapshot last --units hertzian \
    --field fluid_pressure
mv out fluid.csv
expect 0 "$OVERROLL" export touch.h5 --snapshot last --units hertzian \
    --field contact_pressure
paste -d, fluid.csv out | awk -F, 'NR > 1 { P = $2 + $4
    if (NR > 2) sum += (P + last) / 2 * ($1 - x); x = $1; last = P }
    END { off = sum / (atan2(0, -1) / 2) - 1
        exit !(off > -1e-5 && off < 1e-5) }' ||
    fail 'oil and metal do not carry the load'
expect 0 "$OVERROLL" view touch.h5 -o touch.html
grep -q '"C":{"levels"' touch.html || fail 'the page does not mark what touches'

# What check foretells of the friction holds the run between its bounds, and is
# next to it where little touches.
for speed in 2 4 8; do
    expect 0 "$OVERROLL" check touch.ini --set "contact.mean_speed=$speed m/s"
    # shellcheck disable=SC2046 # two words
    set -- $(sed -n 's/^#  *predicted friction coefficient  *//; t range
        d
        : range
        s/ to / /; s/ for.*//p' out)
    expect 0 "$OVERROLL" steady touch.ini --json \
        --set "contact.mean_speed=$speed m/s" --set domain.level=6
    mu=$(sed -n 's/.*"mu_slide": \([^,]*\).*/\1/p' out)
    awk -v low="$1" -v high="$2" -v mu="$mu" 'BEGIN {
        exit !(mu > 0.93 * low && mu < 1.05 * high) }' ||
        fail "$speed m/s: mu $mu, foretold $1 to $2"
done

# Mixed films converge on fine levels too: Newton's method needs exact slopes
sed 's/^ *//' >fine.ini <<'END'
    [contact]
    hertz_pressure = 1 GPa
    radius = 12 mm
    modulus = 226 GPa
    mean_speed = 0.3 m/s
    slide_to_roll = 0.2
    [lubricant]
    viscosity = 30 mPa.s
    alpha = 18 1/GPa
    rheology = eyring
    eyring_stress = 5 MPa
    limiting_shear = 0.08
    [boundary]
    law = exponential
    Rq = 0.1 um
    slope = 0.05
    friction = 0.12
END
for level in 9 11; do
    expect 0 "$OVERROLL" steady fine.ini --level $level --json
    sed -n 's/^ *"H_cen": \([^,]*\).*/\1/p' out | tail -n 1
done >films
awk 'NR == 1 { H = $1 } END { exit !(NR == 2 && ($1 / H - 1) ^ 2 < 1e-6) }' \
    films || fail "$(cat films)"
