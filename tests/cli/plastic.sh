#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Plastic deformation: no change below yield; otherwise the rim is reduced,
# stored, and used by a later run; a killed run resumes to the same digits;
# rejected input.
. "$TOP/tests/support/cli.sh"
. "$TOP/tests/support/indent.sh"
need_python h5py numpy

{
    indent 6 3.6 -1.8
    printf '%s\n' 'every = 100' 'checkpoint = 10 ms' '[stress]' \
        'depth_max = 0.5'
} >dent.ini
cat >soft.ini <<'END'
[plastic]
hardening = linear
yield = 0.75
modulus = 4.5 GPa
layers = 12
depth_max = 0.2
END
cat dent.ini soft.ini >plastic.ini
grep -v '^modulus = 4.5' plastic.ini >perfect.ini

# Nothing flows: the elastic run, to the bit.
expect 0 "$OVERROLL" run dent.ini -o elastic.h5 -q
expect 0 "$OVERROLL" run plastic.ini -o hard.h5 -q --set plastic.yield=50
expect 0 "$OVERROLL" run plastic.ini -o soft.h5 -q --json
cp out soft.json
expect 0 "$PYTHON" - <<'END'
import h5py, json, numpy as np
e, h, s = (h5py.File(n + ".h5") for n in ("elastic", "hard", "soft"))
for name in ("pressure", "film_thickness"):
    a, b = e[name][...], h[name][...]
    assert a.dtype == b.dtype and (a == b).all(), name
g = h["plastic/surface_1"]
assert g["cumulative"][...].max() == 0 and g["residual_x"][...].max() == 0
assert (g["profile_before"][...] == g["profile_after"][...]).all()

# What flowed: incompressible work above 0, less shoulder, tension and pressure
# left behind, no stress on the surface, and balanced on each section.
g = s["plastic/surface_1"]
d = json.load(open("soft.json"))
a = g.attrs
assert a["work"] > 0 and a["plastic_strain_max"] > 1e-3
assert abs(a["plastic_strain_max"] / d["plastic_strain_max"] - 1) < 1e-6
lost = a["shoulder_before_trailing"] - a["shoulder_height_trailing"]
assert 0.002 < lost / a["shoulder_before_trailing"] < 0.05, lost
assert abs(a["shoulder_before_leading"] / a["shoulder_height_leading"] - 1) \
    < 2e-3
x, z = g["residual_x"][...], g["residual_z"][...]
assert x.min() < 0 < x.max()
# a mean over the first layer, a mesh thick as what changes along it
assert abs(z[0]).max() < min(0.1 * abs(x[0]).max(), 0.5 * abs(z[1]).max())
assert (e["film_thickness"][-1] != s["film_thickness"][-1]).any()
e_x, e_z = g["plastic_strain_x"][...], g["plastic_strain_z"][...]
assert (e_x[0] * e_z[0]).min() < 0
assert g["profile_after"].shape == g["material"].shape
END

# It goes on where another run ended: less flows than did at first.
expect 0 "$OVERROLL" run plastic.ini -o next.h5 -q --set plastic.initial=soft.h5
expect 0 "$PYTHON" - <<'END'
import h5py
a, b = (h5py.File(n + ".h5")["plastic/surface_1"] for n in ("soft", "next"))
first, both = a.attrs["plastic_strain_max"], b.attrs["plastic_strain_max"]
assert first < both < 2 * first, (first, both)
assert b.attrs["work"] < a.attrs["work"]
assert (b["cumulative"][...] >= a["cumulative"][...]).all()
END
expect 2 "$OVERROLL" run plastic.ini -o bad.h5 -q \
    --set plastic.initial=elastic.h5
contains err 'contains no plastic strains of surface 1'
expect 2 "$OVERROLL" run plastic.ini -o bad.h5 -q --set domain.level=5 \
    --set plastic.initial=soft.h5
contains err 'its window or layers differ'

# Killed and resumed: the same end.
for more in 'plastic.coupling=step' 'plastic.initial=soft.h5'; do
    rm -f part.h5 part.h5.restart
    expect 0 "$OVERROLL" run plastic.ini --force -o whole.h5 -q --set "$more"
    "$OVERROLL" run plastic.ini -o part.h5 -q --set "$more" &
    pid=$!
    tries=0
    while { [ ! -e part.h5 ] || [ ! -e part.h5.restart ]; } &&
        [ "$tries" -lt 500 ]; do
        sleep 0.01
        tries=$((tries + 1))
    done
    sleep 0.1
    kill -9 "$pid" 2>/dev/null || :
    wait "$pid" 2>/dev/null || :
    expect 0 "$OVERROLL" resume part.h5 -q
    content whole.h5 >1.txt
    content part.h5 >2.txt
    cmp 1.txt 2.txt || fail "resumed run differs: $more"
