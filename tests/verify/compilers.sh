#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# gcc and clang compute the same run within 1e-9, and comparisons of numbers
# also hold with the optimizer of clang.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "once is enough"
need gcc clang

dent_case 7 3 0.1 0.5 -3 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 20
END

for compiler in gcc clang; do
    make -s -C "$TOP" CC=$compiler BUILD="$PWD/$compiler" \
        "$PWD/$compiler/overroll" >log 2>&1 || fail "$compiler: $(cat log)"
    expect 0 "$compiler/overroll" run dent.ini -o $compiler.h5 -q
    expect 0 "$compiler/overroll" export $compiler.h5 --all
    mv out $compiler.csv
done

# Every number beside its counterpart.
paste -d ';' gcc.csv clang.csv | awk -F ';' '
    {
        n = split($1, a, ","); m = split($2, b, ",")
        if (n != m) { print "line " NR " differs"; bad = 1; exit }
        for (i = 1; i <= n; i++) {
            d = a[i] - b[i]
            if (d < 0) d = -d
            if (d > worst) worst = d
            count++
        }
    }
    END {
        print count " numbers, largest difference " worst + 0
        exit bad || count < 1000 || worst > 1e-9
    }' || fail "gcc and clang differ"

make -C "$TOP" CC=clang BUILD="$PWD/clang" check \
    ONLY="unit/kernels_test unit/plain_test unit/determinism_test \
unit/stress_test unit/flow_test unit/heat_test unit/film_test \
unit/residuals_test reference/march_test reference/cavitation_test \
reference/heat_test reference/newton_test cli/run"
