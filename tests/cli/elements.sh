#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Gears, cams and bearings specified in a case: contact and path, warnings, and
# every rejected input.
. "$TOP/tests/support/cli.sh"

# write NAME: the section on standard input, and what all three share.
write() {
    {
        cat
        printf '[contact]\nmodulus = 226 GPa\n[lubricant]\n'
        printf 'viscosity = 10 mPa.s\nalpha = 16 1/GPa\n[domain]\nlevel = 5\n'
    } >"$1.ini"
}
write gear <<'END'
[gear]
module = 3 mm
teeth_1 = 20
teeth_2 = 40
centre = 90 mm
face = 20 mm
speed = 3000 rpm
torque = 100 N.m
END
write cam <<'END'
[cam]
base_radius = 20 mm
face = 12 mm
speed = 1500 rpm
lift = 9 mm
rise = 65 deg
spring = 30 N/mm
preload = 250 N
mass = 100 g
to = 30 deg
END
write bearing <<'END'
[roller_bearing]
roller = 10 mm
rollers = 14
length = 9.6 mm
inner = 54.991 mm
clearance = 41 um
load = 4450 N
speed_inner = 1000 rpm
passes = zone
END
cat >>bearing.ini <<'END'
[cavitation]
model = conserving
[time]
end = 4
[feature d]
shape = dent
depth = 0.4 um
width = 0.5
start = -3
END

# says PATTERN: `out` has a line of it.
says() {
    grep -q "$1" out || {
        cat out
        fail "nothing says: $1"
    }
}

# The pair of the truth: R_C 6.840403 mm, u_C 3.223464 m/s, 1.635186 ms.
expect 0 "$OVERROLL" check gear.ini -v
says 'reduced radius R  *6.8404 mm'
says 'entrainment speed u_m  *3.22346 m/s'
expect 0 "$OVERROLL" run gear.ini -o gear.h5 -q --json
says '"T_end": 45\.[01]' # the first step beyond 45.07
expect 0 "$OVERROLL" info gear.h5
# The step that ends behind the end of contact is as the one before it.
expect 0 "$OVERROLL" export gear.h5 -o gear.csv
awk -F, 'function share(a, b) { return a > b ? a / b - 1 : b / a - 1 }
    NR == 1 {
        for (k = 1; k <= NF; k++) {
            sub(/ .*/, "", $k)
            column[$k] = k
        }
        H = column["min_film_thickness"]
        W = column["power_dissipated"]
        next
    }
    { film = share($H, before_H); power = share($W, before_W)
      before_H = $H; before_W = $W }
    END { exit !(NR > 100 && H && W && film < 0.001 && power < 0.02) }' \
    gear.csv || fail 'the last step of a gear jumps'

# Given by the load at the pitch point, or by power, it is the same gear.
expect 0 "$OVERROLL" check gear.ini --json
sed -n '/"load_N_per_m"/p' out >torque.txt
sed 's/torque = 100 N.m/power = 31.41592653589793 kW/' gear.ini >power.ini
expect 0 "$OVERROLL" check power.ini --json
sed -n '/"load_N_per_m"/p' out | cmp - torque.txt ||
    fail "power is another gear"

expect 0 "$OVERROLL" run cam.ini -o cam.h5 -q
# Three rollers meet a point of the inner ring: 309, 1967 and 309 N.
expect 0 "$OVERROLL" run bearing.ini -o bearing.h5 -q \
    --set domain.level=6
expect 0 "$OVERROLL" info bearing.h5
says 'pass'

# ---------------------------------------------------------------- refusals

# no FILE WORDS SETTING...: refused with the words, in one line.
no() {
    file=$1 words=$2
    shift 2
    for setting; do
        set -- "$@" --set "$setting"
        shift
    done
    refuses "$words" check "$file.ini" "$@"
}
# without FILE KEY: the case without a key.
without() {
    sed "/^$2 = /d" "$1.ini" >less.ini
}

# What an element says stands nowhere else.
for key in 'radius=8 mm' 'mean_speed=2 m/s' 'speed_1=2 m/s' 'speed_2=2 m/s' \
    slide_to_roll=0.1 M=20 L=10 lambda=0.1 alphabar=16 'width=9 mm'; do
    no gear "already determined by .*; remove ${key%%=*}" "contact.$key"
done
for kind in gear cam; do
    no $kind 'already determined by .*; remove radius' 'body 1.radius=8 mm'
    no $kind "already determined by .*; remove load and change $kind\\." \
        'contact.load=100 kN/m'
    for of in load speed sliding radius radius_1; do
        no $kind "determines the time history of $of; remove \\[$of\\]" \
            "$of.history=sine" "$of.amplitude=0.1"
    done
