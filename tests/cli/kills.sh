#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A few runs killed at random instants; `make verify` kills 200.
. "$TOP/tests/support/kills.sh"
KILLS=6 SEED=1 MOST=0.4
kill_test
