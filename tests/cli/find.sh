#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# find: closed forms to 1e-9 without runs, answers from runs, inequalities,
# several answers, failed ends, rejected input; in a study, stopped and
# resumed.
. "$TOP/tests/support/cli.sh"
need setsid

# close A B TOLERANCE: relative.
close() {
    awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN {
        d = a - b; if (d < 0) d = -d; m = b < 0 ? -b : b
        exit !(a != "" && b != "" && d <= t * m) }' ||
        fail "$1 is not $2 to $3: $(cat out)"
}

cat >contact.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
mean_speed = 1 m/s
[lubricant]
alpha = 20 1/GPa
viscosity = 40 mPa.s
[domain]
level = 5
END
cat >dent.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.2
[domain]
level = 5
[time]
end = 6.4
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4.6
END

# Scales and formulas (w = 2 pi R ph^2/E', lambda and alphabar of M and L by
# their definitions in SciPy), nothing solved
closed() { # VALUE UNIT QUESTION...
    value=$1 unit=$2
    shift 2
    expect 0 "$OVERROLL" find "$@" --json
    contains out '"found": true'
    contains out '"level": 0'
    close "$(awk -v v="$(number value)" -v f="$unit" \
        'BEGIN { printf "%.17g", v * f }')" "$value" 1e-9
}
closed 500430.6881824449 1000 contact.ini contact.load between 50 and 800 kN/m \
    so that hertz_pressure_Pa is 1.5 GPa
closed 0.010790705141630504 0.001 contact.ini contact.radius between 2 mm \
    and 50 mm so that hertz_pressure_Pa = 1 GPa
closed 8.407486824596893 1 dent.ini contact.L between 2 and 30 so that \
    alphabar is 15
closed 19.23824745242796 1 dent.ini contact.M between 2 and 50 so that \
    'lambda=0.01'
expect 0 "$OVERROLL" find contact.ini largest contact.load between 50 and \
    800 kN/m so that 'hertz_pressure_Pa <= 1.5 GPa' --json
close "$(number value)" 500.4306881824449 1e-9
"$OVERROLL" check contact.ini --set "contact.load=$(number value) kN/m" --json |
    awk '/"hertz_pressure_Pa"/ { exit !($2 + 0 <= 1.5e9) }' ||
    fail 'the largest that was told is too large'

# Of runs: what is told has been run, on the right side, and a step farther it
# does not hold
H_min_at() { # DEPTH
    "$OVERROLL" run dent.ini --set "feature.dent.depth=$1" --json |
        sed -n 's/^  "H_min_overall": \(.*\),/\1/p'
}
asked='feature.dent.depth between 0.01 and 0.5 so that H_min_overall'
# shellcheck disable=SC2086 # words
expect 0 "$OVERROLL" find dent.ini largest $asked is at least 0.05 --json -j 2 \
    --table made.csv
at=$(number value)
close "$(H_min_at "$at")" "$(number at_value)" 1e-15
[ "$(awk -F, '$2 != ""' made.csv | wc -l)" -ge 7 ] || fail "$(cat made.csv)"
awk -v a="$(number at_value)" -v b="$(H_min_at "$(number high)")" \
    'BEGIN { exit !(a >= 0.05 && b < 0.05) }' || fail "$(cat out)"
# shellcheck disable=SC2086
expect 0 "$OVERROLL" find dent.ini $asked is 0.05 --json
close "$(number value)" "$at" 1e-3
# its slope by two runs
one=$(H_min_at "$(echo "$at" | awk '{ print $1 * 0.99 }')")
other=$(H_min_at "$(echo "$at" | awk '{ print $1 * 1.01 }')")
close "$(number slope)" "$(awk -v a="$one" -v b="$other" -v at="$at" \
    'BEGIN { print (b - a)/(0.02 * at) }')" 0.1
# shellcheck disable=SC2086
expect 0 "$OVERROLL" find dent.ini $asked is 0.05 -v
contains out '^feature.dent.depth = 0[.0-9]* b.2/R$'
contains out '^minimum film thickness over the run +0.0[45].* b.2/R +.H_min'
name='minimum film thickness over the run'
contains out "^feature.dent.depth \(b.2/R\) +$name \(b.2/R\) +order level"

# Several: refused but with the largest or smallest (P_max rises and falls; it
# stands in a spike that the grid does not resolve, hence the mean is given)
ask='feature.dent.width between 0.1 and 3 so that P_max_overall'
# shellcheck disable=SC2086
expect 2 "$OVERROLL" find dent.ini $ask is 1.8 \
    --set domain.faces=gap
