#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A strip from the case to its file: fields (time, y, x), lines and areas,
# resume to the bit, estimated size, rejected input.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[strip]
width = 2
[time]
end = 1
[feature dent]
shape = dent
depth = 0.08
width = 1
start = -2
across = 0.5
[output]
every = 4
END

expect 0 "$OVERROLL" run dent.ini -o whole.h5 --json
number Y_H_min_overall >least
[ -s least ] || fail "no Y of the minimum film thickness"

# Dimensions and coordinates as netCDF's own tools see them.
if command -v ncdump >/dev/null; then
    ncdump -h whole.h5 >head.txt
    for line in 'float pressure(time, y, x)' 'float roughness(time, y, x)' \
        'float film_thickness(time, y, x)' 'x:axis = "X"' \
        ':format_version = 3' ':shown_over_b = 0.5' \
        'output.precision = "f32"'; do
        grep -qF "$line" head.txt || fail "no '$line' in the header"
    done
    # With both axes ParaView draws the strip on a sphere.
    ! grep -F 'y:axis' head.txt || fail "y has an axis"
fi

expect 0 "$OVERROLL" info whole.h5
contains out 'nodes +113 x 28 lines, a strip 2 b wide'

# All lines at once and one after the other are the same numbers.
expect 0 "$OVERROLL" export whole.h5 --snapshot last --areal -o all.csv
for y in -1 0 0.5; do
    expect 0 "$OVERROLL" export whole.h5 --snapshot last --across $y -o one.csv
    rm -f some.csv
    awk -F, -v y=$y 'NR > 1 { d = $2 - y; if (d < 1e-9 && d > -1e-9)
        print $1 "," $3 "," $4 "," $5 }' all.csv >some.csv
    [ "$(wc -l <some.csv)" = 113 ] || fail "line $y is not in the area"
    tail -n +2 one.csv | cmp - some.csv || fail "line $y differs"
    rm -f one.csv
done
[ "$(wc -l <all.csv)" = $((113 * 28 + 1)) ] || fail "rows of the area"

# The line that is shown is that of the dent.
expect 0 "$OVERROLL" export whole.h5 --snapshot last -o shown.csv
expect 0 "$OVERROLL" export whole.h5 --snapshot last --across 0.5 -o dent.csv
cmp shown.csv dent.csv || fail "the line of the dent is not shown"

# A longer run, of all lines at each snapshot, has the bits of the whole one.
expect 0 "$OVERROLL" run dent.ini -o part.h5 --set time.end=0.45
contains out 'Grid: level 4, 113 nodes x 28 lines; scheme characteristic'
expect 0 "$OVERROLL" resume part.h5 --set time.end=1 --json
number Y_H_min_overall | cmp - least || fail "Y of the minimum after resume"
for file in whole part; do
    content $file.h5 >$file.txt
    for k in 0 2 4 last; do
        "$OVERROLL" export $file.h5 --snapshot $k --areal >>$file.txt
    done
done
cmp whole.txt part.txt || fail "resumed run differs"

# Nor does a run with threads, which may be others after it was resumed.
expect 0 "$OVERROLL" run dent.ini -o shared.h5 -q --set strip.threads=2 \
    --set time.end=0.45
expect 0 "$OVERROLL" resume shared.h5 -q --set time.end=1 --set strip.threads=3
for k in 0 2 4 last; do
    for file in whole shared; do
        "$OVERROLL" export $file.h5 --snapshot $k --areal >$file.csv
    done
    cmp whole.csv shared.csv || fail "snapshot $k with threads differs"
done

# Nor does a run differ that was killed after a checkpoint.
"$OVERROLL" run dent.ini -o cut.h5 -q --set 'output.checkpoint=1 us' &
run=$!
while { [ ! -e cut.h5 ] || [ ! -e cut.h5.restart ]; } &&
    kill -0 $run 2>/dev/null; do :; done
kill -KILL $run 2>/dev/null
status=0
wait $run 2>/dev/null || status=$?
[ $status = 137 ] || fail "the run ended before it was killed: $status"
expect 0 "$OVERROLL" resume cut.h5 -q
content cut.h5 >cut.txt
for k in 0 2 4 last; do
    "$OVERROLL" export cut.h5 --snapshot $k --areal >>cut.txt
done
cmp whole.txt cut.txt || fail "run after a kill differs"

# Three fields of 113 x 28 floats for each of 8 snapshots, the history and
# 0.3 MB, which the file does not exceed.
expect 0 "$OVERROLL" check dent.ini --json
number disk_bytes >bytes
awk -v size="$(wc -c <whole.h5)" '$1 < 96 * 113 * 28 + 300000 ||
    $1 > 102 * 113 * 28 + 300000 || $1 < size { exit 1 }' bytes ||
    fail "size of the file: $(cat bytes)"

# A groove of five film thicknesses grows out of smooth surfaces.  The cost of
# that is predicted within ten times.  Cycles stand for time.
cat >groove.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[strip]
[time]
end = 0.02
[feature groove]
shape = groove
depth = 0.4
width = 0.5
start = -0.3
END
for depth in 0.01 0.4; do
    expect 0 "$OVERROLL" check groove.ini --json \
        --set feature.groove.depth=$depth
    number estimated_seconds >>costs
    expect 0 "$OVERROLL" run groove.ini -o groove.h5 --force --json \
        --set feature.groove.depth=$depth
    number cycles_total >>costs