done

# What a pass does to a profile that it does not feel is near what it does to
# one that it does, while that changes by little of the film; the film is the
# elastic one.
expect 0 "$OVERROLL" run plastic.ini -o once.h5 -q --set plastic.coupling=pass
expect 0 "$PYTHON" - <<'END'
import h5py
once, soft, elastic = (h5py.File(n + ".h5")
                       for n in ("once", "soft", "elastic"))
assert (once["pressure"][...] == elastic["pressure"][...]).all()
a, b = (f["plastic/surface_1"].attrs for f in (once, soft))
lost = [v["shoulder_before_trailing"] - v["shoulder_height_trailing"]
        for v in (a, b)]
assert 0.5 < lost[0] / lost[1] < 2, lost
assert a["plastic_strain_max"] > b["plastic_strain_max"]
END

# The profiles as files: that from before is the dent, that from after is what
# [feature] shape = profile reads, with less of its shoulder.
expect 0 "$OVERROLL" run plastic.ini -o again.h5 -q --set plastic.profiles=left
expect 0 "$OVERROLL" info again.h5
! grep -q '^input' out || fail 'a file that is written is an input'
expect 0 "$PYTHON" - <<'END'
import h5py, numpy as np
g = h5py.File("again.h5")["plastic/surface_1"]
for name in ("before", "after"):
    x, z = np.loadtxt("left-%s.csv" % name, delimiter=",", skiprows=1).T
    assert abs(x * 1e-6 - g["material"][...]).max() < 1e-12
    assert abs(z * 1e-6 - g["profile_" + name][...]).max() < 1e-14
END
# The middle of 256 points is half a mesh behind the dent's.
sed -e '/^shape = /,/^width/d' -e 's/^start = .*/centre = -1.80652/' \
    dent.ini >file.ini
for name in before after; do
    expect 0 "$OVERROLL" run file.ini -o "$name.h5" -q --json \
        --set feature.dent.shape=profile --set feature.dent.level=none \
        --set feature.dent.file="left-$name.csv"
    cp out "$name.json"
done
expect 0 "$OVERROLL" run dent.ini -o shape.h5 -q --json
expect 0 "$PYTHON" - out before.json after.json <<'END'
import json, sys
dent, before, after = (json.load(open(n))["P_max_overall"]
                       for n in sys.argv[1:])
assert abs(before / dent - 1) < 1e-4 and after < dent * 0.998
END

# A picture of it; of a run without there is none.
expect 2 "$OVERROLL" plot elastic.h5 --kind plastic -o none.png
contains err 'contains no plastic/surface_1'
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot soft.h5 --kind plastic -o soft.png
    [ -s soft.png ] || fail 'no soft.png'
fi

# Overrollings: each begins where the one before ended, from the same steady
# contact; killed between two of them, the same end.
expect 0 "$OVERROLL" run plastic.ini -o passes.h5 -q --set plastic.passes=3
expect 0 "$OVERROLL" info passes.h5
contains out '^trailing +trailing rim height, at the end of the pass'
grep -q meniscus out && fail 'a column without a number is listed'
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot passes.h5 -o passes.svg
    contains passes.svg 'rim height '
fi
expect 0 "$PYTHON" - <<'END'
import h5py
g = [h5py.File(n)["plastic/surface_1"] for n in
     ("soft.h5", "next.h5", "passes-1.h5", "passes-2.h5", "passes-3.h5")]
soft, following, one, two, three = g
for name in ("cumulative", "plastic_strain_xz", "residual_x", "profile_after"):
    assert (soft[name][...] == one[name][...]).all(), name
    assert (following[name][...] == two[name][...]).all(), name
assert (three["cumulative"][...] >= two["cumulative"][...]).all()
h = [a.attrs["shoulder_height_trailing"] for a in (one, two, three)]
assert h[0] > h[1] > h[2], h
assert h[1] - h[2] < h[0] - h[1], h
P = [h5py.File("passes-%d.h5" % k)["pressure"][0] for k in (1, 2)]
# the dent begins in the domain, and at its foot with what is left of it
assert 0 < abs(P[0] - P[1]).max() < 1e-4 * P[0].max()
END
"$OVERROLL" run plastic.ini -o cut.h5 -q --set plastic.passes=3 &
pid=$!
tries=0
while { [ ! -e cut-2.h5 ] || [ ! -e cut-2.h5.restart ]; } &&
    [ "$tries" -lt 500 ]; do
    sleep 0.01
    tries=$((tries + 1))
