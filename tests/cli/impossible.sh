#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Cases without solution: a message of one line, exit code 1, and the last
# state stored for inspection without NaN.
. "$TOP/tests/support/cli.sh"

# gives_up REASON ARGUMENTS...
gives_up() {
    reason=$1
    shift
    expect 1 "$OVERROLL" "$@" -q
    contains err "^(overroll: )?$reason"
    [ "$(wc -l <err)" -eq 1 ] || fail "not one line: $(cat err)"
}

# kept FILE REASON: the file says why, all in it are numbers, and it ends with
# a snapshot; $steps: rows of its history, $converged: of the last one.
kept() {
    expect 0 "$OVERROLL" info "$1"
    contains out "^status +failed: $2"
    expect 0 "$OVERROLL" export "$1"
    steps=$(($(wc -l <out) - 1))
    converged=$(awk -F , 'NR == 1 { for (i = 1; i <= NF; i++)
        if ($i ~ /^converged/) c = i } END { print $c }' out)
    end=$(tail -n 1 out | cut -d , -f 2)
    cut -d , -f 1-8 out >all # the spike may be none, which is NaN
    expect 0 "$OVERROLL" export "$1" --at 0
    tail -n 1 out | awk -F , -v end="$end" '{ exit !($1 >= end) }' ||
        fail "$1: the last snapshot is before T = $end: $(tail -n 1 out)"
    expect 0 "$OVERROLL" export "$1" --all
    [ "$(wc -l <out)" -gt 100 ] || fail "$1: no snapshot"
    cat out >>all
    # numbers of a start without a film are withheld (NaN)
    [ "$1" = start.h5 ] || [ "$1" = strip.h5 ] || ! grep -qiE 'inf|nan' all ||
        fail "$1: not all are numbers"
}

# A ridge that grows until the surfaces touch, amid a run that is to store
# hardly anything
cat >wall.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
outlet = 1.5
[time]
end = 4
[feature wall]
shape = ridge
height = 30
width = 0.3
start = 0
grow = 4
[output]
every = 100000
END
touch='the surfaces touch at T = 0\.[0-9]+: film thickness H = .* at X = '
gives_up "$touch" run wall.ini -o wall.h5
kept wall.h5 "$touch"
[ "$steps" -gt 3 ] && [ "$converged" = 1 ] || fail "$steps steps, $converged"
gives_up "$touch" run wall.ini # no file, the same words
sed 's/^every = .*/at = 3.5/' wall.ini >at.ini # a moment never reached
gives_up "$touch" run at.ini -o at.h5
kept at.h5 "$touch"

# Resuming tries that step again, and says the same
before=$steps
gives_up "$touch" resume wall.h5
kept wall.h5 "$touch"
[ "$steps" -eq "$before" ] || fail "$steps steps, $before before"
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot wall.h5 -o wall.png
    [ -s wall.png ] || fail 'no picture'
fi

# A ridge of thirty films from the start, which films do not reach as it grows:
# the state is no solution and says so
touch='the surfaces touch at T = 0: film thickness H = -.* at X = '
sed '/^grow/d' wall.ini >start.ini
gives_up "$touch" run start.ini -o start.h5
kept start.h5 "$touch"
[ "$steps" -eq 1 ] && [ "$converged" = 0 ] || fail "$steps steps, $converged"
expect 1 "$OVERROLL" resume start.h5 # begins again, not from that state
contains err 'the run starts again'
kept start.h5 "$touch"
[ "$steps" -eq 1 ] || fail "$steps steps"

# A film too thin for the grid, with the level that resolves it (by the gap this
# one is solved)
thin='the film is too thin for the grid: .*; level [0-9]+ resolves it$'
printf '[contact]\nM = 900\nL = 5\n[domain]\nlevel = 6\n' >thin.ini
echo 'faces = arithmetic' >>thin.ini
gives_up "$thin" steady thin.ini
expect 1 "$OVERROLL" steady thin.ini --json
contains out '"converged": false'
! grep -qiE 'inf|nan' out || fail "$(cat out)"
gives_up "$thin" run thin.ini -o thin.h5
kept thin.h5 "$thin"
[ "$steps" -eq 1 ] && [ "$converged" = 0 ] || fail "$steps steps, $converged"
level=$(sed -n "s/.*; level \([0-9]*\) resolves it\$/\1/p" err)
expect 0 "$OVERROLL" steady thin.ini --level "${level:-9}"

# A film that no level resolves, and a contact at nearly no speed whose load is
# carried by the boundary layers: the conditions to change
beyond='the film is too thin for the grid: .*; no level up to 14 resolves it; '
beyond="${beyond}use a higher speed or viscosity"
cat >layer.ini <<'END'
[contact]
hertz_pressure = 0.5 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 1e-9 m/s
[lubricant]
viscosity = 30 mPa.s
alpha = 18 1/GPa
[domain]
level = 6
[boundary]
law = layer
layer = 5 nm
layer_decay = 2 nm
END
gives_up "$beyond .asperities carry nearly all of the load.$" run layer.ini \
    -o layer.h5

