#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Random mixes of physics against an independent model, another seed each day:
# see reference/mixes.py.  OVERROLL_SEED and OVERROLL_RUNS choose others.
. "$TOP/tests/support/cli.sh"
need_python numpy h5py

export OVERROLL OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
"$PYTHON" "$TOP/tests/reference/mixes.py" random \
    "${OVERROLL_SEED:-$(date +%Y%m%d)00}" "${OVERROLL_RUNS:-60}"
