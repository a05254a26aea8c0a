#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A tenth of the random gears, cams and bearings marched; `make verify` takes
# them all.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/elements.sh"
march_elements 10
[ "$ran" -ge 9 ] || fail "only $ran runs"