# None of these: how far it came, after all strategies
far='the steady solution did not converge with any of 4 strategies: relative '
printf '[contact]\nM = 20\nL = 10\n' >far.ini
gives_up "$far" run far.ini -o far.h5 --set solver.max_cycles=1
kept far.h5 "$far"

# What no arithmetic can meet
below='tolerance = 1.0e-16 is below rounding error on this grid: the res'
gives_up "$below" run far.ini -o below.h5 --set solver.tolerance=1e-16
kept below.h5 "$below"

# Another strategy is reported (some of these are too thin for the grid; by the
# gap they need none)
told=
for M in 200 300 400 500; do
    "$OVERROLL" steady --M $M --L 3 --level 6 --json \
        --set domain.faces=arithmetic >out 2>err
    ! grep -q 'another strategy: the load was raised in smaller steps' err || {
        told=$told$M
        contains out '"way": "the load was raised in smaller steps on a fine'
        expect 0 "$OVERROLL" steady --M $M --L 3 --level 6 -q \
            --set domain.faces=arithmetic
        [ ! -s err ] || fail "told in spite of -q: $(cat err)"
    }
done
[ -n "$told" ] || fail 'no contact needed another way, or none was told'
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 6 --json
contains out '"way": ""'
! grep 'another strategy' err || fail 'told of the usual way'

# A domain too short for the film carries a pressure of its own: warned of
expect 0 "$OVERROLL" steady --M 0.1 --L 0 --level 5 --set domain.inlet=-4
contains err 'too low because the inlet boundary .*error more than a fifth'
expect 0 "$OVERROLL" steady --M 1 --L 0 --level 5 --set domain.inlet=-4
contains err 'too low because the inlet boundary .*error some [0-9]+ %'
expect 0 "$OVERROLL" steady --M 0.1 --L 0 --level 5 --set domain.inlet=auto
! grep starved err || fail 'an automatic inlet is starved'

# The usual inlet is farther upstream where X = -4 would cost too much, as check
# reports; not where a feature would begin inside.
expect 0 "$OVERROLL" steady --M 3 --L 10 --level 5
! grep starved err || fail 'the usual inlet is starved'
printf '[contact]\nM = 3\nL = 10\n[domain]\nlevel = 5\n' >usual.ini
expect 0 "$OVERROLL" check usual.ini
contains out 'X = -8.[0-9]* to 1.5; an inlet at X = -4 would reduce .* by 3.7 %'
cat >kept.ini <<'END'
[contact]
M = 3
L = 10
[domain]
level = 5
[time]
end = 0.5
[feature d]
shape = dent
depth = 0.01
width = 0.2
start = -4.5
END
expect 0 "$OVERROLL" check kept.ini
contains err 'upstream of X = -4 and keeps the inlet .* some 3.7 % too low'
expect 0 "$OVERROLL" check kept.ini --set domain.inlet=-4
! grep 'keeps the inlet' err || fail 'told of an inlet that was given'

# A strip whose time steps end before its features are high: no number that is
# not finite in the message, report, JSON or file
cat >strip.ini <<'END'
[contact]
M = 5.4
L = 10.7
slide_to_roll = -20
[domain]
level = 4
[time]
end = 0.2
[strip]
width = 1.84
[feature w]
surface = 2
shape = roughness
Rq = 2.5
length = 12
shortest = 0.122
start = 4.2
peklenik = 9.7
angle = -12 deg
END
grew='the steady solution of the strip did not converge: from smooth surfaces '
grew=$grew'the features grew to [0-9]+ % of their height in '
gives_up "${grew}[0-9]+ cycles; features" run strip.ini -o strip.h5
kept strip.h5 "$grew"
! grep -qiwE 'inf|nan' out err || fail "$(cat out err)"
expect 1 "$OVERROLL" run strip.ini --set solver.max_cycles=9
contains out 'not finite .NOT CONVERGED in'
contains err 'cycles with solver.max_cycles = 9; features'

# A step of a strip that no shorter step solves: what may help, and no load
# error, which is not measured
sed 's/= -20$/= 1/; s/^start.*/start = -6.6/; s/^end.*/end = 3/
    s/^Rq.*/Rq = 20/; s/^M.*/M = 5/; s/^L.*/L = 5/' strip.ini >step.ini
gives_up 'the step [0-9]+ to T = [0-9.]+ did not converge, and neither did ' \
    run step.ini
contains err 'imbalance [0-9.e-]+ after [0-9]+ cycles; lower features, .* help$'
