#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A dataset that cannot be read is an error, not a column less.
. "$TOP/tests/support/cli.sh"
need_python h5py
cat >dent.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[time]
end = 0.2
END
expect 0 "$OVERROLL" run dent.ini -o a.h5 -q

# One byte of the header of a dataset is another.
"$PYTHON" - >out 2>&1 <<'END' || fail "$(cat out)"
import shutil
import h5py
for path in "film_thickness", "history/load":
    with h5py.File("a.h5", "r") as f:
        at = h5py.h5o.get_info(f[path].id).addr + 30
    name = path.split("/")[-1] + ".h5"
    shutil.copy("a.h5", name)
    with open(name, "r+b") as f:
        f.seek(at)
        byte = f.read(1)[0]
        f.seek(at)
        f.write(bytes([byte ^ 0x55]))
END
refuses "cannot read 'film_thickness'" info film_thickness.h5
refuses "cannot read 'film_thickness'" export film_thickness.h5
refuses "cannot read 'history/load'" info load.h5
refuses "cannot read 'history/load'" export load.h5 --all

# Texts that another program put beside the numbers are not in the way.
"$PYTHON" - >out 2>&1 <<'END' || fail "$(cat out)"
import h5py
with h5py.File("a.h5", "a") as f:
    f.create_dataset("remark", data="by another")
END
expect 0 "$OVERROLL" info a.h5
