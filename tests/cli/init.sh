#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# init: every kind with every oil is a valid case, and each kind runs.
. "$TOP/tests/support/cli.sh"

for kind in roller gear cam bearing indented numbers starved; do
    for oil in paper vg32 vg68 vg100 vg220; do
        expect 0 "$OVERROLL" init $kind --oil $oil
        mv out $kind.ini
        expect 0 "$OVERROLL" check $kind.ini
        [ ! -s err ] || fail "$kind, $oil: $(cat err)"
    done
    expect 0 "$OVERROLL" run $kind.ini --level 5 --set time.end=0.3
    ! grep 'not realistic' out || fail "$kind: a friction that no oil has"
    [ -f $kind.h5 ] || fail "no $kind.h5"
done
# An inlet that is chosen by itself is in the report of check and is no message.
contains_domain='^#   domain +X = -4\.[0-9]+ to 1\.5; an inlet at X = -4 would'
expect 0 "$OVERROLL" init roller
mv out roller.ini
expect 0 "$OVERROLL" check roller.ini
contains out "$contains_domain reduce the central film thickness by 0\.[0-9]+ %"
expect 0 "$OVERROLL" check roller.ini --set domain.inlet=-5
! grep "$contains_domain" out || fail 'a reason for an inlet that was given'
expect 0 "$OVERROLL" init discs
mv out discs.ini
expect 0 "$OVERROLL" check discs.ini
[ ! -s err ] || fail "discs: $(cat err)"
expect 0 "$OVERROLL" steady discs.ini --level 6
contains out '^sliding friction coefficient +0\.0'
# Nor has the demo, of which this is the case.
expect 0 "$OVERROLL" steady "$TOP/profiles/dent.ini" --level 6
contains out '^sliding friction coefficient +0\.0'
expect 0 "$OVERROLL" init hot
mv out hot.ini
expect 0 "$OVERROLL" check hot.ini
[ ! -s err ] || fail "hot: $(cat err)"
expect 0 "$OVERROLL" run hot.ini --level 5 -o hot.h5
expect 0 "$OVERROLL" init coated
mv out coated.ini
expect 0 "$OVERROLL" check coated.ini
contains out '^#   coating 1 +thickness 0\.01[0-9]+ b'
[ ! -s err ] || fail "coated: $(cat err)"
expect 0 "$OVERROLL" run coated.ini --level 7 -o coated.h5
contains out '^von Mises stress in a layer '
# A turn of the cam on its own level, whose inlet and outlet are exchanged
expect 0 "$OVERROLL" init cam
mv out cam.ini
expect 0 "$OVERROLL" run cam.ini -o turn.h5
! grep warning err || fail "cam: $(cat err)"
expect 0 "$OVERROLL" init strip
mv out strip.ini
expect 0 "$OVERROLL" check strip.ini
contains out '^#   strip +2 b wide, periodic; 449 x 96 nodes'
[ ! -s err ] || fail "strip: $(cat err)"
expect 0 "$OVERROLL" run strip.ini --level 4 --set time.end=0.3
[ -f strip.h5 ] || fail "no strip.h5"
refuses "'discs' has an oil of its own" init discs --oil vg32
expect 0 "$OVERROLL" init gear -o gear2.ini
refuses 'gear2.ini: exists already' init gear -o gear2.ini
refuses "no case 'gaer'; did you mean gear" init gaer
refuses "no oil 'vg46'" init --oil vg46

# A value put in, with its comment kept; a key that was not there; mistakes.
expect 0 "$OVERROLL" init gear --set 'gear.module=3 mm' --set gear.shift_1=0.1
grep -q '^module = 3 mm  *# normal' out || fail "$(cat out)"
mv out gear3.ini
expect 0 "$OVERROLL" check gear3.ini -v
grep -q '^shift_1 = 0.1' out || fail "no shift: $(cat out)"
refuses 'modul' init gear --set gear.modul=3mm
refuses 'unit' init gear --set gear.module=3
expect 0 "$OVERROLL" init bearing --set 'feature.dent.depth=0.2 um' -o own.ini
contains own.ini '^depth = 0.2 um'
expect 0 "$OVERROLL" check own.ini

# The web page offers the same kinds.
expect 0 "$OVERROLL" init --help
sed -n '/^Kinds of cases/,/^--set/s/^  \([a-z]*\)  .*/\1/p' out | sort >kinds
sed -n '/^const KINDS = /,/;$/p' "$TOP/src/web/app_run.js" |
    grep -o '"[a-z]*"' | tr -d '"' | sort >offered
grep -qx strip kinds || fail "kinds: $(cat kinds)"
diff kinds offered || fail 'the page offers other kinds'

# The depths of a coated contact follow its level.
expect 0 "$OVERROLL" init coated -o layered.ini
for level in 5 6 7 8 9; do
    expect 0 "$OVERROLL" check layered.ini --level $level
    if grep warning err; then
        fail "init coated --level $level warns"
    fi
done

# Each kind runs without a warning on the level that it sets. The cam is above;
# bearing, indented and strip, which take longer, are in verify/init.sh.
for kind in roller coated starved discs hot numbers gear; do
    expect 0 "$OVERROLL" init $kind -o quiet.ini --force
    expect 0 "$OVERROLL" run quiet.ini -o quiet.h5 --force
    if grep warning err; then
        fail "init $kind warns"
    fi
done

# overroll(1) lists every kind of the help
"$OVERROLL" init --help |
    sed -n '/^Kinds/,/^--set/s/^  \([a-z]*\) .*/\1/p' >kinds
[ "$(wc -l <kinds)" -ge 11 ] || fail "kinds: $(cat kinds)"
sed -n '/^.BI "init "/,/^.TP/p' "$TOP/src/cli/overroll.1" >page
while read -r kind; do
    grep -Eq "^\.(B|BR) $kind( |\$)" page ||
        fail "overroll(1) lacks $kind"
done <kinds
