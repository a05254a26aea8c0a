# SPDX-License-Identifier: GPL-3.0-or-later
"""Several simulations in several threads, and release of their memory."""
import gc
import os
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import overroll as ovr


def history(k):
    sim = ovr.Simulation(M=20 + k, L=10, level=5)
    sim.surface(lambda T, X: 0.02 * np.cos(X - T))
    return [state.H_min for state in sim.march(end=0.3)]


def test_threads_compute_the_same():
    alone = [history(k) for k in range(4)]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(history, range(4))) == alone


def test_runs_in_threads_keep_their_files():
    def run(k):
        return float(ovr.run(M=20 + k, L=10, level=5, end=0.3, case=None)
                     .film_thickness.min())
    alone = [run(k) for k in range(3)]
    with ThreadPoolExecutor(3) as pool:
        assert list(pool.map(run, range(3))) == alone


def test_the_interpreter_is_free_while_it_computes():
    """Another thread continues to count during a long call of a C function."""
    sim = ovr.Simulation(M=20, L=10, level=15)
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)
    thread = threading.Thread(target=tick)
    thread.start()
    began = time.perf_counter()
    sim.steady()
    ended = time.perf_counter()
    done.set()
    thread.join()
    within = [t for t in ticks if began < t < ended]
    assert len(within) > 3


def test_one_simulation_is_not_for_two_threads():
    sim = ovr.Simulation(M=20, L=10, level=4)
    inside, go_on = threading.Event(), threading.Event()

    def waits(T, X):
        inside.set()
        go_on.wait(10)
        return 0 * X
    sim.surface(waits)
    thread = threading.Thread(target=sim.steady)
    thread.start()
    inside.wait(10)
    with pytest.raises(RuntimeError, match="at work"):
        sim.step()
    go_on.set()
    thread.join()
    sim.surface(None)
    sim.step()


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_many_simulations_leave_nothing():
    """10,000 simulations leak less than 400 bytes each (make verify)."""
    keys = {"M": 5, "L": 2, "level": 2, "mlmi_order": 4, "mlmi_range": 2}

    def one(k):
        sim = ovr.Simulation(**keys)
        sim.surface(lambda T, X: 0 * X)
        if k % 20 == 0:
            sim.steady()
            ovr.steady(**keys)
            with pytest.raises(ovr.BadInput):
                ovr.Simulation(M=20)
        return sim.P
    for k in range(500):
        one(k)
    gc.collect()
    before, objects = resident(), len(gc.get_objects())
    for k in range(int(os.environ.get("SIMULATIONS", 1000))):
        one(k)
    gc.collect()
    assert resident() - before < 4e6
    assert len(gc.get_objects()) - objects < 1000
