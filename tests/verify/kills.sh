#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# 200 runs killed at random instants, and one at each write.
. "$TOP/tests/support/kills.sh"
KILLS=${KILLS:-200} SEED=7
kill_test
[ -n "$INSTRUMENTED" ] || STRIDE=1 kill_writes_test
