# SPDX-License-Identifier: GPL-3.0-or-later
"""From a case to a result file."""
from __future__ import annotations

import atexit
import os
import shutil
import tempfile
import warnings
import weakref
from typing import TYPE_CHECKING, Any, Callable, Optional, Union

import numpy as np

from ._case import Case, Path, case_of, value_text
from ._library import (ORIGIN, OverrollWarning, encoded, error_of, ffi, lib,
                       new_error, text)
from ._progress import Progress, Teller
from ._simulation import Heights, _RunCore, moving_heights, remember, warn
from ._solution import Solution
from ._tables import place

if TYPE_CHECKING:
    import xarray

_FOLDER: list[str] = []


def temporary(name: str) -> str:
    """A path for a file that lives as long as the interpreter."""
    if not _FOLDER:
        _FOLDER.append(tempfile.mkdtemp(prefix="overroll-"))
        atexit.register(shutil.rmtree, _FOLDER[0], ignore_errors=True)
    handle, path = tempfile.mkstemp(suffix=name, dir=_FOLDER[0])
    os.close(handle)
    os.unlink(path)
    return path


class State(Solution):
    """A run's state, as an observer sees it: valid within the call."""

    def __init__(self, core: Any, info: Any) -> None:
        self._attach(core, info.sim, info.setup)
        self._info = info

    @property
    def pass_number(self) -> int:
        """Of several passes the one under way, from 1; 0: there are none."""
        return int(getattr(self._info, "pass"))


class _Watch:
    """What the callbacks of a run meet: see remember()."""

    def __init__(self, progress: Progress,
                 observe: Optional[Callable[[State], Any]],
                 heights: Optional[Heights],
                 stopped: Optional[Callable[[], bool]],
                 settings: Optional[dict[str, Any]] = None) -> None:
        self.teller = Teller(progress)
        self.observe = observe
        self.heights = heights
        self.stopped = stopped
        self.settings = settings or {}
        self.trouble: Optional[BaseException] = None
        self.info: Any = None
        self.core: Any = None
        self.state: Optional[State] = None
        self.handle = ffi.new_handle(weakref.ref(self))

    @property
    def surfaces(self) -> Any:
        """Features of the case; each of several passes has its own."""
        return ffi.NULL if self.info is None else self.info.setup.surfaces

    def follow(self) -> None:
        """Shows the simulation of the pass under way."""
        if self.state is not None and self.state._sim != self.info.sim:
            self.state = State(self.core, self.info)


@ffi.callback("bool(void *)", error=True, onerror=remember)
def _stop(data: Any) -> bool:
    watch = ffi.from_handle(data)()
    if watch.trouble is not None:
        return True
    watch.follow()
    if watch.observe is not None:
        enough = watch.observe(watch.state)
        if isinstance(enough, (bool, np.bool_)) and enough:
            return True
    if watch.teller:
        info = watch.info
        watch.teller.tell(info.fraction,
                          f"T = {watch.state.T:.3f}" if info.transient else "")
    return watch.stopped is not None and bool(watch.stopped())


@ffi.callback("bool(void *)", error=True, onerror=remember)
def _interrupt(data: Any) -> bool:
    watch = ffi.from_handle(data)()
    return watch.trouble is not None or (watch.stopped is not None
                                         and bool(watch.stopped()))


@ffi.callback("ovr_status(void *, ovr_case *, ovr_error *)",
              error=lib.OVR_BAD_INPUT, onerror=remember)
def _change(data: Any, c: Any, err: Any) -> int:
    status = lib.OVR_OK
    for word, value in ffi.from_handle(data)().settings.items():
        status = status or lib.ovr_case_set(
            c, encoded(place(word)), encoded(value_text(value)),
            ORIGIN.encode(), err)
    return status


def go(core: _RunCore, watch: _Watch) -> int:
    """Runs it; the status, or what the callbacks raised."""
    err = new_error()
    watch.info = lib.ovr_run_get_info(core.run)
    watch.core = core
    watch.state = State(core, watch.info)
    try:
        status = lib.ovr_run_execute(core.run, err)
    finally:
        watch.teller.end()
    if watch.trouble is not None:
        raise watch.trouble
    if status not in (lib.OVR_OK, lib.OVR_STOPPED):
        raise error_of(err, status)
    return status


def options(watch: _Watch, output: Optional[str],
            force: bool) -> tuple[Any, Any]:
    how = ffi.new("ovr_run_options *")
    how.force = force
    how.data = watch.handle
    how.stop = _stop
    how.interrupt = _interrupt
    if watch.heights is not None:
        how.heights = moving_heights
    if output is None:
        return how, None
    how.output = path = ffi.new("char[]", encoded(output))
    return how, path  # which must live as long


