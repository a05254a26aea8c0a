#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every input of every fuzz corpus goes through its target without a crash.
set -u
for replay in "$BUILD"/tests/fuzz/*_replay; do
    name=$(basename "$replay" _replay)
    corpus=$TOP/tests/fuzz/corpus/$name
    [ -d "$corpus" ] || { echo "$name has no corpus"; exit 1; }
    "$replay" "$corpus"/* || { echo "$name failed"; exit 1; }
done
