#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A result file without snapshots (a run stopped before the first one):
# commands that need none work, the others end with a message of one line.
. "$TOP/tests/support/cli.sh"

cat >late.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 7
[time]
end = 10000
[output]
at = 9999
END
"$OVERROLL" run late.ini -o a.h5 -q &
run=$!
begins a.h5
kill -INT $run
wait $run
[ $? -eq 130 ] || fail "the run was not stopped"
expect 0 "$OVERROLL" info a.h5
contains out "snapshots +0"
expect 0 "$OVERROLL" info a.h5 --json
contains out '"snapshots": 0'

# The history is there, whatever was stored.
expect 0 "$OVERROLL" export a.h5
[ "$(wc -l <out)" -gt 1 ] || fail "no history: $(cat out)"

says="contains no snapshot; only its history of"
for kind in snapshot map trace stress; do
    expect 2 "$OVERROLL" plot a.h5 -o p.svg --kind $kind
    contains err "$says"
    [ ! -f p.svg ] || fail "a picture of nothing: $kind"
done
expect 2 "$OVERROLL" frames a.h5 -o frames
contains err "$says"
expect 2 "$OVERROLL" frames a.h5 --movie a.mp4
contains err "$says"
expect 2 "$OVERROLL" view a.h5 -o page.html
contains err "$says"
[ ! -f page.html ] || fail "a page of nothing"
for choice in "--snapshot last" "--time 1" --all "--at 0"; do
    # shellcheck disable=SC2086 # two words
    expect 2 "$OVERROLL" export a.h5 $choice
    [ "$(wc -l <err)" -eq 1 ] || fail "$choice: $(cat err)"
done
for kind in risk depth; do # of [fatigue], which it has not
    expect 2 "$OVERROLL" plot a.h5 -o p.svg --kind $kind
    [ "$(wc -l <err)" -eq 1 ] || fail "$kind: $(cat err)"
done
expect 2 "$OVERROLL" stress a.h5
[ "$(wc -l <err)" -eq 1 ] || fail "stress: $(cat err)"

if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot a.h5 -o p.svg --kind history
    [ -s p.svg ] || fail "no picture of the history"
fi
