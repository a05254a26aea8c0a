#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Calls every public function with NULL for each pointer and NaN for each number
# in turn (arguments.py, arguments.h). The function returns an error where it
# can detect the value, and never crashes.
. "$TOP/tests/support/cli.sh"

[ -z "$INSTRUMENTED" ] || skip "the shared library is instrumented"
need_python re sys
name=$(objdump -p "$SHARED" | awk '$1 == "SONAME" { print $2 }')
ln -s "$SHARED" "$name" || fail "no link to $SHARED"

echo '#include <overroll/overroll.h>' |
    $CC -E -P -I"$TOP/include" -x c - >api.h ||
    fail "the headers do not compile"
"$PYTHON" "$TOP/tests/source/arguments.py" api.h >arguments.c ||
    fail "no calls"
$CC -std=gnu17 -w -I"$TOP/include" -I"$TOP/tests/source" -o arguments \
    arguments.c "./$name" -lm >log 2>&1 || fail "$(head -n 20 log)"
LD_LIBRARY_PATH=. ./arguments >out 2>err || fail "$(cat out)"

# All of them: as many functions as the library exports have been called.
grep -o '{"ovr_[a-z0-9_]*"' arguments.c | sort -u | wc -l >called
[ "$(cat called)" -gt 120 ] || fail "only $(cat called) functions were called"
cat out
