#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A run remains in its steady start until load, speed or radius change or a
# feature arrives. A wave of small amplitude at T = 0 changes the central film
# thickness in proportion to its amplitude, so that the mean of the runs with a
# crest and with a trough at the same place is that of smooth surfaces.
. "$TOP/tests/support/cli.sh"

smooth='[contact]
M = 200
L = 10
[domain]
level = 7
[time]
end = 1'

# steady NAME LIMIT: H_cen and H_min change by less than LIMIT
steady() {
    expect 0 "$OVERROLL" run case.ini -q -o case.h5 --force
    "$OVERROLL" export case.h5 | awk -F, -v limit="$2" '
        NR == 1 { for (i = 1; i <= NF; i++) {
            name = $i
            sub(" .*", "", name)
            at[name] = i }
            c = at["central_film_thickness"]
            m = at["min_film_thickness"] }
        NR == 2 { cen = $c; low = $m }
        NR > 2 { a = $c / cen - 1; b = $m / low - 1
            if (a * a > most * most) most = a
            if (b * b > most * most) most = b }
        END { print most
            exit !(NR > 100 && most * most < limit * limit) }' >off ||
        fail "$1 moves by itself: $(cat off)"
}

for what in load speed radius; do
    for model in reynolds conserving; do
        { echo "$smooth" && printf '[cavitation]\nmodel = %s\n' $model &&
            printf '[%s]\nhistory = ramp\nto = 1.3\nstart = 1.2\n' $what &&
            printf 'duration = 1\n'; } >case.ini
        steady "$what, $model" 1e-8
    done
done
{ echo "$smooth" && printf '[feature dent]\nshape = dent\ndepth = 0.0012\n' &&
    printf 'width = 0.5\nstart = inlet\n'; } >case.ini
steady 'a dent at the inlet' 1e-6
# A load that changes by 0.1 % is noticed.
{ echo "$smooth" && printf '[load]\nhistory = ramp\nto = 1.001\n' &&
    printf 'start = 0.5\nduration = 0.4\n'; } >case.ini
(steady 'a load that changes' 1e-4) >shown && fail 'no change is measured'

for origin in 0 0.25; do
    { echo "$smooth" && printf '[feature wave]\nshape = wave\n' &&
        printf 'amplitude = 3e-5\nwavelength = 0.5\norigin = %s\n' $origin; } \
        >case.ini
    expect 0 "$OVERROLL" run case.ini -q -o case.h5 --force
    "$OVERROLL" export case.h5 | awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++)
                      if ($i ~ /^central_film_thickness/) c = i }
        NR > 1 { print $c }' >wave.$origin
done
expect 0 "$OVERROLL" steady --M 200 --L 10 --level 7 --json
number H_cen >smooth
paste -d' ' wave.0 wave.0.25 | awk 'NR == 1 { getline H <"smooth" }
    { mean = ($1 + $2) / 2 / H - 1
    if (mean * mean > most * most) most = mean
    wave = ($1 - $2) / 2 / H
    if (wave * wave > wide * wide) wide = wave }
    END { print most, wide
        exit !(NR > 100 && wide * wide > 1e-7 && most * most < 4e-10) }' >off ||
    fail "the mean of waves moves by itself: $(cat off)"
