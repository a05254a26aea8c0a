#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# 200 states that the disk may be in when the machine dies.
. "$TOP/tests/support/power.sh"
STATES=${STATES:-140} SEED=${SEED:-1}
power_test
