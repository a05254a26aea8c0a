#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Keys that have another name today are understood by the one that they had,
# which is said: in a file, in --set, in the columns of a sweep, in `find` and
# in what `check --rewrite` prints.  Help and completion know today's alone.
. "$TOP/tests/support/cli.sh"

cat >old.ini <<'END'
[gear]
module = 3 mm
teeth_1 = 20
teeth_2 = 40
centre = 90 mm
face = 20 mm
speed = 3000 rpm
  least_share = 0.03   # of the load
[contact]
hertz_pressure = 0.8 GPa
modulus = 226 GPa
[lubricant]
viscosity = 0.02 Pa.s
alpha = 2e-8 1/Pa
[domain]
level = 4
END
said="'least_share' in \[gear\] is called 'min_share' now; the old name is"
expect 0 "$OVERROLL" check old.ini
contains err "^overroll: old.ini:8: $said"
contains out '^min_share = 0.03$'
expect 0 "$OVERROLL" check old.ini --set gear.least_radius=0.06 \
    --set gear.min_share=0.04
contains err "^overroll: --set: 'least_radius' in \[gear\] is called "
! grep -q least_share err || fail 'a name that was replaced is told'
contains out '^min_share = 0.04$'
contains out '^min_radius = 0.06$'

# Today's words, which nothing is said of
expect 0 "$OVERROLL" check --rewrite old.ini
contains out '^  min_share = 0.03   # of the load    # was called least_share$'
cp out new.ini
expect 0 "$OVERROLL" check new.ini
! grep -q 'is called' err || fail "$(cat err)"
contains out '^min_share = 0.03$'

# By both names it is given twice
sed 's/^face.*/min_share = 0.01/' old.ini >twice.ini
expect 2 "$OVERROLL" check twice.ini
contains err "'least_share' is given twice in .* .first in line 6, as min_s"
sed 's/least_share/leest_share/' old.ini >slip.ini
expect 2 "$OVERROLL" check slip.ini
contains err "unknown key 'leest_share' in \[gear\]"

# A study's columns are called as its file calls them
printf '[study]\ncase = old.ini\n[product]\ngear.least_share = 0.02, 0.04\n' \
    >study.ini
expect 0 "$OVERROLL" sweep study.ini -q
contains study/manifest.csv '^task,name,least_share,status'
expect 0 "$OVERROLL" sweep study.ini --collect table.csv -q
contains table.csv '^2,least_share=0.04,0.040*1?,finished'
contains study/least_share=0.04.log "$said"

expect 0 "$OVERROLL" help gear
contains out '^ *min_share '
! grep -q least_share out || fail 'help tells an old name'
! grep -q least_share "$BUILD/overroll.bash" || fail 'completion offers it'
