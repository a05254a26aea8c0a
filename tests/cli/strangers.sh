#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A result of unknown origin: its title and name execute no command in gnuplot,
# ffmpeg or a shell, and temporary names next to the output follow no links.
. "$TOP/tests/support/faults.sh"
need gnuplot

mkdir caught
cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[time]
end = 1
[feature dent]
surface = 1
shape = dent
depth = 0.1
width = 0.5
start = -1.5
[output]
every = 5
END
# one line of the case, too long for one here
tr -d '\n' >>dent.ini <<'END'
title = @m `touch caught/1` '. system('touch caught/2') . ! touch caught/3
 $(touch caught/4) \ "`touch caught/5`" {/=90 x}_{y}^z %s %n
END
echo >>dent.ini
name="-it's \`touch caught_6\` | touch caught_7 @m.h5"
expect 0 "$OVERROLL" run dent.ini -o "./$name" -q
expect 0 "$OVERROLL" info "./$name"
contains out '.touch caught/1.*touch caught/5'

for kind in snapshot map history; do
    expect 0 "$OVERROLL" plot "./$name" --kind $kind -o $kind.svg \
        --script $kind.gp
    expect 0 gnuplot $kind.gp
done
contains snapshot.svg 'touch caught/2'
expect 0 "$OVERROLL" frames "./$name" -o all --size 320x240 --time 0:0.3
expect 0 "$OVERROLL" plot "./$name" -o '|touch caught_8;.png'
[ -s '|touch caught_8;.png' ] || fail 'no picture of that name'
[ -z "$(ls -A caught; find . -name 'caught_*')" ] || fail "ran: $(ls . caught)"

# Links where plot, view and frames put what is not whole yet.
echo precious >victim
mkdir linked
ln -s victim .a.png.part
ln -s victim .a.png.gp
ln -s victim .p.html.part
ln -s ../victim linked/.frame_0000.png.part
ln -s ../victim linked/.frame_0000.png.gp
expect 0 "$OVERROLL" plot "./$name" -o a.png
expect 0 "$OVERROLL" view "./$name" -o p.html
expect 0 "$OVERROLL" frames "./$name" -o linked --size 320x240 --time 0:0.3
[ "$(cat victim)" = precious ] || fail 'a link was followed'
for file in a.png p.html linked/frame_0000.png; do
    { [ -s $file ] && [ ! -L $file ]; } || fail "$file is no file of its own"
done
[ "$(find . -name '.?*' | wc -l)" -eq 0 ] || fail "left: $(ls -A . linked)"

# What cannot be taken away is not written into.
mkdir -p .b.png.gp/full
refuses 'cannot be created' plot "./$name" -o b.png
[ ! -e b.png ] || fail 'b.png was drawn'
rm -r .b.png.gp

# Another user's link in a shared folder, which cannot be taken away either.
if can_fault; then
    for hidden in .c.png.gp .c.png.part; do
        ln -s victim $hidden
        expect 2 env FAULT_KEEP=${hidden#.c} LD_PRELOAD=./faults.so \
            "$OVERROLL" plot "./$name" -o c.png
        contains err 'cannot be created'
        [ "$(cat victim)" = precious ] || fail "$hidden was followed"
        rm -f $hidden
    done
    [ ! -e c.png ] || fail 'c.png was drawn'
fi

# The same in the folder of a sweep.
cat >study.ini <<'END'
[study]
case = dent.ini
[product]
contact.M = 10, 20
END
mkdir swept
ln -s ../victim swept/M=10.ini
expect 3 "$OVERROLL" sweep study.ini -o swept
contains err "^swept/M=10.ini: cannot be written"
[ "$(cat victim)" = precious ] || fail 'a link was followed by a sweep'
[ -s swept/M=20.json ] || fail 'a link in one case stops another'

# A link that the user names is the user's.
ln -s elsewhere.csv named.csv
expect 0 "$OVERROLL" export "./$name" -o named.csv --force
[ -s elsewhere.csv ] || fail 'a link that was named is not followed'

command -v ffmpeg >/dev/null || { echo 'no ffmpeg: no movie tried'; exit 0; }
ln -s victim .-y.gif.part
for movie in -y.gif 'm%d %05d.gif' "http:it's.gif" 'tee:a|b.gif'; do
    expect 0 "$OVERROLL" frames "./$name" --movie="$movie" --size 320x240
    contains "./$movie" '^GIF8'
done
[ "$(cat victim)" = precious ] || fail 'a link was followed by a movie'
