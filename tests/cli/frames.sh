#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# frames and plot: files, resuming, rejected input, a movie.
. "$TOP/tests/support/cli.sh"
need gnuplot

dent_case 4 2 0.1 0.5 -1.5 >dent.ini
cat >>dent.ini <<'END'
surface = 1
[output]
every = 5
fields = pressure, film_thickness, roughness, viscosity
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q

# Every frame, named so that names sort; a second call draws none again.
expect 0 "$OVERROLL" frames dent.h5 -o all --size 320x240
contains out '^all: [0-9]+ frames drawn, 0 kept'
n=$(find all -name 'frame_*.png' | wc -l)
[ "$n" -ge 5 ] || fail "only $n frames"
rm all/frame_0001.png
expect 0 "$OVERROLL" frames dent.h5 -o all --size 320x240 --jobs 1
contains out "^all: 1 frames drawn, $((n - 1)) kept"
[ "$(find all -name '.*.*' | wc -l)" -eq 0 ] ||
    fail "parts are left: $(ls -A all)"

# As many gnuplots as there are cores, or one: the same bytes
expect 0 "$OVERROLL" frames dent.h5 -o many --size 320x240 --jobs 3
for file in all/*.png; do
    cmp "$file" "many/${file#all/}" || fail "$file differs with three gnuplots"
done

# Other settings are refused, or forced.
refuses 'other settings; --force' frames dent.h5 -o all --size 400x300
expect 0 "$OVERROLL" frames dent.h5 -o all --size 400x300 --force
contains out "^all: $n frames drawn, 0 kept"

# A choice of them, with what is needed to draw them again.
expect 0 "$OVERROLL" frames dent.h5 -o some --form svg --every 2 --time 0.5: \
    --script
for file in some/frame_0004.svg some/frame_0004.gp some/frame_0004.dat; do
    [ -s $file ] || fail "no $file"
done
for file in some/frame_0000.svg some/frame_0005.svg; do
    [ ! -e $file ] || fail "$file was not asked for"
done
mv some/frame_0004.svg before.svg
(cd some && gnuplot frame_0004.gp) || fail 'the script does not run'
[ -s some/frame_0004.svg ] || fail 'the script draws nothing'

# A result is no case: what it is good for.
refuses "is a result file, not a case; 'overroll resume'" run dent.h5

# One picture of two results.
expect 0 "$OVERROLL" plot dent.h5 dent.h5 --kind history -o two.pdf
refuses 'exists; --force' plot dent.h5 -o two.pdf
refuses 'a map shows one' plot dent.h5 dent.h5 --kind map -o map.png
for kind in stress risk depth plastic element; do
    refuses 'shows one result only' plot dent.h5 dent.h5 --kind $kind -o one.png
done

# A map of any field, its colours said in words where it has no symbol.
expect 0 "$OVERROLL" plot dent.h5 --kind map --field viscosity -o eta.svg
contains eta.svg 'viscosity.*eta0'
refuses "no map of 'density'" plot dent.h5 --kind map --field density -o n.png
refuses "kind 'maps'" plot dent.h5 --kind maps -o map.png
refuses 'no output: set -o' plot dent.h5
refuses 'no output: set -o' frames dent.h5
refuses 'no snapshot between' frames dent.h5 -o none --time 100:
refuses "size '1x1'" plot dent.h5 -o x.png --size 1x1
refuses 'must be a range' plot dent.h5 -o x.png --x 1:-1

# Two physical results of other scales: each curve in its own, on common axes.
# The largest pressure drawn of each is what `info` says in GPa; a file without
# scales makes all axes Hertzian, said, or is refused.
for case in a:100:1 b:400:2; do
    IFS=: read -r name load speed <<END
$case
END
    {
        printf '[contact]\nload = %s kN/m\nradius = 10 mm\n' "$load"
        printf 'modulus = 220 GPa\nviscosity = 40 mPa.s\n'
        printf 'speed_1 = %s m/s\nspeed_2 = %s m/s\n' "$speed" "$speed"
        printf '[lubricant]\nalpha = 20 1/GPa\n[domain]\nlevel = 4\n'
        printf '[time]\nend = 0.5\n[output]\nevery = 4\n'
    } >"$name.ini"
    expect 0 "$OVERROLL" run "$name.ini" -o "$name.h5" -q
    "$OVERROLL" export "$name.h5" -o "$name.csv" -q
done
largest() { # FILE INDEX: of the second column of a table of the data
    awk -v want="$2" 'BEGIN { RS = ""; FS = "\n" } NR == want + 1 {
        for (i = 1; i <= NF; i++) {
            n = split($i, a, " ")
            if (a[1] != "#" && a[2] + 0 > m) m = a[2] + 0
        }
        print m }' "$1"
}
expect 0 "$OVERROLL" plot a.h5 b.h5 --kind history -o ab.svg --script ab.gp
for k in 0 1; do
    name=$([ $k = 0 ] && echo a || echo b)
    drawn=$(largest ab.dat $((4 + k)))
    own=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++)
                if ($i ~ /^max_pressure( |$)/) c = i }
        NR > 1 && $c > m { m = $c } END { print m * 1e-9 }' "$name.csv")
    awk -v a="$drawn" -v b="$own" 'BEGIN { exit !(b > 0.1 &&
        (a - b) ^ 2 < (1e-4 * b) ^ 2) }' ||
        fail "$name.h5: largest pressure $own GPa is drawn as $drawn"
done
expect 0 "$OVERROLL" plot a.h5 b.h5 -o ab.png
expect 0 "$OVERROLL" plot a.h5 dent.h5 -o mixed.svg
contains err 'dent.h5 has no physical scales: each result is drawn'
refuses 'dent.h5: SI units' plot a.h5 dent.h5 --si -o si.svg
expect 0 "$OVERROLL" frames a.h5 dent.h5 -o mixed --every 100 --size 320x240
contains err 'dent.h5 has no physical scales'

# Numbers with units, by the scales of the first result; b is 0.108 mm, b/um
# 0.108 ms.
expect 0 "$OVERROLL" plot a.h5 -x -0.1mm:0.2mm --at 0.02ms --p-max 1GPa \
    --h-max 2um -o at.svg --script at.gp
contains at.gp 'x_from.* = \[-0.1[],]'
contains at.gp 'x_to.* = \[0.2[],]'
contains at.gp 'array y_to.* = \[1\.?[],]'
contains at.gp 't = (1[0-9]|2[0-9])\.[0-9]* µs'
expect 0 "$OVERROLL" plot a.h5 --kind history --time 10us:0.03ms -o us.svg \
    --script us.gp
contains us.gp 'x_from.* = \[10\.[],]'
contains us.gp 'x_to.* = \[30\.[],]'
refuses "unknown unit 'parsec'; allowed: s, ms, us" plot a.h5 --at 2parsec \
    -o x.png
refuses '^overroll plot: --at 99: snapshots exist only from 0 to' \
    plot dent.h5 --at 99 -o none.png
[ ! -e none.png ] || fail 'another instant was drawn'
refuses 'no physical scales; without a unit the' plot dent.h5 --at 0.2ms \
    -o x.png

# Without being asked for, the instants of largest pressure and smallest film
# are there; the heading's ph has its index; what the strip of roughness holds
# has a scale; a colour that stands for more says so; no panel is empty.
expect 0 "$OVERROLL" plot dent.h5 -o all.svg --script all.gp
"$OVERROLL" export dent.h5 --all -o all.csv -q
for what in 'p max' 'h min'; do
    contains all.gp "T = [0-9.]*: (p max, )?$what"
done
at=$(awk -F, 'NR > 1 && $3 + 0 > m { m = $3 + 0; T = $1 }
    END { printf "%.3f", T }' all.csv)
contains all.gp "T = $at: p max"
expect 0 "$OVERROLL" plot a.h5 -o ph.svg --script ph.gp

# Of several results the extremes are those of the worst, by its name; the title
# is the name of the case, and none where the cases differ.
contains all.gp "^title = 'dent'"
sed 's/depth = 0.1/depth = 0.15/' dent.ini >deep.ini
expect 0 "$OVERROLL" run deep.ini -o deep.h5 -q
"$OVERROLL" export deep.h5 --all -o deep.csv -q
at=$(awk -F, 'NR > 1 && $3 + 0 > m { m = $3 + 0; T = $1 }
    END { printf "%.3f", T }' deep.csv)
expect 0 "$OVERROLL" plot dent.h5 deep.h5 -o worst.svg --script worst.gp
contains worst.gp "T = $at: p max of deep.h5"
contains worst.gp "h min of deep.h5"
contains worst.gp "^title = ''"
printf '[contact]\nM = 20\nL = 10\n[domain]\nlevel = 4\n' >steady.ini
expect 0 "$OVERROLL" run steady.ini -o steady.h5 -q
expect 0 "$OVERROLL" plot steady.h5 -o steady.svg --script steady.gp
contains steady.gp "'steady'"
grep -q 'p max' steady.gp && fail 'a steady film has a time of p max'
contains ph.gp '\{/:Italic p\}_h = '
expect 0 "$OVERROLL" plot dent.h5 --kind map --field pressure --p-max 0.5 \
    -o clip.svg
contains clip.svg '▲ above'
expect 0 "$OVERROLL" run dent.ini -o film.h5 -q \
    --set output.fields=film_thickness
expect 0 "$OVERROLL" plot film.h5 -o film.svg --script film.gp
! grep -q 'pressure, ' film.gp || fail 'an empty panel for the pressure'

# A rough run that conserves oil: its trace is drawn (0.2.0 crashed).
expect 0 "$OVERROLL" run dent.ini -o oil.h5 -q --set cavitation.model=conserving
expect 0 "$OVERROLL" plot oil.h5 --kind trace -o trace.svg --script trace.gp
contains trace.gp 'surface height at x = 0'

# Many results: each in a colour and dash of its own, in rows of a legend that
# are no wider than the picture.
set --
for k in 1 2 3 4 5 6 7 8; do
    cp dent.h5 "a_result_of_a_long_name_$k.h5"
    set -- "$@" "a_result_of_a_long_name_$k.h5"
done
expect 0 "$OVERROLL" plot "$@" -o many.svg --script many.gp
expect 0 "$OVERROLL" plot "$@" -o history.svg --kind history --script many.gp
array() { # NAME: its elements, a line each
    sed -n "s/^array $1\[.*= \[\(.*\)\]/\1/p" many.gp | tr -d ' ' | tr ',' '\n'
}
array mark >marks
[ "$(array colour | paste - marks | sort | uniq -c | awk '{ print $1 }' |
    sort -u)" = 3 ] || fail 'two results look the same'
awk '/translate/ { split($0, part, /[(,)]/) }
    /<text>.*a_result/ { n++; if (part[2] > 0.75 * 1280) exit 1 }
    END { if (n < 8) exit 1 }' history.svg || fail 'a legend is cut off'

# What is missing is said, with how to get it.
expect 2 env PATH=/nowhere "$OVERROLL" plot dent.h5 -o x.png
contains err 'gnuplot is not installed.*apt install gnuplot-nox'
[ "$(find . -name '.*.part' | wc -l)" -eq 0 ] || fail 'parts are left'

# A gnuplot built without cairo: SVG and PNG all the same, PDF is refused.
mkdir poor
cat >poor/gnuplot <<END
#!/bin/sh
while IFS= read -r line; do
    case \$line in
    load*) sed -i "s/GPVAL_TERMINALS/'dumb png svg'/" \
        "\$(expr "\$line" : "load .\(.*\).\$")" ;;
    esac
    printf '%s\n' "\$line"
done | $(command -v gnuplot) "\$@"
END
chmod +x poor/gnuplot
for form in svg png; do
    expect 0 env "PATH=$PWD/poor:$PATH" "$OVERROLL" plot dent.h5 \
        -o "poor.$form"
done
[ "$(od -An -tx1 -N4 poor.png | tr -d ' ')" = 89504e47 ] || fail 'no PNG'
expect 1 env "PATH=$PWD/poor:$PATH" "$OVERROLL" plot dent.h5 -o poor.pdf
contains err 'no pdfcairo terminal: write an .svg or .png picture'
[ -e poor.pdf ] && fail 'a PDF of nothing'

refuses 'the name of a movie must end in' frames dent.h5 --movie m.avi
command -v ffmpeg >/dev/null || { echo 'no ffmpeg: no movie tried'; exit 0; }
for form in mp4 webm gif; do
    expect 0 "$OVERROLL" frames dent.h5 --movie "m.$form" --size 321x241
    [ -s "m.$form" ] || fail "no movie m.$form"
done
[ "$(find . -name '.*' ! -name . | wc -l)" -eq 0 ] || fail "left: $(ls -A)"
refuses 'exists; --force' frames dent.h5 --movie m.gif
contains m.gif '^GIF89a'
