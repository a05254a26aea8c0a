# SPDX-License-Identifier: GPL-3.0-or-later
"""Many cases from one."""
from __future__ import annotations

import itertools
import os
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional, Union

import numpy as np

from . import _workers
from ._case import Case, Path, case_of, value_text
from ._library import text
from ._progress import Progress, Teller
from ._tables import extremes, observables, parameters, place

if TYPE_CHECKING:
    import xarray


def _name(keys: list[str], values: tuple[Any, ...]) -> str:
    parts = (f"{key}={value_text(value)}" for key, value in zip(keys, values))
    return "_".join(parts).replace("/", "per").replace(" ", "")


def coordinate(c: Case, key: str, values: list[Any],
               repeated: bool = False) -> tuple[str, Any, dict]:
    """Numbers in SI or bare, where all values are numbers, and different ones
    unless they may be `repeated`; else texts."""
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
    if np.isfinite(numbers).all() and (repeated or
                                       len(set(numbers)) == len(values)):
        return key, np.array(numbers), {"units": unit or "1"}
    return key, np.array([value_text(v) for v in values], dtype=object), {}


def sweep(case: Union[None, Case, Path] = None, *,
          workers: _workers.Workers = None, output: Optional[Path] = None,
          force: bool = False, progress: Progress = None,
          **keys: Any) -> "xarray.Dataset":
    """Runs a case for each combination of some of its keys, in threads or by
    an executor.

    >>> table = overroll.sweep(c, feature_dent_depth=[0.05, 0.1],
    ...                        slide_to_roll=[0, 0.5], workers=2)
    >>> table.H_min_overall.sel(slide_to_roll=0.5)

    Parameters
    ----------
    case : Case or path, optional
    workers : int or executor, optional
        So many threads, as many as there are processors unless given; or any
        executor of concurrent.futures: processes, those of mpi4py, ipyparallel
        or dask (`client.get_executor()`), to which the text of each case
        travels.  It is not shut down; Ctrl-C takes back what has not begun.
    output : path, optional
        A folder for the result files, named by the values, which workers
        elsewhere must share; without it none are kept.  What is there and
        whole is read, what was stopped is resumed.
    force : bool
        Run all again, and replace files that are there.
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
    _workers.check(workers)
    varied = {key: list(value) for key, value in keys.items()
              if isinstance(value, (list, tuple, range, np.ndarray))}
    base = case_of(case, {k: v for k, v in keys.items() if k not in varied})
    base = base.copy() if base is case else base
    base["output.file"] = None
    coordinates = [coordinate(base, *item) for item in varied.items()]
    points = list(itertools.product(*varied.values()))
    cases = [base.copy().set(**dict(zip(varied, point))) for point in points]
    paths: list[Optional[str]] = [None] * len(points)
    if output is not None:
        os.makedirs(output, exist_ok=True)
        paths = [os.path.join(os.path.abspath(output),
                              _name(list(varied), point) + ".h5")
                 for point in points]
    found = _workers.run_all(cases, paths, workers, force, Teller(progress))
    return dataset(found, {key: numbers for key, numbers, _ in coordinates},
                   {key: (key, numbers, about)
                    for key, numbers, about in coordinates})


def dataset(found: list[dict[str, Any]], dims: Mapping[str, Iterable[Any]],
            coordinates: Mapping[str, Any]) -> "xarray.Dataset":
    """What was found over dimensions, in their order, with coordinates."""
    import xarray
    shape = [len(list(values)) for values in dims.values()]
    ds = xarray.Dataset(coords={**{name: list(values)
                                   for name, values in dims.items()
                                   if name not in coordinates},
                                **coordinates})
    about = {**extremes(), **observables()}
    for name in dict.fromkeys(itertools.chain.from_iterable(found)):
        if name == "failed" or name in ds.coords:
            continue
        column = [row.get(name, "" if name == "message" else np.nan)
                  for row in found]
        kind = object if name == "message" else \
            bool if name == "converged" else float
        attrs = {"long_name": about[name].long_name} if name in about else {}
        ds[name] = (list(dims), np.array(column, kind).reshape(shape), attrs)
    return ds
