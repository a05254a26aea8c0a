#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Steps of two mesh sizes, the default: a dent rolls through in half the number
# of steps of one mesh size. The film thickness differs from a run with twice as
# many nodes and steps of one mesh size by at most 5e-5 in the centre and 1e-3
# at its minimum (rms of the passage). In version 0.2.0, with steps of one mesh
# size and without convected corrections, the centre differed by 1.1e-4. `check`
# prints the reason for steps of one mesh size.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 7
inlet = -4
outlet = 1.5
[time]
end = 5.5
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4.6
[output]
every = 1000000
END

history() {
    expect 0 "$OVERROLL" run dent.ini -o "$1.h5" --json -q \
        --set domain.level="$2" "$3"
    awk -F: '$1 ~ /"steps"/ { print $2 + 0 }' out >"$1.steps"
    expect 0 "$OVERROLL" export "$1.h5" -o "$1.csv"
}
history auto 7 --set=output.compression=0
history fine 8 --set=time.step=grid
steps=$(cat auto.steps) fine=$(cat fine.steps)
[ $((4 * steps)) -le $((fine + 4)) ] ||
    fail "$steps steps of two meshes, $fine of half a mesh"
awk -F, '
    FNR == 1 {
        for (k = 1; k <= NF; k++) {
            sub(/ .*/, "", $k)
            at[$k] = k
        }
        next }
    { T = sprintf("%.6f", $at["time"]) }
    FILENAME ~ /fine/ {
        cen[T] = $at["central_film_thickness"]
        min[T] = $at["min_film_thickness"]; next }
    !(T in cen) { exit n = 0 }
    { n++
      c += ($at["central_film_thickness"] / cen[T] - 1) ^ 2
      m += ($at["min_film_thickness"] / min[T] - 1) ^ 2 }
    END {
        printf "%d moments: rms H_cen %g, H_min %g\n", n, sqrt(c / n),
            sqrt(m / n)
        exit !(n > 400 && sqrt(c / n) < 5e-5 && sqrt(m / n) < 1e-3) }
' fine.csv auto.csv >said || fail "$(cat said)"

# Given steps: three meshes a step, no whole number of which passes b, keep
# the scheme of the default, and H_min is off by less than 2e-3 and a fifth of
# what upstream2 makes of the same steps.
error_of() {
    expect 0 "$OVERROLL" run dent.ini -o "given_$1.h5" -q --set time.step=0.02 \
        --set time.scheme="$1"
    expect 0 "$OVERROLL" export "given_$1.h5" -o "given_$1.csv"
    awk -F, '
        FNR == 1 {
            for (k = 1; k <= NF; k++) {
                sub(/ .*/, "", $k)
                at[$k] = k
            }
            next }
        { T = $at["time"]; H = $at["min_film_thickness"] }
        FILENAME ~ /fine/ { t[++n] = T; h[n] = H; next }
        T >= t[1] && T <= t[n] {
            for (k = k < 1 ? 1 : k; k < n - 1 && t[k + 1] < T; k++);
            part = (T - t[k]) / (t[k + 1] - t[k])
            H0 = h[k] + (h[k + 1] - h[k]) * part
            e += (H / H0 - 1) ^ 2
            count++ }
        END { print (count > 200 ? sqrt(e / count) : 0) }' \
        fine.csv "given_$1.csv"
}
own=$(error_of auto) upstream=$(error_of upstream2)
awk "BEGIN { exit !($own > 0 && $own < 2e-3 && 5 * $own < $upstream) }" ||
    fail "given steps: rms of H_min $own, by upstream2 $upstream"
expect 0 "$OVERROLL" check dent.ini --json --set time.step=0.06
contains out '"scheme": "upstream2"'

# What check says of the step
why() {
    said=$1
    shift
    expect 0 "$OVERROLL" check dent.ini -v "$@"
    contains out "time step +$said"
}
why '0.0122768 = 2 D$'
why '0.00613839 = 1 D$' --set time.step=grid
why '0.1 = 16.3 D$' --set time.step=0.1
why '0.00613839 = 1 D: as upstream' --set time.scheme=upstream2
why '0.00613839 = 1 D: without corrections' --set domain.order=2
why '0.00613839 = 1 D: for M of 100' --set contact.M=100
why '0.0122768 = 1 D: on a mesh above 0.01 b' --set domain.level=6
why '0.00613839 = 1 D: for a feature narrower' --set feature.dent.width=0.18
why '0.00613839 = 1 D: for a change within 30' --set load.history=step \
    --set load.to=1.1 --set load.start=1
why '0.00613839 = 1 D: for a change within 30' --set load.history=sine \
    --set load.amplitude=0.1 --set load.period=0.18
why '0.0122768 = 2 D$' --set load.history=ramp --set load.to=1.1 \
    --set load.duration=0.2
why 'adaptive, target error 0.001' --set time.step=adaptive
