#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Too little memory for the program or libhdf5 is an error with a message and
# not a signal, for any limit.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "sanitizers reserve memory of their own"

cat >case.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 6
[time]
end = 0.5
[output]
every = 1
END
expect 0 "$OVERROLL" run case.ini -q -o whole.h5

# tried KB ARGUMENTS...: by an exit status of the program, or 127 if libraries
# cannot be loaded; what fails says why.
tried() {
    limit=$1
    shift
    status=0
    # shellcheck disable=SC3045 # dash and bash have it
    (ulimit -v "$limit" && exec "$OVERROLL" "$@") >out 2>err || status=$?
    case $status in
    0) succeeded=yes ;;
    1 | 2)
        failed=yes
        [ -s err ] || fail "ulimit -v $limit $*: no message"
        ;;
    127) grep -q 'shared librar\|cannot' err || fail "$(cat err)" ;;
    *) fail "ulimit -v $limit $*: status $status: $(cat err)" ;;
    esac
}

succeeded=no failed=no
for limit in $(seq 16000 1500 64000); do
    tried "$limit" run case.ini -q -o limited.h5 --force
    tried "$limit" info whole.h5
    tried "$limit" export whole.h5 -o whole.csv --force
done
[ "$succeeded $failed" = 'yes yes' ] ||
    fail "succeeded: $succeeded, failed: $failed"
