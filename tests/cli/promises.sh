#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Numbers that the manual states and that no other script checks: lines of a
# case, materials, layers, depths, units of profiles, sample sizes, signals.
. "$TOP/tests/support/cli.sh"
page=$TOP/src/case/overroll-case.5

# Lines of 190 characters, and no longer ones.
for x in 185 186; do
    { echo '[output]'
        printf 'title=%s\n' "$(printf "%${x}s" | tr ' ' x)"
        printf '[contact]\nM = 20\nL = 10\n'; } >$x.ini
done
sed -i 's/title=x/title=/' 185.ini
[ "$(awk 'length > n { n = length } END { print n }' 186.ini)" -gt 190 ] ||
    fail 'no long line'
expect 0 "$OVERROLL" check 185.ini
refuses '186.ini:2: .*190' check 186.ini

# Materials by name have the moduli and ratios of overroll-case(5), which it
# has in GPa: E' = E/(1 - nu^2) of two equal bodies.
materials=$(sed -n '/^Materials by name.*nu):/,/^\.EE/p' "$page" |
    sed 's/\\-/-/g' |
    awk '$2 ~ /^[0-9]+$/ && $3 ~ /^0\.[0-9]+$/ { print $1, $2, $3 }')
[ "$(echo "$materials" | wc -l)" -ge 6 ] || fail "materials: $materials"
echo "$materials" | while read -r name E nu; do
    printf '[contact]\nload = 100 kN/m\nradius = 10 mm\nmean_speed = 1 m/s
[lubricant]\nviscosity = 40 mPa.s\nalpha = 20 1/GPa\n' >body.ini
    for k in 1 2; do
        printf '[body %s]\nmaterial = %s\n' $k "$name" >>body.ini
    done
    expect 0 "$OVERROLL" check body.ini --json
    number modulus_Pa | awk -v E="$E" -v nu="$nu" '{
        off = $1 * (1 - nu * nu) / (E * 1e9) - 1
        exit !(off < 1e-9 && off > -1e-9) }' ||
        fail "$name is not $E GPa and $nu: $(number modulus_Pa)"
    echo "$name" >>named
done
[ "$(wc -l <named)" -ge 6 ] || fail "only $(cat named)"

# `oil = mineral` estimates what MEASURED ACCURACY says.
while read -r viscosity alpha; do
    printf '[contact]\nload = 100 kN/m\nradius = 10 mm\nmodulus = 226 GPa
mean_speed = 1 m/s\n[lubricant]\nviscosity = %s mPa.s\noil = mineral\n' \
        "$viscosity" >oil.ini
    expect 0 "$OVERROLL" check oil.ini --json
    number alpha_per_Pa | awk -v a="$alpha" '{ off = $1 * 1e9 - a
        exit !(off < 0.06 && off > -0.06) }' ||
        fail "alpha of $viscosity mPa.s is not $alpha: $(number alpha_per_Pa)"
    tr '\n' ' ' <"$page" | grep -q "[^0-9.]${alpha}[^0-9]" ||
        fail "overroll-case(5) does not have $alpha"
done <<'END'
13.6 18.4
52.5 23.1
346 29.6
1068 33.4
28 20.9
200 27.7
12.5 18.2
END

# Layers: at least 0.02 mesh sizes thick, strains above 0.1 named, and at most
# three times as wide a contact as that of the scale.
cat >layer.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 10 mm
mean_speed = 2 m/s
[lubricant]
viscosity = 40 mPa.s
alpha = 20 1/GPa
[body 1]
material = steel
[body 2]
material = steel
[coating 2]
thickness = 0.047 um
modulus = 100 GPa
[domain]
level = 6
END
expect 0 "$OVERROLL" check layer.ini
! grep -q 'not small' out || fail 'small strains are not small'
refuses 'is 0\.01[0-9]* mesh sizes thick, must be at least 0\.02' \
    check layer.ini --set 'coating 2.thickness=0.043 um'
expect 0 "$OVERROLL" check layer.ini --set 'coating 2.thickness=20 um' \
    --set 'coating 2.modulus=3 GPa' --set 'coating 2.poisson=0.4'
contains out 'strains of 0\.[1-9][0-9]* are not small'
set -- --set 'coating 2.thickness=400 um' --set contact.scale=substrate
expect 0 "$OVERROLL" check layer.ini "$@" --set 'coating 2.modulus=20 GPa' -q
refuses 'the contact is [3-9]\.[0-9]* times as wide' \
    check layer.ini "$@" --set 'coating 2.modulus=1 GPa' -q

