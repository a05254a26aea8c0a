# SPDX-License-Identifier: GPL-3.0-or-later
"""The value of a key for which a number of the run has a value."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional, Union

import numpy as np

from . import _workers
from ._case import Case, Path, case_of, value_text
from ._library import (ORIGIN, BadInput, encoded, error_of, ffi, lib,
                       new_error, rows, text)
from ._progress import Progress, Teller
from ._tables import place
from ._task import _take


@dataclass
class Found:
    """What `overroll.find` found.

    `value` is in `unit`, which is that of the ends of `between`; `low` and
    `high` are the bracket it lies in, `error` how far off it may be by the
    discretization of the quantity (NaN: not known), `slope` the derivative of
    the quantity, `scatter` its relative scatter from mesh to mesh.
    `evaluations` are all runs in the order of their values, `numbers` those of
    the run at the answer, `message` what is to be known beside it.
    """

    key: str
    value: float
    unit: str
    quantity: str
    at_value: float
    low: float
    high: float
    error: float
    slope: float
    scatter: float
    monotone: bool
    message: str
    evaluations: list[dict[str, Any]] = field(repr=False)
    numbers: dict[str, float] = field(repr=False)

    def __float__(self) -> float:
        return self.value


class _Asked:
    """What the callback of a search meets."""

    def __init__(self, workers: _workers.Workers, progress: Progress) -> None:
        self.workers = workers
        self.progress = progress
        self.trouble: Optional[BaseException] = None
        self.handle = ffi.new_handle(self)


@ffi.callback("ovr_trial_runner", error=lib.OVR_STOPPED)
def _run_trials(data: Any, trials: Any, err: Any) -> int:
    asked = ffi.from_handle(data)
    try:
        cases = []
        for c in rows(lib.ovr_trials_case, trials):
            directory = lib.ovr_case_directory(c)
            cases.append(Case.from_text(
                text(lib.ovr_case_text(c, ffi.NULL)),
                text(lib.ovr_case_name(c)) or "text", text(directory)))
        found = _workers.run_all(
            cases, [None] * len(cases), asked.workers, False,
            Teller(asked.progress), bool(lib.ovr_trials_steady(trials)),
            bool(lib.ovr_trials_estimate(trials)))
    except BaseException as trouble:  # raised again by find()
        asked.trouble = trouble
        return lib.OVR_STOPPED
    for k, numbers in enumerate(found):
        if numbers.get("failed"):
            lib.ovr_trials_fail(trials, k, encoded(numbers["message"]))
            continue
        steady = not np.isfinite(numbers.get("steps", np.nan))
        for key, value in numbers.items():
            if key != "message":
                lib.ovr_trials_put(trials, k, encoded(key), float(value))
        if steady and not numbers["converged"]:
            lib.ovr_trials_fail(trials, k, b"the solution did not converge")
    return lib.OVR_OK


def _condition(quantity: str, equals: Any, at_least: Any, at_most: Any) -> str:
    given = [(word, value) for word, value in (
        ("is", equals), ("at least", at_least), ("at most", at_most))
        if value is not None]
    if len(given) != 1:
        raise BadInput(f"{ORIGIN}: one of equals, at_least and at_most is "
                       "needed", key="equals")
    return f"{quantity} {given[0][0]} {value_text(given[0][1])}"


def find(case: Union[None, Case, Path], key: str, *,
         between: tuple[Any, Any], quantity: str, equals: Any = None,
         at_least: Any = None, at_most: Any = None,
         which: Optional[str] = None, tolerance: float = 1e-3,
         steady: bool = False, workers: _workers.Workers = None,
         progress: Progress = False, **keys: Any) -> Found:
    """The value of a key for which a number of the run has a value, as
    `overroll find` does.

    >>> overroll.find("dent.ini", "feature.dent.depth",
    ...               between=("0.1 um", "2 um"), quantity="H_min_overall",
    ...               equals=0.05)

    Parameters
    ----------
    case : Case or path
    key : str
        The key that is varied, by any of its names.
    between : two values
    quantity : str
        A number of the run by its JSON name.
    equals, at_least, at_most : number or text with a unit
        One of them.
    which : "largest" or "smallest"
        The key, where the quantity is at least or at most a value.
    tolerance : float
        Relative, of the key.
    steady : bool
        The steady contact alone.
    workers : int or executor, optional
        For runs that can be made at once: threads, or any executor of
        concurrent.futures.
    progress : bool or callable(fraction), optional
    **keys
        Keys of the case.

    Returns
    -------
    Found

    Raises
    ------
    BadInput
        What is asked cannot be, has no answer, or several.
    NotConverged
        Runs fail where the answer lies.
    """
    _workers.check(workers)
    base = case_of(case, keys)
    if isinstance(between, (str, bytes)) or len(between) != 2:
        raise BadInput(f"between={between!r}: two values are needed, "
                       "between=(A, B)", key="between")
    asked = _Asked(workers, progress)
    how = ffi.new("ovr_find_options *")
    texts = {"key": place(key), "low": value_text(between[0]),
             "high": value_text(between[1]),
             "condition": _condition(quantity, equals, at_least, at_most)}
    if which is not None:
        texts["which"] = which
    keep = {name: ffi.new("char[]", encoded(value))
            for name, value in texts.items()}
    for name, value in keep.items():
        setattr(how, name, value)
    how.tolerance = tolerance
    how.steady = steady
    how.workers = workers if isinstance(workers, int) else 1
    how.data = asked.handle
    how.run = _run_trials
    err = new_error()
    search = lib.ovr_find_create(base._c, how, err)
    if search == ffi.NULL:
        raise error_of(err)
    try:
        status = lib.ovr_find_execute(search, err)
        if asked.trouble is not None:
            raise asked.trouble
        if status:
            raise error_of(err, status)
        return _found(search)
    finally:
        lib.ovr_find_free(search)


def _found(search: Any) -> Found:
    info = lib.ovr_find_get_info(search)
    evaluations = []
    for k in range(info.evaluations):
        e = lib.ovr_find_evaluation_at(search, k)
        evaluations.append({
            "value": e.value, "quantity": e.quantity, "order": e.order,
            "level": e.level, "converged": bool(e.converged),
            "marked": e.marked, "seconds": e.seconds,
            "message": text(e.message)})
    numbers: dict[str, float] = {}
    lib.ovr_find_summary(search, True, _take, ffi.new_handle(numbers))
    return Found(text(info.key), info.value, text(info.unit),
                 text(info.quantity), info.at_value, info.low, info.high,
                 info.error, info.slope, info.scatter, bool(info.monotone),
                 text(info.message), evaluations, numbers)
