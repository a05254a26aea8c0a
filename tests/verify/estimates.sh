#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Estimated errors of extremes in time are not optimistic: 40 random cases at
# level 6 beside level 8.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/estimates.sh"

estimates 40 6 38 || fail 'the estimates are optimistic'
