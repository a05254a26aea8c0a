#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Thick films on the base circle of a cam, where sweeps after the coarse-grid
# correction increase the residual (step_cycles.c). Multigrid cycles solve each
# step without a retry, in 10 cycles at most on average. With those sweeps the
# same steps need 22 cycles and 221 retries in all.
. "$TOP/tests/support/cli.sh"

cat >cam.ini <<'END'
[cam]
follower = flat
base_radius = 26 mm
face = 12 mm
speed = 1000 rpm
law = 4567
lift = 6 mm
rise = 70 deg
spring = 30 N/mm
preload = 250 N
mass = 100 g
[contact]
modulus = 226 GPa
[lubricant]
viscosity = 30 mPa.s
alpha = 18 1/GPa
rheology = eyring
eyring_stress = 5 MPa
limiting_shear = 0.08
[domain]
level = 8
[time]
step = adaptive
end = 4.5 ms
END
expect 0 "$OVERROLL" run cam.ini -o cam.h5 -q --json
steps=$(number steps) cycles=$(number cycles_total) retries=$(number retries)
echo "$steps steps, $cycles cycles, $retries retries"
[ "$steps" -gt 300 ] || fail "too few steps"
[ "$retries" -eq 0 ] && [ "$cycles" -le $((10 * steps)) ]
