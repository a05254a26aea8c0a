#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A program with only the public headers and the shared library runs a case with
# its file, resumes it, sweeps it, and runs a case of several passes (examples
# of overroll-library(3)). Its results equal those of the overroll program.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "instrumented libraries carry more than symbols"

soname=$(readelf -d "$SHARED" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
ln -s "$SHARED" "$soname"

# example NAME: compiled, to a program of that name
example() {
    sed -n "/^\\.\\\\\" $1/,/^\\.EE/p" "$TOP/src/run/overroll-library.3" |
        sed '1,2d; $d; s/\\-/-/g; s/\\e/\\/g' >"$1.c"
    # shellcheck disable=SC2086 # CC may be a command and its options
    expect 0 $CC -std=c11 -Wall -Wextra -Wpedantic -Werror -I"$TOP/include" \
        "$1.c" "$soname" -Wl,-rpath,"$PWD" -o "$1"
}

example run
cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[time]
end = 4
[feature dent]
shape = dent
start = -4.9
depth = 0.1
width = 1
[output]
every = 4
END
printf '[study]\ncase = dent.ini\n[product]\nfeature.dent.depth = 0.05, 0.1\n' \
    >depths.ini
expect 0 ./run
cp out found
expect 0 "$OVERROLL" run dent.ini -o whole.h5 --json
least=$(sed -n 's/^  "H_min_overall": \(.*\),$/\1/p' out)
contains found "^H_min = $least, 2 cases$"

# Stopped and resumed, the file is that of a run left alone.
expect 0 "$OVERROLL" export whole.h5 --all
mv out whole
expect 0 "$OVERROLL" export dent.h5 --all
cmp -s out whole || fail 'resumed from C it is another run'
[ "$(grep -c finished depths/manifest.csv)" -eq 2 ] ||
    fail "$(cat depths/*.csv)"
[ "$(wc -l <depths.csv)" -eq 3 ] || fail "$(cat depths.csv)"
expect 0 "$OVERROLL" sweep depths.ini
contains out '^2 cases: 2 finished'

# Several passes
example passes
printf '[contact]\nM = 20\nL = 10\n[domain]\nlevel = 5\n' >oil.ini
expect 0 ./passes
for k in 1 2 3 4; do
    film=$("$OVERROLL" export "oil-$k.h5" | awk -F, '
        NR == 1 { while ($++c !~ /^central_film_thickness /); }
        NR == 2 { printf "%.4g", $c }')
    contains out "^oil-$k.h5: central film $film$"
done
