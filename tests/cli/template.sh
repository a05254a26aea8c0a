#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Templates: the examples of overroll-pictures(7) are drawn, contour lines have
# the value of the field, notes and legends are above panels, and a faulty
# template causes a message with the reason.
. "$TOP/tests/support/cli.sh"
need gnuplot

# example NAME: that of the manual page
page=$TOP/src/pictures/overroll-pictures.7
example() {
    sed -n "/^\\.\\\\\" $1\$/,/^\\.EE/p" "$page" | sed '1d;$d' >"$1.gp"
}
dent_case 5 3 0.1 0.5 -1.5 >dent.ini
cat >>dent.ini <<'END'
surface = 1
[output]
every = 5
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q

# A few settings, with the built-in program behind them
example journal
expect 0 "$OVERROLL" plot dent.h5 -o journal.svg --template journal.gp
contains journal.svg 'font-family="Times"'
expect 0 "$OVERROLL" plot dent.h5 -o usual.svg
cmp -s journal.svg usual.svg && fail 'the template changes nothing'

# A program of one's own
example own
expect 0 "$OVERROLL" plot dent.h5 --at 2 -o own.png --template own.gp
expect 0 "$OVERROLL" frames dent.h5 --every 10 -o own --template own.gp
refuses 'other settings; --force' frames dent.h5 --every 10 -o own
echo 'print kind, rows; plot nothing[' >wrong.gp
expect 1 "$OVERROLL" plot dent.h5 -o wrong.png --template wrong.gp
contains err 'wrong.png: gnuplot: .*expected|wrong.png: gnuplot: .*invalid'
[ ! -e wrong.png ] || fail 'a template with a mistake draws a picture'
refuses 'template no.gp: cannot be read' plot dent.h5 -o x.png \
    --template no.gp

# What stands where, said by a template: each note lies above its panel and
# below the legend, a subtitle that has no room beside the title below it.
cat >said.gp <<'END'
@chart@
set print 'said.txt'
do for [r=1:rows] { print row_top[r], above[r] * em_y, legends[r], em_y }
set print 'head.txt'
print below, head_lines, lines[1]
set print 'bar.txt'
print bar, tip - foot, row_height[2], y_to[columns + 1] - y_from[columns + 1]
END
long='A title as long as people write them who want to say what the case was,
    for whom it was made, and on which day of the year'
for size in 420x320 1280x720; do
    expect 0 "$OVERROLL" plot dent.h5 -o said.svg --template said.gp --force \
        --size $size --title "$long"
    awk '{ if ($2 < 1.3 * $3 * $4) exit 1 }' said.txt ||
        fail "$size: no room for legends: $(cat said.txt)"
    awk '{ if ($1 <= 0 || ($2 / $3 - $1 / $4) ^ 2 > 1e-10) exit 1 }' bar.txt ||
        fail "$size: the bar of the roughness has another length than it says"
    [ "$(cut -d' ' -f1 head.txt)" -eq 1 ] ||
        fail "$size: title and subtitle share a line: $(cat head.txt)"
    awk 'NR == FNR { if (FNR == 1) top = $1; next }
        /<text>.*t = |<text>.*T = / { y = at; n++
            if (y > (1 - top) * height) exit 1 }
        /translate/ { split($0, part, /[(,)]/); at = part[3] }
        END { if (!n) exit 1 }' height="${size#*x}" said.txt said.svg ||
        fail "$size: a note lies in its panel"
done

# Contours lie, within half a cell, where the field between the cells' middles
# has their value.
cat >rings.gp <<'END'
@chart@
set print 'rings.txt'
print $equal
set print 'grid.txt'
print x_from[rows], x_to[rows], y_from[rows], y_to[rows], cells_x[rows], \
  cells_y[rows], image[rows]
END
expect 0 "$OVERROLL" plot dent.h5 --kind stress --at 2 -o rings.png \
    --template rings.gp --script all.gp --hertzian
table=$(cut -d' ' -f7 grid.txt)
awk -v table="$table" 'BEGIN { RS = ""; FS = "\n" }
    NR == table + 1' all.dat | grep -v '^#' >field.txt
awk 'FILENAME == "grid.txt" { x0 = $1; dx = ($2 - $1) / $5
        y0 = $3; dy = ($4 - $3) / $6; nx = $5; ny = $6; next }
    FILENAME == "field.txt" { for (i = 1; i <= NF; i++) v[FNR, i] = $i; next }
    NF == 3 && $1 + 0 == $1 { u = ($1 - x0) / dx - .5; w = ($2 - y0) / dy - .5
        i = int(u); j = int(w); a = u - i; b = w - j; i++; j++
        if (i >= nx || j >= ny) next
        f = (1 - b) * ((1 - a) * v[j, i] + a * v[j, i + 1]) + \
            b * ((1 - a) * v[j + 1, i] + a * v[j + 1, i + 1])
        gx = v[j, i + 1] - v[j, i]; gy = v[j + 1, i] - v[j, i]
        away = sqrt((f - $3) ^ 2 / (gx * gx + gy * gy + 1e-12))
        n++; if (away > worst) worst = away }
    END { print n, worst; exit !(n > 100 && worst < 0.5) }' \
    grid.txt field.txt rings.txt >fit ||
    fail "contours do not lie where the field has their value: $(cat fit)"

# The line that is 8 meshes deep is there, though rounded data has both of its
# ends outside of the axis.
expect 0 "$OVERROLL" plot dent.h5 --kind stress --at 2 --hertzian \
    -x -1.2345678:1.3456789 -o deep.svg
contains deep.svg "rgb\(255, 255, 255\)' stroke-dasharray"
