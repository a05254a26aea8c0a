#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run by conda-build in the source tree; PREFIX is the environment to fill.
set -eu
make -j"${CPU_COUNT:-1}" install PREFIX="$PREFIX"
