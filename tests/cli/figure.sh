#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Picture of a study in one command: lines, a band over seeds, mean and limits
# equal to those of the summaries; from the study and from its table.
. "$TOP/tests/support/cli.sh"
need gnuplot

cat >base.ini <<'END'
[contact]
load = 100 kN/m
radius = 10 mm
modulus = 220 GPa
viscosity = 40 mPa.s
speed_1 = 1 m/s
speed_2 = 1 m/s
[lubricant]
alpha = 20 1/GPa
[domain]
level = 3
[time]
end = 0.6
[feature rough]
shape = roughness
Rq = 0.1 um
length = 3
start = -2
END
cat >study.ini <<'END'
[study]
case = base.ini
[product]
contact.load = 50 kN/m, 100 kN/m, 200 kN/m
feature.rough.Rq = 0.05 um, 0.1 um
feature.rough.seed = 1, 2, 3
END
refuses 'no case has finished yet' plot study.ini -o none.svg
expect 0 "$OVERROLL" sweep study.ini -q
sed -i 's/^level = 3/level = 4/' base.ini
refuses 'the study was changed after its cases were run \(18 of 18\)' \
    plot study.ini -o none.svg
sed -i 's/^level = 4/level = 3/' base.ini
refuses "no quantity 'H_mim'; did you mean 'H_min'" \
    plot study.ini --quantity H_mim -o none.svg
expect 0 "$OVERROLL" sweep study.ini --collect table.csv -q
expect 0 "$OVERROLL" plot study.ini --quantity H_min -o study.svg \
    --script study.gp
expect 0 "$OVERROLL" plot table.csv --quantity H_min -o table.png \
    --script table.gp
contains table.csv '^task,name,load \[N/m\],Rq \[m\],seed,status,'
contains table.gp "x_label.* = \['load .kN/m.'\]"
grep -v '^#' table.dat >from_csv
grep -v '^#' study.dat | cmp from_csv - ||
    fail 'the CSV table draws another thing'
expect 0 "$OVERROLL" sweep study.ini --collect table.nc -q
expect 0 "$OVERROLL" plot table.nc --quantity H_min -o netcdf.svg \
    --script netcdf.gp
contains netcdf.gp "x_label.* = \['load .kN/m.'\]"
grep -v '^#' study.dat >numbers
grep -v '^#' netcdf.dat | cmp numbers - ||
    fail 'the netCDF table draws another thing'
expect 0 "$OVERROLL" run base.ini -o result.nc -q
expect 0 "$OVERROLL" plot result.nc -o result.svg
for picture in study.svg table.png; do
    [ -s $picture ] || fail "no $picture"
done
contains study.gp "x_label.* = \['load .kN/m.'\]"
contains study.gp "y_label.* = .'minimum film thickness at a node .b²/R.'"
for label in 0.05 0.1; do
    contains study.gp "root mean square roughness = $label µm"
done
contains study.gp "mark.*'band'"

# Load 50 kN/m, Rq 0.05 um: least and largest of the three seeds, and the mean
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "H_min") c = i }
    NR > 1 && $3 == 50000 && $4 < 6e-8 { n++; s += $c
        if (n == 1 || $c < a) a = $c
        if (n == 1 || $c > b) b = $c }
    END { print n, a, b, s / n }' table.csv >wanted
awk 'BEGIN { RS = ""; FS = "\n" } NR == 1 { split($2, a, " ") }
    NR == 3 { split($2, m, " ") } END { print 3, a[2], a[3], m[2] }' \
    study.dat >drawn
paste -d' ' wanted drawn | awk '{ for (i = 1; i <= 4; i++)
    if (($i - $(i + 4)) ^ 2 > 1e-10 * $i ^ 2) exit 1 }' ||
    fail "$(cat wanted drawn)"

# Other choices, and what there is not
expect 0 "$OVERROLL" plot study.ini --quantity min_film_m --against Rq \
    --lines none --panels none --log x -o other.svg --script other.gp
contains other.gp "y_label.* = .'minimum film thickness at a node .(nm|µm).'"
contains other.gp 'log_x.* = \[1\]'
contains other.gp 'band: minimum to maximum over load, seed'
# Values of a geometric series over a decade are drawn logarithmically, unless
# --log says otherwise; those of a smaller range are not.
for range in 'log 50 to 500 kN/m in 4' 'log 50 to 400 kN/m in 4' \
    'linear 50 to 500 kN/m in 4'; do
    printf '[study]\ncase = base.ini\nresults = no\n[set]\ntime.end = 0.1\n' \
        >range.ini
    printf '[product]\ncontact.load = %s\n' "$range" >>range.ini
    expect 0 "$OVERROLL" sweep range.ini -q
    expect 0 "$OVERROLL" plot range.ini -o range.svg --script range.gp --force
    case $range in
    'log 50 to 500'*)
        contains range.gp 'log_x.* = \[1\]'
        expect 0 "$OVERROLL" plot range.ini --log none -o range.svg \
            --script range.gp --force
        contains range.gp 'log_x.* = \[0\]'
        ;;
    *) contains range.gp 'log_x.* = \[0\]' ;;
    esac
    rm -r range
