#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Shear stress of the film as a load on the surfaces: signs, exchanged
# surfaces, from the file and after a stop; cases without traction and the
# reason.
. "$TOP/tests/support/cli.sh"
need_python h5py numpy

cat >slide.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 2 m/s
slide_to_roll = 0.3
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[domain]
level = 6
inlet = -4
[time]
end = 2.4
[feature dent]
shape = dent
surface = 1
depth = 0.3 um
width = 0.5
start = -2
[output]
every = 1
[stress]
surface = both
every = 20
depth_min = 0.06
[fatigue]
limit_pressure = none
END
expect 0 "$OVERROLL" run slide.ini -o slide.h5 --json
cp out run.json
contains run.json '"traction": true'

# The pull on each surface is the friction that is told of, and tau_xz just
# below carries it: with body 1 the faster, body 1 is held back.
expect 0 "$PYTHON" - slide.h5 run.json <<'END'
import sys, json, h5py, numpy
f = h5py.File(sys.argv[1]); run = json.load(open(sys.argv[2]))
x, xs = f["x"][...], f["stress/surface_1/x"][...]
load = numpy.trapz(f["pressure"][-1], x)
assert run["mu_1"] < 0 < run["mu_2"]
carried, sheared = [], []
for k, sign in ((1, 1), (2, -1)):
    mu = numpy.trapz(sign * f["shear_stress_%d" % k][-1], x) / load
    # half nodes there, nodes here; mu_k has the pressure on slopes, too, and
    # the rolling friction before the domain, at most 0.15 of mu_roll
    told = run["mu_%d" % k]
    slope = told / run["F_%d" % k] * run["F_slope_%d" % k]
    off = mu - (told - slope)
    assert abs(off) < 3e-3 * abs(mu) + 0.15 * abs(run["mu_roll"]), (mu, told)
    sheared.append(mu)
    g = f["stress/surface_%d" % k]
    assert g.attrs["traction"] == 1
    n = abs(f["time"][...] - g["time"][-1]).argmin()
    assert abs(g["time"][-1] - f["time"][n]) < 1e-9 * f["time"][n]
    pull = numpy.trapz(sign * f["shear_stress_%d" % k][n], x)
    carried.append(-numpy.trapz(g["tau_xz"][-1][0], xs) / pull)
# Of a pull 4 z/(pi x) is carried beyond |x|; of the pressure, whose middle is
# not at 0, as much is on either surface, which pull the opposite way.
lost = 1 - sum(carried) / 2
far = 4 * g["depth"][0] / (numpy.pi * xs[-1])
assert abs(lost / far - 1) < 0.1, (lost, far)
assert abs(carried[0] - carried[1]) < 0.02, carried
slide = (sheared[0] - sheared[1]) / 2
assert abs(slide + abs(run["mu_slide"])) < 3e-3 * abs(slide), slide
END

# The other way round: bodies change places, the numbers stay
expect 0 "$OVERROLL" run slide.ini -o turned.h5 -q \
    --set contact.slide_to_roll=-0.3 --set feature.dent.surface=2
expect 0 "$PYTHON" - slide.h5 turned.h5 <<'END'
import sys, h5py, numpy
a, b = (h5py.File(n) for n in sys.argv[1:3])
for k in (1, 2):
    for group, name in (("fatigue", "circle_radius"), ("fatigue", "amplitude"),
                        ("fatigue", "max_hydrostatic"), ("stress", "tau_xz")):
        u = a["%s/surface_%d/%s" % (group, k, name)][...]
        v = b["%s/surface_%d/%s" % (group, 3 - k, name)][...]
        worst = abs(u - v).max() / (abs(u).max() or 1)
        assert worst < 1e-5, (k, name, worst)
END

# From the file the same numbers; without the shear stress in it none
expect 0 "$OVERROLL" stress slide.h5 --json
expect 0 "$PYTHON" - run.json out <<'END'
import json, sys
a, b = (json.load(open(n)) for n in sys.argv[1:3])
for k in ("tau_max", "X_tau_max", "von_mises_max", "R_max", "xi_R_max",
          "equivalent_length"):
    if a[k] is None:  # no point passes the whole contact
        assert b[k] is None, k
        continue
    assert abs(a[k] - b[k]) <= 1e-6 * max(1, abs(a[k])), (k, a[k], b[k])
END
expect 0 "$OVERROLL" stress slide.h5 --set stress.traction=no
contains out '^traction  *none: .stress. traction = no'
expect 0 "$OVERROLL" run slide.ini -o bare.h5 -q --set stress.depth_min=auto \
    --set 'output.fields=pressure, film_thickness' --set time.end=0.2
expect 0 "$OVERROLL" stress bare.h5
contains out '^traction  *none: the file contains no shear_stress_1'
refuses 'traction = yes: .*contains no shear_stress_1' stress bare.h5 \
    --set stress.traction=yes
refuses 'add shear_stress_1 to output.fields' run slide.ini -o no.h5 \
    --set 'output.fields=pressure, film_thickness' --set time.end=0.2 \
    --set fatigue.criterion=dang-van

# The same bits after a stop
expect 0 "$OVERROLL" run slide.ini -o short.h5 -q --set time.end=1.3
expect 0 "$OVERROLL" resume short.h5 -q --set time.end=2.4
expect 0 "$PYTHON" - slide.h5 short.h5 <<'END'
import sys, h5py, numpy
a, b = (h5py.File(n) for n in sys.argv[1:3])
for group in ("fatigue", "stress"):
    for k in (1, 2):
        g, h = (f["%s/surface_%d" % (group, k)] for f in (a, b))
        for n in g:
            assert numpy.array_equal(g[n][...], h[n][...], equal_nan=True), n
END

# Dang Van's line by the second pass: without its alpha the circle
expect 0 "$OVERROLL" run slide.ini -o line.h5 -q --set stress.surface=2 \
    --set fatigue.criterion=dang-van --set fatigue.alpha=0 \
    --set stress.depths_per_octave=2
expect 0 "$PYTHON" - line.h5 <<'END'
import sys, h5py
g = h5py.File(sys.argv[1])["fatigue/surface_2"]
A, R = g["amplitude"][...], g["circle_radius"][...]
assert (abs(A - R) < 0.03 * R.max()).all(), abs(A - R).max() / R.max()
END

refuses 'needs the stored pressure of all nodes' run slide.ini \
    --set fatigue.criterion=dang-van

# Asked for, or left out
expect 0 "$OVERROLL" check slide.ini
contains out "^#   traction  *shear stress of the film"
sed '/^eyring/d; s/^rheology.*/rheology = newtonian/' slide.ini >newton.ini
expect 0 "$OVERROLL" check newton.ini
contains out '^#   traction  *none: Newtonian film'
expect 0 "$OVERROLL" check newton.ini --set stress.traction=yes
contains out "^#   traction  *shear stress of the film"
cat >numbers.ini <<'END'
[contact]
M = 20
L = 10
[lubricant]
rheology = eyring
eyring_number = 0.4
[time]
end = 1
[stress]
END
expect 0 "$OVERROLL" check numbers.ini
contains out '^#   traction  *none: b/R is unknown'
refuses 'traction.*b/R is unknown' check numbers.ini \
    --set stress.traction=yes

# The pictures have it too
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot slide.h5 --kind stress --surface 2 -o tau.svg
    contains tau.svg 'with traction'
fi
