#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# steady: table, JSON with the documented keys, the exact discrete solution.
. "$TOP/tests/support/cli.sh"

expect 0 "$OVERROLL" steady --M 20 --L 10 --level 7
contains out '^minimum film thickness +0\.0[0-9]+ +b\^2/R +0\.9'
[ ! -s err ] || fail "says on stderr: $(cat err)"

# The minimum of the report is the one between nodes, closer to the limit of
# fine meshes, 0.073573 (tools/paper).
printed=$(sed -n 's/^minimum film thickness  *\([0-9.]*\) .*/\1/p' out)
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 7 --json
awk -v p="$printed" -v l="$(number H_min_located)" -v n="$(number H_min)" '
    function off(x, y) { return x > y ? x - y : y - x }
    BEGIN {
        exit !(off(p, l) < 1e-7 && off(l, 0.073573) < off(n, 0.073573))
    }' ||
    fail "$printed is printed, H_min_located is $(number H_min_located)"

# A tolerance below rounding errors keeps the fourth order and is named.
H=$(number H_cen)
expect 1 "$OVERROLL" steady --M 20 --L 10 --level 7 --json \
    --set solver.tolerance=1e-11
contains err 'tolerance = 1.0e-11 is below rounding .* use tolerance = 1.0e-09'
! grep 'second order' err || fail 'rounding makes the solution second order'
[ "$(number order)" = 4 ] || fail "order $(number order)"
[ "$(number cycles)" -lt 100 ] || fail "$(number cycles) cycles"
awk -v a="$H" -v b="$(number H_cen)" 'BEGIN { d = a / b - 1
    exit !(d < 1e-7 && d > -1e-7) }' || fail "H_cen $(number H_cen), not $H"

expect 0 "$OVERROLL" steady --M 20 --L 10 --level 6 -q
[ ! -s out ] || fail "-q prints: $(cat out)"

expect 0 "$OVERROLL" steady --M 20 --L 10 --level 9 --scheme upstream1 --json
for key in converged M L alphabar hertz_pressure_Pa nodes level scheme \
    smoother H_min X_min H_cen H0 P_max X_P_max P_spike X_spike load \
    mass_flow residual cycles seconds; do
    contains out "^ *\"$key\": "
done
contains out '"converged": true'
contains out '"scheme": "upstream1"'

# Keys that only the paper needs stand in [paper], and elsewhere are told so
printf '[contact]\nM = 20\nL = 10\n[solver]\nsmoother = hybrid\n' >old.ini
expect 2 "$OVERROLL" steady old.ini --level 5 --json
contains err "old.ini:5: unknown key 'smoother' in \[solver\]"
contains err 'it is a key of \[paper\]'
sed 's/solver/paper/' old.ini >new.ini
expect 0 "$OVERROLL" steady new.ini --level 5 --json
contains out '"smoother": "hybrid"'

# No spike, no Hertzian pressure: null
expect 0 "$OVERROLL" steady --M 5 --L 0 --level 6 --json
contains out '"hertz_pressure_Pa": null'
contains out '"P_spike": null'

# Second order where fourth was wanted is a warning, and the level that it
# names is of fourth order; by the gap this contact is, on a coarser mesh too
thin='steady --M 503.8029 --L 6.047824 --set domain.faces=arithmetic'
# shellcheck disable=SC2086
expect 0 "$OVERROLL" $thin --level 7 --json
contains out '"order": 2'
contains out '"warnings": .*second order.* use level = 8'
# shellcheck disable=SC2086
expect 0 "$OVERROLL" $thin --level 8 --json
contains out '"order": 4'
contains out '"warnings": \[ \]'
# shellcheck disable=SC2086
expect 0 "$OVERROLL" $thin --level 7 --json --set domain.faces=gap
contains out '"order": 4'
contains out '"warnings": \[ \]'

# The same contact in physical units and in numbers
cat >roller.ini <<'END'
[contact]
load = 307 kN/m
radius = 10 mm
modulus = 226 GPa
viscosity = 40 mPa.s
mean_speed = 1.3 m/s
[lubricant]
alpha = 17 1/GPa
z = 0.68
[domain]
level = 7
END
expect 0 "$OVERROLL" steady roller.ini --json
contains out '"min_film_m": [0-9.]+e-07'
mv out physical
value() {
    sed -n "s/^  \"$2\": \([^,]*\),*$/\1/p" "$1"
}
expect 0 "$OVERROLL" steady --json --level 7 --M "$(value physical M)" \
    --L "$(value physical L)" --set lubricant.z=0.68
for key in H_min H_cen H0 P_max P_spike mass_flow; do
    a=$(value physical $key) b=$(value out $key)
    awk -v a="$a" -v b="$b" \
        'BEGIN { d = (a - b)/a; exit !(a != 0 && d < 1e-10 && d > -1e-10) }' ||
        fail "$key: $a in physical units, $b in numbers"
