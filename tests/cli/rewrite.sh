#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# check --rewrite: a case of 0.2.0, which is refused today, in today's words:
# what is printed is taken, has what still counts, and says what was left out;
# with the defaults of then it is solved as then.
. "$TOP/tests/support/cli.sh"

cat >old.ini <<'END'
# a dent
[contact]
M = 20
L = 10   ; viscous
[solver]
mlmi_order = 6
tolerance = 1e-7
[time]
end = 2
[load]
history = ramp
to = 1.2
duration = 1
[feature dent]
shape = indent
depth = 0.1
width = 0.4
Rq = 0.01
END
expect 2 "$OVERROLL" check old.ini
contains err "Rq: has no effect"
expect 0 "$OVERROLL" check --rewrite old.ini
cp out new.ini
contains new.ini '^# Rq = 0.01 +# has no effect with shape = indent'
contains new.ini '^# mlmi_order = 6 +# stands in \[paper\] now'
contains new.ini '^L = 10   ; viscous$'
contains new.ini '^# scheme = upstream2 '
expect 0 "$OVERROLL" check new.ini
contains out '^mlmi_order = 6$'
contains out '^tolerance = 1e-7$'
contains out '^to = 1.2$'

# Once more changes nothing that is read.
grep -v '^#' new.ini >new.read
expect 0 "$OVERROLL" check --rewrite new.ini
grep -v '^#' out >again.read
cmp new.read again.read || fail "rewritten twice, the case is another one"

# The mean of then, by taking the sign away: M 20, L 10 at level 6 by it is
# off by more than by today's (the film on level 9).
film() {
    expect 0 "$OVERROLL" steady --json --set domain.order=2 "$@"
    sed -n 's/.*"H_cen": \([-0-9.e]*\).*/\1/p' out
}
printf '[contact]\nM = 20\nL = 10\n[domain]\nlevel = 6\n' >film.ini
expect 0 "$OVERROLL" check --rewrite film.ini
sed 's/^# faces = arithmetic/faces = arithmetic/' out >then.ini
now=$(film film.ini)
then=$(film then.ini)
truth=$(film film.ini --level 9)
awk -v n="$now" -v t="$then" -v f="$truth" 'BEGIN {
    a = n - f; b = t - f
    exit !((a < 0 ? -a : a) < (b < 0 ? -b : b)) }' ||
    fail "faces of then: $then, today: $now, truth $truth"

expect 2 "$OVERROLL" check --rewrite
contains err "needs a case"
expect 2 "$OVERROLL" check --rewrite --json old.ini

# Where speed reverses the domain ended as it does today, and a default of then
# would be refused.
cat >cam.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[time]
end = 2
[speed]
history = ramp
from = 1
to = -1
duration = 2
END
expect 0 "$OVERROLL" check --rewrite cam.ini
! grep -q outlet out || fail "a domain of another end: $(cat out)"
sed 's/^# \(.*\)    # was the default.*/\1/' out >then.ini
expect 0 "$OVERROLL" check then.ini
