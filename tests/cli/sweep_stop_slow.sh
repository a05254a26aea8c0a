#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# sweep stopped by signals, and killed while its workers continue: started
# cases are resumed, and the results equal those of an uninterrupted sweep.
. "$TOP/tests/support/cli.sh"

cat >study.ini <<'END'
[set]
contact.M = 20
domain.level = 7
time.end = 6
output.every = 50
output.checkpoint = 0.05 s
feature.dent.shape = dent
feature.dent.start = -4.9
feature.dent.width = 1
[product]
contact.L = 8, 10
feature.dent.depth = linear 0.05 to 0.2 in 4
END
numbers() {
    "$OVERROLL" sweep study.ini -o "$1" --collect t.csv -q
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "seconds") s = i }
        { $s = ""; print }' t.csv
}
expect 0 "$OVERROLL" sweep study.ini -o alone -j 2
numbers alone >alone.txt

# begin FOLDER: a sweep under way
begin() {
    "$OVERROLL" sweep study.ini -o "$1" -j 2 >out 2>err &
    pid=$!
    until ls "$1"/*.h5 >/dev/null 2>&1; do
        kill -0 "$pid" || fail "no sweep: $(cat out err)"
        sleep 0.02
    done
}

# interrupt SIGNAL: a sweep stopped in the middle of a case.  The signal may
# fall between two cases, with nothing under way to stop: then once more.
interrupt() {
    for _ in 1 2 3 4 5 6 7 8; do
        rm -rf "$1"
        begin "$1"
        kill -s "$1" "$pid"
        code=0
        wait "$pid" || code=$?
        grep -q ' stopped' out && return
    done
}

for signal in INT TERM; do
    interrupt $signal
    case $signal in
    INT) wanted=130 ;;
    TERM) wanted=143 ;;
    esac
    [ "$code" -eq "$wanted" ] || fail "SIG$signal: $code: $(cat out err)"
    contains out ' stopped'
    contains out ' waiting'
    ls $signal/*.failed >/dev/null 2>&1 && fail 'stopped is not failed'
    expect 0 "$OVERROLL" sweep study.ini -o $signal -j 2
    numbers $signal | cmp - alone.txt || fail "SIG$signal changes results"
done

# The parent killed: its workers end what they have begun while another sweep
# does the rest.
begin kill
kill -s KILL "$pid"
wait "$pid"
until "$OVERROLL" sweep study.ini -o kill -j 2 -q >/dev/null 2>&1; do
    sleep 1
done
numbers kill | cmp - alone.txt || fail 'a killed sweep changes results'
