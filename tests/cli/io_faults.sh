#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every eleventh write and read of a run fails in turn, in make verify each: an
# exit code of the program and one line each time. The remaining file is
# complete or recognized as interrupted (a disk that fails permanently during a
# commit), and resume completes it with the same result. Also short transfers
# and a failing fsync.
STRIDE=${OVERROLL_VERIFY:+1}
. "$TOP/tests/support/faults.sh"
make_faults
make_dent
echo 'checkpoint = 1 ms' >>dent.ini
expect 0 "$OVERROLL" run dent.ini -o a.h5 -q
"$OVERROLL" export a.h5 --all >whole || fail export

# same: a.h5 is what the undisturbed run wrote.
same() {
    "$OVERROLL" export a.h5 --all >now 2>&1 || fail "$1: export: $(cat now)"
    cmp -s now whole || fail "$1: another result"
}

# faulty SETTING...: a run under that fault, and what must be true after it.
faulty() {
    rm -f a.h5* counts
    code=0
    env "$@" FAULT_REPORT=counts LD_PRELOAD=./faults.so "$OVERROLL" \
        run dent.ini -o a.h5 -q >out 2>err || code=$?
    [ $code -le 2 ] || fail "$*: exit code $code: $(cat err)"
    if [ $code -eq 0 ]; then
        same "$*"
        return
    fi
    [ "$(wc -l <err)" -eq 1 ] || fail "$*: not one line: $(cat err)"
    if [ ! -e a.h5 ]; then
        [ ! -e a.h5.part ] || fail "$*: a part is left"
        return
    fi
    "$OVERROLL" info a.h5 >log 2>&1 ||
        grep -q 'last write was interrupted' log ||
        fail "$*: info: $(cat log)"
    "$OVERROLL" resume a.h5 -q >log 2>&1 || fail "$*: resume: $(cat log)"
    same "$*"
}

# asked COLUMN: how often the last run asked for that (writes 2, reads 3).
asked() {
    awk -v c="$1" '{ print $c }' counts
}

faulty FAULT_SHORT=1
[ $code -eq 0 ] || fail "short transfers: $(cat err)"
faulty FAULT_SYNC=1
faulty FAULT_MALLOC=0
writes=$(asked 2)
reads=$(asked 3)
[ "$writes" -gt 20 ] && [ "$reads" -gt 20 ] || fail "counts: $(cat counts)"
k=0
while [ $k -lt "$writes" ]; do
    k=$((k + ${STRIDE:-11}))
    faulty FAULT_WRITE=$k FAULT_ERRNO=28
done
k=1
while [ $k -lt "$writes" ]; do
    k=$((k + ${STRIDE:-11}))
    faulty FAULT_WRITE=$k FAULT_ERRNO=5
done
k=0
while [ $k -lt "$reads" ]; do
    k=$((k + ${STRIDE:-11}))
    faulty FAULT_READ=$k
done
echo "$writes writes, $reads reads"
