import sys, json, h5py, numpy
f = h5py.File(sys.argv[1]); run = json.load(open(sys.argv[2]))
ph = f.attrs["scale_pressure"]
x, xs = f["x"][...], f["stress/surface_1/x"][...]
assert run["mu_1"] < 0 < run["mu_2"]
for k, sign in ((1, 1), (2, -1)):
    q = sign * f["shear_stress_%d" % k][...]
    load = numpy.trapz(f["pressure"][-1], x)
    mu = numpy.trapz(q[-1], x) / load
    # sums over half nodes there, over nodes here
    assert abs(mu - run["mu_%d" % k]) < 3e-3 * abs(mu), (mu, run["mu_%d" % k])
    g = f["stress/surface_%d" % k]
    assert g.attrs["traction"] == 1
    tau, z = g["tau_xz"][-1], g["depth"][...] / f.attrs["scale_length"]
    assert z[0] < 0.06, z[0]
    force = [-numpy.trapz(t, xs) / load for t in tau]
    # over any depth the whole force goes through; what is cut off at
    # |x| = 2.6 grows with the depth
    assert abs(force[0] / mu - 1) < 0.01, (force[0], mu)
