#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Extremes over a run that are from flagged steps carry a mark in the report, in
# JSON and in pictures; others do not. Here the asperity law is exhausted when
# the speed has fallen.
. "$TOP/tests/support/cli.sh"

cat >ex.ini <<'END'
[contact]
hertz_pressure = 0.8 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
slide_to_roll = 0.1
[lubricant]
viscosity = 40 mPa.s
alpha = 20 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[domain]
level = 5
[boundary]
law = greenwood-tripp
friction = 0.1
Rq = 0.3 um
[speed]
history = ramp
from = 1
to = 0.05
duration = 1
[time]
end = 12
END
expect 3 "$OVERROLL" run ex.ini -o ex.h5
contains out '^minimum film thickness .* ms; flagged step\)'
contains out '^maximum asperity load share .*; flagged step\)'
! grep '^maximum pressure.*flagged' out || fail 'no flagged step has P_max'
expect 3 "$OVERROLL" run ex.ini --json -q
contains out '"extremes_flagged": "H_min_overall, contact_share_max, A_max'
flagged=$(number steps_marked)
expect 0 "$OVERROLL" view ex.h5 -o ex.html
contains ex.html "\"about\":\"M = [^\"]*, $flagged flagged steps .not converged"
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot ex.h5 --kind history -o ex.svg
    contains ex.svg "$flagged flagged steps .not converged"
fi

# The film before the flagged steps has the extremes of converged steps.
expect 0 "$OVERROLL" run ex.ini --set time.end=3 -o short.h5 --json -q
contains out '"extremes_flagged": null'
expect 0 "$OVERROLL" view short.h5 -o short.html
! grep 'flagged step' short.html || fail 'a converged run is marked'
