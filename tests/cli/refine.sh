#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# [domain] refine = spike: from a case to files and back; incompatible options.
. "$TOP/tests/support/cli.sh"

# near NAME WANTED SHARE: a number of the JSON in `out`.
near() {
    awk -v x="$(number "$1")" -v w="$2" -v e="$3" \
        'BEGIN { d = x - w; if (d < 0) d = -d; if (w < 0) w = -w
                 exit !(x != "" && d <= e * w) }' ||
        fail "$1 is $(number "$1"), wanted $2 within $3"
}

cat >spike.ini <<'END'
[contact]
M = 20
L = 10
[domain]
inlet = -4
refine = spike
refine_level = 14
[output]
file = spike.h5
END

# The spike of a uniform grid of level 17, 0.888986 (tests/verify/spike_test.c).
expect 0 "$OVERROLL" run spike.ini --json
near refined_level 14 0
near P_spike 0.888986 2e-3
near X_spike 0.902706 3e-5
near load 1.5707963267949 1e-9
nodes=$(number nodes)
awk -v n="$nodes" 'BEGIN { exit !(n > 1793 && n < 4000) }' ||
    fail "$nodes nodes"

# Weights are those of the integral, in the file and by its nodes.
expect 0 "$OVERROLL" export spike.h5 --snapshot last --field pressure
awk -F, '/^[-0-9]/ { if (n++) sum += (p + $2) / 2 * ($1 - x); x = $1; p = $2 }
    END { d = sum - 1.5707963267949
          exit !(n > 1793 && d < 1e-9 && d > -1e-9) }' out ||
    fail 'the load of the stored pressure is not pi/2'
if command -v h5dump >/dev/null; then
    h5dump -m %.17g -d weight -y -w 1 spike.h5 >weights
    awk '/^ *[0-9.e-]+,?$/ { n++; sum += $1 }
        END { exit !(n == '"$nodes"' && sum > 5.499999 && sum < 5.500001) }' \
        weights || fail 'the weights do not make up the domain'
fi

# What reads files copes.
expect 0 "$OVERROLL" info spike.h5
contains out 'nodes'
expect 0 "$OVERROLL" view spike.h5 -o spike.html
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot spike.h5 -o spike.svg
fi
refuses 'not equidistant' stress spike.h5
refuses 'cannot be resumed' resume spike.h5

# By the change of its height; a contact without a spike says so.
expect 0 "$OVERROLL" steady --M 20 --L 10 --json --set domain.refine=spike \
    --set domain.refine_change=3e-3
awk -v c="$(number spike_change)" 'BEGIN { exit !(c > 0 && c < 3e-3) }' ||
    fail "spike_change is $(number spike_change)"
expect 0 "$OVERROLL" steady --M 3 --L 0 --set domain.refine=spike
contains err 'refine: the pressure has no spike'
expect 0 "$OVERROLL" check spike.ini
contains out 'local refinement .*to level 14'

refuses 'needs levels 6 to' check spike.ini --set domain.level=5
refuses 'above the level, 14' check spike.ini --set domain.level=14
refuses 'combined with \[domain\] refine' check spike.ini --set time.end=1
refuses 'cannot be combined with \[domain\] refine' check spike.ini \
    --set lubricant.rheology=eyring --set lubricant.eyring_number=1
refuses 'cannot be combined with \[domain\] refine' check spike.ini \
    --set paper.smoother=hybrid
refuses 'cannot be combined with \[domain\] refine' check spike.ini \
    --set cavitation.model=conserving
