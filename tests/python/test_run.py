# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs and their files, compared with files written by the program."""
import json
import os
import signal
import subprocess
import threading
import time

import numpy as np
import pytest
import xarray

import overroll as ovr


def same_file(a, b):
    """Asserts that two files contain the same computed values, to the bit."""
    for group in (None, "history"):
        x, y = ovr.open(a, group=group), ovr.open(b, group=group)
        assert set(x.variables) == set(y.variables)
        for name in x.variables:
            assert x[name].values.tobytes() == y[name].values.tobytes(), name


def test_what_is_no_result(dent, tmp_path):
    (tmp_path / "table.csv").write_text("a,b\n1,2\n")
    with pytest.raises(ovr.OverrollError, match="table.csv") as caught:
        ovr.open(tmp_path / "table.csv")
    assert caught.value.file == str(tmp_path / "table.csv")
    with pytest.raises(FileNotFoundError):
        ovr.open("none.h5")
    ds = ovr.run(dent, output="short.h5", end=0.2)
    for group in ("film_thickness", "no_such"):
        with pytest.raises(ovr.BadInput, match=group):
            ds.overroll.group(group)
    with pytest.raises(ovr.BadInput, match="force=True replaces"):
        ovr.run(dent, output="short.h5", end=0.2)
    for key in ("output.title", "feature\0.depth"):
        with pytest.raises(ovr.BadInput, match="NUL"):
            dent[key] = "a\0b"
    with pytest.raises(ovr.BadInput, match="between"):
        ovr.find(dent, "contact.M", between=(10,), quantity="H_min",
                 equals=0.1)


def test_same_bits_as_the_program(dent, program):
    dent.save("dent.ini")
    subprocess.run([program, "run", "dent.ini", "-q", "-o", "c.h5"],
                   check=True)
    ds = ovr.run("dent.ini", "python.h5")
    assert ds.status == "complete"
    same_file("c.h5", "python.h5")
    sim = ovr.Simulation(dent)
    H_min = [state.H_min_located for state in sim.march()]
    assert (ds.overroll.history.min_film_thickness.values == H_min).all()


def test_same_numbers_as_the_program(program):
    summary = subprocess.run([program, "steady", "--M", "20", "--L", "10",
                              "--level", "6", "--json", "-q"], check=True,
                             stdout=subprocess.PIPE).stdout
    film, summary = ovr.steady(M=20, L=10, level=6), json.loads(summary)
    compared = 0
    for name, value in film.numbers().items():
        if name in summary and summary[name] is not None:
            assert value == summary[name], name
            compared += 1
    assert compared > 15


def test_fields_are_those_of_a_file():
    """Fields of a contact with dimensions equal those of the file, except for
    rounding of the scale factor."""
    case = ovr.Case(
        load="300 kN/m", radius="8 mm", modulus="226 GPa", level=4,
        viscosity="58.5 mPa.s", alpha="23.5 1/GPa", mean_speed="3 m/s",
        output_fields="pressure, film_thickness, viscosity, mass_flow")
    ds, now = ovr.run(case).isel(time=0), case.steady().dataset()
    for name in ("pressure", "film_thickness", "viscosity", "mass_flow", "x"):
        assert now[name].values == pytest.approx(ds[name].values, rel=1e-14)
        assert now[name].units == ds[name].units


def test_without_a_name_the_file_is_temporary(dent):
    ds = ovr.run(dent)
    path = ds.overroll.path
    assert os.path.exists(path) and not os.listdir(".")
    assert ds.film_thickness.shape == (ds.sizes["time"], ds.sizes["x"])
    assert ds.overroll.case["contact.M"] == 20
    with pytest.raises(ValueError, match="does not know the result file"):
        xarray.Dataset({"H": 1}).overroll.path


def test_files_are_not_overwritten(dent):
    ovr.run(dent, "a.h5")
    with pytest.raises(ovr.BadInput, match="a.h5"):
        ovr.run(dent, "a.h5")
    ovr.run(dent, "a.h5", force=True)
    with pytest.raises(ovr.BadInput):
        ovr.run(dent, "no/such/folder/a.h5")


