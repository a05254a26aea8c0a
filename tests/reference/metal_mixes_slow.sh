#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# One of five fixed cases of plastic bodies with other physical models, compared
# with an independent model (metal_mixes.py, metal.py). verify/mixes.sh runs all
# five.
. "$TOP/tests/support/cli.sh"
need_python numpy h5py

export OVERROLL OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
expect 0 "$PYTHON" "$TOP/tests/reference/metal_mixes.py" fixed 5
cat out
