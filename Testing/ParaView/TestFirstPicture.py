# SPDX-License-Identifier: BSD-3-Clause
"""What Apply shows of real files, beside the picture of the program's plainest command."""

import os
import subprocess
import tempfile
import unittest

import Plugin
from paraview import servermanager, simple

SIZE = (600, 400)
COLOURED = 40  # of 255: the least difference of the channels of a pixel that has a colour
BAR = 0.85  # of the width: legends stand to the right of it


def measure(pixels):
    """The part of the picture that is echo, in percent, and how bright it is, 0 to 255."""
    pixels = pixels[:, : int(BAR * pixels.shape[1]), :3]
    coloured = pixels.max(axis=2) - pixels.min(axis=2) >= COLOURED
    return 100 * coloured.mean(), pixels.max(axis=2)[coloured].mean()


class FirstPicture(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(self.close)
        self.path = os.path.join(folder.name, "picture.png")
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = SIZE

    def close(self):
        """ParaView crashes at its end when a view with a text is still there."""
        simple.Delete(self.view)
        self.view = None
        simple.ResetSession()

    def file(self, folder, name):
        return next(path for path in Plugin.real_files(folder) if name in path)

    def picture(self):
        simple.SaveScreenshot(self.path, self.view)
        return Plugin.picture(self.path)

    def apply(self, path):
        day = simple.NEXRADRadarDay(FileNames=[path])
        controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
        controller.ShowInPreferredView(day.SMProxy, 0, self.view.SMProxy)
        return simple.GetDisplayProperties(day, self.view)

    def of_program(self, path):
        subprocess.run([os.environ["NEXRAD3D"], "render", path, "-o", self.path, "--size", f"{SIZE[0]}x{SIZE[1]}"],
                       check=True, stdout=subprocess.DEVNULL, timeout=200)
        return Plugin.picture(self.path)

    def compare(self, path, least):
        """At least so many percent are echo, and about as many as in the program's picture."""
        display = self.apply(path)
        covered, brightness = measure(self.picture())
        expected, bright = measure(self.of_program(path))
        print(f"{os.path.basename(path)}: {covered:.1f} % at {brightness:.0f}, of the program {expected:.1f} % at "
              f"{bright:.0f}; stretched {display.Scale[2]:g} times, opacities of {display.ScalarOpacityUnitDistance:.0f} m")
        self.assertGreater(covered, least)
        self.assertLess(abs(covered - expected), 0.35 * expected)
        self.assertGreater(brightness, 140)
        self.assertLess(abs(brightness - bright), 15)
        return display

    def test_supercells_fill_the_picture_and_cast_shadows(self):
        display = self.compare(self.file("legacy", "KTLX19990503"), 20)
        self.assertEqual(display.Scale[2], 3)
        lit = self.picture()
        display.ShadowStrength = display.AmbientOcclusionStrength = 0
        unlit = self.picture()
        ground = (lit.max(axis=2) - lit.min(axis=2) < 12) & (unlit.max(axis=2) - unlit.min(axis=2) < 12)
        shadow = 100 * (ground & (lit.max(axis=2) < 0.8 * unlit.max(axis=2))).mean()
        print(f"{shadow:.1f} % of the picture is ground that lies in the shadow")
        self.assertGreater(shadow, 0.5)

    def test_weak_echo_is_seen_as_well(self):
        display = self.compare(self.file("pairs", "KVBX20190501_093433"), 12)
        self.assertLess(display.ScalarOpacityUnitDistance, 1000)

    def test_an_empty_picture_says_what_there_is(self):
        day = simple.NEXRADRadarDay(FileNames=[self.file("tdwr", "TSTL")])
        words = Plugin.fetch(simple.NEXRADTime(Input=day), day.TimestepValues[0]).GetColumn(0).GetValue(0)
        print(words)
        self.assertRegex(words, r'TSTL\nHardly any echo above 5 dBZ; .*preset "clear air"')


if __name__ == "__main__":
    unittest.main(verbosity=2)
