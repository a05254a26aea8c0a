#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Two rough surfaces without seeds have different heights; the default seeds
# equal explicit ones; the first feature of surface 1 has seed 1 as before. The
# same explicit seed on both surfaces causes a warning.
. "$TOP/tests/support/cli.sh"

cat >both.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.2
[domain]
level = 6
[time]
end = 3
[feature ring]
surface = 1
shape = roughness
Rq = 0.004
length = 12
shortest = 0.4
start = -4.2
[feature roller]
surface = 2
shape = roughness
Rq = 0.004
length = 12
shortest = 0.4
start = -4.2
END

# film_of SETTING...: H_min_overall with them
film_of() {
    expect 0 "$OVERROLL" run both.ini --json "$@"
    number H_min_overall
}
default=$(film_of)
! grep -q 'same roughness' err || fail "$(cat err)"
written=$(film_of --set feature.ring.seed=1 --set feature.roller.seed=2)
[ "$default" = "$written" ] || fail "$default is not $written"
same=$(film_of --set feature.ring.seed=3 --set feature.roller.seed=3)
contains err 'warning: surfaces 1 and 2 have the same roughness.*seed = 3'
[ "$default" != "$same" ] || fail "seeds change nothing"
# a default that meets an explicit seed
film_of --set feature.ring.seed=2 >/dev/null
contains err "features 'ring' and 'roller' both have seed = 2"

# Several on one surface differ, too
sed 's/^surface = 2/surface = 1/' both.ini >one.ini
expect 0 "$OVERROLL" run one.ini --json
default=$(number H_min_overall)
expect 0 "$OVERROLL" run one.ini --json --set feature.roller.seed=3
[ "$default" = "$(number H_min_overall)" ] || fail 'the second seed is not 3'
expect 0 "$OVERROLL" run one.ini --json --set feature.roller.seed=1
[ "$default" != "$(number H_min_overall)" ] || fail 'one seed for both'
