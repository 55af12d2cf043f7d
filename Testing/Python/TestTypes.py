# SPDX-License-Identifier: BSD-3-Clause
"""The type hints of the package and the stubs of the wrapped classes, by mypy where it is installed."""

import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

import vtknexrad

HAS_MYPY = importlib.util.find_spec("mypy") is not None
CONFIGURATION = """[mypy]
disallow_untyped_defs = True
disallow_incomplete_defs = True
check_untyped_defs = True
no_implicit_reexport = True
[mypy-vtkmodules.*,matplotlib.*,xarray.*,datatree.*]
ignore_missing_imports = True
"""
USE = """import datetime
import pathlib

import numpy
import vtknexrad

series = vtknexrad.merge(pathlib.Path("a"), dims=(1, 2, 3), begin=numpy.datetime64("2006-03-12"),
                         step=datetime.timedelta(minutes=5), bias={"KLSX": 1.0})
reveal_type(series[0]["REF"].values)  # numpy.ma.core.MaskedArray
reveal_type(series[0].time)  # numpy.datetime64
reveal_type(series[1:])  # vtknexrad.series.VolumeSeries
reveal_type(vtknexrad.RadarVolume("a")[0]["REF"].unit)  # builtins.str
reveal_type(vtknexrad.vtkNexradDayReader().GetMaximumGap())  # builtins.float
reveal_type(vtknexrad.__version__)  # builtins.str
vtknexrad.merge("a", dims=3)  # error
vtknexrad.vtkNexradDayReader().SetMaximumGap("a")  # error
"""


class Stubs(unittest.TestCase):
    def test_the_package_is_marked_and_has_stubs(self):
        folder = os.path.dirname(vtknexrad.__file__)
        for name in ("py.typed", "vtkNexradIO.pyi", "vtkNexradFilters.pyi", "vtkNexradRendering.pyi",
                     "vtkNexradScene.pyi"):
            self.assertTrue(os.path.isfile(os.path.join(folder, name)), name)

    def test_every_class_and_function_is_in_them(self):
        for module in (vtknexrad.vtkNexradIO, vtknexrad.vtkNexradFilters, vtknexrad.vtkNexradRendering,
                       vtknexrad.vtkNexradScene):
            with open(os.path.splitext(module.__file__)[0] + ".pyi", encoding="utf-8") as file:
                stub = file.read()
            compile(stub, module.__name__, "exec")
            self.assertNotIn("*arguments", stub)
            for one in vars(module).values():
                if isinstance(one, type) and one.__module__ == module.__name__:
                    self.assertIn(f"class {one.__name__}(", stub)
                    for name, member in vars(one).items():
                        if callable(member) and not name.startswith("_") and not isinstance(member, type):
                            self.assertIn(f"    def {name}(", stub)


@unittest.skipUnless(HAS_MYPY, "mypy is not installed")
class Types(unittest.TestCase):
    # What mypy finds out about other packages in one test, it need not find out again in the other.
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        with open(os.path.join(cls.folder.name, "mypy.ini"), "w", encoding="ascii") as file:
            file.write(CONFIGURATION)

    def mypy(self, *arguments):
        options = ["--config-file", os.path.join(self.folder.name, "mypy.ini"), "--cache-dir",
                   os.path.join(self.folder.name, "cache")]
        done = subprocess.run([sys.executable, "-m", "mypy", *options, *arguments], capture_output=True, text=True)
        return done.stdout + done.stderr

    def test_the_package(self):
        self.assertRegex(self.mypy("-p", "vtknexrad"), "^Success")

    def test_what_a_user_gets_of_it(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "use.py")
            with open(path, "w", encoding="ascii") as file:
                file.write(USE)
            said = self.mypy(path)
        lines = {int(line.split(":")[1]): line for line in said.splitlines() if ": " in line and "use.py" in line}
        expected = {number: line.split("# ")[1] for number, line in enumerate(USE.splitlines(), 1) if "# " in line}
        self.assertEqual(set(lines), set(expected), said)
        for number, text in expected.items():
            self.assertIn(text, lines[number])


if __name__ == "__main__":
    unittest.main()
