#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every case of profiles/ runs to its end (on a coarse grid here) without a
# warning or a marked step, and its surface says where it is from.
. "$TOP/tests/support/cli.sh"

for case in "$TOP"/profiles/*.ini; do
    name=$(basename "$case" .ini)
    head -n 1 "${case%.ini}.csv" |
        grep -q "made by tools/make-profiles $name" ||
        fail "$name.csv does not say where it is from"
    expect 0 "$OVERROLL" run "$case" -o "$name.h5" --json \
        --set domain.level=6
    contains out '"steps_marked": 0'
    contains err 'overroll: feature .*: column 1 is x'
    ! grep warning err ||
        fail "$name: $(grep warning err)"
done
