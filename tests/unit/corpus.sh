#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every input of every fuzz corpus goes through its target without a crash.
set -u
for target in "$TOP"/tests/fuzz/*_fuzz.c; do
    name=$(basename "$target" _fuzz.c)
    corpus=$TOP/tests/fuzz/corpus/$name
    [ -d "$corpus" ] || { echo "$name has no corpus"; exit 1; }
    "$BUILD/tests/fuzz/replay" "$name" "$corpus"/* ||
        { echo "$name failed"; exit 1; }
done