done
refuses 'log z: must be x, y, xy or none' plot study.ini --log z -o x.svg
refuses "no key of the study 'depth'; there are load, Rq, seed" \
    plot study.ini --against depth -o x.svg
refuses "no quantity 'film'; .*there are .*H_min" \
    plot study.ini --quantity film -o x.svg
refuses 'exists; --force' plot study.ini -o study.svg
printf 'a,b\n1,2\n' >no.csv
refuses 'is not the table of a study' plot no.csv -o x.svg
cp no.csv no.nc
refuses 'not an HDF5 file' plot no.nc -o x.svg

# What the study says itself: its first key in the units it was written in, the
# film in metres where the contact has a size, the study's name, over what the
# band is.
expect 0 "$OVERROLL" plot study.ini -o plain.svg --script plain.gp
contains plain.gp "^title = 'study'"
contains plain.gp 'minimum film thickness over the run .(nm|µm).'
contains plain.gp "label.*'band: minimum to maximum over seed'"

# Against a seed: a histogram of all cases in %, and quantiles.
expect 0 "$OVERROLL" plot study.ini --quantity H_min --against seed \
    --lines Rq --panels none -o seeds.svg --script seeds.gp
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "H_min") c = i }
    NR > 1 && $4 < 6e-8 { print $c }' table.csv | sort -g |
    awk '{ v[NR - 1] = $1 } END { n = split("0.05 0.5 0.95", p, " ")
        for (k = 1; k <= n; k++) { a = p[k] * (NR - 1); i = int(a)
            printf "%.17g\n", v[i] + (a - i) * (v[i + 1] - v[i]) } }' >wanted
awk 'BEGIN { RS = ""; FS = "\n" } NR >= 2 && NR <= 4 { split($2, a, " ")
    print a[1] }' seeds.dat >drawn
paste wanted drawn | awk '($1 - $2) ^ 2 > 1e-20 * $1 ^ 2 { exit 1 }
    END { if (NR != 3) exit 1 }' || fail "quantiles: $(cat wanted drawn)"
awk 'BEGIN { RS = ""; FS = "\n" } NR == 1 { for (i = 2; i < NF; i += 2) {
    split($i, a, " "); s += a[2] } exit (s - 100) ^ 2 > 1e-6 }' seeds.dat ||
    fail 'the histogram does not hold all cases'
sed 's/^feature.rough.seed.*/feature.rough.seed = 1..3/
    /^contact.load/d; /rough.Rq/d' study.ini >only.ini
expect 0 "$OVERROLL" sweep only.ini -q
expect 0 "$OVERROLL" plot only.ini -o only.svg --script only.gp
contains only.gp "y_label.* = \['cases .%.'\]"

# A [zip NAME] is an axis; a third key makes panels, a fourth too; turning
# speeds are drawn as they were written, from tables too.
cat >discs.ini <<'END'
[contact]
width = 10 mm
load = 2000 N
speed_1 = 1000 rpm
speed_2 = 1000 rpm
[body 1]
material = steel
radius = 35 mm
[body 2]
material = steel
radius = 35 mm
[lubricant]
viscosity = 40 mPa.s
alpha = 20 1/GPa
[domain]
level = 4
END
cat >speeds.ini <<'END'
[study]
case = discs.ini
[product]
lubricant.alpha = 15 1/GPa, 20 1/GPa
lubricant.viscosity = 20 mPa.s, 40 mPa.s
[zip turning]
contact.speed_1 = 1000 rpm, 1000 rpm, 3000 rpm
contact.speed_2 = 1000 rpm, 2000 rpm, 3000 rpm
[product]
domain.level = 4, 5
END
expect 0 "$OVERROLL" sweep speeds.ini -q
expect 0 "$OVERROLL" plot speeds.ini --against turning -o zip.svg \
    --script zip.gp
contains zip.gp "x_label.* = \['speed of surface 2 .rpm.'"
contains zip.gp "note.* = \['viscosity = 20 mPa.s, grid level = 4', "
contains zip.gp 'x_from.* = \[920\.'
grep -q 'band:' zip.gp && fail 'a band that no seed makes'
expect 0 "$OVERROLL" plot speeds.ini --lines turning -o lines.svg
contains lines.svg 'speed of surface 2 = 3000 rpm'
expect 0 "$OVERROLL" sweep speeds.ini --collect speeds.nc -q
expect 0 "$OVERROLL" plot speeds.nc --against speed_1 -o rpm.svg \
    --script rpm.gp
expect 0 "$OVERROLL" plot speeds.nc --against turning -o turning.svg
contains rpm.gp "x_label.* = \['speed of surface 1 .rpm.'"
refuses "no key of the study 'wheels'; there are .*speed_1, turning, speed_2" \
    plot speeds.ini --against wheels -o x.svg
