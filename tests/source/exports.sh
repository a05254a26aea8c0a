#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The shared library exports exactly the functions that public headers declare
# with OVR_API, at most 170. Each is called by the program, by Python or by the
# example of the manual. Every global name of the static library begins with
# ovr_.
set -u
if [ -n "$INSTRUMENTED" ]; then
    echo "instrumented libraries carry symbols of their own"
    exit 77
fi

# The declared names: after the preprocessor OVR_API is an attribute; the name
# stands before the first parenthesis or at the end.
for header in "$TOP"/include/overroll/*.h; do
    # shellcheck disable=SC2086
    $CC -E -P -I"$TOP/include" -x c "$header" || exit 1
done | tr '\n' ' ' | tr ';{}' '[\n*]' |
    sed -n 's/.*visibility("default"))) *//p' |
    sed 's/ *(.*//; s/ *\[.*//; s/.*[ *]//' | sort -u >declared

nm -D --defined-only "$SHARED" | awk '$2 ~ /[A-Z]/ { print $3 }' |
    grep -vxE '_init|_fini|_edata|_end|__bss_start' | sort -u >exported
nm -g --defined-only "$LIB" | awk 'NF == 3 { print $3 }' | sort -u >global

comm -13 declared exported | sed 's/$/ is exported but not declared/' >wrong
comm -23 declared exported | sed 's/$/ is declared but not defined/' >>wrong
grep -v '^ovr_' global | sed 's/$/ is global without ovr_ before it/' >>wrong
nm -D --defined-only "$SHARED" | awk '$2 == "T" { print $3 }' |
    grep -vxE '_init|_fini' >functions
count=$(wc -l <functions)
[ "$count" -le 170 ] || echo "$count functions are exported" >>wrong
cat "$TOP"/src/cli/*.[ch] "$TOP"/src/*/overroll-library.3 \
    "$TOP"/tools/python/overroll/*.py >users
while read -r name; do
    grep -qw "$name" users || echo "$name is exported, and has no use" >>wrong
done <functions
cat wrong
[ ! -s wrong ] && [ -s declared ]
