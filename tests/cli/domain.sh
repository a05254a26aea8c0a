#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Default domain for varying load and radius, also of passes. Given boundaries
# are used, with a note about better ones, and rejected only inside the dry
# contact.
. "$TOP/tests/support/cli.sh"

cat >ramp.ini <<'END'
[contact]
load = 200 kN/m
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
viscosity = 40 mPa.s
alpha = 20 1/GPa
[domain]
level = 6
[load]
history = ramp
to = 2.5
duration = 2
[time]
end = 4
step = 0.05
END

value() {
    sed -n 's/^  "'"$1"'": \([-0-9.e]*\),*$/\1/p' out | head -n 1
}
is() {
    awk "BEGIN { exit !($1) }" || fail "not so: $1"
}

# Half width sqrt(2.5) at the end
expect 0 "$OVERROLL" check ramp.ini --json
is "$(value outlet) > 1.5 * sqrt(2.5) - 1e-6 && $(value outlet) < 2.6"
expect 0 "$OVERROLL" check ramp.ini --json --set domain.outlet=auto
is "$(value outlet) > 1.5 * sqrt(2.5) - 1e-6"
# The same pressure as with room enough (0.2.0: 1.4 times as much)
expect 0 "$OVERROLL" run ramp.ini --json
most=$(value P_max_overall) inlet=$(value inlet)
expect 0 "$OVERROLL" run ramp.ini --json --set domain.level=7 \
    --set domain.inlet="$inlet" --set domain.outlet=5
is "$most < 1.1 * $(value P_max_overall)"

# A constant load that is not nominal, steady (0.2.0: 0.0635)
cat >steady.ini <<'END'
[contact]
M = 20
L = 10
[load]
history = ramp
from = 2.25
to = 2.25
END
expect 0 "$OVERROLL" steady steady.ini --json
is "$(value outlet) == 2.25"
is "$(value H_min) > 0.0660 && $(value H_min) < 0.0668"

# Passes, the third of which has four times the load
cat >passes.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[time]
end = 0.5
step = 0.05
[cavitation]
model = conserving
[passes]
number = 3
loads = 1, 0.5, 4
END
expect 0 "$OVERROLL" check passes.ini --json
is "$(value outlet) == 3"
expect 0 "$OVERROLL" run passes.ini -o passes.h5 -q
for pass in 1 2 3; do
    expect 0 "$OVERROLL" export passes-$pass.h5 --snapshot last
    tail -n 1 out | grep -q '^3,' || fail "pass $pass does not end at X = 3"
done

# The domain of a single pass does not depend on loads without effect
sed '/^number/d' passes.ini >single.ini
expect 0 "$OVERROLL" check single.ini --json
contains err 'loads has no effect without number'
echo "$(value inlet) $(value outlet)" >with
sed '/^loads/d' single.ini >plain.ini
expect 0 "$OVERROLL" check plain.ini --json
echo "$(value inlet) $(value outlet)" | cmp - with ||
    fail "ineffective loads move the domain to $(cat with)"

# Given numbers
expect 0 "$OVERROLL" check ramp.ini --json --set domain.outlet=1.6
is "$(value outlet) == 1.6"
contains err 'warning: the outlet boundary X = 1.6 .* set domain.outlet = 2.372'
expect 0 "$OVERROLL" check ramp.ini --json --set domain.inlet=-2
is "$(value inlet) == -2"
contains err 'the inlet boundary X = -2 .* set domain.inlet = -[0-9.]+'
expect 0 "$OVERROLL" check ramp.ini --set domain.inlet=-12 --set domain.outlet=3
! grep 'starved\|near' err || fail "warned of: $(cat err)"
expect 2 "$OVERROLL" check ramp.ini --set domain.outlet=1.5
contains err 'outlet: 1.5 lies inside the contact, whose half-width .* 1.581'
expect 2 "$OVERROLL" check ramp.ini --set domain.inlet=-1.5
contains err 'inlet: -1.5 lies inside the contact, whose half-width .* 1.581'
expect 0 "$OVERROLL" check steady.ini --set domain.outlet=1.6
