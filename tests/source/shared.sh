#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A program that has nothing but the public headers and the shared library runs
# a case with its file, goes on with it and sweeps: the second example of
# overroll-library(3).  What it finds is what the program finds.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "instrumented libraries carry more than symbols"

sed -n '/^\.\\" run/,/^\.EE/p' "$TOP/src/run/overroll-library.3" |
    sed '1,2d; $d; s/\\-/-/g; s/\\e/\\/g' >user.c
soname=$(readelf -d "$SHARED" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
ln -s "$SHARED" "$soname"
# shellcheck disable=SC2086 # CC may be a command and its options
expect 0 $CC -std=c11 -Wall -Wextra -Wpedantic -Werror -I"$TOP/include" \
    user.c "$soname" -Wl,-rpath,"$PWD" -o user

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
expect 0 ./user
cp out found
expect 0 "$OVERROLL" run dent.ini -o whole.h5 --json
least=$(sed -n 's/^  "H_min_overall": \(.*\),$/\1/p' out)
contains found "^H_min = $least, 2 cases$"

# Stopped and gone on with, the file is that of a run left alone.
expect 0 "$OVERROLL" export whole.h5 --all
mv out whole
expect 0 "$OVERROLL" export dent.h5 --all
cmp -s out whole || fail 'resumed from C it is another run'
[ "$(grep -c finished depths/manifest.csv)" -eq 2 ] ||
    fail "$(cat depths/*.csv)"
[ "$(wc -l <depths.csv)" -eq 3 ] || fail "$(cat depths.csv)"
expect 0 "$OVERROLL" sweep depths.ini
contains out '^2 cases: 2 finished'
