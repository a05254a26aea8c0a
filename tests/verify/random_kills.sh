#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A study of 200 draws killed three times.
DRAWS=200
. "$TOP/tests/support/random_kills.sh"
