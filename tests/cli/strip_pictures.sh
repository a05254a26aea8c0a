#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of a strip: maps with cuts, frames, a cut in time, rejected input.
. "$TOP/tests/support/cli.sh"
need gnuplot

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[strip]
[time]
end = 3.2
[feature dent]
shape = dent
depth = 0.08
width = 1
start = -3
[output]
every = 8
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q

# Maps are the picture of a strip.  The curves in them are rows of the file.
expect 0 "$OVERROLL" plot dent.h5 -o map.png --at 3 --script map.gp --along 0.4
[ -s map.png ] || fail "no map.png"
contains map.gp 'film thickness'
contains map.gp 'cut at y/b = 0'
contains map.gp 'cut at x/b = 0.4'
expect 0 "$OVERROLL" export dent.h5 --time 3 --field pressure -o line.csv
awk -F, 'NR > 1 && $2 > m { m = $2 } END { print m }' line.csv >most
awk -v most="$(cat most)" 'BEGIN { found = 0 }
    NF == 2 && $2 - most < 1e-9 && most - $2 < 1e-9 { found = 1 }
    END { exit !found }' map.dat ||
    fail "the largest pressure of the line, $(cat most), is not drawn"

# Colours of the film begin at its smallest value, here at the exit.
expect 0 "$OVERROLL" plot dent.h5 -o exit.png --at 1 --script exit.gp
expect 0 "$OVERROLL" export dent.h5 --time 1 --areal --units hertzian \
    -o areal.csv
awk -F, 'NR > 1 && (!m || $4 < m) { m = $4; x = $1 } END { print m, x }' \
    areal.csv >least
awk '!($2 > 0.9) { exit 1 }' least || fail "the minimum: $(cat least)"
grep '^array colour_from' exit.gp | tr -d ',' >from
awk -v least="$(cat least)" '{ d = $5 - least; exit !(d * d < 1e-16) }' from ||
    fail "$(cat from), not $(cat least)"

# Frames have one scale of colours, and a cut is drawn like a line contact.
expect 0 "$OVERROLL" frames dent.h5 -o all --size 640x480 --script
n=$(find all -name 'frame_*.gp' | wc -l)
[ "$n" -gt 5 ] || fail "$n frames"
cat all/frame_*.gp | grep -c '^array colour_to' >count
[ "$(cat count)" = "$n" ] || fail "no colours in $n frames"
cat all/frame_*.gp | grep '^array colour_' | sort -u | wc -l >count
[ "$(cat count)" = 3 ] || fail "frames have different colours"
expect 0 "$OVERROLL" plot dent.h5 -o cut.png --across 0.5
expect 0 "$OVERROLL" plot dent.h5 -o time.png --kind map --across 0.5 \
    --script time.gp
contains time.gp 'cut at y/b = 0.5'
expect 0 "$OVERROLL" plot dent.h5 -o history.png --kind history

sed '/strip/d; /time/,/end/d' dent.ini >line.ini
expect 0 "$OVERROLL" run line.ini -o line.h5 -q --set 'feature dent.start=0'
refuses 'maps across rolling need the result of a strip' \
    plot line.h5 -o no.png --kind areal
refuses 'one instant' plot dent.h5 -o no.png --at 1 --at 2
refuses 'must be a position' plot dent.h5 -o no.png --along 9
