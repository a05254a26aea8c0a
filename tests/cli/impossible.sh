#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A ridge that grows until the surfaces touch: named, with what was reached
# kept for inspection, and no NaN in it.
. "$TOP/tests/support/cli.sh"

cat >wall.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[time]
end = 4
[feature wall]
shape = ridge
height = 30
width = 0.3
start = 0
grow = 4
[output]
every = 1
END

expect 1 "$OVERROLL" run wall.ini -o wall.h5 -q
contains err '^the surfaces touch at T = 0\.[0-9]+: film H = .* at X = '
[ "$(wc -l <err)" -eq 1 ] || fail "not one line: $(cat err)"
expect 0 "$OVERROLL" info wall.h5
contains out 'status +failed'
[ -s wall.h5.restart ] || fail 'no state to inspect'

# What led there is in the file up to the last step, and resuming says the
# same again.
expect 0 "$OVERROLL" export wall.h5 --all
[ "$(wc -l <out)" -gt 1000 ] || fail 'no snapshots'
expect 0 "$OVERROLL" export wall.h5
cut -d , -f 1-8 out >history
! grep -qi inf history || fail 'an infinite value'
expect 1 "$OVERROLL" resume wall.h5 -q
contains err '^the surfaces touch at T = 0\.'
