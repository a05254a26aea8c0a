# SPDX-License-Identifier: GPL-3.0-or-later
"""find, random and executors: threads, processes and dask give equal
results."""
import json
import multiprocessing
import os
import signal
import subprocess
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

import overroll as ovr

CONTACT = dict(load="300 kN/m", radius="8 mm", modulus="226 GPa",
               viscosity="40 mPa.s", alpha="20 1/GPa", mean_speed="1 m/s",
               level=4)


@pytest.fixture
def passed(dent):
    """Returns the dent case with an end time after the dent has left."""
    return dent.set(end=6.4)


def same(one, other):
    """True if all numbers except times and file names are equal to the bit."""
    assert set(one) == set(other)
    for name in one:
        if name not in ("seconds", "message", "snapshots"):
            np.testing.assert_array_equal(one[name], other[name], name)


# ------------------------------------------------------------------- find


def test_find_scales_by_formulas():
    found = ovr.find(None, "load", between=("50 kN/m", "800 kN/m"),
                     quantity="hertz_pressure_Pa", equals="1.5 GPa", **CONTACT)
    assert found.value == pytest.approx(500.4306881824449, rel=1e-9)
    assert found.unit == "kN/m" and float(found) == found.value
    assert len(found.evaluations) > 5 and found.monotone


def test_find_of_runs_is_that_of_the_program(passed, program):
    dent = passed
    how = dict(between=(0.01, 0.5), quantity="H_min_overall", at_least=0.05,
               which="largest")
    found = ovr.find(dent, "feature_dent_depth", workers=2, **how)
    dent.save("dent.ini")
    asked = "feature.dent.depth between 0.01 and 0.5 so that H_min_overall " \
            "at least 0.05 --json"
    told = json.loads(subprocess.run(
        [program, "find", "dent.ini", "largest", *asked.split()],
        check=True, stdout=subprocess.PIPE).stdout)
    assert found.value == told["value"] and found.slope == told["slope"]
    assert found.at_value >= 0.05
    one = ovr.run(dent, feature_dent_depth=found.value)
    assert one.attrs["H_min_overall"] == found.at_value
    assert found.numbers["H_min_overall"] == found.at_value


def test_find_says_what_is_wrong(passed):
    dent = passed
    how = dict(between=(0.01, 0.02), quantity="H_min_overall")
    with pytest.raises(ovr.BadInput, match="0.0695.* at 0.02; it does not "
                                           "reach 0.05"):
        ovr.find(dent, "feature.dent.depth", equals=0.05, **how)
    with pytest.raises(ovr.BadInput, match="one of equals"):
        ovr.find(dent, "feature.dent.depth", equals=1, at_most=2, **how)
    with pytest.raises(ovr.BadInput, match="workers: must be a number or an "
                                           "executor"):
        ovr.find(dent, "feature.dent.depth", equals=1, workers="two", **how)


# ----------------------------------------------------------------- random