def run(case: Union[Case, Path], output: Optional[Path] = None, *,
        force: bool = False, progress: Progress = None,
        surface: Optional[Heights] = None,
        observe: Optional[Callable[[State], Any]] = None,
        stop: Optional[Callable[[], bool]] = None,
        **keys: Any) -> "xarray.Dataset":
    """Marches a case in time (one without `end` is steady) into a result
    file, as `overroll run` does.

    >>> ds = overroll.run("mine.ini", output="mine.h5")

    Ctrl-C finishes the step, closes the file and raises KeyboardInterrupt;
    `overroll.resume` goes on from there.

    Parameters
    ----------
    case : Case or path
    output : path, optional
        The result file; where the case says, unless given; else one that
        lives as long as the interpreter.
    force : bool
        Replace an existing file.
    progress : bool or callable(fraction), optional
        Unless given, told in terminals and notebooks.
    surface : callable(T, X) -> array, optional
        A surface of one's own, see `Simulation.surface`.  The file does not
        hold it: `resume` has to be given it again.
    observe : callable(state), optional
        Called after the steady start and each step; True ends the run, with
        a file that can be resumed, and so does what it raises, which
        travels on.  `state` is a `Solution`, to be used within the call.
    stop : callable() -> bool, optional
        Asked as often, and between the cycles of the steady start, in the
        thread that runs.
    **keys
        Keys of the case.

    Returns
    -------
    xarray.Dataset
        See `overroll.open`; of a case with several passes their rows, whose
        `file` names the results.

    Raises
    ------
    BadInput, NotConverged, Impossible, NoMemory, InputOutput
    """
    c = case_of(case, keys)
    c.resolved()  # errors name the lines of its own text
    c = c.copy() if c is case else c
    if output is None and c.get("output.file") is None:
        output = temporary(".h5")
    watch = _Watch(progress, observe, surface, stop)
    how, _path = options(watch, None if output is None else os.fspath(output),
                         force)
    err = new_error()
    created = lib.ovr_run_create(c._share(), how, ffi.NULL, err)
    if created == ffi.NULL:
        raise error_of(err)
    core = _RunCore(created, c._c)
    go(core, watch)
    return _finished(core)


def _finished(core: _RunCore) -> "xarray.Dataset":
    from ._xarray import open
    info = lib.ovr_run_get_info(core.run)
    warn(core)
    path = info.passes_file if info.passes else info.output
    return open(ffi.string(path).decode("utf-8", "surrogateescape"))


def resume(path: Path, *, force: bool = False, progress: Progress = None,
           surface: Optional[Heights] = None,
           observe: Optional[Callable[[State], Any]] = None,
           stop: Optional[Callable[[], bool]] = None,
           **keys: Any) -> "xarray.Dataset":
    """Goes on where the run of a result file ended, as `overroll resume`
    does.

    Parameters are those of `run`; `keys` are settings that may change, such
    as `end`.  `force` begins again where there is no checkpoint.

    Raises
    ------
    BadInput
        There is no checkpoint beside the file, or a key that would change the
        physics.
    """
    from ._xarray import open
    watch = _Watch(progress, observe, surface, stop, keys)
    how, _path = options(watch, None, force)
    how.from_start = force
    how.change = _change
    err = new_error()
    created = lib.ovr_run_resume(encoded(os.fspath(path)), how, ffi.NULL, err)
    if watch.trouble is not None:
        raise watch.trouble
    if created == ffi.NULL:
        if err.status:
            raise error_of(err)
        return open(path)  # complete, and to go no further
    core = _RunCore(created, None)
    go(core, watch)
    return _finished(core)


@ffi.callback("ovr_listener")
def _listed(data: Any, kind: int, message: Any) -> None:
    ffi.from_handle(data).append((kind, text(message)))


def unpack(path: Path, folder: Path, *, force: bool = False) -> list[str]:
    """Writes the case of a result file and the input files that it holds into
    a folder, as `overroll info --inputs` does: running that case computes the
    result again.

    Parameters
    ----------
    path
        A result file.
    folder
        Made if it is not there.
    force
        Replaces files there.

    Returns
    -------
    list of str
        The paths of the files, that of the case last.

    Warns
    -----
    OverrollWarning
        An input is not in the result file.
    """
    said: list[tuple[int, str]] = []
    handle = ffi.new_handle(said)
    err = new_error()
    status = lib.ovr_result_unpack(encoded(os.fspath(path)),
                                   encoded(os.fspath(folder)), force, _listed,
                                   handle, err)
    if status:
        raise error_of(err, status)
    for kind, message in said:
        if kind == lib.OVR_MESSAGE_WARNING:
            warnings.warn(message, OverrollWarning, stacklevel=2)
    return [message for kind, message in said if kind == lib.OVR_MESSAGE_FILE]
