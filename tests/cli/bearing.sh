#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Rollers in sequence on a dented raceway, the example bearing 209 on a coarse
# level: three rollers met by one point with the loads of an independent
# program (truth of tests/reference/elements_test.c), another roller each time,
# replenishment between them, and combined lives.
. "$TOP/tests/support/cli.sh"

# The dent starts at the inlet of a coarse grid, X = -4.
sed 's/^end = 19/end = 12/
    s/^start = -13/start = -7/' "$TOP/tools/examples/bearing.ini" >three.ini
expect 0 "$OVERROLL" run three.ini -q -o three.h5 --json --set domain.level=5 \
    --set feature.dent.depth=0.3um --set feature.dent.shoulder=0.05um
mv out three.json
expect 0 "$OVERROLL" export three.h5
mv out three.csv
for k in 1 2 3; do
    expect 0 "$OVERROLL" export "three-$k.h5"
    mv out "$k.csv"
done

# column NAME, of the file read now
column='
    FNR == 1 { for (i = 1; i <= NF; i++) {
        name = $i
        sub(" .*", "", name)
        at[FILENAME, name] = i } }
    function of(name) { return $at[FILENAME, name] }
    function near(a, b, by) { return (a - b) ^ 2 <= (by * b) ^ 2 }'

# The load of each is carried from its start to its end
for k in 1 2 3; do
    awk -F, "$column"'
        FNR > 1 {
            w = n == 2 ? 1 : 309.095281596226 / 1967.23911105236
            if (!near(of("load"), w * atan2(0, -1) / 2, 1e-3)) bad = of("load")
            if (!near(of("load_ratio"), w, 1e-12)) bad = of("load_ratio")
        }
        END { print bad; exit bad != "" }' n=$k $k.csv >bad ||
        fail "pass $k carries $(cat bad)"
done

# What arrives at the second: of the raceway what lay there, of the roller what
# was there before the dent; both less a fifth, then back by 1 - exp(-1/2), in
# 12.34 mm at 3.323 m/s, to what a flooded contact leaves, not above
awk -F, "$column"'
    FNR == 1 { next }
    FILENAME == "1.csv" {
        T[m] = of("time")
        f[m++] = of("outflow")
        next
    }
    function between(t,    j) {
        j = int(t / T[1])
        return j + 1 < m ? f[j] + (t / T[1] - j) * (f[j + 1] - f[j]) : f[m - 1]
    }
    function later(h) {
        h *= 0.8
        return h < full ? full - (full - h) * kept : h
    }
    FILENAME == "2.csv" && rows++ {
        if (!speed) speed = 3.32312422143476
        full = f[0] / speed / 2
        left = of("time") + 5.5 * b / speed
        wanted = later(between(left) / speed / 2) + later(f[0] / speed / 2)
        if (!near(of("supply"), wanted, 1e-9)) bad = of("supply") ", " wanted
        if (wanted > high) high = wanted
        if (!low || wanted < low) low = wanted
    }
    BEGIN { kept = exp(-0.0123399515438254 / 3.32312422143476 / 6e-3) }
    END {
        if (!(high > 1.02 * low)) bad = "no wake " low " " high
        print bad
        exit bad != ""
    }' b="$(sed -n 's/^ *"half_width_m": \(.*\),$/\1/p' three.json)" \
    1.csv 2.csv >bad || fail "arrives: $(cat bad)"

# Lives: of each by its equivalent length, together by Palmgren and Miner, of
# the inner raceway of 54.991 mm; the risk of a load goes with its power 4.5,
# where the least depth is no matter. $1: the table, $2: raceway, $3: load ratio
check_lives() {
    awk -F, "$column"'
        FNR > 1 {
            e = 9 / 8
            each = (1 + 30 * of("equivalent_length") / l) ^ (-1 / e)
            if (!near(of("life_ratio"), each, 1e-9)) bad = "alone " each
            part = of("risk_smooth") ^ (1 / e)
            smooth += part
            real += part / each
            if (!near(of("life_ratio_together"), smooth / real, 1e-9))
                bad = "together " smooth / real
            if (w && of("pass") == 2 &&
                !near(risk / of("risk_smooth"), w ^ 4.5, 0.3))
                bad = "risks " risk / of("risk_smooth")
            risk = of("risk_smooth")
            last = of("life_ratio_together")
        }
        END {
            if (!near(last, told, 1e-12)) bad = "tells " told
            print bad
            exit bad != ""
        }' told="$(sed -n 's/^ *"life_ratio_together": \(.*\),$/\1/p' \
        "$1.json")" l="$2" w="$3" "$1.csv" >bad || fail "lives: $(cat bad)"
}
check_lives three 0.17275932 0
# The same without a bearing, loads and lengths as they are given
sed '/^\[roller_bearing\]/,/^passes/d
    s/^modulus.*/&\nradius = 5 mm\nhertz_pressure = 1.5 GPa/
    s/\nradius = 5 mm/&\nmean_speed = 4 m\/s/
    s/^again/number = 3\nloads = 0.5, 1, 0.5\nspacing = 12 mm\n&/
    s/^count/raceway = 150 mm\n&/' three.ini >plain.ini
expect 0 "$OVERROLL" run plain.ini -q -o plain.h5 --json --set domain.level=5 \
    --set feature.dent.depth=0.3um --set feature.dent.shoulder=0.05um
mv out plain.json
expect 0 "$OVERROLL" export plain.h5
mv out plain.csv
check_lives plain 0.15 0.5

# In one piece or resumed: the same
rm three-2.h5* three-3.h5*
expect 0 "$OVERROLL" resume three.h5 -q
expect 0 "$OVERROLL" export three.h5
cmp -s out three.csv || fail 'resumed it is another run'

# What does not go together
refuses 'loads: 2 loads are given for 3' check plain.ini --set passes.loads=1,2
sed '/^spacing/d' plain.ini >near.ini
refuses 'recovery: needs passes.spacing' check near.ini
refuses 'recovery: surface 1 does not move' check plain.ini \
    --set contact.slide_to_roll=-2

# What is said before
expect 0 "$OVERROLL" check three.ini
contains out '^#   load zone +1 of the reference load at most'
contains out '^#   roller spacing +[0-9.]+ \(12.34 mm\), T'
expect 0 "$OVERROLL" check plain.ini
contains out '^#   replenishment +39.3 % of the missing layer'
