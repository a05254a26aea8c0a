#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# check rejects what run rejects before the solution, with the same message and
# line; numbers in messages have no sign of zero, rounding errors or infinity.
. "$TOP/tests/support/cli.sh"

# both_refuse PATTERN CASE
both_refuse() {
    refuses "$1" check "$2"
    cp err checked
    refuses "$1" run "$2" -o never.h5
    cmp -s err checked || fail "run: $(cat err); check: $(cat checked)"
}

printf '[contact]\nM = 20\nL = 10\n[domain]\nlevel = 5\n[stress]\n' >plain.ini
printf '[fatigue]\ncriterion = dang-van\n' | cat plain.ini - >dangvan.ini
both_refuse '^dangvan.ini:8: criterion = dang-van .* set time.end$' dangvan.ini
sed 's/M = 20/M = 0.02/; s/L = 10/L = 2/' plain.ini >depth.ini
both_refuse '^depth.ini:6: depth_max = 2.5 b is below .* 17.58 b .4 mesh' \
    depth.ini
echo 'depth_min = 0.001' | cat plain.ini - >half.ini
both_refuse '^half.ini:7: depth_min = 0.001 b .* at least 0.01228 b' half.ini
cat >thin.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 10 mm
mean_speed = 3 m/s
[body 1]
modulus = 206 GPa
[body 2]
modulus = 206 GPa
[coating 2]
modulus = 60 GPa
thickness = 1 nm
[lubricant]
viscosity = 20 mPa.s
alpha = 17 1/GPa
[domain]
level = 5
END
both_refuse '^thin.ini:9: .coating 2. is 0.00023 mesh sizes thick' thin.ini
expect 0 "$OVERROLL" check thin.ini --set 'coating 2.thickness=1 um'

# A sign before the scales are known: nothing about an upper bound.
cat >feature.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[time]
end = 0.4
[feature f]
surface = 1
shape = step
height = 0.001
arrival = 6
END
sed 's/^shape.*/shape = dent/; s/^height.*/depth = -1 um/' feature.ini >sign.ini
echo 'width = 1' >>sign.ini
both_refuse '^sign.ini:11: depth: -1 um must not be negative$' sign.ini
sed -i 's/^depth.*/depth = 0.1/; s/^width.*/width = 0 um/' sign.ini
both_refuse '^sign.ini:13: width: 0 um must be above 0$' sign.ini

# A step has no other end.
expect 0 "$OVERROLL" check feature.ini
contains err "is at X <= -5.475 when the run ends at T = 0.4"

# At the pitch point nothing slides; at the nose the follower stands still.
expect 0 "$OVERROLL" init gear -o gear.ini
expect 0 "$OVERROLL" check gear.ini
contains out '^# C( +[0-9.]+){4} +0( +[0-9.]+){3} +0$'
expect 0 "$OVERROLL" init cam -o cam.ini
expect 0 "$OVERROLL" check cam.ini
! grep -E ' -0( |$)|e-1[0-9]' out || fail 'signs of zero or rounding'
contains out '^#   expected discretization error +0\.00[0-9]* at most '

# A measured trace has a mean wavelength, a wave its own.
awk 'BEGIN { for (i = 0; i < 200; i++)
    print i * 0.005, 0.01 * sin(0.7 * i) }' >trace.txt
sed '/^shape/,$d' feature.ini >trace.ini
echo 'shape = profile
file = trace.txt
unit_x = b
unit_z = b^2/R' >>trace.ini
expect 0 "$OVERROLL" check trace.ini
contains out '^#     mean wavelength +0\.06[0-9]*, 2\.'
contains err 'the mean wavelength 0\.06[0-9]* of feature .f. has only'
sed '/^shape/,$d' feature.ini >wave.ini
echo 'shape = wave
amplitude = 0.01
wavelength = 0.1' >>wave.ini
expect 0 "$OVERROLL" check wave.ini
contains out '^#     shortest wavelength +0\.1, 4\.0'

# A contact as wide as its roller is no line contact of half-spaces.
cat >wide.ini <<'END'
[contact]
load = 300 kN/m
mean_speed = 2 m/s
modulus = 226 GPa
[body 1]
radius = 24 mm
[body 2]
radius = -24.001 mm
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
END
expect 0 "$OVERROLL" check wide.ini
contains err 'warning: the contact is 88\.[0-9]+ mm wide at a radius of 24 mm'
expect 0 "$OVERROLL" check wide.ini --set 'body 2.radius=-25 mm'
! grep 'mm wide' err || fail 'an ordinary contact is too wide'

# Headers in any encoding; commas that are there.
printf 'x [mm];H\303\266he [um]\n0;1\n0.1;1.2\n0.2;1.1\n0.3;0.7\n' >utf8.csv
expect 0 "$OVERROLL" profile utf8.csv
grep -q "header: \"H$(printf '\303\266')he \[um\]\"" out || fail "$(cat out)"
! grep 'decimal points' out || fail 'decimal commas without a comma'
iconv -f UTF-8 -t LATIN1 utf8.csv | sed 's/1\.2/1,2/' >latin1.csv
expect 0 "$OVERROLL" profile latin1.csv
grep -q "header: \"H$(printf '\303\266')he \[um\]\"" out || fail "$(cat out)"
contains out 'commas are decimal points'

# A window of stored nodes, or of material, that the grid cannot have (check
# printed inf or nan MB)
printf '[output]\nfrom = 1.6\n' | cat plain.ini - >from.ini
both_refuse '^from.ini:8: from: 1.6 b is outside the domain X = -4 to 1.5' \
    from.ini
printf '[output]\nto = -5\n' | cat plain.ini - >to.ini
both_refuse '^to.ini:8: to: -5 b is outside the domain' to.ini
printf '[output]\nfrom = 0.1\nto = 0.1001\n' | cat plain.ini - >thin.ini
both_refuse '^thin.ini:9: to: no node lies between 0.1 b and 0.1001 b' thin.ini
echo 'window = -1e6, 1e6' | cat plain.ini - >material.ini
sed -i 's/^level.*/level = 7/' material.ini
both_refuse '^material.ini:7: a window of -1e.06 to 1e.06 b has .* points' \
    material.ini
expect 0 "$OVERROLL" init indented -o plastic.ini
sed 's/^passes = .*/window = -200, 13.6/' plastic.ini >window.ini
line=$(grep -n '^window' window.ini | cut -d: -f1)
both_refuse "^window.ini:$line: window: -200 to 13.6 b .*: must be 213.5.* b" \
    window.ini
sed 's/^window = .*/window = -200, 13.5/' window.ini >fits.ini
expect 0 "$OVERROLL" check fits.ini
printf '%s\n' '[feature far]' 'shape = indent' 'depth = 1 um' 'width = 0.6' \
    'start = -250' 'surface = 1' | cat plastic.ini - >far.ini
line=$(grep -n '^\[plastic' far.ini | cut -d: -f1)
both_refuse "^far.ini:$line: .* need a window .* plastic.window = FROM, TO" \
    far.ini
refuses '^--set: to: no node lies between 1.001 b and 1.002 b; .* 0.02455 b' \
    run plain.ini -o never.h5 --set output.from=1.001 \
    --set output.to=1.002

# Sections of studies in a case
for section in find random limits; do
    printf '[contact]\nM = 20\nL = 10\n[%s]\n' $section >study.ini
    both_refuse "^study.ini:4: \[$section\] is a section of a study" study.ini
done

# A list where one number is expected is not a decimal comma
refuses "'20, 30' is a list; one number is expected" steady --M '20, 30' --L 10
refuses "'20,5' is not a number: write a point" steady --M '20,5' --L 10
