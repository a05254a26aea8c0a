#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every key of 0.2.0 is there today with its default of then, or stands in the
# page of what changes from one version to the next.
. "$TOP/tests/support/cli.sh"

page=$TOP/src/case/overroll-changes.7
grep -v '^#' "$TOP/tests/cli/stopped/keys-0.2.0.txt" >keys.txt
[ "$(wc -l <keys.txt)" -gt 250 ] || fail "keys of 0.2.0 are lost"

# SECTION.KEY DEFAULT of today, in the words of help
for section in $(sed 's/\..*//' keys.txt | sort -u); do
    "$OVERROLL" help "$section" |
        sed -n -E "s/^  ([A-Za-z][A-Za-z0-9_]*) +\((.*)\)$/$section.\1 \2/p
            s/^  ([A-Za-z][A-Za-z0-9_]*) *$/$section.\1 -/p"
done | sort >now

sort keys.txt | while read -r key value; do
    today=$(sed -n "s/^$key //p" now)
    [ "$today" = "$value" ] && continue
    section=${key%.*} name=${key#*.}
    [ -n "$today" ] || {
        grep -q "\[$section\].*$name\|$name.*\[$section\]" "$page" ||
            fail "$key is gone, and $page does not say so"
        continue
    }
    grep -q "^\.B.*\[$section\] $name: $today" "$page" ||
        fail "$key was $value and is $today, and $page does not say so"
    grep -q "^\.B.*$name: $today, was $value" "$page" ||
        fail "$key was $value, and $page does not say so"
done || exit 1
