#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The recipes of overroll-recipes(7), in order, on coarser grids: each succeeds
# without an error message.
. "$TOP/tests/support/cli.sh"
need gnuplot

mkdir bin
cat >bin/overroll <<END
#!/bin/sh
case \$1 in
run | find) exec "$OVERROLL" "\$@" --level 5 ;;
esac
exec "$OVERROLL" "\$@"
END
chmod +x bin/overroll
PATH=$PWD/bin:$PATH

sed -n '/^\.\\" recipe$/,/^\.EE/p' "$TOP/src/cli/overroll-recipes.7" |
    grep -v '^\.' | sed 's/\\-/-/g; s/\\e$/\\/' >recipes
[ "$(grep -c '^overroll ' recipes)" -ge 20 ] || fail "$(cat recipes)"
expect 0 sh -e recipes
contains out '^lubricant.iso_vg = '
contains out '^feature.dent.depth = '
for file in speed.svg dent.png dent.html centre.csv history.csv traction.svg \
    stribeck.png trace.h5 gear.png; do
    [ -s "$file" ] || fail "no $file"
done
