#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Ten fixed mixes of physics, and hot films, against an independent model: see
# mixes.py, hot_mixes.py.
. "$TOP/tests/support/cli.sh"
need_python numpy h5py

export OVERROLL OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
expect 0 "$PYTHON" "$TOP/tests/reference/mixes.py" fixed
expect 0 "$PYTHON" "$TOP/tests/reference/hot_mixes.py" fixed
