#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library never prints, exits, aborts or reads the environment: it has no
# reference to functions for these purposes. (Writing to its own files is
# allowed, and pool.o ends the processes that it has forked.)
set -u
nm -A -u "$LIB" 2>/dev/null | grep -v ':pool\.o:.* _exit$' | awk '
    $NF ~ /^(stdin|stdout|stderr|puts|putchar|perror)$/ ||
    $NF ~ /^(__)?v?printf(_chk)?$/ ||
    $NF ~ /^(_?exit|_Exit|quick_exit|abort|__assert_fail)$/ ||
    $NF ~ /^(secure_)?getenv$|^(set|put)env$|^setlocale$|^signal$/ {
        sub(/.*\.a:/, "")
        print
        bad = 1
    }
    END { exit bad }'
