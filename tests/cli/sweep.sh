#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# sweep: lists, ranges, products and zips; finished cases are skipped, failed
# ones listed and repeated on request; the same results with one worker, two
# workers, GNU parallel and a job array.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/sweep_failures.sh"

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
[output]
file = never.h5
every = 8
END
cat >study.ini <<'END'
[study]
case = base.ini          # beside the study
[set]
output.fields = pressure, film_thickness
[product]
feature.ground.seed = 1..3
time.scheme = upstream1, upstream2
[zip pairs]
contact.M = linear 10 to 20 in 2
contact.L = log 5 to 10 in 2
END

# What a table says but for what depends on the clock.
numbers() {
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "seconds") s = i }
        { $s = ""; print }' "$1"
}

expect 0 "$OVERROLL" sweep study.ini -j 1 --json
contains out '"cases": 12,'
contains out '"finished": 12,'
[ ! -e never.h5 ] || fail 'the base case decides where results go'
one='study/seed=2_scheme=upstream2_M=20_L=10'
for ending in h5 ini json log; do
    [ -s "$one.$ending" ] || fail "no $one.$ending"
done
[ "$(wc -l <study/manifest.csv)" -eq 13 ] || fail "$(cat study/manifest.csv)"
contains study/manifest.csv '^task,name,seed,scheme,M,L,status,output,summary,'
contains study/manifest.csv '^8,seed=2_s.*=10,2,upstream2,20,10,finished,.*h5,'
expect 0 "$OVERROLL" sweep study.ini --collect one.csv -q
[ ! -s err ] || fail "-q: $(cat err)"
contains one.csv '^1,[^,]*,1,upstream1,10,5,finished,1,'

# The table is made from the result files, not from the JSON; cases whose files
# were removed are to be run again
cp -r study told
for file in told/*.json; do
    sed 's/^  "H_min": .*/  "H_min": 7,/' "$file" >kept && mv kept "$file"
done
expect 0 "$OVERROLL" sweep study.ini -o told --collect told.csv -q
cmp one.csv told.csv || fail 'the table is not of the result files'
rm "told/${one#*/}.h5"
expect 3 "$OVERROLL" sweep study.ini -o told --collect told.csv
contains out '1 waiting 11 finished'

# Two workers
expect 0 "$OVERROLL" sweep study.ini -j 2 -o two
# (two are under way when the last progress is shown, on a busy machine)
contains err '^100 %  1[0-2] of 12 cases'
expect 0 "$OVERROLL" sweep study.ini -o two --collect two.csv
numbers one.csv >one.txt
numbers two.csv >two.txt
cmp one.txt two.txt || fail 'two workers compute another thing'
for file in study/*.h5; do
    for all in '' --all; do
        expect 0 "$OVERROLL" export "$file" $all
        mv out one.rows
        expect 0 "$OVERROLL" export "two/${file#*/}" $all
        cmp one.rows out || fail "$file: other rows with two workers"
    done
done

