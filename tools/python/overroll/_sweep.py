# SPDX-License-Identifier: GPL-3.0-or-later
"""Many cases from one."""
from __future__ import annotations

import itertools
import os
import threading
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from ._case import Case, Path, case_of, value_text
from ._library import OverrollError, error_of, ffi, lib, new_error, text
from ._progress import Progress, Teller
from ._run import _Watch, go, options
from ._simulation import _RunCore
from ._solution import Solution
from ._tables import extremes, observables, parameters, place

if TYPE_CHECKING:
    import xarray


class _Summary(Solution):
    """The numbers of a finished run."""

    def __init__(self, core: _RunCore) -> None:
        info = lib.ovr_run_about(core.run)
        self._attach(core, info.sim, info.setup)
        self.found = {name: value for name, value in self.numbers().items()
                      if info.transient or name not in extremes()
                      or extremes()[name].row.of.steady}
        self.found["converged"] = bool(info.converged)
        self.found["seconds"] = info.seconds
        self.found["message"] = "; ".join(
            text(info.warning[k]) for k in range(info.warnings))


def _run_one(c: Case, output: Optional[str], force: bool,
             stop: threading.Event) -> dict[str, Any]:
    watch = _Watch(False, None, None, stop.is_set)
    how, _path = options(watch, output, force)
    how.no_thread = True
    err = new_error()
    try:
        run = lib.ovr_run_create(c._share(), how, ffi.NULL, err)
        if run == ffi.NULL:
            raise error_of(err)
        core = _RunCore(run, c._c)
        go(core, watch)
    except OverrollError as error:
        return {"converged": False, "message": str(error)}
    return _Summary(core).found


def _name(keys: list[str], values: tuple[Any, ...]) -> str:
    parts = (f"{key}={value_text(value)}" for key, value in zip(keys, values))
    return "_".join(parts).replace("/", "per").replace(" ", "")


def _coordinate(c: Case, key: str, values: list[Any]) -> tuple[str, Any, dict]:
    """Numbers in SI or bare, where all values are numbers; else texts."""
    numbers, unit = [], ""
    where = place(key).replace(" ", ".")
    for value in values:
        probe = c.copy()
        probe[key] = value
        entry = next(e for name, e in probe._entries()
                     if name.replace(" ", ".") == where)
        kind = parameters()[entry.parameter].type
        numbers.append(entry.number if kind.endswith("number") else np.nan)
        unit = text(entry.unit) or unit
    if np.isfinite(numbers).all() and len(set(numbers)) == len(values):
        return key, np.array(numbers), {"units": unit or "1"}
    return key, np.array([value_text(v) for v in values], dtype=object), {}


def sweep(case: Union[None, Case, Path] = None, *,
          workers: Optional[int] = None, output: Optional[Path] = None,
          force: bool = False, progress: Progress = None,
          **keys: Any) -> "xarray.Dataset":
    """Runs a case for each combination of some of its keys, in threads.

    >>> table = overroll.sweep(c, feature_dent_depth=[0.05, 0.1],
    ...                        slide_to_roll=[0, 0.5], workers=2)
    >>> table.H_min_overall.sel(slide_to_roll=0.5)

    Parameters
    ----------
    case : Case or path, optional
    workers : int, optional
        At once; the processors there are unless given.
    output : path, optional
        A folder for the result files, named by the values; without it none
        are kept.
    force : bool
        Replace files that are there.
    progress : bool or callable(fraction), optional
    **keys
        A list for each key to be varied, one value for all others.

    Returns
    -------
    xarray.Dataset
        A dimension for each varied key, of its name, with its values in SI or
        bare numbers (texts where they are none); variables are the numbers of
        the end state and the extremes of the run by their JSON names (H_min,
        H_min_overall, ...), NaN for a case that failed, with `converged`,
        `seconds` and `message`, which says why.

    Raises
    ------
    BadInput
        A key or value that is not understood, before anything is run.
    KeyboardInterrupt
        After the steps at work.
    """
    import xarray
    varied = {key: list(value) for key, value in keys.items()
              if isinstance(value, (list, tuple, range, np.ndarray))}
    base = case_of(case, {k: v for k, v in keys.items() if k not in varied})
    base = base.copy() if base is case else base
    base["output.file"] = None
    coordinates = [_coordinate(base, *item) for item in varied.items()]
    points = list(itertools.product(*varied.values()))
    cases = [base.copy().set(**dict(zip(varied, point))) for point in points]
    paths: list[Optional[str]] = [None] * len(points)
    if output is not None:
        os.makedirs(output, exist_ok=True)
        paths = [os.path.join(output, _name(list(varied), point) + ".h5")
                 for point in points]
    found = _run_all(cases, paths, workers, force, Teller(progress))
    shape = [len(values) for values in varied.values()]
    ds = xarray.Dataset(coords={key: (key, values, about)
                                for key, values, about in coordinates})
    about = {**observables(), **extremes()}
    for name in dict.fromkeys(itertools.chain.from_iterable(found)):
        column = [row.get(name, "" if name == "message" else np.nan)
                  for row in found]
        kind = object if name == "message" else \
            bool if name == "converged" else float
        attrs = {"long_name": about[name].long_name} if name in about else {}
        ds[name] = (list(varied), np.array(column, kind).reshape(shape), attrs)
    return ds


def _run_all(cases: list[Case], paths: list[Optional[str]],
             workers: Optional[int], force: bool,
             teller: Teller) -> list[dict[str, Any]]:
    stop = threading.Event()
    count = workers or len(os.sched_getaffinity(0))
    with ThreadPoolExecutor(count) as pool:
        waiting = {pool.submit(_run_one, c, path, force, stop): k
                   for k, (c, path) in enumerate(zip(cases, paths))}
        left = set(waiting)
        try:
            while left:
                done, left = wait(left, 0.2, FIRST_COMPLETED)
                teller.tell(1 - len(left) / len(cases),
                            f"{len(cases) - len(left)} of {len(cases)}")
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise
        finally:
            teller.end()
    results: list[dict[str, Any]] = [{}] * len(cases)
    for future, k in waiting.items():
        results[k] = future.result()
    return results
