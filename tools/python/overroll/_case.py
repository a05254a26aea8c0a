# SPDX-License-Identifier: GPL-3.0-or-later
"""A case: what is to be computed."""
from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING, Any, Iterator, Optional, Union

import numpy as np

from ._library import ORIGIN, check, encoded, error_of, ffi, lib
from ._library import new_error, text
from ._tables import place

if TYPE_CHECKING:
    import xarray
    from ._simulation import Film, Simulation

Path = Union[str, "os.PathLike[str]"]


def value_text(value: Any) -> str:
    """A value as a case file has it: numbers so that they come back the
    same, yes and no, lists with commas."""
    if isinstance(value, str):
        return value
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return ", ".join(value_text(item) for item in value)


def _owned(c: Any, err: Any) -> Any:
    if c == ffi.NULL:
        raise error_of(err)
    return ffi.gc(c, lib.ovr_case_free)


class Case:
    """What is to be computed, as overroll-case(5) describes it.

    >>> c = Case(M=20, L=10, level=8)
    >>> c = Case("dent.ini", end=6)
    >>> c = Case(load="300 kN/m", radius="8 mm", modulus="226 GPa",
    ...          viscosity="58.5 mPa.s", alpha="23.5 1/GPa", mean_speed="3 m/s")
    >>> c.feature("dent", depth="1 um", width="40 um", start=-4)
    >>> c["time.end"] = 6

    Parameters
    ----------
    path : str or path, optional
        A case file; without one nothing is given yet.
    **keys
        Keys of the case: numbers (Hertzian: lengths in b, heights in b^2/R,
        times in b/um), texts with a unit, True and False, lists; None takes a
        key back to its default.  A name is the key itself where it stands in
        one section only or in [contact]; else section_key (`output_every`,
        `feature_dent_depth`, `body_1_material`) or, with `**{...}`,
        "section.key".  `overroll.help()` lists all.

    Raises
    ------
    BadInput
        A key or value that is not understood, with `file`, `line`, `key`,
        `suggestion`.  What contradicts or is missing is said when the case is
        run, or by `check()`.
    """

    def __init__(self, path: Optional[Path] = None, **keys: Any) -> None:
        err = new_error()
        self._c = _owned(
            lib.ovr_case_create(ffi.NULL, err) if path is None
            else lib.ovr_case_read(encoded(path), ffi.NULL, err), err)
        self._shared = False
        self._lock = threading.Lock()
        if keys:
            self.set(**keys)

    @classmethod
    def from_text(cls, source: str, name: str = "text",
                  directory: Optional[Path] = None) -> "Case":
        """A case from the text of a case file; `name` stands in messages,
        relative paths start at `directory`."""
        case = cls.__new__(cls)
        err = new_error()
        where = ffi.NULL if directory is None else encoded(directory)
        case._c = _owned(lib.ovr_case_read_text(
            encoded(source), encoded(name),
            where if directory is None else ffi.new("char[]", where),
            ffi.NULL, err), err)
        case._shared = False
        case._lock = threading.Lock()
        return case

    # ----------------------------------------------------------- settings

    def set(self, **keys: Any) -> "Case":
        """Sets keys, as the constructor does; returns the case."""
        for word, value in keys.items():
            self[word] = value
        return self

    def feature(self, name: str, shape: Optional[str] = None,
                **keys: Any) -> "Case":
        """Puts a feature on a surface, or changes the one of that name.

        `shape` ("dent", "bump", "wave", "profile", "roughness", ...) is the
        feature's name unless given; the other keys are those of [feature] in
        overroll-case(5).  Returns the case.
        """
        where = f"feature {name}"
        if shape is not None or self.get(where + ".shape") is None:
            self[where + ".shape"] = shape or name
        for key, value in keys.items():
            self[f"{where}.{key}"] = value
        return self

    def __setitem__(self, word: str, value: Any) -> None:
        where = place(word)
        if value is None:
            del self[word]
            return
        self._own()
        err = new_error()
        check(lib.ovr_case_set(self._c, encoded(where),
                               encoded(value_text(value)), ORIGIN.encode(),
                               err), err)

    def __delitem__(self, word: str) -> None:
        where = place(word)
        self._own()
        lib.ovr_case_unset(self._c, encoded(where))

    def get(self, word: str, default: Optional[str] = None) -> Optional[str]:
        """The text of a key, as given or its default; else `default`."""
        where = place(word).replace(" ", ".")
        for name, entry in self._entries():
            if name.replace(" ", ".") == where:
                return default if entry.text == ffi.NULL else text(entry.text)
        return default

    def __getitem__(self, word: str) -> str:
        found = self.get(word)
        if found is None:
            raise KeyError(word)
        return found

    def _entries(self) -> Iterator[tuple[str, Any]]:
        for k in range(lib.ovr_case_entries(self._c)):
            entry = lib.ovr_case_entry_at(self._c, k)
            section = text(entry.section)
            if entry.name != ffi.NULL:
                section = f"{section} {text(entry.name)}"
            yield f"{section}.{text(entry.key)}", entry

    def __contains__(self, word: str) -> bool:
        """Whether a key was given, by any of its names."""
        return place(word).replace(" ", ".") in {
            name.replace(" ", ".") for name in self.given()}

    def __iter__(self) -> Iterator[str]:
        """What was given: "section.key"."""
        return iter(self.given())

    def given(self) -> dict[str, str]:
        """What was given, "section.key" and its text, without defaults."""
        return {name: text(entry.text) for name, entry in self._entries()
                if entry.given}

    @property
    def text(self) -> str:
        """The case as the text of a case file."""
        err = new_error()
        with self._lock:  # the case keeps the text
            found = lib.ovr_case_text(self._c, err)
            if found == ffi.NULL:
                raise error_of(err)
            return text(found)

    @property
    def name(self) -> Optional[str]:
        """The file it was read from."""
        return text(lib.ovr_case_name(self._c))

    @property
    def directory(self) -> Optional[str]:
        """Where its relative paths start."""
        return text(lib.ovr_case_directory(self._c))

    def save(self, path: Path) -> None:
        """Writes the case file."""
        with open(path, "w", encoding="utf-8",
                  errors="surrogateescape") as file:
            file.write(self.text)

    def copy(self) -> "Case":
        """A case of its own that says the same."""
        return Case.from_text(self.text, self.name or "text", self.directory)

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> "Case":
        return self.copy()

    def __reduce__(self) -> Any:
        return Case.from_text, (self.text, self.name or "text",
                                self.directory)

    def __repr__(self) -> str:
        keys = ", ".join(f"{k}={v}" for k, v in self.given().items())
        return f"<overroll.Case {keys}>"

    def _own(self) -> None:
        """Before a change: what runs keeps the case that it began with."""
        if self._shared:
            self._c = self.copy()._c
            self._shared = False

    def _share(self) -> Any:
        self._shared = True
        return self._c

    # ------------------------------------------------------------ running

    def resolved(self) -> None:
        """Raises BadInput, with its place, for what is contradictory or
        missing; no grid is made."""
        err = new_error()
        setup = lib.ovr_case_resolve(self._c, ffi.NULL, err)
        if setup == ffi.NULL:
            raise error_of(err)
        lib.ovr_setup_free(setup)

    def check(self) -> "Simulation":
        """The case resolved, its files read and its grid allocated, nothing
        solved: raises BadInput for what is wrong."""
        return self.simulation()

    def simulation(self) -> "Simulation":
        """A simulation of it: `overroll.Simulation(self)`."""
        from ._simulation import Simulation
        return Simulation(self)

    def steady(self, **keys: Any) -> "Film":
        """`overroll.steady(self, **keys)`."""
        from ._simulation import steady
        return steady(self, **keys)

    def run(self, output: Optional[Path] = None, **how: Any) \
            -> "xarray.Dataset":
        """`overroll.run(self, output, **how)`."""
        from ._run import run
        return run(self, output, **how)


def case_of(source: Union[None, Path, Case], keys: dict[str, Any]) -> Case:
    """The case that a function was given: one, a path, keys, or both."""
    if isinstance(source, Case):
        return source.copy().set(**keys) if keys else source
    return Case(source, **keys)
