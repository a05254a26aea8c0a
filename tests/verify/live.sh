#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Other programs read a file while it is written: h5py polls at 5 Hz during a
# whole run and compares every row with the final file. The newest row may still
# be NaN, and one retry is allowed.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

dent_case 8 24 0.1 0.5 -4.6 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 4
END
cat >poll.py <<'END'
import sys
import time
import h5py
import numpy

def look():
    with h5py.File("a.h5", "r") as f:
        times = f["time"][...]
        rows = int((~numpy.isnan(times)).sum())
        seen = {"time": times[:rows]}
        for name in "pressure", "film_thickness":
            seen[name] = f[name][max(0, rows - 20):rows]
        seen["H"] = f["history/min_film_thickness"][...]
        return f.attrs["status"], rows, seen

looks, retries, kept = 0, 0, []
while True:
    try:
        status, rows, seen = look()
    except (OSError, RuntimeError, KeyError, ValueError):
        retries += 1
        status, rows, seen = look()
    looks += 1
    kept.append((rows, seen))
    if status != "running":
        break
    time.sleep(0.2)
with h5py.File("a.h5", "r") as f:
    for rows, seen in kept:
        assert (f["time"][:rows] == seen["time"]).all()
        for name in "pressure", "film_thickness":
            true = f[name][max(0, rows - 20):rows]
            assert true.tobytes() == seen[name].tobytes(), (name, rows)
        true = f["history/min_film_thickness"][:len(seen["H"])]
        assert true.tobytes() == seen["H"].tobytes()
assert status == "complete" and retries < 2, (status, retries)
print(looks, "looks,", retries, "retries,", len({k[0] for k in kept}),
      "different lengths")
END
"$OVERROLL" run dent.ini -o a.h5 -q >out 2>err &
while [ ! -f a.h5 ]; do sleep 0.05; done
"$PYTHON" poll.py || fail 'a reader saw something wrong'
wait $! || fail "the run failed: $(cat err)"
