#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Estimated errors of transient extremes are not too small: 40 random cases at
# level 6 compared with level 8.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/estimates.sh"

estimates 40 6 38 || fail 'the estimates are optimistic'
