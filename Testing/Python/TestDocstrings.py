# SPDX-License-Identifier: BSD-3-Clause
"""The examples in the docstrings of the package and in the user guide, run in a folder with the files that they name."""

import contextlib
import datetime
import doctest
import functools
import importlib.util
import io
import os
import pathlib
import pkgutil
import re
import shutil
import subprocess
import unittest

import matplotlib
import numpy

matplotlib.use("Agg")
import vtknexrad

import SyntheticFiles

NAMES = {"vtknexrad": vtknexrad, "State": vtknexrad.State, "numpy": numpy, "datetime": datetime, "pathlib": pathlib}
LEAST_EXAMPLES = 40


def modules():
    """The package, and those of its modules that are written in Python."""
    names = [module.name for module in pkgutil.iter_modules(vtknexrad.__path__) if not module.name.startswith("vtk")]
    return [vtknexrad, *(importlib.import_module(f"vtknexrad.{name}") for name in names)]


@contextlib.contextmanager
def folder_of_examples(name):
    """The current folder is one with the files that the docstring of the package and the user guide name."""
    folder = os.path.join(SyntheticFiles.folder(), name)
    os.makedirs(os.path.join(folder, "KLSX"))
    for path in SyntheticFiles.files():
        shutil.copy(path, os.path.join(folder, "KLSX"))
    os.symlink("KLSX", os.path.join(folder, "folder-of-radar-files"))
    shutil.copy(SyntheticFiles.files()[0], folder)
    before = os.getcwd()
    os.chdir(folder)
    try:
        subprocess.run([os.environ["NEXRAD3D"], "grid", "KLSX", "-o", "volumes", "--dims", "64x64x32", "--quiet"],
                       check=True)
        yield
    finally:
        os.chdir(before)


class Docstrings(unittest.TestCase):
    def test_examples(self):
        attempted = 0
        with folder_of_examples("docstrings"):
            for module in modules():
                with self.subTest(module.__name__):
                    failed, count = doctest.testmod(module, extraglobs=NAMES)
                    attempted += count
                    self.assertEqual(failed, 0)
        self.assertGreaterEqual(attempted, LEAST_EXAMPLES)

    def test_the_code_of_the_user_guide(self):
        guide = pathlib.Path(os.environ["NEXRAD_EXAMPLES"]).parent / "5-vtk.md"
        blocks = re.findall(r"^```python\n(.*?)^```", guide.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
        self.assertGreaterEqual(len(blocks), 2)
        names = {}
        with folder_of_examples("guide"), contextlib.redirect_stdout(io.StringIO()) as said:
            for block in blocks:
                exec(self.runnable(block), names)  # pylint: disable=exec-used
        self.assertRegex(said.getvalue(), r"^11 2006-03-12T18:01:45[.\d]+ \d\d\.\d dBZ\n(2006-03-12T[^\n]+\n){3}$")

    @staticmethod
    def runnable(code):
        """The code without the lines that need packages which are not installed."""
        without = [start for start, package in (("data", "xarray"), ("data.to_netcdf", "netCDF4"))
                   if importlib.util.find_spec(package) is None]
        return "\n".join(line for line in code.splitlines() if not line.startswith(tuple(without)))

    def test_whatever_is_public_has_one(self):
        lacking = []
        for module in modules():
            own = [one for one in vars(module).values() if getattr(one, "__module__", None) == module.__name__]
            for one in own:
                members = vars(one).items() if isinstance(one, type) else ()
                for name, member in [("", one), *((name, member) for name, member in members
                                                  if not name.startswith("_") and
                                                  (callable(member) or isinstance(
                                                      member, (property, functools.cached_property))))]:
                    if callable(one) and not one.__name__.startswith("_") and not member.__doc__:
                        lacking.append(f"{one.__name__}.{name}")
        overridden = {"_Pipeline.RequestInformation", "_Pipeline.RequestData"}
        self.assertEqual(set(lacking) - overridden, set())


class Version(unittest.TestCase):
    def test_the_version_is_that_of_the_program(self):
        said = subprocess.run([os.environ["NEXRAD3D"], "--version"], check=True, capture_output=True, text=True).stdout
        self.assertIn(vtknexrad.__version__, said)

    def test_importing_all_leaves_python_s_open(self):
        names = {}
        exec("from vtknexrad import *", names)  # pylint: disable=exec-used
        self.assertNotIn("open", names)
        self.assertIn("vtkNexradDayReader", names)
        self.assertIn("merge", names)


if __name__ == "__main__":
    unittest.main()
