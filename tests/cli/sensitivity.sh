#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# --sensitivity: elasticities of an independent Richardson limit (levels 8 to
# 12, steps of 1e-3), products of powers by Buckingham's theorem, slopes of
# keys through zero, and numbers suppressed because of the discretization
# error.
. "$TOP/tests/support/cli.sh"

# row KEY QUANTITY NAME: a number of the JSON in `out`.
row() {
    tr -d '\n' <out | tr '{' '\n' | grep "\"$1\".*\"$2\"" |
        sed "s/.*\"$3\": \([^,} ]*\).*/\1/"
}
near() { # A B TOLERANCE
    awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN {
        d = a - b; exit !(a != "" && a != "null" && d <= t && d >= -t) }' ||
        fail "'$1' is not $2 +- $3: $(cat out)"
}
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 8 --sensitivity --json -j 2
near "$(row contact.M H_cen elasticity)" -1.14115 2e-4
near "$(row contact.M H_min_located elasticity)" -1.1171 1e-3
near "$(row contact.L H_cen elasticity)" 0.5459 2e-4
near "$(row contact.L H_min_located elasticity)" 0.5962 1e-3
expect 0 "$OVERROLL" steady --M 20 --L 10 --sensitivity contact.M --level 8
contains out '^contact.M  *central film thickness  *-1.14  *\+- '
[ "$(grep -c contact.L out)" -eq 0 ] || fail "$(cat out)"

# h = R f(w/(E R), eta u/(E R), alpha E): what is multiplied together with
# lengths, and with stresses, has no other effect
cat >contact.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
mean_speed = 1 m/s
slide_to_roll = 0.1
[lubricant]
alpha = 20 1/GPa
viscosity = 40 mPa.s
viscosity_law = barus
density_law = incompressible
[domain]
level = 7
END
expect 0 "$OVERROLL" steady contact.ini --sensitivity --json
for h in central_film_m H_min_located_m; do
    w=$(row contact.load $h elasticity)
    R=$(row contact.radius $h elasticity)
    E=$(row contact.modulus $h elasticity)
    u=$(row contact.mean_speed $h elasticity)
    eta=$(row lubricant.viscosity $h elasticity)
    alpha=$(row lubricant.alpha $h elasticity)
    near "$u" "$eta" 2e-4
    near "$(echo "$w $R $u" | awk '{ print $1 + $2 + $3 }')" 1 3e-3
    near "$(echo "$w $E $eta $alpha" | awk '{ print $1 + $2 + $3 - $4 }')" \
        0 3e-3
done
# a steady film knows nothing of sliding: a slope per unit
near "$(row contact.slide_to_roll central_film_m slope)" 0 1e-12

# The largest pressure that a dent makes is of the mesh
cat >dent.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.2
[domain]
level = 6
[time]
end = 6.4
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4.6
END
expect 0 "$OVERROLL" run dent.ini --sensitivity feature.dent.depth \
    --estimate-error -j 2
name='maximum pressure over the run'
contains out "depth  *$name  *-  *two .*(steps|levels) disagree"
name='minimum film thickness over the run'
contains out "depth  *$name  *-0.[12].*one level coarser"
expect 0 "$OVERROLL" run dent.ini --sensitivity feature.dent.depth --json
found=$(row feature.dent.depth H_min_overall elasticity)
for depth in 0.097 0.103; do
    "$OVERROLL" run dent.ini --set feature.dent.depth=$depth --json |
        sed -n 's/^  "H_min_overall": \(.*\),/\1/p'
done >two
near "$found" "$(paste -s two | awk \
    '{ print log($2 / $1) / log(0.103 / 0.097) }')" 0.01

refuses 'not a key of this case' steady --sensitivity contact.lod --M 20 --L 10
refuses 'not set to a number' run dent.ini --sensitivity feature.dent.shape
refuses 'whole number from 1' steady --M 20 --L 10 --sensitivity -j none
