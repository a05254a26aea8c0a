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
