#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Any single allocation of the process fails, including allocations inside the
# libraries. Commands that read end with their own exit code and, in addition to
# warnings, one line. Commands that write do the same unless the allocation was
# HDF5's. HDF5 then aborts or crashes, which is counted, and the run leaves a
# complete file or none.
. "$TOP/tests/support/faults.sh"
make_faults
make_dent
expect 0 "$OVERROLL" run dent.ini -o whole.h5 -q

# faulty K COMMAND...: that allocation fails; the exit code in $code.
faulty() {
    k=$1
    shift
    code=0
    env FAULT_MALLOC="$k" FAULT_REPORT=counts LD_PRELOAD=./faults.so \
        "$OVERROLL" "$@" >out 2>err || code=$?
}

# each COMMAND...: every allocation in turn.
each() {
    faulty 0 "$@"
    all=$(awk '{ print $1 }' counts)
    [ "$all" -ge 5 ] || fail "$*: $all allocations"
    for k in $(seq 1 "$all"); do
        faulty "$k" "$@"
        [ $code -le 2 ] || fail "$*: allocation $k: exit code $code"
        [ $code -eq 0 ] ||
            [ "$(grep -cv -e 'warning:' -e 'inlet boundary' err)" -eq 1 ] ||
            fail "$*: allocation $k: not one line: $(cat err)"
    done
    echo "$all allocations: $*"
}

each info whole.h5
each export whole.h5 --all
each view whole.h5 -o page.html --force
each check dent.ini
each steady --M 20 --L 10 --level 6
each profile load.txt

faulty 0 run dent.ini -o a.h5 -q
all=$(awk '{ print $1 }' counts)
tried=0 died=0
for k in $(seq 1 "${STRIDE:-37}" "$all"); do
    rm -f a.h5*
    faulty "$k" run dent.ini -o a.h5 -q
    tried=$((tried + 1))
    [ $code -le 2 ] || died=$((died + 1))
    [ ! -e a.h5 ] || "$OVERROLL" info a.h5 >log 2>&1 ||
        grep -q 'last write was interrupted' log ||
        fail "run: allocation $k: a file that cannot be read: $(cat log)"
done
echo "$all allocations: run; of $tried that failed $died ended it inside HDF5"
