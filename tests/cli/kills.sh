#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A few runs killed at random instants and writes; `make verify` kills 200, and
# one at each write.
. "$TOP/tests/support/kills.sh"
KILLS=6 SEED=1
kill_test
[ -n "$INSTRUMENTED" ] || STRIDE=17 kill_writes_test
