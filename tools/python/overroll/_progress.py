# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a run is: a line of a terminal, a bar in a notebook."""
from __future__ import annotations

import sys
import time
from typing import Any, Callable, Optional, Union

Progress = Union[None, bool, Callable[[float], Any]]

#: Seconds between two looks.
PAUSE = 0.2


def _in_notebook() -> bool:
    shell = sys.modules.get("IPython")
    shell = shell and shell.get_ipython()
    return shell is not None and hasattr(shell, "kernel")


class _Bar:
    """HTML that is rewritten in place."""

    def __init__(self) -> None:
        from IPython.display import HTML, display
        self.html = HTML
        self.shown = display(HTML(""), display_id=True)

    def __call__(self, fraction: float, text: str) -> None:
        self.shown.update(self.html(
            f"<progress value='{fraction:.4f}'></progress> {text}"))

    def end(self) -> None:
        self.shown.update(self.html(""))


class _Line:
    """A line of standard error that is rewritten."""

    def __call__(self, fraction: float, text: str) -> None:
        sys.stderr.write(f"\r\033[K{100 * fraction:3.0f} %  {text}")
        sys.stderr.flush()

    def end(self) -> None:
        sys.stderr.write("\r\033[K")
        sys.stderr.flush()


class Teller:
    """Told often, tells a few times a second; nothing where nobody looks."""

    def __init__(self, progress: Progress) -> None:
        self.show: Optional[Any] = None
        self.call: Optional[Callable[[float], Any]] = None
        self.next = 0.0
        if callable(progress):
            self.call = progress
        elif progress is not False and _in_notebook():
            self.show = _Bar()
        elif progress or (progress is None and sys.stderr is not None
                          and sys.stderr.isatty()):
            self.show = _Line()
        self.begun = time.monotonic()

    def __bool__(self) -> bool:
        return self.show is not None or self.call is not None

    def tell(self, fraction: float, text: str = "") -> None:
        now = time.monotonic()
        if now < self.next:
            return
        self.next = now + PAUSE
        if self.call:
            self.call(fraction)
        if self.show:
            left = (now - self.begun) * (1 / fraction - 1) if fraction else 0
            self.show(fraction, f"{text}  {left:.0f} s left"
                      if fraction else text)

    def end(self) -> None:
        if self.show:
            self.show.end()
