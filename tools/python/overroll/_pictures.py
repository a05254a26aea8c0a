# SPDX-License-Identifier: GPL-3.0-or-later
"""The program's own pictures, shown in a notebook."""
from __future__ import annotations

import base64
import html
import os
import weakref
from typing import Any, Optional, Sequence, Union

from ._library import BadInput, check, encoded, error_of, ffi, lib, new_error
from ._library import options_of, put_option
from ._progress import Progress, Teller
from ._run import temporary
from ._simulation import remember

Path = Union[str, "os.PathLike[str]"]


class _Shown:
    """A file that a notebook shows."""

    def __init__(self, path: str) -> None:
        #: Where it is.
        self.path = path

    @property
    def data(self) -> bytes:
        """What is in it."""
        with open(self.path, "rb") as file:
            return file.read()

    def _url(self, kind: str) -> str:
        return f"data:{kind};base64," + base64.b64encode(self.data).decode()

    def __fspath__(self) -> str:
        return self.path

    def __repr__(self) -> str:
        return f"<overroll.{type(self).__name__} {self.path}>"


class Picture(_Shown):
    """A picture, shown by a notebook when it ends a cell."""

    def _repr_png_(self) -> Optional[bytes]:
        return self.data if self.path.endswith(".png") else None

    def _repr_svg_(self) -> Optional[str]:
        return self.data.decode() if self.path.endswith(".svg") else None


class Movie(_Shown):
    """A movie, or a folder of frames; `drawn` and `kept` count frames."""

    drawn = kept = 0

    def _repr_html_(self) -> Optional[str]:
        ending = os.path.splitext(self.path)[1][1:]
        if ending in ("gif", "webp"):
            return f"<img src='{self._url('image/' + ending)}'>"
        if ending in ("mp4", "webm"):
            return (f"<video controls loop width='100%' "
                    f"src='{self._url('video/' + ending)}'></video>")
        return None


class Page(_Shown):
    """A page that plays a run."""

    def _repr_html_(self) -> str:
        page = html.escape(self.data.decode(), quote=True)
        return (f'<iframe srcdoc="{page}" width="100%" height="640" '
                'frameborder="0"></iframe>')


class _Results:
    """Result files, open for the library."""

    def __init__(self, paths: Sequence[Path]) -> None:
        self.opened: list[Any] = []
        for path in paths:
            err = new_error()
            result = lib.ovr_result_open(encoded(os.fspath(path)), ffi.NULL,
                                         err)
            if result == ffi.NULL:
                raise error_of(err)
            self.opened.append(ffi.gc(result, lib.ovr_result_close))
        self.array = ffi.new("ovr_result *[]", self.opened)
        self.count = len(self.opened)


def _target(path: Optional[Path], ending: str, how: dict[str, Any]) -> str:
    """Where a picture goes; one without a path is replaced at will."""
    if path is not None:
        return os.fspath(path)
    how["force"] = True
    return temporary(ending)


def _look(look: dict[str, Any]) -> dict[str, Any]:
    """`units` in our words."""
    words = {"stored": lib.OVR_AS_STORED, "hertzian": lib.OVR_HERTZIAN,
             "si": lib.OVR_SI}
    if "units" in look:
        if look["units"] not in words:
            raise BadInput(f"units: '{look['units']}' must be stored, "
                           "hertzian or si", key="units")
        look["units"] = words[look["units"]]
    return look


def plot(paths: Sequence[Path], kind: str, path: Optional[Path],
         look: dict[str, Any]) -> Picture:
    given = _look(dict(look))
    target = _target(path, ".png", given)
    how, keep = options_of("ovr_picture_options",
                           {"kind": kind, "path": target, **given})
    results, err = _Results(paths), new_error()
    check(lib.ovr_picture(results.array, results.count, how, ffi.NULL, err),
          err)
    del keep
    return Picture(target)


class _Watch:
    """What the progress of frames meets: see remember()."""

    def __init__(self, progress: Progress) -> None:
        self.teller = Teller(progress)
        self.trouble: Optional[BaseException] = None
        self.handle = ffi.new_handle(weakref.ref(self))


@ffi.callback("bool(void *, size_t, size_t)", error=False, onerror=remember)
def _drawn(data: Any, done: int, count: int) -> bool:
    watch = ffi.from_handle(data)()
    if watch.teller:
        watch.teller.tell(done / count, f"frame {done} of {count}")
    return watch.trouble is None


def frames(paths: Sequence[Path], movie: Optional[Path],
           folder: Optional[Path], progress: Progress,
           how: dict[str, Any]) -> Movie:
    of_frames = {name for name, _ in ffi.typeof("ovr_frames_options").fields}
    given = _look(dict(how))
    if movie is None and folder is None:
        movie = temporary(".mp4")
    options, keep = options_of(
        "ovr_frames_options",
        {name: value for name, value in given.items() if name in of_frames})
    options.look, of_look = options_of(
        "ovr_picture_options",
        {name: value for name, value in given.items()
         if name not in of_frames})
    keep += of_look
    for name, value in (("movie", movie), ("folder", folder)):
        if value is not None:
            put_option(options, "ovr_frames_options", name, os.fspath(value),
                       keep)
    watch = _Watch(progress)
    options.progress, options.data = _drawn, watch.handle
    results, err = _Results(paths), new_error()
    made = ffi.new("ovr_frames_made *")
    status = lib.ovr_frames(results.array, results.count, options, ffi.NULL,
                            made, err)
    watch.teller.end()
    if watch.trouble is not None:
        raise watch.trouble
    check(status, err)
    shown = Movie(os.fspath(movie if movie is not None else folder))
    shown.drawn, shown.kept = made.drawn, made.kept
    return shown


def view(paths: Sequence[Path], path: Optional[Path],
         how: dict[str, Any]) -> Page:
    given = dict(how)
    target = _target(path, ".html", given)
    options, keep = options_of("ovr_view_options", {"path": target, **given})
    results, err = _Results(paths), new_error()
    check(lib.ovr_view(results.array, results.count, options, ffi.NULL, err),
          err)
    del keep
    return Page(target)
