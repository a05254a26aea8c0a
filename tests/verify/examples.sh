#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every example of tools/examples runs and draws its picture.
. "$TOP/tests/support/cli.sh"
need gnuplot
for script in "$TOP"/tools/examples/*; do
    [ -x "$script" ] || continue
    name=$(basename "$script")
    expect 0 env EXAMPLES="$PWD/made" OVERROLL="$OVERROLL" "$script"
    [ "$(head -c 4 "made/$name.png" | tail -c 3)" = PNG ] ||
        fail "$name makes no picture"
done
