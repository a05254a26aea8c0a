#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The studies and cases of tools/examples can be read, and the quick ones end in
# their pictures; `make verify` runs all.
. "$TOP/tests/support/cli.sh"
for file in "$TOP"/tools/examples/*.ini; do
    if grep -q '^\[product\]\|^\[zip\|^\[random' "$file"; then
        expect 0 "$OVERROLL" sweep "$file" -o here --list
        [ "$(wc -l <out)" -ge 2 ] || fail "$file: $(cat out)"
    else
        expect 0 "$OVERROLL" check "$file"
    fi
    [ -x "${file%.ini}" ] || fail "no script for $file"
done

[ -z "$INSTRUMENTED" ] || exit 0 # what they run is tested by itself
command -v gnuplot >/dev/null || exit 0
for name in film-chart heat liner coating scuffing; do
    expect 0 env LC_ALL=C EXAMPLES="$PWD/made" OVERROLL="$OVERROLL" \
        "$TOP/tools/examples/$name"
    ! grep iconv err || fail "gnuplot warns of the locale in $name"
    [ "$(head -c 4 "made/$name.png" | tail -c 3)" = PNG ] ||
        fail "$name makes no picture: $(cat err)"
done

# The scuffing check: the mean rise of both flanks is near Blok's flash
# temperature at A, B, D and E, and no flank is as cold as the oil
awk -F , 'NR > 1 && $1 ~ /[ABDE]/ { n++
        r = (($4 + $5) / 2 - 90) / ($6 - 90)
        if (r < 0.8 || r > 1.25) exit bad = 1 }
    END { exit bad || n != 4 }' made/scuffing.csv ||
    fail "flanks and Blok: $(cat made/scuffing.csv)"
contains out 'hottest flank [0-9.]+ degC at 0.000 ms, safety'

# Round dents raise the pressure less than grooves and leave a thicker film.
expect 0 env LEVEL=4 EXAMPLES="$PWD/made" OVERROLL="$OVERROLL" \
    "$TOP/tools/examples/round-dent"
for picture in round-dent round-dent-map; do
    [ "$(head -c 4 "made/$picture.png" | tail -c 3)" = PNG ] ||
        fail "round-dent makes no $picture.png: $(cat err)"
done
awk '$NF == "min_film_thickness" { least[$1] = $5 }
    $NF == "max_pressure" { most[$1] = $6 }
    END { exit !(least["round:"] > 1.03 * least["endless:"] &&
                 most["round:"] > 1 &&
                 most["round:"] < 0.985 * most["endless:"]) }' out ||
    fail "round dent and groove: $(cat out)"
