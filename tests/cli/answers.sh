#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Results for gears, cams and bearings at the end of a report: obtained by two
# commands, compared with the history and the drawing, and the same after a
# stop and resume, in text, JSON and on the page.
. "$TOP/tests/support/cli.sh"

# number KEY: that of the JSON in `out`.
number() {
    sed -n "s/^ *\"$1\": \\(.*[^,]\\),*\$/\\1/p" out
}

# Two commands: a drawing, and the answers.
expect 0 "$OVERROLL" init gear --set gear.teeth_1=25 --set gear.teeth_2=57 \
    --set gear.module=2.5mm --set gear.torque=60N.m --set gear.speed=2000rpm \
    --set domain.level=5 -o new.ini
expect 0 "$OVERROLL" run new.ini
contains out '^Machine element'
contains out '^gear pair +60 N.m at 2000 rpm: 12.57 kW; contact ratio 1\.6'
contains out '^friction power loss +[0-9.]+ W, mean over one .* efficiency 99'
contains out '^minimum film thickness +0\.[0-9]+ um [0-9.]+ mm (before|after) '
contains out 'lambda ratio at this position [0-9.]+, over the run [0-9.]+'
contains out '^maximum pressure +[0-9.]+ GPa '

# Steady, the film is that of the report.
expect 0 "$OVERROLL" steady new.ini
film=$(sed -n 's/^minimum film thickness .*(\([0-9.]* um\).*/\1/p' out)
[ -n "$film" ] || fail "no film: $(cat out)"
contains out "^minimum film thickness +$film"
contains out '^maximum pressure +[0-9.]+ GPa'

# ... and of a bearing too
expect 0 "$OVERROLL" init bearing --set domain.level=5 -o steady.ini
expect 0 "$OVERROLL" steady steady.ini
film=$(sed -n 's/^minimum film thickness .*(\([0-9.]* um\).*/\1/p' out)
pressure=$(sed -n 's/^maximum pressure .*(\([0-9.]* GPa\) .*/\1/p' out)
contains out '^bearing +[0-9]+ N at [0-9]+ rpm'
[ "$(grep -c "^minimum film thickness  *$film" out)" = 1 ] || fail "no $film"
[ "$(grep -c "^maximum pressure  *$pressure" out)" = 1 ] || fail "no $pressure"

cat >gear.ini <<'END'
[contact]
modulus = 226 GPa
[gear]
module = 3 mm
teeth_1 = 20
teeth_2 = 40
face = 20 mm
speed = 3000 rpm
torque = 100 N.m
[lubricant]
viscosity = 10 mPa.s
alpha = 16 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[domain]
inlet = -5
outlet = 1.6
level = 5
[feature ground]
surface = 1
shape = wave
amplitude = 0.02 um
wavelength = 1
grow = 1
[stress]
surface = both
END

# What one pair loses on its way, from the history, once in 1 ms: 20 teeth pass
# 50 times a second.  $1: face over the cosine of the base helix, mm.
check_loss() {
    expect 0 "$OVERROLL" run "$2" -o run.h5 --force --json -q
    cp out run.json
    expect 0 "$OVERROLL" export run.h5 --units si
    awk -F, -v told="$(sed -n 's/.*"power_loss_W": \(.*\),/\1/p' run.json)" \
        -v face="$1" '
        NR == 1 { for (i = 1; i <= NF; i++) {
            sub(" .*", "", $i); at[$i] = i }; next }
        NR == 2 { before = $at["time"]; next }
        { joule += $at["power_in"] * ($at["time"] - before)
          before = $at["time"] }
        END {
            watt = joule * face / 1e-3
            # The last step ends behind the way, which counts its mean.
            if (!(watt > 0) || (told - watt) ^ 2 > (3e-3 * watt) ^ 2) {
                print "power_loss_W", told, "by the history", watt
                exit 1
            } }' out || fail 'power_loss_W'
    cp run.json out
}
check_loss 20e-3 gear.ini
awk -v e="$(number efficiency)" -v w="$(number power_loss_W)" 'BEGIN {
    d = e - (1 - w / (100 * 3000 * atan2(0, -1) / 30))
    exit !(d * d < 1e-20) }' || fail "efficiency $(number efficiency)"
