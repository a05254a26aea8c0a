#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Possible but unusual numbers: check and run print a warning with the usual
# range.
. "$TOP/tests/support/cli.sh"

cat >usual.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
mean_speed = 2 m/s
viscosity = 40 mPa.s
alpha = 17 1/GPa
[domain]
level = 5
inlet = -6
[time]
end = 0.1
[feature mark]
shape = indent
depth = 0.5 um
width = 100 um
start = -9
END
expect 0 "$OVERROLL" check usual.ini
! grep 'is outside the usual range' err || fail 'warned of what is usual'
told() {
    expect 0 "$OVERROLL" check usual.ini --set "$1"
    contains err "warning: $2"
}
told contact.modulus='226 MPa' \
    'modulus = 0.226 GPa is outside the usual range of 1 to 1000 GPa'
told contact.radius='8 m' \
    'radius = 8000 mm is outside the usual range of 0.1 to 2000 mm'
told contact.load='300 N/m' \
    'load = 0.3 kN/m is outside the usual range of 1 to 20000 kN/m'
told contact.viscosity='40 Pa.s' \
    'viscosity = 40 Pa.s is outside the usual range of 0.0001 to 20'
told contact.alpha='1.7 1/GPa' \
    'alpha = 1.7 1/GPa is outside the usual range of 3 to 60 1/GPa'
told feature.mark.depth='40 um' "feature 'mark': 40 um deep and 100 um wide"
told feature.mark.width='5 nm' \
    "feature 'mark': width = 0.005 um is outside the usual range of 0.1"
"$OVERROLL" run usual.ini --set contact.load='300 N/m' >out 2>err
contains err 'warning: load = 0.3 kN/m is outside the usual range'
