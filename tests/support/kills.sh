# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# For the kill tests: runs of a small case are killed with SIGKILL, KILLS of
# them at random instants, and where a library can be put before the program
# one at every STRIDE-th write to a file.  Each file must open, here and in
# HDF5, and hold a prefix of the true result, or be known as cut; each must be
# resumed to the identical end.
. "$TOP/tests/support/faults.sh"

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 6
[time]
end = 6
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4.6
[output]
every = 2
checkpoint = 10 ms
END

# compare.py WHOLE PART...: values to the bit; after --all also the shapes and
# every attribute that holds no date.
cat >compare.py <<'END'
import sys
import h5py
import numpy
everything = sys.argv[1] == "--all"
names = sys.argv[1 + everything:]
whole = h5py.File(names[0], "r")
def attributes(name, a, b):
    assert list(a.attrs) == list(b.attrs), name + ": other attributes"
    for key in a.attrs:
        if key.startswith("date_") or key == "history":
            continue
        if key in ("DIMENSION_LIST", "REFERENCE_LIST"):
            continue
        u, v = numpy.asarray(a.attrs[key]), numpy.asarray(b.attrs[key])
        assert u.tobytes() == v.tobytes() or u == v, name + "@" + key
def visit(name, a):
    b = whole[name]
    if everything:
        attributes(name, a, b)
    if isinstance(a, h5py.Dataset):
        rows = a.shape[0]
        assert rows <= b.shape[0], name + ": too long"
        assert not everything or a.shape == b.shape, name + ": too short"
        assert a[...].tobytes() == b[:rows].tobytes(), name + ": differs"
for name in names[1:]:
    with h5py.File(name, "r") as part:
        print(name)
        if everything:
            attributes("/", part, whole)
        part.visititems(visit)
END

kill_test() {
    need_python h5py numpy
    began=$(date +%s.%N)
    expect 0 "$OVERROLL" run dent.ini -o whole.h5 -q
    most=$(awk -v a="$began" -v b="$(date +%s.%N)" 'BEGIN { print b - a }')
    unborn=0 unbegun=0 repaired=0 k=0
    while [ $k -lt "$KILLS" ]; do
        k=$((k + 1))
        rm -f a.h5*
        after=$(awk -v seed="$SEED$k" -v most="$most" \
            'BEGIN { srand(seed); print most * rand() }')
        timeout -s KILL "$after" "$OVERROLL" run dent.ini -o a.h5 -q \
            >/dev/null 2>&1 </dev/null
        [ -f a.h5 ] || { # killed before the file had its name
            unborn=$((unborn + 1))
            continue
        }
        if "$OVERROLL" info a.h5 >out 2>err; then
            "$PYTHON" compare.py whole.h5 a.h5 >out 2>&1 ||
                fail "kill $k after $after s: $(tail -n 1 out)"
        else
            grep -q 'resume. restores' err ||
                fail "kill $k after $after s: $(cat err)"
        fi
        expect 0 "$OVERROLL" resume a.h5
        grep -q 'was interrupted' err && repaired=$((repaired + 1))
        grep -q 'starts again' err && unbegun=$((unbegun + 1))
        "$PYTHON" compare.py --all whole.h5 a.h5 >out 2>&1 ||
            fail "kill $k after $after s, resumed: $(tail -n 1 out)"
    done
    [ $unborn -lt "$KILLS" ] || fail 'all killed before their files were made'
    echo "$KILLS kills: $unborn before the file had its name, $unbegun before" \
        "the first checkpoint, $repaired repaired; all resumed to the same end"
}

# The instants that matter lie within a commit, and are short.
# shellcheck disable=SC2086 # words on purpose, names without blanks
kill_writes_test() {
    need_python h5py numpy
    make_faults
    short='--set domain.level=4 --set time.end=0.5'
    expect 0 env FAULT_REPORT=counts LD_PRELOAD=./faults.so "$OVERROLL" \
        run dent.ini -o short.h5 -q $short --set 'output.checkpoint=1 us'
    writes=$(awk '{ print $2 }' counts)
    cuts=0 readable='' k=${STRIDE:-1}
    while [ $k -le "$writes" ]; do
        expect 137 env FAULT_KILL=$k LD_PRELOAD=./faults.so "$OVERROLL" \
            run dent.ini -o $k.h5 -q $short --set 'output.checkpoint=1 us'
        [ ! -f $k.h5 ] || look_at_killed $k.h5
        k=$((k + STRIDE))
    done
    "$PYTHON" compare.py short.h5 $readable >out 2>&1 ||
        fail "killed at a write: $(tail -n 2 out)"
    for file in [0-9]*.h5; do
        expect 0 "$OVERROLL" resume "$file" -q
    done
    "$PYTHON" compare.py --all short.h5 [0-9]*.h5 >out 2>&1 ||
        fail "killed at a write, resumed: $(tail -n 2 out)"
    [ $cuts -gt 0 ] || fail "none of $writes writes was within a commit"
    echo "killed at every ${STRIDE}th of $writes writes, $cuts within a commit"
}

# $cuts or $readable grows.
look_at_killed() {
    if "$OVERROLL" info "$1" >out 2>err; then
        readable="$readable $1"
    else
        contains err 'last write was interrupted'
        cuts=$((cuts + 1))
    fi
}
