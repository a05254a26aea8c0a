#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Studies without result files: rows of tables instead of files of each case.
# The table equals that of the study with files. After a killed sweep,
# destroyed rows, a lost index or an enlarged study no case is lost or
# repeated.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/sweep_failures.sh"
need setsid

cat >case.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
END
cat >files.ini <<'END'
[study]
case = case.ini
[product]
contact.M = 20, 25
[random]
draws = 64
design = plain
contact.L = uniform 8 to 12
END
sed 's/^case = .*/&\nresults = no/' files.ini >rows.ini
rows() { # FOLDER: rows of its tables
    cat "$1"/cases-*.csv | grep -vc '^name,'
}
# What a table has but for the clock and the number of snapshots.
table_of() { # STUDY FOLDER
    "$OVERROLL" sweep "$1" -o "$2" --collect "$2.csv" -q
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++)
            skip[k] = $k == "seconds" || $k == "snapshots" }
        { for (k = 1; k <= NF; k++) if (!skip[k]) printf "%s,", $k
          print "" }' "$2.csv"
}
same_table() { # FOLDER WHAT
    table_of rows.ini "$1" | cmp - files.txt || fail "$2: another table"
}

expect 0 "$OVERROLL" sweep files.ini -j 2 -q
table_of files.ini files >files.txt
[ "$(grep -c ,finished, files.txt)" -eq 128 ] || fail "$(cat files.txt)"
expect 0 "$OVERROLL" sweep rows.ini -j 2 -q
same_table rows 'rows'
[ "$(find rows -type f | wc -l)" -le 8 ] || fail "files: $(ls rows)"
[ "$(rows rows)" -eq 128 ] || fail "$(rows rows) rows"
contains rows/manifest.csv '^1,M=20_draw-0001,20,.*,finished,,cases-[12].csv,'

# Nothing is run again, with or without the index
expect 0 "$OVERROLL" sweep rows.ini -q
rm rows/cases.index
expect 0 "$OVERROLL" sweep rows.ini -q
[ "$(rows rows)" -eq 128 ] || fail 'cases were run again'
# a row that was destroyed is run again, one cut off at the end of a table too
last=$(tail -n 1 rows/cases-1.csv | cut -d, -f1)
truncate -s -20 rows/cases-1.csv
expect 3 "$OVERROLL" sweep rows.ini --collect cut.csv -q
contains cut.csv "^[0-9]*,$last,.*,waiting,"
expect 0 "$OVERROLL" sweep rows.ini -j 2 -q
same_table rows 'a row was cut off'
[ "$(cat rows/cases-*.csv | grep -c "^$last,")" -eq 1 ] ||
    fail 'the row that was cut off is still there'

# Killed with all its workers at some moment, and resumed
for lines in 5 60; do
    setsid "$OVERROLL" sweep rows.ini -o killed -j 2 -q >/dev/null 2>&1 &
    tries=0
    until [ "$(cat killed/cases-*.csv 2>/dev/null | wc -l)" -ge $lines ]; do
        tries=$((tries + 1))
        [ $tries -lt 3000 ] || fail 'no case is run'
        sleep 0.01
    done
    kill -9 "-$!" 2>/dev/null
    wait $! 2>/dev/null
done
for _ in $(seq 100); do
    "$OVERROLL" sweep rows.ini -o killed -j 2 -q && break
    sleep 0.1 # workers may still hold locks
done
same_table killed 'killed'
[ "$(rows killed)" -le 134 ] || fail "$(rows killed) rows for 128 cases"

# Blocks by several processes at once, one block twice, single cases
for block in 1-50 20-70 71-127 20-70; do
    "$OVERROLL" sweep rows.ini -o blocks --tasks $block -q &
done
wait
expect 0 "$OVERROLL" sweep rows.ini -o blocks --task 128
contains out '^128 finished M=25_draw-0064'
same_table blocks 'blocks'
[ "$(rows blocks)" -eq 128 ] || fail "$(rows blocks) rows of blocks"

# A study that grows keeps its cases, by name
sed 's/draws = 64/draws = 80/' rows.ini >more.ini
expect 0 "$OVERROLL" sweep more.ini -o rows -j 2 -q
[ "$(rows rows)" -eq 160 ] || fail 'a larger sample repeats cases'
expect 0 "$OVERROLL" sweep rows.ini -q
same_table rows 'a smaller sample'
[ "$(rows rows)" -eq 160 ] || fail 'a smaller sample repeats cases'

# The case of a task, as text, can be run by itself
expect 0 "$OVERROLL" sweep rows.ini --case 100
mv out single.ini
expect 0 "$OVERROLL" run single.ini --json -q
awk -F, -v H="$(number H_min out)" 'NR == 1 { for (k = 1; k <= NF; k++)
        if ($k == "H_min") h = k }
    $2 == "M=25_draw-0036" { found = $h == H } END { exit !found }' rows.csv ||
    fail 'the case of a task is another one'

# Another base case: what is there is not of this study any more
sed 's/^level = 5/level = 4/' case.ini >coarse.ini
mv coarse.ini case.ini
expect 3 "$OVERROLL" sweep rows.ini
contains out '128 changed'
expect 0 "$OVERROLL" sweep rows.ini --redo -j 2
contains out '128 finished'
rm rows/cases.index
expect 0 "$OVERROLL" sweep rows.ini
contains out '128 finished'

# Failures are rows with the message.
lists_failures no

# Result files of the cases, of a study with results = yes, count
cat >old.ini <<'END'
[study]
case = case.ini
[product]
contact.M = 20, 25, 30
END
expect 0 "$OVERROLL" sweep old.ini -q
rm old/manifest.csv
sed -i 's/^case = .*/&\nresults = no/' old.ini
expect 0 "$OVERROLL" sweep old.ini --collect old.csv
contains out '3 finished'
contains old.csv '^3,M=30,30,finished,1,'
expect 0 "$OVERROLL" sweep old.ini
[ ! -e old/cases-1.csv ] || fail 'cases with files of their own ran again'

# What somebody else keeps there is not touched
mkdir kept
printf 'my notes\n' >kept/cases-1.csv
expect 0 "$OVERROLL" sweep old.ini -o kept -q -j 1
[ "$(cat kept/cases-1.csv)" = 'my notes' ] || fail 'notes were changed'
[ "$(grep -vc '^name,' kept/cases-2.csv)" -eq 3 ] || fail "$(ls kept)"