done
grep -q '"way": "from smooth surfaces' out || fail "the groove did not grow"
paste -s -d ' ' costs | awk '{ r = $3 / $1 / ($4 / $2)
    exit !(r > 0.1 && r < 10 && $4 < 3000) }' ||
    fail "predicted seconds and cycles, shallow and deep: $(cat costs)"

# Two threads take less time, but more than half of it.
expect 0 "$OVERROLL" check dent.ini --json
number estimated_seconds >alone
expect 0 "$OVERROLL" check dent.ini --json --set strip.threads=2
number estimated_seconds | paste alone - >both
awk '!($2 < 0.9 * $1 && $2 > 0.5 * $1) { exit 1 }' both ||
    fail "times with one and two threads: $(cat both)"

expect 2 "$OVERROLL" export whole.h5 --areal
contains err '--areal needs --snapshot or --time'
sed '/strip/,/width = 2/d; /time/,$d' dent.ini >line.ini
expect 0 "$OVERROLL" run line.ini -o line.h5 -q
expect 2 "$OVERROLL" export line.h5 --across 0
contains err 'has no lines across rolling'

# A key without effect does not change the steps.
expect 0 "$OVERROLL" check dent.ini --json
number steps >steps
expect 0 "$OVERROLL" check dent.ini --json --set boundary.passes=2
number steps | cmp - steps || fail "steps with passes without a law"

# A long domain has long meshes: eight lines are halved, fewer are not.
printf '%s\n' '[contact]' 'M = 0.2' 'L = 7' '[strip]' 'width = 2' >light.ini
expect 0 "$OVERROLL" check light.ini --set domain.level=5
contains out '2 b wide, periodic; 225 x 8 nodes'
refuses 'is too narrow for mesh sizes of .* set a width of at least' \
    check light.ini --set domain.level=5 --set strip.width=0.5

# The level that a refusal offers fits.
refuses 'level: 14 .* memory.*level [0-9]+ fits' \
    check dent.ini --set domain.level=14
level=$(sed 's/.*level \([0-9]*\) fits.*/\1/' err)
expect 0 "$OVERROLL" check dent.ini --set domain.level="$level"
refuses "level: $((level + 1)) .* level $level fits" check dent.ini \
    --set domain.level=$((level + 1))
refuses 'width: .* coarsest grid .* set a width of at most' check dent.ini \
    --set strip.width=1000

# The numbers of lines that a refusal offers are accepted.
refuses 'lines: 64 have .* set 10 to 40 lines' check dent.ini \
    --set strip.lines=64
for lines in 10 40; do
    expect 0 "$OVERROLL" check dent.ini --set strip.lines=$lines
done

# Refused at once, whatever a line contact would need in addition.
while read -r setting words; do
    refuses "$words cannot be combined with a strip" check dent.ini \
        --set "$setting"
done <<'END'
heat.model=lobatto model: lobatto
supply.model=film model: film
passes.number=3 number: 3
boundary.law=profile law: surfaces that touch
plastic.surface=1 surface: plastic deformation
stress.surface=1 surface: stresses
END
for section in stress plastic fatigue; do
    { cat dent.ini && echo "[$section]"; } >with.ini
    refuses "cannot be combined with a strip; use no .$section" check with.ini
done
# Its solver has its own cycles.
for key in cycle=W sweeps_before=2 sweeps_after=2 coarsest_level=2; do
    refuses "${key%=*}: has no effect beside .strip.\$" check dent.ini \
        --set solver.$key
done
refuses 'angle: 100 deg must be -90 to 90 deg' check dent.ini \
    --set feature.dent.angle='100 deg'
refuses 'thickness: a coating cannot be combined with a strip' check dent.ini \
    --set 'coating 1.material=dlc' --set 'coating 1.thickness=2 um'

# A bearing whose passes follow from its drawing.
expect 0 "$OVERROLL" init bearing -o bearing.ini
sed -i '/^\[cavitation\]/,/^$/d' bearing.ini
refuses 'several passes cannot be combined with a strip' check bearing.ini \
    --set strip.width=2

# Longitudinal waves in a shear-thinning film are solved at once.
cat >thin.ini <<'END'
[contact]
M = 20.66
L = 3.63
[lubricant]
rheology = eyring
eyring_number = 0.4
[domain]
level = 5
[strip]
width = 1.133
[feature wave]
shape = wave
amplitude = 0.003
wavelength = 0.28325
angle = 90 deg
END
for slide in 0 0.1 2; do
    expect 0 "$OVERROLL" run thin.ini --set contact.slide_to_roll=$slide
    [ ! -s err ] || fail "slide $slide: $(cat err)"
    contains out 'converged in [12][0-9] cycles'
done

# Domains on which the coarsest grid has no solution: the film of the line
cat >line.ini <<'END'
[contact]
M = 2.03
L = 0.0129
[domain]
level = 4
inlet = -4
END
for M in 2.03 2.5; do
    for outlet in 2.8 3 3.2; do
        set -- --M $M --set domain.outlet=$outlet --json
        expect 0 "$OVERROLL" run line.ini "$@"
        number H_cen >of_line
        expect 0 "$OVERROLL" run line.ini "$@" --set strip.width=2.1
        number H_cen | paste - of_line | awk '{ exit !($1 > 0 &&
            ($1 - $2)^2 < (1e-3 * $2)^2) }' ||
            fail "M $M, outlet $outlet: $(number H_cen), $(cat of_line)"
    done
done
