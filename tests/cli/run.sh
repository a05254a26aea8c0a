#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run: documented keys, the result file, input rejected before the solution,
# stop by signal.
. "$TOP/tests/support/cli.sh"

dent_case 5 0.5 0.1 1 -4.9 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 2
END

# A summary alone
expect 0 "$OVERROLL" run dent.ini --json
for key in converged M L alphabar hertz_pressure_Pa nodes level scheme \
    smoother H_min X_min H_cen H0 P_max X_P_max P_spike X_spike load \
    mass_flow residual cycles seconds steps steps_marked T_end \
    H_min_overall T_H_min cycles_total snapshots output; do
    contains out "^ *\"$key\": "
done
contains out '"output": null'
contains out '"steps_marked": 0'
contains err '^ 5[0-9] %'
[ "$(grep -c '%' err)" -eq 10 ] || fail "not ten lines of progress: $(cat err)"

# A result file; not over another one
expect 0 "$OVERROLL" run dent.ini -o a.h5 -q
[ ! -s err ] || fail "-q says: $(cat err)"
refuses '^a.h5: exists already; --force' run dent.ini -o a.h5
expect 0 "$OVERROLL" run dent.ini -o a.h5 --force --json
contains out '"output": "a.h5"'
contains out '"snapshots": [1-9][0-9]'
expect 0 "$OVERROLL" info a.h5
contains out 'complete'

# [output] file is beside the case
mkdir sub
{ cat dent.ini; echo 'file = b.h5'; } >sub/b.ini
expect 0 "$OVERROLL" run sub/b.ini
[ -f sub/b.h5 ] || fail 'no sub/b.h5'

# A case without [time] end is steady
expect 0 "$OVERROLL" run dent.ini --set time.end=0.1 --json
sed '/^end/d' dent.ini >steady.ini
expect 0 "$OVERROLL" run steady.ini --json
contains out '"converged": true'
grep -q '"steps"' out && fail 'a steady case has steps'

# Outputs that cannot be made
refuses '^nodir/a.h5: cannot be written: nodir: No such' \
    run dent.ini -o nodir/a.h5
refuses 'is not a file name' run dent.ini -o sub/
refuses 'the input file is missing' run

# SIGINT and SIGTERM: step finished, file closed, 130 and 143
for signal in INT TERM; do
    rm -f c.h5*
    "$OVERROLL" run dent.ini --level 7 --set time.end=1000 -o c.h5 \
        >out 2>err &
    pid=$!
    begins c.h5
    kill -s $signal $pid
    code=0
    wait $pid || code=$?
    case $signal in
    INT) wanted=130 ;;
    TERM) wanted=143 ;;
    esac
    [ "$code" -eq "$wanted" ] || fail "SIG$signal: exit code $code: $(cat err)"
    contains err "stopped by signal .*; 'overroll resume c.h5' continues the"
    expect 0 "$OVERROLL" info c.h5
    contains out 'stopped'
    refuses "^c.h5: exists already and is not .*'overroll resume c.h5' cont" \
        run dent.ini -o c.h5
done
# resume does continue it, without a change and to a nearer end
at=$("$OVERROLL" info c.h5 --json | sed -n 's/^  "T": \(.*\),/\1/p')
expect 0 "$OVERROLL" resume c.h5 --set "time.end=$(
    awk -v at="$at" 'BEGIN { print at + 0.1 }')"
contains err 'continuing from T'
refuses '^c.h5: exists already; --force' run dent.ini -o c.h5
# without a file there is nothing to resume
"$OVERROLL" run dent.ini --level 7 --set time.end=1000 -v >out 2>err &
pid=$!
tries=0
until grep -q '%' err; do
    tries=$((tries + 1))
    [ $tries -lt 2000 ] || fail 'no progress'
    sleep 0.01
done
kill -s TERM $pid
wait $pid
contains err 'stopped by signal 15 at T = [0-9.]*$'

