#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Picture of a machine element: teeth touch on the path of contact, which ends
# at the tip circles; lift of a cam; loads and positions of the rollers of a
# bearing; from a case, from a result and on the page.
. "$TOP/tests/support/cli.sh"
need gnuplot

cat >gear.ini <<'END'
[contact]
modulus = 226 GPa
[gear]
module = 3 mm
teeth_1 = 20
teeth_2 = 40
face = 20 mm
speed = 3000 rpm
torque = 100 N.m
[lubricant]
viscosity = 10 mPa.s
alpha = 16 1/GPa
[domain]
level = 5
END

# table NAME: its rows in the data beside the script, by how it begins.
table() {
    awk -v name="# $1" 'index($0, "#") == 1 { on = index($0, name) == 1; next }
        on && NF' element.dat
}
drawn() {
    expect 0 "$OVERROLL" plot "$1" --kind element -o element.png --force \
        --script element.gp
}

drawn gear.ini
contains element.gp "^kind = 'element'"
for gear in 1 2; do
    table "gear $gear" | awk 'NF == 2 && n++ {
            # distance of the pitch point from the piece x, y to $1, $2
            dx = $1 - x; dy = $2 - y; l = dx * dx + dy * dy
            t = l > 0 ? -(x * dx + y * dy) / l : 0
            t = t < 0 ? 0 : t > 1 ? 1 : t
            d = sqrt((x + t * dx) ^ 2 + (y + t * dy) ^ 2)
            if (!least || d < least) least = d
        }
        { x = $1; y = $2 }
        END { exit !(least < 2e-3) }' ||
        fail "the flank of gear $gear does not pass the pitch point"
done
# A on the tip circle of gear 2 (63 mm about 0, 60), E on that of gear 1 (33 mm
# about 0, -30), C at 0.
table '-: position' >points
awk '{ x[NR] = $1; y[NR] = $2 }
    END {
        a = sqrt(x[1] ^ 2 + (60 - y[1]) ^ 2) - 63
        e = sqrt(x[5] ^ 2 + (30 + y[5]) ^ 2) - 33
        c = x[3] ^ 2 + y[3] ^ 2
        way = sqrt((x[5] - x[1]) ^ 2 + (y[5] - y[1]) ^ 2)
        p = atan2(0, -1) * 3 * cos(20 * atan2(0, -1) / 180)
        exit !(NR == 5 && a * a < 1e-12 && e * e < 1e-12 && c < 1e-18 &&
            (way / p - 1.635186) ^ 2 < 1e-10)
    }' points || fail "A to E: $(cat points)"

# Driven, the line leans the other way; a ring is about its pinion.
sed 's/^face/driving = 2\n&/' gear.ini >driven.ini
drawn driven.ini
table '-: position' | awk '{ printf "%.9g %.9g\n", -$1, $2 }' >mirrored
awk '{ printf "%.9g %.9g\n", $1, $2 }' points | cmp -s - mirrored ||
    fail 'driven, the path is not the mirrored one'
sed 's/^teeth_1.*/teeth_1 = 30/; s/^teeth_2.*/teeth_2 = -90/' gear.ini >ring.ini
drawn ring.ini
# The ring's teeth point down: tips a module below the pitch point, feet above.
table 'gear 2' | awk '{ if ($2 > high) high = $2 }
    END { exit !(high > 3 && high <= 3.75) }' || fail 'the feet of a ring'

# A result has the film too, but no other than an element's.
expect 0 "$OVERROLL" run gear.ini -o gear.h5 -q
drawn gear.h5
table 'minimum film thickness' | grep -q . || fail 'no film'
cat >own.gp <<'END'
set print 'own.txt'
print kind, rows, equal[1], equal[2], letters[5]
@chart@
END
expect 0 "$OVERROLL" plot gear.h5 --kind element -o own.svg --template own.gp
contains own.txt '^element 5 1 0 A B C D E'
expect 0 "$OVERROLL" view gear.h5 -o gear.html
contains gear.html '"element":\{"at":"'

# As high as base circle and lift, where the rise ends.
expect 0 "$OVERROLL" init cam -o cam.ini
drawn cam.ini
table 'range of the run' | awk '{ r = sqrt($1 ^ 2 + $2 ^ 2)
        if (r > high) { high = r; at = atan2($2, $1) } }
    END { at *= 180 / atan2(0, -1)
        exit !((high - 32) ^ 2 < 1e-4 && (at - 70) ^ 2 < 1) }' ||
    fail 'the nose of the cam'
table 'reversals of the entrainment speed' | awk 'END { exit NR != 4 }' ||
    fail 'four turns'

# 209: three rollers carry, as long as their loads; three that a point meets,
# 44.6 degrees apart.
expect 0 "$OVERROLL" init bearing -o bearing.ini
drawn bearing.ini
table 'load of a roller' | awk 'NF == 2 && $1 == $1 && $1 != "NaN" {
        r = sqrt($1 ^ 2 + $2 ^ 2)
        if (++n % 2) from = r; else long[n / 2] = r - from }
    END { for (k in long) { sum += long[k]; if (long[k] > most) most = long[k] }
        exit !(n == 6 && (sum / most - 2.4) ^ 2 < 0.01) }' ||
    fail 'bars of the rollers'
table 'roller positions met by a raceway point' | awk '
    { a[NR] = atan2($1, -$2) * 180 / atan2(0, -1) }
    END { exit !(NR == 3 && (a[3] - a[2] - 44.6) ^ 2 < 0.01) }' ||
    fail 'rollers that a point meets'

expect 0 "$OVERROLL" init roller --set domain.level=5 --set time.end=0.5 \
    -o other.ini
refuses 'only cases with' \
    plot other.ini --kind element -o no.png
expect 0 "$OVERROLL" run other.ini -q -o other.h5
refuses 'only cases with' \
    plot other.h5 --kind element -o no.png
refuses 'shows one result only' plot gear.h5 other.h5 --kind element -o no.png
expect 0 "$OVERROLL" view other.h5 -o other.html
grep -q '"element":{' other.html && fail 'an element on the page of none'
exit 0
