#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source file names its licence in its first two lines and is at most 80
# columns wide (except rows of Markdown tables), without tabs and without blanks
# at line ends. The top folder contains only the listed files. Lengths of
# functions are printed and not checked: a function is as long as its one idea.
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
    length > 80 && !(file ~ /[.]md$/ && /^\|/) {
        print file ":" FNR ": wider than 80"
        bad = 1
    }
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
exit $status
