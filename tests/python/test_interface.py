# SPDX-License-Identifier: GPL-3.0-or-later
"""The declarations of cffi equal those of the public headers."""
import os
import re
import shutil
import subprocess

import overroll as ovr
from overroll._interface import ffi
from conftest import TOP


def test_structs_are_those_of_the_compiler():
    structs = {}
    for name in ffi.list_types()[0]:
        try:
            kind = ffi.typeof(name)
        except ffi.error:  # a function
            continue
        if kind.kind == "struct" and kind.fields:
            structs[name] = {field: at.offset for field, at in kind.fields}
    assert len(structs) > 40
    lines = ["#include <overroll/overroll.h>", "#include <stdio.h>",
             "int main(void) {"]
    for name, fields in structs.items():
        lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
        lines += [f'printf("{name}.{field} %zu\\n", '
                  f'offsetof({name}, {field}));' for field in fields]
    with open("sizes.c", "w") as file:
        file.write("\n".join(lines + ["return 0;", "}"]))
    subprocess.run([*os.environ["CC"].split(), "-I", TOP / "include",
                    "sizes.c", "-o", "sizes"], check=True)
    said = subprocess.run(["./sizes"], stdout=subprocess.PIPE, text=True,
                          check=True).stdout
    wanted = dict(line.rsplit(" ", 1) for line in said.splitlines())
    for name, fields in structs.items():
        assert ffi.sizeof(name) == int(wanted[name]), name
        for field, offset in fields.items():
            assert offset == int(wanted[f"{name}.{field}"]), (name, field)


def test_version_and_manual():
    header = (TOP / "include/overroll/version.h").read_text()
    assert f'"{ovr.__version__}"' in header
    page = (TOP / "src/run/overroll-python.7").read_text()
    page = page.replace("\\-", "-").replace("\\", "")
    for name in (*ovr.__all__, "open", "help"):
        assert re.search(rf"\b{name}\b", page), name


def test_the_page_shows_what_works():
    page = (TOP / "src/run/overroll-python.7").read_text()
    shown = re.findall(r'\.\\" python\n\.EX\n(.*?)\.EE', page, re.S)
    assert len(shown) >= 5
    exec("\n".join(shown).replace("\\-", "-"), {})


def test_the_tour_of_the_readme(program):
    """The Python example of README.md runs on a coarser grid."""
    page = (TOP / "README.md").read_text()
    subprocess.run([program, "init", "roller", "--set", "domain.level=4",
                    "-o", "roller.ini"], check=True)
    shown = re.search(r"```python\n(.*?)```", page, re.S).group(1)
    assert "ovr.sweep" in shown
    if not shutil.which("gnuplot"):
        shown = shown.replace("ds.overroll.plot()", "")
    exec(shown, {})


def test_all_that_is_public_is_described():
    for name in (*ovr.__all__, "open", "help"):
        thing = getattr(ovr, name)
        if name.startswith("_"):
            continue
        assert thing.__doc__, name
        for member, value in vars(thing).items() if isinstance(thing, type) \
                else ():
            if not member.startswith("_") and (callable(value)
                                               or isinstance(value, property)):
                if isinstance(value, property) and thing is not ovr.Solution:
                    continue
                assert value.__doc__, f"{name}.{member}"
