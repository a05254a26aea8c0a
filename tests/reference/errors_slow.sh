#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A tenth of tests/verify/errors.sh.
. "$TOP/tests/support/cli.sh"
need_python csv json

"$PYTHON" "$TOP/tests/verify/errors.py" "$OVERROLL" 101 4 ||
    fail 'errors exceed those expected'
"$PYTHON" "$TOP/tests/verify/errors.py" "$OVERROLL" 7 3 uncommon ||
    fail 'errors of uncommon features exceed those expected'
"$PYTHON" "$TOP/tests/verify/errors.py" "$OVERROLL" 61098 2 default ||
    fail 'errors of cases like those of users exceed what accuracy.md says'
