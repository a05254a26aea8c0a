#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Rheological models set in a case, and rejected input.
. "$(dirname "$0")/../support/cli.sh"

law='--M 20 --L 10 --level 5 --set contact.G=4000'
law="$law --set contact.slide_to_roll=0.5"
run() {
    # shellcheck disable=SC2086
    "$OVERROLL" steady $law "$@" --json
}
value() { sed -n "s/^  \"$1\": \(.*\),/\1/p" "$2"; }

run --set lubricant.rheology=carreau \
    --set 'lubricant.carreau_stress=5 MPa' >carreau || fail 'carreau'
awk 'BEGIN {
    print "rate [1/s], stress [MPa]"
    for (k = 0; k < 150; k++) {
        y = exp(-6 + 0.15 * k)
        printf "%.9g, %.9g\n", 1e5 * y, 5 * y * (1 + y * y) ^ -0.25
    }
}' >points.csv
run --set lubricant.rheology=table \
    --set lubricant.rheology_file=points.csv >table || fail 'table'
near=$(echo "$(value mu_slide carreau) $(value mu_slide table)" |
    awk '{ d = $1 / $2 - 1; print d * d < 1e-5 }')
[ "$near" = 1 ] || fail "$(value mu_slide carreau) $(value mu_slide table)"

# A Newtonian film is worth its thickness: that no oil has its friction stands
# beside that alone.  Heat takes it away; a flow law has no such stresses.
steel='--set contact.radius=12.7mm --set contact.modulus=226GPa
    --set contact.mean_speed=2m/s --set contact.slide_to_roll=0.02
    --set lubricant.viscosity=40mPa.s --set lubricant.alpha=0.02mm2/N
    --set domain.level=5 --set domain.inlet=-4'
newtonian() {
    # shellcheck disable=SC2086
    "$OVERROLL" steady $steel "$@" >out 2>err || fail "$*: $(cat err)"
}
newtonian --set 'contact.hertz_pressure=0.9 GPa'
contains out '^friction is not realistic +the shear stress'
contains out '^rolling friction coefficient .*surface 2: '
! grep friction err || fail 'a warning of friction nobody asked for'
newtonian --set 'contact.hertz_pressure=0.9 GPa' \
    --set lubricant.rheology=eyring --set 'lubricant.eyring_stress=5 MPa'
! grep 'not realistic' out || fail 'a flow law that no oil has'
# A flow law that does not bound the stress, at a friction above the load
cat >steep.ini <<'END'
[contact]
hertz_pressure = 2 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 1 m/s
slide_to_roll = 0.5
[lubricant]
viscosity = 100 mPa.s
alpha = 20 1/GPa
rheology = eyring
eyring_stress = 1e6 MPa
END
expect 0 "$OVERROLL" steady steep.ini
contains out '^friction is not realistic .*set lubricant.limiting_shear'
expect 0 "$OVERROLL" steady steep.ini --set lubricant.limiting_shear=0.08
! grep 'not realistic' out || fail 'a limiting stress'
newtonian --set 'contact.hertz_pressure=0.5 GPa' \
    --set heat.model=lobatto --set heat.temperature=80degC
! grep 'not realistic' out || fail 'heat is on'

# Forces in N over the width.
newtonian --set 'contact.hertz_pressure=0.9 GPa' \
    --set 'contact.width=10 mm' --json
mv out wide
forces="$(value F_1_N wide) $(value F_1_N_per_m wide) $(value load_N wide)"
near=$(echo "$forces" |
    awk '{ print (($1 / $2 / 0.01 - 1)^2 < 1e-20 && $3 > 2800 && $3 < 2900) }')
[ "$near" = 1 ] || fail "forces: $(grep _N wide)"
newtonian --set 'contact.hertz_pressure=0.9 GPa' --json
! grep F_1_N\" out || fail 'forces without a width'

refused() {
    expected=$1
    shift
    if run "$@" >out 2>err; then
        fail "accepted: $*"
    fi
    contains err "$expected"
}
refused 'eyring_stress is missing' --set lubricant.rheology=eyring
refused 'eyring_stress: has no effect with rheology = newtonian' \
    --set 'lubricant.eyring_stress=5 MPa'
refused 'carreau_stress is missing' --set lubricant.rheology=carreau
refused "needs 'rheology_file'" --set lubricant.rheology=table
echo '1, 2' >bare.csv
refused 'bare.csv:1: the header must name the units' \
    --set lubricant.rheology=table --set lubricant.rheology_file=bare.csv
printf 'rate [1/s], stress [MPa]\n1, 2\n2, 1\n' >falls.csv
refused 'must be positive and increase' \
    --set lubricant.rheology=table --set lubricant.rheology_file=falls.csv
refused 'rheology_file: no.csv: cannot be opened' \
    --set lubricant.rheology=table --set lubricant.rheology_file=no.csv

# The same points with the columns the other way round, other units, a comment
# behind them and an empty line before: one file like the other.
awk 'BEGIN {
    print "rate [1/s]; stress [MPa]" >"one.csv"
    printf "\nstress (kPa), rate (s^-1)\n" >"other.csv"
    for (k = 1; k <= 12; k++) {
        rate = 1e4*2^k; stress = 4*log(rate/1e6 + sqrt((rate/1e6)^2 + 1))
        printf "%.17g; %.17g\n", rate, stress >"one.csv"
        printf "%.17g %.17g  # point %d\n", stress*1000, rate, k >"other.csv"
    } }'
for name in one other; do
    run --set lubricant.rheology=table --set lubricant.rheology_file=$name.csv \
        >$name.out 2>err || fail "$name: $(cat err)"
done
echo "$(value mu_slide one.out) $(value mu_slide other.out)" |
    awk '{ exit !($1 > 0 && ($1/$2 - 1)^2 < 1e-20) }' ||
    fail "$(value mu_slide one.out) is not $(value mu_slide other.out)"
