#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# 300 hot contacts one surface of which hardly moves, another seed each day.
OVERROLL_RUNS=${OVERROLL_RUNS:-300}
OVERROLL_SEED=${OVERROLL_SEED:-$(date +%Y%m%d)}
export OVERROLL_RUNS OVERROLL_SEED
exec "$TOP/tests/reference/still_surfaces.sh"
