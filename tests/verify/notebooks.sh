#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The notebooks of tools/python run completely; their pictures remain in
# $OVERROLL_VERIFY/notebooks. 10,000 simulations leak no memory.
. "$TOP/tests/support/cli.sh"

need gnuplot
need_python cffi setuptools wheel pip pytest xarray h5py nbclient nbformat \
    ipykernel matplotlib
"$PYTHON" -m venv --system-site-packages --without-pip venv || skip "no venv"
OVERROLL_LIBRARY=$SHARED
export OVERROLL_LIBRARY
expect 0 venv/bin/python -m pip install -q --no-build-isolation --no-index \
    "$TOP/tools/python"
# The kernel is the system's Python.
PYTHONPATH=$(venv/bin/python -c 'import overroll, os
print(os.path.dirname(os.path.dirname(overroll.__file__)))')
export PYTHONPATH
venv/bin/python -B "$TOP/tests/verify/notebooks.py" \
    "${OVERROLL_VERIFY:-.}/notebooks" "$TOP"/tools/python/notebooks/*.ipynb ||
    fail 'a notebook failed'
SIMULATIONS=10000 venv/bin/python -B -m pytest -q -p no:cacheprovider \
    "$TOP/tests/python/test_threads.py" || fail 'memory is lost'