def test_units(dent):
    physical = ovr.Case(
        load="300 kN/m", radius="8 mm", modulus="226 GPa", end=0.5, level=4,
        inlet=-4, outlet=1.5,
        viscosity="58.5 mPa.s", alpha="23.5 1/GPa", mean_speed="3 m/s")
    stored = ovr.run(physical)
    bare, si = (stored.overroll.convert(u) for u in ("hertzian", "si"))
    assert stored.pressure.units == "Pa" and bare.pressure.units == "1"
    assert bare.x.values[[0, -1]] == pytest.approx([-4, 1.5])
    assert float(bare.pressure.max()) == pytest.approx(1, abs=0.1)
    again = bare.overroll.convert("si")
    for name in si.variables:
        assert again[name].values == pytest.approx(stored[name].values)
        assert again[name].attrs["units"] == stored[name].attrs["units"]
    with pytest.raises(ValueError, match="scale"):
        ovr.run(dent).overroll.convert("si")
    with pytest.raises(ValueError, match="furlong"):
        stored.overroll.convert("furlong")


def test_a_growing_file_is_read(program, dent):
    dent.set(end=1e4, level=7).save("long.ini")
    run = subprocess.Popen([program, "run", "long.ini", "-q", "-o", "long.h5"])
    try:
        counts = set()
        for _ in range(600):
            if os.path.exists("long.h5"):
                ds = ovr.open("long.h5")
                steps = ds.overroll.history
                assert ds.status == "running"
                assert not np.isnan(ds.film_thickness.values).any()
                assert not np.isnan(steps.min_film_thickness.values).any()
                counts.add(steps.sizes["step"])
            if len(counts) > 2:
                break
            time.sleep(0.1)
        assert len(counts) > 2
    finally:
        run.send_signal(signal.SIGINT)
        assert run.wait() == 130
    assert ovr.open("long.h5").status == "stopped"


def test_ctrl_c_keeps_a_file_that_can_be_gone_on_with(dent):
    dent["end"] = 1
    whole = ovr.run(dent, "whole.h5")
    began = threading.Event()

    def press():
        began.wait()
        os.kill(os.getpid(), signal.SIGINT)

    def observe(state):
        if state.T > 0.3:
            began.set()
            time.sleep(0.01)  # the signal comes within the callback or after
    thread = threading.Thread(target=press)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        ovr.run(dent, "cut.h5", observe=observe)
    thread.join()
    cut = ovr.open("cut.h5")
    assert cut.status == "stopped"
    assert 0.3 < cut.overroll.history.time.values[-1] < 1
    ds = ovr.resume("cut.h5")
    assert ds.status == "complete" and ds.identical(ds) and whole.sizes
    same_file("cut.h5", "whole.h5")
    longer = ovr.resume("cut.h5", end=1.2)
    assert longer.overroll.history.time.values[-1] >= 1.2
    with pytest.raises(ovr.BadInput) as caught:
        ovr.resume("cut.h5", M=30)
    assert "M" in str(caught.value)
    with pytest.raises(ovr.BadInput) as caught:
        ovr.resume("cut.h5", edn=30)
    assert caught.value.suggestion == "end"


def test_observers_see_each_step_and_may_end_it(dent):
    seen = []
    ds = ovr.run(dent, "a.h5",
                 observe=lambda s: seen.append(s.T) or (s.X + s.T > 2).any())
    assert ds.status == "stopped"
    assert (ds.overroll.history.time.values == seen).all()
    with pytest.raises(ZeroDivisionError):
        ovr.run(dent, "b.h5", observe=lambda s: 1 / 0)
    assert ovr.open("b.h5").status == "stopped"


def test_a_steady_start_is_stopped_too(dent):
    asked = []

    def enough():
        asked.append(True)
        return len(asked) > 2
    ds = ovr.run(dent, "start.h5", stop=enough)
    assert ds.status == "stopped" and ds.overroll.history.sizes["step"] == 0
    assert len(asked) == 3
    ovr.run(dent, "whole.h5")
    ovr.resume("start.h5")
    same_file("start.h5", "whole.h5")


