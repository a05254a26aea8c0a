#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A result rewritten by h5repack or ncks with their defaults is read like the
# original, to the last digit, and resumed.
. "$TOP/tests/support/cli.sh"
need h5repack ncks

dent_case 4 1 0.1 0.5 -2 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 2
fields = pressure, film_thickness, roughness, cavitated
END
# The columns of a table, in the order of their names: ncks sorts them.
columns() {
    awk -F, '{ for (k = 1; k <= NF; k++) c[k] = c[k] "," $k }
        END { for (k in c) print c[k] }' "$1" | sort
}

for precision in f32 f64; do
    expect 0 "$OVERROLL" run dent.ini -o first.h5 -q --force \
        --set output.precision=$precision
    expect 0 h5repack first.h5 h5repack.h5
    expect 0 ncks -O -4 first.h5 ncks.h5
    for by in h5repack ncks; do
        cp first.h5.restart $by.h5.restart
        cmp -s first.h5 $by.h5 && fail "$by changed nothing"
    done
    for end in 1 1.5; do
        for by in first h5repack ncks; do
            expect 0 "$OVERROLL" resume $by.h5 -q --set time.end=$end
            expect 0 "$OVERROLL" export $by.h5 --all
            columns out >$by.csv
            expect 0 "$OVERROLL" export $by.h5
            columns out >$by.txt
            cmp first.csv $by.csv || fail "$by, $precision: other fields"
            cmp first.txt $by.txt || fail "$by, $precision: another history"
        done
    done
done
