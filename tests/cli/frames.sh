#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# frames and plot from the command line: files, resuming, refusals, a movie.
. "$TOP/tests/support/cli.sh"
need gnuplot

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[time]
end = 2
[feature dent]
surface = 1
shape = dent
depth = 0.1
width = 0.5
start = -1.5
[output]
every = 5
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

# One picture of two results.
expect 0 "$OVERROLL" plot dent.h5 dent.h5 --kind history -o two.pdf
refuses 'exists; --force' plot dent.h5 -o two.pdf
refuses 'a map shows one' plot dent.h5 dent.h5 --kind map -o map.png
refuses "kind 'maps'" plot dent.h5 --kind maps -o map.png
refuses 'where to' plot dent.h5
refuses 'where to' frames dent.h5
refuses 'no snapshot between' frames dent.h5 -o none --time 100:
refuses "size '1x1'" plot dent.h5 -o x.png --size 1x1
refuses 'a range such as' plot dent.h5 -o x.png --x 1:-1

# What is missing is said, with how to get it.
expect 2 env PATH=/nowhere "$OVERROLL" plot dent.h5 -o x.png
contains err 'gnuplot is not installed.*apt install gnuplot-nox'
[ "$(find . -name '.*.part' | wc -l)" -eq 0 ] || fail 'parts are left'

refuses 'a movie.s name ends in' frames dent.h5 --movie m.avi
command -v ffmpeg >/dev/null || { echo 'no ffmpeg: no movie tried'; exit 0; }
for form in mp4 webm gif; do
    expect 0 "$OVERROLL" frames dent.h5 --movie "m.$form" --size 321x241
    [ -s "m.$form" ] || fail "no movie m.$form"
done
[ "$(find . -name '.*' ! -name . | wc -l)" -eq 0 ] || fail "left: $(ls -A)"
refuses 'exists; --force' frames dent.h5 --movie m.gif
contains m.gif '^GIF89a'
