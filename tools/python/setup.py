# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the package `overroll`.

Beside the modules a wheel carries the shared library, built by the Makefile (or
that of OVERROLL_LIBRARY), and `_interface.py`, which cffi makes from the public
headers: no C is compiled here, and no declaration is written down twice.
"""
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import setuptools
from cffi import FFI
from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
HEADERS = TOP / "include" / "overroll"
VERSION = re.search(r'OVERROLL_VERSION "(.*)"',
                    (HEADERS / "version.h").read_text()).group(1)


def declarations():
    """The public headers as the preprocessor leaves them, for cffi."""
    text = "".join(path.read_text() for path in HEADERS.glob("*.h"))
    with tempfile.TemporaryDirectory() as empty:
        for name in re.findall(r"#include <(\w+\.h)>", text):
            (Path(empty) / name).touch()
        # Without attributes; bool is a word that cffi knows.
        text = subprocess.run(
            [*os.environ.get("CC", "cc").split(), "-E", "-P", "-U__GNUC__",
             "-nostdinc", "-I", empty, "-I", TOP / "include", "-"],
            input="#include <overroll/overroll.h>\n", text=True, check=True,
            stdout=subprocess.PIPE).stdout
    return re.sub(r"static inline[^{}]*\{[^{}]*\}", "", text)


def library():
    """The shared library, made where none is given."""
    given = os.environ.get("OVERROLL_LIBRARY")
    if given:
        return Path(given)
    made = Path("build") / f"liboverroll.so.{VERSION}"
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("MAKE", "MFLAGS"))}
    subprocess.run(["make", "-s", f"-j{os.cpu_count() or 1}", "-C", TOP, made],
                   env=environment, check=True)
    return TOP / made


class Build(build_py):
    def run(self):
        super().run()
        package = Path(self.build_lib) / "overroll"
        package.mkdir(parents=True, exist_ok=True)
        ffi = FFI()
        ffi.cdef(declarations())
        ffi.set_source("overroll._interface", None)
        ffi.emit_python_code(str(package / "_interface.py"))
        (package / "_version.py").write_text(f'VERSION = "{VERSION}"\n')
        shutil.copyfile(library(), package / "liboverroll.so")


class Wheel(bdist_wheel):
    """For any Python 3 on this kind of machine."""

    def get_tag(self):
        return ("py3", "none", super().get_tag()[2])


class Binary(Distribution):
    def has_ext_modules(self):
        return True


# An SPDX expression, under the name that this setuptools has for it.
RELEASE = int(setuptools.__version__.split(".")[0])
LICENCE = {"license_expression" if RELEASE >= 77 else "license":
           "GPL-3.0-or-later"}

os.chdir(HERE)
(TOP / "build" / "python-package").mkdir(parents=True, exist_ok=True)
setup(version=VERSION, **LICENCE, packages=["overroll"], distclass=Binary,
      package_data={"overroll": ["py.typed"]},
      cmdclass={"build_py": Build, "bdist_wheel": Wheel})