contains err 'P_max_overall is 1.8 at [23] values, between .*largest'
# shellcheck disable=SC2086
expect 0 "$OVERROLL" find dent.ini largest $ask at least 1.8 --json \
    --set domain.faces=gap
awk -v v="$(number value)" -v a="$(number at_value)" \
    'BEGIN { exit !(a >= 1.8 && v > 1.05 && v < 1.6) }' || fail "$(cat out)"

# An end that cannot be run (on level 5 it can) is left out, and said
expect 0 "$OVERROLL" find dent.ini contact.M between 0.001 and 200 so that \
    H_min is 0.1 --steady --level 7
contains err \
    'warning: below 0.02[0-9]*: the (steady solution did not|surfaces touch)'

# A run that is stopped
"$OVERROLL" find dent.ini feature.dent.depth between 0.01 and 0.5 so that \
    H_min_overall is 0.05 --level 9 >out 2>err &
sleep 1
kill -INT $!
wait $!
[ $? -eq 130 ] || fail "stopped by SIGINT it is no 130: $(cat out err)"

# With a folder the results are kept; stopped in the middle of a run and asked
# again, what is there is not run again, and the answer is the same
ask='feature.dent.depth between 0.02 and 0.3 so that H_min_overall is 0.05'
# shellcheck disable=SC2086
expect 0 "$OVERROLL" find dent.ini $ask --json --level 7
sed '/seconds/d' out >alone
# shellcheck disable=SC2086
"$OVERROLL" find dent.ini $ask --level 7 --results kept.d >out 2>err &
for _ in $(seq 1000); do
    [ -e kept.d/depth=0.0393597934253086.h5.restart ] && break
    sleep 0.01
done
first=$!
# shellcheck disable=SC2086
refuses 'kept.d: another find uses this folder' \
    find dent.ini $ask --level 7 --results kept.d
