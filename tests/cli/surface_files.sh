#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Surface files written by Python (surface_files.py), independently of the
# readers: every format and dialect gives the written heights, and lines of
# maps are those selected by NumPy. Messages name other formats.
. "$TOP/tests/support/cli.sh"

need_python numpy zlib
"$PYTHON" "$TOP/tests/cli/surface_files.py" "$OVERROLL" || fail "see above"

# Formats that are not read are named, with a remedy
printf 'PK\003\004' >a.xlsx
refuses 'Excel workbook.*CSV' profile a.xlsx
printf '\320\317\021\340' >a.xls
refuses 'Excel workbook.*CSV' profile a.xls
printf '\001\000Directory' >a.opd
refuses 'Wyko.*export it as X3P' profile a.opd
printf 'AliconaImaging\000' >a.al3d
refuses 'Alicona.*export it as X3P' profile a.al3d
printf 'a\000b' >a.mnt
refuses 'MountainsMap.*export it as X3P' profile a.mnt
printf 'a\000b' >a.plu
refuses 'Sensofar.*export it as X3P' profile a.plu
printf 'aISO-9.0\nNumPoints = 2\n*\n1 2\n*\n' >a.sdf
refuses "dialect 'aISO-9.0' is not supported" profile a.sdf
printf 'bBCR-3.0xxxxxxxxxxxxxxxx' >b.sdf
refuses "dialect 'bBCR-3.0" profile b.sdf

# Text: quoted numbers, with decimal commas too; a column of validity
printf '"Position (mm)","Height (um)"\n"0.000","0.1"\n"0.001","0.3"\n' >q.csv
expect 0 "$OVERROLL" profile q.csv --level none --convert q.out
contains q.out 'e-0[67], (3|2\.99+[0-9]*)e-07$'
printf '"x (mm)","z (um)"\n"0,000","0,1"\n"0,001","0,3"\n' >qc.csv
expect 0 "$OVERROLL" profile qc.csv
contains out '^length +1 um'
{
    printf 'X;Z;valid\n[mm];[um];[1/0]\n'
    for k in 0 1 2 3 4 5 6 7 8 9; do
        [ $k -ne 4 ] && echo "0,00$k;$((k % 3));1" || echo "0,004;77;0"
    done
} >v.csv
expect 0 "$OVERROLL" profile v.csv --max-gap 2um
contains out '^missing heights +1 +.filled: 1.'

# Signs of missing heights, in words and in codes of instruments
for sign in '#N/A' '-nan(ind)' '1.#QNAN' '*****' '--' '' -9999 1e30 -32768; do
    {
        echo 'x um,z um'
        for k in 0 1 2 3 4 5 6 7 8 9; do
            [ $k -ne 4 ] && echo "$k,0.$((k % 3))" || echo "$k,$sign"
        done
    } >m.csv
    expect 0 "$OVERROLL" profile m.csv --max-gap 2um
    contains out '^missing heights +1 +.filled: 1.'
done
contains out '1 heights of -32768, far from all others'
# Not a code among heights of its size; not a comment at the start of a row
printf 'x um,z nm\n0,-9000\n1,-9999\n2,-8000\n3,-12000\n' >m.csv
expect 0 "$OVERROLL" profile m.csv
contains out '^missing heights +0 '
printf 'z um\n1\n2\n#N/A\n1\n2\n1\n2\n' >m.csv
expect 0 "$OVERROLL" profile m.csv --spacing 1um --max-gap 2um
contains out '^points +7,'

# Sizes that no roughness has are questioned
printf 'x m,z um\n0,1\n0.2,2\n0.4,1\n' >m.csv
expect 0 "$OVERROLL" profile m.csv
contains out 'warning: a length of 0\.4 m'
printf 'x mm,z mm\n0,1\n1,3\n2,1\n' >m.csv
expect 0 "$OVERROLL" profile m.csv
contains out 'warning: heights above 2 mm'
expect 0 "$OVERROLL" profile "$TOP/profiles/dent.csv"
! grep -q warning out || fail "a warning about a dent: $(cat out)"

# A flat profile: no rounding is printed as a height, no negative Rk
printf 'x um,z um\n0,0.1\n1,0.1\n2,0.1\n3,0.1\n' >m.csv
expect 0 "$OVERROLL" profile m.csv
contains out '^core height Pk +0 m'
! grep -Eq '^P[a-z]+ +-?[0-9.]+e-' out || fail "rounding: $(cat out)"

# What lines cannot be chosen
printf 'x um,z um\n0,1\n1,2\n2,1\n' >m.csv
refuses 'row: the file contains line 1 only' profile m.csv --row 2
refuses 'direction: the file contains line 1 only' profile m.csv --direction 10
