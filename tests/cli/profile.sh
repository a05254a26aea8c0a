#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# profile: what is understood, what is asked for, conversion, picture, case.
. "$TOP/tests/support/cli.sh"

dent=$TOP/profiles/dent.csv

# What was understood, and numbers
expect 0 "$OVERROLL" profile "$dent"
contains out '^understood column 1 is x, column 2 is z, of 2'
contains out 'x in um \(header: "X_\(microns\)"\)'
contains out 'levelled: line'
contains out '^points +641, from x = 0 m to 0\.32 mm'
for number in Ra Rq Rz Rsk Rku Rdq; do
    contains out "^$number  *-?[0-9]"
done
contains out '^waves'

expect 0 "$OVERROLL" profile "$dent" --json
for key in file format understood points missing filled uniform length_m \
    spacing_m Ra_m Rq_m Rz_m Rsk Rku Rdq waves; do
    contains out "^ *\"$key\": "
done

# In the contact of a case: b is 186 um
expect 0 "$OVERROLL" profile "$dent" --case "$TOP/profiles/dent.ini"
contains out '130\.1|0\.1301 mm .* 0\.[67][0-9]* .* \(x 0\.[67]'
printf '[contact]\nM = 20\nL = 10\n' >bare.ini
refuses 'radius and modulus' profile "$dent" --case bare.ini

# What a file does not say is asked for
printf '0.5,1\n1.5,2\n2.5,4\n' >bare.csv
refuses 'set unit_x' profile bare.csv
refuses 'set unit_z' profile bare.csv --unit-x um
refuses 'parsec' profile bare.csv --unit-x parsec --unit-z um
expect 0 "$OVERROLL" profile bare.csv --unit-x um --unit-z nm
contains out 'x in um \(unit_x\)'
printf '1\n2\n4\n' >single.txt
refuses 'spacing' profile single.txt --unit-z nm
refuses "like '12 um'" profile single.txt --unit-z nm --spacing wide
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
contains out 'lambda_c = 8e-05'

# Mistakes
refuses 'absent' profile absent.csv
refuses 'level' profile "$dent" --level up
refuses 'lambda_c' profile "$dent" --lambda-c '-1 um'
refuses 'line' profile "$dent" --line x
refuses 'column_x' profile "$dent" --column-x 9
refuses 'window' profile "$dent" --from '1 m'
refuses 'no/such' profile "$dent" --convert no/such/folder.csv
refuses 'empty' profile /dev/null

# A name cannot become a command
need gnuplot
name="it's \`touch hacked\`.csv"
cp "$dent" "$name"
expect 0 "$OVERROLL" profile "$name" --plot "p'\`touch hacked\`.png"
[ -s "p'\`touch hacked\`.png" ] || fail 'no picture'
[ ! -e hacked ] || fail 'a file name was run as a command'
