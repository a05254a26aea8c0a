# SPDX-License-Identifier: GPL-3.0-or-later
"""What a simulation holds, as numpy and xarray see it."""
from __future__ import annotations

from operator import attrgetter
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ._library import BadInput, ffi, fields_of, lib, suggest, text
from ._tables import Quantity, extremes, fields, observables

if TYPE_CHECKING:
    import xarray


class _Memory:
    """n doubles of the library for numpy, which keeps their owner alive."""

    __slots__ = ("__array_interface__", "owner")

    def __init__(self, owner: Any, address: Any, n: int) -> None:
        self.owner = owner
        self.__array_interface__ = {
            "data": (int(ffi.cast(_ADDRESS, address)), True),
            "shape": (n,), "typestr": _FLOAT, "version": 3}


_ADDRESS = ffi.typeof("uintptr_t")
_FLOAT = np.dtype(float).str


def view(owner: Any, address: Any, n: int) -> np.ndarray:
    """A read-only array over memory that `owner` keeps."""
    return np.asarray(_Memory(owner, address, n))


def _array(name: str, doc: str) -> property:
    def get(self: "Solution") -> np.ndarray:
        state = self._state
        return view(self._core, getattr(state, name), state.n)
    return property(get, doc=doc + """

    Shape (n,), float64, dimensionless, read-only, without a copy: it shows
    the solution as it is *now* and stays valid as long as it is referred to.
    """)


def _number(name: str, doc: str) -> property:
    return property(lambda self: getattr(self._state, name), doc=doc)