# Where the film is least: from A, at L - sqrt(ra2^2 - rb2^2), with w rb1.
awk -v at="$(number way_H_min_m)" -v t="$(number T_H_min_s)" 'BEGIN {
    pi = atan2(0, -1); a = 20 * pi / 180
    rb1 = 30 * cos(a); rb2 = 60 * cos(a); L = 90 * sin(a)
    A = L - sqrt(63 * 63 - rb2 * rb2)
    way = (A + 100 * pi * t * rb1 - rb1 * sin(a) / cos(a)) / 1e3
    exit !((at - way) ^ 2 < 1e-18) }' || fail "way $(number way_H_min_m)"
contains run.json '"contact_ratio": 1.63518596'
cp run.h5 whole.h5
cp run.json whole.json

# The film where it is least over the roughness: the snapshot of that moment.
# And what the file tells of the element: at the pitch point nothing slides.
for PYTHON in python3 /usr/bin/python3; do
    "$PYTHON" -c 'import h5py, numpy' 2>/dev/null || continue
    "$PYTHON" - whole.h5 "$(number lambda_ratio_at_H_min)" \
        "$(number T_H_min_s)" "$(number H_mean_m)" "$(number lambda_ratio)" \
        "$(number half_width_m)" <<'END' || fail 'lambda ratio or element'
import sys
import h5py
import numpy as np
file = h5py.File(sys.argv[1])
told, t, mean, ratio, b = (float(v) for v in sys.argv[2:])
k = np.argmin(abs(file["time"][:] - t))
assert abs(file["time"][k] - t) < 1e-5, (t, file["time"][k])
x, h = file["x"][:] / b, file["film_thickness"][k]
# |X| < 3/4 of the contact there, which is narrower than the nominal one
load = file["history/load_ratio"][:]
radius = file["history/radius_ratio"][:]
i = np.argmin(abs(file["history/time"][:] - t))
inner = 0.75 * min(1, np.sqrt(load[i] * radius[i]))
fine = np.linspace(-inner, inner, 20001)
there = np.mean(np.interp(fine, x, h))
assert abs(told * mean / ratio / there - 1) < 0.02, (told, mean, ratio, there)
e = {name: file["element"][name][:] for name in file["element"]}
assert abs(e["moment"][-1] / 1.635185963571e-3 - 1) < 1e-9
slides = e["speed_1"] - e["speed_2"]
assert abs(np.interp(0, e["path"], slides)) < 1e-9, "slides at the pitch point"
assert abs(np.interp(0, e["path"], e["radius"]) / 6.840402866e-3 - 1) < 1e-5
assert np.allclose(1 / e["radius"], 1 / e["radius_1"] + 1 / e["radius_2"],
                   rtol=1e-12)
END
    break
done

# By text, JSON and page the same; of a part of the way no loss.
expect 0 "$OVERROLL" view whole.h5 -o whole.html
expect 0 "$OVERROLL" run gear.ini -o text.h5
sed -n '/^Machine element/,$p' out >text
contains text '^maximum shear stress +0\.[0-9]+ GPa '
sed '1d; s/^.\{32\}//' text | while read -r line; do
    grep -qF "\"text\":\"$line\"" whole.html || exit 1
done || fail "the page has other answers: $(cat text)"
sed '/^\[stress\]/,$d' gear.ini >film.ini
expect 0 "$OVERROLL" run film.ini -o part.h5 -q --json --set time.end=20
[ "$(number power_loss_W)" = null ] || fail 'a loss of a part of the way'
expect 0 "$OVERROLL" resume part.h5 -q --json --set time.end=auto
for key in power_loss_W efficiency way_H_min_m lambda_ratio_at_H_min; do
    value=$(number $key)
    grep -q "\"$key\": $value," whole.json ||
        fail "$key: $value once it was resumed"
done

# Helical: the slice stands for the lines of contact of the whole face.
sed 's/^face.*/&\nhelix_angle = 15 deg/' gear.ini >helical.ini
check_loss "$(awk 'BEGIN { pi = atan2(0, -1)
    s = sin(15 * pi / 180) * cos(20 * pi / 180)
    printf "%.17g", 20e-3 / sqrt(1 - s * s) }')" helical.ini
# Driven, gear 1 has the torque that the loss has left.
sed 's/^face.*/&\ndriving = 2/' gear.ini >driven.ini
check_loss 20e-3 driven.ini
awk -v e="$(number efficiency)" -v w="$(number power_loss_W)" 'BEGIN {
    p = 100 * 3000 * atan2(0, -1) / 30
    exit !((e - p / (p + w)) ^ 2 < 1e-20) }' || fail 'efficiency, driven'

