#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Files of other programs are replaced only with --force: tables of find and
# sweep, the manifest, cases of samples, profiles after wear. Workers end if
# their parent is killed, and the study is resumed.
. "$TOP/tests/support/cli.sh"
need_python h5py

cat >contact.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
END
cat >study.ini <<'END'
[study]
case = contact.ini
output = d
[random]
draws = 8
contact.M = uniform 15 to 25
END

# kept PATTERN FILE ARGUMENTS...: refused, and the file is as it was; replaced
# with --force, and then without.
kept() {
    pattern=$1 file=$2
    shift 2
    printf 'my notes\n' >"$file"
    refuses "$pattern" "$@"
    [ "$(cat "$file")" = 'my notes' ] || fail "$file is replaced"
    expect 0 "$OVERROLL" "$@" --force
    ! grep -q 'my notes' "$file" || fail "$file is not replaced with --force"
    expect 0 "$OVERROLL" "$@"
}

kept 'table.csv: exists and was not written' table.csv find contact.ini \
    contact.M between 10 and 30 so that H_min is 0.1 --table table.csv
mkdir d
kept 'd/draw-0003.ini: exists and is not a case' d/draw-0003.ini sweep study.ini
kept 'd/manifest.csv: exists and was not written' d/manifest.csv sweep study.ini
kept 'exists and was not written' all.csv sweep study.ini --collect all.csv
kept 'exists and was not written' all.nc sweep study.ini --collect all.nc
printf 'my notes\n' >d/summary.csv
refuses 'd/summary.csv: exists and was not written' sweep study.ini --statistics
expect 0 "$OVERROLL" sweep study.ini --statistics --force

# A result is an HDF5 file, but no table of cases.
expect 0 "$OVERROLL" run contact.ini --set time.end=0.5 -q -o result.h5
cp result.h5 before.h5
refuses 'exists and is not a table' sweep study.ini --collect result.h5
cmp result.h5 before.h5 || fail 'the result is replaced'

# What fails in all draws alike is printed once, and nothing runs.
cat >twice.ini <<'END'
[study]
case = contact.ini
output = twice
[random]
draws = 8
contact.load = uniform 300 kN/m to 400 kN/m
END
refuses 'all 8 draws: ' sweep twice.ini
[ ! -e twice/draw-0001.ini ] || fail 'a case was begun'

# A quantity under two names is overridden as one.
cat >physical.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
mean_speed = 1 m/s
viscosity = 40 mPa.s
alpha = 20 1/GPa
[domain]
level = 4
END
cat >oils.ini <<'END'
[study]
case = physical.ini
results = no
output = oils
[random]
draws = 8
lubricant.viscosity = uniform 30 mPa.s to 50 mPa.s
END
expect 0 "$OVERROLL" sweep oils.ini
contains out '^8 cases: 8 finished'
expect 0 "$OVERROLL" check physical.ini --set "lubricant.alpha=15 1/GPa"

# Profiles of bodies that yield, in a run of several passes
expect 0 "$OVERROLL" init indented --set domain.level=5 -o indented.ini
sed -i 's/^passes = 3.*/passes = 1\nprofiles = shape/' indented.ini
echo 'mine' >shape-after.csv
refuses 'shape-after.csv: .*--force' run indented.ini -o passes.h5
grep -qx mine shape-after.csv || fail 'a foreign profile was replaced'

# Control characters in the name of a file
strange=$(printf 'a\033[31mb.h5')
cp result.h5 "$strange"
expect 0 "$OVERROLL" info "$strange"
contains out '^a.x1b\[31mb\.h5: '
! grep -q "$(printf '\033')" out || fail 'info prints an escape sequence'

# Workers of a killed parent
cat >long.ini <<'END'
[study]
case = contact.ini
output = long
[product]
time.end = 50000, 60000, 70000
END
"$OVERROLL" sweep long.ini -j 2 -q >out 2>err &
sweep=$!
for file in long/end=50000.h5 long/end=60000.h5; do
    begins "$file"
done
workers=$(ps -o pid= --ppid $sweep)
[ "$(echo "$workers" | wc -l)" -eq 2 ] || fail "workers: $workers"
kill -KILL $sweep
wait $sweep 2>/dev/null
for worker in $workers; do
    tries=0
    while kill -0 "$worker" 2>/dev/null; do
        case $(ps -o stat= -p "$worker") in Z*) break ;; esac
        tries=$((tries + 1))
        [ $tries -lt 100 ] || fail "worker $worker works on without a parent"
        sleep 0.1
    done
done
