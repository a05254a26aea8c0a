# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady solutions, and simulations that one steps through oneself."""
from __future__ import annotations

import sys
import threading
import warnings
import weakref
from typing import Any, Callable, Iterator, Optional, Union

import numpy as np

from ._case import Case, Path, case_of
from ._library import BadInput, OverrollWarning, check, error_of, ffi, lib
from ._library import new_error, text
from ._solution import Solution, view

_AT_WORK = ("this simulation is at work already, in another thread or further "
            "up")

Heights = Callable[[float, np.ndarray], Any]


class _RunCore:
    """An ovr_run and the case it needs, freed in order."""

    __slots__ = ("run", "case")

    def __init__(self, run: Any, case: Any) -> None:
        self.run, self.case = run, case

    def __del__(self) -> None:
        lib.ovr_run_free(self.run)


class Film(Solution):
    """A steady contact, as `overroll.steady` leaves it.

    Attributes
    ----------
    X, P, H, S, ... : numpy.ndarray
        Dimensionless, shape (n,), read-only, without a copy.
    pressure, thickness, roughness : xarray.DataArray
        With units.
    H_min, H_cen, P_max, ... :
        Numbers; see `numbers()`.
    converged : bool
    warnings : tuple of str
        What speaks against the result.
    lambda_ratio : float
        Central film over the composite Rq of both surfaces; NaN: smooth.
    seconds : float
    errors : dict or None
        With `estimate_error`: estimated discretization errors by key, H_min,
        H_cen, P_max, ...; NaN where the levels do not tell.
    """

    def __init__(self, core: _RunCore) -> None:
        info = lib.ovr_run_get_info(core.run)
        self._info = info
        self._attach(core, info.sim, info.setup)

    @property
    def converged(self) -> bool:
        return bool(self._info.converged)

    @property
    def seconds(self) -> float:
        return self._info.seconds

    @property
    def lambda_ratio(self) -> float:
        return self._info.lambda_ratio

    @property
    def warnings(self) -> tuple[str, ...]:
        return tuple(text(self._info.warning[k])
                     for k in range(self._info.warnings))

    @property
    def errors(self) -> Optional[dict[str, float]]:
        all_of_them = self._info.error
        if not all_of_them.level:
            return None
        return {text(e.key): e.error
                for e in all_of_them.of[0:all_of_them.count]}

    def __repr__(self) -> str:
        return (f"<overroll.Film M={self.contact.M:g} L={self.contact.L:g} "
                f"n={self.n} H_min={self.H_min:.6g} H_cen={self.H_cen:.6g} "
                f"P_max={self.P_max:.6g}>")


def warn(core: _RunCore) -> None:
    """Says the warnings of a run, at the place where the user called."""
    info = lib.ovr_run_get_info(core.run)
    depth, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        depth, frame = depth + 1, frame.f_back
    for k in range(info.warnings):
        warnings.warn(text(info.warning[k]), OverrollWarning, depth)


_STEADY = ffi.new("ovr_run_options *")
_STEADY.steady = True
_ESTIMATED = ffi.new("ovr_run_options *", _STEADY[0])
_ESTIMATED.estimate_error = True


def steady(case: Union[None, Path, Case] = None, *,
           estimate_error: bool = False, **keys: Any) -> Film:
    """Solves one steady contact, its features fully grown, as
    `overroll steady` does.

    >>> film = overroll.steady(M=20, L=10, level=9)
    >>> film.H_min, film.P.max(), film.pressure

    Parameters
    ----------
    case : Case or path, optional
    estimate_error : bool
        Solve again one level coarser; see `Film.errors`.
    **keys
        Keys of the case, see `Case`.

    Raises
    ------
    BadInput, NotConverged, Impossible, NoMemory
    """
    c = case_of(case, keys)
    # a steady solve takes the growth of features out of its case
    c = c.copy() if c is case and "grow" in c.text else c
    err = new_error()
    shared = c._share()
    run = lib.ovr_run_create(
        shared, _ESTIMATED if estimate_error else _STEADY, ffi.NULL, err)
    if run == ffi.NULL:
        raise error_of(err)
    core = _RunCore(run, shared)
    check(lib.ovr_run_execute(run, err), err)
    if lib.ovr_run_get_info(run).warnings:
        warn(core)
    return Film(core)


# --------------------------------------------------------------- simulations

