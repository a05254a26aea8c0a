#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every command of overroll-tutorial(7) runs, in its order, on coarser grids.
. "$TOP/tests/support/cli.sh"
need gnuplot

sed -n '/^\.EX/,/^\.EE/p' "$TOP/src/cli/overroll-tutorial.7" |
    sed 's/\\e$/\\/; s/\\-/-/g' >examples
awk '/^\[study\]/, /^\.EE/ { if ($0 !~ /^\.EE/) print }' examples >depth.ini
sed -i 's/^domain.level = 7/domain.level = 5/' depth.ini
[ "$(grep -c = depth.ini)" -eq 4 ] || fail "no study: $(cat depth.ini)"
cp "$TOP/profiles/ground.csv" mine.csv

awk '/^overroll / || more { print; more = /\\$/ }' examples >commands
[ "$(grep -c '^overroll' commands)" -ge 14 ] || fail "$(cat commands)"
overroll() {
    case $1 in
    run | find) "$OVERROLL" "$@" --level 5 ;;
    *) "$OVERROLL" "$@" ;;
    esac >out 2>err || fail "overroll $*: $(cat err)"
}
. ./commands
for file in history.png gear.html both.png mine.png depth.png error.h5; do
    [ -s "$file" ] || fail "no $file"
done
