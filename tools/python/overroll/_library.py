# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared library, and its errors as exceptions."""
from __future__ import annotations

import re
from keyword import iskeyword
from pathlib import Path
from typing import Any, Iterator, Optional

from ._interface import ffi

lib = ffi.dlopen(str(Path(__file__).with_name("liboverroll.so")))

#: What stands in messages in place of a file for what Python code gave.
ORIGIN = "argument"


class OverrollError(Exception):
    """What the library refuses or cannot do.

    Attributes
    ----------
    message : str
        One line: where, what is wrong, what would be right.
    status : str
        "bad input", "not converged", ...
    file, line : str or None, int or None
        The text file that is wrong, and where.
    key : str or None
        The key of the case, or the argument, that is wrong or missing.
    suggestion : str or None
        What was probably meant.
    """

    status = "failed"

    def __init__(self, message: str, *, file: Optional[str] = None,
                 line: Optional[int] = None, key: Optional[str] = None,
                 suggestion: Optional[str] = None) -> None:
        super().__init__(message)
        self.message = message
        self.file = file
        self.line = line
        self.key = key
        self.suggestion = suggestion

    def __str__(self) -> str:
        return self.message


class BadInput(OverrollError, ValueError):
    """A case, file or argument is wrong or missing."""


class NotConverged(OverrollError, ArithmeticError):
    """A solve or step did not reach its tolerance."""


class Impossible(OverrollError, ArithmeticError):
    """The physics asked for has no solution here."""


class NoMemory(OverrollError, MemoryError):
    """An allocation failed."""


class InputOutput(OverrollError, OSError):
    """Reading or writing failed on the way."""


class Stopped(OverrollError):
    """A run ended early because it was asked to."""


class OverrollWarning(UserWarning):
    """A result may not be what was meant."""


_CLASSES = {lib.OVR_BAD_INPUT: BadInput, lib.OVR_NOT_CONVERGED: NotConverged,
            lib.OVR_IMPOSSIBLE: Impossible, lib.OVR_NO_MEMORY: NoMemory,
            lib.OVR_IO: InputOutput, lib.OVR_STOPPED: Stopped}
for _status, _class in _CLASSES.items():
    _class.status = ffi.string(lib.ovr_status_name(_status)).decode()


def text(pointer: Any) -> Optional[str]:
    """A C string; None for NULL."""
    if pointer == ffi.NULL:
        return None
    return ffi.string(pointer).decode("utf-8", "surrogateescape")


def encoded(value: Any) -> bytes:
    """A text or path for the library."""
    found = str(value).encode("utf-8", "surrogateescape")
    if b"\0" in found:
        raise BadInput(f"{str(value)!r:.80}: a text or a name has no "
                       "character NUL")
    return found


def new_error() -> Any:
    return ffi.new("ovr_error *")


def error_of(err: Any, status: Optional[int] = None) -> OverrollError:
    """The exception that an `ovr_error` is."""
    raw = ffi.string(err.message)
    message = raw.decode("utf-8", "replace").replace("--force", "force=True")
    origin = raw[:err.file].decode("utf-8", "surrogateescape") or None
    key = text(err.about)
    if key is None:
        unknown = re.search(r"unknown key '([^']*)'", message)
        key = unknown.group(1) if unknown else None
    kind = _CLASSES.get(err.status if status is None else status,
                        OverrollError)
    return kind(message or "failed", file=None if origin == ORIGIN else origin,
                line=err.line or None, key=key, suggestion=text(err.meant))


def check(status: int, err: Any) -> None:
    """Raises what a call that returned `status` has to say."""
    if status:
        raise error_of(err, status)


def rows(at: Any, *arguments: Any) -> Iterator[Any]:
    """The rows of one of the library's tables, which end with NULL."""
    k = 0
    while True:
        row = at(*arguments, k)
        if row == ffi.NULL:
            return
        yield row
        k += 1


def suggest(wrong: str, names: list[str]) -> Optional[str]:
    """The name that was probably meant."""
    keep = [ffi.new("char[]", encoded(name)) for name in names]
    return text(lib.ovr_suggest(encoded(wrong), ffi.new("char *[]", keep),
                                len(keep)))


def options_of(kind: str, given: dict[str, Any]) -> tuple[Any, list[Any]]:
    """A struct of options with its defaults and what is given by name, and
    what must live as long.

    A text becomes a `char *`, the end of an enumerator's name its value, a
    list of numbers a pointer with its count before it.
    """
    how = ffi.new(kind + " *")
    if hasattr(lib, kind + "_default"):  # the others' defaults are zero
        how[0] = getattr(lib, kind + "_default")()
    keep: list[Any] = [how]
    for name, value in given.items():
        put_option(how, kind, name, value, keep)
    return how, keep


def put_option(how: Any, kind: str, name: str, value: Any,
               keep: list[Any]) -> None:
    fields = dict(ffi.typeof(kind).fields)
    if name not in fields or fields[name].type.kind == "function":
        raise BadInput(f"unknown option '{name}'", key=name,
                       suggestion=suggest(name, list(fields)))
    member = fields[name].type
    if member.kind == "enum":
        value = enumerator(member, value)
    elif member.cname in ("char *", "char const *"):
        value = ffi.new("char[]", encoded(value))
        keep.append(value)
    elif member.kind == "pointer" and member.item.cname.startswith("double"):
        value = [float(v) for v in value]
        setattr(how, name.rstrip("s") + "_count", len(value))
        value = ffi.new("double[]", value)
        keep.append(value)
    setattr(how, name, value)


def enumerator(kind: Any, word: Any) -> int:
    """The value whose name ends in `word`: "map" for OVR_PICTURE_MAP."""
    if not isinstance(word, str):
        return int(word)
    ending = "_" + word.upper().replace("-", "_")
    for value, name in kind.elements.items():
        if name.endswith(ending):
            return value
    words = [name.rsplit("_", 1)[1].lower() for name in kind.elements.values()]
    raise BadInput(f"unknown '{word}'; there are {', '.join(words)}",
                   suggestion=suggest(word, words))


def fields_of(struct: Any) -> dict[str, Any]:
    """The numbers of a struct by name, `lambda_` for what Python calls
    otherwise."""
    return {name + "_" * iskeyword(name): getattr(struct, name)
            for name, field in ffi.typeof(struct[0]).fields
            if field.type.kind == "primitive"}
