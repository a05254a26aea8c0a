#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# find, [random], --sensitivity and --estimate-error with each physical model:
# answers were computed by runs, samples equal single runs, and elasticities
# equal the difference of two runs. Commands that are killed and repeated give
# the same bits.
. "$TOP/tests/support/cli.sh"
need setsid

# holds EXPRESSION NAME=VALUE...: of awk.
holds() {
    expression=$1
    shift
    for named; do
        set -- "$@" -v "$named"
        shift
    done
    awk "$@" "function abs(x) { return x < 0 ? -x : x }
        BEGIN { exit !($expression) }"
}
run_at() { # VALUE
    "$OVERROLL" run "$name.ini" --set "$key=$1" -q --json >one.json 2>err ||
        fail "$name, $key = $1: $(cat err)"
    number "$quantity" one.json
}
# killed FOLDER FILES COUNT COMMAND...: until it has so many lines of results.
killed() {
    folder=$1 files=$2 count=$3
    shift 3
    setsid "$@" >/dev/null 2>&1 &
    tries=0
    # shellcheck disable=SC2086 # a pattern
    until [ "$(cat "$folder"/$files 2>/dev/null | grep -c .)" -ge "$count" ]
    do
        tries=$((tries + 1))
        [ $tries -lt 6000 ] || fail "$name: '$*' does not get on"
        sleep 0.01
    done
    kill -9 "-$!" 2>/dev/null || fail "$name: '$*' has ended before"
    wait $! 2>/dev/null
    for _ in $(seq 300); do # its children have locks until they are gone
        kill -0 "-$!" 2>/dev/null || break
        sleep 0.01
    done
}

asked_to_find() {
    set -- "$OVERROLL" find "$name.ini" "$key" between "$low" and \
        "$high" so that "$quantity" is "$value" --json -q
    expect 0 "$@" --results once.d
    sed '/seconds/d' out >once
    found=$(number value out)
    holds 'found > low + 0 && found < high + 0' found="$found" \
        low="${low%% *}" high="${high%% *}" || fail "$name: found $found"
    # the answer has been run, and lies a thousandth of the key off at most
    now=$(run_at "$found${unit:+ $unit}")
    holds 'now == at && abs(at - value) <= 2e-3 * abs((b - a)/(1 - low/high))' \
        now="$now" at="$(number at_value once)" value="$value" \
        a="$at_low" b="$at_high" low="${low%% *}" high="${high%% *}" ||
        fail "$name: found $now, told $(cat once), asked for $value"
    killed killed.d find.csv 3 "$@" --results killed.d
    expect 0 "$@" --results killed.d
    sed '/seconds/d' out | cmp - once || fail "$name: killed, found another"
    rm -rf once.d killed.d
}

# What a table says but for what depends on the clock.
table_of() {
    "$OVERROLL" sweep study.ini -o "$1" --collect "$1.csv" -q
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "seconds") s = i }
        { $s = ""; print }' "$1.csv"
}
asked_at_random() {
    {
        printf '[study]\ncase = %s.ini\n[random]\ndraws = 32\n' "$name"
        printf '%s = uniform %s to %s\n' "$key" "$low" "$high"
    } >study.ini
    expect 0 "$OVERROLL" sweep study.ini -j 2 -q -o drawn
    table_of drawn >drawn.txt
    [ "$(grep -c ' finished ' drawn.txt)" -eq 32 ] ||
        fail "$name: $(cat drawn.txt)"
    killed killed '*.json' 2 "$OVERROLL" sweep study.ini -j 2 -q -o killed
    expect 0 "$OVERROLL" sweep study.ini -j 2 -q -o killed
    table_of killed | cmp - drawn.txt || fail "$name: killed, other draws"
    rm -rf drawn killed
}

asked_for_slopes() {
    expect 0 "$OVERROLL" run "$name.ini" --sensitivity "$key" --json -q
    told=$(tr -d '\n' <out | tr '{' '\n' | grep "\"$quantity\"" |
        sed -n 's/.*"elasticity": \([-0-9.e+]*\).*/\1/p')
    [ -z "$told" ] ||
        holds 'abs(told - (c = log(b/a)/log(high/low))) <= 0.15 * abs(c)' \
            told="$told" a="$at_low" b="$at_high" low="${low%% *}" \
            high="${high%% *}" ||
        fail "$name: elasticity $told, from $at_low to $at_high by two runs"
    expect 0 "$OVERROLL" run "$name.ini" --estimate-error --json -q
    same=$(echo "$quantity" | sed 's/central_film_m/H_cen/; s/_m$//; s/_Pa$//')
    # without a known order of convergence there is none, with a warning
    grep -q "\"${same}_error_relative\": null" out &&
        grep -q "$same: no error estimate, because the values" out ||
        holds 'e > 0 && e < 1' e="$(number "${same}_error_relative" out)" ||
        fail "$name: no error of $same: $(grep error out)"
    echo "$name: $quantity is $value at $found, elasticity ${told:-left out}"
}

