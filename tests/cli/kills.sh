#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs killed at random times and at writes: 6 and every 17th write; in make
# verify 200 and each write.
. "$TOP/tests/support/kills.sh"
if [ -n "${OVERROLL_VERIFY:-}" ]; then
    KILLS=${KILLS:-200} SEED=7 STRIDE=1
else
    KILLS=6 SEED=1 STRIDE=17
fi
kill_test
[ -n "$INSTRUMENTED" ] || kill_writes_test
