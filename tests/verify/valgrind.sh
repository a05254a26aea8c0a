#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# valgrind finds no error in a steady and a transient run.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "sanitizers and valgrind do not mix"
need valgrind

watched() {
    expect 0 valgrind --quiet --error-exitcode=99 --leak-check=full \
        --errors-for-leak-kinds=definite "$OVERROLL" "$@"
}

watched steady --M 20 --L 10 --level 6
dent_case 6 0.5 0.1 0.5 -1.5 >dent.ini
watched run dent.ini -o dent.h5
