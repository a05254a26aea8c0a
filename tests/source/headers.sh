#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every header compiles alone, public headers also as C++ and as C11. A header
# that a source file includes first has been compiled in this way.
set -u
cd "$TOP" || exit 1
status=0

# alone HEADER COMMAND...: compiles a file that includes only the header.
alone() {
    header=$1
    shift
    # C forbids a file without declarations, which version.h alone would be.
    printf '#include "%s"\nint declared;\n' "$header" |
        "$@" -Wall -Wextra -Wpedantic -Werror -fsyntax-only - || {
        echo "$header does not compile alone with: $*"
        status=1
    }
}

for path in include/overroll/*.h; do
    header=${path#include/}
    # shellcheck disable=SC2086 # CC may be a command and its options
    alone "$header" $CC -x c -std=c11 -Iinclude
    if command -v c++ >/dev/null; then
        alone "$header" c++ -x c++ -std=c++11 -Iinclude
    fi
done
first=$(for path in src/*/*.c src/*/*/*.c; do
    sed -n '/^#include/{s/#include "\(.*\)"/ \1 /p;q;}' "$path"
done)
for path in src/*/*.h src/*/*/*.h; do
    case $first in *" ${path#src/} "*) continue ;; esac
    # shellcheck disable=SC2086
    alone "${path#src/}" $CC $TEST_CFLAGS -DOVR_ISA=base -x c
done
exit $status
