#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of 40 random cases, of 25 cases with deep dents, textures and short
# waves, and of 30 typical cases, compared with the error that `check` expects.
. "$TOP/tests/support/cli.sh"
need_python csv json

"$PYTHON" "$TOP/tests/verify/errors.py" "$OVERROLL" "${SEED:-1}" 40 ||
    fail 'errors exceed those expected'
"$PYTHON" "$TOP/tests/verify/errors.py" "$OVERROLL" "${SEED:-1}" 25 uncommon ||
    fail 'errors of uncommon features exceed those expected'
"$PYTHON" "$TOP/tests/verify/errors.py" "$OVERROLL" "${SEED:-61000}" 30 \
    default ||
    fail 'errors of cases like those of users exceed what accuracy.md says'
