#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# 200 runs killed at random instants.
. "$TOP/tests/support/kills.sh"
KILLS=${KILLS:-200} SEED=7 MOST=0.6
kill_test