# Depths that the surfaces pass in steps of more than z/4 are refused, with the
# `every` that would do.
cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[time]
end = 2
[feature d]
shape = dent
depth = 0.1
width = 0.5
start = -3
[output]
every = 2
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q
expect 2 "$OVERROLL" stress dent.h5 --set stress.surface=1 \
    --set stress.depth_min=0.1 -q
travel=$(sed -n 's/.* are \([0-9.]*\) b of travel apart.*/\1/p' err)
depth=$(sed -n 's/.*resolve depths from \([0-9.]*\) only.*/\1/p' err)
awk -v t="$travel" -v z="$depth" 'BEGIN {
    exit !(t > 0 && z / t > 3.98 && z / t < 4.02) }' || fail "$(cat err)"
contains err 'set every = 1$'

# Lengths above 0.25 m and heights above 1 mm are questioned; a file of more
# than 64 columns is a map.
profile() { # COUNT STEP HEIGHT: a zigzag in mm
    awk -v n="$1" -v d="$2" -v h="$3" 'BEGIN { print "# x [mm], z [mm]"
        for (k = 0; k < n; k++) printf "%g, %g\n", k * d, k % 2 * h }'
}
profile 101 2.6 0.001 >long.csv
profile 101 0.4 1.1 >high.csv
profile 101 2.4 0.9 >usual.csv
expect 0 "$OVERROLL" profile long.csv
contains out 'a length of 0\.26 m is unusual'
expect 0 "$OVERROLL" profile high.csv
contains out 'heights above 1\.1 mm are unusual'
expect 0 "$OVERROLL" profile usual.csv
! grep unusual out || fail 'what is usual is questioned'

# Confidence intervals of the 10, 5 and 1 % quantiles are closed from 36, 72 and
# 368 samples on.  Shares of the variance have a digit from 50 and two from 200.
cat >disc.ini <<'END'
[contact]
load = 100 kN/m
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
[lubricant]
viscosity = 40 mPa.s
alpha = 20 1/GPa
[domain]
level = 4
END
statistics() { # DRAWS
    cat >s.ini <<END
[study]
case = disc.ini
results = no
[random]
draws = $1
design = plain
contact.load = normal 100 kN/m sd 10 kN/m
END
    rm -rf s
    expect 0 "$OVERROLL" sweep s.ini -q -j 2
    expect 0 "$OVERROLL" sweep s.ini --statistics
}
closed() { # PERCENT
    grep -E "^$1 % quantile" out | head -n 1 | grep -q ' to '
}
for n in '10 36' '5 72' '1 368'; do
    statistics $((${n#* } - 1))
    ! closed "${n% *}" || fail "closed below ${n#* } samples"
    statistics "${n#* }"
    closed "${n% *}" || fail "not closed at ${n#* } samples: $(cat out)"
done
for n in '49 0' '50 1' '199 1' '200 2'; do
    statistics "${n% *}"
    digits=$(sed -n 's/^load *[0-9]\.\([0-9]*\) (.*/\1/p' out | head -n 1)
    [ ${#digits} -eq "${n#* }" ] || fail "${n% *} samples: $(cat out)"
done

# A second signal ends at once a step that takes seconds.
"$OVERROLL" run dent.ini --level 14 -o slow.h5 -q >out 2>err &
pid=$!
# handles yes|no: waits until the program does (not) handle SIGINT, which a
# process in the background ignores at first; the handler serves one signal.
handles() {
    for k in $(seq 600); do
        case $(sed -n 's/^SigCgt:.*\(.\)$/\1/p' /proc/$pid/status) in
        [2367abef]) seen=yes ;;
        *) seen=no ;;
        esac
        [ $seen = "$1" ] && return
        sleep 0.1
    done
    kill -KILL $pid
    fail "SIGINT is handled: $seen"
}
handles yes
kill -INT $pid
handles no
kill -INT $pid 2>/dev/null
code=0
wait $pid || code=$?
[ $code -eq 130 ] || fail "after two signals: $code"

# Nothing is coloured.
for command in 'help' 'check dent.ini -v' 'info dent.h5'; do
    # shellcheck disable=SC2086 # words
    expect 0 env -u NO_COLOR TERM=xterm-256color "$OVERROLL" $command
    ! cat out err | grep -q "$(printf '\033')" || fail "$command has colours"
done
