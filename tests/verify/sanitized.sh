#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# All tests, including slow ones, with the address and undefined-behaviour
# sanitizers.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "sanitized already"
make -C "$TOP" SAN=1 CC="$CC" check
