#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Where the elastic, Newtonian or thin-film model is left, answers are withheld
# or marked, with the reason.
. "$TOP/tests/support/cli.sh"

# Friction of surfaces that touch is not known without its coefficient.
rubbing_contact >mixed.ini
cat >>mixed.ini <<'END'
[boundary]
law = exponential
Rq = 0.5 um
slope = 0.03
[domain]
level = 5
END
expect 0 "$OVERROLL" steady mixed.ini
contains out '^friction coefficient +unknown .set boundary.friction.'
! grep -i 'nan' out || fail 'nan in a report'
expect 0 "$OVERROLL" steady mixed.ini --json
for key in mu_slide F_slide F_1 F_2 power_in power_dissipated; do
    contains out "^  \"$key\": null"
done

# Its heat is not known either, nor the balance of energy.
cat mixed.ini - >hot.ini <<'END'
[heat]
model = lobatto
temperature = 60 degC
END
expect 0 "$OVERROLL" steady hot.ini
contains out '^energy balance error +unknown .set boundary.friction.'
! grep -i 'nan' out || fail 'nan in the report of a hot mixed contact'
expect 0 "$OVERROLL" run hot.ini --set time.end=0.1 -o hot.h5
! grep -i 'nan' out || fail 'nan in the report of a hot mixed run'
expect 0 "$OVERROLL" steady hot.ini --set boundary.friction=0.1
contains out '^energy balance error +[-0-9.e]+ *$'

expect 0 "$OVERROLL" steady mixed.ini --set boundary.friction=0.1 --json
contains out '^  "power_in": 2\.[0-9]'

# Shear stress over pressure is that of the oil, whatever the metal's friction.
for mu in 0 0.3; do
    expect 0 "$OVERROLL" steady mixed.ini --set boundary.friction=$mu --json
    number shear_over_pressure >shear.$mu
done
awk '{ exit !($1 > 0 && $1 < 0.1) }' shear.0 || fail "shear $(cat shear.0)"
cmp -s shear.0 shear.0.3 || fail "shear $(cat shear.0 shear.0.3)"

# A Newtonian film that slides: friction no oil has, so no power of it.
expect 0 "$OVERROLL" init gear --set gear.teeth_1=25 --set gear.teeth_2=57 \
    --set gear.module=2.5mm --set gear.torque=200N.m --set gear.speed=2000rpm \
    --set domain.level=5 --set lubricant.rheology=newtonian \
    --set lubricant.limiting_shear=0 -o gear.ini
sed -i '/^eyring_stress/d' gear.ini
expect 0 "$OVERROLL" run gear.ini
contains out '^friction power loss +not given: the sliding friction coeff'
! grep -E '^friction power.* W|efficiency' out || fail 'a power is given'
expect 0 "$OVERROLL" run gear.ini --json --force
contains out '^  "power_loss_W": null'
contains out '^  "efficiency": null'

# No life without a point that passes the contact, nor above what bodies bear.
cat >life.ini <<'END'
[contact]
hertz_pressure = 6 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 20 m/s
[lubricant]
viscosity = 100 mPa.s
alpha = 10 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[domain]
level = 7
[time]
end = 8
[feature d]
surface = 1
shape = dent
depth = 2 um
width = 0.5
start = -4.2
[stress]
[fatigue]
raceway = 100
END
expect 0 "$OVERROLL" run life.ini
contains out '^life +not given: the elastic .*contact.bearable_pressure'
! grep '^equivalent raceway length' out || fail 'an equivalent length is given'
expect 0 "$OVERROLL" run life.ini --json --force
contains out '^  "life_ratio": null'
expect 0 "$OVERROLL" run life.ini --set 'contact.bearable_pressure=8 GPa'
contains out '^equivalent raceway length'
expect 0 "$OVERROLL" run life.ini --set 'contact.bearable_pressure=8 GPa' \
    --set time.end=2
contains out '^life +not given: no material point passes .* later time.end'
expect 0 "$OVERROLL" run life.ini --set 'body 1.material=steel' \
    --set 'body 2.material=steel' --set time.end=2
contains out '^yielding volume share +unknown: no material point passed the '
! grep -E '[ (]nan' out || fail 'nan in a report of stresses'

# A film thinner than molecules
cat >thin.ini <<'END'
[contact]
load = 5 kN/m
radius = 5 mm
mean_speed = 1 mm/s
modulus = 226 GPa
[lubricant]
viscosity = 1 mPa.s
alpha = 15 1/GPa
END
"$OVERROLL" steady thin.ini >out 2>err
contains err 'minimum film thickness of 0\.[0-9]+ nm .* below the size of lubr'
contains err 'the surfaces touch there, see .boundary.'

# [boundary] and [plastic] are not advised where they are on.
cat thin.ini - >touching.ini <<'END'
[boundary]
law = exponential
Rq = 0.01 um
slope = 0.01
END
expect 0 "$OVERROLL" steady touching.ini
! grep 'see .boundary.' err || fail '[boundary] is on, and advised'
expect 0 "$OVERROLL" init indented --set domain.level=5 \
    --set contact.bearable_pressure=1GPa --set plastic.passes=1 -o indented.ini
expect 0 "$OVERROLL" run indented.ini -o indented.h5
contains err 'exceeds bearable_pressure = 1 GPa$'
! grep 'would yield' err || fail '[plastic] is on, and advised'
sed '/^.plastic/,/^$/d' indented.ini >elastic.ini
expect 0 "$OVERROLL" run elastic.ini -o elastic.h5
contains err 'exceeds bearable_pressure = 1 GPa: the body would yield; see .pla'
