#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# [cavitation] and [supply]: a starved run, contents of its file, resumed to
# the same bits; incompatible options; columns only if they apply.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
inlet = -4
level = 5
faces = arithmetic
[cavitation]
model = conserving
[supply]
model = film
thickness_1 = 0.02521
thickness_2 = 0.02521
[time]
end = 2
[feature d]
shape = dent
depth = 0.1
width = 0.5
start = -1.5
[output]
every = 20
END

# near KEY VALUE TOLERANCE: of the JSON in `out`
near() {
    sed -n "s/.*\"$1\": \([-0-9.e+]*\).*/\1/p" out |
        awk -v key="$1" -v v="$2" -v t="$3" \
            'NR == 1 { d = $1 - v; if (d < 0) d = -d; ok = d <= t; was = $1 }
             END { if (!ok) { print key " is " was ", wanted " v; exit 1 } }' ||
        exit 1
}

# Half of level 5's flooded flow: the independent solution's central film and
# meniscus (tests/reference/cavitation_truth.h)
sed '/time/,$d' dent.ini >steady.ini
expect 0 "$OVERROLL" steady steady.ini --json --scheme upstream2
near H_cen 0.041415 2e-6
near X_meniscus -1.12092 2e-5
near film_ratio 0.49983 1e-4
contains out '"order": 2'
expect 0 "$OVERROLL" steady steady.ini --json
contains out '"scheme": "characteristic"'
contains out '"order": 4'
expect 0 "$OVERROLL" steady steady.ini
contains out '^starvation factor .*inlet meniscus at X = -1.12'

# What arrives beyond what it takes makes no difference
expect 0 "$OVERROLL" steady steady.ini --json --set supply.thickness_1=0.3
contains out '"X_meniscus": null'
near film_ratio 1 1e-12
expect 0 "$OVERROLL" steady steady.ini --set supply.thickness_1=0.3
contains out 'flooded flow is 0\.[0-9]+ of the supply, the excess collects'

# A run, and the same in two pieces
expect 0 "$OVERROLL" run dent.ini -o whole.h5 -q
expect 0 "$OVERROLL" run dent.ini -o part.h5 -q --set time.end=1
expect 0 "$OVERROLL" resume part.h5 -q --set time.end=2
content whole.h5 >1.txt
content part.h5 >2.txt
cmp 1.txt 2.txt || fail 'resumed, it is another run'
for column in supply meniscus inflow outflow oil_inside oil_waiting \
    cavity_length mass_defect; do
    contains history.txt "$column"
done
contains snapshots.txt filling
contains snapshots.txt oil_content

# A layer along a surface: here twice as thick where the first b/2 of it lies
cat >layer.csv <<'END'
x in b, z in b^2/R
0, 0.02521
1, 0.02521
1.001, 0.05042
1.5, 0.05042
END
sed 's/thickness_1 =.*/profile_1 = layer.csv/; s/end = 2/end = 1/' \
    dent.ini >layer.ini
expect 0 "$OVERROLL" run layer.ini -o layer.h5 -q
"$OVERROLL" export layer.h5 >history.txt
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^supply /) c = i }
         NR == 2 { first = $c } { last = $c }
         END { exit !(first > 0.0755 && first < 0.0757 &&
                      last > 0.0503 && last < 0.0505) }' history.txt ||
    fail "the layer does not arrive: $(head -3 history.txt)"
refuses 'profile_1: .*thickness_1 is also set' \
    check layer.ini --set supply.thickness_1=0.1

# A layer goes by as fast as its surface, which [sliding] may say too
supplies() {
    "$OVERROLL" export "$1" | awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^supply /) c = i }
        NR > 1 { printf "%.10g\n", $c }'
}
expect 0 "$OVERROLL" run layer.ini -o 1.h5 -q --set contact.slide_to_roll=0.5
expect 0 "$OVERROLL" run layer.ini -o 2.h5 -q --set sliding.history=step \
    --set sliding.from=0.5 --set sliding.to=0.5
supplies 1.h5 >1.txt
supplies 2.h5 >2.txt
supplies layer.h5 >3.txt
cmp 1.txt 2.txt || fail 'the supply does not see [sliding]'
! cmp -s 1.txt 3.txt || fail 'the supply does not see slide_to_roll'

# What is said of it
expect 0 "$OVERROLL" check dent.ini --set supply.thickness_1=0.3
contains err 'supply of 0.325 exceeds the flooded flow rate of about 0\.[01]'
expect 0 "$OVERROLL" check dent.ini --scheme upstream2
contains err 'smear it out. Use scheme = characteristic .*, or level 8'
expect 0 "$OVERROLL" steady steady.ini --set domain.inlet=-1.3
contains err 'meniscus X = -1.1.* is closer to .* X = -1.3 .*upstream'

# Runs of the Reynolds equation know nothing of it
sed '/supply/,/thickness_2/d; s/conserving/reynolds/; s/end = 2/end = 0.1/' \
    dent.ini >plain.ini
expect 0 "$OVERROLL" run plain.ini -o plain.h5 -q
"$OVERROLL" export plain.h5 >history.txt
! grep -q meniscus history.txt || fail 'a flooded file has a meniscus'

# What does not go together
refuses 'smoother: hybrid cannot be combined' \
    check dent.ini --set paper.smoother=hybrid
refuses 'model: film needs cavitation.model = conserving' \
    check dent.ini --set cavitation.model=reynolds
# A study over supply.model goes on: what is switched off is said, not refused.
expect 0 "$OVERROLL" check dent.ini --set supply.model=flooded
contains err 'dent.ini:12: thickness_1 has no effect with model = flooded; '
sed '/thickness/d' dent.ini >none.ini
refuses 'film needs thickness_1' check none.ini

# Ratios are of the flooded film of the moment, not of the start's (0.2.0: 3
# and more for a film that is flooded), and none where nothing moves.
cat >moment.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 6
[cavitation]
model = conserving
[supply]
model = film
thickness_1 = 1
thickness_2 = 1
[speed]
history = ramp
from = 0.1
to = 1
duration = 1
[load]
history = ramp
from = 0.1
to = 1
duration = 1
[time]
end = 6
step = 0.05
END
expect 0 "$OVERROLL" run moment.ini --json
ratio=$(sed -n 's/^  "film_ratio": \([-0-9.e]*\),*$/\1/p' out)
awk "BEGIN { exit !($ratio > 0.9 && $ratio < 1.1) }" || fail "film_ratio $ratio"
expect 0 "$OVERROLL" run moment.ini --set speed.from=1 --set speed.to=0.0001
contains out '^starvation factor +undefined: the entrainment speed is nearly'
! grep 'flow is -' out || fail "$(grep 'flow is' out)"

# The error of the narrow constriction of a starved film, relative to a grid
# four times finer, is below the expected error (it was 3.9 times that).
printf '[contact]\nM = 103\nL = 7.9\n' >narrow.ini
printf '[cavitation]\nmodel = conserving\n' >>narrow.ini
printf '[supply]\nmodel = film\nthickness_1 = 0.00786\n' >>narrow.ini
at_level() {
    expect 0 "$OVERROLL" steady narrow.ini --level "$1" --json -q
    number H_min_located
}
coarse=$(at_level 8)
fine=$(at_level 10)
expect 0 "$OVERROLL" check narrow.ini --level 8 --json -q
expected=$(number expected_error)
awk -v a="$coarse" -v b="$fine" -v e="$expected" 'BEGIN {
    exit !(a / b - 1 > 1e-3 && a / b - 1 < e && e < 6e-3) }' ||
    fail "H_min $coarse, level 10 $fine, expected error $expected"