# A cam: 4-5-6-7 of 6 mm over 70 degrees under 250 N + 30 N/mm s + 0.1 kg w^2
# s'' takes F s' at most; it loses what the event does, once a turn.
expect 0 "$OVERROLL" init cam --set domain.level=7 -o cam.ini
expect 0 "$OVERROLL" run cam.ini -o cam.h5
contains out '^cam +1000 rpm; maximum drive torque of the lift [0-9.]+ N.m'
contains out '^friction power loss +[0-9.]+ W, mean over one revolution'
contains out '^minimum film thickness +.* at [0-9.]+ deg'
expect 0 "$OVERROLL" run cam.ini -o cam.h5 --force --json -q
cp out cam.json
awk -v told="$(number torque_N_m)" 'BEGIN {
    pi = atan2(0, -1); w = 1000 * pi / 30; b = 70 * pi / 180
    for (k = 0; k <= 10000; k++) {
        y = k / 10000; z = 1 - y
        s = 6e-3 * y ^ 4 * (35 - y * (84 - y * (70 - 20 * y)))
        s1 = 6e-3 * 140 * y ^ 3 * z ^ 3 / b
        s2 = 6e-3 * 420 * y ^ 2 * z ^ 2 * (z - y) / b ^ 2
        f = (250 + 30e3 * s + 0.1 * w * w * s2) * s1
        if (f > most) most = f
    }
    exit !((told - most) ^ 2 < (1e-4 * most) ^ 2) }' || fail 'torque of the cam'
expect 0 "$OVERROLL" export cam.h5 --units si
awk -F, -v told="$(sed -n 's/.*"power_loss_W": \(.*\),/\1/p' cam.json)" '
    NR == 1 { for (i = 1; i <= NF; i++) {
        sub(" .*", "", $i); at[$i] = i }; next }
    NR == 2 { before = $at["time"]; next }
    { joule += $at["power_in"] * ($at["time"] - before)
      before = $at["time"] }
    END {
        watt = joule * 12e-3 * 1000 / 60
        exit !(watt > 0 && (told - watt) ^ 2 < (3e-3 * watt) ^ 2) }' out ||
    fail 'power_loss_W of the cam'

# A bearing
expect 0 "$OVERROLL" init bearing --set domain.level=6 --set time.end=8 \
    --set passes.number=3 --set feature.dent.width=0.6 \
    --set feature.dent.start=-6 -o bearing.ini
expect 0 "$OVERROLL" run bearing.ini -o bearing.h5
contains out '^bearing +4450 N at 1000 rpm; [35] loaded rollers, .* 1967 N'
contains out '^minimum film thickness +.* under roller 3'

# Each number that the answers use is a key of some summary.
{
    sed '/^\[feature/,$d' gear.ini
    printf '[time]\nend = 1\n[heat]\nmodel = lobatto\ntemperature = 60 degC\n'
    printf '[boundary]\nlaw = exponential\nRq = 0.3 um\nslope = 0.03\n'
    printf 'friction = 0.1\n[stress]\nsurface = both\n'
    printf '[fatigue]\nlimit_pressure = 1 GPa\n'
} >all.ini
expect 0 "$OVERROLL" run all.ini -o all.h5 --json -q
cp out all.json
printf '[fatigue]\nlimit_pressure = 0.3 GPa\n' | cat bearing.ini - >worn.ini
expect 0 "$OVERROLL" run worn.ini -o worn.h5 --json -q \
    --set stress.surface=1 --set time.end=1 --set domain.level=5
keys=$(grep -oE 'ROW\([A-Z]?[a-z_A-Z0-9]+\)[,}]' "$TOP/src/run/answers.c" |
    sed 's/ROW(\(.*\)).*/\1/')
[ "$(echo "$keys" | wc -l)" -gt 30 ] || fail "few keys: $keys"
for key in $keys; do
    grep -q "^  \"$key\":" all.json cam.json out || fail "no summary has $key"
done

# Another contact has none.
expect 0 "$OVERROLL" init roller --set domain.level=5 -o other.ini
expect 0 "$OVERROLL" run other.ini -o other.h5
grep -q '^Machine element' out && fail 'answers of no element'
expect 0 "$OVERROLL" view other.h5 -o other.html
grep -q '"answers":\[0\]' other.html || fail 'answers on the page of no element'
