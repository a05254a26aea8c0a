# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference values from other programs; tolerances as in the corresponding C
tests."""
import numpy as np
import pytest

import overroll as ovr
from conftest import REFERENCE, truth


@pytest.mark.parametrize("row", truth("truth_wedge_2")[:5])
def test_table_2(row):
    level, H_m, H_cen, H0, P_s, X_s, X_m = row
    film = ovr.steady(**REFERENCE, level=int(level))
    assert film.converged
    assert film.H_min == pytest.approx(H_m, rel=2e-5)
    assert film.H_cen == pytest.approx(H_cen, rel=2e-5)
    assert film.H0 == pytest.approx(H0, rel=2e-5)
    assert film.P_spike == pytest.approx(P_s, rel=1e-3)
    assert film.X_spike == pytest.approx(X_s, abs=0.01 * film.D)
    assert film.X_min == pytest.approx(X_m, abs=0.01 * film.D)


def shape(T, X):
    xi = (X + 4.6 - T) / 0.5
    return -0.1 * 10**(-10 * xi**2) * np.cos(2 * np.pi * xi)


@pytest.mark.parametrize("own", [False, True])
def test_discrete_series(own):
    """The dent is a feature of the case, or a function."""
    H_min, H_cen = truth("dent_bdf2_H_min"), truth("dent_bdf2_H_cen")
    case = ovr.Case(**REFERENCE, level=7, end=6.4, tolerance=1e-8)
    if not own:
        case.feature("dent", depth=0.1, width=0.5, start=-4.6)
    sim = ovr.Simulation(case)
    if own:
        sim.surface(shape, speed=1)
    k = 0
    for state in sim.march():
        if state.step_count % 16 == 0 and k < len(H_min):
            assert state.H_min_located == pytest.approx(H_min[k], rel=2e-6)
            assert state.H_cen == pytest.approx(H_cen[k], rel=2e-6)
            k += 1
    assert k == len(H_min)
