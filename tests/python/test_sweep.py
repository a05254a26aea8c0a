# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps and pictures."""
import os
import shutil
import signal

import pytest

import overroll as ovr


def test_sweep_is_the_runs_one_by_one(dent):
    table = ovr.sweep(dent, feature_dent_depth=[0.05, 0.1],
                      slide_to_roll=[0, 0.5, 1], workers=2, output="here")
    assert dict(table.sizes) == {"feature_dent_depth": 2, "slide_to_roll": 3}
    assert table.converged.all() and len(os.listdir("here")) >= 6
    one = ovr.run(dent, feature_dent_depth=0.1, slide_to_roll=0.5)
    at = table.sel(feature_dent_depth=0.1, slide_to_roll=0.5)
    assert float(at.H_min_overall) == one.attrs["H_min_overall"]
    assert table.H_min_overall.attrs["long_name"]


def test_steady_sweep_with_units_and_words():
    table = ovr.sweep(load="300 kN/m", radius="8 mm", modulus="226 GPa",
                      viscosity="58.5 mPa.s", alpha="23.5 1/GPa", level=4,
                      mean_speed=["1 m/s", "2000 mm/s"],
                      density_law=["incompressible", "dowson-higginson"])
    assert table.mean_speed.values == pytest.approx([1, 2])
    assert table.mean_speed.units == "m/s"
    assert list(table.density_law.values) == ["incompressible",
                                              "dowson-higginson"]
    assert (table.min_film_m > 0).all() and "steps" not in table
    film = ovr.steady(M=20, L=10, level=4)
    other = ovr.sweep(M=[20], L=[10], level=4)
    assert float(other.H_min[0, 0]) == film.H_min


def test_a_case_that_fails_is_a_gap():
    table = ovr.sweep(M=[20, 30], L=10, level=6, tolerance=[1e-15, 1e-6],
                      max_cycles=1)
    assert not table.converged.sel(tolerance=1e-15).any()
    assert "" not in table.message.sel(tolerance=1e-15).values


def test_ctrl_c_ends_a_sweep(dent):
    """Running cases finish their step; waiting cases do not start."""
    dent.set(end=1000, level=7)

    def press(fraction):
        if os.path.exists("here/M=10.h5"):
            os.kill(os.getpid(), signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        ovr.sweep(dent, M=[10, 20, 30, 40], workers=2, output="here",
                  progress=press)
    assert ovr.open("here/M=10.h5").status == "stopped"
    assert not os.path.exists("here/M=40.h5")


def test_wrong_keys_are_said_before_anything_runs(dent):
    with pytest.raises(ovr.BadInput) as caught:
        ovr.sweep(dent, feature_dent_detph=[1, 2])
    assert caught.value.suggestion == "feature_dent_depth"
    with pytest.raises(ovr.BadInput):
        ovr.sweep(dent, level=[5, 99])


@pytest.fixture
def gnuplot():
    if not shutil.which("gnuplot"):
        pytest.skip("no gnuplot")


def test_pictures(dent, gnuplot):
    ds = ovr.run(dent)
    picture = ds.overroll.plot(width=400, times=[0.5, 1])
    assert picture._repr_png_().startswith(b"\x89PNG")
    drawn = ds.overroll.plot("map", "map.svg", field="pressure")
    assert "<svg" in drawn._repr_svg_() and drawn.path == "map.svg"
    with pytest.raises(ovr.BadInput, match="map.svg"):
        ds.overroll.plot("map", "map.svg")
    for wrong, suggestion in [({"kind": "histroy"}, "history"),
                              ({"widht": 3}, "width"), ({"units": "SI"}, None)]:
        with pytest.raises(ovr.BadInput) as caught:
            ds.overroll.plot(**wrong)
        assert caught.value.suggestion == suggestion
    page = ds.overroll.view("run.html")
    assert "<iframe" in page._repr_html_()


def test_frames(dent, gnuplot):
    ds = ovr.run(dent)
    reported = []
    frames = ds.overroll.frames(folder="frames", every=80, width=320,
                                height=240, progress=reported.append)
    assert frames.drawn == len([n for n in os.listdir("frames")
                                if n.endswith(".png")]) > 1 and reported
    with pytest.raises(ZeroDivisionError):
        ds.overroll.frames(folder="other", width=320, height=240,
                           progress=lambda f: 1 / 0)
