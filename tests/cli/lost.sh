#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# No data are lost: outputs never replace inputs, failures leave no partial
# files and keep existing ones, closed streams and file systems without locks
# are handled, and SIGHUP ends a run like SIGTERM.
. "$TOP/tests/support/faults.sh"
make_dent
expect 0 "$OVERROLL" run dent.ini -o a.h5 -q

# ---------------------------------------------- the same file read and written
# unharmed FILE COMMAND...: it is refused, and FILE stays as it is.
unharmed() {
    cp "$1" kept
    file=$1
    shift
    expect 2 "$OVERROLL" "$@"
    contains err 'is an input file|would replace'
    cmp -s "$file" kept || fail "$*: $file was written to"
}
ln -s a.h5 link.h5
ln a.h5 hard.h5
for path in a.h5 ./a.h5 link.h5 hard.h5; do
    unharmed a.h5 export a.h5 -o $path --force
    unharmed a.h5 view a.h5 -o $path --force
done
ln -s a.h5 link.svg
unharmed a.h5 plot a.h5 -o link.svg --force
unharmed a.h5 plot a.h5 -o a.svg --script link.svg --force
printf 'x_um,z_um\n0,0\n100,0\n200,-0.2\n300,0\n400,0\n' >p.csv
unharmed p.csv profile p.csv --convert p.csv --force
ln -s p.csv p.png
unharmed p.csv profile p.csv --plot p.png --force
unharmed dent.ini run dent.ini -o dent.ini --force
unharmed load.txt run dent.ini -o load.txt --force
ln -s load.txt load.h5
unharmed load.txt run dent.ini --set output.file=load.h5 --force
cp dent.ini b.h5.restart
unharmed b.h5.restart run b.h5.restart -o b.h5
[ ! -e b.h5 ] || fail 'a refused run made a file'
sed '/^\[feature/,/^start/d; /^\[load/,/^file/d' dent.ini >ridge.ini
printf '[feature p]\nshape = profile\nfile = p.csv\nstart = -2\n' >>ridge.ini
unharmed p.csv run ridge.ini -o p.csv --force
printf '[study]\ncase = dent.ini\n[product]\ncontact.M = 10, 20\n' >study.csv
unharmed study.csv sweep study.csv --collect study.csv

# -------------------------------------------------- half files, others' files
echo before >r.csv
for file in p.csv nothing.h5; do
    expect 2 "$OVERROLL" export $file -o r.csv --force
    [ "$(cat r.csv)" = before ] || fail "a refused read took r.csv away"
done
expect 2 "$OVERROLL" export r.csv -o r.csv --force
[ "$(cat r.csv)" = before ] || fail "an input was deleted"
# A field that cannot be read, after heads were written
"$OVERROLL" export a.h5 --snapshot 0 >/dev/null || fail 'export'
size=$(wc -c <a.h5)
cp a.h5 torn.h5
dd if=/dev/zero of=torn.h5 bs=1 seek=$((size / 2)) count=$((size / 3)) \
    conv=notrunc 2>/dev/null
if ! "$OVERROLL" export torn.h5 --all -o r.csv --force 2>err; then
    [ "$(cat r.csv)" = before ] || fail 'half a table replaced a whole file'
fi
[ -z "$(find . -name '.*.part')" ] || fail "left: $(find . -name '.*.part')"
if [ -c /dev/full ]; then
    expect 1 "$OVERROLL" export a.h5 -o /dev/full --force
    [ -c /dev/full ] || fail '/dev/full is gone'
    expect 1 "$OVERROLL" init -o /dev/full --force
fi
ln -s elsewhere.csv named.csv
expect 0 "$OVERROLL" export a.h5 -o named.csv
[ -s elsewhere.csv ] && [ -L named.csv ] || fail 'a named link is not followed'
expect 0 "$OVERROLL" export a.h5 -o named.csv --force
[ -L named.csv ] || fail 'a named link was replaced'

