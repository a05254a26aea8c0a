#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# resume: the same result as without interruption; rejected changes, after
# which the file is unchanged; a lost checkpoint; a longer run.
. "$TOP/tests/support/cli.sh"

dent_case 5 3 0.1 1 -3.9 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 2
END

same() {
    content "$1" >1.txt
    content "$2" >2.txt
    cmp 1.txt 2.txt || fail "$1 and $2 differ"
}

expect 0 "$OVERROLL" run dent.ini -o whole.h5 -q
expect 0 "$OVERROLL" run dent.ini -o short.h5 -q --set time.end=1
cp short.h5 kept.h5 && cp short.h5.restart kept.h5.restart

# What it refuses
refuses '^nowhere.h5: No such file' resume nowhere.h5
refuses '^dent.ini: is not an HDF5 file' resume dent.ini
refuses "'contact.M' was '20' and is now '21'" \
    resume short.h5 --set contact.M=21
refuses "'feature dent.depth' was '0.1' and is now '0.2'" \
    resume short.h5 --set 'feature dent.depth=0.2'
refuses 'other nodes' \
    resume short.h5 --set output.stride=2 --set time.end=2
cmp short.h5 kept.h5 || fail 'a refusal changed the file'
cmp short.h5.restart kept.h5.restart || fail 'a refusal changed the checkpoint'

# Longer, in two pieces
expect 0 "$OVERROLL" resume short.h5 --set time.end=2
contains err 'continuing from T = 1'
expect 0 "$OVERROLL" resume short.h5 --set time.end=3 -q --json
contains out '"converged": true'
same whole.h5 short.h5

# The report of a complete run is the same again, but for times of the computer.
expect 0 "$OVERROLL" run dent.ini -o report.h5 -v --set time.end=3
grep -v '^computing time' out >report.txt
expect 0 "$OVERROLL" resume report.h5 -v
grep -v '^computing time' out | diff report.txt - || fail 'another report'

# Nothing left to do: the file is not touched, with or without a checkpoint
cp -p short.h5 before.h5
expect 0 "$OVERROLL" resume short.h5 --json
contains err 'already complete'
contains out '"T_end": 3'
cmp short.h5 before.h5 || fail 'a complete file was written to'
mv short.h5.restart elsewhere
expect 0 "$OVERROLL" resume short.h5
contains err '^short.h5: run is already complete'
expect 0 "$OVERROLL" resume short.h5 --force
expect 0 "$OVERROLL" resume short.h5 --from-start
refuses 'no checkpoint.*--from-start --force' \
    resume short.h5 --set time.end=4 --force
cmp short.h5 before.h5 || fail 'a complete file was begun again'
[ ! -e short.h5.restart ] || fail 'a complete file has a checkpoint again'
sed "/^\[time\]/,/^end/d" dent.ini >steady.ini
expect 0 "$OVERROLL" run steady.ini -o steady.h5 -q
rm steady.h5.restart
expect 0 "$OVERROLL" resume steady.h5
contains err 'already complete'

# A damaged checkpoint is refused; a lost one means to begin again, if asked
dd if=/dev/zero of=kept.h5.restart bs=1 count=4 seek=300 conv=notrunc \
    2>/dev/null
refuses '^kept.h5.restart: is damaged' resume kept.h5 --set time.end=3
rm kept.h5.restart
refuses 'no checkpoint.*--from-start --force' resume kept.h5 --set time.end=3
expect 0 "$OVERROLL" resume kept.h5 --set time.end=3 --from-start --force
contains err 'no checkpoint; the run starts again'
same whole.h5 kept.h5

# The checkpoint of another run
expect 0 "$OVERROLL" run dent.ini -o other.h5 -q --set time.end=1
cp other.h5.restart whole.h5.restart
refuses 'is from another run' resume whole.h5

# A profile that has changed
printf 'x_um,z_um\n0,0\n100,0\n200,-0.2\n300,0\n400,0\n' >p.csv
cat >profile.ini <<'END'
[contact]
load = 50 kN/m
radius = 10 mm
modulus = 220 GPa
viscosity = 40 mPa.s
speed_1 = 1 m/s
speed_2 = 1 m/s
[lubricant]
alpha = 20 1/GPa
[domain]
level = 4
[time]
end = 3
[feature p]
shape = profile
file = p.csv
start = -2
END
expect 0 "$OVERROLL" run profile.ini -o p.h5 -q
printf 'x_um,z_um\n0,0\n100,0\n200,-0.3\n300,0\n400,0\n' >p.csv
refuses "restore the original profile file" resume p.h5 --set time.end=4

# A start that needed domain.faces = gap: the equations of all steps are those
cat >gap.ini <<'END'
[contact]
M = 20
L = 33
[domain]
level = 6
[time]
end = 0.06
END
for case in 'contact.M=12 --set contact.L=60' strip.width=1; do
    rm -f ./gap*.h5*
    expect 0 "$OVERROLL" run gap.ini -o gap.h5 --set $case
    # Rounding decides whether a strategy before it succeeds.
    case $BUILD in *-san*) ;; *) contains err 'domain.faces = gap' ;; esac
    expect 0 "$OVERROLL" run gap.ini -o gap_part.h5 -q --set $case \
        --set time.end=0.03
    expect 0 "$OVERROLL" resume gap_part.h5 -q --set time.end=0.06
    same gap.h5 gap_part.h5
done

# A start that failed has no state: the domain, longer for a high feature, is
# chosen again, and is that of the file
cat >high.ini <<'END'
[contact]
M = 1.9
L = 1.5
[domain]
level = 4
[strip]
width = 1.1
[feature w]
shape = wave
amplitude = 1
wavelength = 0.55
wavelength_across = 0.55
[solver]
max_cycles = 1
END
expect 0 "$OVERROLL" check high.ini --json
[ "$(number outlet)" != 1.5 ] || fail 'no feature moves the outlet'
expect 1 "$OVERROLL" run high.ini -o high.h5 -q
expect 1 "$OVERROLL" resume high.h5
contains err 'the run starts again'
exit 0
