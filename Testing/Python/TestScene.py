# SPDX-License-Identifier: BSD-3-Clause
"""Scene and session: the pictures of `nexrad3d render`, drawn in Python."""

import datetime
import functools
import os
import subprocess
import unittest

import numpy
import vtknexrad
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

import SyntheticFiles
from Tolerance import at_least

SIZE = (320, 240)


@functools.lru_cache(maxsize=None)
def volumes():
    """A folder of merged volumes with ancillary arrays."""
    folder = os.path.join(SyntheticFiles.folder(), "scene")
    subprocess.run([os.environ["NEXRAD3D"], "grid", *SyntheticFiles.files(), "-o", folder, "--dims",
                    "64x64x32", "--ancillary", "--quiet"], check=True)
    return folder


def times(folder):
    """Names and times of the volumes in a folder."""
    names = sorted(name for name in os.listdir(folder) if name.endswith(".nxv"))
    read = [datetime.datetime.strptime(name, "%Y%m%dT%H%M%SZ.nxv") for name in names]
    return [time.replace(tzinfo=datetime.timezone.utc) for time in read]


def pixels(image):
    return vtk_to_numpy(image.GetPointData().GetScalars())


def program_picture(source, time, *options):
    """What `nexrad3d render` draws of a time, one row a pixel."""
    path = os.path.join(SyntheticFiles.folder(), "render.png")
    subprocess.run([os.environ["NEXRAD3D"], "render", *source, "-o", path, "--size", "%dx%d" % SIZE,
                    "--time", f"{time:%Y-%m-%dT%H:%M:%S}", "--quiet", *options], check=True)
    reader = vtkPNGReader()
    reader.SetFileName(path)
    return pixels(vtknexrad.update(reader))