done
no gear 'remove hertz_pressure' 'contact.hertz_pressure=1 GPa'
no bearing 'remove load' 'contact.load=100 kN/m'
no gear 'at most one machine element' 'cam.base_radius=3 mm'
no cam 'at most one machine element' roller_bearing.rollers=14

# What it needs, its end.
for key in teeth_1 teeth_2 module face speed; do
    without gear $key
    no less "\\[gear\\] needs $key"
done
for key in face speed spring preload lift rise; do
    without cam $key
    no less "\\[cam\\] needs $key"
done
for key in roller length load; do
    without bearing $key
    no less "\\[roller_bearing\\] needs $key"
done
without cam base_radius
no less 'has no effect without base_radius'
without bearing rollers
no less 'has no effect without rollers'
without gear torque
no less '\[gear\] needs torque or power'
no gear '\[gear\] ends at 1.635 ms \(T = 45.08\)' time.end=99
no cam '\[cam\] ends at' time.end=99999

# Geometry of gears
no gear 'shift_1, shift_2 and centre determine each' gear.shift_1=0 \
    gear.shift_2=0
no gear 'centre must be above 84.5' 'gear.centre=80 mm'
no gear 'contact ratio 0.7[0-9]* is below 1: at times no tooth pair' \
    gear.addendum=0.4
without gear centre
no less 'tip of gear 2 reaches below the base circle of gear 1' \
    gear.teeth_1=8
no gear 'tip_1 = .* is inside the base circle' 'gear.tip_1=50 mm'
no gear 'tip_2 = .* is inside the base circle' 'gear.tip_2=90 mm'
no less 'needs at least 8 teeth more' gear.teeth_1=24 gear.teeth_2=-30
no less 'the internal gear must be gear 2' gear.teeth_1=-20
no less 'must be 5 or more' gear.teeth_1=3
# The load that pairs share
no gear 'the load would jump at B and D' gear.blend=0
no gear "needs 'file'" gear.sharing=table
no gear 'has no effect' 'gear.relief_1=10 um'
no less 'must be elastic for helical teeth' 'gear.helix_angle=15 deg' \
    gear.sharing=rule
no less 'above 2, where two or more pairs' gear.addendum=1.5 \
    gear.teeth_1=60 gear.teeth_2=80
printf '0 0.3\n0.5 1.4\n1.7 0.3\n' >shares.txt
no gear '1.4' gear.sharing=table gear.file=shares.txt
printf '0 0.3\n1.7 0.3\n0.5 1\n' >shares.txt
no gear "shares.txt:3: the distance must increase: 0.5 follows 1.7" \
    gear.sharing=table gear.file=shares.txt

# Cams
no cam 'a flat follower loses contact' 'cam.base_radius=17 mm' \
    'cam.to=60 deg' cam.from=0deg
no cam 'undercut' cam.follower=roller 'cam.roller_radius=40 mm' 'cam.to=60 deg'
no cam 'lifts off the cam' 'cam.preload=1 N' 'cam.spring=0 N/mm' \
    'cam.speed=3000 rpm' 'cam.to=60 deg' 'cam.base_radius=60 mm'
awk 'BEGIN { for (k = 0; k <= 120; k++)
    printf "%d %.3f\n", k, 4 * (1 - cos(3 * k * atan2(0, -1) / 180)) }' \
    >lifts.txt
sed '/^lift/d; /^rise/d; /^to/d' cam.ini >less.ini
no less 'lifts are rounded to 1 um' cam.law=table cam.file=lifts.txt
no less 'needs file' cam.law=table
# Units of a lift table: those of its header; without one degrees and mm, which
# metres and radians are not
table() { # NAME HEADER FORMAT (of the angle in degrees and the lift in mm)
    awk -v header="$2" "BEGIN { if (header) print header
        for (k = 0; k <= 120; k++) {
            a = k; s = 1 - cos(3 * k * atan2(0, -1) / 180)
            pi = atan2(0, -1); $3 } }" >"$1"
}
pressure() {
    expect 0 "$OVERROLL" check less.ini --json -q --set cam.law=table \
        --set cam.file="$1"
    number hertz_pressure_Pa
}
table plain.txt '' 'printf "%d %.17g\n", a, s'
wanted=$(pressure plain.txt)
table metres.txt '# angle in degrees, lift in m' 'printf "%d %.17g\n", a, s/1e3'
table radians.txt '"Angle (rad)";"Lift [mm]"' \
    'printf "%.17g;%.17g\n", a * pi / 180, s'
table swapped.txt 'lift_microns angle_deg' 'printf "%.17g %d\n", 1e3 * s, a'
table named.txt 'angle,lift' 'printf "%d,%.17g\n", a, s'
for file in metres radians swapped named; do
    awk -v a="$(pressure $file.txt)" -v b="$wanted" \
        'BEGIN { exit !(b > 1e8 && a / b > 1 - 1e-9 && a / b < 1 + 1e-9) }' ||
        fail "$file.txt: $(number hertz_pressure_Pa) for $wanted"
