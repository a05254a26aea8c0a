#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs with shear thinning and reversing sliding, killed and resumed: the same
# result to the last digit for each rheological model.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
G = 4000
slide_to_roll = 0.5
[domain]
level = 5
[time]
end = 4
[sliding]
history = sine
amplitude = 1
period = 3
[feature dent]
shape = dent
depth = 0.05
width = 0.5
start = -3.9
[output]
every = 20
checkpoint = 10 ms
END
awk 'BEGIN {
    print "rate [1/s], stress [MPa]"
    for (k = 0; k < 40; k++) {
        y = exp(-4 + 0.4 * k)
        printf "%.9g, %.9g\n", 1e5 * y, 5 * y * (1 + y) ^ -0.6
    }
}' >law.csv

killed() {
    "$OVERROLL" "$@" -q &
    pid=$!
    tries=0
    while { [ ! -e part.h5 ] || [ ! -e part.h5.restart ]; } &&
        [ "$tries" -lt 500 ]; do
        sleep 0.01
        tries=$((tries + 1))
    done
    kill -9 "$pid" 2>/dev/null || :
    wait "$pid" 2>/dev/null || :
}
for law in 'eyring --set lubricant.eyring_number=0.3' \
    'carreau --set lubricant.carreau_number=0.1' \
    'table --set lubricant.rheology_file=law.csv'; do
    # shellcheck disable=SC2086
    set -- run dent.ini --force --set lubricant.rheology=$law
    rm -f part.h5 part.h5.restart
    expect 0 "$OVERROLL" "$@" -o whole.h5 -q
    killed "$@" -o part.h5
    expect 0 "$OVERROLL" resume part.h5 -q
    content whole.h5 >1.txt
    content part.h5 >2.txt
    cmp 1.txt 2.txt || fail "$law: another end"
done
