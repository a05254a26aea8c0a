# SPDX-License-Identifier: GPL-3.0-or-later
"""Solutions as arrays of numpy and xarray, and misuse of their memory."""
import gc

import numpy as np
import pytest

import overroll as ovr
from conftest import REFERENCE

PHYSICAL = {"load": "300 kN/m", "radius": "8 mm", "modulus": "226 GPa",
            "viscosity": "58.5 mPa.s", "alpha": "23.5 1/GPa",
            "mean_speed": "3 m/s", "level": 5}


def test_views_share_memory_and_cannot_be_written():
    sim = ovr.Simulation(M=20, L=10, level=5).steady()
    for name in ("X", "P", "H", "S", "q", "eps", "weights"):
        a, b = getattr(sim, name), getattr(sim, name)
        assert a.shape == (sim.n,) and a.dtype == np.float64
        assert np.shares_memory(a, b)
        with pytest.raises(ValueError):
            a[0] = 1
        with pytest.raises(ValueError):
            a.setflags(write=True)
    assert (sim.weights * sim.P).sum() == pytest.approx(sim.load, rel=1e-12)
    P = sim.P
    before = P.copy()
    sim.surface(lambda T, X: 0.05 * np.cos(X - T))
    sim.step()
    assert np.shares_memory(P, sim.P) and (P != before).any()


def test_views_outlive_their_simulation():
    kept, copies = [], []
    for k in range(50):
        film = ovr.steady(M=10 + k / 10, L=5, level=4)
        kept.append(film.P[3:])
        copies.append(film.P[3:].copy())
        sim = ovr.Simulation(M=10 + k / 10, L=5, level=4)
        kept.append(sim.X)
        copies.append(sim.X.copy())
        del film, sim
    gc.collect()
    for a, b in zip(kept, copies):
        assert (a == b).all()


def test_numbers_have_the_names_of_the_program():
    film = ovr.steady(**PHYSICAL)
    numbers = film.numbers()
    assert numbers["H_min"] == film.H_min == film.H.min()
    assert film.X_min == film.X[film.H.argmin()]
    assert film.P_max == film.P.max()
    assert film.min_film_m == film.H_min * film.contact.height
    assert isinstance(film.cycles, int) and film.marked is False
    assert set(numbers) <= set(dir(film))
    with pytest.raises(AttributeError, match="did you mean 'H_min'"):
        film.H_mn


def test_arrays_with_units():
    film = ovr.steady(**PHYSICAL)
    p, h = film.pressure, film.thickness
    assert p.units == "Pa" and h.units == "m" and p.x.units == "m"
    assert p.values == pytest.approx(film.P * film.contact.ph)
    assert h.values == pytest.approx(film.H * film.contact.height)
    assert p.x.values == pytest.approx(film.X * film.contact.b)
    bare = ovr.steady(M=20, L=10, level=5)
    assert bare.thickness.units == "1"
    assert (bare.thickness.values == bare.H).all()
    bare.thickness.values[:] = 0  # a copy
    assert bare.H.min() > 0
    ds = film.dataset()
    assert {"pressure", "film_thickness", "viscosity"} <= set(ds)
    assert ds.attrs["H_min"] == film.H_min


def test_errors_are_estimated():
    """The estimated error is close to the true error, known from the limit of
    table 2."""
    film = ovr.steady(**REFERENCE, level=7, estimate_error=True)
    assert film.errors["H_cen"] == pytest.approx(
        abs(film.H_cen - 0.08419667638), rel=0.3)
    assert ovr.steady(M=20, L=10, level=5).errors is None


def test_fields():
    film = ovr.steady(M=20, L=10, level=5)
    assert (film.field("film_thickness") == film.H).all()
    assert len(film.field("mass_flow")) == film.n - 1
    assert (film.field("viscosity") >= 1).all()
    with pytest.raises(ovr.BadInput) as caught:
        film.field("presure")
    assert caught.value.suggestion == "pressure"


def test_surface_functions_are_checked():
    for function, wrong in [
            (lambda T, X: X[:-1], "shape"), (lambda T, X: "x", "could not"),
            (lambda T, X: np.full_like(X, np.nan), "not finite"),
            (lambda T, X: [[1.0]], "shape"), (lambda T: 0, "argument")]:
        sim = ovr.Simulation(M=20, L=10, level=4)
        sim.surface(function)
        with pytest.raises((ValueError, TypeError), match=wrong):
            sim.steady()
        with pytest.raises(ValueError, match="finite|shape|could"):
            sim.surface(lambda T, X: X[:-1])
            sim.steady()


def test_exceptions_travel_through_and_the_simulation_begins_again():
    class Mine(Exception):
        pass

    def fails(T, X):
        if T > 0.1:
            raise Mine
        return 0 * X
    sim = ovr.Simulation(M=20, L=10, level=4)
    sim.surface(fails)
    with pytest.raises(Mine):
        for _ in sim.march(end=1):
            pass
    with pytest.raises(RuntimeError, match="steady"):
        sim.step()
    sim.surface(None)
    sim.steady()
    assert [s.T for s in sim.march(end=0.2)][-1] >= 0.2


def test_a_loop_may_break_raise_and_go_on():
    sim = ovr.Simulation(M=20, L=10, level=4)
    for state in sim.march(end=1):
        if state.T > 0.3:
            break
    assert 0.3 < sim.T < 0.5
    with pytest.raises(KeyError):
        for state in sim.march(end=1):
            raise KeyError
    times = [state.T for state in sim.march(end=1)]
    assert times[0] > 0.3 and times[-1] == sim.T >= 1
    assert list(sim.march(end=1)) == []
    with pytest.raises(ovr.BadInput, match="end"):
        sim.march()


def test_march_takes_the_steps_asked_for():
    sim = ovr.Simulation(M=20, L=10, level=4)
    assert [round(s.T / 0.25, 9) for s in sim.march(1, step=0.25)] == \
        [0, 1, 2, 3, 4]
    sim.steady()
    assert 1 < len(list(sim.march(1, adaptive=True, error=1e-3))) < 40
    sim.step(0.1)
    assert sim.T == pytest.approx(1.1)


def test_within_its_own_function_a_simulation_is_at_work():
    sim = ovr.Simulation(M=20, L=10, level=4)
    sim.surface(lambda T, X: sim.step())
    with pytest.raises(RuntimeError, match="at work"):
        sim.steady()


def test_own_surface_is_on_top_of_the_features():
    keys = {"M": 20, "L": 10, "level": 5, "end": 1}
    both = ovr.Case(**keys).feature("wave", amplitude=0.02, wavelength=1)
    a = ovr.Simulation(both)
    a.surface(lambda T, X: 0.01 * np.cos(X - T), speed=1)
    a.steady()
    X = a.X
    assert a.S == pytest.approx(
        0.02 * np.cos(2 * np.pi * X) + 0.01 * np.cos(X), abs=1e-12)
    a.surface(None)
    a.steady()
    assert a.S == pytest.approx(0.02 * np.cos(2 * np.pi * X), abs=1e-12)


def test_impossible_and_wrong_are_of_their_kind():
    with pytest.raises(ovr.BadInput):
        ovr.Simulation(M=20)
    with pytest.raises(ovr.BadInput):
        ovr.Simulation(M=20, L=10, level=4).step(-1)
    with pytest.raises(ovr.NotConverged):
        ovr.steady(M=20, L=10, level=6, max_cycles=1, tolerance=1e-15)
