#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Without arguments: at most ten lines of help with two examples.  Commands and
# topics that do not exist: one line, exit code 2.
. "$TOP/tests/support/cli.sh"

expect 0 "$OVERROLL"
[ "$(wc -l <out)" -le 10 ] || fail "help is longer than ten lines: $(cat out)"
[ "$(grep -c '^  overroll ' out)" -eq 2 ] || fail "not two examples: $(cat out)"
[ ! -s err ] || fail "stderr: $(cat err)"

refuses nonsense nonsense
refuses nonsense help nonsense
refuses nonsense --nonsense
refuses . ''

# --json where there is a report; the other commands ignored it
for verb in export plot frames view init help; do
    refuses "^overroll $verb: --json is not an option of commands" $verb --json
    expect 0 "$OVERROLL" $verb --help
    ! grep -q -e '--json ' out || fail "$verb offers --json"
done
expect 0 "$OVERROLL" steady --help
contains out '^  --json  '

# -q drops the report, as the help states; with --json it is printed.
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 5 -q
[ ! -s out ] && [ ! -s err ] || fail "not quiet: $(cat out err)"
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 5 -q --json
[ -n "$(number H_min)" ] || fail "no JSON: $(cat out)"
expect 0 "$OVERROLL" steady --help
contains out '^  -q .* no report of a run'

# Without the page of make web --live names the files that it looked for.
mkdir -p tree/bin
cp "$OVERROLL" tree/bin/overroll
dent_case 4 0.2 0.1 0.5 -1 >dent.ini
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q
expect 2 tree/bin/overroll view dent.h5 --live -o dent.html
contains err '/tree/bin/web/overroll\.html or /.*/share/overroll/over.*: '
contains err 'run make web; .* then make install again$'
[ ! -e dent.html ] || fail 'a page without the program'

# An option of one letter in the other case
refuses "unknown option '--m'; did you mean '--M'" steady --m 20 --L 10
refuses "unknown option '--l'; did you mean '--L'" steady --M 20 --l 10
