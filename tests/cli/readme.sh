#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck disable=SC2013,SC2016 # names without blanks; no expansion wanted
#
# The tour of README.md works as it stands there, and its links lead
# somewhere.
. "$TOP/tests/support/cli.sh"
need gnuplot

sed -n '/^```sh$/,/^```$/p' "$TOP/README.md" | grep -v '^```' >tour
[ "$(grep -c '^overroll' tour)" -ge 9 ] || fail "$(cat tour)"
# From line one, in a folder set up by tools/demo.
mkdir -p here/build made
ln -s "$OVERROLL" here/build/overroll
cp tour here
cd here || exit 1
PATH=/usr/local/bin:/usr/bin:/bin
TMPDIR=$OLDPWD/made expect 0 env -u TOP sh -eu tour
[ "$(ls)" = "$(printf 'build\nerr\nout\ntour')" ] ||
    fail "the tour leaves here: $(ls)"
cd "$OLDPWD"/made/* || exit 1
for file in roller.ini roller.h5 roller.png roller.html study/manifest.csv \
    study.svg study.nc; do
    [ -s $file ] || fail "the tour makes no $file"
done
[ "$(grep -c ,finished, study/manifest.csv)" -eq 8 ] ||
    fail "$(cat study/manifest.csv)"

# overroll-reading(7) shows the table of this study.
if (need_python xarray netCDF4 pandas); then
    need_python xarray netCDF4 pandas
    sed -n '/^\.\\" study$/,/^\.EE/p' "$TOP/src/results/overroll-reading.7" |
        grep -v '^\.' >read.py
    expect 0 "$PYTHON" read.py
    contains out 'depth +load +H_min_overall +P_max_overall'
    contains out '^8 +4\.0+e-07 +300000\.0 '
fi

for link in $(sed -n 's/.*](\([^):#]*\)).*/\1/p' "$TOP/README.md" \
    "$TOP/CHANGELOG.md" | sort -u); do
    [ -e "$TOP/$link" ] || fail "README.md leads to $link, which is not there"
done
(
    cd "$TOP/tools/validation" || exit 1
    for link in $(sed -n 's/.*](\([^):#]*\)).*/\1/p' proofs.md | sort -u); do
        [ -e "$link" ] || echo "$link"
    done
) >missing
[ ! -s missing ] || fail "proofs.md names what is not there: $(cat missing)"
[ "$(wc -l <"$TOP/README.md")" -le 150 ] || fail 'README.md is too long'
sed -n 1,14p "$TOP/README.md" | grep -q Venner || fail 'the paper is not named'
