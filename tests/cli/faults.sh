#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Events that affect a file during the run: full disk, removed or replaced
# file, second writer. Each causes a message of one line, earlier data remain
# readable, and resume continues.
. "$TOP/tests/support/cli.sh"

dent_case 6 3 0.1 0.5 -3.6 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 1
compression = 0
checkpoint = 10 ms
END

# one_line PATTERN: err is one line that matches.
one_line() {
    [ "$(wc -l <err)" -eq 1 ] || fail "not one line: $(cat err)"
    contains err "$1"
}

# same A B: the same content.
same() {
    for file in "$1" "$2"; do
        "$OVERROLL" export "$file" >"$file.history" || fail "export $file"
        "$OVERROLL" export "$file" --all >"$file.snapshots"
    done
    cmp "$1.history" "$2.history" || fail "$1 and $2: other history"
    cmp "$1.snapshots" "$2.snapshots" || fail "$1 and $2: other snapshots"
}

# failed PATTERN: what must be true after a run that could not write.
failed() {
    one_line "$1"
    expect 0 "$OVERROLL" info a.h5
    contains out 'status +failed'
    [ ! -e a.h5.journal ] || fail 'a journal is left'
    expect 0 "$OVERROLL" resume a.h5 -q
    same a.h5 whole.h5
    rm -f a.h5*
}

expect 0 "$OVERROLL" run dent.ini -o whole.h5 -q
size=$(wc -c <whole.h5)

# No room: a limit on the size of files stands for the full disk
for part in 3 5 8; do
    blocks=$((size * part / 10 / 512))
    expect 1 sh -c "trap '' XFSZ; ulimit -f $blocks;
        exec '$OVERROLL' run dent.ini -o a.h5 -q"
    failed '^a.h5: cannot be written: File too large'
done

# However near to the limit the last flush was: with one at each step the next
# snapshot is the one that does not fit
for part in 20 25 35 51 57; do
    blocks=$((size * part / 100 / 512))
    expect 1 sh -c "trap '' XFSZ; ulimit -f $blocks;
        exec '$OVERROLL' run dent.ini -o a.h5 -q --set 'output.checkpoint=1 us'"
    failed '^a.h5: cannot be written: File too large'
done

# None for the headers: known before anything is solved
expect 2 sh -c "trap '' XFSZ; ulimit -f 8;
    exec '$OVERROLL' run dent.ini -o a.h5 -q"
one_line '^a.h5: cannot be written: File too large'
for file in a.h5 a.h5.part a.h5.journal; do
    [ ! -e $file ] || fail "$file is left behind"
done
rm -f a.h5*

# A disk that is really full (unmounted by its whole path: in a chroot without
# /proc another is not found)
trap 'umount "$PWD/full" 2>/dev/null' EXIT
if mkdir full && mount -t tmpfs -o size=$((size / 2)) none full 2>/dev/null
then
    expect 1 "$OVERROLL" run dent.ini -o full/a.h5 -q
    one_line '^full/a.h5(.restart)?: cannot be written: No space left'
    expect 0 "$OVERROLL" info full/a.h5
    cp full/a.h5 full/a.h5.restart .
    umount "$PWD/full" || fail 'full stays mounted'
    expect 0 "$OVERROLL" resume a.h5 -q
    same a.h5 whole.h5
    rm -f a.h5*
fi

# start: a long run in the background, under way, its process id in $pid
start() {
    "$OVERROLL" run dent.ini --set time.end=10000 -o a.h5 -q >out 2>err &
    pid=$!
    begins a.h5
}

finish() {
    code=0
    wait $pid || code=$?
    [ $code -eq "$1" ] || fail "exit code $code, wanted $1: $(cat err)"
}

# Removed, and replaced
start
rm a.h5
finish 1
one_line '^a.h5: was removed or replaced'
[ ! -e a.h5 ] || fail 'a.h5 came back'
rm -f a.h5*
start
cp whole.h5 b.h5 && mv b.h5 a.h5
finish 1
one_line '^a.h5: was removed or replaced'
cmp a.h5 whole.h5 || fail 'the other file was written to'
rm -f a.h5*

# A second writer
start
mv out out.first && mv err err.first
refuses '^a.h5: another process is writing it' resume a.h5
refuses '^a.h5: another process is writing it' run dent.ini -o a.h5 --force
kill -s INT $pid
finish 130
expect 0 "$OVERROLL" info a.h5
contains out 'status +stopped'
exit 0
