#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Utilization of the yield stress of layers and of the strength of interfaces:
# for one layer its maximum von Mises stress divided by the yield stress, for
# two layers the larger utilization.
. "$TOP/tests/support/cli.sh"
need_python json

cat >case.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
speed_1 = 3.0 m/s
speed_2 = 3.0 m/s
[body 1]
modulus = 206 GPa
[body 2]
modulus = 206 GPa
[coating 1]
thickness = 0.3
modulus = 400 GPa
[coating 1b]
thickness = 0.3
modulus = 120 GPa
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
[domain]
level = 6
[time]
end = 6.5
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -4
[output]
every = 1
[stress]
surface = 1
END
expect 0 "$OVERROLL" run case.ini -o none.h5 --json
cp out none.json
for upper in none '3 GPa'; do
    for lower in none '0.4 GPa'; do
        expect 0 "$OVERROLL" run case.ini -o both.h5 --json --force \
            --set "coating 1.yield=$upper" --set "coating 1b.yield=$lower"
        cp out "$upper-$lower.json"
    done
done
expect 0 "$OVERROLL" run case.ini -o words.h5 --set 'coating 1.yield=3 GPa'
contains out '^layer stress / yield stress '
contains out '^tension across an interface +[0-9.e-]+ +p_h .* Z = '
contains out '^tension at the surface +none'
for limit in upper:1:'2 GPa' lower:1b:'0.5 GPa'; do
    coat=${limit#*:}
    expect 0 "$OVERROLL" run case.ini -o "${limit%%:*}_limit.h5" --json \
        --set "coating ${coat%%:*}.limit_pressure=${limit##*:}" \
        --set 'fatigue.criterion=von-mises'
    cp out "${limit%%:*}_limit.json"
done
expect 0 "$OVERROLL" run case.ini -o words.h5 --force \
    --set 'coating 1.limit_pressure=2 GPa' --set 'fatigue.alpha=0.3'
contains out '^layer stress / fatigue limit '
expect 0 "$OVERROLL" run case.ini -o strong.h5 --json \
    --set 'coating 1.interface_strength=0.5 GPa' \
    --set 'coating 1b.interface_strength=0.5 GPa'
cp out strong.json
expect 0 "$OVERROLL" run case.ini -o upper.h5 --json \
    --set 'coating 1.interface_strength=0.5 GPa'
cp out upper.json
expect 0 "$OVERROLL" run case.ini -o lower.h5 --json \
    --set 'coating 1b.interface_strength=0.1 GPa'
cp out lower.json
expect 0 "$OVERROLL" run case.ini -o words.h5 --force \
    --set 'coating 1.interface_strength=0.5 GPa'
contains out '^interface stress / strength '
expect 0 "$PYTHON" - <<'END'
import json
def of(name):
    return json.load(open(name + ".json"))
none = of("none-none")
assert "layer_utilisation" not in none
largest = none["layer_von_mises_max_Pa"]
upper = of("3 GPa-none")["layer_utilisation"]
lower = of("none-0.4 GPa")["layer_utilisation"]
both = of("3 GPa-0.4 GPa")["layer_utilisation"]
assert abs(max(upper * 3e9, lower * 0.4e9) / largest - 1) < 1e-9
assert lower > upper and both == lower, (upper, lower, both)
strong, upper, lower = (of(name) for name in ("strong", "upper", "lower"))
used = strong["interface_utilisation"]
assert "interface_utilisation" not in none
assert abs(used * 0.5e9 / none["interface_shear_max_Pa"] - 1) < 1e-9
# By von Mises' criterion the limit is 0.558 of the limiting pressure, Poisson's
# ratio 0.3 (Johnson, Contact Mechanics, 4.3), and what is used of it what is
# used of such a yield, but for points at the ends of the material.
assert "layer_fatigue" not in none
for which, yields, limit, Y in (("upper", "3 GPa-none", 2.0, 3.0),
                                ("lower", "none-0.4 GPa", 0.5, 0.4)):
    ratio = (of(which + "_limit")["layer_fatigue"] * limit * 0.558 /
             (of(yields)["layer_utilisation"] * Y))
    assert abs(ratio - 1) < 5e-3, (which, ratio)
# One of the two has the larger shear; the other's is its own, and smaller.
of_each = (upper["interface_utilisation"] * 0.5,
           lower["interface_utilisation"] * 0.1)
assert abs(max(of_each) / (used * 0.5) - 1) < 1e-9, (used, of_each)
assert 0 < min(of_each) < 0.98 * max(of_each), of_each
END

# Of an empty [stress] too; without it the keys have no effect, which is said
sed '/^surface = 1/d' case.ini >bare.ini
expect 0 "$OVERROLL" check bare.ini --set 'coating 1.yield=3 GPa'
sed '/^\[stress\]/d' bare.ini >without.ini
refuses 'yield: has no effect without \[stress\]' \
    check without.ini --set 'coating 1.yield=3 GPa'

# Steel yields below a layer of its own moduli as it does without; 12/16 MLMI of
# layers makes 1e-6. Below one of other moduli residual stresses are not known.
"$OVERROLL" init indented >indented.ini
sed -i 's/^modulus = 226 GPa .*//; s/^level = .*/level = 6/
    s/^number = .*/number = 1/
    s/^eyring_stress = .*/eyring_stress = 5 MPa/' indented.ini
for case in bare coated stiff; do
    {
        cat indented.ini
        printf '[body 1]\nmodulus = 206 GPa\n'
        printf '[body 2]\nmodulus = 206 GPa\n'
        [ "$case" = bare ] || printf '[coating 1]\nthickness = 0.3\n'
        [ "$case" = coated ] && printf 'modulus = 206 GPa\n'
        [ "$case" = stiff ] && printf 'modulus = 300 GPa\n'
    } >"$case.ini"
done
expect 0 "$OVERROLL" run bare.ini -o bare.h5 --json -q
cp out bare.json
expect 0 "$OVERROLL" run coated.ini -o coated.h5 --json -q
cp out coated.json
refuses 'cannot be combined with \[coating\] modulus = 300 GPa' check stiff.ini
expect 0 "$PYTHON" - <<'END'
import json
bare, coated = (json.load(open(name + ".json")) for name in ("bare", "coated"))
assert bare["plastic_strain_max"] > 1e-4  # an Eyring oil presses less
for key in ("plastic_strain_max", "profile_change_max", "H_cen_mean"):
    assert abs(coated[key] / bare[key] - 1) < 1e-5, key
END
