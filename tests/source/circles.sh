#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# No two folders of src call each other, directly or indirectly: tsort orders
# the folders by the symbols that their objects define and use. Files of one
# folder may call each other. LAYER_NAME.c in the folder of a subject
# (layers.sh) counts as part of that layer. The list of physical models, through
# which lower layers call them, is omitted.
. "$TOP/tests/support/cli.sh"
command -v nm >/dev/null || skip 'no nm'
# Of a kernel compiled for several instruction sets one object is enough.
cd "$BUILD" || exit 1
for file in src/*/*.o src/*/*/*.o; do
    source=$TOP/${file%.o}
    case $file in *.avx2.o | *.avx512.o) continue ;; esac
    [ -e "$source.c" ] || [ -e "${source%.base}.kernel.c" ] || continue
    echo "$file"
done | xargs nm -A | sed -n -E \
    -e 's#^src/(elements|physics/[a-z]+)/(case|run|pictures)_#src/\2/#' \
    -e 's#^(.*)/[^/]*:[0-9a-f]* [TDRBV] (.*)#\2 defined \1#p' \
    -e 's#^(.*)/[^/]*: *U (.*)#\2 used \1#p' >"$OLDPWD/symbols"
cd "$OLDPWD" || exit 1
awk '
    $1 == "ovr_physics_list" { next }
    $2 == "defined" { home[$1] = $3 }
    $2 == "used" { n++; name[n] = $1; by[n] = $3 }
    END {
        for (k = 1; k <= n; k++)
            if (name[k] in home && home[name[k]] != by[k])
                print by[k], home[name[k]]
    }' symbols | sort -u >calls
[ "$(wc -l <calls)" -gt 20 ] || fail "hardly a folder calls another"
tsort calls >/dev/null 2>loop || fail "folders go in circles: $(cat loop)"
