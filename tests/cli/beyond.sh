#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Results outside the validity of a model are reported on stderr, in --json and
# in the file.
. "$TOP/tests/support/cli.sh"

sized_dent_case 4 7 0.2 0.5 -4.6 >dent.ini

says() { # PATTERN SETTING...: run and check say it, the file holds it
    pattern=$1
    shift
    settings=
    for setting; do settings="$settings --set $setting"; done
    # shellcheck disable=SC2086 # settings are words
    expect 0 "$OVERROLL" run dent.ini $settings --json
    contains out "^  \"warnings\": \[.*$pattern"
    contains err "warning: .*$pattern"
}

# An ordinary material history: nothing to say
expect 0 "$OVERROLL" run dent.ini --json
contains out '"warnings": \[ \]'
contains out '"lambda_ratio": null'

says 'exceeds bearable_pressure = 1.1 GPa' \
    'contact.bearable_pressure=1.1GPa'
contains out 'the pressure of 1\.[1-9][0-9]* GPa at X = .*, T = '
expect 0 "$OVERROLL" check dent.ini -v
contains out '^bearable_pressure = 4 GPa +# default'

says "feature 'dent' .*never reaches" 'feature.dent.start=-50'
says "feature 'dent' has not left" 'time.end=4'
says 'shorter than one step' 'time.end=0.01'
says 'slide_to_roll 3 is beyond' 'contact.slide_to_roll=3' 'time.end=20'

# A thin film under a load that swings hard takes many cycles
says '[0-9]+ cycles for [0-9]+ time steps .3 per step are usual' \
    'contact.M=600' 'contact.L=3' 'load.history=sine' 'load.amplitude=0.95' \
    'load.period=1' 'time.end=0.15' 'domain.level=6' 'domain.outlet=1.5' \
    'feature.dent.depth=0.01'

# Rough: the ratio of film to roughness by hand
cat >rough.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[feature one]
shape = wave
amplitude = 0.01
wavelength = 1
[feature other]
surface = 2
shape = wave
amplitude = 0.02
wavelength = 1
END
expect 0 "$OVERROLL" steady rough.ini --json
awk '/^  "H_mean":/ { H = $2 + 0 } /"lambda_ratio":/ { r = $2 + 0 }
    END { d = r*sqrt((0.01*0.01 + 0.02*0.02)/2)/H - 1
        exit !(H > 0 && d < 1e-12 && d > -1e-12) }' out || fail "$(cat out)"
expect 0 "$OVERROLL" steady rough.ini
contains out '^(mean )?lambda ratio +[0-9.]+ '
# Of waves longer than the contact what is left in windows of 2 b:
# A^2/2 (1 - s^2), s = sin(2 pi/l)/(2 pi/l)
expect 0 "$OVERROLL" steady rough.ini --json --set feature.one.wavelength=4 \
    --set feature.other.wavelength=5
awk 'function left(A, l, a) { a = 6.283185307179586/l
        return A*A/2*(1 - (sin(a)/a)^2) }
    /^  "H_mean":/ { H = $2 + 0 } /"lambda_ratio":/ { r = $2 + 0 }
    END { d = r*sqrt(left(0.01, 4) + left(0.02, 5))/H - 1
        exit !(H > 0 && d < 1e-12 && d > -1e-12) }' out || fail "$(cat out)"
# A column of the history, and its smallest value over the run
expect 0 "$OVERROLL" run rough.ini --json --set time.end=0.5 -o rough.h5
[ "$("$OVERROLL" export rough.h5 | awk -F, 'NR == 1 {
    for (i = 1; i <= NF; i++) { if ($i ~ /^lambda_ratio/) l = i
        if ($i ~ /^mean_film_thickness/) h = i }
    next } { if (least == "" || $l < least) least = $l
        if (NR > 2 && ($l/$h/first - 1)^2 > 1e-20) bad = 1
        if (NR == 2) first = $l/$h }
    END { printf "%.12g %d", least, bad }')" = "$(awk \
    '/"lambda_ratio_min":/ { printf "%.12g 0", $2 + 0 }' out)" ] ||
    fail "$(grep lambda_ratio out)"
expect 0 "$OVERROLL" steady rough.ini --set 'feature.one.amplitude=0.09' \
    --set feature.other.amplitude=0.08 --set feature.other.origin=0.5
contains err 'is below the composite roughness Rq = [0-9.e-]* b.2/R'

# All warnings are shown, a fifth as well
for k in 1 2 3 4 5 6 7; do
    printf '[feature f%d]\nshape = bump\nheight = 0.01\nwidth = 1\n' $k
    echo 'start = -60'
done >>dent.ini
expect 0 "$OVERROLL" run dent.ini -o a.h5 --json
[ "$(grep -o 'never reaches' out | wc -l)" -eq 7 ] || fail "$(cat out)"
expect 0 "$OVERROLL" check dent.ini --json
[ "$(grep -o 'never reaches' out | wc -l)" -eq 7 ] || fail "$(cat out)"
need ncdump
expect 0 ncdump -h a.h5
[ "$(grep -o 'never reaches' out | wc -l)" -eq 7 ] || fail "$(cat out)"
contains out 'warnings = .*f1.*never reaches'
