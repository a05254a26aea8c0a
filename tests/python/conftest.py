# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixtures and reference values shared by the tests of the Python package."""
import os
import re
from pathlib import Path

import pytest

import overroll as ovr

TOP = Path(os.environ["TOP"])

#: The contact of the reference values, whatever the defaults are.
REFERENCE = {"M": 20, "L": 10, "alpha": "17 1/GPa", "p0": "198 MPa",
             "z": 0.68, "inlet": -4, "outlet": 1.5, "order": 2,
             "faces": "arithmetic", "scheme": "upstream2"}


def truth(name):
    """The numbers of an array of tests/reference/truth.h, row by row."""
    text = (TOP / "tests/reference/truth.h").read_text()
    body = re.search(rf"\b{name}\[\] = \{{(.*?)\}};", text, re.S).group(1)
    rows = re.findall(r"\{(.*?)\}", body, re.S)
    return [[float(x) for x in row.split(",")] for row in rows] if rows \
        else [float(x) for x in body.split(",") if x.strip()]


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def dent():
    """A case whose dent rolls through the contact in about 150 steps."""
    case = ovr.Case(M=20, L=10, level=5, end=2, inlet=-4)
    return case.feature("dent", depth=0.1, width=0.5, start=-4.6)


@pytest.fixture
def program():
    return os.environ["OVERROLL"]
