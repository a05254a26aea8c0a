#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck disable=SC2013,SC2016 # names without blanks; no expansion wanted
#
# The tour of README.md works as it stands there, and its links lead
# somewhere.
. "$TOP/tests/support/cli.sh"
need gnuplot

blocks='sh'
command -v ffmpeg >/dev/null && blocks='sh\( ffmpeg\)*'
sed -n "/^\`\`\`$blocks\$/,/^\`\`\`\$/p" "$TOP/README.md" | grep -v '^```' >tour
[ "$(grep -c '^overroll' tour)" -ge 10 ] || fail "$(cat tour)"
# From line one, in a folder set up by tools/demo.
mkdir -p here/build made
ln -s "$TOP/profiles" here/profiles
ln -s "$OVERROLL" here/build/overroll
cp tour here
cd here || exit 1
PATH=/usr/local/bin:/usr/bin:/bin
TMPDIR=$OLDPWD/made expect 0 env -u TOP sh -eu tour
[ "$(ls)" = "$(printf 'build\nerr\nout\nprofiles\ntour')" ] ||
    fail "the tour leaves here: $(ls)"
cd "$OLDPWD"/made/* || exit 1
for file in roller.ini roller.h5 roller.png mine.h5 mine.html \
    study/manifest.csv study.svg study.nc; do
    [ -s $file ] || fail "the tour makes no $file"
done
[ "$blocks" = sh ] || [ -s mine.gif ] || fail 'the tour makes no mine.gif'
[ "$(grep -c ,finished, study/manifest.csv)" -eq 8 ] ||
    fail "$(cat study/manifest.csv)"

# overroll-reading(7) shows the table of this study.
if (need_python xarray netCDF4 pandas); then
    need_python xarray netCDF4 pandas
    sed -n '/^\.\\" study$/,/^\.EE/p' "$TOP/src/results/overroll-reading.7" |
        grep -v '^\.' >read.py
    expect 0 "$PYTHON" read.py
    contains out 'scale +speed_2 +H_min_overall +P_max_overall'
    contains out '^8 +0\.4 +3\.2 '
fi

for link in $(sed -n 's/.*](\([^):#]*\)).*/\1/p' "$TOP/README.md" \
    "$TOP/CHANGELOG.md" | sort -u); do
    [ -e "$TOP/$link" ] || fail "README.md leads to $link, which is not there"
done
for script in $(sed -n 's/^| `\([a-z-]*\)` |.*/\1/p' "$TOP/README.md"); do
    [ -x "$TOP/tools/examples/$script" ] || fail "no example $script"
done
