# SPDX-License-Identifier: GPL-3.0-or-later
"""Many tasks at once: in threads here, or by any executor of
concurrent.futures."""
from __future__ import annotations

import os
import threading
from concurrent.futures import (FIRST_COMPLETED, Executor, Future,
                                ThreadPoolExecutor, wait)
from typing import Any, Optional, Union

from . import _task
from ._case import Case
from ._library import ORIGIN, BadInput
from ._progress import Teller
from ._version import VERSION

Workers = Union[None, int, Executor]


def check(workers: Any) -> None:
    """Raises BadInput, before anything is read."""
    good = workers is None or hasattr(workers, "submit") or \
        (isinstance(workers, int) and not isinstance(workers, bool)
         and workers > 0)
    if not good:
        raise BadInput(f"{ORIGIN}: workers: must be a number or an executor "
                       f"(it has submit), not {type(workers).__name__}",
                       key="workers")


def _submit(pool: Any, cases: list[Case], paths: list[Optional[str]],
            how: dict[str, Any]) -> dict["Future[dict[str, Any]]", int]:
    return {pool.submit(_task.run, c.text, c.name or "text",
                        c.directory or os.getcwd(), path, **how): k
            for k, (c, path) in enumerate(zip(cases, paths))}


def _wait(waiting: dict["Future[dict[str, Any]]", int],
          teller: Teller) -> list[dict[str, Any]]:
    left, count = set(waiting), len(waiting)
    found: list[dict[str, Any]] = [{}] * count
    while left:
        done, left = wait(left, 0.2, FIRST_COMPLETED)
        for future in done:
            result = future.result()
            version = result.pop("version")
            if version != VERSION:
                raise BadInput(f"{ORIGIN}: a worker has overroll {version}, "
                               f"here is {VERSION}", key="workers")
            found[waiting[future]] = result
        teller.tell(1 - len(left) / count, f"{count - len(left)} of {count}")
    return found


def run_all(cases: list[Case], paths: list[Optional[str]], workers: Workers,
            force: bool, teller: Teller, steady: bool = False,
            estimate: bool = False) -> list[dict[str, Any]]:
    """The numbers of each case.  Where waiting ends by an exception, what runs
    in threads is stopped at its next step; of an executor, which is never shut
    down, only what has not begun is taken back."""
    how = {"force": force, "steady": steady, "estimate": estimate}
    waiting: dict["Future[dict[str, Any]]", int] = {}
    try:
        if isinstance(workers, int) or workers is None:
            stop = threading.Event()
            count = workers or len(os.sched_getaffinity(0))
            with ThreadPoolExecutor(count) as pool:
                waiting = _submit(pool, cases, paths,
                                  {**how, "stopped": stop.is_set})
                try:
                    return _wait(waiting, teller)
                except BaseException:
                    stop.set()
                    pool.shutdown(cancel_futures=True)
                    raise
        # dask would give the same task the same answer without running it
        extra = {"pure": False} if type(workers).__module__.startswith(
            "distributed.") and not isinstance(workers, Executor) else {}
        waiting = _submit(workers, cases, paths, {**how, **extra})
        return _wait(waiting, teller)
    except BaseException:
        for future in waiting:
            future.cancel()
        raise
    finally:
        teller.end()
