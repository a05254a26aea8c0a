#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Extremes over the run come first in reports. They are those of the history,
# in --json, the summary, the file and the table of a study, also after a stop
# and resume.
. "$TOP/tests/support/cli.sh"

sized_dent_case 4 7 0.2 0.5 -4.6 >dent.ini
cat >>dent.ini <<'END'
[output]
checkpoint = 0.05 s
END

value() { # KEY FILE
    sed -n "s/^  \"$1\": \([^,]*\),*$/\1/p" "$2"
}
near() { # NUMBER NUMBER
    awk -v a="$1" -v b="$2" \
        'BEGIN { d = a - b; exit !(a != "" && b != "" &&
            d*d <= 1e-24*(a*a + b*b)) }' || fail "$3: $1 is not $2"
}

# extreme COLUMN SIGN: value, place and time of a column's extreme, by the
# history alone
extreme() {
    awk -F, -v name="$1" -v place="$2" -v sign="$3" 'NR == 1 {
            for (i = 1; i <= NF; i++) { sub(/ .*/, "", $i); c[$i] = i }
            next }
        { v = sign*$c[name]
            if (sign == 0) v = $c[name] < 0 ? -$c[name] : $c[name] }
        NR == 2 || v > most { most = v; row = $0 }
        END { split(row, r, ",")
            printf "%.17g %.17g %.17g\n", r[c[name]],
                place == "" ? 0 : r[c[place]], r[c["time"]] }' history.csv
}

expect 0 "$OVERROLL" run dent.ini -o a.h5 --json
mv out a.json
expect 0 "$OVERROLL" export a.h5 --units hertzian
mv out history.csv

check() { # COLUMN PLACE SIGN KEY PLACE_KEY TIME_KEY
    # shellcheck disable=SC2046 # three words are wanted
    set -- "$4" "$5" "$6" $(extreme "$1" "$2" "$3")
    near "$(value "$1" a.json)" "$4" "$1"
    [ -z "$2" ] || near "$(value "$2" a.json)" "$5" "$2"
    near "$(value "$3" a.json)" "$6" "$3"
}
check max_pressure x_max_pressure 1 P_max_overall X_P_max_overall T_P_max
check min_film_thickness x_min_film_thickness -1 \
    H_min_overall X_H_min_overall T_H_min
check load_error '' 0 load_error_max '' T_load_error_max
check power_in '' 0 power_in_max '' T_power_in_max
check power_dissipated '' 1 power_dissipated_max '' T_power_dissipated_max
check film_roughness '' 1 film_Rq_max '' T_film_Rq_max

# mean COLUMN KEY: each value for the step that led to it, by the history alone
mean() {
    near "$(value "$2" a.json)" "$(awk -F, -v name="$1" 'NR == 1 {
            for (i = 1; i <= NF; i++) { sub(/ .*/, "", $i); c[$i] = i }
            next }
        { s += ($c["time"] - T)*$c[name]; T = $c["time"] }
        END { printf "%.17g\n", s/T }' history.csv)" "$2"
}
mean central_film_thickness H_cen_mean
mean min_film_thickness H_min_mean
mean mean_film_thickness H_mean
mean power_in power_in_mean
mean power_dissipated power_dissipated_mean

# The dent has left: the peak is not that of the end
awk -v all="$(value P_max_overall a.json)" -v end="$(value P_max a.json)" \
    'BEGIN { exit !(all > 1.1*end) }' || fail 'no peak on the way'
near "$(value P_max_overall_Pa a.json)" "$(awk -v a="$(value P_max_overall \
    a.json)" -v b="$(value hertz_pressure_Pa a.json)" \
    'BEGIN { printf "%.17g", a*b }')" P_max_overall_Pa

# In words: the run first, then its end
expect 0 "$OVERROLL" run dent.ini
awk '/^over the run / { a = NR } /^maximum pressure .*GPa at .*ms/ {
    b = NR } /^minimum film thickness .*um at .*ms/ && a && !e { c = NR }
    /^largest force bal.*at .*ms/ { d = NR } /^at the end, T = / { e = NR }
    /^maximum pressure/ && e { f = NR }
    END { exit !(a && a < c && c < b && b < d && d < e && e < f) }' out ||
    fail "$(cat out)"

# A study's table and its manifest
printf '[study]\ncase = dent.ini\n[product]\n%s\n' \
    'feature.dent.depth = 0.1, 0.2' >study.ini
expect 0 "$OVERROLL" sweep study.ini -q
expect 0 "$OVERROLL" sweep study.ini --collect study.csv -q
head -n 1 study/manifest.csv | grep -q ',H_min_overall,.*,P_max_overall,' ||
    fail "$(cat study/manifest.csv)"
head -n 1 study/manifest.csv | grep -q ',P_max,' && fail 'the end as the peak'
near "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++)
    if ($i == "P_max_overall") c = i } NR == 3 { print $c }' study.csv)" \
    "$(value P_max_overall a.json)" 'P_max_overall of the study'

# A steady solution has its load error
expect 0 "$OVERROLL" steady --M 20 --L 10 --level 4 --json
contains out '"load_error_max": -*[0-9.e-]+,'
contains out '"order": [124],'
grep -q P_max_overall out && fail 'a steady solution over time'

# Ended early and resumed: not all of it behind the peak
expect 0 "$OVERROLL" run dent.ini --level 6 -o b.h5 --json
mv out b.json
"$OVERROLL" run dent.ini --level 6 --set time.end=5.3 -o c.h5 -q || fail 'c.h5'
expect 0 "$OVERROLL" resume c.h5 --set time.end=7 --json
for key in P_max_overall X_P_max_overall T_P_max H_min_overall \
    X_H_min_overall T_H_min load_error_max T_load_error_max; do
    [ "$(value $key out)" = "$(value $key b.json)" ] ||
        fail "$key: $(value $key out) resumed, $(value $key b.json) whole"
done

need ncdump
expect 0 ncdump -h a.h5
for key in H_min_overall H_min_overall_m P_max_overall P_max_overall_Pa \
    T_P_max load_error_max T_load_error_max_s; do
    near "$(sed -n "s/^.*:$key = \([^ ]*\) ;/\1/p" out)" \
        "$(value $key a.json)" "attribute $key"
done

# No key stands there twice
grep -o '^  "[^"]*"' a.json | sort | uniq -d >twice
[ ! -s twice ] || fail "twice: $(cat twice)"
