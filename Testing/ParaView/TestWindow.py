# SPDX-License-Identifier: BSD-3-Clause
"""From ParaView's start to a lit storm over its map by mouse, in at most six actions."""

import os
import shutil
import tempfile
import unittest

import Plugin
import SyntheticFiles
import Window


@unittest.skipUnless(os.environ.get("DISPLAY") and all(map(shutil.which, ("xdotool", "import", "paraview"))),
                     "a display, xdotool, ImageMagick and ParaView's window are needed")
class Guide(unittest.TestCase):
    def test_files_of_the_archive_become_one_lit_day_in_six_actions(self):
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as home:
            files = SyntheticFiles.files()
            for path in files:
                shutil.copy(path, os.path.join(folder, os.path.basename(path) + "_V06"))
            picture = os.path.join(home, "window.png")
            with Window.Window(os.environ["NEXRAD_PLUGIN"], folder, home) as window:
                Window.open_day(window, len(files))
                window.picture(picture)
                self.assertLessEqual(len(window.actions), 6)
            # The view below its buttons; rows count from below.
            view = Plugin.picture(picture)[-760:-215, 320:1150, :3]
            light = (view.min(axis=2) > 200).mean()
            coloured = (view.max(axis=2) - view.min(axis=2) > 60).mean()
            print(f"{100 * light:.0f} % of the view is light, {100 * coloured:.1f} % is coloured")
            self.assertGreater(light, 0.4)
            self.assertGreater(coloured, 0.06)


if __name__ == "__main__":
    unittest.main(verbosity=2)
