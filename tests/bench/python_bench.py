# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the cost of the Python interface on level 8.

usage: python_bench.py FILE.json

Steps of a rolling dent are computed by one call of ovr_simulation_march and by
a loop over Simulation.march that reads the state. A steady contact is computed
from its keys by functions of the library and by overroll.steady. Both variants
are run in alternation. The CPU time of this thread is the minimum of all turns.
"""
import json
import sys
import time

import overroll as ovr
from overroll._library import ffi, lib, new_error

LEVEL, STEPS, TURNS, SOLVES = 8, 200, 7, 20

case = ovr.Case(M=20, L=10, level=LEVEL, inlet=-4, end=2)
case.feature("dent", depth=0.1, width=0.5, start=-3.2)
err = new_error()


def started():
    return ovr.Simulation(case).steady()


def march_in_c(sim, end):
    how = ffi.new("ovr_march *", sim._setup.march[0])
    how.end = end
    assert not lib.ovr_simulation_march(sim._sim, how, err)


def march_in_python(sim, end):
    thinnest = 1
    for state in sim.march(end):
        thinnest = min(thinnest, state.H_min)
    return thinnest


def steady_in_c():
    for _ in range(SOLVES):
        c = lib.ovr_case_create(ffi.NULL, err)
        for key, value in ((b"contact.M", b"20"), (b"contact.L", b"10"),
                           (b"domain.level", b"%d" % LEVEL)):
            assert not lib.ovr_case_set(c, key, value, b"bench", err)
        how = ffi.new("ovr_run_options *")
        how.steady = True
        run = lib.ovr_run_create(c, how, ffi.NULL, err)
        assert not lib.ovr_run_execute(run, err)
        lib.ovr_run_free(run)
        lib.ovr_case_free(c)


def steady_in_python():
    for _ in range(SOLVES):
        ovr.steady(M=20, L=10, level=LEVEL)


def cpu_time(work, *arguments):
    began = time.thread_time()
    work(*arguments)
    return time.thread_time() - began


def least(*works):
    times = [[work() for work in works] for _ in range(TURNS)]
    return [min(column) for column in zip(*times)]


end = STEPS * started().D
c_step, python_step = (t / STEPS for t in least(
    lambda: cpu_time(march_in_c, started(), end),
    lambda: cpu_time(march_in_python, started(), end)))
c_steady, python_steady = (t / SOLVES for t in least(
    lambda: cpu_time(steady_in_c), lambda: cpu_time(steady_in_python)))
print("Python at level 8                 C   Python   ratio")
for name, c, python in (("step, reading its H_min", c_step, python_step),
                        ("steady contact", c_steady, python_steady)):
    print(f"{name:28} {1e6 * c:6.0f} {1e6 * python:6.0f} us {python / c:6.3f}")
with open(sys.argv[1], "w") as file:
    json.dump({"level": LEVEL, "c_step": c_step, "python_step": python_step,
               "c_steady": c_steady, "python_steady": python_steady}, file)
