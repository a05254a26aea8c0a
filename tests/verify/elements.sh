#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# 12 random gears, 10 cams and 8 bearings marched at level 6 with all that goes
# with them.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/elements.sh"
march_elements 1
[ "$ran" -eq 102 ] || fail "only $ran runs"
[ "${resumed:-0}" -ge 6 ] || fail "only ${resumed:-0} were stopped on the way"
