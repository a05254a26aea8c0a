#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The example gear: the tables of a tooth pair are its geometry; its first
# touch runs with everything on.
. "$TOP/tests/support/cli.sh"

gear() {
    expect 0 env EXAMPLES="$PWD" OVERROLL="$OVERROLL" PICTURES=no "$@" \
        "$TOP/tools/examples/gear"
}
gear LEVEL=7 OPTIONS='--set time.end=0.15 --json -q'
for key in T_max_rise mu_slide_max film_ratio tau_max radius_ratio; do
    grep -q "\"$key\": *-*[0-9]" out || fail "no $key: $(cat out)"
done
grep -q '"steps_marked": 0' out || fail 'marked steps'
expect 0 "$OVERROLL" info gear.h5
grep -q 'temperature_middle' out || fail 'no temperatures'

# A pair and a flank of one's own
mkdir own
cp gear-nominal.txt own/
cp "$TOP/profiles/honed.csv" mine.csv
expect 0 env EXAMPLES="$PWD/own" OVERROLL="$OVERROLL" PICTURES=no MODULE=2 \
    TEETH_1=25 TEETH_2=60 CENTRE=85 RPM=1500 LEVEL=6 FLANK_1=mine.csv \
    OPTIONS='--set time.end=0.02 -q' "$TOP/tools/examples/gear"
cmp -s gear-nominal.txt own/gear-nominal.txt && fail 'the same pair'

# Module 3, 20 and 40 teeth: pitch radii 30 and 60 mm, R = 10.26 20.52/30.78;
# contact ratio 1.635 by ISO 21771, so 1.635 pi 3 cos(20)/(w rb) ms.
awk '{ exit !($1 - 6.8404 < 1e-3 && 6.8404 - $1 < 1e-3 &&
    $3 - 1.6352 < 1e-3 && 1.6352 - $3 < 1e-3) }' gear-nominal.txt ||
    fail "nominal: $(cat gear-nominal.txt)"
# At the pitch point no sliding, the nominal radius; loads from a third.
pitch=$(cut -d' ' -f4 gear-nominal.txt)
awk -v at="$pitch" '
function near(x, y) { return x - y < 3e-3 && y - x < 3e-3 }
FNR == 1 { of++; first[of] = $2 }
$1 <= at { value[of] = $2 }
{ last[of] = $2 }
END { exit !(near(value[1], 0) && near(value[2], 1) && near(value[3], 1) &&
    near(value[4], 1) && near(first[4], 1 / 3) && near(last[4], 1 / 3)) }' \
    gear-sliding.csv gear-radius.csv gear-speed.csv gear-load.csv ||
    fail 'the tables are not the pitch point at the pitch point'
