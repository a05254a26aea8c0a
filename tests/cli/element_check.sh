#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What check prints about the reference contact and the contact positions of
# gears, cams and bearings.
. "$TOP/tests/support/cli.sh"

for kind in gear cam bearing; do
    expect 0 "$OVERROLL" init $kind -o $kind.ini
done

# The reference of a cam occurs at no position: no film thickness is printed.
expect 0 "$OVERROLL" check cam.ini -v
contains out 'reference contact .* no position has all three$'
! grep -qi 'predicted film thickness\|asymptote\|lambda' out ||
    fail "a film thickness of a scale: $(cat out)"
expect 0 "$OVERROLL" check cam.ini --json
contains out '"H_cen_moes": [0-9]'
expect 0 "$OVERROLL" check gear.ini
contains out 'reference contact  *pitch point'
contains out '^# Predicted film thickness'
contains out '^#   minimum film thickness, overroll fit '
contains out 'load at B and D .* 0\.05 base pitches .gear\.blend.$'
# Half-way from two thirds of the load, by the rule, to all of it.
expect 0 "$OVERROLL" check gear.ini --json --set gear.sharing=rule
load() { # POSITION
    sed -n "/\"name\": \"$1\"/,/load_N/s/.*load_N_per_m\": *\(.*\),/\1/p" out
}
for at in B D; do
    awk -v half="$(load $at)" -v all="$(load C)" 'BEGIN {
        exit !((half / all - 5 / 6) ^ 2 < 1e-12) }' || fail "load at $at"
done
expect 0 "$OVERROLL" check gear.ini --set 'gear.helix_angle=15 deg'
! grep -q 'load at B and D' out || fail 'helical teeth have no blend'
expect 0 "$OVERROLL" check bearing.ini
contains out 'reference contact  *roller of the largest load'
contains out '^# Predicted film thickness'

# "-" of h_min and SRR is explained where it occurs.
explained() { # KIND ARGUMENTS...
    expect 0 "$OVERROLL" check "$@"
    unknown=$(awk '/^# position/ { on = 1; next } /^#  / { on = 0 }
        on && $(NF - 1) == "-" { n++ } END { print n + 0 }' out)
    grep -q '^#   h_min -: outside the range' out && said=yes || said=no
}
explained cam.ini
[ "$unknown" -gt 0 ] && [ $said = yes ] || fail "$unknown unknown, $said"
contains out 'SRR: slide-to-roll ratio .-: no entrainment.'
explained gear.ini
[ "$unknown" -eq 1 ] && [ $said = yes ] || fail "$unknown unknown, $said"
contains out 'SRR: slide-to-roll ratio, w'
explained bearing.ini
[ "$unknown" -eq 0 ] && [ $said = no ] || fail "$unknown unknown, $said"
sed '/^p0 =/d; /^z =/s/.*/viscosity_law = barus/' bearing.ini >barus.ini
explained barus.ini
[ "$unknown" -eq 3 ] && [ $said = yes ] || fail "$unknown unknown, $said"

# The friction coefficients of the report have a sign, and say which.
expect 0 "$OVERROLL" run gear.ini --set domain.level=5 --set time.end=0.5
contains out '^mean sliding friction coefficient +-0\.0.*\(sign of u1 - u2\)'
contains out '^[a-z ]*sliding friction coefficient .* ms; sign of u1 - u2\)'
