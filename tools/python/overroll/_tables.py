# SPDX-License-Identifier: GPL-3.0-or-later
"""What the library's tables list: keys of a case, quantities of a solution."""
from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import count
from operator import attrgetter
from typing import Any, Optional

from ._library import BadInput, ORIGIN, ffi, lib, rows, suggest, text


@dataclass(frozen=True)
class Parameter:
    """One key of a case.

    `least` and `most` bound a number, in SI or, where `bare` names a Hertzian
    unit, in that; NaN: it is no number.
    """

    section: str
    key: str
    type: str
    units: str
    bare: str
    initial: Optional[str]
    least: float
    most: float
    choices: tuple[str, ...]
    help: str
    named: bool

    def __str__(self) -> str:
        words = [f"{self.section}.{self.key}: {self.help} [{self.type}"]
        if self.units or self.bare:
            units = ", ".join(u for u in (self.units, self.bare) if u)
            words.append(f"; {units}")
        if self.choices:
            words.append("; " + ", ".join(self.choices))
        if self.initial is not None:
            words.append(f"; default {self.initial}")
        return "".join(words) + "]"


@lru_cache(maxsize=None)
def parameters() -> tuple[Parameter, ...]:
    """All keys that a case may have, in the order of overroll-case(5)."""
    named = {text(name): lib.ovr_section_named(k)
             for k, name in enumerate(rows(lib.ovr_section_name))}
    table = []
    for k in range(lib.ovr_parameter_count()):
        p = lib.ovr_parameter_at(k)
        choices = [text(c) for c in p.choices if c != ffi.NULL]
        table.append(Parameter(
            text(p.section), text(p.key), text(p.type), text(p.units),
            text(p.bare), text(p.initial), p.minimum, p.maximum, tuple(choices),
            text(p.help), named[text(p.section)]))
    return tuple(table)


@lru_cache(maxsize=None)
def _places() -> dict[str, tuple[str, ...]]:
    """Where a bare key, or section_key, may stand."""
    places: dict[str, tuple[str, ...]] = {}
    for p in parameters():
        if not p.named:
            where = f"{p.section}.{p.key}"
            places[p.key] = places.get(p.key, ()) + (where,)
            places[f"{p.section}_{p.key}"] = (where,)
    return places


@lru_cache(maxsize=None)
def _named() -> tuple[Parameter, ...]:
    return tuple(p for p in parameters() if p.named)


def _of_a_name(word: str) -> Optional[str]:
    """feature_dent_depth: the longest key that it ends with."""
    fits = [p for p in _named() if word.startswith(p.section + "_")
            and word.endswith("_" + p.key)
            and len(word) > len(p.section) + len(p.key) + 2]
    if not fits:
        return None
    p = max(fits, key=lambda p: len(p.key))
    return f"{p.section} {word[len(p.section) + 1:-len(p.key) - 1]}.{p.key}"


def _meant_of_a_name(word: str) -> Optional[str]:
    """feature_dent_depth for feature_dent_detph."""
    for section in dict.fromkeys(p.section for p in _named()):
        keys = [p.key for p in _named() if p.section == section]
        parts = word.split("_")
        for k in range(2, len(parts) if parts[0] == section else 0):
            meant = suggest("_".join(parts[k:]), keys)
            if meant:
                return "_".join([*parts[:k], meant])
    return None


@lru_cache(maxsize=4096)
def place(word: str) -> str:
    """The "section.key" that a name in Python means.

    "section.key" itself; the key alone where it is in one section only, or in
    [contact]; "section_key"; "feature_NAME_key" and "body_1_key".
    """
    if "." in word:
        return word
    found = _places().get(word, ())
    if len(found) > 1:
        found = tuple(w for w in found if w.startswith("contact.")) or found
    if len(found) == 1:
        return found[0]
    if found:
        names = " or ".join(w.replace(".", "_") for w in found)
        raise BadInput(f"{ORIGIN}: '{word}' stands in several sections: say "
                       f"{names}", key=word)
    named = _of_a_name(word)
    if named:
        return named
    meant = suggest(word, list(_places())) or _meant_of_a_name(word)
    hint = f"; did you mean '{meant}'?" if meant else \
        "; overroll.help() lists them"
    raise BadInput(f"{ORIGIN}: unknown key '{word}'{hint}", key=word,
                   suggestion=meant)


def help(word: Optional[str] = None) -> None:
    """Prints what a case may say: all of it, or what belongs to a word (a
    key, a section, or a part of the description).

    >>> overroll.help("radius")
    """
    said = [p for p in parameters()
            if not word or word in (p.key, p.section)] or \
        [p for p in parameters() if word in str(p)]
    if not said:
        place(word or "")
    for p in said:
        print(p)


class Quantity:
    """A number of a solution: its key and kind, and how its value is had of
    the struct that it is in."""

    __slots__ = ("key", "key_si", "long_name", "row", "kind", "total", "value")

    def __init__(self, row: Any, total: bool) -> None:
        self.row, self.total = row, total
        self.key = text(row.key) or (None if total else text(row.name))
        self.key_si = text(row.key_si) or None
        self.long_name = text(row.long_name)
        self.kind = row.kind
        self.value = partial(lib.ovr_extreme_value, row) if total else \
            self._member()

    def _member(self) -> Any:
        """Whole numbers and flags stay what they are."""
        for name, at in ffi.typeof("ovr_observation").fields:
            if at.offset == self.row.offset:
                return attrgetter(name)
        return partial(lib.ovr_observable_value, self.row)


@lru_cache(maxsize=None)
def observables() -> dict[str, Quantity]:
    """Numbers of a solution as it is now, by their JSON key, or else their
    name in result files."""
    found = (Quantity(row, False)
             for row in rows(lib.ovr_observable_at)
             if row.axes == lib.OVR_AT_STEPS)
    return {q.key: q for q in found if q.key}


@lru_cache(maxsize=None)
def extremes() -> dict[str, Quantity]:
    """Extremes and means since the steady start, by their JSON key."""
    found = {}
    for k in count():
        row = ffi.new("ovr_extreme *")
        if not lib.ovr_extreme_at(k, row):
            return found
        quantity = Quantity(row, True)
        found[quantity.key] = quantity


@lru_cache(maxsize=None)
def fields() -> dict[str, Any]:
    """What is known along x, by its name in result files."""
    along_x = lib.OVR_AT_NODES, lib.OVR_AT_HALVES
    return {text(row.name): row for row in rows(lib.ovr_observable_at)
            if row.field != ffi.NULL and row.axes in along_x}
