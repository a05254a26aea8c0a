# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# For tests/cli/*.sh, which begin with:  . "$TOP/tests/support/cli.sh"
# Each runs in an empty folder; $OVERROLL is the program, $TOP the sources.
set -u

fail() {
    echo "$*"
    exit 1
}

skip() {
    echo "$*"
    exit 77
}

# need COMMAND...: skips the test where one is missing.
need() {
    for tool; do
        command -v "$tool" >/dev/null || skip "no $tool"
    done
}

# need_python MODULE...: sets $PYTHON to one that has them; else skips.
need_python() {
    modules=$(echo "$*" | tr ' ' ,)
    for PYTHON in python3 /usr/bin/python3; do
        "$PYTHON" -c "import $modules" 2>/dev/null && return
    done
    skip "no Python with $modules"
}

# Nothing to read, but for what a script hands on (expect ... <<'END').
exec </dev/null

# expect CODE COMMAND...: runs it, checks its exit code; its output is in the
# files out and err, which it may read as the command before left them.
expect() {
    wanted=$1
    shift
    code=0
    "$@" >.out 2>.err || code=$?
    mv .out out
    mv .err err
    [ "$code" -eq "$wanted" ] && return
    echo "$*"
    sed 's/^/stdout: /' out
    sed 's/^/stderr: /' err
    fail "exit code $code, wanted $wanted"
}

# number KEY [FILE]: of the JSON in `out` or that file, of its outermost keys.
number() {
    sed -n "s/^  \"$1\": \([-0-9.e+]*\),*\$/\1/p" "${2:-out}"
}

# dent_case LEVEL END DEPTH WIDTH START: a case with M = 20, L = 10 and a dent.
# More keys of the dent can follow.
dent_case() {
    printf '[contact]\nM = 20\nL = 10\n[domain]\nlevel = %s\n' "$1"
    printf '[time]\nend = %s\n[feature dent]\nshape = dent\n' "$2"
    printf 'depth = %s\nwidth = %s\nstart = %s\n' "$3" "$4" "$5"
}

# sized_dent_case LEVEL END DEPTH WIDTH START: the same with dimensions.
sized_dent_case() {
    dent_case "$@" | sed '/^L = /a\
radius = 10 mm\
modulus = 226 GPa\
viscosity = 40 mPa.s'
}

# rubbing_contact: a contact of steel whose surfaces slide and may touch.
rubbing_contact() {
    cat <<'END'
[contact]
load = 250 kN/m
radius = 10 mm
mean_speed = 1.5 m/s
slide_to_roll = 0.4
modulus = 226 GPa
[lubricant]
viscosity = 30 mPa.s
alpha = 18 1/GPa
rheology = eyring
eyring_stress = 5 MPa
END
}

# begins FILE: waits until the run in the background has stored steps in it, and
# so listens to signals.
begins() {
    tries=0
    until "$OVERROLL" info "$1" 2>&1 | grep -q '^history .*T = 0 to'; do
        tries=$((tries + 1))
        [ $tries -lt 600 ] || fail "the run does not begin: $(cat err)"
        sleep 0.1
    done
}

# contains FILE PATTERN: a line of the file matches (extended expression).
contains() {
    grep -qE -e "$2" "$1" && return
    cat "$1"
    fail "$1 has no line that matches '$2'"
}

# refuses PATTERN ARGUMENTS...: the program ends with exit code 2, nothing on
# stdout, and one line on stderr that matches.
refuses() {
    pattern=$1
    shift
    expect 2 "$OVERROLL" "$@"
    [ ! -s out ] || fail "stdout of a refused '$*': $(cat out)"
    [ "$(wc -l <err)" -eq 1 ] || fail "'$*' says not one line: $(cat err)"
    contains err "$pattern"
}

# content FILE: all that a result file says of its run, as text without dates.
content() {
    "$OVERROLL" export "$1" >history.txt &&
        "$OVERROLL" export "$1" --all >snapshots.txt &&
        cat history.txt snapshots.txt
}
