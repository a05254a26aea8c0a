#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A result or page with the suffix of another kind of file is rejected;
# warnings about omitted models name the active ones.
. "$TOP/tests/support/cli.sh"

dent_case 5 1 0.02 0.5 -4.6 >dent.ini
for name in R.csv R.png R.html R.ini; do
    refuses 'a result is an HDF5 file' run dent.ini -o $name
    [ ! -e $name ] || fail "$name was written"
done
expect 0 "$OVERROLL" run dent.ini -o R.nc -q
refuses 'must be an HTML page' view R.nc -o P.png
expect 0 "$OVERROLL" view R.nc -o P.html

# ... and a table, a case, a script or a folder under that of a result
refuses 'the output is a table, not a .h5 file; use NAME.csv' \
    export R.nc -o e.h5
for name in e.png e.html e.json e.ini; do
    refuses 'the output is a table, not' export R.nc -o $name
done
for name in e.csv e.txt e.dat e; do
    expect 0 "$OVERROLL" export R.nc -o $name
done
refuses 'the output is a case, not a .nc file' init roller -o i.nc
refuses 'the output is a gnuplot script' plot R.nc -o p.png --script p.csv
refuses 'the output is a folder, not a .h5 file' frames R.nc -o f.h5
set -- contact.M between 10 and 30 so that H_min is 0.1
refuses 'the output is a table, not a .nc file' find dent.ini "$@" \
    --table t.nc
refuses 'the output is a folder, not a .csv' find dent.ini "$@" \
    --results t.csv
for name in e.h5 i.nc f.h5 t.nc t.csv; do
    [ ! -e $name ] || fail "$name was written"
done

# steady names the moving feature that it leaves out
expect 0 "$OVERROLL" steady dent.ini
contains err "feature 'dent' moves and is left out of a steady solution"

# A limit of fatigue in Pa is far above p_h in a soft contact
cat >soft.ini <<'END'
[contact]
modulus = 10 MPa
hertz_pressure = 1 MPa
radius = 10 mm
mean_speed = 1 m/s
[lubricant]
viscosity = 20 mPa.s
viscosity_law = isoviscous
[domain]
level = 6
[stress]
surface = 1
[fatigue]
END
expect 0 "$OVERROLL" check soft.ini

# A table of a Carreau film rounded to four digits, Newtonian at low rates
cat >table.ini <<'END'
[contact]
load = 200 kN/m
radius = 10 mm
modulus = 226 GPa
viscosity = 50 mPa.s
alpha = 19 1/GPa
mean_speed = 3 m/s
slide_to_roll = 0.1
[lubricant]
rheology = table
rheology_file = thin.csv
END
{
    echo "rate [1/s], stress [MPa]"
    awk 'BEGIN { for (k = 0; k < 60; k++) {
        g = 1e3 * exp(0.3 * k)
        printf "%.4g, %.4g\n", g, 5e-5 * g / (1 + g / 1e6)^0.4 } }'
} >thin.csv
expect 0 "$OVERROLL" check table.ini
# thickening by a hundredth is refused
sed '6s/.*/3320, 0.168/' thin.csv >thick.csv
refuses 'only shear thinning is modelled' check table.ini \
    --set lubricant.rheology_file=thick.csv
