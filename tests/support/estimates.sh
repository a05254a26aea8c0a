# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# estimates COUNT LEVEL LEAST: `run --estimate-error` of extremes in time, of
# COUNT random cases whose films converge, at LEVEL, beside the true error from
# LEVEL + 2: at least LEAST of them have the smallest film, and the largest
# pressure where one is told for it, below three times the estimate. Those
# without an estimate of the film, or whose differences do not shrink between
# LEVEL + 1 and LEVEL + 2 either (a peak that only finer meshes see), are named,
# and the next draw takes their place.
SEED=20261122

# A case of the draws: M, L with ph below 2 GPa, slip, a feature on either
# surface. Park and Miller's generator: the same numbers with every awk.
draw() {
    awk -v seed="$SEED" -v skip="$1" '
    function next_number() { x = x*16807 % 2147483647; return x/2147483647 }
    function between(a, b) { return a + (b - a)*next_number() }
    BEGIN {
        x = seed
        for (k = 0; k <= skip; k++)
            do {
                M = 5*exp(between(0, log(20))); L = between(2, 15)
                slip = between(-1, 1); surface = 1 + int(between(0, 2))
                n = 1 + int(between(0, 4)); width = between(0.3, 1.2)
                height = 0.01*exp(between(0, log(25)))
                scheme = between(0, 1) < 0.5 ? "characteristic" : "upstream2"
            } while (L*sqrt(M/6.2832)/17 > 2)
        split("dent bump indent ridge", shape, " ")
        split("depth height depth height", tall, " ")
        printf "[contact]\nM = %.6g\nL = %.6g\nslide_to_roll = %.4g\n", M, L,
            slip
        printf "[time]\nend = auto\nscheme = %s\n", scheme
        printf "[output]\nevery = 1000000\n"
        printf "[feature it]\nsurface = %d\nshape = %s\n", surface, shape[n]
        printf "width = %.4g\n%s = %.4g\n", width, tall[n], height
    }'
}

value() { # FILE KEY
    awk -v key="\"$2\":" '$1 == key { sub(",", "", $2); print $2; exit }' "$1"
}

is_told() { # KEY
    [ "$(value coarse "$1_error")" != null ]
}

# true error over the estimate
ratio() { # KEY
    awk -v a="$(value coarse "$1")" -v b="$(value finer2 "$1")" \
        -v e="$(value coarse "$1_error")" \
        'BEGIN { d = a - b; print (d < 0 ? -d : d)/e }'
}

# Differences that shrink by a third at least, or are below 0.5 %.
shrinks() { # KEY
    awk -v a="$(value coarse "$1")" -v b="$(value finer1 "$1")" \
        -v c="$(value finer2 "$1")" 'function size(x) { return x < 0 ? -x : x }
        BEGIN { exit !(size(c - b) <= 0.67*size(b - a) ||
                       size(c - b) <= 0.005*size(c)) }'
}

estimates() { # COUNT LEVEL LEAST
    counted=0 good=0 i=0
    while [ $counted -lt "$1" ] && [ $i -lt $((8*$1)) ]; do
        draw $i >case.ini
        what=$(tr '\n' ' ' <case.ini | sed 's/\[[a-z ]*\] //g')
        i=$((i + 1))
        "$OVERROLL" run case.ini --set domain.level="$2" -o case.h5 --force \
            --estimate-error --json -q >coarse 2>err
        if [ $? -eq 1 ]; then
            echo "# $i: replaced, it fails: $(tail -n 1 err); $what"
            continue
        fi
        if ! is_told H_min_overall; then
            echo "# $i: replaced, no estimate of the film; $what"
            continue
        fi
        for up in 1 2; do
            "$OVERROLL" run case.ini --set domain.level=$(($2 + up)) \
                -o case.h5 --force --json -q >finer$up 2>err
        done
        if ! shrinks H_min_overall ||
            { is_told P_max_overall && ! shrinks P_max_overall; }; then
            echo "# $i: replaced, does not converge on finer levels; $what"
            continue
        fi
        film=$(ratio H_min_overall) pressure=0
        ! is_told P_max_overall || pressure=$(ratio P_max_overall)
        counted=$((counted + 1))
        verdict=$(awk -v p="$pressure" -v h="$film" \
            'BEGIN { print p < 3 && h < 3 ? "below" : "ABOVE" }')
        [ "$verdict" = below ] && good=$((good + 1))
        echo "# $i: true/estimated: pressure $pressure, film $film: $verdict;" \
            "$what"
    done
    echo "# seed $SEED: $good of $counted below 3 times the estimate," \
        "$((i - counted)) replaced"
    [ $counted -eq "$1" ] && [ $good -ge "$3" ]
}