def test_own_surface_in_a_file(dent):
    ds = ovr.run(dent, surface=lambda T, X: 0.01 * np.cos(X - T))
    S = ds.roughness.isel(time=0).values
    assert S == pytest.approx(0.01 * np.cos(ds.x.values), abs=1e-3)
    with pytest.raises(ovr.BadInput, match="finite"):
        ovr.run(dent, surface=lambda T, X: X * np.nan)


def test_progress_is_reported(dent, capsys):
    reported = []
    ovr.run(dent, progress=reported.append)
    assert reported and all(0 <= f <= 1 for f in reported)
    ovr.run(dent, progress=True)
    assert "%" in capsys.readouterr().err
    ovr.run(dent)  # no terminal
    assert capsys.readouterr().err == ""


def test_warnings_are_warnings(dent):
    dent["feature_dent_start"] = -3
    with pytest.warns(ovr.OverrollWarning, match="starts inside") as caught:
        ovr.run(dent)
    assert caught[0].filename == __file__


def test_the_same_as_by_xarray(dent):
    """The dataset equals what h5netcdf reads, and is loaded lazily."""
    path = ovr.run(dent, "a.h5", level=4, end=0.2).overroll.path
    for group in (None, "history"):
        other = xarray.open_dataset(path, group=group, engine="h5netcdf",
                                    decode_times=False)
        with other:
            assert ovr.open(path, group=group).identical(other.load())
    with ovr.open(path, load=False) as lazy:
        assert lazy.pressure.sizes == ovr.open(path).pressure.sizes


def test_xarray_opens_by_itself(dent):
    path = ovr.run(dent, "a.h5").overroll.path
    ds = xarray.open_dataset(path, engine="overroll", units="stored")
    assert ds.identical(ovr.open(path))


def test_no_result_file():
    with pytest.raises(OSError):
        ovr.open("none.h5")
    with open("text.h5", "w") as file:
        file.write("no result\n")
    with pytest.raises(OSError):
        ovr.open("text.h5")
    with pytest.raises(ovr.BadInput):
        ovr.resume("none.h5")


def test_passes():
    """Each pass is a separate simulation; all passes are one run."""
    seen = []
    case = ovr.Case(M=20, L=10, level=4, cavitation_model="conserving",
                    passes_number=3, loss=0.2)
    ds = ovr.run(case, "out.h5", surface=lambda T, X: 0 * X,
                 observe=lambda s: seen.append((s.pass_number, s.H_cen)))
    assert [number for number, _ in seen] == [1, 2, 3]
    np.testing.assert_allclose(ds.supply_ratio[1:], [0.8, 0.64], rtol=1e-4)
    np.testing.assert_allclose([H for _, H in seen],
                               ds.central_film_thickness)
    assert list(ds.file.values) == ["out-1.h5", "out-2.h5", "out-3.h5"]
    third = ovr.open(ds.file.values[2], group="history")
    assert third.meniscus[0] == ds.meniscus[2]


