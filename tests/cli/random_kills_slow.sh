#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A study of 64 draws killed three times; `make verify` kills one of 200.
DRAWS=64
. "$TOP/tests/support/random_kills.sh"
