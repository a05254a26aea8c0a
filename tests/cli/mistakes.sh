#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Mistakes of a first-time user: one clear line each, exit code 2.
. "$TOP/tests/support/cli.sh"

refuses "no command 'stedy'; did you mean 'steady'" stedy
refuses "unknown option '--levl'; did you mean '--level'" steady --levl 3
refuses "option '--level' needs a value" steady --level
refuses "option '--level' is given twice" steady --level 3 --level=4
refuses "option '--json' has no value" steady --json=1
refuses "unexpected 'b'" steady a b
refuses 'nowhere.ini: cannot read the case: No such file' steady nowhere.ini
refuses '/: cannot read the case: Is a directory' steady /
refuses 'load is missing; set M and L' steady
refuses '^--M: L is missing' steady --M 20
refuses '^--M: -20 must be 0.001 to 1000000' steady --M -20 --L 10
refuses '^--M: .nan. is not a number' steady --M nan --L 10
refuses '^--level: 99 must be 1 to' steady --M 20 --L 10 --level 99
refuses '^--level: level 23 cannot be solved in double precision' \
    steady --M 20 --L 10 --level 23
refuses '^--scheme: unknown .upstream3.; did you mean' \
    steady --M 20 --L 10 --scheme upstream3
refuses "^--set: unknown key 'leveel' in \[domain\]; did you mean 'level'" \
    steady --M 20 --L 10 --set domain.leveel=3
refuses '^--set: unknown section \[domian\]; did you mean \[domain\]' \
    steady --M 20 --L 10 --set domian.level=3

printf '[contact]\nM = 20\nL = 10\n\n[lubricant]\nalpha = 22 1/GP\n' >unit.ini
refuses "^unit.ini:6: alpha: '22 1/GP': unknown .*; did you mean '1/GPa'" \
    steady unit.ini
printf '[lubricant]\nviscocity = 3\n' >key.ini
refuses "^key.ini:2: unknown key 'viscocity' in \[lubricant\]; did you mean \
'viscosity'\?" check key.ini
printf '[contact]\nM = 20\nL = 10\nload = 3 kN/m\n' >both.ini
refuses '^both.ini:4: load is already determined by M and L' check both.ini
head -c 3000000 /dev/zero | tr '\0' '\n' >long.ini
refuses '^long.ini: is too long for a case' check long.ini
head -c 3000 /dev/zero >nul.ini
refuses '^nul.ini: is not a case file' check nul.ini

# A case is no study, and a study no case; a shape is no section.
printf '[contact]\nM = 20\nL = 10\n' >case.ini
printf '[study]\ncase = case.ini\n[product]\n' >study.ini
refuses '^case.ini:1: .contact. is a section of a case: .*overroll run' \
    sweep case.ini
for verb in run steady check; do
    refuses '^study.ini:1: .study. is a section of a study: .*overroll sweep' \
        $verb study.ini
done
cp study.ini range.ini
echo 'contact.M = 10 to 40 in 4' >>range.ini
refuses "^range.ini:4: .* did you mean 'linear 10 to 40 in 4'" sweep range.ini
printf '[set]\ncontact.L = 5\n[zip]\ncontact.M = 1\ncontact.G = 1, 2\n' |
    cat study.ini - >values.ini
refuses 'contact.G has 2 values, but contact.M has 1' sweep values.ini
printf '[zip]\ncontact.M = 1, 2\ncontact.G = 1\n' | cat study.ini - >one.ini
refuses 'contact.G has 1 value, but contact.M has 2' sweep one.ini
refuses 'unknown section .dent.; did you mean .feature dent.' \
    check case.ini --set dent.depth=0.1
refuses "'80 C': unknown unit 'C'; did you mean 'degC'" \
    check case.ini --set 'heat.temperature=80 C'
refuses "feature 'd': an indent needs its depth" \
    check case.ini --set feature.d.shape=indent --set feature.d.width=1
# A number in units of the contact is the number.
expect 0 "$OVERROLL" check case.ini --set 'domain.inlet=-5 b' --set \
    'time.end = 2 b/um' --set feature.d.shape=dent --set \
    'feature.d.depth = 0.1 b^2/R' --set 'feature.d.width_half=0.25 b' -q
refuses "'5 b/um': unknown unit 'b/um'" \
    check case.ini --set 'domain.inlet=5 b/um'
# What is meant by half a name
expect 0 "$OVERROLL" run case.ini -o none.h5 -q --set time.end=0.1 \
    --set domain.level=4 --set output.every=1
refuses "no field 'presure'; did you mean 'pressure'" \
    export none.h5 --field presure --all
refuses "no map of 'presure'.*did you mean 'pressure'" \
    plot none.h5 --kind map --field presure -o none.svg
refuses 'quantity draws studies' plot none.h5 --quantity H_min -o none.svg
# Words that are neither command nor key
for topic in friction Hertz rpm torque study film life grease units dent; do
    expect 0 "$OVERROLL" help $topic
    [ "$(wc -l <out)" -gt 3 ] || fail "little on $topic"
done
expect 0 "$OVERROLL" help units
for unit in cSt g/cm3 W/m.K degC rpm inch; do
    grep -qF "$unit" out || fail "help units lacks $unit"
done
expect 0 "$OVERROLL" help width
contains out 'width_half over width: dent 0.2478, bump 0.2478, indent'

expect 0 "$OVERROLL"
[ "$(wc -l <out)" -eq 10 ] || fail "not ten lines: $(cat out)"
contains out 'overroll steady --M 20 --L 10'
