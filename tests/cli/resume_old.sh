#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Files that versions 0.1.0 and 0.2.0 stopped open, draw and go on as they
# began, with the order, scheme and mean between nodes that they had, whatever
# the defaults of today.  Those versions themselves ended with the numbers
# below.
. "$TOP/tests/support/cli.sh"

# stopped NAME: the file and its checkpoint, as old.h5.
stopped() {
    for part in h5 h5.restart; do
        gzip -dc "$TOP/tests/cli/stopped/$1.$part.gz" >"old.$part" || exit 1
    done
}

# ends KEY NUMBER BAND: out has it within this of the number, relatively.
ends() {
    ours=$(sed -n "s/^  \"$1\": \\([0-9.e-]*\\).*/\\1/p" out)
    awk -v a="$ours" -v b="$2" -v band="$3" \
        'BEGIN { d = a/b - 1; exit !(d*d < band*band) }' ||
        fail "$1 = $ours, by the older version $2"
}

# opens VERSION: what reads and draws result files takes this one.
opens() {
    expect 0 "$OVERROLL" info old.h5
    contains out "by overroll $1"
    expect 0 "$OVERROLL" export old.h5 --snapshot last
    command -v gnuplot >/dev/null || return 0
    expect 0 "$OVERROLL" plot old.h5 -o old.png --force
    [ -s old.png ] || fail "nothing was drawn of $1"
}

# A step is solved to a tolerance, on these levels some 1e-5 of H.
stopped 0.1.0
opens 0.1.0
expect 0 "$OVERROLL" resume old.h5 --set time.end=1 --json
contains out '"order": 2'
contains out '"scheme": "upstream2"'
ends H_cen 0.0769017516 1e-4

stopped 0.2.0-starved
opens 0.2.0
expect 0 "$OVERROLL" resume old.h5 --set time.end=2 --json
contains out '"scheme": "upstream2"'
ends H_cen 0.053027349211237348 1e-4
ends mu_slide 0.047226470429812366 1e-4

# `scheme = auto` was another one under histories.
stopped 0.2.0-histories
opens 0.2.0
expect 0 "$OVERROLL" resume old.h5 --set time.end=2 --json
contains out '"scheme": "upstream2"'
ends H_min 0.10534899354765581 1e-4
ends H_cen 0.15755984956194394 1e-4

# Hot films of 0.2.0 lagged by a step, by 3.5e-4 of H at level 7 and first order
# in D: on this mesh of level 3 by up to 16 times that.  Ours was said to begin
# without what 0.2.0 did not keep.
stopped 0.2.0-hot
opens 0.2.0
expect 0 "$OVERROLL" resume old.h5 --set time.end=2 --json
contains err 'overroll 0.2.0 kept less'
ends H_cen 0.17046447202527804 5.6e-3
ends T_max_rise 33.299033034282971 5.6e-3
opens 0.2.0

# Another order or scheme is another run, said and refused.
stopped 0.1.0
expect 2 "$OVERROLL" resume old.h5 --set time.end=1 --set domain.order=4
contains err "'domain.order' was '2' and is now '4'"
