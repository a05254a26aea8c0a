#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A result file contains the input files of its case: `info --inputs` writes
# them and the case, whose run has the same bits. Names from a file stay inside
# the folder; files are replaced only with --force.
. "$TOP/tests/support/cli.sh"

mkdir -p cases data away
awk 'BEGIN { print "x in um,z in nm"; for (k = 0; k < 300; k++)
    printf "%g,%g\n", k / 2, 40 * sin(k * 0.3) + 9 * sin(k * 0.77) }' \
    >data/scratch.csv
awk 'BEGIN { print "pressure [MPa], viscosity [Pa.s]"
    for (k = 0; k <= 20; k++) printf "%g %.6g\n", 60 * k,
        0.04 * exp(0.017 * 60 * k / (1 + k / 40)) }' >data/oil.txt
awk 'BEGIN { for (k = 0; k <= 20; k++) printf "%g %g\n", k / 10,
    1 + 0.01 * k * k / 400 }' >cases/load.txt
cat >cases/case.ini <<'END'
[contact]
load = 100 kN/m
radius = 12 mm
modulus = 226 GPa
viscosity = 40 mPa.s
speed_1 = 1 m/s
speed_2 = 1 m/s
[lubricant]
viscosity_law = table
viscosity_file = ../data/oil.txt
[domain]
level = 5
[time]
end = 0.5
[load]
history = table
file = load.txt
[feature one]
shape = profile
file = ../data/scratch.csv   # twice
start = -2
[feature two]
shape = profile
surface = 2
file = ../data/scratch.csv
start = -1
END
expect 0 "$OVERROLL" run cases/case.ini -o one.h5 -q
expect 0 "$OVERROLL" info one.h5
sum() {
    sha256sum "$1" | cut -d ' ' -f 1
}
contains out "input .*scratch.csv \(feature one.file\), [0-9]+ bytes"
contains out "bytes, SHA-256 $(sum data/scratch.csv)"
[ "$(grep -c '^input' out)" -eq 3 ] || fail "not three files: $(cat out)"

# Written elsewhere, without the files that the case had
expect 0 "$OVERROLL" info one.h5 --inputs back
for file in scratch.csv oil.txt; do
    cmp data/$file back/$file || fail "$file is another"
done
cmp cases/load.txt back/load.txt || fail 'load.txt is another'
contains out '^back/one.ini$'
[ "$(find back -type f | wc -l)" -eq 4 ] || fail "$(ls back)"
grep -q '^file = scratch.csv *# twice' back/one.ini || fail 'lost a comment'
mv data cases away
expect 0 "$OVERROLL" run back/one.ini -o two.h5 -q
content one.h5 >1.txt
content two.h5 >2.txt
[ "$(wc -c <1.txt)" -gt 10000 ] || fail 'nothing to compare'
cmp 1.txt 2.txt || fail 'the run of the inputs has other bits'
expect 0 "$OVERROLL" info two.h5 --json
contains out '"name": "oil.txt"'

# Stresses of a result need no files but it
sed 's/level = 5/level = 6/' back/one.ini >stress.ini
cp back/scratch.csv back/oil.txt back/load.txt .
expect 0 "$OVERROLL" run stress.ini -o stress.h5 -q
expect 0 "$OVERROLL" stress stress.h5 --json
cp out with.json
rm scratch.csv oil.txt load.txt
expect 0 "$OVERROLL" stress stress.h5 --json
cmp out with.json || fail 'other stresses without the files'
ls -d /tmp/overroll-??????/scratch.csv 2>/dev/null && fail 'left in /tmp'

# Nothing is replaced without --force, nor through a link
echo mine >back/oil.txt
refuses 'exists already; --force' info one.h5 --inputs back
contains back/oil.txt mine
expect 0 "$OVERROLL" info one.h5 --inputs back --force
cmp away/data/oil.txt back/oil.txt || fail 'not replaced'
echo outside >outside
ln -sf ../outside back/load.txt
refuses 'not an ordinary file' info one.h5 --inputs back --force
contains outside outside
refuses 'cannot be written' info one.h5 --inputs outside

# A case without files has no group, and its case is written
sed -e '/^\[load\]/,$d; /viscosity_f/d' \
    -e 's/^viscosity_law.*/alpha = 17 1\/GPa/' away/cases/case.ini >plain.ini
expect 0 "$OVERROLL" run plain.ini -o plain.h5 -q
expect 0 "$OVERROLL" info plain.h5 --inputs plain
cmp plain.ini plain/plain.ini || fail 'the case changed'
expect 0 "$OVERROLL" info plain.h5
grep '^input' out && fail 'inputs of a case without'