kill -INT $first
wait $first
# shellcheck disable=SC2086
expect 0 "$OVERROLL" find dent.ini $ask --json --level 7 --results kept.d
sed '/seconds/d' out | cmp - alone || fail 'found in two goes it is another'
[ "$(find kept.d -name '*.h5' | wc -l)" -gt 6 ] || fail "$(ls kept.d)"
expect 0 "$OVERROLL" info kept.d/depth=0.02.h5
rows=$(wc -l <kept.d/find.csv)
stamp=$(cksum kept.d/*.h5)
# shellcheck disable=SC2086
expect 0 "$OVERROLL" find dent.ini $ask --json --level 7 --results kept.d
sed '/seconds/d' out | cmp - alone || fail 'found twice it is another'
[ "$(wc -l <kept.d/find.csv)" -eq "$rows" ] || fail 'runs were made again'
[ "$(cksum kept.d/*.h5)" = "$stamp" ] || fail 'results were written again'
# shellcheck disable=SC2086
refuses 'kept.d: contains results of another question' \
    find dent.ini $ask --level 6 --results kept.d

# What is refused, and what would be right
depth='dent.ini feature.dent.depth between'
# shellcheck disable=SC2086
expect 2 "$OVERROLL" find $depth 0.01 and 0.05 so that H_min_overall is 0.05
contains err 'not reach 0.05; it falls with .*: extend the range above 0.05,'
contains err ', or change the limit'
# both values at the ends are those of runs
for depth_at in 0.01 0.05; do
    H=$(H_min_at $depth_at 2>/dev/null)
    contains err "$(printf '%.6g at %s' "$H" $depth_at)"
done
# a quantity far from the target
expect 2 "$OVERROLL" find $depth 0.01 and 0.02 so that H_min_overall is 2
contains err 'reach 2; it hardly changes with .*: change the limit or vary'
# shellcheck disable=SC2086
expect 2 "$OVERROLL" find $depth 0.2 and 0.5 so that H_min_overall is 0.05
contains err 'extend the range below 0.2, or change the limit'
# shellcheck disable=SC2086
expect 2 "$OVERROLL" find dent.ini largest feature.dent.depth between 0.01 \
    and 0.05 so that H_min_overall at least 0.05
contains err 'already holds at 0.05; extend the range above it'
# A number at the end of a run, where the extreme may be meant; not of the
# extreme itself, nor of a steady contact.
run_end='is the value at the end of the run'
for q in 'H_min at least 0' 'H_min_overall at least 0'; do
    # shellcheck disable=SC2086
    "$OVERROLL" find dent.ini largest feature.dent.depth between 0.01 \
        and 0.05 so that $q >out 2>err && fail "$q does not end"
    case $q in
    'H_min at'*) contains err "H_min $run_end; H_min_overall is the minimum" ;;
    *) ! grep "$run_end" err || fail "a note on $q" ;;
    esac
done
"$OVERROLL" find dent.ini largest contact.M between 20 and 30 \
    so that H_min at least 0 --steady >out 2>err && fail 'steady does not end'
! grep "$run_end" err || fail 'a note on a steady contact'
# (level 12 runs for minutes: refused before anything is solved)
asks() { # PATTERN QUESTION...
    pattern=$1
    shift
    refuses "$pattern" find "$@"
}
H='so that H_min_overall'
# shellcheck disable=SC2086
{
    asks 'not a result of this run; did you mean H_min_overall' \
        $depth 0.01 and 0.5 so that H_min_overal is 0.05
    asks 'T_max_rise: is not a result of this run; .* needs another section' \
        $depth 0.01 and 0.5 so that T_max_rise is 4
    asks 'H_minimum: is .* did you mean H_min_overall, or H_min .at the end' \
        $depth 0.01 and 0.5 so that H_minimum is 0.05 --level 12
    asks 'hmin: is .* did you mean H_min_overall, or H_min .at the end' \
        $depth 0.01 and 0.5 so that hmin is 0.3 um --level 12
    asks 'qqq: is not a result of this run; .overroll run CASE --json' \
        $depth 0.01 and 0.5 so that qqq is 1 --level 12
    asks '^feature.dent.dept: unknown key .dept. in .feature.; did you mean' \
        dent.ini feature.dent.dept between 0.01 and 0.5 $H is 0.05
    asks 'lambda_ratio_min needs roughness on the grid .*use lambda_ratio' \
        $depth 0.01 and 0.5 so that lambda_ratio_min is 1 --level 12
    asks 'lambda_ratio needs the roughness .*contact.Rq_1 and contact.Rq_2' \
        $depth 0.01 and 0.5 so that lambda_ratio is 1 --level 12
    asks 'largest .*the condition .* must contain at most or at least' \
        dent.ini largest \
        feature.dent.depth between 0.1 and 0.5 $H is 0.05
    asks '^overroll: largest or smallest is missing before feature.dent.depth' \
        $depth 0.1 and 0.5 $H at most 0.05
    asks 'cannot be measured in um' $depth 0.1 and 0.5 so that P_max is 2 um
    asks 'unknown unit' $depth 0.1 and 0.5 so that P_max is 2 furlongs
    asks 'the ends must differ' $depth 0.1 and 0.1 $H is 0.05
    asks 'must be a number' $depth little and much $H is 0.05
    asks "must be .largest" $depth 0.1 to 0.5 $H is 0.05
    asks 'is a choice, not a number' dent.ini feature.dent.shape between 1 \
        and 2 $H is 0.05
    asks 'use a study' dent.ini domain.level between 4 and 6 $H is 0.05
    asks 'needs a unit' contact.ini contact.load between 50 and 500 $H is 0.05
    asks 'same unit' contact.ini contact.load between 50 N/m and 5 kN/m $H is 1
    asks 'set domain.level' $depth 0.1 and 0.5 $H is 0.05 --level auto
    asks 'tolerance: must be' $depth 0.1 and 0.5 $H is 0.05 --tolerance 2
    asks 'whole number' $depth 0.1 and 0.5 $H is 0.05 -j 0
    asks "did you mean 'depth'" dent.ini feature.dent.detph between 1 and 2 \
        $H is 1
}
# a number below zero is no option
expect 2 "$OVERROLL" find dent.ini contact.slide_to_roll between -0.5 and 0.5 \
    so that H_min is 9 --steady
contains err '; it does not reach 9'

# In a study: a curve; the table has a column of the key's name; a case that
# was stopped is resumed from its evaluations
cat >curve.ini <<'END'
[study]
case = dent.ini
[product]
contact.slide_to_roll = 0, 0.2
[find]
key = feature.dent.depth
between = 0.01, 0.5
so_that = H_min_overall >= 0.05
which = largest
END
expect 0 "$OVERROLL" sweep curve.ini -j 2 -q
expect 0 "$OVERROLL" sweep curve.ini --collect curve.csv -q
column() { # NAME TABLE ROW
    awk -F, -v name="$1" -v row="$3" 'NR == 1 { for (k = 1; k <= NF; k++)
        if ($k == name) c = k } NR == row + 1 { print $c }' "$2"
}
close "$(column feature.dent.depth curve.csv 2)" "$at" 1e-3
case=curve/slide_to_roll=0.2
without_time() { # TABLE: without the columns of times
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) time[k] = $k ~ /^seconds/ }
        { for (k = 1; k <= NF; k++) if (!time[k]) printf "%s,", $k
          print "" }' "$1"
}
without_time curve.csv >whole
rows=$(wc -l <"$case.find.csv")
head -n 5 "$case.find.csv" >kept
cp kept "$case.find.csv"
printf '0.3,0.0' >>"$case.find.csv" # a row that was being written
sed -i '/^slide_to_roll=0.2,/d' curve/cases-*.csv
rm curve/cases.index
expect 3 "$OVERROLL" sweep curve.ini --collect curve.csv
contains out '1 stopped'
sed 's/>= 0.05/>= 0.04/' curve.ini >other.ini
expect 3 "$OVERROLL" sweep other.ini -o curve --collect other.csv
contains out '2 changed'
expect 0 "$OVERROLL" sweep curve.ini -q
[ "$(wc -l <"$case.find.csv")" -eq "$rows" ] || fail 'other evaluations'
head -n 5 "$case.find.csv" | cmp - kept || fail 'evaluations were run again'
expect 0 "$OVERROLL" sweep curve.ini --collect curve.csv -q
without_time curve.csv | cmp - whole || fail 'resumed it differs'
# killed with its processes in the middle of a search
setsid "$OVERROLL" sweep curve.ini -o killed -j 1 -q >/dev/null 2>&1 &
tries=0
until [ "$(cat killed/*.find.csv 2>/dev/null | wc -l)" -ge 4 ]; do
    tries=$((tries + 1))
    [ $tries -lt 3000 ] || fail 'no evaluation is written'
    sleep 0.01
done
kill -9 "-$!" 2>/dev/null
wait $! 2>/dev/null
for _ in $(seq 100); do
    "$OVERROLL" sweep curve.ini -o killed -q && break
    sleep 0.1 # a process that was killed may still hold locks
done
expect 0 "$OVERROLL" sweep curve.ini -o killed --collect killed.csv -q
without_time killed.csv | cmp - whole || fail 'killed and resumed it differs'
# without result files no files of single cases remain, and the table is equal
sed 's/^case = .*/&\nresults = no/' curve.ini >rows.ini
expect 0 "$OVERROLL" sweep rows.ini -q
expect 0 "$OVERROLL" sweep rows.ini --collect rows.csv -q
without_time rows.csv | cmp - whole || fail 'without files it differs'
[ -z "$(find rows -name 'slide*')" ] || fail "files of cases: $(ls rows)"
# another question is another case
mv other.ini curve.ini
expect 3 "$OVERROLL" sweep curve.ini --collect curve.csv
contains out '2 changed'

wrong() { # PATTERN LINES
    printf '[study]\ncase = dent.ini\n[find]\n%b' "$2" >wrong.ini
    refuses "$1" sweep wrong.ini
}
wrong 'between is missing' 'key = contact.M\nso_that = H_min is 1\n'
wrong "did you mean 'so_that'" 'sothat = H_min is 1\n'
wrong 'two numbers' 'key = contact.M\nbetween = 3\nso_that = H_min is 1\n'
wrong 'wrong.ini:6: .*largest or smallest is missing' \
    'key = contact.M\nbetween = 3, 5\nso_that = H_min <= 1\n'

# A folder of results serves one find at a time.
"$OVERROLL" find dent.ini feature.dent.depth between 0.02 and 0.2 \
    so that H_min_overall is 0.06 --results shared -q --level 8 >first 2>&1 &
first=$!
tries=0
until [ -e shared/question.lock ]; do
    tries=$((tries + 1))
    [ $tries -lt 100 ] || fail "no search: $(cat first)"
    sleep 0.05
done
refuses 'shared: another find uses this folder; wait' find dent.ini \
    feature.dent.depth between 0.02 and 0.2 so that H_min_overall is 0.06 \
    --results shared -q --level 8
kill $first
wait $first || true
