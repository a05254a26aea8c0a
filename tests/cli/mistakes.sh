#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A first-time user's mistakes: one clear line each, exit code 2.
. "$TOP/tests/support/cli.sh"

refuses "no command 'stedy'; did you mean 'steady'" stedy
refuses "unknown option '--levl'; did you mean '--level'" steady --levl 3
refuses "option '--level' needs a value" steady --level
refuses "option '--level' is given twice" steady --level 3 --level=4
refuses "option '--json' takes no value" steady --json=1
refuses "unexpected 'b'" steady a b
refuses 'nowhere.ini: cannot read the case: No such file' steady nowhere.ini
refuses '/: cannot read the case: Is a directory' steady /
refuses 'load is missing: give M and L' steady
refuses '^--M: L is missing' steady --M 20
refuses '^--M: M: -20 must be 0.001 to 1000000' steady --M -20 --L 10
refuses '^--M: M: .nan. is not a number' steady --M nan --L 10
refuses '^--level: level: 99 must be 1 to' steady --M 20 --L 10 --level 99
memory=$(sed -n 's/^MemTotal: *\([0-9]*\) kB/\1/p' /proc/meminfo 2>/dev/null)
if [ "${memory:-999999999}" -lt 28000000 ]; then # level 23 takes 24.4 GB
    refuses '^--level: level: 23 takes about .* GB of memory' \
        steady --M 20 --L 10 --level 23
fi
refuses '^--scheme: scheme: unknown .upstream3.; did you mean' \
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
refuses '^both.ini:4: load cannot stand beside M and L' check both.ini
head -c 3000000 /dev/zero | tr '\0' '\n' >long.ini
refuses '^long.ini: is longer than a case may be' check long.ini
head -c 3000 /dev/zero >nul.ini
refuses '^nul.ini: is not a case file' check nul.ini

expect 0 "$OVERROLL"
[ "$(wc -l <out)" -eq 10 ] || fail "not ten lines: $(cat out)"
contains out 'overroll steady --M 20 --L 10'
