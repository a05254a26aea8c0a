#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The snippets of overroll-reading(7) that can be run do what they say.
. "$TOP/tests/support/cli.sh"
need_python h5py xarray netCDF4 pandas
need ncdump

# snippets KIND: those of the page, one after the other.
snippets() {
    sed -n "/^\\.\\\\\" $1\$/,/^\\.EE/p" "$TOP/src/results/overroll-reading.7" |
        grep -v '^\.' | sed 's/\\-/-/g'
}

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
radius = 10 mm
modulus = 226 GPa
viscosity = 40 mPa.s
[domain]
level = 4
[time]
end = 0.5
[feature dent]
shape = dent
depth = 0.1
width = 1
start = -4.9
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5
snippets python >read.py
[ "$(grep -c '^import' read.py)" -eq 2 ] || fail "$(cat read.py)"
expect 0 "$PYTHON" read.py
contains out 'film_thickness +\(time, x\)'
contains out ' m at x = 0.0'
contains out 'status: complete'
contains out '^\[contact\]'

mkdir bin
ln -s "$OVERROLL" bin/overroll
PATH=$PWD/bin:$PATH
snippets shell >read.sh
[ "$(wc -l <read.sh)" -eq 3 ] || fail "$(cat read.sh)"
expect 0 sh -e read.sh
contains out 'double pressure\(time, x\)'
[ -s all.csv ] || fail 'nothing exported'

printf '[study]\ncase = dent.ini\n[product]\n%s\n' \
    'feature.dent.depth = 0.05, 0.1' >study.ini
expect 0 "$OVERROLL" sweep study.ini
expect 0 "$OVERROLL" sweep study.ini --collect study.nc
snippets study >read.py
expect 0 "$PYTHON" read.py
contains out '^2 +.* 0\.0'