def test_layers_of_a_body(program):
    """Keys of [coating 1] and [coating 1b], and the report of a run with
    layers."""
    case = ovr.Case(**{"load": "300 kN/m", "radius": "8 mm",
                       "mean_speed": "3 m/s", "viscosity": "40 mPa.s",
                       "alpha": "17 1/GPa", "level": 6,
                       "body 1.modulus": "206 GPa",
                       "body 2.modulus": "206 GPa", "stress.surface": 1,
                       "coating 1.thickness": "50 um",
                       "coating 1.modulus": "400 GPa",
                       "coating 1.yield": "3 GPa",
                       "coating 1b.thickness": "50 um",
                       "coating 1b.modulus": "120 GPa"})
    stiff = ovr.steady(case)
    bare = ovr.steady(case, **{"coating 1.modulus": "206 GPa",
                               "coating 1b.modulus": "206 GPa"})
    plain = ovr.steady(load="300 kN/m", radius="8 mm", mean_speed="3 m/s",
                       viscosity="40 mPa.s", alpha="17 1/GPa", level=6,
                       **{"body 1.modulus": "206 GPa",
                          "body 2.modulus": "206 GPa"})
    assert abs(bare.H_cen / plain.H_cen - 1) < 1e-6
    assert abs(stiff.H_cen / plain.H_cen - 1) > 1e-4
    case.feature("dent", depth=0.1, width=0.5, start=-2).set(end=2)
    case.save("layers.ini")
    subprocess.run([program, "run", "layers.ini", "-q", "-o", "c.h5"],
                   check=True)
    ds = ovr.run(case, "python.h5")
    same_file("c.h5", "python.h5")
    s = ovr.open("python.h5", group="summary").attrs
    upper = s["layer_utilisation"] * 3e9 / s["layer_von_mises_max_Pa"]
    assert 0 < upper <= 1 + 1e-9
    table = ovr.sweep(case, **{"coating 1.thickness": ["20 um", "50 um"],
                               "workers": 2})
    assert float(table.layer_von_mises_max_Pa[1]) == \
        s["layer_von_mises_max_Pa"]
    assert table.layer_von_mises_max_Pa[0] != table.layer_von_mises_max_Pa[1]


def test_a_body_that_yields(program):
    """A plastic body: the result equals the program's file, in a study over
    the yield stress and in a continued run, where less plastic strain is added
    than in the first."""
    case = ovr.Case(load="300 kN/m", radius="8 mm", mean_speed="3 m/s",
                    viscosity="40 mPa.s", alpha="17 1/GPa", level=5, order=2,
                    end=3.6, inlet=-4,
                    **{"body 1.modulus": "206 GPa",
                       "body 2.modulus": "206 GPa", "stress.surface": 1,
                       "plastic.hardening": "linear", "plastic.yield": 0.7,
                       "plastic.modulus": "4.5 GPa", "plastic.layers": 8,
                       "plastic.depth_max": 0.2})
    case.feature("dent", shape="indent", depth="1.5 um", shoulder="0.25 um",
                 width=0.6, start=-1.8)
    case.save("soft.ini")
    subprocess.run([program, "run", "soft.ini", "-q", "-o", "c.h5"], check=True)
    first = ovr.run(case, "python.h5")
    same_file("c.h5", "python.h5")
    group = ovr.open("python.h5", group="plastic/surface_1")
    assert group.attrs["plastic_strain_max"] == \
        pytest.approx(first.attrs["plastic_strain_max"], rel=1e-6)
    assert 0 < first.attrs["plastic_strain_max"]
    again = ovr.run(case, "again.h5", **{"plastic.initial": "python.h5"})
    assert first.attrs["plastic_strain_max"] < \
        again.attrs["plastic_strain_max"] < \
        2 * first.attrs["plastic_strain_max"]
    table = ovr.sweep(case, **{"plastic.yield": [0.7, 50], "workers": 2})
    assert float(table.plastic_strain_max[0]) == \
        first.attrs["plastic_strain_max"]
    assert float(table.plastic_strain_max[1]) == 0


def test_unpack(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "load.txt").write_text("0 1\n1 1.1\n2 1\n")
    (tmp_path / "load.ini").write_text(
        "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 4\n"
        "[time]\nend = 0.3\n[load]\nhistory = table\n"
        "file = load.txt\n")
    ovr.run("load.ini", output="first.h5")
    paths = ovr.unpack("first.h5", "inputs")
    assert paths == ["inputs/load.txt", "inputs/first.ini"]
    with pytest.raises(ovr.BadInput, match="exists already"):
        ovr.unpack("first.h5", "inputs")
    (tmp_path / "load.txt").unlink()
    ovr.unpack("first.h5", "inputs", force=True)
    ovr.run("inputs/first.ini", output="second.h5")
    same_file("first.h5", "second.h5")
