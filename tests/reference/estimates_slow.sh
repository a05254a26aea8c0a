#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A tenth of tests/verify/estimates.sh, at level 5 compared with level 7.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/estimates.sh"

estimates 4 5 4 || fail 'the estimates are optimistic'
