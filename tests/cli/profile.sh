#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# profile: interpreted files, missing information, conversion, picture, case.
. "$TOP/tests/support/cli.sh"

dent=$TOP/profiles/dent.csv

# What was understood, and numbers
expect 0 "$OVERROLL" profile "$dent"
contains out '^interpretation +column 1 is x, column 2 is z, of 2'
contains out 'x in um \(header: "X_\(microns\)"\)'
contains out 'levelled: line'
contains out '^points +641, from x = 0 m to 0\.32 mm'
for number in Pa Pq Pz Pp Pv Psk Pku Pdq Pk Ppk Pvk; do
    contains out " $number  *-?[0-9]"
done
! grep -q ' R[aqz] ' out || fail 'R-parameters of what is not filtered'
contains out '^strongest waves'

expect 0 "$OVERROLL" profile "$dent" --json
for key in file format understood points missing filled uniform length_m \
    spacing_m Pa_m Pq_m Pz_m Psk Pku Pdq Ra_m Rz_m lambda_c_m \
    lambda_c_suggested_m sections waves; do
    contains out "^ *\"$key\": "
done
contains out '"Rz_m": null'
expect 0 "$OVERROLL" profile "$dent" --lambda-c '60 um'
for number in Pa Pz Ra Rq Rz Rt Rsk Rku Rdq Rk Rpk Rvk; do
    contains out " $number  *-?[0-9]"
done
contains out '^sections +5 of 60 um'

# What it bears, pressed dry
expect 0 "$OVERROLL" profile "$dent" --contact
contains out '^dry contact with a smooth surface'
contains out 'p/\(E\* slope\) +mean gap +contact fraction'
expect 0 "$OVERROLL" profile "$dent" --contact --json --case \
    "$TOP/profiles/dent.ini"
for key in pressure_over_E_star mean_gap_m area pressure_Pa; do
    contains out "^ *\"$key\": "
done
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" profile "$dent" --contact --plot bears.svg
    [ -s bears.svg ] || fail 'no picture of what it bears'
fi

# In the contact of a case: b is 186 um
expect 0 "$OVERROLL" profile "$dent" --case "$TOP/profiles/dent.ini"
contains out '130\.1|0\.1301 mm .* 0\.[67][0-9]* .* 0\.[67]'
printf '[contact]\nM = 20\nL = 10\n' >bare.ini
refuses 'contact.radius and contact.modulus' profile "$dent" --case bare.ini

# What a file does not say is asked for
printf '0.5,1\n1.5,2\n2.5,4\n' >bare.csv
refuses 'give --unit-x um, --unit-z um' profile bare.csv
refuses 'unit of z .* give --unit-z um' profile bare.csv --unit-x um
refuses "unknown unit 'parsec' of x" profile bare.csv --unit-x parsec \
    --unit-z um
{
    printf '[contact]\nload = 1 kN/m\nradius = 10 mm\nmodulus = 220 GPa\n'
    printf 'viscosity = 40 mPa.s\nspeed_1 = 1 m/s\nspeed_2 = 1 m/s\n'
    printf '[lubricant]\nalpha = 20 1/GPa\n'
    printf '[feature s]\nshape = profile\nfile = bare.csv\nstart = 0\n'
} >keys.ini
refuses 'give unit_x = um, unit_z = um' check keys.ini
expect 0 "$OVERROLL" profile bare.csv --unit-x um --unit-z nm
contains out 'x in um \(--unit-x\)'
printf '1\n2\n4\n' >single.txt
refuses "give --spacing '0.5 um', --unit-z um" profile single.txt
refuses "such as '12 um'" profile single.txt --unit-z nm --spacing wide
expect 0 "$OVERROLL" profile single.txt --unit-z nm --spacing '2 um'
contains out 'spacing +2 um'
expect 0 "$OVERROLL" profile single.txt --unit-z b^2/R --unit-x b --spacing 0.1
contains out '^length +0.2 b'

# Conversion reads back as the same; nothing is overwritten unasked
expect 0 "$OVERROLL" profile "$dent" --level none --convert a.csv
expect 0 "$OVERROLL" profile a.csv --level none --convert b.csv
cmp a.csv b.csv || fail 'converted twice is not the same'
refuses 'exists' profile "$dent" --convert a.csv
expect 0 "$OVERROLL" profile "$dent" --convert a.csv --force
gzip a.csv
expect 0 "$OVERROLL" profile a.csv.gz --lambda-c '80 um' --lambda-s '2.5 um'
contains out 'lambda_c = 80 um'
contains out 'lambda_s = 2.5 um'

# A length without its unit is none: not metres in silence
for option in spacing from to lambda-c lambda-s max-gap offset; do
    refuses "--$option 0.8: needs a unit, such as '0.8 mm'" \
        profile "$dent" --$option 0.8
    refuses "--$option 8 furlong: unknown unit 'furlong'" \
        profile "$dent" --$option '8 furlong'
done
refuses 'the profile is in metres' profile "$dent" --from '0.1 b'
expect 0 "$OVERROLL" profile "$dent" --lambda-c '0.4 b' \
    --case "$TOP/profiles/dent.ini"
contains out 'lambda_c = 74\.[0-9]* um'

# The cut-off for a length of 4 mm; the radius of an arc on it
awk 'BEGIN { print "x mm, z um"
    for (i = 0; i <= 4000; i++)
        printf "%.17g, %.17g\n", i / 1e3,
            -(i - 2000) ^ 2 / 2e4 + sin(i / 10) }' >arc.csv
expect 0 "$OVERROLL" profile arc.csv
contains out "lambda-c '0.8 mm'"
expect 0 "$OVERROLL" profile arc.csv --level auto
contains out 'auto.: circle of radius 10(\.[0-9]*)? mm, a crown'
expect 0 "$OVERROLL" profile arc.csv --level circle --json
contains out '"lambda_c_suggested_m": 0\.0008'
contains out 'circle of radius 10(\.[0-9]*)? mm'

# Mistakes
refuses 'absent' profile absent.csv
refuses 'level' profile "$dent" --level up
refuses 'lambda-c = -1 um must be' profile "$dent" --lambda-c '-1 um'
refuses 'line' profile "$dent" --line x
refuses '--column-x = 9' profile "$dent" --column-x 9
refuses 'from 1 m to its end .* extends from 0 m to 0.32 mm' profile "$dent" \
    --from '1 m'
refuses 'no/such' profile "$dent" --convert no/such/folder.csv
refuses 'empty' profile /dev/null

# A name cannot become a command
need gnuplot
name="it's \`touch hacked\`.csv"
cp "$dent" "$name"
expect 0 "$OVERROLL" profile "$name" --plot "p'\`touch hacked\`.png"
[ -s "p'\`touch hacked\`.png" ] || fail 'no picture'
[ ! -e hacked ] || fail 'a file name was run as a command'
