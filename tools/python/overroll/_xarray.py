# SPDX-License-Identifier: GPL-3.0-or-later
"""Result files as xarray Datasets, and what these can do.

xarray imports this module by itself (as a backend), so that `ds.overroll` is
there for files that it opened without us.
"""
from __future__ import annotations

import builtins
import os
import time
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
import xarray
from xarray.backends import BackendEntrypoint

from ._library import BadInput, InputOutput

if TYPE_CHECKING:
    from ._pictures import Movie, Page, Picture

Path = Union[str, "os.PathLike[str]"]

#: Attempts at a file that is just being written, and seconds between them.
ATTEMPTS, PAUSE = 10, 0.1


#: What HDF5 and netCDF keep for themselves.
_INTERNAL = {"CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST",
             "_FillValue", "_Netcdf4Dimid", "_Netcdf4Coordinates",
             "_NCProperties", "_nc3_strict"}


def _attributes(thing: Any) -> dict[str, Any]:
    def plain(value: Any) -> Any:
        if isinstance(value, bytes):
            return value.decode("utf-8", "replace")
        if isinstance(value, np.ndarray) and value.size == 1:
            return value.ravel()[0]
        return value
    return {name: plain(value) for name, value in thing.attrs.items()
            if name not in _INTERNAL}


def _variable(v: Any, name: str, path: str) -> xarray.Variable:
    if v.attrs.get("CLASS") == b"DIMENSION_SCALE":
        dims = [name]
    else:
        dims = [dim[0].name.rsplit("/", 1)[1] for dim in v.dims]
    values = v[()] if v.dtype.kind != "O" else v.asstr()[()]
    return xarray.Variable(dims, values, _attributes(v), {"source": path})


def _group(path: str, group: Optional[str]) -> xarray.Dataset:
    """As xarray.open_dataset(path, group=group, decode_times=False).load():
    its netCDF readers take a second for a history that still grows."""
    import h5py
    with h5py.File(path, "r") as file:
        at = file[group] if group else file
        if not isinstance(at, h5py.Group):
            raise BadInput(f"{path}: '{group}' is a variable, not a group",
                           file=path, key="group")
        names = [name for name, v in at.items()
                 if isinstance(v, h5py.Dataset) and v.dtype.kind in "fiubO"]
        found = {name: _variable(at[name], name, path) for name in names}
        ds = xarray.Dataset(found, attrs=_attributes(at))
    ds.encoding["source"] = path
    return ds


def _lazily(path: str, group: Optional[str]) -> xarray.Dataset:
    return xarray.open_dataset(path, group=group, decode_times=False)


def _complete(ds: xarray.Dataset) -> xarray.Dataset:
    """Without the rows that are being written: their time is NaN."""
    if "time" not in ds or not ds["time"].dims:
        return ds
    unfinished = np.isnan(ds["time"].values)
    if not unfinished.any():
        return ds
    return ds.isel({ds["time"].dims[0]: slice(int(unfinished.argmax()))})


def _foreign(path: str) -> bool:
    """A file that is no HDF5 file, not even one just begun."""
    if not os.path.isfile(path):
        return False
    with builtins.open(path, "rb") as file:
        head = file.read(8)
    return head != b"" and head != b"\x89HDF\r\n\x1a\n"


def _read(path: str, group: Optional[str], load: bool) -> xarray.Dataset:
    for attempt in range(ATTEMPTS):
        try:
            return _complete((_group if load else _lazily)(path, group))
        except BadInput:
            raise
        except (OSError, RuntimeError, ValueError, KeyError) as error:
            # the writer was met half-way
            if not os.path.exists(path):
                raise
            if attempt == ATTEMPTS - 1 or _foreign(path):
                if isinstance(error, KeyError):
                    raise BadInput(f"{path}: has no group '{group}'",
                                   file=path, key="group") from error
                raise InputOutput(f"{path}: cannot be read as a result: "
                                  f"{error}", file=path) from error
            time.sleep(PAUSE)
    raise AssertionError


def open(path: Path, *, group: Optional[str] = None, units: str = "stored",
         load: bool = True) -> xarray.Dataset:
    """A result file as an xarray Dataset, also while it grows: its complete
    rows.

    >>> ds = overroll.open("dent.h5")
    >>> ds.film_thickness.sel(x=0, method="nearest")
    >>> ds.overroll.history.min_film_thickness.min()

    Parameters
    ----------
    path : path
    group : str, optional
        "history", "stress/surface_1", ...; without one the snapshots: fields
        of shape (time, x).
    units : "stored", "hertzian" or "si"
        As in the file, with the scales of the contact applied or taken out:
        stored is SI ("Pa", "m", "s") where the contact is physical, else
        Hertzian ("1": ph, b, b^2/R, b/um).
    load : bool
        Read all and close the file; else lazily.

    Raises
    ------
    FileNotFoundError
        There is no such file.
    InputOutput
        It is damaged or no result; an OSError, too.
    BadInput
        `group` is not one of its groups.
    ValueError
        `units` is "si" and the file does not know the scales.
    """
    ds = _read(os.fspath(path), group, load)
    return ds if units == "stored" else convert(ds, units)


