#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The test runner counts tests that failed, crashed, hung, or printed no result.
. "$TOP/tests/support/cli.sh"

# program NAME COMMANDS: one that is counted by its TAP output, like cmocka's.
program() {
    printf '#!/bin/sh\n%s\n' "$2" >"$1"
    chmod +x "$1"
}

# counts CODE SUMMARY TEST...: what the runner makes of these tests.
counts() {
    code=$1 summary=$2
    shift 2
    expect "$code" "$TOP/tests/support/run" -j 2 -o log "$@"
    [ "$(tail -n 1 out)" = "$summary" ] || {
        cat out
        fail "'$*' is not counted as '$summary'"
    }
}

program good 'echo 1..2; echo ok 1 - a; echo ok 2 - b'
program bad 'echo 1..2; echo ok 1 - a; echo not ok 2 - b; exit 1'
program skipping 'echo 1..2; echo ok 1 - a; echo "not ok 2 # SKIP b"'
program crashing 'echo 1..4; echo ok 1 - a; kill -SEGV $$'
program leaking 'echo 1..1; echo ok 1 - a; exit 23'
program early 'echo 1..3; echo ok 1 - a; exit 0'
program mute 'exit 0'
program good.sh 'exit 0'
program bad.sh 'echo why; exit 1'
program skipped.sh 'echo why; exit 77'
# shellcheck disable=SC2016 # expanded there
program scratch.sh '[ -z "$(ls -A)" ] && : >file'
program hanging.sh 'sleep 60'

counts 0 '2 passed, 0 failed' good
counts 1 '1 passed, 1 failed' bad
counts 0 '1 passed, 0 failed, 1 skipped' skipping
counts 1 '1 passed, 3 failed' crashing
counts 1 '1 passed, 1 failed' leaking
counts 1 '1 passed, 2 failed' early
counts 1 '0 passed, 1 failed' mute
counts 1 '0 passed, 1 failed' absent
counts 0 '1 passed, 0 failed' good.sh
counts 1 '0 passed, 1 failed' bad.sh
contains out '\| why'
counts 0 '0 passed, 0 failed, 1 skipped' skipped.sh
counts 0 '1 passed, 0 failed' scratch.sh
if command -v timeout >/dev/null; then
    export TEST_SECONDS=1
    counts 1 '0 passed, 1 failed' hanging.sh
    contains out ' 1 FAILED \(timed out after 1 s \(TEST_SECONDS\)\)$'
    program early.sh 'exit 124'
    TEST_SECONDS=60 counts 1 '0 passed, 1 failed' early.sh
    contains out ' 1 FAILED \(exit code 124\)$'
fi
counts 1 '5 passed, 5 failed, 1 skipped' good bad crashing good.sh bad.sh \
    skipped.sh

# How many there are and how long it will take, then one after the other.
expect 0 "$TOP/tests/support/run" -n -j 2 -o foretold good good.sh skipped.sh
[ "$(cat out)" = '3 tests, 2 at a time: about 6 s' ] || fail "$(cat out)"
[ -z "$(find foretold -name '*.log')" ] || fail 'it runs what it foretells'
expect 0 "$TOP/tests/support/run" -j 1 -o foretold good good.sh skipped.sh
contains out '^3 tests, 1 at a time: about 12 s'
for k in 1 2 3; do
    contains out "^test   $k of 3 "
done
# The next time it is known better.
expect 0 "$TOP/tests/support/run" -n -o foretold good good.sh skipped.sh
contains out '^3 tests, 1 at a time: about [0-3] s'