# A path from the command line starts at the working directory: the case of the
# result, which stands elsewhere, names that file too.  Files that change are
# no longer those of the run.
mv away/cases away/data .
expect 0 "$OVERROLL" run cases/case.ini -o set.h5 -q \
    --set lubricant.viscosity_file=data/oil.txt
expect 0 "$OVERROLL" resume set.h5 -q --set time.end=0.6
sed 's/0.04/0.05/' data/oil.txt >changed && mv changed data/oil.txt
refuses 'data/oil.txt: has changed since.*--inputs' \
    resume set.h5 --set time.end=0.7
expect 0 "$OVERROLL" info one.h5 --inputs old
cp old/oil.txt data
expect 0 "$OVERROLL" resume set.h5 -q --set time.end=0.7

# More than 4 MB: the checksum alone; the run of the case wants the file
{ cat cases/load.txt && head -c 4300000 /dev/zero | tr '\0' '#' | fold -w 99
} >big.txt
sed -e 's/^file = load.txt/file = big.txt/' -e '/^\[feature/,$d' \
    -e '/viscosity_f/d' -e 's/^viscosity_law.*/alpha = 17 1\/GPa/' \
    cases/case.ini >big.ini
expect 0 "$OVERROLL" run big.ini -o big.h5
contains err 'contains only the SHA-256 of big.txt'
[ "$(wc -c <big.h5)" -lt 1000000 ] || fail 'big.txt is in the result file'
expect 0 "$OVERROLL" info big.h5 --inputs big
contains err "SHA-256 of big.txt \($(sum big.txt)\)"
[ ! -e big/big.txt ] || fail 'written from nowhere'
refuses "big/big.txt: cannot be opened" run big/big.ini -o big2.h5

# Several passes
sed 's/end = 0.5/end = 0.1/' cases/case.ini >cases/passes.ini
cat >>cases/passes.ini <<'END'
[passes]
number = 2
[supply]
model = film
thickness_1 = 0.5
thickness_2 = 0.5
[cavitation]
model = conserving
END
expect 0 "$OVERROLL" run cases/passes.ini -o passes.h5 -q
expect 0 "$OVERROLL" info passes.h5 --inputs passes
cmp data/scratch.csv passes/scratch.csv || fail 'passes hold no profile'
expect 0 "$OVERROLL" run passes/passes.ini -o passes2.h5 -q
content passes-2.h5 >1.txt
content passes2-2.h5 >2.txt
cmp 1.txt 2.txt || fail 'the passes of the inputs have other bits'

# Names and contents of a stranger's file
need_python h5py
"$PYTHON" - <<'END' || fail 'h5py'
import shutil, h5py
def made(to, change):
    shutil.copy("one.h5", to)
    with h5py.File(to, "r+") as f:
        change(f["inputs"])
def name(text):
    return lambda g: g["file_3"].attrs.modify("name", text)
made("up.h5", name("../../up.csv"))
made("root.h5", name("/etc/passwd"))
made("odd.h5", name("a/\x1b[31m\n;#.csv"))
made("dots.h5", name(".."))
made("long.h5", name("x" * 3000 + ".csv"))
made("case.h5", name("case.INI"))
made("twice.h5", name("oil.txt"))
def damage(g):
    g["file_3"][7] = 1
made("bad.h5", damage)
def resize(g):
    g["file_3"].resize((9,))
made("cut.h5", resize)
def huge(g):
    g["file_3"].attrs.modify("bytes", 1e300)
made("huge.h5", huge)
def loose(g):
    del g["file_3"]
made("loose.h5", loose)
END
for name in up root odd dots long case twice; do
    expect 0 "$OVERROLL" info $name.h5 --inputs strange-$name
    [ "$(find strange-$name -type f | wc -l)" -eq 4 ] ||
        fail "$name: $(ls strange-$name)"
    expect 0 "$OVERROLL" check strange-$name/$name.ini -q
done
expect 0 "$OVERROLL" run strange-twice/twice.ini -o strange.h5 -q
content one.h5 >1.txt
content strange.h5 >2.txt
cmp 1.txt 2.txt || fail 'renamed inputs have other bits'
[ ! -e ../up.csv ] || fail 'wrote outside the folder'
expect 1 "$OVERROLL" info bad.h5 --inputs bad
contains err 'does not have the SHA-256.*damaged'
expect 0 "$OVERROLL" info cut.h5 --inputs cut
contains err 'only the SHA-256 of scratch.csv'
expect 0 "$OVERROLL" info huge.h5 --inputs huge
contains err 'only the SHA-256 of scratch.csv'
expect 0 "$OVERROLL" info loose.h5 --inputs loose
contains err 'file .*scratch.csv of feature two.file is not in the result'
