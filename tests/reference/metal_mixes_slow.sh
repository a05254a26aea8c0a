#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# One of five fixed mixes of bodies that yield with other physics, against an
# independent model: see metal_mixes.py, metal.py (all: verify/mixes.sh).
. "$TOP/tests/support/cli.sh"
need_python numpy h5py

export OVERROLL OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
expect 0 "$PYTHON" "$TOP/tests/reference/metal_mixes.py" fixed 5
cat out