class _SimCore:
    """A simulation, its setup and the case they need, freed in order; and what
    callbacks meet."""

    __slots__ = ("sim", "setup", "case", "heights", "standing", "surfaces",
                 "trouble", "handle", "__weakref__")

    def __init__(self, case: Any) -> None:
        self.case = case
        self.sim = self.setup = ffi.NULL
        self.heights: Optional[Heights] = None
        self.standing: Optional[Callable[[np.ndarray], Any]] = None
        self.surfaces = ffi.NULL
        self.trouble: Optional[BaseException] = None
        # weak: a strong one would keep this alive for ever
        self.handle: Any = ffi.new_handle(weakref.ref(self))

    def __del__(self) -> None:
        if self.sim != ffi.NULL:
            lib.ovr_simulation_free(self.sim)
        if self.setup != ffi.NULL:
            lib.ovr_setup_free(self.setup)


def checked(given: Any, n: int, T: float) -> np.ndarray:
    """What a surface function gave, if it may be one."""
    heights = np.asarray(given, dtype=float)
    if heights.shape not in ((n,), ()):
        raise BadInput(f"surface: the function gave an array of shape "
                       f"{heights.shape} where X has ({n},)", key="surface")
    if not np.isfinite(heights).all():
        raise BadInput(f"surface: the function gave a height that is not "
                       f"finite at T = {T:g}", key="surface")
    return heights


def remember(kind: Any, error: Any, traceback: Any) -> None:
    """What a callback raises, Ctrl-C too, goes on when C has returned."""
    core = ffi.from_handle(traceback.tb_frame.f_locals["data"])()
    if core.trouble is None:
        core.trouble = error


@ffi.callback("void(void *, double, size_t, const double *, double *)",
              onerror=remember)
def moving_heights(data: Any, T: float, n: int, X: Any, S: Any) -> None:
    core = ffi.from_handle(data)()
    out = np.frombuffer(ffi.buffer(S, 8 * n))
    out[:] = 0
    if core.surfaces != ffi.NULL:
        lib.ovr_surfaces_heights(core.surfaces, T, n, X, S)
    if core.trouble is None:
        out += checked(core.heights(T, view(None, X, n).copy()), n, T)


@ffi.callback("void(void *, double, size_t, const double *, double *)",
              onerror=remember)
def standing_heights(data: Any, T: float, n: int, X: Any, S: Any) -> None:
    core = ffi.from_handle(data)()
    out = np.frombuffer(ffi.buffer(S, 8 * n))
    out[:] = 0
    if core.surfaces != ffi.NULL:
        lib.ovr_surfaces_standing(core.surfaces, T, n, X, S)
    if core.trouble is None and core.standing is not None:
        out += checked(core.standing(view(None, X, n).copy()), n, T)


