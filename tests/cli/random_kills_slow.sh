#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A study of 64 samples, in make verify of 200, killed three times.
DRAWS=${OVERROLL_VERIFY:+200}
DRAWS=${DRAWS:-64}
. "$TOP/tests/support/random_kills.sh"
