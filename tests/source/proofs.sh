#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every test named in tools/validation/proofs.md exists: `FOLDER/FILE` below
# tests, without the ending `.c` if it is omitted, and in `FOLDER/FILE:NAME` one
# of its TESTs or Python functions. `make GOAL` is a goal of the Makefile. Each
# manual page has a table, each public header a row, and the lists of the
# Makefile name tests.
. "$TOP/tests/support/cli.sh"

list=$TOP/tools/validation/proofs.md
folders='unit|reference|verify|cli|python|pictures|paper|source|fuzz|soak|bench'

# names FILE: what stands between ` and `, a line each.
names() {
    tr '\n' ' ' <"$1" | grep -oE '`[^`]+`' | tr -d '`'
}

# missing FILE: what it names and what is not there.
missing() {
    names "$1" | grep -E "^($folders)/" | while read -r name; do
        file=$TOP/tests/${name%%:*}
        [ -f "$file" ] || file=$file.c
        if [ ! -f "$file" ]; then
            echo "no test ${name%%:*}"
        elif [ "$name" != "${name#*:}" ]; then
            grep -qE "^(TEST[A-Z_]*\(|def )${name#*:}\>" "$file" ||
                echo "no ${name#*:} in $file"
        fi
    done
    names "$1" | sed -n 's/^make \([a-z-]*\).*/\1/p' | while read -r goal; do
        grep -qE "^$goal:" "$TOP/Makefile" "$TOP/src/web/web.mk" ||
            echo "no goal $goal"
    done
}

count=$(names "$list" | grep -cE "^($folders)/")
[ "$count" -ge 170 ] || fail "proofs.md names $count tests"

# Each page of the manual has its table.
for page in "$TOP"/src/*/overroll*.[0-9]; do
    name=$(basename "$page")
    grep -q "^###.* *${name%.*}(${name##*.})" "$list" ||
        fail "proofs.md has no table of ${name%.*}(${name##*.})"
done
# Each public header has a row, unless it only includes the others.
for header in "$TOP"/include/overroll/*.h; do
    name=$(basename "$header")
    [ "$name" = overroll.h ] ||
        grep -qE "^\|( [a-z]*\.h,)* ${name}[, ]" "$list" ||
        fail "proofs.md has no promise of $name"
done
grep -q '^### overroll help$' "$list" || fail 'proofs.md has no table of help'
missing "$list" >gone
[ ! -s gone ] || fail "proofs.md names what is not there: $(cat gone)"

# The lists of tests in the Makefile, which would leave out what is not there.
grep -oE "\\b($folders)/[a-z_0-9]+(_test\.c|\.sh)" "$TOP/Makefile" >listed
[ "$(wc -l <listed)" -ge 40 ] || fail "the Makefile lists $(wc -l <listed)"
while read -r name; do
    [ -f "$TOP/tests/$name" ] || fail "Makefile: no tests/$name"
done <listed

# What is not there is found, also across lines and beside what is.
cat >wrong.md <<'END'
A file `unit/nothing_test`, `cli/run.sh`, a test in one
`unit/memory_test.c:heat_is_announced`, `unit/memory_test:nothing_is_tested`,
`python/test_run.py:test_units`, `python/test_run.py:test_nothing`, `make
paper`, `make proofs`, 1e-3 `not/a_test`.
END
missing wrong.md >gone
[ "$(wc -l <gone)" -eq 4 ] && grep -q 'no test unit/nothing_test' gone &&
    grep -q 'no nothing_is_tested in .*/unit/memory_test.c' gone &&
    grep -q 'no test_nothing in' gone && grep -q 'no goal proofs' gone ||
    fail "wrong names found: $(cat gone)"
