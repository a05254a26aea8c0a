#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The thread sanitizer finds no error in runs that compute stresses and write
# the file on separate threads, in resumed runs, or in strips with several
# threads. (After an error the program ends with exit code 66.)
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "once is enough"

make -s -C "$TOP" TSAN=1 BUILD="$PWD/build" "$PWD/build-tsan/overroll" \
    >log 2>&1 || fail "$(cat log)"
tsan=build-tsan/overroll
cat >slide.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
slide_to_roll = 0.3
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[domain]
level = 6
inlet = -4
[time]
end = 1
[feature dent]
shape = dent
depth = 0.3 um
width = 0.5
start = -2
[output]
every = 1
[stress]
surface = both
every = 20
[fatigue]
limit_pressure = none
END
expect 0 "$tsan" run slide.ini -o slide.h5 -q --set 'output.checkpoint=0.1 s'
expect 0 "$tsan" resume slide.h5 -q --set time.end=1.3
expect 0 "$tsan" run slide.ini -q --set time.end=0.5
expect 0 "$tsan" stress slide.h5

cat >strip.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
slide_to_roll = 0.5
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[domain]
level = 4
[strip]
threads = 3
[time]
end = 0.5
[feature dent]
shape = dent
depth = 0.3 um
width = 1
start = -1.5
END
expect 0 "$tsan" run strip.ini -o strip.h5 -q
expect 0 "$tsan" resume strip.h5 -q --set time.end=0.7
