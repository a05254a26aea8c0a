#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A reversing entrainment speed: stopped before, at and after the reversal and
# resumed, the same result to the last digit with every scheme; its domain;
# incompatible options.
. "$TOP/tests/support/cli.sh"

cat >cam.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.4
[domain]
level = 5
[time]
end = 2.4
[speed]
history = sine
mean = 0
amplitude = 1
period = 4
start = -1
[feature dent]
shape = dent
depth = 0.05
width = 1
start = -1.5
[feature bump]
surface = 2
shape = bump
height = 0.01
width = 1
start = 1
[output]
every = 4
END

# Cu = 0 at T = 8/7, the end of a step
for scheme in upstream1 upstream2 characteristic; do
    set -- run cam.ini -q --force --set time.scheme=$scheme \
        --set speed.period=4.571428571428571 \
        --set speed.start=-1.1428571428571428
    expect 0 "$OVERROLL" "$@" -o whole.h5
    content whole.h5 >whole.txt
    for end in 0.5 1.142857142857 1.2 2; do
        expect 0 "$OVERROLL" "$@" -o part.h5 --set time.end=$end
        expect 0 "$OVERROLL" resume part.h5 -q --set time.end=2.4
        content part.h5 >part.txt
        cmp whole.txt part.txt || fail "$scheme, stopped at $end, differs"
    done
done

# As long on both sides
expect 0 "$OVERROLL" check cam.ini --json
contains out '"inlet": -4,'
contains out '"outlet": 4,'
expect 0 "$OVERROLL" check cam.ini --json --set domain.inlet=-5
contains out '"outlet": 5,'
refuses "outlet: 1.5: inlet and outlet are exchanged where .speed." \
    run cam.ini -o no.h5 --set domain.outlet=1.5

# What it cannot be combined with
refuses "model: conserving cannot be combined with a speed that reverses" \
    run cam.ini -o no.h5 --set cavitation.model=conserving
[ ! -e no.h5 ] || fail 'a refused run left a file'
