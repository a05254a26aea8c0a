#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# reference/heat_lag_slow.sh with levels 8 and 9.
HEAT_LEVELS='6 7 8 9' exec "$TOP/tests/reference/heat_lag_slow.sh"
