#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Not every eleventh write and read fails, but each.
STRIDE=1
. "$TOP/tests/cli/io_faults.sh"
