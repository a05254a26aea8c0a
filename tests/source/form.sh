#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source file names its licence in its first two lines, is at most 80
# columns wide, and has neither tabs nor blanks at line ends.  No function is
# longer than 45 lines, its head included.  Nothing else stands in the top
# folder.
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
for file in src/*/*.[ch] src/*/*/*.[ch] include/overroll/*.h \
    tests/*/*.[ch] tests/*/*.sh tests/support/run \
    tools/* tools/examples/* .ci/run Makefile \
    tests/python/*.py tests/bench/*.py tests/verify/*.py tools/python/*.py \
    tools/python/*/*.py; do
    [ -f "$file" ] || continue
    head -n 2 "$file" | grep -q 'SPDX-License-Identifier: GPL-3.0-or-later' || {
        echo "$file: no SPDX line"
        status=1
    }
    [ "$file" != Makefile ] || continue
    # Bytes beyond ASCII make a line longer than it looks: awk counts bytes.
    awk -v file="$file" '
        { gsub(/[\200-\277]/, "") }
        length > 80 { print file ":" NR ": wider than 80"; bad = 1 }
        /\t/        { print file ":" NR ": a tab"; bad = 1 }
        / $/        { print file ":" NR ": blanks at the end"; bad = 1 }
        file !~ /\.c$/ { next }
        /^[A-Za-z_]/ { head = NR; name = $0 }
        /^\{/       { open = head }
        /^}/ && open {
            if (NR - open > 44) {
                print file ":" open ": longer than 45 lines: " name
                bad = 1
            }
            open = 0
        }
        END { exit bad }' "$file" || status=1
done
exit $status
