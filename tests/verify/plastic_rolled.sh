#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A dent rolled over, against an independent program of another scheme (its
# shoulders on level 8: Y = 0.75 p_h 241.0 and 238.5 nm after one and two
# overrollings, levels 7 to 9 within 0.4 %; bearing steel 245.3 nm, 0.2 nm
# gone), with its mean between nodes, `gap`; steps that are no whole node.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/indent.sh"
need_python json h5py

{
    indent 8 12 -9
    printf '%s\n' 'every = 1000' '[stress]' 'depth_max = 0.5'
} >dent.ini
cat >soft.ini <<'END'
[plastic]
hardening = linear
yield = 0.75
modulus = 4.52 GPa
END
cat dent.ini soft.ini >soft_dent.ini
{
    cat dent.ini
    echo '[plastic]'
} >steel.ini

expect 0 "$OVERROLL" run soft_dent.ini -o soft.h5 -q --set plastic.passes=2 \
    --set domain.faces=gap
expect 0 "$OVERROLL" run steel.ini -o steel.h5 -q --set domain.faces=gap
expect 0 "$PYTHON" - <<'END'
import h5py
rows = h5py.File("soft.h5")
h = rows["shoulder_height_trailing"][...] * 1e9
assert abs(h[0] / 241.0 - 1) < 0.004 and abs(h[1] / 238.5 - 1) < 0.004, h
lead = rows["shoulder_height_leading"][...] * 1e9
assert (abs(lead - 245.4) < 0.2).all(), lead
steel = h5py.File("steel.h5")
a, scale = steel["plastic/surface_1"].attrs, steel.attrs["scale_height"] * 1e9
assert abs(a["shoulder_height_trailing"] * scale - 245.3) < 0.2
assert a["profile_change_max"] * scale < 0.5
assert 2e-4 < a["plastic_strain_max"] < 2e-3
END

# Steps of whole nodes, and of 0.7 and 0.9 of one: what flows is that of the
# material, wherever the nodes are.
for step in 0.0065104 0.0045 0.0059; do
    expect 0 "$OVERROLL" run soft_dent.ini -o part.h5 --force -q --json \
        --set domain.level=7 --set time.step=$step --set time.scheme=upstream2
    mv out "$step.json"
done
expect 0 "$PYTHON" - <<'END'
import json
a, b, c = (json.load(open(n + ".json"))
           for n in ("0.0065104", "0.0045", "0.0059"))
first = 245.24
for other in (b, c):
    lost = [first - v["shoulder_height_trailing_m"] * 1e9 for v in (a, other)]
    assert abs(lost[1] / lost[0] - 1) < 0.25, lost
END
