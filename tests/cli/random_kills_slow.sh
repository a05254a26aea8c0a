#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A study of 60 draws killed three times; `make verify` kills one of 200.
DRAWS=60
. "$TOP/tests/support/random_kills.sh"