done
for file in metres radians; do
    sed 1d $file.txt | tr ';' ' ' >bare.txt
    no less 'must be in degrees and mm; set other units' cam.law=table \
        cam.file=bare.txt
done
sed '1s/.*/angle, lift [mm]/' plain.txt >half.txt
no less 'names a unit of the lift and none of the angle' cam.law=table \
    cam.file=half.txt
echo 'no numbers' >none.txt
no less 'needs at least 4 points' cam.law=table cam.file=none.txt

# Bearings
no bearing 'do not fit on a pitch circle' 'roller_bearing.roller=20 mm'
no bearing 'inner and pitch determine each' 'roller_bearing.pitch=65 mm'
without bearing inner
no less 'inner or pitch must be set'
no bearing 'speed_outer are equal' 'roller_bearing.speed_outer=1000 rpm'
no bearing 'both 0' 'roller_bearing.speed_inner=0 rpm'
no bearing 'already determined by .*; remove spacing' passes.spacing=9 \
    passes.recovery=1
no bearing 'already determined by .*; remove loads' passes.loads=1,2
no bearing 'meets 3 rollers' passes.number=7
no bearing 'use zone' roller_bearing.passes=turns
no bearing 'use turns' roller_bearing.contact=outer
no bearing 'turns needs passes.number' roller_bearing.contact=outer \
    roller_bearing.passes=turns

# ------------------------------------------------------------ where it stands

# Steady at its stations, of smooth surfaces: the load and radius of check's
# table, films as the fit's to its own 2.6 % and what fourth order adds.
value() { # value KEY, of the JSON in `out`
    sed -n "s/^ *\"$1\": \(.*[^,]\),*\$/\1/p" out | head -n 1
}
expect 0 "$OVERROLL" check gear.ini --json
sed -n '/"stations"/,/\]/s/^ *"\(name\|load_N_per_m\|h_min_m\)": \(.*\),/\2/p' \
    out | tr -d '"' | paste -d ' ' - - - >stations
while read -r name load film; do
    expect 0 "$OVERROLL" steady gear.ini --at "$name" --json --level 8
    awk -v name="$name" -v load="$load" -v film="$film" \
        -v w="$(value load_N_per_m)" -v h="$(value min_film_m)" 'BEGIN {
        exit !((w / load - 1) ^ 2 < 1e-18 && (h / film - 1) ^ 2 < 9e-4) }' ||
        fail "at $name: $(value load_N_per_m) N/m, $(value min_film_m) m"
done <stations
# Nothing said: the pitch point; a time; another kind of case.
expect 0 "$OVERROLL" steady gear.ini --json
pitch=$(value min_film_m)
expect 0 "$OVERROLL" steady gear.ini --json --at 0.85676681188388171ms
awk -v a="$pitch" -v b="$(value min_film_m)" \
    'BEGIN { exit !((a / b - 1) ^ 2 < 1e-14) }' || fail 'not the pitch point'
expect 0 "$OVERROLL" steady cam.ini --at '12 deg' --json
refuses 'a contact position .A to E' steady gear.ini --at Z
refuses 'the path of contact, from 0 to 1.635 ms' steady gear.ini --at 2ms
refuses 'within the event, from 0 to 30 deg' steady cam.ini --at '40 deg'
refuses 'only cases with .gear. or .cam.' steady bearing.ini --at A

# ---------------------------------------------------------------- warnings

warns() { # warns WORDS COMMAND...
    words=$1
    shift
    expect 0 "$OVERROLL" "$@"
    contains err "warning: .*$words"
}
quiet() {
    expect 0 "$OVERROLL" "$@"
    ! grep -E "blend|ends before the end|would touch" err || fail "warned: $*"
}
# A to B are 0.635 base pitches.
warns 'more than a third of the distance from A to B .0.635' check gear.ini \
    --set gear.blend=0.22
quiet check gear.ini --set gear.blend=0.21
warns 'the run ends before the end of contact at 45.08' check gear.ini \
    --set time.end=20
quiet check gear.ini --set time.end=auto
{
    cat gear.ini
    printf '[feature r]\nsurface = 1\nshape = roughness\nRq = 0.3 um\n'
    printf 'length = 20\nshortest = 1\nseed = 1\nstart = 2\ngrow = 1\n'
} >rough.ini
warns 'at A the predicted minimum film thickness 0.1[0-9]* um .* Rq = ' \
    check rough.ini
quiet check rough.ini --set feature.r.Rq=0.03um
# The load that comes on in 0.9 mm: its pressure peaks there.
warns 'the maximum pressure .* occurs .* mm from B' run gear.ini \
    --set gear.blend=0.1
exit 0
