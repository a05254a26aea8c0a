# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# DRAWS samples of a ground surface, killed three times and resumed, have the
# bits of an uninterrupted study and of single tasks.
. "$TOP/tests/support/cli.sh"
need setsid xargs

cat >base.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[time]
end = 1
[feature ground]
shape = roughness
Rq = 0.01
length = 2
shortest = 0.8
seed = 1
start = -4.1
END
cat >study.ini <<END
[study]
case = base.ini
[random]
draws = $DRAWS
feature.ground.seed = 1..1000000000
contact.M = lognormal 20 sd 10 %
contact.slide_to_roll = uniform -0.5 to 0.5
[limits]
H_min_overall >= 0.06
END
# What a table says but for what depends on the clock.
numbers() {
    "$OVERROLL" sweep study.ini -o "$1" --collect "$1.csv" -q
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "seconds") s = i }
        { $s = ""; print }' "$1.csv"
}
expect 0 "$OVERROLL" sweep study.ini -j 2 -q -o once
numbers once >once.txt
[ "$(grep -c ' finished ' once.txt)" -eq "$DRAWS" ] ||
    fail "$(head -n 3 once.txt)"

for part in $((DRAWS * 3 / 20)) $((DRAWS * 9 / 20)) $((DRAWS * 3 / 4)); do
    setsid "$OVERROLL" sweep study.ini -j 2 -q -o killed &
    sweep=$!
    tries=0
    until [ "$(find killed -name '*.json' 2>/dev/null |
        wc -l)" -ge "$part" ]; do
        tries=$((tries + 1))
        [ $tries -lt 3000 ] || fail 'the sweep does not get on'
        sleep 0.02
    done
    kill -9 "-$sweep"
    wait "$sweep" 2>/dev/null
    for _ in $(seq 300); do # its children have locks until they are gone
        kill -0 "-$sweep" 2>/dev/null || break
        sleep 0.01
    done
    [ "$(find killed -name '*.json' | wc -l)" -lt "$DRAWS" ] || fail 'too late'
done
expect 0 "$OVERROLL" sweep study.ini -j 2 -q -o killed
numbers killed | cmp - once.txt || fail 'killed, it is another thing'

seq "$DRAWS" | sort -R --random-source=base.ini |
    xargs -P 2 -I I "$OVERROLL" sweep study.ini -o tasks --task I -q ||
    fail 'a task failed'
numbers tasks | cmp - once.txt || fail 'by tasks it is another thing'
for folder in once killed tasks; do
    "$OVERROLL" sweep study.ini -o $folder --statistics >$folder.told ||
        fail "no statistics of $folder"
    cmp $folder.told once.told || fail "other statistics of $folder"
done
contains once.told '^probability of at least 0.06 b.2/R  *0[.]'
