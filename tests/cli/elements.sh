#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Gears, cams and bearings as the case says them: their contact and way, what
# they refuse.
. "$TOP/tests/support/cli.sh"

cat >gear.ini <<'END'
[contact]
modulus = 226 GPa
[gear]
module = 3 mm
teeth_1 = 20
teeth_2 = 40
centre = 90 mm
face = 20 mm
speed = 3000 rpm
torque = 100 N.m
[lubricant]
viscosity = 10 mPa.s
alpha = 16 1/GPa
[domain]
level = 5
END
cat >cam.ini <<'END'
[contact]
modulus = 226 GPa
[cam]
base_radius = 20 mm
face = 12 mm
speed = 1500 rpm
lift = 9 mm
rise = 65 deg
spring = 30 N/mm
preload = 250 N
mass = 100 g
to = 30 deg
[lubricant]
viscosity = 10 mPa.s
alpha = 16 1/GPa
[domain]
level = 5
END
cat >bearing.ini <<'END'
[contact]
modulus = 226 GPa
[roller_bearing]
roller = 10 mm
rollers = 14
length = 9.6 mm
inner = 54.991 mm
clearance = 41 um
load = 4450 N
speed_inner = 1000 rpm
passes = zone
[cavitation]
model = conserving
[lubricant]
viscosity = 10 mPa.s
alpha = 16 1/GPa
[domain]
level = 6
[time]
end = 4
[feature d]
shape = dent
depth = 0.4 um
width = 0.5
start = -3
END

# says PATTERN: `out` has a line of it.
says() {
    grep -q "$1" out || {
        cat out
        fail "nothing says: $1"
    }
}

# The pair of the truth: R_C 6.840403 mm, u_C 3.223464 m/s, 1.635186 ms.
expect 0 "$OVERROLL" check gear.ini
says 'reduced radius R  *6.8404 mm'
says 'mean speed um  *3.22346 m/s'
expect 0 "$OVERROLL" run gear.ini -o gear.h5 -q --json
says '"T_end": 45.0'
expect 0 "$OVERROLL" info gear.h5

# Given by the load at the pitch point, or by power, it is the same gear.
expect 0 "$OVERROLL" check gear.ini --json
sed -n '/"load_N_per_m"/p' out >torque.txt
sed 's/torque = 100 N.m/power = 31.41592653589793 kW/' gear.ini >power.ini
expect 0 "$OVERROLL" check power.ini --json
sed -n '/"load_N_per_m"/p' out | cmp - torque.txt ||
    fail "power is another gear"

expect 0 "$OVERROLL" run cam.ini -o cam.h5 -q
# Three rollers meet a point of the inner ring: 309, 1967 and 309 N.
expect 0 "$OVERROLL" run bearing.ini -o bearing.h5 -q
expect 0 "$OVERROLL" info bearing.h5
says 'pass'

# refuses FILE LINE WORDS: one line on stderr, with the words, exit code 2.
refuses() {
    printf '%s\n' "$2" >>"$1"
    expect 2 "$OVERROLL" check "$1"
    grep -q "$3" err || {
        cat err
        fail "not said: $3"
    }
}

with() {
    cp "$1.ini" case.ini
    refuses case.ini "$2" "$3"
}

with gear '[contact]
radius = 8 mm' '\[gear\] says it: leave radius out'
with gear '[contact]
mean_speed = 2 m/s' '\[gear\] says it: leave mean_speed out'
with gear '[contact]
load = 100 kN/m' '\[gear\] says it: leave load out'
with gear '[load]
history = sine' '\[gear\] says how load changes: leave \[load\] out'
with gear '[cam]
base_radius = 3 mm' 'one element at most'
with gear '[time]
end = 99' '\[gear\] ends at 1.635 ms (T = 45.08)'
with gear '[gear]
shift_1 = 0
shift_2 = 0' 'shift_1, shift_2 and centre: leave one out'
with gear '[gear]
blend = 0' 'the load would jump'
with gear '[gear]
sharing = table' "needs 'file'"
sed '/face/d' gear.ini >less.ini
with less '' '\[gear\] needs face'
sed '/torque/d' gear.ini >less.ini
with less '' '\[gear\] needs torque or power'
sed 's/base_radius = 20/base_radius = 17/; s/to = 30/to = 60/' cam.ini >less.ini
with less '[cam]
from = 0 deg' 'a flat follower cannot follow'
with bearing '[passes]
spacing = 9' '\[roller_bearing\] says it: leave spacing out'
with bearing '[passes]
number = 7' 'meets 3 rollers'
sed 's/zone/turns/' bearing.ini >less.ini
with less '' 'take zone'
exit 0
