# SPDX-License-Identifier: GPL-3.0-or-later
"""One case run somewhere: in a thread, or in a process of an executor, to
which its text travels and from which its numbers come back."""
from __future__ import annotations

import fcntl
import json
import math
import os
from typing import Any, Callable, Optional

from ._case import Case
from ._library import (OverrollError, Stopped, encoded, error_of, ffi, lib,
                       new_error, text)
from ._run import _Watch, go, options
from ._simulation import _RunCore
from ._version import VERSION

_FORMS = (lib.OVR_SUMMARY_NUMBER, lib.OVR_SUMMARY_COUNT, lib.OVR_SUMMARY_FLAG)


@ffi.callback("ovr_summary_taker")
def _take(data: Any, line: Any) -> None:
    if line.key != ffi.NULL and line.form in _FORMS:
        ffi.from_handle(data)[text(line.key)] = line.number


def _summary(core: _RunCore) -> dict[str, Any]:
    """The numbers of a finished run, by their JSON keys; those that are not
    known are NaN."""
    info = lib.ovr_run_get_info(core.run)
    found: dict[str, Any] = {}
    handle = ffi.new_handle(found)
    lib.ovr_run_summary(info, _take, handle)
    lib.ovr_setup_scales(info.setup, _take, handle)
    found["converged"] = bool(info.converged)
    found["seconds"] = info.seconds
    found["message"] = "; ".join(text(info.warning[k])
                                 for k in range(info.warnings))
    return found


def _say(path: str, what: str) -> None:
    with open(path + ".log", "a", encoding="utf-8") as log:
        log.write(f"{what} {os.uname().nodename} {os.getpid()}\n")


def _read(path: str) -> Optional[dict[str, Any]]:
    """What a run that has finished left."""
    try:
        with open(path + ".json", encoding="utf-8") as file:
            found = json.load(file)
    except FileNotFoundError:
        return None
    return {key: math.nan if value is None else value
            for key, value in found.items()}


def _write(path: str, found: dict[str, Any]) -> None:
    """Whole or not at all; a line for each number, as studies have them."""
    lines = ",\n".join(
        f'  "{key}": ' + json.dumps(
            None if isinstance(value, float) and not math.isfinite(value)
            else value) for key, value in found.items())
    with open(path + ".json.part", "w", encoding="utf-8") as file:
        file.write("{\n" + lines + "\n}\n")
        file.flush()
        os.fsync(file.fileno())
    os.replace(path + ".json.part", path + ".json")


def _compute(case: Case, output: Optional[str], force: bool, steady: bool,
             estimate: bool, go_on: bool,
             stopped: Optional[Callable[[], bool]]) -> dict[str, Any]:
    watch = _Watch(False, None, None, stopped)
    how, _path = options(watch, output, force)
    how.no_thread = True
    how.steady = steady
    how.estimate_error = estimate
    err = new_error()
    if go_on:
        how.force = how.from_start = True
        run = lib.ovr_run_resume(encoded(output), how, ffi.NULL, err)
    else:
        run = lib.ovr_run_create(case._share(), how, ffi.NULL, err)
    if run == ffi.NULL:
        raise error_of(err)
    core = _RunCore(run, case._c)
    if go(core, watch) == lib.OVR_STOPPED:
        raise Stopped("stopped")
    return _summary(core)


def _once(case: Case, source: str, path: str, output: str, force: bool,
          *how: Any) -> dict[str, Any]:
    """With files: what has finished as this case is read, what was stopped is
    resumed.  NAME.ini is locked meanwhile: where an executor runs a task
    twice, the second waits, and reads."""
    with open(path + ".ini", "a+", encoding="utf-8",
              errors="surrogateescape") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        lock.seek(0)
        same = lock.read() == source
        found = _read(path) if same and not force else None
        if found is not None:
            return found
        go_on = same and not force and os.path.exists(output)
        if not same or force:
            if not force and os.path.exists(output):
                raise OverrollError(f"{output}: exists, of another case; "
                                    "force=True replaces it")
            if os.path.exists(path + ".json"):
                os.unlink(path + ".json")
            lock.truncate(0)
            lock.write(source)
            lock.flush()
        _say(path, "begins")
        found = _compute(case, output, force, *how[:2], go_on, how[2])
        _write(path, found)
        _say(path, "finished")
        return found


def run(source: str, name: str, directory: Optional[str],
        output: Optional[str] = None, force: bool = False,
        steady: bool = False, estimate: bool = False,
        stopped: Optional[Callable[[], bool]] = None) -> dict[str, Any]:
    """The numbers of a case, or `message` says why there are none; with
    `version`, that of the package that ran it."""
    try:
        case = Case.from_text(source, name, directory)
        if output is None:
            found = _compute(case, None, force, steady, estimate, False,
                             stopped)
        else:
            found = _once(case, source, output[:-len(".h5")], output, force,
                          steady, estimate, stopped)
    except Stopped:
        raise
    except OverrollError as error:
        found = {"converged": False, "message": str(error), "failed": True}
    return {**found, "version": VERSION}
