# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# For the tests of power failure: a run is recorded, then the resuming of one
# that was killed, and STATES that the disk may be in when the machine dies
# meanwhile are made of each (tests/verify/crash_states.py, by SEED).  In each
# the result is not there yet, or it resumes to the same bits, and is read as
# the beginning of the true result or called cut.
. "$TOP/tests/support/kills.sh"

# record LOG ARGUMENT...: the program's writes, its clock going faster.
record() {
    log=$1
    shift
    RECORD=$log RECORD_NAME=a.h5 RECORD_SPEED="${SPEED:-50}" \
        LD_PRELOAD=./recorder.so "$OVERROLL" "$@" >out 2>err
}

# Of the folder $1: $unborn, $cuts or the list of readable ones grows.
look_at_state() {
    [ -f "$1/a.h5" ] || {
        unborn=$((unborn + 1))
        return
    }
    code=0 told=0
    "$OVERROLL" info "$1/a.h5" >out 2>err || code=$?
    "$OVERROLL" export "$1/a.h5" --all >/dev/null 2>err.all || told=$?
    ! grep -q 'contains no snapshot' err.all || told=0
    [ $code -eq $told ] || fail "$1: info ends with $code, export with $told"
    if [ $code -eq 0 ]; then
        cp "$1/a.h5" "$1/read.h5"
        echo "$1/read.h5" >>readable
    else
        grep -q 'was interrupted.*resume. restores' err || fail "$1: $(cat err)"
        cuts=$((cuts + 1))
    fi
    "$OVERROLL" resume "$1/a.h5" >out 2>err ||
        fail "$1: not resumed: $(cat err)"
    [ ! -e "$1/a.h5.journal" ] || grep -q 'already complete' err ||
        fail "$1: a journal is left"
    echo "$1/a.h5" >>resumed
}

# states NAME BEFORE COUNT SEED: of the log NAME.log.
states() {
    "$PYTHON" "$TOP/tests/verify/crash_states.py" "$1.log" "$2" "$1" "$3" \
        "$4" >"$1.count" || fail "states of $1"
    unborn=0 cuts=0 k=0
    while [ $k -lt "$3" ]; do
        look_at_state "$1/$k"
        k=$((k + 1))
    done
    echo "$1, seed $4: $(cat "$1.count"), $3 states: $unborn without" \
        "a result yet, $cuts called cut"
}

# shellcheck disable=SC2046 # words on purpose, names without blanks
power_test() {
    [ -z "$INSTRUMENTED" ] || skip "no preloading with sanitizers"
    need_python h5py numpy
    "$CC" -shared -fPIC -O1 -o recorder.so "$TOP/tests/verify/recorder.c" \
        -ldl -lpthread 2>log || skip "no preloading here"
    printf 'checkpoint = 3 s\n' >>dent.ini
    sed -i -e '/checkpoint = 10 ms/d' -e "s/^level = .*/level = ${LEVEL:-5}/" \
        -e "s/^end = .*/end = ${END:-6}/" dent.ini
    expect 0 "$OVERROLL" run dent.ini -o whole.h5 -q
    : >readable
    : >resumed
    mkdir nothing killed
    record run.log run dent.ini -o a.h5 -q || fail "recording: $(cat err)"
    states run nothing "$STATES" "$SEED"
    rm -f a.h5*
    half=$(awk '{ print int($1 / 2) }' run.count)
    (RECORD_KILL=$half record half.log run dent.ini -o a.h5 -q) 2>/dev/null
    cp a.h5* killed || fail 'not killed in the middle'
    record resume.log resume a.h5 -q || fail "recording: $(cat err)"
    states resume killed $((STATES / 2)) $((SEED + 1))
    "$PYTHON" compare.py whole.h5 $(cat readable) >out 2>&1 ||
        fail "what is read: $(tail -n 2 out)"
    "$PYTHON" compare.py --all whole.h5 $(cat resumed) >out 2>&1 ||
        fail "resumed: $(tail -n 2 out)"
}
