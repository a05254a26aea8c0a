# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastohydrodynamically lubricated line contacts: overroll(1) from Python.

>>> import overroll as ovr
>>> film = ovr.steady(M=20, L=10, level=9)
>>> film.H_min, film.pressure
>>> ds = ovr.run("mine.ini", output="mine.h5")
>>> ds.overroll.plot()

Lengths are in b, heights in b^2/R, pressures in ph and times in b/um unless a
unit is named; see overroll-python(7) and overroll-theory(7).
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._case import Case
from ._library import (BadInput, Impossible, InputOutput, NoMemory,
                       NotConverged, OverrollError, OverrollWarning, Stopped)
from ._find import Found, find
from ._random import random
from ._run import State, resume, run, unpack
from ._simulation import Film, Simulation, steady
from ._solution import Solution
from ._sweep import sweep
from ._tables import Parameter, help, parameters
from ._version import VERSION as __version__

if TYPE_CHECKING:
    from ._xarray import open

# Without open, help and random, which Python has too.
__all__ = [
    "BadInput", "Case", "Film", "Found", "Impossible", "InputOutput",
    "NoMemory", "NotConverged", "OverrollError", "OverrollWarning",
    "Parameter", "Simulation", "Solution", "State", "Stopped", "find",
    "parameters", "resume", "run", "steady", "sweep", "unpack",
    "__version__"]


def __getattr__(name: str) -> Any:
    # xarray takes a second to import: only where it is needed
    if name == "open":
        from ._xarray import open
        return open
    raise AttributeError(f"module 'overroll' has no '{name}'")
