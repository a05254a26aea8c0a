#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The files and tests in the table of equations of overroll-theory(7) exist, and
# every file whose head comment contains an equation is in the table.
set -u
cd "$TOP" || exit 1
page=src/multigrid/overroll-theory.7
status=0
table=$(mktemp)
trap 'rm -f "$table"' EXIT
sed -n '/^\.SH EQUATION, FILE, TEST/,/^\.EE/p' $page >"$table"

complain() {
    echo "$page: $*"
    status=1
}

files=$(grep -oE '[a-z_/0-9]+\.(kernel\.)?[ch]\b' "$table")
tests=$(grep -oE '[a-z]+/[a-z_0-9]+(_test|\.sh)$' "$table")
count=$(echo "$files" | wc -l)
if [ "$count" -lt 40 ] || [ "$count" -ne "$(echo "$tests" | wc -l)" ]; then
    complain 'the table is not files and tests'
fi
for file in $files; do
    [ -f "src/$file" ] || complain "no src/$file"
done
for test in $tests; do
    [ -f "tests/$test" ] || [ -f "tests/$test.c" ] || complain "no tests/$test"
done

# An equation: an indented line of the opening comment with " = ".
for path in src/contact/*.[ch] src/contact/laws/*.h src/surface/*.[ch] \
    src/multigrid/*.[ch] src/strip/*.[ch] src/simulation/*.[ch] \
    src/stress/*.[ch] src/physics/*/*.[ch]; do
    file=${path#src/}
    awk 'FNR > 1 && /\*\// { exit }
         /^ \*     *.* = / { found = 1; exit }
         END { exit !found }' "$path" || continue
    echo "$files" | grep -qxF "$file" ||
        complain "$file opens with an equation, the table lacks it"
done
exit $status
