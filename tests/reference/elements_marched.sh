#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Random gears, cams and bearings are marched at level 6 with the usual physical
# models: 12 gears, 10 cams and 8 bearings in make verify, otherwise a tenth.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/elements.sh"
if [ -n "${OVERROLL_VERIFY:-}" ]; then
    march_elements 1
    [ "$ran" -eq 102 ] || fail "only $ran runs"
    [ "${resumed:-0}" -ge 6 ] || fail "only ${resumed:-0} were stopped"
else
    march_elements 10
    [ "$ran" -ge 9 ] || fail "only $ran runs"
fi
