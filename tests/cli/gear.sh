#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The example gear: its start of contact with all models, also with another
# pair and another flank. The same case from tables of an independent script of
# the geometry gives the same film thicknesses within 1e-6.
. "$TOP/tests/support/cli.sh"

gear() {
    expect 0 env EXAMPLES="$PWD" OVERROLL="$OVERROLL" PICTURES=no \
        "$TOP/tools/examples/gear" "$@"
}
gear --set time.end=0.15 --json -q
for key in T_max_rise mu_slide_max film_ratio tau_max radius_ratio; do
    grep -q "\"$key\": *-*[0-9]" out || fail "no $key: $(cat out)"
done
grep -q '"steps_marked": 0' out || fail 'marked steps'
expect 0 "$OVERROLL" info gear.h5
grep -q 'temperature_middle' out || fail 'no temperatures'

# A pair and a flank of one's own
cp "$TOP/profiles/honed.csv" mine.csv
gear --set gear.module=2mm --set gear.teeth_1=25 --set gear.teeth_2=60 \
    --set gear.centre=85mm --set 'gear.speed=1500 rpm' --set domain.level=6 \
    --set "feature.pinion.file=$PWD/mine.csv" --set time.end=0.02 -q

# Module 3, 20 and 40 teeth: load, speeds and radii on the line of action, by
# the way R1 from the base circle of the pinion, in ms and over those of the
# pitch point, at the times that the program takes.
awk '
function tangent(r, base) { return sqrt(r * r - base * base) }
# 0 to 1 about x = 0, smoothly over `wide`
function rise(x, wide) {
    x = x / wide + 0.5
    return x < 0 ? 0 : x > 1 ? 1 : x * x * x * (10 + x * (6 * x - 15))
}
function put(what, t, value) {
    printf "%.17g %.17g\n", 1e3 * t, value >(what ".csv")
}
function point(R1) {
    R2 = line - R1
    t = (R1 - from) / v
    s = (R1 - from) / (till - from - step)
    e = (till - R1) / (till - from - step)
    share = 1 / 3 + (s < 1 ? s : 1) / 3
    fall = 1 / 3 + (e < 1 ? e : 1) / 3
    if (fall < share) share = fall
    alone = rise(R1 - (till - step), wide) * rise(from + step - R1, wide)
    put("load", t, share + (1 - share) * alone)
    put("radius", t, R1 * R2 / line / R0)
    put("radius_1", t, R1 / R0)
    put("speed", t, (w1 * R1 + w1 * rb1 / rb2 * R2) / 2 / um)
    put("sliding", t, (w1 * R1 - w1 * rb1 / rb2 * R2) / um)
}
BEGIN {
    pi = atan2(0, -1)
    rb1 = 30 * cos(pi / 9)
    rb2 = 2 * rb1
    line = sqrt(90 * 90 - (rb1 + rb2) ^ 2)
    pitch = line / 3
    from = line - tangent(63, rb2)
    till = tangent(33, rb1)
    step = 2 * pi * rb1 / 20
    wide = 0.0451651 * step
    w1 = 100 * pi
    v = w1 * rb1
    R0 = pitch * (line - pitch) / line
    um = w1 * pitch
    n = split((till - step - wide / 2) " " (till - step) " " \
        (till - step + wide / 2) " " pitch " " (from + step - wide / 2) " " \
        (from + step) " " (from + step + wide / 2), corner, " ")
    next_corner = 1
    for (k = 0; k <= 1600; k++) {
        R1 = from + (till - from) * k / 1600
        while (next_corner <= n && corner[next_corner] < R1 - 1e-9)
            point(corner[next_corner++])
        if (next_corner <= n && corner[next_corner] < R1 + 1e-9) next_corner++
        point(R1)
    }
    printf "%.17g %.17g %.17g %.17g\n", R0, um / 1e3, 1e3 * t, \
        1e3 * (pitch - from) / v
}' CONVFMT=%.17g >nominal.txt
read -r radius speed end _ <nominal.txt
awk '{ exit !($1 - 6.8404 < 1e-3 && 6.8404 - $1 < 1e-3 &&
    $3 - 1.6352 < 1e-3 && 1.6352 - $3 < 1e-3) }' nominal.txt ||
    fail "nominal: $(cat nominal.txt)"

# The film alone, smooth, flooded and isothermal, on a domain of its own.
smooth() {
    sed '/^\[heat\]/,/^temperature/d; /^\[cavitation\]/,$d
        s/^level = .*/level = 5\n[time]\nscheme = upstream2/' \
        "$TOP/tools/examples/gear.ini"
}
smooth >new.ini
{
    smooth | sed "/^\\[gear\\]/,/^blend/d
        s/^modulus/radius = $radius mm\\nmean_speed = $speed m\\/s\\n&/
        s/^scheme/end = $end ms\\n&/"
    for of in load radius radius_1 speed sliding; do
        printf '[%s]\nhistory = table\ntime_unit = ms\nfile = %s.csv\n' $of $of
    done
} >old.ini
for one in new old; do
    expect 0 "$OVERROLL" run $one.ini -o $one.h5 -q
    expect 0 "$OVERROLL" export $one.h5
    mv out $one.csv
done
awk -F, '
FNR == 1 { of++; for (i = 1; i <= NF; i++) { name = $i; sub(" .*", "", name)
    at[of, name] = i }; next }
of == 1 { h[FNR] = $at[1, "central_film_thickness"]; rows = FNR; next }
{ d = $at[2, "central_film_thickness"] / h[FNR] - 1
    if (d < 0) d = -d
    # Behind the end of contact a table keeps its value.
    if (FNR < rows && d > most) most = d }
END { printf "%d rows, off by %g\n", rows, most
    exit !(rows > 1000 && FNR == rows && most < 1e-6) }' new.csv old.csv ||
    fail 'another gear than that of the tables'

# Nothing slides at the pitch point, where speeds differ by rounding only: no
# fluid friction of 1e-17, and no boundary friction.
cat >pitch.ini <<'END'
[gear]
teeth_1 = 20
teeth_2 = 40
module = 4 mm
face = 40 mm
speed = 1500 rpm
torque = 300 Nm
[contact]
modulus = 226 GPa
[lubricant]
viscosity = 18.09 mPa.s
alpha = 15.30 1/GPa
rheology = eyring
eyring_stress = 5 MPa
limiting_shear = 0.08
[domain]
level = 6
[boundary]
law = exponential
Rq = 0.4 um
slope = 0.1
friction = 0.1
END
expect 0 "$OVERROLL" steady pitch.ini --json
zero() {
    for key; do
        [ "$(number "$key")" = 0 ] || fail "$key: $(grep "\"$key\"" out)"
    done
}
zero sliding mu_slide mu_film mu_boundary F_slide
printf '[heat]\nmodel = lobatto\n' >>pitch.ini
expect 0 "$OVERROLL" steady pitch.ini --json \
    --set lubricant.temperature='80 degC'
zero sliding mu_slide mu_film mu_boundary F_slide
