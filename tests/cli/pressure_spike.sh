#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A maximum pressure in a spike a few mesh sizes wide is marked as not resolved
# in the report, JSON, the file, pictures and stresses.  The pressure of a
# Newtonian film at a dent is singular like the logarithm of the distance: the
# maximum grows on every level.  With Eyring's law it converges.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

expect 0 "$OVERROLL" init roller -o roller.ini
grep -v '^rheology\|^eyring\|^limiting' roller.ini >newton.ini

for level in 6 7 8; do
    expect 0 "$OVERROLL" run newton.ini --level $level --json \
        -o newton.h5 --force --set time.step=grid
    contains out '"P_max_resolved": false'
    contains err 'warning: the maximum pressure .* is not resolved.*rheology'
    number P_max_overall >newton.$level
done
expect 0 "$OVERROLL" run newton.ini --level 7
contains out '^maximum pressure.*not resolved'
# Nor is the spike of a Newtonian film at the outlet, by itself
expect 0 "$OVERROLL" steady --M 200 --L 14 --level 8
contains out '^pressure spike .*not resolved'
expect 0 "$OVERROLL" steady --M 200 --L 14 --level 8 --json
contains out '"P_spike_resolved": false'

for level in 8 9; do
    expect 0 "$OVERROLL" run roller.ini --level $level --json \
        -o roller.h5 --force
    contains out '"P_max_resolved": true'
    ! grep -q 'not resolved' err || fail "the Eyring film is marked"
    number P_max_overall >eyring.$level
done

# The flag follows from the nodes of the largest snapshot, and the logarithm: a
# constant step of the maximum from level to level, against a few per cent.
"$PYTHON" - <<'END' || fail "the maxima"
def read(name):
    return float(open(name).read())
a, b, c = (read("newton.%d" % l) for l in (6, 7, 8))
assert b - a > 0.3 and c - b > 0.3, (a, b, c)
assert abs((c - b) / (b - a) - 1) < 0.2, (a, b, c)
d, e = read("eyring.8"), read("eyring.9")
assert abs(e / d - 1) < 0.03, (d, e)
END

# By the mean of the gap the steady maximum is in the centre on level 7, and the
# spike at the outlet on level 9.  Where the spike is lower, it is resolved.
expect 0 "$OVERROLL" run newton.ini --level 7 -q -o newton.h5 --force \
    --set output.every=1 --set stress.surface=1 --set domain.faces=gap
"$PYTHON" - <<'END' || fail "the file"
import h5py, numpy
f = h5py.File("newton.h5", "r")
P, flag = f["pressure"][...], f["history/max_pressure_resolved"][...]
def resolved(P):
    """No maximum is more than 10 % above the mean beside it and, by half the
    difference, more than 2 % above the largest pressure."""
    up = P[1:-1] - (P[:-2] + P[2:]) / 2
    top = (P[1:-1] > P[:-2]) & (P[1:-1] >= P[2:]) & (up > .1 * P[1:-1])
    return not (top & (P[1:-1] + up / 2 > 1.02 * P.max())).any()
for k in range(len(P)):
    assert flag[k] == resolved(P[k]), k
assert flag[0] == 0 and flag.any() and flag[P.max(axis=1).argmax()] == 0
assert f["summary"].attrs["P_max_resolved"] == 0
END

# Stresses nearer to the surface than eight mesh sizes, in the run and after it
expect 0 "$OVERROLL" run newton.ini --level 6 -q --json --set output.every=1 \
    --set stress.surface=1 --set feature.dent.depth=1.5um -o again.h5 --force
contains out '"von_mises_max_resolved": false'
expect 0 "$OVERROLL" stress again.h5
contains out 'von Mises.*not resolved'

# Pictures of stress and risk of a deeper dent name the remedy.
expect 0 "$OVERROLL" run newton.ini --level 6 -q --set output.every=1 \
    --set stress.surface=1 --set fatigue.criterion=dang-van \
    --set feature.dent.depth=1.5um -o deep.h5
expect 0 "$OVERROLL" view deep.h5 -o deep.html
grep -o '"unresolved":\[[^]]*\]' deep.html >flags
contains flags '"set lubricant.rheology = eyring"'
contains flags '""'
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot deep.h5 --kind stress -o stress.svg
    contains stress.svg 'maximum .*, not resolved; smooth'
    contains stress.svg 'not resolved \(set lubricant.rheology = eyring\)'
    expect 0 "$OVERROLL" plot deep.h5 --kind risk -o risk.svg
    contains risk.svg 'resolved from .* \(set lubricant.rheology = eyring\)'
    expect 0 "$OVERROLL" plot deep.h5 --kind depth -o depth.svg
    contains depth.svg 'not resolved above a depth'