# The same run a level coarser tells the error
cat >estimate.ini <<'E'
[contact]
M = 20
L = 10
[domain]
level = 6
[time]
end = 1
[feature dent]
shape = dent
depth = 0.05
width = 0.5
start = -4.6
E
expect 0 "$OVERROLL" run estimate.ini --estimate-error --json
for key in H_min H_cen P_max H_min_overall P_max_overall; do
    if grep -q "\"not_converging\": .*\"$key\"" out; then
        contains out "\"${key}_error\": null"
        contains out "\"${key}_error_relative\": null"
    else
        contains out "\"${key}_error\": [0-9.e-]+"
        contains out "\"${key}_error_relative\": [0-9.e-]+"
    fi
done
contains out '"H_cen_error": [0-9]'
contains out '"H_min_error": [0-9]'

# What does not converge with the level is said in words (the
# pressure where the bump leaves the contact: 1.74, 1.80, 2.09 ph).
cat >narrow.ini <<'END'
[contact]
M = 14.4
L = 12.4
slide_to_roll = -0.24
[domain]
level = 5
[time]
end = auto
[feature bump]
shape = bump
height = 0.098
width = 0.97
END
expect 0 "$OVERROLL" run narrow.ini --estimate-error
contains err 'P_max_overall: no error estimate, because the values [0-9.]+, '
contains out '^maximum pressure +over the run: does not converge with the level'
expect 0 "$OVERROLL" run narrow.ini -o narrower.h5 --estimate-error --json
contains out '"not_converging": \[ .*"P_max_overall"'

# From rest, and from no load: said, and done
cat >rest.ini <<'E'
[contact]
M = 20
L = 10
[domain]
level = 6
[time]
end = 0.5
step = adaptive
[speed]
history = ramp
from = 0
to = 1
duration = 2
E
expect 0 "$OVERROLL" run rest.ini
contains err 'starts from rest'
sed 's/speed/load/' rest.ini >unloaded.ini
expect 0 "$OVERROLL" run unloaded.ini
contains err 'starts without load'

# Of a physical case every Hertzian number has its physical one beside it (with
# this inlet and mean the levels 2 to 4 fall in order).
cat >physical.ini <<'END'
[contact]
load = 100 kN/m
radius = 10 mm
modulus = 220 GPa
viscosity = 40 mPa.s
speed_1 = 1 m/s
speed_2 = 1 m/s
[lubricant]
alpha = 20 1/GPa
[domain]
inlet = -5.25
level = 4
faces = arithmetic
[time]
end = 0.2
END
expect 0 "$OVERROLL" run physical.ini -o physical.h5 --estimate-error
contains out '^at the end, T = 0\.[0-9]+ \(0\.02[0-9]+ ms\)'
contains out '^minimum film thickness .* 0\.[0-9]+ +\([0-9.]+ um at .* um\)$'
contains out '^maximum pressure .* p_h .* \([0-9.]+ GPa at -?[0-9.]+ um'
contains out '^load integral +1\.57.* 100 kN/m'
contains out '^mass flow rate .* mm2/s'
contains out '^minimum film thickness .* \([0-9.]+ um at .* um, [0-9.]+ ms\)$'
contains out '^minimum film thickness +[0-9.e-]+ +% +.[0-9.e-]+ nm.$'
contains out '^maximum pressure +[0-9.e-]+ +% +\([0-9.e-]+ MPa, over the run\)$'
contains out '^estimated .* .from level 3 and the next coarser, time steps'
expect 0 "$OVERROLL" info physical.h5
contains out 't = 0 to 0\.02[0-9]+ ms$'
contains out ' at t, ms '
contains out '^minimum film thickness +[0-9.e-]+ .* [un]m +min_film_thickness$'
contains out '^Hertzian half-width b +[0-9.]+ um$'

# Progress: a line for each tenth in a file, nothing in a pipe but for -v
expect 0 "$OVERROLL" run dent.ini -o file.h5
[ "$(grep -c '^ *[0-9]* %  T = ' err)" -eq 10 ] || fail "progress: $(cat err)"
{ "$OVERROLL" run dent.ini -o quiet.h5 2>&1 >/dev/null; } | cat >piped
! grep ' %  T = ' piped || fail 'progress in a pipe'
{ "$OVERROLL" run dent.ini -o told.h5 -v 2>&1 >/dev/null; } | cat >piped
contains piped '^100 %  T = '