done
kill -9 "$pid" 2>/dev/null || :
wait "$pid" 2>/dev/null || :
expect 0 "$OVERROLL" resume cut.h5 -q
for k in 1 2 3; do
    content passes-$k.h5 >1.txt
    content cut-$k.h5 >2.txt
    cmp 1.txt 2.txt || fail "pass $k of the resumed run differs"
done

# What has shaken down ends: bearing steel does, in two.
expect 0 "$OVERROLL" run perfect.ini -o steel.h5 -q --json \
    --set plastic.passes=6 --set plastic.hardening=swift \
    --set plastic.yield=1.1
contains out '"shaken_down": true'
contains out '"passes": [23]'
expect 0 "$OVERROLL" resume steel.h5
contains err 'is already complete'

# What the case says, and what is refused.
expect 0 "$OVERROLL" check plastic.ini
contains out 'surface 1: yield stress Y = 0.75 p_h'
contains out 'shakedown limit 1.732 p_h'
contains out '12 layers down to 0.2 b'
refused() {
    pattern=$1
    shift
    expect 2 "$OVERROLL" check plastic.ini "$@"
    contains err "$pattern"
}
refused 'exceeds the shakedown limit' --set plastic.yield=0.4
expect 0 "$OVERROLL" check plastic.ini --set plastic.yield=0.4 \
    --set plastic.anyway=yes
expect 2 "$OVERROLL" check perfect.ini --set plastic.hardening=none \
    --set plastic.yield=0.45
contains err 'shakes down too slowly'
refused 'surface 2 needs its stresses' --set plastic.surface=2
expect 2 "$OVERROLL" check perfect.ini --set plastic.hardening=swift \
    --set plastic.swift=945
contains err 'must be B, C, n'
refused 'needs a modulus' --set plastic.modulus=0
sed '/^\[time\]/,/^end/d' plastic.ini >steady.ini
expect 2 "$OVERROLL" check steady.ini
contains err 'set time.end'
grep -v '^\[stress\]\|^depth_max = 0.5' plastic.ini >none.ini
expect 2 "$OVERROLL" check none.ini
contains err 'needs its stresses'

# A pass before the others in which nothing yields: what elastic stresses
# foretell, to the digits of the run that cannot yield; the passes behind it are
# those of the run without it.
# From outside, so that all material has a whole material history.
sed -e 's/^start = .*/start = -4.5/' -e 's/^end = .*/end = 6.6/' \
    plastic.ini >passes.ini
cat >>passes.ini <<'END'
passes = 2
[fatigue]
limit_pressure = none
raceway = 20 mm
END
expect 0 "$OVERROLL" run passes.ini -o with.h5 -q --json \
    --set plastic.elastic=yes
cp out with.json
expect 0 "$OVERROLL" run passes.ini -o without.h5 -q --json
cp out without.json
expect 0 "$OVERROLL" run passes.ini -o stiff.h5 -q --json \
    --set plastic.passes=1 --set plastic.yield=50
cp out stiff.json
expect 0 "$PYTHON" - <<'END'
import h5py, json
a, b, c = (json.load(open(n + ".json")) for n in ("with", "without", "stiff"))
assert a["passes"] == 3 and b["passes"] == 2
for key in ("equivalent_length", "life_ratio", "plastic_strain_max",
            "shoulder_height_trailing"):
    assert a[key] == b[key], key
for key in ("equivalent_length", "life_ratio"):
    assert a[key + "_elastic"] == c[key] != a[key], key
assert "life_ratio_elastic" not in b
last, end = (h5py.File(n + ".h5")["film_thickness"][-1]
             for n in ("with-3", "without-2"))
assert (last == end).all()
first, end = (h5py.File(n + ".h5")["film_thickness"][-1]
              for n in ("with-1", "stiff"))
assert (first == end).all()
END
expect 2 "$OVERROLL" check passes.ini --set plastic.elastic=yes \
    --set cavitation.model=conserving --set passes.number=2 \
    --set passes.loads='1, 0.9'
contains err 'the first of passes.loads'

# Coarser levels begin no pass with strains of their own: no errors are told
# from the second pass on.
expect 0 "$OVERROLL" run passes.ini -o told.h5 --force --estimate-error
contains err 'no error estimates from this pass on, because the bodies start'
expect 0 "$PYTHON" - <<'END'
import h5py, numpy as np
e = h5py.File("told.h5")["central_film_thickness_error"][...]
assert e[0] > 0 and np.isnan(e[1]), e
END

# Strains that are not small are said to be beyond the model.
expect 0 "$OVERROLL" run perfect.ini -o thin.h5 --set plastic.yield=0.5 \
    --set plastic.hardening=none --set plastic.anyway=yes \
    --set plastic.iterations=100 --set feature.dent.shoulder='1.2 um'
