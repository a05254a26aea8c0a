#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The studies and cases of tools/examples can be read, and the quick ones end in
# their pictures; `make verify` runs all.
. "$TOP/tests/support/cli.sh"
for file in "$TOP"/tools/examples/*.ini; do
    if grep -q '^\[product\]\|^\[zip\|^\[random' "$file"; then
        expect 0 "$OVERROLL" sweep "$file" -o here --list
        [ "$(wc -l <out)" -ge 2 ] || fail "$file: $(cat out)"
    else
        expect 0 "$OVERROLL" check "$file"
    fi
    [ -x "${file%.ini}" ] || fail "no script for $file"
done

[ -z "$INSTRUMENTED" ] || exit 0 # what they run is tested by itself
command -v gnuplot >/dev/null || exit 0
for name in film-chart heat liner coating; do
    expect 0 env EXAMPLES="$PWD/made" OVERROLL="$OVERROLL" \
        "$TOP/tools/examples/$name"
    [ "$(head -c 4 "made/$name.png" | tail -c 3)" = PNG ] ||
        fail "$name makes no picture: $(cat err)"
done
