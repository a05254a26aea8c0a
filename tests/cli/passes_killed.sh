#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Killed at the end of the last of several passes, between its file and its
# row: resume writes the missing row and prints the report of the run.
. "$TOP/tests/support/faults.sh"
make_faults

cat >roller.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[cavitation]
model = conserving
[passes]
number = 3
loss = 0.2
END

# But for what the clock says, and how a solution was begun.
told() {
    awk '/"refinements"/ { skip = 1 }
        !skip && !/"seconds"/
        /\]/ { skip = 0 }' out
}
expect 0 env FAULT_REPORT=counts LD_PRELOAD=./faults.so \
    "$OVERROLL" run roller.ini -o whole.h5 -q --json
told | sed 's/whole/part/' >whole.json
writes=$(awk '{ print $2 }' counts)
"$OVERROLL" export whole.h5 >whole.csv
# Names and numbers of the summary, which become columns of study tables.
summary() {
    h5dump -g summary "$1" | awk -F'"' '/ATTRIBUTE/ { name = $2 }
        /\(0\)/ && name != "seconds" { print name, $0 }'
}
need h5dump
summary whole.h5 >whole.summary
contains whole.summary '^snapshots '
contains whole.csv '^3,[0-9]'

# One at each of the last writes: the table is the last that is written.
k=$((writes - 24)) missing=0
while [ $k -le "$writes" ]; do
    rm -f part*.h5*
    expect 137 env FAULT_KILL=$k LD_PRELOAD=./faults.so \
        "$OVERROLL" run roller.ini -o part.h5 -q
    expect 0 "$OVERROLL" resume part.h5 --json
    grep -q 'the last row was written' err && missing=$((missing + 1))
    told | cmp -s - whole.json ||
        fail "killed at write $k of $writes: $(cat out err)"
    "$OVERROLL" export part.h5 >part.csv
    cmp -s whole.csv part.csv || fail "killed at write $k of $writes:" \
        "$(diff whole.csv part.csv)"
    summary part.h5 | cmp -s - whole.summary ||
        fail "killed at write $k of $writes: another summary"
    expect 0 "$OVERROLL" resume part.h5
    contains err 'run is already complete'
    k=$((k + 1))
done
[ $missing -gt 0 ] || fail "no write was between the last pass and its row"

# Later passes have the title of the first, which is that of the case.
for eighths in 3 4 5 6 7; do
    rm -f part*.h5*
    expect 137 env FAULT_KILL=$((writes * eighths / 8)) \
        LD_PRELOAD=./faults.so "$OVERROLL" run roller.ini -o part.h5 -q
    [ ! -f part-2.h5 ] || break
done
[ -f part-2.h5 ] && [ ! -f part-3.h5 ] || fail 'not killed in the second pass'

# Killed between the first checkpoint of the second pass and the renaming of its
# file: the pass is begun again.
mkdir early
cp part*.h5* early
mv early/part-2.h5 early/part-2.h5.part
(cd early && expect 0 "$OVERROLL" resume part.h5 -q) || exit 1
"$OVERROLL" export early/part.h5 >part.csv
cmp whole.csv part.csv || fail "killed before the file of a pass had its name"

expect 0 "$OVERROLL" resume part.h5 -q
expect 0 "$OVERROLL" info part-3.h5
contains out '^part-3.h5: roller$'