def _convert_one(name: str, v: Any, units: str) -> Any:
    scale, unit = v.attrs.get("scale"), v.attrs.get("units", "1")
    is_si = unit != "1"
    if "scale" not in v.attrs or is_si == (units == "si"):
        return v
    if not np.isfinite(scale):
        raise ValueError(f"{name}: the file does not know its scale: only a "
                         "physical contact has SI units")
    factor = scale if units == "si" else 1 / scale
    attrs = dict(v.attrs)
    attrs["units"] = _si_unit(v) if units == "si" else "1"
    return v.copy(data=v.data * v.dtype.type(factor)).assign_attrs(attrs) \
        if hasattr(v, "assign_attrs") else v


def _si_unit(v: Any) -> str:
    from ._library import ffi, lib, text
    kind = lib.ovr_kind_named(ffi.new("char[]", str(
        v.attrs.get("kind", "")).encode()))
    about = lib.ovr_kind_about(kind)
    return text(about.si) if about != ffi.NULL else "1"


def convert(ds: xarray.Dataset, units: str) -> xarray.Dataset:
    """The same in Hertzian ("hertzian") or SI ("si") units."""
    if units not in ("hertzian", "si"):
        raise ValueError(f"units: '{units}' must be stored, hertzian or si")
    made = {name: _convert_one(str(name), ds[name], units)
            for name in ds.variables}
    coords = {name: made.pop(name) for name in list(ds.coords)}
    out = xarray.Dataset({name: v.variable for name, v in made.items()},
                         {name: v.variable for name, v in coords.items()},
                         ds.attrs)
    out.encoding = ds.encoding
    return out


def source_of(ds: xarray.Dataset) -> str:
    """The file that a Dataset came from."""
    for holder in (ds, *ds.variables.values()):
        path = holder.encoding.get("source")
        if path:
            return str(path)
    raise ValueError("this Dataset does not know the result file that it came "
                     "from: use one of overroll.open or overroll.run")


class Accessor:
    """`ds.overroll`: what a result file holds besides its snapshots, and its
    pictures, drawn from the file."""

    def __init__(self, ds: xarray.Dataset) -> None:
        self._ds = ds

    @property
    def path(self) -> str:
        """The result file."""
        return source_of(self._ds)

    def again(self) -> xarray.Dataset:
        """The file opened once more: what has been written since."""
        return open(self.path)

    def group(self, name: str, units: str = "stored") -> xarray.Dataset:
        """A group of the file: "history", "stress/surface_1", ..."""
        return open(self.path, group=name, units=units)

    @property
    def history(self) -> xarray.Dataset:
        """One value each step: `min_film_thickness`, `max_pressure`, ... of
        shape (step,), with units."""
        return self.group("history")

    @property
    def case(self) -> dict[str, Any]:
        """Every parameter by "section.key", and the case file as "text"."""
        return dict(self.group("case").attrs)

    @property
    def status(self) -> str:
        """running, complete, stopped or failed, as it was when read."""
        return str(self._ds.attrs.get("status", ""))

    def convert(self, units: str) -> xarray.Dataset:
        """The same in Hertzian ("hertzian") or SI ("si") units."""
        return convert(self._ds, units)

    def plot(self, kind: str = "snapshot", path: Optional[Path] = None,
             **look: Any) -> "Picture":
        """A picture of the file, as `overroll plot` draws it; shown by a
        notebook.

        Parameters
        ----------
        kind : "snapshot", "history", "map", "trace", "stress", "risk", "depth",
            "element", "plastic", "areal" (maps of a strip)
        path : path, optional
            Where to keep it: .png, .svg or .pdf.
        **look
            Members of `ovr_picture_options`: `times` (b/um), `x_from`, `x_to`
            (b), `P_to`, `H_to`, `field`, `units`, `width`, `height`, `title`,
            `overlay`, ...

        Raises
        ------
        BadInput, InputOutput
            Such as without gnuplot.
        """
        from ._pictures import plot
        return plot([self.path], kind, path, look)

    def frames(self, movie: Optional[Path] = None,
               folder: Optional[Path] = None, *, progress: Any = None,
               **how: Any) -> "Movie":
        """A movie (.mp4, .webm, .gif, .webp) of the file, or a picture for
        each snapshot in `folder`, as `overroll frames` draws them; shown by a
        notebook.

        `how`: members of `ovr_frames_options` and of `ovr_picture_options`
        (`every`, `rate`, `workers`, `T_from`, `T_to`, `P_to`, ...).
        """
        from ._pictures import frames
        return frames([self.path], movie, folder, progress, how)

    def view(self, path: Optional[Path] = None, **how: Any) -> "Page":
        """One page of HTML that plays the run; shown by a notebook."""
        from ._pictures import view
        return view([self.path], path, how)


if not hasattr(xarray.Dataset, "overroll"):
    xarray.register_dataset_accessor("overroll")(Accessor)


class Backend(BackendEntrypoint):
    """xarray.open_dataset(path, engine="overroll")."""

    description = "Result files of overroll, also while they grow"

    def open_dataset(self, filename_or_obj: Any, *,
                     drop_variables: Any = None, group: Optional[str] = None,
                     units: str = "stored") -> xarray.Dataset:
        ds = open(filename_or_obj, group=group, units=units)
        return ds.drop_vars(drop_variables or [])

    def guess_can_open(self, filename_or_obj: Any) -> bool:
        return False


Backend.open_dataset_parameters = ("filename_or_obj", "drop_variables",
                                   "group", "units")
