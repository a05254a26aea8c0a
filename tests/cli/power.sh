#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A few states that the disk may be in when the machine dies; `make verify`
# tries 200.
. "$TOP/tests/support/power.sh"
STATES=10 SEED=1 LEVEL=4 END=2 SPEED=500
power_test
