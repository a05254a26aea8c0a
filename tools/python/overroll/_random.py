# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws of a case some of whose keys are random."""
from __future__ import annotations

import os
import re
import tempfile
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _workers
from ._case import Case, Path, case_of
from ._library import BadInput, ORIGIN, encoded, error_of, ffi, lib
from ._library import new_error, text
from ._progress import Progress, Teller
from ._sweep import coordinate, dataset
from ._tables import place

if TYPE_CHECKING:
    import xarray

_LAW = re.compile(r"\s*((normal|lognormal|uniform|triangular|file) |"
                  r"-?\d+\.\.-?\d+\s*$)")


def _drawn(settings: dict[str, Any], keys: dict[str, str]) -> list[Case]:
    """A case for each draw, which says nothing but its values: the study is
    made by the library."""
    lines = ["[study]", "results = no", "[random]"]
    lines += [f"{name} = {value}" for name, value in settings.items()]
    for key, law in keys.items():
        if law.startswith("file "):
            law = "file " + os.path.abspath(law[5:].strip())
        lines.append(f"{place(key).replace(' ', '.')} = {law}")
    err = new_error()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "random")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")
        study = lib.ovr_study_read(encoded(path), ffi.NULL, err)
    if study == ffi.NULL:
        raise error_of(err)
    try:
        cases = []
        for k in range(lib.ovr_study_cases(study)):
            c = lib.ovr_study_case(study, k, err)
            if c == ffi.NULL:
                raise error_of(err)
            try:
                cases.append(Case.from_text(
                    text(lib.ovr_case_text(c, ffi.NULL))))
            finally:
                lib.ovr_case_free(c)
        return cases
    finally:
        lib.ovr_study_free(study)


def random(case: Union[None, Case, Path] = None, *, draws: int = 200,
           seed: int = 1, design: str = "sobol", shifts: Optional[int] = None,
           workers: _workers.Workers = None, output: Optional[Path] = None,
           force: bool = False, progress: Progress = None,
           **keys: Any) -> "xarray.Dataset":
    """Runs draws of a case, as a study with [random] does.

    >>> table = overroll.random("ground.ini", draws=256,
    ...                         load="normal 300 kN/m sd 10 %",
    ...                         feature_ground_seed="1..1000000000")
    >>> table.H_min_overall.quantile(0.05)

    Parameters
    ----------
    case : Case or path, optional
    draws, seed, design, shifts
        As in overroll-study(5): the same draws as there.
    workers : int or executor, optional
        Threads, or any executor of concurrent.futures.
    output : path, optional
        A folder for the result files, draw-0001.h5 and so on: what is there
        and whole is read, what was stopped is resumed.
    force : bool
        Run all again.
    progress : bool or callable(fraction), optional
    **keys
        Keys of the case; those whose value is a distribution (a text that
        begins with normal, lognormal, uniform, triangular or file, or a range
        1..8) are random.

    Returns
    -------
    xarray.Dataset
        Over a dimension `draw`: the drawn values as coordinates, the numbers
        of each run as variables, as `sweep` has them.

    Raises
    ------
    BadInput
        A key or value that is not understood, before anything is run.
    """
    _workers.check(workers)
    chances = {key: value for key, value in keys.items()
               if isinstance(value, str) and _LAW.match(value)}
    if not chances:
        raise BadInput(f"{ORIGIN}: no key is random: load='normal 300 kN/m sd "
                       "10 %'")
    base = case_of(case, {k: v for k, v in keys.items() if k not in chances})
    base = base.copy() if base is case else base
    base["output.file"] = None
    settings = {"draws": draws, "seed": seed, "design": design}
    if design == "sobol" and shifts is not None:
        settings["shifts"] = shifts
    drawn = _drawn(settings, chances)
    values = {key: [c[place(key)] for c in drawn] for key in chances}
    coordinates = [coordinate(base, key, value, repeated=True)
                   for key, value in values.items()]
    cases = [base.copy().set(**{key: values[key][k] for key in chances})
             for k in range(len(drawn))]
    cases[0].resolved()
    names = [f"draw-{k + 1:04d}" for k in range(len(drawn))]
    paths: list[Optional[str]] = [None] * len(cases)
    if output is not None:
        os.makedirs(output, exist_ok=True)
        paths = [os.path.join(os.path.abspath(output), name + ".h5")
                 for name in names]
    found = _workers.run_all(cases, paths, workers, force, Teller(progress))
    return dataset(found, {"draw": range(1, len(cases) + 1)},
                   {key: ("draw", numbers, about)
                    for key, numbers, about in coordinates})