fi

# A load that rises leaves a spike at the outlet that grows from level to level.
cat >ramp.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
[lubricant]
viscosity = 80 mPa.s
alpha = 20 1/GPa
[load]
history = ramp
to = 3
duration = 1
[time]
end = 4
END
for level in 7 8; do
    expect 0 "$OVERROLL" run ramp.ini --level $level --json
    contains out '"P_max_resolved": false'
    contains err 'warning: the maximum pressure .* is not resolved.*rheology'
    number P_max_overall >ramp.$level
    expect 0 "$OVERROLL" run ramp.ini --level $level --json \
        --set lubricant.rheology=eyring --set lubricant.eyring_stress=5MPa
    contains out '"P_max_resolved": true'
    ! grep -q 'not resolved' err || fail "the Eyring film of a ramp is marked"
    number P_max_overall >thins.$level
done
"$PYTHON" - <<'END' || fail "the maxima of a ramp"
def read(name):
    return float(open(name).read())
assert read("ramp.8") > 1.1 * read("ramp.7")
assert abs(read("thins.8") / read("thins.7") - 1) < 1e-3
# the pressure of Hertz's contact at three times the load: 3^(1/2)
assert 1.65 < read("thins.8") < 2
END

# A resumed run knows it, too: its largest pressure is from before the stop.
expect 0 "$OVERROLL" run newton.ini --level 6 -q -o half.h5 --set time.end=11
expect 0 "$OVERROLL" resume half.h5 --set time.end=13 -q --json
contains out '"P_max_resolved": false'

# A lower spike that passes the maximum on finer grids is not resolved either:
# the maximum of this film is 0.9975 p_h up to level 10, and its spike at most
# 0.84 p_h, but 1.28 p_h on level 11.
expect 0 "$OVERROLL" steady --M 50 --L 20 --level 8 --json
contains out '"P_max_resolved": false'
contains err 'the pressure spike at X = 0.95.* wide'
number P_max >low
expect 0 "$OVERROLL" steady --M 50 --L 20 --level 11 --json
number P_max >high
awk '{ getline finer <"high"; exit !($1 < 1 && finer > 1.2 * $1) }' low ||
    fail "the spike does not grow: $(cat low high)"
# That of M = 20, L = 10 converges to 0.888 p_h (composite_test).
for level in 7 8 9; do
    expect 0 "$OVERROLL" steady --M 20 --L 10 --level $level --json
    contains out '"P_max_resolved": true'
    ! grep -q 'not resolved' err || fail "M = 20, L = 10 is marked"
done

# The spike of another step: on level 6 the maximum of the run is in the centre,
# on level 7 it is a spike at an earlier time.
cat >steps.ini <<'END'
[roller_bearing]
roller = 14.65 mm
rollers = 12
length = 17.28 mm
inner = 83.61 mm
clearance = 42.7 um
load = 17.91 kN
speed_inner = 3799 rpm
contact = inner
[contact]
modulus = 226 GPa
[lubricant]
viscosity = 25 mPa.s
alpha = 18 1/GPa
[feature f]
shape = dent
depth = 0.4 um
width = 0.4
start = -6
[time]
end = 12
END
for level in 6 7; do
    expect 0 "$OVERROLL" run steps.ini --level $level --json --force \
        -o steps.h5
    contains out '"P_max_resolved": false'
    number P_max_overall >steps.$level
done
awk '{ getline finer <"steps.7"; exit !(finer > 1.2 * $1) }' steps.6 ||
    fail "the spike does not grow: $(cat steps.6 steps.7)"
expect 0 "$OVERROLL" view steps.h5 -o steps.html
contains steps.html 'maximum pressure not resolved'

# Pictures
expect 0 "$OVERROLL" view newton.h5 -o newton.html
contains newton.html 'maximum pressure not resolved'
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot newton.h5 --kind history -o newton.svg
    contains newton.svg 'maximum pressure not resolved'
fi

# Every kind with features has a shear-thinning oil
for kind in roller gear bearing indented numbers; do
    expect 0 "$OVERROLL" init $kind
    contains out '^rheology = eyring'
done
