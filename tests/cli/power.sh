#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Possible states of the disk after a crash of the machine: of a run, and half
# as many of a resumed run. 15 in all; in make verify 201, of a longer run.
. "$TOP/tests/support/power.sh"
if [ -n "${OVERROLL_VERIFY:-}" ]; then
    STATES=${STATES:-134} SEED=${SEED:-1}
else
    STATES=10 SEED=1 LEVEL=4 END=2 SPEED=500
fi
power_test
