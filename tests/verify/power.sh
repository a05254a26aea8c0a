#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# 201 states that the disk may be in when the machine dies: of a run, and half
# as many of the resuming of one.
. "$TOP/tests/support/power.sh"
STATES=${STATES:-134} SEED=${SEED:-1}
power_test