class Solution:
    """Fields and numbers of a contact, now.

    All quantities of the tables are attributes by the names they have in JSON
    (`H_min`, `X_min`, `P_max`, `H_cen`, `load`, `residual`, `H_min_overall`,
    ...): dimensionless; by their SI names (`min_film_m`, `max_pressure_Pa`)
    in SI, NaN where the contact has no such scale.  `dir()` lists them.
    """

    _core: Any   # keeps the memory
    _sim: Any    # ovr_simulation *
    _setup: Any  # ovr_setup *
    _state: Any  # ovr_state *
    _seen: Any   # ovr_observation *
    _total: Any  # ovr_statistics *

    X = _array("X", "Positions x/b of the nodes.  P, H, S, q and eps of a "
                    "strip are those of the line `line` along x.")
    P = _array("P", "Pressure p/ph.")
    H = _array("H", "Film thickness h R/b^2.")
    S = _array("S", "Height of both surfaces' features, in b^2/R, positive "
                    "out of the surface.")
    q = _array("q", "rho H, the mass in the film.")
    eps = _array("eps", "rho H^3/(eta lambda), the flow coefficient.")
    weights = _array("weights", "Weights of an integral: (weights * f).sum().")
    T = _number("T", "Time t um/b.")
    step_count = _number("step", "Steps since the steady start.")
    n = _number("n", "Number of nodes along x.")
    lines = _number("lines", "Number of lines across rolling, of a line "
                             "contact 1.")
    line = _number("line", "The line of a strip that arrays along x show, "
                           "from 0.")
    D = _number("D", "Mesh size, the smallest, in b.")
    H0 = _number("H0", "Rigid approach, in b^2/R.")

    def _attach(self, core: Any, sim: Any, setup: Any) -> None:
        """Shows a simulation whose memory `core` keeps."""
        self._core, self._sim, self._setup = core, sim, setup
        self._state = lib.ovr_simulation_state(sim)
        self._seen = lib.ovr_simulation_observation(sim)
        self._total = lib.ovr_simulation_statistics(sim)

    def __getattr__(self, name: str) -> Any:
        meant = None if name.startswith("_") else suggest(name, dir(self))
        hint = f"; did you mean '{meant}'?" if meant else ""
        raise AttributeError(f"'{type(self).__name__}' has no '{name}'{hint}")

    def _scale(self, kind: int) -> float:
        return lib.ovr_kind_scale(kind, self._setup.contact)

    def field(self, name: str) -> np.ndarray:
        """A field by its name in result files ("viscosity", "mass_flow",
        ...): a new array, float64, shape (n,), or (n - 1,) at half nodes,
        dimensionless.

        Raises BadInput where there is none of that name.
        """
        row = fields().get(name)
        if row is None:
            meant = suggest(name, list(fields()))
            raise BadInput(f"no field '{name}'; there are "
                           f"{', '.join(fields())}", key=name,
                           suggestion=meant)
        room = np.empty(self.n)
        values = row.field(self._sim, ffi.cast("double *", room.ctypes.data))
        if values == ffi.NULL:
            return np.full(self.n, np.nan)
        n = self.n - (row.axes == lib.OVR_AT_HALVES)
        return view(self._core, values, n).copy() \
            if int(ffi.cast(_ADDRESS, values)) != room.ctypes.data \
            else room[:n]

    @property
    def Y(self) -> np.ndarray:
        """Positions y/b of the lines of a strip, shape (lines,), without a
        copy; [0.] of a line contact."""
        if self._state.Y == ffi.NULL:
            return np.zeros(1)
        return view(self._core, self._state.Y, self.lines)

    def show(self, Y: Optional[float] = None) -> Any:
        """Makes P, H, S, q, eps and fields of a strip those of the line
        nearest to Y (periodic, in b), or of `strip.shown`, until the next
        step.  Returns the solution."""
        line = self.lines
        if Y is not None and self.lines > 1:
            width = self.lines * (self.Y[1] - self.Y[0])
            apart = np.abs(np.remainder(self.Y - Y + width / 2, width)
                           - width / 2)
            line = int(apart.argmin())
        lib.ovr_simulation_show(self._sim, line)
        return self

    def areal(self, name: str) -> np.ndarray:
        """A field of all lines of a strip by its name in result files: a new
        array, float64, shape (lines, n), dimensionless.

        >>> p = overroll.Simulation("strip.ini").steady().areal("pressure")
        """
        line, rows = self.line, []
        try:
            for k in range(self.lines):
                lib.ovr_simulation_show(self._sim, k)
                rows.append(self._at_nodes(name))
        finally:
            lib.ovr_simulation_show(self._sim, line)
        return np.array(rows)

    def _at_nodes(self, name: str) -> np.ndarray:
        values = self.field(name)
        if len(values) < self.n:  # at the half nodes: as files have them
            ends = np.pad(values, 1, mode="edge")
            values = 0.5 * (ends[:-1] + ends[1:])
        return values

    @property
    def contact(self) -> SimpleNamespace:
        """The contact: M, L, lambda, alphabar, and in SI ph, b, height
        (b^2/R), time (b/um), load, radius, ..., NaN where not known."""
        return SimpleNamespace(**fields_of(self._setup.contact))

    @property
    def options(self) -> SimpleNamespace:
        """What the solver chose: inlet, outlet, level, order, ..."""
        how = lib.ovr_simulation_options(self._sim)
        found = fields_of(how)
        found["scheme"] = text(lib.ovr_scheme_name(how.scheme))
        return SimpleNamespace(**found)

    def numbers(self) -> dict[str, Any]:
        """All numbers by their JSON keys; in SI too where the contact has
        scales."""
        return {name: getattr(self, name)
                for name, (quantity, scaled) in _QUANTITIES.items()
                if not scaled or np.isfinite(self._scale(quantity.kind))}

    # ------------------------------------------------------------ xarray

    @property
    def physical(self) -> bool:
        """Whether the contact has scales, so that SI values are known."""
        c = self._setup.contact
        return bool(np.isfinite(c.b * c.ph * c.height))

    def _data(self, name: str) -> "xarray.DataArray":
        from ._xarray import xarray
        row = fields()[name]
        strip = self.lines > 1
        values = self.areal(name) if strip else self._at_nodes(name)
        value, about = self._scaled(values, row.kind, text(row.long_name))
        places = {"y": self.Y, "x": self.X} if strip else {"x": self.X}
        coords = {axis: (axis, *self._scaled(at, lib.OVR_KIND_LENGTH, axis))
                  for axis, at in places.items()}
        return xarray.DataArray(value, dims=tuple(places), coords=coords,
                                name=name, attrs=about)

    def _scaled(self, values: np.ndarray, kind: int,
                long_name: str) -> tuple[np.ndarray, dict[str, Any]]:
        about = lib.ovr_kind_about(kind)
        scale = self._scale(kind)
        if self.physical and np.isfinite(scale):
            return values * scale, {"units": text(about.si) or "1",
                                    "long_name": long_name}
        attrs = {"units": "1", "long_name": long_name}
        if np.isfinite(scale):
            attrs["scale"] = scale
        return np.array(values), attrs

    @property
    def pressure(self) -> "xarray.DataArray":
        """Pressure along x, of a strip (y, x), with its units: Pa and m where
        the contact is physical, else ph and b ("1").  A copy."""
        return self._data("pressure")

    @property
    def thickness(self) -> "xarray.DataArray":
        """Film thickness along x with its units; a copy."""
        return self._data("film_thickness")

    @property
    def roughness(self) -> "xarray.DataArray":
        """Heights of the surfaces' features with their units; a copy."""
        return self._data("roughness")

    def dataset(self, *names: str) -> "xarray.Dataset":
        """The named fields (all, unless named) and all numbers, as
        attributes, of this moment: a copy.  Fields at half nodes are means at
        the nodes, as in result files."""
        from ._xarray import xarray
        return xarray.Dataset(
            {name: self._data(name) for name in names or fields()},
            attrs={"time": self.T, **self.numbers()})


#: Name: quantity, and whether that name is of its value in SI.
_QUANTITIES: dict[str, tuple[Quantity, bool]] = {}


def _in_si(plain: Any, kind: int) -> Any:
    return lambda self: plain(self) * self._scale(kind)


def _show(quantity: Quantity) -> None:
    """Makes a quantity an attribute of all solutions."""
    of = attrgetter("_total" if quantity.total else "_seen")

    def plain(self: Solution) -> Any:
        return quantity.value(of(self))

    if quantity.key in _QUANTITIES:  # what is of the run comes first
        return
    doc = f"{quantity.long_name} (dimensionless)"
    _QUANTITIES[quantity.key] = quantity, False
    if not hasattr(Solution, quantity.key):
        setattr(Solution, quantity.key, property(plain, doc=doc))
    if quantity.key_si:
        _QUANTITIES[quantity.key_si] = quantity, True
        setattr(Solution, quantity.key_si,
                property(_in_si(plain, quantity.kind),
                         doc=f"{quantity.long_name} in SI"))


for _table in (extremes(), observables()):
    for _quantity in _table.values():
        _show(_quantity)