# asked NAME KEY LOW HIGH QUANTITY: what that case makes of all of them.
asked() {
    name=$1 key=$2 low=$3 high=$4 quantity=$5
    unit=${low#* }
    [ "$unit" != "$low" ] || unit=
    at_low=$(run_at "$low") at_high=$(run_at "$high")
    value=$(awk -v a="$at_low" -v b="$at_high" \
        'BEGIN { printf "%.9g", (a + b)/2 }')
    holds 'abs(a - b) > 1e-6 * abs(a)' a="$at_low" b="$at_high" ||
        fail "$name: $quantity does not depend on $key"
    asked_to_find
    asked_at_random
    asked_for_slopes
}

# write NAME: the sections on standard input, and those that all share.
write() {
    cat - rest >"$1.ini"
}
cat >oil <<'END'
[lubricant]
viscosity = 0.12 Pa.s
alpha = 18 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[domain]
level = 5
[solver]
tolerance = 1e-9
END
cat >dent <<'END'
[feature dent]
shape = dent
depth = 0.3 um
width = 1
start = -4.6
END
cat >steel <<'END'
[contact]
load = 60 kN/m
radius = 10 mm
speed_1 = 5.2 m/s
speed_2 = 4.8 m/s
[body 1]
modulus = 206 GPa
[body 2]
modulus = 206 GPa
END
cat oil steel dent >rest

write plain <<'END'
[time]
end = 2
END
write heat <<'END'
[time]
end = 1
[heat]
model = lobatto
temperature = 60 degC
END
write starved <<'END'
[time]
end = 2
[cavitation]
model = conserving
[supply]
model = film
thickness_1 = 0.3 um
thickness_2 = 0.3 um
END
write passes <<'END'
[time]
end = 1
[cavitation]
model = conserving
[passes]
number = 2
loss = 0.1
END
write plastic <<'END'
[time]
end = 4
[stress]
surface = 1
[plastic]
hardening = kinematic
yield = 0.21 GPa
modulus = 5 GPa
layers = 8
depth_max = 0.9
END
write fatigue <<'END'
[time]
end = 2
[stress]
surface = 1
[fatigue]
criterion = circle
alpha = 0.3
END
write coated <<'END'
[time]
end = 2
[coating 1]
thickness = 3 um
modulus = 100 GPa
END
write touching <<'END'
[time]
end = 2
[boundary]
law = exponential
Rq = 150 nm
slope = 0.03
friction = 0.11
of = unresolved
END
write histories <<'END'
[time]
end = 2
step = adaptive
[load]
history = sine
amplitude = 0.2
period = 3
[speed]
history = ramp
from = 1
to = 0.7
duration = 1
[sliding]
history = ramp
to = 0.2
duration = 1
[radius]
history = ramp
to = 1.01
duration = 1
END
write reversal <<'END'
[time]
end = 2
[speed]
history = ramp
from = 0.5
to = -0.5
duration = 2
END
write ground <<'END'
[time]
end = 2
[feature rough]
shape = roughness
Rq = 20 nm
length = 4
shortest = 0.5
start = -5
END
cat steel oil >rest
write wear <<'END'
[boundary]
law = profile
wear_1 = 1e-7 mm3/Nm
passes = 2000
jump = 500
[feature rough]
shape = roughness
Rq = 150 nm
length = 4
END
{
    sed -n '/^\[body/,$p' steel
    cat oil
} >rest
write gear <<'END'
[gear]
module = 3 mm
teeth_1 = 20
teeth_2 = 40
centre = 90 mm
face = 20 mm
speed = 3000 rpm
torque = 100 N.m
[time]
end = 3
END
write cam <<'END'
[cam]
base_radius = 34 mm
face = 12 mm
speed = 1500 rpm
lift = 6 mm
rise = 70 deg
spring = 30 N/mm
preload = 250 N
mass = 100 g
[time]
end = 3
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
END

for name in plain heat starved plastic fatigue coated touching histories \
    reversal ground wear; do
    asked $name lubricant.viscosity '0.11 Pa.s' '0.13 Pa.s' H_min_overall_m
done
asked plastic contact.load '55 kN/m' '65 kN/m' P_max_overall_Pa
asked gear gear.torque '95 N.m' '105 N.m' H_min_overall_m
asked cam cam.preload '240 N' '260 N' H_min_overall_m
asked bearing roller_bearing.load '4300 N' '4600 N' central_film_m

# Several passes are found with a folder for their files, and have no slopes.
run_at() {
    "$OVERROLL" run "$name.ini" --set "$key=$1" -o one.h5 --force -q --json \
        >one.json 2>err || fail "$name, $key = $1: $(cat err)"
    number "$quantity" one.json
}
asked_for_slopes() {
    expect 1 "$OVERROLL" run "$name.ini" --sensitivity "$key" -q
    contains err 'use a study of the key'
}
asked passes lubricant.viscosity '0.11 Pa.s' '0.13 Pa.s' H_min_overall_m
