#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# --version begins with the program's version, the one in version.h.
. "$TOP/tests/support/cli.sh"

version=$(sed -n 's/.*OVERROLL_VERSION "\(.*\)"/\1/p' \
    "$TOP/include/overroll/version.h")
expect 0 "$OVERROLL" --version
contains out "(^|[^0-9.])$version($|[^0-9.])"
