# SPDX-License-Identifier: GPL-3.0-or-later
"""Strips: maps as arrays, in memory and from files."""
import numpy as np
import pytest

import overroll as ovr


@pytest.fixture
def strip():
    case = ovr.Case(M=20, L=10, level=4, end=2, inlet=-4, strip_width=2)
    return case.feature("dent", shape="dent", depth=0.08, width=1, start=-1.5,
                        across=0.25)


def marched(case):
    sim = ovr.Simulation(case)
    for _ in sim.march():
        pass
    return sim


def test_maps_in_memory(strip):
    sim = marched(strip)
    P = sim.areal("pressure")
    assert P.shape == (sim.lines, sim.n) and sim.lines == len(sim.Y) == 28
    assert sim.Y[0] == -1 and np.ptp(np.diff(sim.Y)) < 1e-14
    # the force balance is that of the mean over all lines
    assert (P @ sim.weights).mean() == pytest.approx(sim.load, rel=1e-12)
    # the dent at 0.25 is in the middle of a line and the next one
    apart = np.remainder(sim.Y - 0.25 + 1, 2) - 1
    order = np.argsort(apart)
    assert apart[order] == pytest.approx(-apart[order][::-1], abs=0.08)
    H = sim.areal("film_thickness")
    assert sim.H_min == pytest.approx(H.min(), rel=1e-12)
    # what is shown is one of them, and the default is that of the dent
    assert abs(sim.Y[sim.line] - 0.25) < 0.04
    assert (sim.P == P[sim.line]).all() and (sim.H == H[sim.line]).all()
    assert sim.show(-0.99).line == 0 and (sim.H == H[0]).all()
    assert sim.show(1.01).line == 0
    assert abs(sim.show().Y[sim.line] - 0.25) < 0.04


def test_a_line_that_is_shown_changes_nothing(strip):
    one, other = (ovr.Simulation(strip).steady() for _ in range(2))
    for _ in range(5):
        one.step()
        other.step()
        other.show(0.7).areal("viscosity")
        assert (one.areal("pressure") == other.areal("pressure")).all()
        assert one.H_min == other.H_min


def test_arrays_with_units():
    sim = ovr.Simulation(load="300 kN/m", radius="8 mm", modulus="226 GPa",
                         viscosity="40 mPa.s", alpha="20 1/GPa",
                         mean_speed="3 m/s", level=4, strip_width=2)
    sim.steady()
    p = sim.pressure
    assert p.dims == ("y", "x") and p.units == "Pa" and p.y.units == "m"
    assert p.values == pytest.approx(sim.areal("pressure") * sim.contact.ph)
    assert p.y.values == pytest.approx(sim.Y * sim.contact.b)
    ds = sim.dataset("pressure", "mass_flow")
    assert ds["mass_flow"].shape == p.shape
    # nothing varies across
    assert np.ptp(p.values, axis=0).max() < 1e-9 * p.values.max()


def test_maps_of_a_file(strip):
    sim = marched(strip)
    strip["output.precision"] = "f64"
    strip["output.every"] = 8
    ds = ovr.run(strip, "strip.h5")
    assert ds["pressure"].dims == ("time", "y", "x")
    assert ds["y"].values == pytest.approx(sim.Y, abs=1e-15)
    last = ds.isel(time=-1)
    assert (last["pressure"].values == sim.areal("pressure")).all()
    assert (last["film_thickness"].values == sim.areal("film_thickness")).all()
    assert (last["roughness"].values == sim.areal("roughness")).all()
    assert ovr.open("strip.h5").equals(ds)


def test_a_line_contact_is_one_line():
    sim = ovr.Simulation(M=20, L=10, level=4).steady()
    assert sim.lines == 1 and sim.line == 0 and (sim.Y == [0]).all()
    assert (sim.show(0.3).areal("pressure") == sim.P).all()
    assert sim.areal("pressure").shape == (1, sim.n)
    assert sim.pressure.dims == ("x",)
