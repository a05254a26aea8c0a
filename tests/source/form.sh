#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source file names its licence in its first two lines, is at most 80
# columns wide, and has neither tabs nor blanks at line ends.  Nothing else
# stands in the top folder.  How long functions are is told and fails nothing: a
# function is as long as its one idea.  Comments are whole sentences: how many
# of sources and public headers begin as fragments is told, and may only fall.
set -u
cd "$TOP" || exit 1
status=0
for file in *; do
    case $file in
    Makefile | src | include | profiles | tests | tools | README.md) ;;
    LICENSE | CHANGELOG.md | build | build-*) ;;
    *)
        echo "$file: does not belong into the top folder"
        status=1
        ;;
    esac
done
# Bytes beyond ASCII make a line longer than it looks: awk counts bytes.
find src/*/*.[ch] src/*/*/*.[ch] include/overroll/*.h \
    tests/*/*.[ch] tests/*/*.sh tests/support/run tests/soak/run \
    tools/* tools/examples/* .ci/run Makefile \
    tests/python/*.py tests/bench/*.py tests/verify/*.py \
    tests/reference/*.py tools/python/*.py \
    tools/python/*/*.py -maxdepth 0 -type f -print0 | xargs -0 awk '
    FNR == 1 { done(); file = FILENAME; licensed = 0 }
    FNR <= 2 && /SPDX-License-Identifier: GPL-3\.0-or-later/ { licensed = 1 }
    file == "Makefile" { next }
    { gsub(/[\200-\277]/, "") }
    length > 80 { print file ":" FNR ": wider than 80"; bad = 1 }
    /\t/        { print file ":" FNR ": a tab"; bad = 1 }
    / $/        { print file ":" FNR ": blanks at the end"; bad = 1 }
    function done() {
        if (file == "" || licensed) return
        print file ": no SPDX line"
        bad = 1
    }
    END { done(); exit bad }' || status=1
# Functions, their median length, and the longest.
awk 'FNR == 1 { open = 0 }
    /^[A-Za-z_]/ { head = FNR; name = $0 }
    /^\{/ { open = head }
    /^}/ && open {
        print FNR - open + 1, FILENAME ":" open, name
        open = 0
    }' src/*/*.c src/*/*/*.c | sort -n | awk '
    { all[NR] = $0 }
    END {
        split(all[int((NR + 1) / 2)], middle, " ")
        print NR " functions, median " middle[1] " lines; the longest:"
        for (k = NR - 4; k <= NR; k++) print "  " all[k]
    }'
# Comments that begin as fragments; the dozen left are sentences whose verb the
# script does not know.
limit=12
fragments=$(find src include -name '*.[ch]' | sort |
    xargs awk -f tests/source/fragments.awk)
count=$(echo "$fragments" | grep -c .)
echo "$count comments begin as fragments, of at most $limit"
[ "$count" -le "$limit" ] || {
    echo "$fragments"
    status=1
}
exit $status
