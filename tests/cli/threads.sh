#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A run uses additional threads only if processors are free: none in the cases
# of a sweep, none if one processor is allowed.
. "$TOP/tests/support/cli.sh"
need taskset
[ -r /proc/self/task ] || skip 'no /proc'

dent_case 7 1000 0.1 1 -4.9 >dent.ini
printf '[study]\ncase = dent.ini\n[product]\ncontact.L = 5, 6\n' >study.ini

threads() { # PID: how many it has
    find "/proc/$1/task" -mindepth 1 -maxdepth 1 2>/dev/null | wc -l
}

"$OVERROLL" sweep study.ini -j 2 >out 2>err &
pid=$!
until [ -f study/L=5.h5 ] && [ -f study/L=6.h5 ]; do
    kill -0 $pid || fail "no sweep: $(cat out err)"
    sleep 0.1
done
workers=$(cat "/proc/$pid/task/$pid/children")
[ "$(echo "$workers" | wc -w)" -eq 2 ] || fail "not two workers: $workers"
for worker in $workers; do
    [ "$(threads "$worker")" -eq 1 ] || fail 'a case of a sweep has threads'
done
kill -s INT $pid
wait $pid

alone() { # THREADS COMMAND...
    most=$1
    shift
    rm -f a.h5*
    "$@" run dent.ini -o a.h5 >out 2>err &
    pid=$!
    begins a.h5
    found=$(threads $pid)
    kill -s INT $pid
    wait $pid
    [ "$found" -eq "$most" ] || fail "$found threads, not $most: $*"
}
cpu=$(taskset -cp $$ | sed 's/.*: //; s/[-,].*//')
alone 1 taskset -c "$cpu" "$OVERROLL"
[ "$(nproc)" -lt 2 ] || alone 2 "$OVERROLL"
