#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The examples of overroll-reading(7) that can be run give correct results.
. "$TOP/tests/support/cli.sh"
need_python h5py xarray netCDF4 pandas
need ncdump

# snippets KIND: those of the page, one after the other.
snippets() {
    sed -n "/^\\.\\\\\" $1\$/,/^\\.EE/p" "$TOP/src/results/overroll-reading.7" |
        grep -v '^\.' | sed 's/\\-/-/g; s/\\e/\\/g'
}

sized_dent_case 4 0.5 0.1 1 -4.9 >dent.ini
expect 0 "$OVERROLL" run dent.ini -o dent.h5
snippets python >read.py
[ "$(grep -c '^import' read.py)" -eq 3 ] || fail "$(cat read.py)"
expect 0 "$PYTHON" read.py
contains out 'film_thickness +\(time, x\)'
contains out ' m at x = 0.0'
contains out 'status: complete'
contains out '^\[contact\]'
contains out '^\(2, '
if "$PYTHON" -c 'import dask' 2>/dev/null; then
    cp dent.h5 thin.h5
    cp dent.h5 thick.h5
    snippets together >read.py
    expect 0 "$PYTHON" read.py
    contains out "^\('case', 'time', 'x'\)"
fi

printf '0 1\n1 1.1\n' >load.txt
{ cat dent.ini && printf '[load]\nhistory = table\nfile = load.txt\n'
} >load.ini
expect 0 "$OVERROLL" run load.ini -o rough.h5
{ snippets inputs && printf 'open("copy", "wb").write(data)\n'; } >read.py
expect 0 "$PYTHON" read.py
contains out "^load.file load.txt $(sha256sum load.txt | cut -d ' ' -f 1)"
cmp load.txt copy || fail 'the bytes are others'

mkdir bin
ln -s "$OVERROLL" bin/overroll
PATH=$PWD/bin:$PATH
snippets shell >read.sh
[ "$(wc -l <read.sh)" -eq 3 ] || fail "$(cat read.sh)"
expect 0 sh -e read.sh
contains out 'double pressure\(time, x\)'
[ -s all.csv ] || fail 'nothing exported'

command -v octave-cli >/dev/null || { echo 'no octave'; exit 0; }
octave-cli --eval 'pkg load netcdf' >/dev/null 2>&1 ||
    { echo 'no octave-netcdf'; exit 0; }
snippets octave >read.m
[ "$(grep -c ncread read.m)" -eq 5 ] || fail "$(cat read.m)"
expect 0 octave-cli --norc --eval \
    "set(0, 'defaultfigurevisible', 'off'); source('read.m')"
contains out '^[0-9]+ times, minimum film thickness [0-9.]+e-0'
"$PYTHON" - <<'END' || fail "$(cat out)"
import h5py
f = h5py.File("dent.h5")
words = open("out").read().split()
assert int(words[0]) == len(f["time"])
least = f["history/min_film_thickness"][...].min()
assert abs(float(words[5]) - least) < 1e-5 * least
END
