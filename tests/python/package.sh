#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The Python package: installed into a venv as a user would, then its tests.
. "$TOP/tests/support/cli.sh"

[ -z "$INSTRUMENTED" ] || skip "Python cannot load an instrumented library"
need_python cffi setuptools wheel venv pip pytest xarray h5netcdf
"$PYTHON" -m venv --system-site-packages --without-pip venv || skip "no venv"
OVERROLL_LIBRARY=$SHARED
export OVERROLL_LIBRARY
expect 0 venv/bin/python -m pip install -q --no-build-isolation --no-index \
    "$TOP/tools/python"
unset OVERROLL_LIBRARY
venv/bin/python -B -m pytest -q -p no:cacheprovider -W ignore --durations=8 \
    "$TOP/tests/python" || fail "pytest failed"
