# SPDX-License-Identifier: BSD-3-Clause
"""Volumes drawn as slices beside ParaView's own representation, time, state and animation."""

import glob
import os
import tempfile
import unittest

import Plugin
import SyntheticFiles
import vtknexrad  # noqa: F401  so that Python knows the mapper's class
from paraview import simple

SLICES = "Volume (slices)"


class PictureTest(unittest.TestCase):
    """One window with twelve minutes of a synthetic storm day, from the south, ten times too high."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [400, 300]
        self.day = simple.NEXRADRadarDay(
            FileNames=list(SyntheticFiles.files()), Dimensions=[96, 96, 48], Range=150000)
        self.show(self.day)
        self.view.ViewTime = self.day.TimestepValues[0]
        self.view.CameraViewUp = [0, 0, 1]
        self.view.CameraFocalPoint = [0, 0, 60e3]
        self.view.CameraPosition = [-100e3, -500e3, 300e3]

    def show(self, source):
        self.display = simple.Show(source, self.view)
        simple.ColorBy(self.display, ("POINTS", "REF"))
        simple.GetColorTransferFunction("REF").ApplyPreset("NEXRAD all echo", False)
        self.opacity = simple.GetOpacityTransferFunction("REF")
        self.opacity.ApplyPreset("NEXRAD all echo", False)
        self.display.Scale = [1, 1, 10]
        self.display.ScalarOpacityUnitDistance = 5000
        self.display.ShadowStrength = self.display.AmbientOcclusionStrength = 0  # as ParaView's own
        self.display.Ground = 0
        self.display.ImageSampleDistance = 1

    def tearDown(self):
        for proxy in (self.display, self.day, self.view):
            simple.Delete(proxy)

    def draw(self, representation=None):
        if representation:
            self.display.SetRepresentationType(representation)
        path = os.path.join(self.folder, "picture.png")
        simple.SaveScreenshot(path, self.view)
        return Plugin.picture(path)

    def mapper(self):
        """The mapper of the representation that is shown."""
        return self.display.GetClientSideObject().GetActiveRepresentation().GetActor().GetMapper()


class Slices(PictureTest):
    def compare_representations(self, slices):
        """Difference of the two, and of the first from nothing: means of 255."""
        nothing, own = self.draw("Outline"), self.draw("Volume")
        self.display.NumberOfSlices = slices
        self.display.PreIntegration = 0  # a sample each, as ParaView's own
        apart, largest = Plugin.difference(own, self.draw(SLICES))
        echo, _ = Plugin.difference(own, nothing)
        print(f"Volume and {SLICES}, {slices}: mean difference {apart:.3f}, largest {largest:.0f} of "
              f"255; the echo makes a mean of {echo:.2f}")
        self.assertGreater(echo, 1.0)
        return apart, echo

    def test_slices_look_like_paraview_s_own_volume(self):
        # Where nothing was scanned VTK's ray caster leaves out a voxel more than the slices do.
        apart, echo = self.compare_representations(256)
        self.assertLess(apart, 0.08 * echo)

    def test_slices_are_paraview_s_own_volume_where_no_point_is_hidden(self):
        simple.Hide(self.day, self.view)
        passed = simple.PassArrays(Input=self.day, PointDataArrays=["REF"])
        self.show(passed)
        apart, echo = self.compare_representations(512)
        self.assertLess(apart, 0.02 * echo)
        simple.Delete(passed)

    def test_number_of_slices_is_a_property(self):
        fine = self.draw(SLICES)
        # As many as the voxels ask for: a volume of 96 x 96 x 48, seen almost along a side.
        self.assertGreater(self.mapper().GetNumberOfDrawnSlices(), 96)
        self.display.NumberOfSlices = 256
        self.draw(SLICES)
        self.assertEqual(self.mapper().GetNumberOfDrawnSlices(), 256)
        self.display.NumberOfSlices = 12
        coarse = self.draw(SLICES)
        self.assertEqual(self.mapper().GetNumberOfDrawnSlices(), 12)
        self.assertGreater(Plugin.difference(fine, coarse)[0], 0.2)

    def test_pre_integration_is_a_property(self):
        self.display.NumberOfSlices = 32
        integrated = self.draw(SLICES)
        self.assertTrue(self.mapper().GetPreIntegration())
        self.display.PreIntegration = 0
        sampled = self.draw(SLICES)
        self.assertFalse(self.mapper().GetPreIntegration())
        self.assertGreater(Plugin.difference(integrated, sampled)[0], 0.05)

    def test_blend_modes(self):
        pictures = []
        for mode in ("Composite", "Maximum", "Average", "Additive", "Isosurface"):
            self.display.SliceBlendMode = mode
            self.display.IsosurfaceValues = [30.0]
            pictures.append(self.draw(SLICES))
        for i, one in enumerate(pictures):
            for other in pictures[:i]:
                self.assertGreater(Plugin.difference(one, other)[0], 0.2)

    def test_opacity_edit_shows(self):
        before = self.draw(SLICES)
        self.opacity.Points = [35, 0, 0.5, 0, 40, 0.2, 0.5, 0, 55, 0.9, 0.5, 0]
        after, own = self.draw(SLICES), self.draw("Volume")
        self.assertGreater(Plugin.difference(before, after)[0], 1.0)
        self.assertLess(Plugin.difference(own, after)[0], 0.2)

    def test_cropping_as_paraview_s_own(self):
        whole = self.draw(SLICES)
        self.display.UseCropping = 1
        self.display.CroppingScale = [1.0, 0.5, 1.0]
        slices, own = self.draw(SLICES), self.draw("Volume")
        cropped, _ = Plugin.difference(whole, slices)
        self.assertGreater(cropped, 0.5)
        self.assertLess(Plugin.difference(own, slices)[0], 0.2 * cropped)


class Time(PictureTest):
    def test_scene_takes_the_day_s_time_steps_and_plays_them(self):
        self.draw(SLICES)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        steps = list(self.day.TimestepValues)
        self.assertEqual(list(simple.GetTimeKeeper().TimestepValues), steps)
        scene.GoToFirst()
        shown = []
        for step in steps:
            self.assertEqual(self.view.ViewTime, step)
            shown.append(self.draw())
            scene.GoToNext()
        for earlier, later in zip(shown, shown[1:]):
            self.assertGreater(Plugin.difference(earlier, later)[0], 0.05)

    def test_animation_has_a_picture_for_every_step(self):
        self.draw(SLICES)
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        simple.SaveAnimation(os.path.join(self.folder, "day.png"), self.view,
                             FrameWindow=[0, len(self.day.TimestepValues) - 1])
        frames = sorted(glob.glob(os.path.join(self.folder, "day.*.png")))
        self.assertEqual(len(frames), len(self.day.TimestepValues))
        pictures = [Plugin.picture(path) for path in frames]
        self.assertGreater(Plugin.difference(pictures[0], pictures[-1])[0], 0.05)


if __name__ == "__main__":
    unittest.main(verbosity=2)
