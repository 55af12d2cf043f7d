# SPDX-License-Identifier: BSD-3-Clause
"""What a person sees who does nothing but open files and press Apply; here Show does what Apply does."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
import Plugin
import SyntheticFiles
import vtknexrad
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

# Makes REF grey in the user's settings, as the colour map editor saves it, and shows a day after a restart.
SETTINGS = """
import os, sys
from paraview import servermanager, simple
settings = servermanager.vtkSMSettings.GetInstance()
settings.AddCollectionFromString('{"standard_presets": {"REF": "Grayscale"}}', 100.0)
simple.LoadPlugin(os.environ["NEXRAD_PLUGIN"], remote=False, ns=vars(simple))
print("colours", list(simple.GetColorTransferFunction("REF").RGBPoints)[1:4])
"""


class ShowTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(simple.ResetSession)
        self.folder = folder.name
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [600, 400]

    def day(self, **settings):
        files = list(SyntheticFiles.files())
        return simple.NEXRADRadarDay(FileNames=files, **{"Dimensions": [96, 96, 48], **settings})

    def apply(self, source):
        """What the button Apply calls."""
        controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
        self.assertTrue(controller.ShowInPreferredView(source.SMProxy, 0, self.view.SMProxy))
        return simple.GetDisplayProperties(source, self.view)

    def picture(self):
        path = os.path.join(self.folder, "picture.png")
        simple.SaveScreenshot(path, self.view)
        return Plugin.picture(path)

    def coloured(self):
        """The part of the picture that is echo."""
        pixels = self.picture()
        return (pixels.max(axis=2) - pixels.min(axis=2) >= 40).mean()


class Volume(ShowTest):
    def test_volume_is_coloured_lit_and_lifted(self):
        day = self.day()
        display = simple.Show(day, self.view)
        self.assertEqual(display.Representation, "Volume (slices)")
        self.assertEqual(list(display.ColorArrayName), ["POINTS", "REF"])
        self.assertEqual(list(display.Scale), [1, 1, 3])
        self.assertTrue(500 < display.ScalarOpacityUnitDistance < 20000)
        self.assertTrue(128 <= display.NumberOfSlices <= 1024)
        self.assertGreater(min(display.ShadowStrength, display.AmbientOcclusionStrength), 0)
        self.assertGreater(display.Exposure, 1)
        self.assertLess(display.ShadowDensity, 1)
        self.assertEqual(display.Ground, 1)
        self.assertEqual(self.view.BackgroundColorMode, "Gradient")
        self.assertEqual(list(self.view.Background), [1, 1, 1])
        away = numpy.subtract(self.view.CameraPosition, self.view.CameraFocalPoint)
        self.assertLess(away[1], 0, "from the south")
        self.assertGreater(away[2], 0, "from above")
        self.assertEqual(list(simple.GetSources().values()), [day], "scripts get nothing that they did not make")

    def test_colours_are_the_preset_s_and_stay(self):
        display = simple.Show(self.day(), self.view)
        function = vtknexrad.vtkNexradTransferFunction()
        colours = simple.GetColorTransferFunction("REF")
        opacity = simple.GetOpacityTransferFunction("REF")
        for dBZ in (10, 30, 55):
            self.assertAlmostEqual(opacity.GetClientSideObject().GetValue(dBZ), function.Evaluate(3, dBZ), delta=0.02)
        before = list(colours.RGBPoints)
        manager = servermanager.vtkSMTransferFunctionManager()
        manager.ResetAllTransferFunctionRangesUsingCurrentData(
            servermanager.ProxyManager().SMProxyManager, False)
        display.RescaleTransferFunctionToDataRange(True, False)
        self.assertEqual(list(colours.RGBPoints), before)
        self.assertEqual(colours.NanOpacity, 0)

    def test_every_moment_has_its_preset_and_its_unit(self):
        for name, title in (("REF", "Reflectivity (dBZ)"), ("VEL", "Radial velocity (m/s)"),
                            ("RHO", "Correlation coefficient"), ("KDP", "Specific differential phase (degrees/km)")):
            function = vtknexrad.vtkNexradTransferFunction()
            function.ApplyPreset(vtknexrad.vtkNexradTransferFunction.FindPreset(name, 0))
            points = simple.GetColorTransferFunction(name).RGBPoints
            span = [0.0, 0.0]
            function.GetRange(span)
            self.assertAlmostEqual(points[0], span[0], delta=0.3 * (span[1] - span[0]), msg=name)
            opacity = simple.GetOpacityTransferFunction(name).GetClientSideObject()
            middle = (span[0] + span[1]) / 2
            self.assertAlmostEqual(opacity.GetValue(middle), function.Evaluate(3, middle), delta=0.02)
        for name, title in (("REF", "Reflectivity (dBZ)"), ("VEL", "Radial velocity (m/s)")):
            display = simple.Show(self.day(Moment=name), self.view)
            display.SetScalarBarVisibility(self.view, True)
            bar = simple.GetScalarBar(simple.GetColorTransferFunction(name), self.view)
            self.assertEqual(bar.Title, title)
            self.assertNotIn("e", bar.RangeLabelFormat)

    def test_what_a_user_chose_counts_before(self):
        done = subprocess.run([os.environ["NEXRAD_PVPYTHON"], "-c", SETTINGS], env={**os.environ, "HOME": self.folder},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100)
        sys.stdout.write(done.stdout)
        found = re.search(r"^colours \[(.*)\]$", done.stdout, re.MULTILINE)
        self.assertEqual(len(set(found.group(1).split(", "))), 1, "grey")

    def test_saved_state_comes_back_as_it_was(self):
        display = simple.Show(self.day(), self.view)
        display.Scale = [1, 1, 3]
        display.SetRepresentationType("Outline")
        self.view.Background = [1, 1, 1]
        state = os.path.join(self.folder, "state.pvsm")
        simple.SaveState(state)
        simple.ResetSession()
        simple.LoadState(state)
        view = simple.GetRenderViews()[0]
        display = simple.GetDisplayProperties(list(simple.GetSources().values())[0], view)
        self.assertEqual(list(display.Scale), [1, 1, 3])
        self.assertEqual(display.Representation, "Outline")
        self.assertEqual(list(view.Background), [1, 1, 1])

    def test_a_second_source_leaves_the_view_as_it_is(self):
        simple.Show(simple.Sphere(), self.view)
        before = list(self.view.CameraPosition), self.view.UseColorPaletteForBackground
        simple.Show(self.day(), self.view)
        self.assertEqual((list(self.view.CameraPosition), self.view.UseColorPaletteForBackground), before)

    def test_degrees_have_the_same_look(self):
        display = simple.Show(self.day(Axes="Geographic (degrees)"), self.view)
        self.assertAlmostEqual(display.Scale[2] * 111195, 3, delta=0.01)
        self.assertAlmostEqual(display.Scale[0], numpy.cos(numpy.radians(38.7)), delta=0.01)
        # ParaView places the clipping planes of the first picture for heights that are not scaled yet.
        self.picture()
        self.assertGreater(self.coloured(), 0.03)


class Companions(ShowTest):
    def names(self):
        return sorted(name for name, _ in simple.GetSources())

    def test_apply_adds_map_and_time_once(self):
        self.apply(self.day())
        self.assertEqual(self.names(), ["Map", "NEXRADRadarDay1", "Time"])
        self.apply(self.day())
        self.assertEqual(self.names(), ["Map", "NEXRADRadarDay1", "NEXRADRadarDay2", "Time"])

    def test_map_lies_under_the_volume(self):
        day = self.day()
        data = Plugin.fetch(simple.NEXRADMap(Input=day, RingSpacing=100e3))
        volume = Plugin.fetch(day)
        low, high = numpy.array(volume.GetBounds()[0:4:2]), numpy.array(volume.GetBounds()[1:4:2])
        half = numpy.array(volume.GetSpacing()[:2]) / 2
        points = vtk_to_numpy(data.GetPoints().GetData())
        kinds = vtk_to_numpy(data.GetCellData().GetArray("MapKind"))
        self.assertLessEqual({1, 3, 4, 5}, set(kinds))
        self.assertNotIn(2, kinds, "too many counties for a domain of this size")
        self.assertTrue((points[:, :2] >= low - half - 1).all() and (points[:, :2] <= high + half + 1).all())
        # KLSX stands in the middle of its domain, 250 m from where the table of sites has it. The first polygon is its
        # disc, the others are its name.
        disc = data.GetCell(data.GetNumberOfLines()).GetBounds()
        self.assertLess(max(abs(disc[0] + disc[1]), abs(disc[2] + disc[3])) / 2, 500.0)
        rings = [data.GetCell(i).GetBounds() for i in range(data.GetNumberOfLines()) if kinds[i] == 3]
        self.assertAlmostEqual(max(ring[1] for ring in rings), 200e3, delta=500)

    def test_letters_are_dark_on_the_light_sky(self):
        display = self.apply(self.day())
        display.SetScalarBarVisibility(self.view, True)
        bar = simple.GetScalarBar(simple.GetColorTransferFunction("REF"), self.view)
        time = simple.GetDisplayProperties(simple.FindSource("Time"), self.view)
        for colour in (bar.TitleColor, bar.LabelColor, time.Color, self.view.OrientationAxesLabelColor):
            self.assertLess(max(colour), 0.3)

    def test_counties_are_there_where_they_can_be_told_apart(self):
        data = Plugin.fetch(simple.NEXRADMap(Input=self.day(Range=80000)))
        self.assertIn(2, vtk_to_numpy(data.GetCellData().GetArray("MapKind")))

    def test_parts_of_the_map_can_be_left_out(self):
        bare = Plugin.fetch(simple.NEXRADMap(Input=self.day(), Radars=0, Towns=0))
        kinds = set(vtk_to_numpy(bare.GetCellData().GetArray("MapKind")))
        self.assertLessEqual(kinds, {0, 1})
        self.assertIn(1, kinds)

    def test_time_is_utc_and_says_synthetic(self):
        day = self.day()
        text = simple.NEXRADTime(Input=day)
        table = Plugin.fetch(text, day.TimestepValues[0])
        self.assertEqual(table.GetColumn(0).GetValue(0), "2006-03-12 18:05:00 UTC\nKLSX\nSYNTHETIC")
        sweeps = simple.NEXRADLevelIISeries(FileNames=list(SyntheticFiles.files()))
        table = Plugin.fetch(simple.NEXRADTime(Input=sweeps, Radars=0), sweeps.TimestepValues[0])
        self.assertRegex(table.GetColumn(0).GetValue(0), r"^2006-03-12 18:0\d:\d\d UTC\nSYNTHETIC$")


class Sweeps(ShowTest):
    def test_the_first_cut_is_a_plan(self):
        sweeps = simple.NEXRADLevelIISeries(FileNames=list(SyntheticFiles.files()))
        sweeps.Moments = ["REF"]
        display = simple.Show(sweeps, self.view)
        self.assertEqual(list(display.ColorArrayName), ["POINTS", "REF"])
        self.assertEqual(len(display.BlockSelectors), 1)
        self.assertIn("Sweep00", display.BlockSelectors[0].replace("_", ""))
        away = numpy.subtract(self.view.CameraPosition, self.view.CameraFocalPoint)
        self.assertLess(numpy.abs(away[:2]).max(), 1e-6 * away[2], "from above")
        self.assertGreater(self.coloured(), 0.01, "echo is seen")
        sky = self.picture().min(axis=2) >= 235
        self.assertGreater(sky.mean(), 0.5, "gates without echo are not")
        # Below 5 dBZ a gate has the colour of the ground, not the first one of the legend.
        colours = simple.GetColorTransferFunction("REF")
        self.assertEqual(colours.UseBelowRangeColor, 1)
        self.assertLess(max(colours.BelowRangeColor) - min(colours.BelowRangeColor), 0.02)
        self.assertEqual(simple.GetColorTransferFunction("VEL").UseBelowRangeColor, 0)

    def test_names_of_blocks_do_not_change_with_time(self):
        sweeps = simple.NEXRADLevelIISeries(FileNames=Plugin.real_files("run-kbgm-20050821"))
        names = []
        for time in sweeps.TimestepValues:
            data = Plugin.fetch(sweeps, time)
            names.append([data.GetMetaData(i).Get(data.NAME()) for i in range(data.GetNumberOfPartitionedDataSets())])
        self.assertEqual(names[0][0], "KBGM Sweep 00 0.48 deg")
        for later in names[1:]:
            self.assertEqual(later, names[0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
