#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The case that `check -v` prints is the same case: all numbers of the kinds of
# init, of the materials of bodies and layers.
. "$TOP/tests/support/cli.sh"

alike() { # FILE
    expect 0 "$OVERROLL" check "$1" -v
    cp out printed.ini
    expect 0 "$OVERROLL" check "$1" --json
    sed '/"estimated_seconds"/d; /"warnings"/,$d' out >of_case
    expect 0 "$OVERROLL" check printed.ini --json
    sed '/"estimated_seconds"/d; /"warnings"/,$d' out | cmp -s of_case - ||
        fail "$1 printed is another case: $(diff of_case out | head -n 5)"
    [ "$(wc -l <of_case)" -gt 30 ] || fail "few numbers: $(cat of_case)"
}
for kind in roller gear cam bearing indented coated numbers starved discs hot \
    strip; do
    expect 0 "$OVERROLL" init $kind -o $kind.ini --force
    alike $kind.ini
done
for material in steel silicon-nitride tungsten-carbide bronze glass sapphire; do
    sed '/^modulus/d' roller.ini >body.ini
    for body in 1 2; do
        printf '[body %s]\nmaterial = %s\n' $body $material
    done >>body.ini
    alike body.ini
done
for layer in dlc babbitt ptfe; do
    printf '[coating 1]\nmaterial = %s\nthickness = 20 um\n' $layer |
        cat body.ini - >layer.ini
    alike layer.ini
done
