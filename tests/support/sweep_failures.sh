# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Cases of a study that fail, in both layouts of its results.
# Needs tests/support/cli.sh.

# lists_failures YES|NO: with `results` so they are listed, left alone, and run
# again on request.
lists_failures() {
    rm -rf bad bad.ini
    cat >bad.ini <<END
[study]
results = $1
[set]
domain.level = 4
[product]
contact.M = 20
contact.lambda = 1
contact.L = 5, 6
END
    expect 1 "$OVERROLL" sweep bad.ini -j 2
    contains out '2 cases: 2 failed'
    contains out '^  1 failed M=20_lambda=1_L=5: .*lambda'
    contains out '^  and 1 more, see manifest.csv'
    contains bad/manifest.csv '^1,.*,failed,,,.*lambda'
    expect 1 "$OVERROLL" sweep bad.ini
    [ ! -s err ] || fail "failed cases ran again: $(cat err)"
    expect 0 "$OVERROLL" sweep bad.ini --list
    [ ! -s out ] || fail "$(cat out)"
    expect 0 "$OVERROLL" sweep bad.ini --list --retry
    [ "$(wc -l <out)" -eq 2 ] || fail "$(cat out)"
    expect 1 "$OVERROLL" sweep bad.ini --retry
    contains err '^100 %'
    expect 1 "$OVERROLL" sweep bad.ini --task 2 --retry
    contains out '^2 failed M=20_lambda=1_L=6: .*lambda'
    lists_five_kinds "$1"
}

# Of failures of eight kinds five are printed.
lists_five_kinds() {
    rm -rf kinds thin.ini kinds.ini
    printf '[contact]\nM = 20\nL = 5\n[domain]\nlevel = 3\n' >thin.ini
    cat >kinds.ini <<END
[study]
case = thin.ini
results = $1
[product]
contact.M = 800, 1000, 1200, 1500, 2000, 2500, 3000, 4000
END
    expect 1 "$OVERROLL" sweep kinds.ini
    [ "$(grep -c 'too thin for the grid' out)" = 5 ] || fail "$(cat out)"
    contains out '^  and 3 more, see manifest.csv'
}
