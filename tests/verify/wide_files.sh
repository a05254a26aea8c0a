#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The cases of reference/wide_case_slow_test in files, through the commands of
# the program (wide_files.py). OVERROLL_SEED and OVERROLL_RUNS select others,
# OVERROLL_MOST (s) leaves out those with a longer estimate.
. "$TOP/tests/support/cli.sh"
need_python numpy h5py

cases=$BUILD/tests/reference/wide_case_slow_test
[ -x "$cases" ] || skip "make verify compiles the program that draws the cases"
export OVERROLL INSTRUMENTED PYTHONDONTWRITEBYTECODE=1
seed=${OVERROLL_SEED:-7500000}
runs=${OVERROLL_RUNS:-60}
code=0
OVERROLL_CASES=. OVERROLL_SEED=$seed OVERROLL_RUNS=$runs "$cases" >log 2>&1 ||
    code=$?
[ $code -ne 2 ] || skip "make verify links the program that draws the cases"
[ $code -eq 0 ] || fail "no cases: $(cat log)"
"$PYTHON" "$TOP/tests/verify/wide_files.py" . "$seed" "$runs" \
    "${OVERROLL_MOST:-2}"
