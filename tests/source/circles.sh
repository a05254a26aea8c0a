#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Inside these floors no two files call each other, by however many steps: of
# objects and the symbols that they define and want, tsort finds an order.
. "$TOP/tests/support/cli.sh"
command -v nm >/dev/null || skip 'no nm'
for floor in base mathematics contact surface multigrid strip stress \
    simulation results case elements run pictures cli; do
    for file in "$TOP/src/$floor"/*.c; do
        name=$(basename "$file" .c)
        [ -e "$BUILD/src/$floor/$name.o" ] || continue # a kernel
        nm "$BUILD/src/$floor/$name.o" | sed -n \
            -e "s|^[0-9a-f]* [TDRBV] \(.*\)|\1 defined $name|p" \
            -e "s|^ *U \(.*\)|\1 wanted $name|p"
    done | awk -v floor="$floor" '
        $2 == "defined" { home[$1] = $3 }
        $2 == "wanted" { n++; name[n] = $1; by[n] = $3 }
        END {
            for (k = 1; k <= n; k++)
                if (name[k] in home && home[name[k]] != by[k])
                    print by[k], home[name[k]]
        }' >calls
    [ -s calls ] || fail "$floor: nothing calls anything"
    tsort calls >/dev/null 2>loop || fail "$floor goes in circles: $(cat loop)"
done
