# SPDX-License-Identifier: BSD-3-Clause
"""The examples of the user guide, each as a user runs it."""

import glob
import importlib.util
import os
import re
import subprocess
import sys
import unittest

import numpy
import vtknexrad
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader

import SyntheticFiles
from Tolerance import at_least

HAS_OPENVDB = importlib.util.find_spec("pyopenvdb") is not None


def example(name):
    return os.path.join(os.environ["NEXRAD_EXAMPLES"], name + ".py")


def run(name, *arguments):
    """What the example prints. Its warnings are errors."""
    done = subprocess.run([sys.executable, "-W", "error", example(name), *arguments],
                          capture_output=True, text=True)
    if done.returncode != 0 or done.stderr:
        raise AssertionError(f"{name}: {done.returncode}\n{done.stderr}")
    return done.stdout


def picture_path(name):
    return os.path.join(SyntheticFiles.folder(), name + ".png")


def pixels(path):
    """A picture's colours, one row a pixel."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    return vtk_to_numpy(vtknexrad.update(reader).GetPointData().GetScalars())


def merged_volume():
    """A volume of the merged series; merges at the first call."""
    folder = os.path.join(SyntheticFiles.folder(), "day")
    if not os.path.isdir(folder):
        run("merge_day", folder, *SyntheticFiles.files())
    return sorted(glob.glob(os.path.join(folder, "*.nxv")))[0]


class Usage(unittest.TestCase):
    names = sorted(os.path.splitext(os.path.basename(path))[0]
                   for path in glob.glob(os.path.join(os.environ["NEXRAD_EXAMPLES"], "*.py"))
                   if "paraview" not in path and "dask" not in path  # ParaView's Python and TestDask run these
                   and (HAS_OPENVDB or "openvdb" not in path))

    def refused(self, name, *arguments):
        done = subprocess.run([sys.executable, "-W", "error", example(name), *arguments], capture_output=True, text=True)
        self.assertNotIn("Traceback", done.stderr, name)
        self.assertEqual(done.stdout, "", name)
        return done.returncode, done.stderr

    def test_without_arguments_an_example_says_how_it_is_used(self):
        self.assertEqual(len(self.names), 10 if HAS_OPENVDB else 9)
        for name in self.names:
            status, said = self.refused(name)
            self.assertEqual(status, 2, name)
            self.assertTrue(said.startswith(f"usage: {name}.py "), said)

    def test_a_file_that_cannot_be_read_is_one_line(self):
        picture = picture_path("none")
        for name in self.names:
            if name == "slices_in_vtk":
                continue  # it reads no file
            for path in ("/nowhere/file", __file__):
                arguments = {"merge_day": (SyntheticFiles.folder(), path),
                             "radar_seam": (path, path, "KILX", "KLSX", picture)}.get(name, (path, picture))
                status, said = self.refused(name, *arguments)
                self.assertEqual(status, 1, name)
                self.assertRegex(said, rf"\A{name}.py: [^\n]*{re.escape(path)}[^\n]*\n\Z")
        self.assertFalse(os.path.exists(picture))

    def test_what_is_not_in_the_file_is_one_line(self):
        file, picture = SyntheticFiles.files()[0], picture_path("none")
        self.assertEqual(self.refused("plot_sweep", file, picture, "99"),
                         (1, "plot_sweep.py: no sweep 99; there are 16, counted from 0\n"))
        self.assertEqual(self.refused("plot_sweep", file, picture, "0", "VEL"),
                         (1, "plot_sweep.py: sweep 0 has no 'VEL'; it has REF\n"))
        self.assertEqual(self.refused("render_volume", merged_volume(), picture, "storm")[0], 2)


class Examples(unittest.TestCase):
    def test_plot_sweep(self):
        picture = picture_path("sweep")
        said = run("plot_sweep", SyntheticFiles.files()[0], picture)
        self.assertRegex(said, r"^36\d rays of \d+ gates, largest REF \d+\.\d\n$")
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 160, "colours of the picture")

    def test_merge_day(self):
        volume = merged_volume()
        reader = vtknexrad.vtkNexradVolumeReader()
        reader.SetFileName(os.path.join(os.path.dirname(volume), "day.nxv.series"))
        self.assertGreaterEqual(len(vtknexrad.time_steps(reader)), 2)
        self.assertEqual(vtknexrad.update(reader).GetDimensions(), (128, 128, 64))

    def test_render_volume(self):
        picture = picture_path("volume")
        run("render_volume", merged_volume(), picture, "storm cores")
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 1500, "colours of the picture")

    def test_echo_tops(self):
        picture = picture_path("tops")
        said = run("echo_tops", merged_volume(), picture)
        self.assertRegex(said, r"^\d+ columns, highest \d+\.\d km\n$")
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 450, "colours of the picture")

    def test_echo_tops_by_hand(self):
        specification = importlib.util.spec_from_file_location("echo_tops", example("echo_tops"))
        module = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(module)
        values = numpy.full((4, 1, 3), -33.0, numpy.float32)
        values[0, 0, 0] = 18.0  # the threshold counts, and the lowest level
        values[1, 0, 1] = values[2, 0, 1] = 30.0
        values[3, 0, 1] = 17.9
        volume = vtkImageData()
        volume.SetDimensions(3, 1, 4)
        volume.SetOrigin(0.0, 0.0, 500.0)
        volume.SetSpacing(1000.0, 1000.0, 1000.0)
        scalars = numpy_to_vtk(values.ravel(), deep=True)
        scalars.SetName("REF")
        volume.GetPointData().SetScalars(scalars)
        numpy.testing.assert_array_equal(module.echo_tops(volume, 18.0), [[500.0, 2500.0, numpy.nan]])

    def test_radar_seam(self):
        folder = os.path.join(SyntheticFiles.folder(), "seam")
        program = os.environ["NEXRAD3D"]
        subprocess.run([program, "simulate", os.path.join(folder, "files"), "--sites", "KILX:21,KLSX:21", "--hours",
                        "0.2", "--bias", "KLSX:6", "--quiet"], check=True)
        for bias in ("off", "KLSX:6"):
            subprocess.run([program, "grid", os.path.join(folder, "files"), "-o", os.path.join(folder, bias), "--bias",
                            bias, "--overlap", "nearest", "--ancillary", "--begin", "2006-03-12T18:10", "--end",
                            "2006-03-12T18:10", "--dims", "160x160x20", "--height", "0,8km", "--quiet"], check=True)
        picture = picture_path("seam")
        volumes = [glob.glob(os.path.join(folder, bias, "*.nxv"))[0] for bias in ("off", "KLSX:6")]
        said = run("radar_seam", *volumes, "KILX", "KLSX", picture)
        steps = [float(number) for number in re.findall(r"step KLSX - KILX ([+-]\d+\.\d\d) dB", said)]
        self.assertEqual(len(steps), 2)
        self.assertAlmostEqual(steps[0] - steps[1], 6.0, delta=0.5)
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 150, "colours of the picture")

    def test_draw_scene(self):
        picture, program = picture_path("scene"), picture_path("program")
        run("draw_scene", merged_volume(), picture)
        subprocess.run([os.environ["NEXRAD3D"], "render", merged_volume(), "-o", program, "--quiet"],
                       check=True)
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 18000, "colours of the picture")
        numpy.testing.assert_array_equal(pixels(picture), pixels(program))

    def test_rotation(self):
        folder = os.path.join(SyntheticFiles.folder(), "rotation")
        subprocess.run([os.environ["NEXRAD3D"], "grid", SyntheticFiles.files()[0], "-o", folder, "--moment",
                        "REF,AZSHEAR", "--dims", "128x128x64", "--quiet"], check=True)
        picture = picture_path("rotation")
        said = run("rotation", glob.glob(os.path.join(folder, "*.nxv"))[0], picture, "0.004")
        self.assertRegex(said, r"^surfaces of 0.004/s that are at least 3 km high: [1-9]\d*\n$")
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 1500, "colours of the picture")

    def test_draw_model(self):
        model, picture = os.path.join(SyntheticFiles.folder(), "storm.glb"), picture_path("model")
        subprocess.run([os.environ["NEXRAD3D"], "render", merged_volume(), "-o", model, "--quiet"], check=True)
        run("draw_model", model, picture)
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 1000, "colours of the picture")

    @unittest.skipUnless(HAS_OPENVDB, "needs pyopenvdb")
    def test_volume_to_openvdb(self):
        import pyopenvdb
        path, file = merged_volume(), picture_path("volume").replace(".png", ".vdb")
        said = run("volume_to_openvdb", path, file, "--least", "10")
        volume = vtknexrad.Volume.open(path)
        expected = numpy.maximum(volume["REF"].filled(10.0), numpy.float32(10.0))
        grid = pyopenvdb.read(file, "REF")
        values = numpy.empty(expected.transpose(2, 1, 0).shape, numpy.float32)
        grid.copyToArray(values)
        numpy.testing.assert_array_equal(values.transpose(2, 1, 0), expected)
        self.assertEqual(grid.activeVoxelCount(), numpy.count_nonzero(expected > 10.0))
        self.assertEqual(said, f"{file}: REF, {grid.activeVoxelCount()} active voxels\n")
        self.assertEqual((grid.background, grid["unit"], grid["synthetic"]), (10.0, "dBZ", True))
        numpy.testing.assert_allclose(grid.transform.indexToWorld((3, 100, 20)),
                                      (volume.x[3], volume.y[100], volume.z[20]))

    def test_slices_in_vtk(self):
        picture = picture_path("slices")
        run("slices_in_vtk", picture)
        at_least(self, len(numpy.unique(pixels(picture), axis=0)), 4000, "colours of the picture")


if __name__ == "__main__":
    unittest.main()
