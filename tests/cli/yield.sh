#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Bodies that yield: what stresses and pressures are over their yield, whether
# plastic strain matters, yields of materials, check, what is stored.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/indent.sh"
need_python json

{
    indent 8 12 -9
    printf '%s\n' 'every = 1000' '[stress]' 'depth_max = 0.5'
} >dent.ini
sed -e '/^\[feature/,/^start/d' -e 's/^end = .*/end = 0.1/' \
    -e 's/^level = .*/level = 6/' -e 's/depth_max = .*/depth_max = 2/' \
    -e 's/^every = .*/every = 1/' dent.ini >smooth.ini
smooth() {
    name=$1
    shift
    expect 0 "$OVERROLL" run smooth.ini --force -o "$name.h5" --json "$@"
    cp out "$name.json"
}

# Without a yield nothing is told; with one nothing else changes.
smooth none
smooth told --set 'body 1.yield=1.36 GPa'
smooth share --set 'body 1.yield=0.9'
smooth soft --set 'body 1.yield=0.54'
smooth steel --set 'body 1.material=steel'
smooth off --set 'body 1.material=steel' --set 'body 1.yield=none'
smooth both --set stress.surface=both --set 'body 1.yield=1.36 GPa' \
    --set 'body 2.yield=1 GPa'
expect 0 "$OVERROLL" stress none.h5 --json --set 'body 1.yield=0.9'
cp out stored.json
expect 0 "$PYTHON" - <<'END'
import json, math
def of(name):
    return json.load(open(name + ".json"))
none, told = of("none"), of("told")
new = set(told) - set(none)
assert new == {"surface_yield", "yield", "yield_Pa", "yield_ratio_max",
               "X_yield_ratio_max", "Z_yield_ratio_max", "T_yield_ratio_max",
               "yielding_share", "yielding_depth", "yielding_depth_m",
               "strip_pressure_max", "X_strip_pressure_max",
               "width_strip_pressure_max", "T_strip_pressure_max",
               "ph_over_first_yield", "ph_over_shakedown"}, new
for key in set(none) - {"seconds", "output", "file", "stored"}:
    assert none[key] == told[key], key
assert "yield" in of("steel") and "yield" not in of("off")
assert abs(of("steel")["yield_Pa"] / 1.36e9 - 1) < 1e-9
ph = told["yield_Pa"] / told["yield"]
assert abs(told["von_mises_max_Pa"] / told["von_mises_max"] / ph - 1) < 1e-9
for case, Y in (("told", 1.36e9 / ph), ("share", 0.9), ("soft", 0.54),
                ("stored", 0.9)):
    t = of(case)
    assert abs(t["yield"] / Y - 1) < 1e-9, t["yield"]
    f = t["von_mises_max"] / Y - 1
    assert abs(t["yield_ratio_max"] - f) < 1e-9
    for axis in "XZT":
        assert (t[axis + "_yield_ratio_max"] == t[axis + "_von_mises_max"])
    # first yield of Hertz's contact at 1.79367 Y, shakedown at 4 Y/sqrt 3
    assert abs(t["ph_over_first_yield"] * 1.7936699 * Y - 1) < 1e-6
    assert abs(t["ph_over_shakedown"] * 4 / math.sqrt(3) * Y - 1) < 1e-9
    # the film's pressure is Hertz's to some per cent: so is its yield
    ratio = (t["yield_ratio_max"] + 1) / t["ph_over_first_yield"]
    assert abs(ratio - 1) < 0.05, ratio
    # a strip of Hertz's bears 0.83 p_h at most
    strip = t["strip_pressure_max"] * (1 + math.pi / 2) * 2 / math.sqrt(3) * Y
    assert 0.75 < strip < 0.9, strip
assert of("told")["yielding_share"] == 0 == of("told")["yielding_depth"]
assert of("soft")["yielding_share"] > 0.01
assert 0.7 < of("soft")["yielding_depth"] < 1.2, of("soft")
assert of("both")["surface_yield"] == 2
assert abs(of("both")["yield_Pa"] / 1e9 - 1) < 1e-9
END

# Sentences: of the smooth contact below first yield (1/1.794 = 0.557), above
# it, and above its shakedown limit (sqrt(3)/4 = 0.433).
while read -r yield words; do
    expect 0 "$OVERROLL" run smooth.ini --force -o words.h5 \
        --set "body 1.yield=$yield"
    contains out '^stress above yield, f/Y '
    contains out '^p_h / p_h at first yield .* p_h at the shakedown limit'
    contains out "plastic strain $words"
done <<'END'
0.9 is negligible: below yield
0.54 matters: the smooth contact yields and shakes down
0.42 matters: the smooth contact exceeds its shakedown limit
END
expect 0 "$OVERROLL" check smooth.ini --set 'body 1.yield=1.36 GPa'
contains out '^#   yield .*1360 MPa: 2439 and 3141 MPa'
expect 0 "$OVERROLL" check smooth.ini
! grep -q '^#   yield' out || fail 'check tells a yield that nobody gave'

# A dent whose stress of 1.95 ph is in a skin: hardened steel, of 1.17 ph, keeps
# all of its shoulder; steel of 0.75 ph loses a twentieth in five passes, as an
# independent elastic-plastic computation has it.
for yield in '1.36 GPa' 0.75; do
    expect 0 "$OVERROLL" run dent.ini --force -o dent.h5 -q --json \
        --set "body 1.yield=$yield"
    cp out "$yield.json"
done
expect 0 "$PYTHON" - <<'END'
import json
hard, soft = (json.load(open(n + ".json")) for n in ("1.36 GPa", "0.75"))
assert hard["P_max_overall"] > 3
assert hard["P_max_overall"] == soft["P_max_overall"]
assert hard["yielding_share"] == 0 and 0 < hard["yielding_depth"] < 0.02
assert soft["yielding_share"] > 0 and soft["yielding_depth"] > 0.04
ratio = soft["strip_pressure_max"] / hard["strip_pressure_max"]
assert abs(ratio / (hard["yield"] / soft["yield"]) - 1) < 1e-9
END
