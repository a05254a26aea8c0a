#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The page of a strip in a headless Chromium: its maps have the values of the
# file at the cross-hair; long runs are made coarser, and the page says so.
. "$TOP/tests/support/cli.sh"
need chromium

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[strip]
[time]
end = 2
[feature dent]
shape = dent
depth = 0.08
width = 1
centre = -0.3
across = 0.5
[output]
every = 8
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q
expect 0 "$OVERROLL" view dent.h5 -o dent.html
timeout 100 chromium --headless --no-sandbox --disable-gpu \
    --virtual-time-budget=5000 --dump-dom "file://$PWD/dent.html" \
    >dom.txt 2>chromium.txt || skip "chromium does not run"
# The page opens at the minimum film thickness.
shot=$(sed -n 's/.*data-drawn="\([0-9]*\)".*/\1/p' dom.txt | head -n 1)
[ "$shot" ] || fail "the page was not drawn"
sed -n 's/.*data-cut="\([^"]*\)".*/\1/p' dom.txt | head -n 1 >place
[ -s place ] || fail "no cross-hair in the page"

# A level is 1/2047 of the range of all snapshots.
expect 0 "$OVERROLL" export dent.h5 --snapshot "$shot" --areal \
    --units hertzian -o areal.csv
awk -v cut="$(cat place)" -F, 'BEGIN { split(cut, c, " ") }
    NR > 1 && ($1 - c[1]) ^ 2 + ($2 - c[2]) ^ 2 < 1e-12 {
        found = ($3 - c[3]) ^ 2 < 1e-6 && ($4 - c[4]) ^ 2 < 1e-8 }
    END { exit !found }' areal.csv || fail "cross-hair: $(cat place)"
awk '$2 != 0.5 { exit 1 }' place || fail "the cross-hair is not on the dent"

# Levels of the film begin at the smallest one of all snapshots.
"$OVERROLL" info dent.h5 | sed -n 's/^snapshots *//p' >shots
for k in $(seq 0 $(($(cat shots) - 1))); do
    "$OVERROLL" export dent.h5 --snapshot "$k" --areal --units hertzian |
        tail -n +2
done | awk -F, '!m || $4 < m { m = $4; x = $1 } END { print m, x }' >least
awk '!($2 > 0.9) { exit 1 }' least || fail "the minimum: $(cat least)"
sed -n 's/.*"H":{"levels":2048,"from":\([0-9.e+-]*\),.*/\1/p' dent.html >from
awk -v least="$(cat least)" '{ d = $1 - least; exit !(d * d < 1e-20) }' from ||
    fail "levels from $(cat from), not $(cat least)"
