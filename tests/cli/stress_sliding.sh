#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Stresses with a history of the sliding: the material moves with the speed of
# its surface, forward and backward.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.3
[domain]
level = 6
inlet = -4
[time]
end = 3
[feature dent]
shape = dent
surface = 1
depth = 0.1
width = 0.5
start = -2.5
[output]
every = 1
[stress]
surface = both
END

# A sliding that does not change is slide_to_roll
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q
expect 0 "$OVERROLL" stress dent.h5 --json
cp out constant.json
expect 0 "$OVERROLL" stress dent.h5 --json --set contact.slide_to_roll=0.1 \
    --set sliding.history=ramp --set sliding.from=0.3 --set sliding.to=0.3 \
    --set sliding.start=1 --set sliding.duration=1
expect 0 "$PYTHON" - constant.json out <<'END'
import json, sys
a, b = (json.load(open(n)) for n in sys.argv[1:3])
for k in a:
    if isinstance(a[k], float):
        assert abs(a[k] - b[k]) <= 1e-5 * max(1, abs(a[k])), (k, a[k], b[k])
END

# Both surfaces turn: u = 1 +- 1.3 sin(2 pi T/4).  Whole paths by direct sums
# of line loads, at the places where the integral of u takes the material.
expect 0 "$OVERROLL" run dent.ini -o turn.h5 -q --set sliding.history=sine \
    --set sliding.amplitude=2.6 --set sliding.period=4 --set sliding.start=0 \
    --set contact.slide_to_roll=0 --set stress.depth_min=0.4 \
    --set stress.depth_max=0.81 --set stress.depths_per_octave=1
expect 0 "$PYTHON" - turn.h5 <<'END'
import sys, h5py, numpy
f = h5py.File(sys.argv[1])
ph = f.attrs["scale_pressure"]
b = t1 = 1      # of a case by M and L
assert numpy.isnan(f.attrs["scale_length"])
x, T, P = f["x"][...] / b, f["time"][...] / t1, f["pressure"][...] / ph
D = x[1] - x[0]

def fields(P, X, z):
    w = X[:, None] - x[None, :] + 1j * z
    C, dC = 1j * D / (numpy.pi * w) @ P, -1j * D / (numpy.pi * w**2) @ P
    return C.real, z * dC.imag, z * dC.real    # h, d, tau

for k, sign in ((1, 1), (2, -1)):
    U = T + sign * 1.3 * 4 / (2 * numpy.pi) * (1 - numpy.cos(numpy.pi / 2 * T))
    assert (numpy.diff(U) < 0).any()
    g = f["fatigue/surface_%d" % k]
    xi, z = g["material"][...] / b, g["depth"][...] / b
    # of the dent itself, or what it meets: U when it is at X = 0
    start = -2.5
    if k == 1:
        reference = start
    else:
        n = (2 * T - U > -start).argmax() - 1
        reference = -numpy.interp(0, (start + 2 * T - U)[n:n + 2], U[n:n + 2])
    end = 1 + sign * 1.3 * numpy.sin(numpy.pi / 2 * T[-1])
    for j, depth in enumerate(z):
        for i in range(len(xi) // 8, len(xi), len(xi) // 7):
            at = reference + xi[i] + U
            parts = [fields(P[0], numpy.arange(-2.5, at[0], D / 2), depth)]
            one = [fields(P[n], at[n:n + 1], depth) for n in range(len(T))
                   if abs(at[n]) <= 2.5]
            parts += one
            later = (numpy.arange(at[-1], 2.5, D / 2) if end > 0 else
                     numpy.arange(-2.5, at[-1], D / 2))
            parts.append(fields(P[-1], later, depth))
            h, d, tau = (numpy.concatenate([p[m] for p in parts] + [[0]])
                         for m in range(3))
            mises = numpy.sqrt(3 * (d**2 + tau**2) + (0.4 * h)**2).max()
            orthogonal = (tau.max() - tau.min()) / 2
            for name, value in (("orthogonal_amplitude", orthogonal),
                                ("max_von_mises", mises)):
                found = g[name][j, i] / ph
                assert abs(found - value) < 1e-3, (k, depth, xi[i], name,
                                                   found, value)
END
expect 0 "$OVERROLL" stress turn.h5
grep -q 'trailing\|leading' out && fail 'sides of a surface that turns'

# As it begins it has to move
refuses 'surface 2 does not move' check dent.ini --set sliding.history=ramp \
    --set sliding.from=2 --set sliding.to=0 --set sliding.start=1 \
    --set sliding.duration=1
