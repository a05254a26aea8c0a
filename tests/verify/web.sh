#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The web page of the program (make web) in a headless Chromium: it loads from
# disk, solves, runs, pauses and stops, and its numbers are those of the
# program.
. "$TOP/tests/support/cli.sh"
need clang wasm-ld node chromium chromedriver
need_python h5py
[ -e /usr/include/wasm32-wasi ] || skip 'no wasi-libc'
expect 0 make -s -C "$TOP" BUILD="$BUILD" web web-base
[ "$(wc -c <"$BUILD/web/overroll.html")" -le 6000000 ] || fail 'more than 6 MB'
# (The program itself is one long line; the name of SVG is no address.)
if grep -v '^H4sI' "$BUILD/web/overroll.html" |
    sed 's,xmlns="http://www.w3.org/2000/svg",,' |
    grep -nE '(src|href)="|https?://|@import|url\([^#]'; then
    fail 'the page refers to something else'
fi

# Cases of every kind, solved here by the kernels that the page has.
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
eyring='rheology = eyring\neyring_stress = 5 MPa\nlimiting_shear = 0.08'
sed "s/^alpha.*/&\n$eyring/" dent.ini >eyring.ini
{ cat dent.ini && printf '[stress]\nsurface = 1\n[fatigue]\n'; } >stress.ini
{
    sed -e 's/^end = .*/end = 0.4/' \
        -e 's/^start = .*/&\nacross = 0\nwidth_across = 0.5/' dent.ini
    echo '[strip]'
} >strip.ini
cp "$TOP/profiles/ground.csv" .
sed -e 's,\.\./\.\./profiles/,,' -e 's/^level = .*/level = 5/' \
    -e 's/^passes = .*/passes = 1e3/' \
    "$TOP/tools/examples/running-in.ini" >wear.ini
sed -e '/^wear/d' -e '/^passes/d' wear.ini >mixed.ini
for kind in numbers roller discs hot gear cam bearing starved indented \
    coated; do
    expect 0 "$OVERROLL" init $kind --set domain.level=5 -o $kind.ini
done
sed -i 's/^level = 5/level = 6/' coated.ini
{ cat hot.ini && sed -n '/^\[time/,/^start/p' dent.ini; } >warm.ini
sed -i 's/^number = .*/number = 3/' starved.ini
for case in *.ini; do
    name=${case%.ini}
    expect 0 "$BUILD/web/overroll-base" run "$case" -o "$name.h5" --json
    cp out "$name.json"
done
expect 0 "$OVERROLL" view dent.h5 --live -o live.html
grep -q 'id="given">{"case":"' live.html || fail 'no case in the live page'
"$PYTHON" "$TOP/tests/verify/web.py" "$PWD" \
    "$(realpath "$BUILD/web/overroll.html")"