contains err 'beyond the small-strain model'
expect 0 "$OVERROLL" run plastic.ini -o soft.h5 --force
[ "$(grep -c 'small strains' err)" -eq 0 ] || fail 'small strains are not small'

# A study over the hardness of the raceway: the softer, the less is left.
cat >study.ini <<'END'
[study]
case = plastic.ini
[product]
plastic.yield = 0.7, 0.8, 50
END
expect 0 "$OVERROLL" sweep study.ini -q
expect 0 "$OVERROLL" sweep study.ini --collect study.csv -q
expect 0 "$PYTHON" - <<'END'
import csv
rows = list(csv.reader(open("study.csv")))
head = [name.split(" [")[0] for name in rows[0]]
column = lambda key: [float(r[head.index(key)]) for r in rows[1:]]
left, strain = column("shoulder_height_trailing"), column("plastic_strain_max")
assert left[0] < left[1] < left[2], left
assert strain[0] > strain[1] > strain[2] == 0, strain
END

# Bodies exchanged, in sliding under traction: the same film, strains and
# stresses to the bit.  Rolling alike and without traction both bodies feel the
# same pressure, so that both yield alike.
expect 0 "$OVERROLL" run plastic.ini -o upper.h5 -q --set plastic.yield=0.62 \
    --set lubricant.rheology=eyring --set lubricant.eyring_stress=5MPa \
    --set contact.speed_1=3.4m/s --set contact.speed_2=2.6m/s
expect 0 "$OVERROLL" run plastic.ini -o lower.h5 -q --set plastic.yield=0.62 \
    --set lubricant.rheology=eyring --set lubricant.eyring_stress=5MPa \
    --set contact.speed_1=2.6m/s --set contact.speed_2=3.4m/s \
    --set feature.dent.surface=2 --set stress.surface=2 \
    --set plastic.surface=2
expect 0 "$OVERROLL" run plastic.ini -o both.h5 -q --set stress.surface=both \
    --set plastic.surface=both
expect 0 "$PYTHON" - <<'END'
import h5py
u, l, b, s = (h5py.File(n + ".h5") for n in ("upper", "lower", "both", "soft"))
for name in ("pressure", "film_thickness"):
    assert (u[name][...] == l[name][...]).all(), name
one, two = u["plastic/surface_1"], l["plastic/surface_2"]
assert one.attrs["plastic_strain_max"] > 1e-4
names = ("plastic_strain_x", "plastic_strain_z", "plastic_strain_xz",
         "cumulative", "residual_x", "residual_z", "residual_xz",
         "profile_after")
for name in names:
    assert (one[name][...] == two[name][...]).all(), name
assert abs(one["plastic_strain_xz"][...]).max() > 0
one, two = b["plastic/surface_1"], b["plastic/surface_2"]
assert one.attrs["plastic_strain_max"] > 1e-3
for name in names[:-1]:
    assert (one[name][...] == two[name][...]).all(), name
# Two bodies share what one alone would bear: each flows less.
assert one.attrs["work"] < s["plastic/surface_1"].attrs["work"]
END

# Layers of the body's own moduli yield as it does; on the other body a layer
# of a hundred half widths is that body; others on what yields are refused.
expect 0 "$OVERROLL" run plastic.ini -o alike.h5 -q --json \
    --set 'coating 1.thickness=20 um' --set 'coating 1.modulus=206 GPa' \
    --set 'coating 1.residual_x=-1 GPa'
cp out alike.json
expect 0 "$OVERROLL" run plastic.ini -o deep.h5 -q --json \
    --set 'coating 2.thickness=20 mm' --set 'coating 2.modulus=100 GPa'
cp out deep.json
expect 0 "$OVERROLL" run plastic.ini -o half.h5 -q --json \
    --set 'body 2.modulus=100 GPa'
cp out half.json
refuses 'deformation cannot be combined with .*modulus = 205 GPa' \
    check plastic.ini --set 'coating 1.thickness=20 um' \
    --set 'coating 1.modulus=205 GPa'
expect 0 "$PYTHON" - <<'END'
import json
soft, alike, deep, half = (json.load(open(n + ".json"))
                           for n in ("soft", "alike", "deep", "half"))
for a, b, most in ((soft, alike, 1e-6), (half, deep, 1e-4)):
    assert a["plastic_strain_max"] > 1e-3
    for key in ("plastic_strain_max", "shoulder_height_trailing", "H_min"):
        assert abs(b[key] / a[key] - 1) < most, (key, a[key], b[key])
END
