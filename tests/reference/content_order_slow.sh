#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Mass-conserving cavitation with characteristic, of second and of fourth order:
# a dent rolls through a starved contact. Runs are compared with finer levels of
# second order, which need no corrections, and steady films with their limit.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
inlet = -4
outlet = 1.5
faces = gap
[cavitation]
model = conserving
[supply]
model = film
thickness_1 = 0.0252
thickness_2 = 0.0252
[time]
end = 7
step = grid
[feature dent]
shape = indent
depth = 0.1
width = 0.5
start = -4.6
END

# series OUT LEVEL OPTIONS: T, H_cen, H_min of each step
series() {
    out=$1 level=$2
    shift 2
    expect 0 "$OVERROLL" run dent.ini -q -o run.h5 --force --level "$level" "$@"
    "$OVERROLL" export run.h5 | awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++) {
            name = $i
            sub(" .*", "", name)
            at[name] = i } }
        NR > 1 { print $at["time"], $at["central_film_thickness"],
                       $at["min_film_thickness"], $at["mass_defect"] }' >"$out"
}

# of second order, [level 9] + ([level 9] - [level 8])/3 at the steps of level 7
series fine 9 --set domain.order=2
series less 8 --set domain.order=2
awk 'FILENAME == "fine" { if ((FNR - 1) % 4 == 0) { a = (FNR - 1) / 4
         T[a] = $1; c[a] = $2; m[a] = $3 } next }
     (FNR - 1) % 2 == 0 { a = (FNR - 1) / 2
         if (a in T) printf "%.17g %.17g %.17g\n", T[a],
             c[a] + (c[a] - $2) / 3, m[a] + (m[a] - $3) / 3 }' \
    fine less >limit

# errors FILE H_CEN H_MIN: rms, at most so much
errors() {
    paste -d' ' limit "$1" | awk -v most_cen="$2" -v most_min="$3" '
        NF == 7 {
            d = $1 - $4
            if (d * d > 1e-18) bad = "steps differ"
            c += ($5 / $2 - 1) ^ 2
            m += ($6 / $3 - 1) ^ 2
            n++
        }
        END {
            c = sqrt(c / n)
            m = sqrt(m / n)
            print n " steps, H_cen " c ", H_min " m " " bad
            exit !(n > 900 && c < most_cen && m < most_min) || bad
        }' >judged || fail "$1: $(cat judged)"
}
series second 7 --set domain.order=2
series fourth 7
series upstream 7 --scheme upstream2
errors second 3e-4 2e-3
errors fourth 3e-4 1.5e-3
(errors upstream 3e-3 1e-2) >shown &&
    fail 'upstream2 is as good: nothing is shown'

# The share of the flooded film that is left: level 6 of fourth order beside the
# limit of second
ratio() {
    expect 0 "$OVERROLL" steady dent.ini --json --level "$1" \
        --set domain.order="$2" --scheme characteristic
    sed -n 's/^ *"film_ratio": \(.*\),$/\1/p' out
}
c6=$(ratio 6 2) c7=$(ratio 7 2) c8=$(ratio 8 2) f6=$(ratio 6 4)
awk -v c6="$c6" -v c7="$c7" -v c8="$c8" -v f6="$f6" 'BEGIN {
    limit = c8 + (c8 - c7) / 3
    second = (c6 / limit - 1) ^ 2
    fourth = (f6 / limit - 1) ^ 2
    print sqrt(second), sqrt(fourth)
    exit !(fourth < 1e-5 ^ 2 && second > 5e-4 ^ 2)
}' >judged || fail "steady: $(cat judged)"
