#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Steps of two mesh sizes of a contact whose pressure spike is two mesh sizes
# wide: the steady film stays as it is, failed steps are halved instead of
# solved at second order, and the film equals that of steps of one mesh size.
. "$TOP/tests/support/cli.sh"

cat >contact.ini <<'END'
[contact]
hertz_pressure = 1.4832 GPa
radius = 6.6363 mm
modulus = 226 GPa
mean_speed = 6.7832 m/s
slide_to_roll = 0
[lubricant]
viscosity = 12.457 mPa.s
alpha = 22.915 1/GPa
rheology = eyring
eyring_stress = 7.407 MPa
[domain]
level = 7
END

# column NAME FILE: of the history of a result file.
column() {
    "$OVERROLL" export "$2" | awk -F, -v name="$1" '
        NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ "^" name "( |$)") c = k }
        NR > 1 { print $c }'
}

# The dent is 2 b upstream of the domain's end.
cat contact.ini - >dent.ini <<'END'
[feature f]
shape = dent
depth = 2.3 um
width = 0.8
start = -6
[time]
step = auto
end = 1
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 --json -q
[ "$(number steps)" -eq 82 ] || fail "$(number steps) steps of two mesh sizes"
[ "$(number retries)" -eq 0 ] || fail "$(number retries) steps are repeated"
for key in central_film_thickness min_film_thickness; do
    column $key dent.h5 | awk 'NR == 1 { a = $1 }
        { d = $1 / a - 1; if (d < -1e-5 || d > 1e-5) bad = d }
        END { if (bad) print bad; exit bad != 0 }' ||
        fail "$key of the steady film changes"
done

cat contact.ini - >wave.ini <<'END'
[feature f]
shape = wave
amplitude = 0.1526 um
wavelength = 1.2
grow = 1
[time]
end = 3
[output]
every = 100
checkpoint = 10 ms
END
expect 0 "$OVERROLL" run wave.ini -o grid.h5 --set time.step=grid -q
expect 0 "$OVERROLL" run wave.ini -o auto.h5 --json -q
[ "$(number substeps)" -gt 100 ] || fail "$(number substeps) steps are halved"
[ "$(number retries)" -lt 40 ] || fail "$(number retries) repeated attempts"
uncorrected=$(column order auto.h5 | grep -c '^2')
[ "$uncorrected" -eq "$(number steps_uncorrected)" ] ||
    fail "$uncorrected steps are stored with order 2"
[ "$uncorrected" -lt 4 ] || fail "$uncorrected steps are of order 2"
column central_film_thickness grid.h5 | awk 'NR % 2' >grid.txt
column central_film_thickness auto.h5 >auto.txt
paste auto.txt grid.txt | awk 'NF == 2 { d = $1 / $2 - 1; s += d * d; n++ }
    END { print sqrt(s / n); exit !(n > 200 && sqrt(s / n) < 5e-5) }' >rms ||
    fail "H_cen differs from that of steps of one mesh size by $(cat rms)"

# The halved steps of a resumed run are the same.
"$OVERROLL" run wave.ini -o part.h5 -q &
pid=$!
tries=0
while { [ ! -e part.h5 ] || [ ! -e part.h5.restart ]; } &&
    [ "$tries" -lt 500 ]; do
    sleep 0.01
    tries=$((tries + 1))
done
kill -9 "$pid" 2>/dev/null || :
wait "$pid" 2>/dev/null || :
expect 0 "$OVERROLL" resume part.h5 -q
content auto.h5 >1.txt
content part.h5 >2.txt
cmp 1.txt 2.txt || fail 'a resumed run has other numbers'