def test_random_is_the_study_of_the_program(program):
    laws = dict(load="lognormal 300 kN/m sd 20 %",
                modulus="normal 226 GPa sd 2 %")
    table = ovr.random(draws=32, shifts=4, seed=5, workers=2,
                       **{**CONTACT, **laws})
    case = ovr.Case(**CONTACT)
    case.save("base.ini")
    with open("study.ini", "w") as file:
        file.write("[study]\ncase = base.ini\nresults = no\n[random]\n"
                   "draws = 32\nshifts = 4\nseed = 5\n")
        file.writelines(f"contact.{k} = {v}\n" for k, v in laws.items())
    subprocess.run([program, "sweep", "study.ini", "-q"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([program, "sweep", "study.ini", "-q", "--collect", "t.csv"],
                   check=True)
    told = np.genfromtxt("t.csv", delimiter=",", names=True)
    load = next(name for name in told.dtype.names if name.startswith("load"))
    np.testing.assert_array_equal(table.load_N_per_m, told[load])
    for name in ("H_min", "hertz_pressure_Pa", "half_width_m", "P_max"):
        np.testing.assert_array_equal(table[name], told[name], name)
    assert dict(table.sizes) == {"draw": 32} and table.converged.all()


def test_random_needs_something_random(dent):
    with pytest.raises(ovr.BadInput, match="no key is random"):
        ovr.random(dent, M=20)
    with pytest.raises(ovr.BadInput, match="multiple of shifts"):
        ovr.random(dent, M="normal 20 sd 1", draws=20, shifts=8)
    drawn = ovr.random(dent, M="normal 20 sd 1", level=4, draws=20)
    assert drawn.sizes["draw"] == 20


# -------------------------------------------------------------- executors


@pytest.fixture(scope="module")
def client():
    distributed = pytest.importorskip("distributed")
    import dask
    dask.config.set({"distributed.scheduler.allowed-failures": 9})
    cluster = distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None,
        silence_logs=50)
    client = distributed.Client(cluster)
    yield client
    client.close()
    cluster.close()


def test_processes(passed):
    dent = passed
    how = dict(feature_dent_depth=[0.05, 0.1], slide_to_roll=[0, 0.5])
    here = ovr.sweep(dent, workers=2, **how)
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(2, mp_context=spawn) as pool:
        same(here, ovr.sweep(dent, workers=pool, **how))
        found = ovr.find(dent, "feature_dent_depth", between=(0.01, 0.5),
                         quantity="H_min_overall", equals=0.05, workers=pool)
        drawn = ovr.random(dent, draws=8, M="normal 20 sd 1", workers=pool)
        with pytest.raises(ovr.BadInput):
            ovr.sweep(dent, M=[1, "much"], workers=pool)
        assert pool.submit(int, 3).result() == 3  # it is still at work
    with ThreadPoolExecutor(2) as pool:
        same(here, ovr.sweep(dent, workers=pool, **how))
    same(drawn, ovr.random(dent, draws=8, M="normal 20 sd 1", workers=1))
    assert found.value == ovr.find(
        dent, "feature_dent_depth", between=(0.01, 0.5),
        quantity="H_min_overall", equals=0.05, workers=2).value


def test_dask(dent, client):
    how = dict(feature_dent_depth=[0.05, 0.1], slide_to_roll=[0, 0.5])
    same(ovr.sweep(dent, workers=2, **how),
         ovr.sweep(dent, workers=client.get_executor(), **how))


def test_a_lost_worker_loses_nothing(dent, client):
    """One of two workers is killed during a case: another worker resumes this
    case, and finished cases do not run again."""
    dent.set(level=7)
    how = dict(M=[16, 18, 20, 22, 24, 26, 28, 30])
    here = ovr.sweep(dent, workers=2, **how)

    def finished(folder="here"):
        return [name for name in os.listdir(folder)
                if name.endswith(".json")] if os.path.isdir(folder) else []

    killed = []

    def look(fraction):
        if not killed and len(finished()) >= 2:
            pids = client.run(os.getpid)
            killed.append(next(iter(pids.values())))
            os.kill(killed[0], signal.SIGKILL)

    there = ovr.sweep(dent, workers=client.get_executor(), output="here",
                      progress=look, **how)
    assert killed and len(finished()) == 8
    same(here, there)

    def ends():
        return {name: open(f"here/{name[:-5]}.log").read().count("\nfinished")
                for name in finished()}

    assert set(ends().values()) == {1}
    same(there, ovr.sweep(dent, workers=client.get_executor(), output="here",
                          **how))
    assert set(ends().values()) == {1}  # read, not run


def test_files_that_are_there(dent):
    """Existing files are read if they are complete, and rejected if they
    belong to another case."""
    first = ovr.sweep(dent, M=[20, 25], workers=2, output="here")
    os.unlink("here/M=25.json")
    again = ovr.sweep(dent, M=[20, 25], workers=2, output="here")
    same(first, again)
    assert float(first.seconds[0]) == float(again.seconds[0])
    other = ovr.sweep(dent, M=[20], L=5, workers=1, output="here")
    assert "another case" in str(other.message.values[0])
    forced = ovr.sweep(dent, M=[20], L=5, workers=1, output="here", force=True)
    assert forced.converged.all()
