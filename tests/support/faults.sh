# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# For tests with failing system calls (tests/cli/preload.c).
. "$TOP/tests/support/cli.sh"

# Makes faults.so, to be preloaded; false where that cannot be (sanitizers and
# preloading do not mix).
can_fault() {
    [ -z "$INSTRUMENTED" ] && "$CC" -shared -fPIC -O1 -o faults.so \
        "$TOP/tests/cli/preload.c" -ldl 2>log
}

# The same, or skips the test.
make_faults() {
    can_fault || skip "no preloading here"
}

# Makes dent.ini, a short run that reads a second file.
make_dent() {
    cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[time]
end = 0.5
[load]
history = table
file = load.txt
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -1.5
[output]
every = 1
END
    printf '0 1\n1 1.1\n2 1\n' >load.txt
}