done

# The estimated discretization error is near the true one (H_cen at level 7:
# 0.0841789 by the gap, 0.0841122 arithmetic, limit 0.0841967; by second order).
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 7 --set domain.order=2 \
    --set domain.faces=gap --estimate-error --json
contains out '"error_level": 6'
contains out '"H_cen_error": (1\.[6-9]|2\.[0-3])[0-9]*e-05'
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 7 --set domain.order=2 \
    --set domain.faces=arithmetic --estimate-error --json
contains out '"H_cen_error": (8|9)\.[0-9]*e-05'

# In thick films the end moves irregularly from level to level (M = 0.2, L = 1:
# H_cen on levels 7 and 8 is 24.29577 and 24.29728). The estimate covers it.
for light in '0.1 1' '0.1 2' '0.2 1'; do
    M=${light% *} L=${light#* }
    expect 0 "$OVERROLL" steady --M "$M" --L "$L" --level 7 --estimate-error \
        --json
    told=$(value out H_cen_error) film=$(value out H_cen)
    expect 0 "$OVERROLL" steady --M "$M" --L "$L" --level 8 --json
    awk -v e="$told" -v a="$film" -v b="$(value out H_cen)" \
        'BEGIN { d = a - b; exit !((d < 0 ? -d : d) <= e && e < 5e-4*a) }' ||
        fail "M = $M, L = $L: $film has the estimate $told"
done

# What had to be done beyond the ordinary is said when asked for; what cannot
# be solved is named, and what was reached is shown; what was solved on too
# coarse a mesh (0.000528 for 0.000708) says so.
expect 0 "$OVERROLL" steady --M 255.5 --L 5.822 --level 6 -v \
    --set domain.order=2 --set domain.faces=arithmetic \
    --set solver.tolerance=2e-9
contains err 'needed another strategy: the load was raised in smaller steps'
expect 0 "$OVERROLL" steady --M 900 --L 5 --level 6
contains err 'too thin for the grid.*; use level = [0-9]+'
expect 1 "$OVERROLL" steady --M 5000 --L 5 --level 6
contains err 'too thin for the grid: .* level [0-9]+ resolves it'
contains out 'NOT CONVERGED'
expect 1 "$OVERROLL" steady --M 5000 --L 5 --level 6 --json
contains out '"converged": false'
! grep -i 'nan\|inf"' out || fail 'NaN in a result'

# The lambda ratio of roughness that is not on the grid: minimum film thickness
# divided by sqrt(Rq_1^2 + Rq_2^2); nothing else changes.
cat >discs.ini <<'END'
[contact]
load = 100 kN/m
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
[lubricant]
viscosity = 40 mPa.s
alpha = 20 1/GPa
[domain]
level = 6
END
member() {
    sed -n 's/^  "'"$1"'": \(.*\),$/\1/p' out | head -n 1
}
expect 0 "$OVERROLL" steady discs.ini --json
[ "$(member lambda_ratio)" = null ] || fail 'a lambda ratio without roughness'
film=$(member min_film_m) H=$(member H_min)
rough="--set contact.Rq_1=30nm --set contact.Rq_2=40nm"
# shellcheck disable=SC2086 # words
expect 0 "$OVERROLL" steady discs.ini --json $rough
[ "$(member H_min)" = "$H" ] || fail 'contact.Rq_1 changed the film'
[ "$(member lambda_ratio_from)" = '"contact.Rq_1 and contact.Rq_2"' ] ||
    fail "from $(member lambda_ratio_from)"
echo "$(member lambda_ratio) $film" | awk '{ exit !($1*50e-9/$2 > 0.99 &&
    $1*50e-9/$2 < 1.01) }' || fail "ratio $(member lambda_ratio) of $film m"
# shellcheck disable=SC2086
expect 0 "$OVERROLL" steady discs.ini $rough
contains out '^lambda ratio +[0-9.]+ .*composite Rq of contact.Rq_1'
# shellcheck disable=SC2086
expect 0 "$OVERROLL" check discs.ini $rough
contains out '^#   lambda ratio +[0-9.]+ .predicted minimum film thickness'
refuses 'Rq_1: ' check --M 20 --L 10 --set contact.Rq_1=30nm

# Stresses are printed by run only; steady names the section that it ignores
{
    printf '[contact]\nM = 20\nL = 10\n[domain]\nlevel = 5\n'
    printf '[stress]\nsurface = 1\n'
} >stress.ini
expect 0 "$OVERROLL" steady stress.ini
contains err '^overroll: \[stress\] is ignored by .*; .overroll run. prints'
! grep '^Stresses' out || fail 'steady prints stresses: the note is wrong'
expect 0 "$OVERROLL" run stress.ini
contains out '^Stresses below surface 1'
! grep 'is ignored' err || fail "run has the note: $(cat err)"
