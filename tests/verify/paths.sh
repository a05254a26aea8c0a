#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# gcc analyses the paths through each file (300 s on one core).
. "$TOP/tests/support/cli.sh"
command -v gcc >/dev/null || skip 'no gcc'
make -C "$TOP" lint-analyzer
