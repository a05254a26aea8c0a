#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Random combinations of physical models, compared with an independent model
# (reference/mixes.py, hot_mixes.py, metal_mixes.py), with another seed each
# day. OVERROLL_SEED and OVERROLL_RUNS set seed and number of cases; a tenth of
# this number are hot films, and a twentieth are plastic bodies. The fixed cases
# of plastic bodies run first.
. "$TOP/tests/support/cli.sh"
need_python numpy h5py

export OVERROLL OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
seed=${OVERROLL_SEED:-$(date +%Y%m%d)00}
runs=${OVERROLL_RUNS:-60}
"$PYTHON" "$TOP/tests/reference/metal_mixes.py" fixed || failed=1
"$PYTHON" "$TOP/tests/reference/mixes.py" random "$seed" "$runs" || failed=1
"$PYTHON" "$TOP/tests/reference/hot_mixes.py" random "$seed" \
    $(((runs + 9) / 10)) || failed=1
"$PYTHON" "$TOP/tests/reference/metal_mixes.py" random "$seed" \
    $(((runs + 19) / 20)) || failed=1
exit ${failed:-0}