def picture(session, size=SIZE):
    """What the session's scene shows in a window off screen."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(4)
    window.SetSize(*size)
    window.AddRenderer(session.GetScene().GetRenderer())
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    return pixels(vtknexrad.update(image))


class Pictures(unittest.TestCase):
    def draw(self, settings, *options):
        session = vtknexrad.vtkNexradSession()
        session.AddFileName(volumes())
        settings(session.GetScene())
        self.assertTrue(session.ShowTimeStep(1))
        session.GetScene().ClearFrame()  # a session frames all of its times, a picture of one time that time
        drawn = picture(session)
        numpy.testing.assert_array_equal(
            drawn, program_picture([volumes()], times(volumes())[1], *options))
        return drawn

    def test_the_usual_picture(self):
        drawn = self.draw(lambda scene: None)
        at_least(self, len(numpy.unique(drawn, axis=0)), 4000, "colours of the picture")

    def test_camera_and_appearance(self):
        def settings(scene):
            scene.SetAzimuth(140.0)
            scene.SetTilt(50.0)
            scene.SetZoom(1.5)
            scene.ParallelProjectionOn()
            scene.SetPreset("storm cores")
            scene.SetOption("exaggeration", 5.0)
            scene.SetOption("slices", "100")
            scene.SetOption("classification", "sampled")
            scene.SetOption("rings", 50000.0)
            scene.SetOption("theme", "light")
            scene.SetOption("walls", "off")
            scene.SetOption("names", "on")
            scene.SetOption("shadow", 0.6)
            scene.SetOption("occlusion", 0.4)
            scene.SetOption("light", "300,30")
        self.draw(settings, "--azimuth", "140", "--tilt", "50", "--zoom", "1.5", "--parallel", "--preset",
                  "storm cores", "--exaggeration", "5", "--slices", "100", "--rings", "50km",
                  "--theme", "light", "--no-walls", "--names",
                  "--shadow", "0.6", "--occlusion", "0.4", "--light", "300,30",
                  "--classification", "sampled")

    def test_a_place_in_the_middle(self):
        def settings(scene):
            scene.SetZoom(4.0)
            scene.SetLookAtGeographic(38.8, -94.3, 4000.0)
        drawn = self.draw(settings, "--zoom", "4", "--look-at", "38.8,-94.3,4km")
        self.assertTrue((drawn != self.draw(lambda scene: scene.SetZoom(4.0), "--zoom", "4")).any())

    def test_two_fields(self):
        drawn = self.draw(lambda scene: scene.SetOption("colour-by", "REF_age"), "--colour-by", "REF_age")
        self.assertTrue((drawn != self.draw(lambda scene: None)).any())

    def test_crop_and_clip(self):
        def settings(scene):
            scene.CroppingOn()
            scene.SetCropBounds(-60e3, 40e3, -200e3, 200e3, 0.0, 9e3)
            scene.ClippingOn()
            scene.SetClipOrigin(-20e3, 5e3, 0.0)
            scene.SetClipNormal(0.0, -1.0, 0.0)
        drawn = self.draw(settings, "--crop=-60km,40km,-200km,200km,0,9km", "--clip=-20km,5km,180")
        self.assertTrue((drawn != self.draw(lambda scene: None)).any())

    def test_a_vertical_section(self):
        session = vtknexrad.vtkNexradSession()
        session.AddFileName(volumes())
        self.assertTrue(session.ShowTimeStep(1))
        section = vtknexrad.vtkNexradVerticalSection()
        section.SetInputData(session.GetScene().GetVolume())
        section.SetA(-100e3, 0.0)
        section.SetB(100e3, 50e3)
        values = vtknexrad.array(vtknexrad.update(section))
        self.assertEqual(values.shape, (256, 512))
        at_least(self, numpy.nanmax(values), 20.0, "largest value of a section, dBZ")

    def test_plan_views(self):
        def settings(plan, array=""):
            def apply(scene):
                scene.SetOption("map", plan)
                scene.SetOption("array", array)
                scene.SetCameraFromAbove()
            return apply
        composite = self.draw(settings("composite"), "--map", "composite")
        lowest = self.draw(settings("lowest"), "--map", "lowest")
        self.assertTrue((composite != lowest).any())
        self.draw(settings("3km"), "--map", "3km")
        self.draw(settings("echo-top"), "--map", "echo-top")
        self.draw(settings("vil"), "--map", "vil")
        self.draw(settings("vil-density"), "--map", "vil-density")
        self.draw(settings("3km", "REF_age"), "--map", "3km", "--array", "REF_age")

    def test_what_is_seen_at_a_pixel(self):
        session = vtknexrad.vtkNexradSession()
        session.AddFileName(volumes())
        self.assertTrue(session.ShowTimeStep(1))
        scene = session.GetScene()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetSize(*SIZE)
        window.AddRenderer(scene.GetRenderer())
        window.Render()
        picker = vtknexrad.vtkNexradEchoPicker()
        picker.SetScene(scene)
        pixels_of_picture = [(x, y) for x in range(0, SIZE[0], 10) for y in range(0, SIZE[1], 10)]
        found = [picker.Pick(x, y, 0.0, scene.GetRenderer()) for x, y in pixels_of_picture]
        for kind in (picker.NOTHING, picker.GROUND, picker.ECHO):
            self.assertIn(kind, found)
        x, y = pixels_of_picture[found.index(picker.ECHO)]
        picker.Pick(x, y, 0.0, scene.GetRenderer())
        self.assertIn("dBZ (REF)", picker.GetText())
        self.assertGreaterEqual(picker.GetNumberOfRadars(), 1)
        navigator = vtknexrad.vtkNexradNavigator()
        navigator.SetScene(scene)
        self.assertEqual(navigator.CentreOn(x, y), picker.ECHO)
        place = [0.0, 0.0, 0.0]
        self.assertTrue(scene.GetLookAt(place))
        self.assertEqual(tuple(place), picker.GetPlace())
        del window
        self.assertEqual(picker.Pick(x, y, 0.0, scene.GetRenderer()), picker.NOTHING)

    def test_a_finer_box(self):
        session = vtknexrad.vtkNexradSession()
        for path in SyntheticFiles.files():
            session.AddFileName(path)
        session.GetDayReader().SetDimensions(48, 48, 24)
        self.assertTrue(session.ShowTimeStep(0))
        coarse = picture(session)
        box = vtkImageData()
        time = vtknexrad.time_steps(session.GetDayReader())[0].timestamp()
        self.assertTrue(session.GetDayReader().MergeBox(time, (-60e3, 60e3, -60e3, 60e3), box))
        self.assertEqual(box.GetDimensions(), (240, 240, 80))
        session.GetScene().SetDetail(box)
        self.assertTrue((picture(session) != coarse).any())

    def test_radar_files(self):
        session = vtknexrad.vtkNexradSession()
        for path in SyntheticFiles.files():
            session.AddFileName(path)
        session.GetDayReader().SetDimensions(48, 48, 24)
        session.GetDayReader().SetOption("sharpening", "off")
        self.assertTrue(session.ShowTimeStep(0))
        session.GetScene().ClearFrame()
        steps = vtknexrad.time_steps(session.GetDayReader())
        numpy.testing.assert_array_equal(
            picture(session),
            program_picture(SyntheticFiles.files(), steps[0], "--dims", "48x48x24", "--no-sharpening"))
        # Settings of the reader that change open the files again.
        session.GetDayReader().SetDimensions(32, 32, 16)
        self.assertTrue(session.ShowTimeStep(0))
        self.assertEqual(session.GetScene().GetVolume().GetDimensions(), (32, 32, 16))


class Sessions(unittest.TestCase):
    def test_times(self):
        session = vtknexrad.vtkNexradSession()
        session.AddFileName(volumes())
        steps = vtk_to_numpy(session.GetTimeSteps())
        self.assertEqual(list(steps), [time.timestamp() for time in times(volumes())])
        self.assertTrue(session.ShowTime(steps[1] + 1.0))
        self.assertEqual(session.GetTimeStepIndex(), 1)

    def test_playing_back_and_forth(self):
        session = vtknexrad.vtkNexradSession()
        session.AddFileName(volumes())
        drawn = {}
        for step in (0, 1, 0, 1, 1, 0):
            self.assertTrue(session.ShowTimeStep(step))
            numpy.testing.assert_array_equal(drawn.setdefault(step, picture(session)), picture(session))
        self.assertTrue((drawn[0] != drawn[1]).any())


if __name__ == "__main__":
    unittest.main()
