# SPDX-License-Identifier: BSD-3-Clause
"""The notebook of the user guide: its cells one after the other, and by nbclient where it is installed."""

import ast
import contextlib
import importlib.util
import io
import json
import os
import sys
import tempfile
import unittest

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot
import numpy
import vtknexrad

import SyntheticFiles

NOTEBOOK = os.path.join(os.environ["NEXRAD_EXAMPLES"], "storm.ipynb")
HAS_NBCLIENT = all(importlib.util.find_spec(name) for name in ("nbclient", "nbformat", "ipykernel"))


def cells():
    """The code cells that the installed packages can run: a tag names a package that a cell needs."""
    with open(NOTEBOOK, encoding="utf-8") as file:
        notebook = json.load(file)
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code" and
            all(importlib.util.find_spec(name) for name in cell["metadata"].get("tags", []))]


def run(source, names):
    """Runs a cell; returns the value of its last line where that is an expression."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) and not source.rstrip().endswith(";") else None
    exec(compile(tree, NOTEBOOK, "exec"), names)  # pylint: disable=exec-used
    return eval(compile(ast.Expression(last.value), NOTEBOOK, "eval"), names) if last else None  # pylint: disable=eval-used


class Notebook(unittest.TestCase):
    def setUp(self):
        self.before = os.getcwd(), os.environ["PATH"]
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        os.chdir(self.folder.name)
        os.environ["PATH"] = os.path.dirname(os.environ["NEXRAD3D"]) + os.pathsep + os.environ["PATH"]

    def tearDown(self):
        os.chdir(self.before[0])
        os.environ["PATH"] = self.before[1]
        matplotlib.pyplot.close("all")

    def test_its_cells_run(self):
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as said:
            shown = [run("".join(cell["source"]), names) for cell in cells()]
        self.assertRegex(said.getvalue(), r"RANGE_FOLDED +\d+ gates\n(.*\n)*largest \d\d\.\d dBZ\n")
        pages = [value._repr_html_() for value in shown if type(value).__module__.startswith("vtknexrad")]
        self.assertEqual(len(pages), 3)  # the radar file, the volume, and the volume that turns
        self.assertIn("<table>", pages[0])
        self.assertIn("data:image/png;base64,", pages[1])
        self.assertRegex(pages[2], "^<iframe srcdoc=")
        self.assertGreaterEqual(len(matplotlib.pyplot.get_fignums()), 3)

    def test_it_is_kept_without_outputs(self):
        with open(NOTEBOOK, encoding="utf-8") as file:
            for cell in json.load(file)["cells"]:
                self.assertEqual(cell.get("outputs", []), [])
                self.assertIsNone(cell.get("execution_count"))

    @unittest.skipUnless(HAS_NBCLIENT, "nbclient, nbformat or ipykernel is not installed")
    def test_it_runs_in_jupyter(self):
        import nbclient
        import nbformat
        notebook = nbformat.read(NOTEBOOK, as_version=4)
        nbformat.validate(notebook)
        kept = {cell["id"] for cell in cells()}
        notebook.cells = [cell for cell in notebook.cells if cell.cell_type != "code" or cell.id in kept]
        nbclient.NotebookClient(notebook, timeout=120).execute()
        kinds = [kind for cell in notebook.cells for output in cell.get("outputs", []) for kind in output.get("data", [])]
        self.assertGreaterEqual(kinds.count("image/png"), 3)
        self.assertGreaterEqual(kinds.count("text/html"), 2)


class Shown(unittest.TestCase):
    """What a notebook shows where matplotlib is not installed, and of volumes that are unusual."""

    def test_without_matplotlib_there_is_the_description(self):
        volume = vtknexrad.merge(SyntheticFiles.files(), dims=(8, 8, 4))[0]
        modules = {name: sys.modules.pop(name) for name in list(sys.modules) if name.startswith("matplotlib")}
        sys.modules["matplotlib"] = None
        try:
            self.assertEqual(volume._repr_html_(), f"<p>{repr(volume).replace('<', '&lt;').replace('>', '&gt;')}</p>")
            with self.assertRaisesRegex(ImportError, "^pictures need the package matplotlib, which is not installed"):
                volume.plot()
        finally:
            del sys.modules["matplotlib"]
            sys.modules.update(modules)

    def test_rays_that_are_missing_stay_blank(self):
        sweep = vtknexrad.open(SyntheticFiles.files()[0])[0]
        mesh = sweep.plot().collections[0]
        drawn = numpy.ma.getmaskarray(mesh.get_array().reshape(-1, len(sweep.ranges)))
        self.assertEqual((~drawn).sum(), sweep["REF"].values.count())
        edges, rays = vtknexrad.pictures.ray_cells(numpy.r_[350.0:360.0, 0.0:80.0, 120.0:350.0])
        gap = list(rays).index(-1)
        self.assertEqual((edges[gap], edges[gap + 1]), (439.5, 479.5))
        self.assertEqual((len(rays), list(rays).count(-1)), (321, 1))
        matplotlib.pyplot.close("all")

    def test_every_moment_has_colours(self):
        for index in range(vtknexrad.vtkNexradMoments.GetNumberOfMoments()):
            colour_map, norm = vtknexrad.colours(vtknexrad.vtkNexradMoments.GetMomentName(index))
            self.assertGreaterEqual(colour_map.N, 5)
            self.assertLess(norm.vmin, norm.vmax)
        with self.assertRaisesRegex(KeyError, "^'REF_age' has no colours$"):
            vtknexrad.colours("REF_age")

    def test_colours_are_those_of_the_weather_service(self):
        colour_map, norm = vtknexrad.colours("REF")
        function = vtknexrad.vtkNexradTransferFunction()
        for value in (7.0, 22.0, 47.0, 66.0):
            index = next(index for index in range(function.GetNumberOfBins())
                         if self.bin_of(function, index)[0][0] <= value < self.bin_of(function, index)[0][1])
            self.assertEqual(colour_map(norm(value))[:3], tuple(self.bin_of(function, index)[1]))
        self.assertEqual(colour_map(norm(2.0))[3], 0.0)

    @staticmethod
    def bin_of(function, index):
        edges, lower, upper = [0.0] * 2, [0.0] * 3, [0.0] * 3
        function.GetBin(index, edges, lower, upper)
        return edges, lower

    def test_a_volume_without_echo_and_axes_in_degrees(self):
        series = vtknexrad.merge(SyntheticFiles.files(), dims=(8, 8, 4), axes="geographic", bounds=(-70, 20, -69, 21))
        self.assertIn("data:image/png;base64,", series[0]._repr_html_())


if __name__ == "__main__":
    unittest.main()
