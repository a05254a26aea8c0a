#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Running-in of profiles: passes are of second order, and the usual level does
# not follow roughness that is in the asperity model.
. "$TOP/tests/support/cli.sh"

# profile LENGTH FILE: waves of this length, um.
profile() {
    awk -v l="$1" 'BEGIN {
        print "x [um];z [um]"
        for (i = 0; i <= 4000; i++)
            printf "%.2f;%.6f\n", i / 4, 0.15 * cos(6.2831853 * i / 4 / l)
    }' >"$2"
}
profile 2 fine.csv
profile 10 usual.csv
profile 250 long.csv
rubbing_contact >wear.ini
cat >>wear.ini <<'END'
[boundary]
law = profile
friction = 0.1
wear_1 = 1e-8 mm3/Nm
passes = 100
[feature ground]
shape = profile
surface = 1
file = usual.csv
END
for name in usual fine long; do
    expect 0 "$OVERROLL" check wear.ini --set "feature ground.file=$name.csv"
    grep -E '^#   (grid|level|expected)' out >$name
    contains $name 'expected discretization error'
    cmp -s usual $name || fail "$name: $(cat usual $name)"
done

# H_cen on levels 6, 7 and 8: differences fall by four, with first order by two.
for level in 6 7 8; do
    for scheme in upstream2 upstream1; do
        expect 0 "$OVERROLL" run wear.ini --level $level --json -q --force \
            -o wear.h5 --set time.scheme=$scheme
        number H_cen >H.$scheme.$level
        number order >order.$scheme
    done
done
[ "$(cat order.upstream1)" = 1 ] || fail "first order: $(cat order.upstream1)"
expect 0 "$OVERROLL" run wear.ini --level 6 --json -q --force -o wear.h5
[ "$(number order)" = 2 ] || fail "the default has order $(number order)"

# ratio SCHEME LOW HIGH
ratio() {
    cat "H.$1.6" "H.$1.7" "H.$1.8" | tr '\n' ' ' >H
    awk -v low="$2" -v high="$3" '{
        ratio = ($1 - $2) / ($2 - $3)
        exit !(ratio > low && ratio < high) }' H ||
        fail "differences of $1: $(cat H)"
}
ratio upstream2 3 6
ratio upstream1 1.5 2.5
