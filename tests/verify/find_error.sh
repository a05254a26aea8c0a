#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The discretization error printed by find at levels 6 to 8 includes the answer
# of level 9: there the film is thicker than requested at one end of the
# interval and thinner at the other.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.2
[time]
end = 6.4
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4.6
END
H_min_at() { # DEPTH
    "$OVERROLL" run dent.ini --set "feature.dent.depth=$1" --level 9 --json |
        sed -n 's/^  "H_min_overall": \(.*\),/\1/p'
}
last=1
for level in 6 7 8; do
    expect 0 "$OVERROLL" find dent.ini feature.dent.depth between 0.01 and 0.5 \
        so that H_min_overall is 0.05 --level $level --json
    value=$(sed -n 's/^  "value": \(.*\),/\1/p' out)
    error=$(sed -n 's/^  "key_error_discretization": \(.*\),/\1/p' out)
    thick=$(H_min_at "$(echo "$value $error" | awk '{ print $1 - $2 }')")
    thin=$(H_min_at "$(echo "$value $error" | awk '{ print $1 + $2 }')")
    echo "level $level: $value +- $error; H_min_overall $thick and $thin"
    echo "$thick $thin $error $last" |
        awk '{ exit !($1 >= 0.05 && $2 <= 0.05 && $3 < $4) }' ||
        fail "the error of level $level does not cover the answer"
    last=$error
done
