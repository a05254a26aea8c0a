#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Asperity load share and friction of mixed contacts that check estimates, and
# 30 runs.
. "$TOP/tests/support/cli.sh"
need_python json

"$PYTHON" "$TOP/tests/cli/mixed_estimates.py" "$OVERROLL" "${SEED:-20000}" 30 ||
    fail 'estimates of mixed contacts are not as overroll-case(5) says'
