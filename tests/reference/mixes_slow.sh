#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every fifth of ten fixed combinations of physical models, and of five hot
# films, compared with an independent model (mixes.py, hot_mixes.py). make
# verify runs all of them.
. "$TOP/tests/support/cli.sh"
need_python numpy h5py

every=5
[ -z "${OVERROLL_VERIFY:-}" ] || every=1
export OVERROLL OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
expect 0 "$PYTHON" "$TOP/tests/reference/mixes.py" fixed $every
expect 0 "$PYTHON" "$TOP/tests/reference/hot_mixes.py" fixed $every