# ------------------------------------------------------------ closed streams
for closed in '<&-' '>&-' '2>&-' '>&- 2>&-' '<&- >&- 2>&-'; do
    rm -f c.h5*
    eval "\"\$OVERROLL\" run dent.ini -o c.h5 $closed" ||
        fail "run $closed: exit code $?"
    "$OVERROLL" export c.h5 --all >c.txt || fail "run $closed: damaged"
    "$OVERROLL" export a.h5 --all | cmp -s - c.txt || fail "run $closed: other"
    rm -rf study
    eval "\"\$OVERROLL\" sweep study.csv -o study $closed" ||
        fail "sweep $closed: exit code $?: $(cat study/*.failed)"
done

# -------------------------------------------------------------------- SIGHUP
sed 's/^end = .*/end = 900/; s/^level = 4/level = 7/' dent.ini >long.ini
sed -i '/^\[load/,/^file/d' long.ini
"$OVERROLL" run long.ini -o h.h5 -q >out 2>err &
run=$!
begins h.h5
kill -HUP $run
code=0
wait $run || code=$?
[ $code -eq 129 ] || fail "after SIGHUP: exit code $code"
expect 0 "$OVERROLL" info h.h5
contains out 'status +stopped'
(
    trap '' HUP # nohup
    exec "$OVERROLL" run long.ini -o n.h5 -q >out 2>err
) &
run=$!
begins n.h5
kill -HUP $run
sleep 0.3
kill -TERM $run
code=0
wait $run || code=$?
[ $code -eq 143 ] || fail "nohup: exit code $code"

# ------------------------------------------- no locks, and a disk that is full
make_faults
for errno in 38 37 95; do # ENOSYS, ENOLCK, EOPNOTSUPP
    rm -rf l.h5* swept
    expect 0 env FAULT_LOCK=$errno LD_PRELOAD=./faults.so "$OVERROLL" \
        run dent.ini -o l.h5
    contains err 'no locks'
    expect 0 env FAULT_LOCK=$errno LD_PRELOAD=./faults.so "$OVERROLL" \
        sweep study.csv -o swept
    contains err 'no locks'
    contains out '2 finished'
done
# Without flock the other lock keeps a second writer, and sweep, out.
rm -rf l.h5* swept
for errno in 38 95; do
    FAULT_FLOCK=$errno LD_PRELOAD=./faults.so \
        "$OVERROLL" run long.ini -o l$errno.h5 -q >out 2>err &
    run=$!
    begins l$errno.h5
    expect 2 env FAULT_FLOCK=$errno LD_PRELOAD=./faults.so \
        "$OVERROLL" resume l$errno.h5
    contains err 'another process is writing it'
    kill -TERM $run
    wait $run
    rm -rf swept
    expect 0 env FAULT_FLOCK=$errno LD_PRELOAD=./faults.so \
        "$OVERROLL" sweep study.csv -o swept
    contains out '2 finished'
    ! grep 'no locks' err || fail 'it has locks of the other kind'
done
expect 0 env FAULT_REPORT=counts LD_PRELOAD=./faults.so "$OVERROLL" \
    run dent.ini -o w.h5 -q
rm -f w.h5*
late=$(($(awk '{ print $2 }' counts) * 3 / 4))
cat >full.c <<'END'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>
#include <unistd.h>
/* From write FULL_AT on no file becomes longer by a snapshot. */
ssize_t pwrite64(int fd, const void *data, size_t bytes, off_t at)
{
    static long writes;
    static ssize_t (*real)(int, const void *, size_t, off_t);
    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "pwrite64");
    if (++writes >= atol(getenv("FULL_AT")) &&
        at + (off_t)bytes > lseek(fd, 0, SEEK_END) && bytes > 20000) {
        errno = ENOSPC;
        return -1;
    }
    return real(fd, data, bytes, at);
}
ssize_t pwrite(int fd, const void *data, size_t bytes, off_t at)
{
    return pwrite64(fd, data, bytes, at);
}
END
"$CC" -shared -fPIC -o full.so full.c -ldl || fail 'full.so'
expect 1 env FULL_AT="$late" LD_PRELOAD=./full.so "$OVERROLL" \
    run dent.ini -o w.h5 -q --set domain.level=9 --set output.compression=0
expect 0 "$OVERROLL" info w.h5
contains out 'status +failed: .*No space left'
