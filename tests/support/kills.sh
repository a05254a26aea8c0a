# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# For the kill tests: KILLS runs of a small case are killed with SIGKILL at
# random instants.  Each file must open, hold a prefix of the true result, and
# be resumed to the identical end.
. "$TOP/tests/support/cli.sh"

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

# compare.py PART WHOLE [all]: values to the bit; with `all` also the shapes
# and every attribute that holds no date.
cat >compare.py <<'END'
import sys
import h5py
import numpy
part, whole = h5py.File(sys.argv[1], "r"), h5py.File(sys.argv[2], "r")
everything = len(sys.argv) > 3
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
if everything:
    attributes("/", part, whole)
part.visititems(visit)
END

kill_test() {
    need_python h5py numpy
    expect 0 "$OVERROLL" run dent.ini -o whole.h5 -q
    unborn=0 unbegun=0 repaired=0 k=0
    while [ $k -lt "$KILLS" ]; do
        k=$((k + 1))
        rm -f a.h5*
        after=$(awk -v seed="$SEED$k" -v most="$MOST" \
            'BEGIN { srand(seed); print 0.01 + most * rand() }')
        timeout -s KILL "$after" "$OVERROLL" run dent.ini -o a.h5 -q \
            >/dev/null 2>&1 </dev/null
        [ -f a.h5 ] || { # killed before the file had its name
            unborn=$((unborn + 1))
            continue
        }
        if "$OVERROLL" info a.h5 >out 2>err; then
            "$PYTHON" compare.py a.h5 whole.h5 >out 2>&1 ||
                fail "kill $k after $after s: $(tail -n 1 out)"
        else
            grep -q 'resume. repairs it' err ||
                fail "kill $k after $after s: $(cat err)"
        fi
        expect 0 "$OVERROLL" resume a.h5
        grep -q 'repaired' err && repaired=$((repaired + 1))
        grep -q 'begins again' err && unbegun=$((unbegun + 1))
        "$PYTHON" compare.py a.h5 whole.h5 all >out 2>&1 ||
            fail "kill $k after $after s, resumed: $(tail -n 1 out)"
    done
    [ $unborn -lt "$KILLS" ] || fail 'all killed before their files were made'
    echo "$KILLS kills: $unborn before the file had its name, $unbegun before" \
        "the first checkpoint, $repaired repaired; all resumed to the same end"
}