# Finished ones are skipped; a lost one is run again
touch -d '2020-01-01' study/*.json
rm "$one".*
expect 0 "$OVERROLL" sweep study.ini --list
[ "$(cat out)" = 'overroll sweep study.ini --task 8' ] || fail "$(cat out)"
expect 0 "$OVERROLL" sweep study.ini -q
[ "$(find study -name '*.json' -newermt 2021-01-01 | wc -l)" -eq 1 ] ||
    fail 'finished cases ran again'
expect 0 "$OVERROLL" sweep study.ini --collect again.csv
numbers again.csv | cmp - one.txt || fail 'run again it is another thing'

# A job array: tasks in any order, some at once, one of them twice
for task in 12 3 7 1 9 5 3; do
    "$OVERROLL" sweep study.ini -o array --task $task -q &
    [ $((task % 2)) -eq 1 ] || wait
done
for task in 2 4 6 8 10 11; do
    expect 0 "$OVERROLL" sweep study.ini -o array --task $task
    contains out "^$task finished seed="
done
wait
expect 0 "$OVERROLL" sweep study.ini -o array --collect array.csv
numbers array.csv | cmp - one.txt || fail 'a job array computes another thing'

# Blocks of tasks: their borders lie where they are asked for, and states of
# tasks outside a block do not count
expect 0 "$OVERROLL" sweep study.ini -o blocks --tasks 2-5 -j 2
[ "$(cut -d' ' -f1,2 out)" = "$(printf '%s finished\n' 2 3 4 5)" ] ||
    fail "$(cat out)"
[ "$(find blocks -name '*.json' | wc -l)" -eq 4 ] || fail 'no block of four'
expect 0 "$OVERROLL" sweep study.ini -o blocks --tasks 1-1 -q
expect 0 "$OVERROLL" sweep study.ini -o blocks --tasks 5-12 -q
expect 0 "$OVERROLL" sweep study.ini -o blocks --collect blocks.csv
numbers blocks.csv | cmp - one.txt || fail 'blocks compute another thing'
for block in 0-2 3-2 2-13 2 2- -3 2-x; do
    refuses 'I-J with whole numbers from 1 to 12' sweep study.ini \
        "--tasks=$block"
done

# GNU parallel
if parallel --version 2>/dev/null | grep -q GNU; then
    mkdir bin
    ln -s "$OVERROLL" bin/overroll
    "$OVERROLL" sweep study.ini -o 'by parallel' --list >list
    [ "$(wc -l <list)" -eq 12 ] || fail "$(cat list)"
    PATH=$PWD/bin:$PATH parallel -j 2 <list >out 2>err || fail "$(cat err)"
    expect 0 "$OVERROLL" sweep study.ini -o 'by parallel' --collect p.csv
    numbers p.csv | cmp - one.txt || fail 'GNU parallel: another thing'
fi

# Another base case: what is there is not of this study any more
sed 's/^Rq = .*/Rq = 0.02/' base.ini >rougher.ini
mv rougher.ini base.ini
expect 3 "$OVERROLL" sweep study.ini
contains out '12 changed'
contains out '^--redo'
expect 0 "$OVERROLL" sweep study.ini --redo -j 2
contains out '12 cases: 12 finished'

lists_failures yes

# What is wrong is said before anything runs
wrong() {
    printf '%s\n' "$2" "$3" >wrong.ini
    refuses "$1" sweep wrong.ini
    [ ! -e wrong ] || fail 'a folder was made for a wrong study'
}
wrong '^wrong.ini:2: .*did you mean .viscosity' \
    '[product]' 'lubricant.viscocity = 1 Pa.s, 2 Pa.s'
wrong '^wrong.ini:2: .*contact.M: .log 1 to.* must be .log A to B in N' \
    '[product]' 'contact.M = log 1 to 5'
wrong 'A and B must be above 0' '[product]' 'contact.M = log 0 to 5 in 3'
wrong 'same unit' '[product]' 'contact.load = linear 1 N/m to 2 kN/m in 3'
wrong '^wrong.ini:2: .*value of the list is missing' \
    '[product]' 'contact.M = 1,,2'
wrong "did you mean 'product'" '[prodct]' ''
wrong "did you mean 'output'" '[study]' 'outptu = a'
wrong 'given twice' '[product]' 'contact.M = 1, 1'
wrong "'contact.alpha' is given twice, in .contact. and in .lubricant." \
    '[product]' 'lubricant.alpha = 15 1/GPa, 20 1/GPa
contact.alpha = 10 1/GPa, 12 1/GPa'
wrong 'must come before' 'contact.M = 1, 1' ''
wrong 'none.ini: ' '[study]' 'case = none.ini'
wrong 'more than a million|must be' '[product]' 'feature.a.seed = 1..1000002'
printf '[zip]\ncontact.M = 1, 2\ncontact.L = 1, 2, 3\n' >wrong.ini
refuses '^wrong.ini:3: .*3 values, but contact.M has 2' sweep wrong.ini
refuses 'from 1 to 12' sweep study.ini --task 13
refuses 'whole number from 1' sweep study.ini -j 0
refuses 'must end with .csv' sweep study.ini --collect x.txt
refuses 'cannot be written' sweep study.ini -o /nonexistent/x

# netCDF-4
expect 0 "$OVERROLL" sweep study.ini --collect all.nc
contains err '^all.nc: written, 12 of 12 cases finished'
need ncdump
expect 0 ncdump -v seed,M,scheme,H_min all.nc
contains out 'case = 12'
contains out '^ seed = 1, 1, 1, 1, 2,'
contains out 'upstream1'
