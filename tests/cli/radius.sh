#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# [radius] in a case: report, rejected input, column of the history, a killed
# run resumed, with every scheme.
. "$TOP/tests/support/cli.sh"

cat >tooth.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.5
[domain]
level = 5
[time]
end = 2
[radius]
history = sine
amplitude = 0.3
period = 30
[feature dent]
shape = dent
depth = 0.05
width = 0.5
start = -3.9
[output]
every = 10
checkpoint = 1 us
END

expect 0 "$OVERROLL" check tooth.ini
contains out 'radius over the run .*1 to 1.122 of the ref.*; half-width 1 to'
contains out 'curvature model .*convected with the material'
expect 0 "$OVERROLL" check tooth.ini --set radius.period=2
contains out 'curvature model .*imposed'
# A contact that gets narrower wants a finer mesh
level() {
    expect 0 "$OVERROLL" check tooth.ini --set domain.level=auto \
        --set domain.accuracy=3e-3 --set radius.amplitude="$1" --set time.end=30
    grep -o 'level [0-9]*,' out | head -n 1
}
wide=$(level 0.01) narrow=$(level -0.9)
[ "$wide" != "$narrow" ] || fail "$wide for a tenth of the radius too"
refuses() {
    what=$1
    shift
    expect 2 "$OVERROLL" check tooth.ini "$@"
    contains err "$what"
}
refuses 'because at T = 0 it changes too fast' \
    --set radius.period=2 --set radius.curvature=rides
refuses 'amplitude' --set radius.amplitude=1
refuses 'must be 0.01 to 100' --set radius.history=ramp --set radius.to=0 \
    --set radius.amplitude=0
refuses 'duration: has no effect with' --set radius.duration=1
printf '0 1\n9 1.1\n12 -1\n' >bad.csv
grep -v '^amplitude\|^period' tooth.ini >table.ini
expect 2 "$OVERROLL" check table.ini --set radius.history=table \
    --set radius.file=bad.csv
contains err 'bad.csv:3: value -1'

expect 0 "$OVERROLL" run tooth.ini -o r.h5 -q --json
grep -q '"radius_ratio": *1.12' out || fail "no radius_ratio: $(cat out)"
expect 0 "$OVERROLL" export r.h5
head -n 1 out | grep -q 'radius_ratio' || fail 'no column of the radius'

# What is not surface 1's is surface 2's: in rolling no matter
printf '0 3\n2 3.5\n' >one.csv
film() {
    name=$1
    shift
    expect 0 "$OVERROLL" run tooth.ini -o "$name.h5" -q "$@"
    "$OVERROLL" export "$name.h5" --snapshot last --field film_thickness \
        >"$name.txt"
}
set -- --set radius_1.history=table --set radius_1.file=one.csv
film a --set contact.slide_to_roll=0
film b --set contact.slide_to_roll=0 "$@"
film c "$@"
film d
differ() {
    paste -d, "$1.txt" "$2.txt" | awk -F, 'NR > 1 && $2 != $4 {
        d = ($2 - $4) / $4
        if (d * d > most) most = d * d }
        END { exit !(most > 1e-12) }'
}
differ c d || fail 'in sliding it matters'
differ a b && fail 'in rolling it does not'

killed() {
    "$OVERROLL" "$@" -q &
    pid=$!
    tries=0
    while [ "$tries" -lt 500 ] && ! "$OVERROLL" info part.h5 2>&1 |
        grep -qE 'history +[1-9][0-9]* steps'; do
        sleep 0.01
        tries=$((tries + 1))
    done
    kill -9 "$pid" 2>/dev/null || :
    wait "$pid" 2>/dev/null || :
}
for scheme in upstream2 characteristic; do
    set -- run tooth.ini --force --set time.scheme=$scheme \
        --set time.end=4
    rm -f part.h5 part.h5.restart
    expect 0 "$OVERROLL" "$@" -o whole.h5 -q
    killed "$@" -o part.h5
    expect 0 "$OVERROLL" resume part.h5 -q
    content whole.h5 >1.txt
    content part.h5 >2.txt
    cmp 1.txt 2.txt || fail "$scheme: another end"
done
