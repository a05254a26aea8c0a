#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Kinds of init with long runs: no warning on the level that they set.
# cli/init.sh runs the other kinds.
. "$TOP/tests/support/cli.sh"

for kind in bearing indented strip; do
    expect 0 "$OVERROLL" init $kind -o quiet.ini
    expect 0 "$OVERROLL" run quiet.ini -o quiet.h5
    if grep warning err; then
        fail "init $kind warns"
    fi
    rm -f ./quiet*
done
