#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The studies and cases of tools/examples can be read; `make verify` runs them.
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