class Simulation(Solution):
    """A contact that one solves, steps through and looks at oneself.

    >>> sim = overroll.Simulation(overroll.Case(M=20, L=10, end=6))
    >>> sim.surface(lambda T, X: 0.05 * np.exp(-((X + 4.5 - T) / 0.2)**2))
    >>> for state in sim.march():
    ...     print(state.T, state.H_min)

    A case that is to be marched has its `end`: scheme and corrections are
    chosen for a run then, as by `overroll run`; else for a steady contact.

    X, P, H, S, ... are arrays without a copy, which show the solution as it
    is now: copy what is to be kept.  One thread at a time may use a
    simulation (RuntimeError else); several may run in several threads, since
    the interpreter is free while the library computes.

    Parameters
    ----------
    case : Case or path, optional
    **keys
        Keys of the case, see `Case`.
    """

    def __init__(self, case: Union[None, Path, Case] = None,
                 **keys: Any) -> None:
        c = case_of(case, keys)
        core = _SimCore(c._share())
        err = self._err = new_error()
        core.setup = lib.ovr_case_resolve(core.case, ffi.NULL, err)
        if core.setup == ffi.NULL:
            raise error_of(err)
        core.sim = lib.ovr_setup_simulation(core.setup, ffi.NULL, err)
        if core.sim == ffi.NULL:
            raise error_of(err)
        self._attach(core, core.sim, core.setup)
        core.surfaces = core.setup.surfaces
        self._lock = threading.Lock()
        self._fresh = True    # not solved yet
        self._broken = False  # a function of its user failed within a solve

    def __repr__(self) -> str:
        return f"<overroll.Simulation n={self.n} T={self.T:g}>"

    def surface(self, heights: Optional[Heights], *,
                speed: Optional[float] = None,
                standing: Optional[Callable[[np.ndarray], Any]] = None) -> None:
        """A surface of one's own, on top of the case's features.

        Parameters
        ----------
        heights : callable(T, X) -> array
            Called with the time (b/um) and the positions X (b), float64 of
            shape (n,); gives the heights in b^2/R, positive out of the
            surface, shape (n,).  What it raises ends the step or march that
            called it and travels on; a wrong shape or a number that is not
            finite is BadInput.  None: the case's features alone.
        speed : float, optional
            u/um of what moves: steps then begin from a guess that moves
            along, and take fewer cycles.
        standing : callable(X) -> array, optional
            Runs of fourth order: the part of the function that stands still.
            Unless given none of it does.
        """
        core, transient = self._core, self._setup.transient
        if heights is None:
            lib.ovr_simulation_surface(
                self._sim, lib.ovr_surfaces_heights
                if core.surfaces != ffi.NULL else ffi.NULL, core.surfaces)
            speed = lib.ovr_surfaces_speed(core.surfaces) \
                if core.surfaces != ffi.NULL else None
        else:
            lib.ovr_simulation_surface(self._sim, moving_heights, core.handle)
        core.heights, core.standing = heights, standing
        lib.ovr_simulation_moving(
            self._sim, float("nan") if speed is None else speed)
        if transient:
            lib.ovr_simulation_standing(self._sim, standing_heights,
                                        core.handle)

    # ------------------------------------------------------------ solving

    def _call(self, function: Any, *arguments: Any) -> None:
        if not self._lock.acquire(False):
            raise RuntimeError(_AT_WORK)
        try:
            status = function(self._sim, *arguments, self._err)
        finally:
            self._lock.release()
        if status or self._core.trouble is not None:
            self._fail(status)

    def _fail(self, status: int) -> None:
        """Raises what a function of the user or else the library said."""
        trouble, self._core.trouble = self._core.trouble, None
        if trouble is not None:
            self._broken = True
            raise trouble
        raise error_of(self._err, status)

    def steady(self) -> "Simulation":
        """Solves the steady contact at T = 0, the start of every run;
        returns the simulation.

        Raises NotConverged, Impossible, and what the surface function does.
        """
        self._call(lib.ovr_simulation_steady)
        self._fresh = self._broken = False
        return self

    def _begin(self) -> None:
        if self._broken:
            raise RuntimeError("the surface function failed in this "
                               "simulation: call steady() to begin again")
        if self._fresh:
            self.steady()

    def step(self, dT: Optional[float] = None) -> "Simulation":
        """One implicit step of length dT > 0 in b/um, the mesh size unless
        given; returns the simulation.  Solves the steady start first where
        that was not done.

        Raises NotConverged, Impossible, and what the surface function does.
        """
        self._begin()
        self._call(lib.ovr_simulation_step, self.D if dT is None else dT)
        return self

    def march(self, end: Optional[float] = None, *,
              step: Optional[float] = None, adaptive: Optional[bool] = None,
              error: Optional[float] = None,
              until_steady: Optional[bool] = None) -> Iterator["Simulation"]:
        """Marches in time, as the case says where nothing is given: yields
        the simulation at its steady start and after each step.

        A loop may end it by `break`, and go on later with another march;
        exceptions of the loop travel through.

        >>> for state in sim.march(end=6):
        ...     if state.H_min < 0.01:
        ...         break

        Parameters
        ----------
        end : float
            Last time, in b/um.
        step : float
            Length of the steps; the k-th time is exactly k steps.
        adaptive : bool
            Steps from the scheme's own estimate of the error, `error`.
        until_steady : bool
            Stop when nothing changes any more.
        """
        how = ffi.new("ovr_march *", self._setup.march[0])
        how.count = 0
        given = {"end": end, "dT": step, "adaptive": adaptive, "error": error,
                 "until_steady": until_steady}
        for name, value in given.items():
            if value is not None:
                setattr(how, name, value)
        if not how.end > 0:
            raise BadInput("march: no end: give one, or the case [time] end",
                           key="end")
        return self._march(how)

    def _march(self, how: Any) -> Iterator["Simulation"]:
        self._begin()
        core, sim, err, state = self._core, self._sim, self._err, self._state
        advance, more = lib.ovr_simulation_advance, ffi.new("bool *")
        acquire, release = self._lock.acquire, self._lock.release
        before = state.step
        if before == 0:
            yield self
        while True:
            if not acquire(False):
                raise RuntimeError(_AT_WORK)
            try:
                status = advance(sim, how, more, err)
            finally:
                release()
            if status or core.trouble is not None:
                self._fail(status)
            if state.step == before:  # it was at its end already
                return
            yield self
            if not more[0]:
                return
            if self._broken:
                self._begin()
