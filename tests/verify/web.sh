#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The program in a page (make web) in a headless Chromium: it loads from disk,
# solves, runs, pauses and stops, and its numbers are those of the program here.
. "$TOP/tests/support/cli.sh"
need clang wasm-ld node chromium chromedriver
need_python h5py
[ -e /usr/include/wasm32-wasi ] || skip 'no wasi-libc'
expect 0 make -s -C "$TOP" BUILD="$BUILD" web
[ "$(wc -c <"$BUILD/web/overroll.html")" -le 6000000 ] || fail 'more than 6 MB'
# (The program itself is one long line.)
if grep -v '^H4sI' "$BUILD/web/overroll.html" |
    grep -nE '(src|href)="|https?://|@import|url\('; then
    fail 'the page refers to something else'
fi

cat >dent.ini <<'END_OF_CASE'
[contact]
load = 3.07e5 N/m
radius = 10 mm
modulus = 226 GPa
viscosity = 40 mPa.s
speed_1 = 1.4 m/s
speed_2 = 1.2 m/s
[lubricant]
alpha = 17 1/GPa
[domain]
level = 5
[time]
end = 3
[feature dent]
surface = 1
shape = dent
depth = 0.1
width = 0.5
start = -1.8
[output]
every = 3
END_OF_CASE
expect 0 "$OVERROLL" run dent.ini -o dent.h5 --json
cp out dent.json
expect 0 "$OVERROLL" view dent.h5 --live -o live.html
grep -q 'id="given">{"case":"' live.html || fail 'no case in the live page'
for kind in numbers roller discs hot; do
    expect 0 "$OVERROLL" init $kind --set domain.level=6 -o $kind.ini
    expect 0 "$OVERROLL" steady $kind.ini --json
    cp out $kind.json
done
"$PYTHON" "$TOP/tests/verify/web.py" "$PWD" \
    "$(realpath "$BUILD/web/overroll.html")"
