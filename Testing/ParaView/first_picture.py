# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: prints how many seconds pass from opening radar files to their first picture, and in what.

    NEXRAD_PLUGIN=PLUGIN Utilities/run-with-paraview pvpython Testing/ParaView/first_picture.py PICTURE FILE_OR_FOLDER...

The clock starts when ParaView and the plugin are loaded and a view of 1200x800 points was drawn empty, as ParaView's
window has it before a person presses Apply. Writes the view to the file PICTURE.
"""

import os
import sys
import time

from paraview import simple

simple.LoadPlugin(os.environ["NEXRAD_PLUGIN"], remote=False, ns=vars(simple))
view = simple.CreateView("RenderView")
view.ViewSize = [1200, 800]
simple.Render(view)
scene = simple.GetAnimationScene()
start = time.monotonic()
begun = start


def say(what):
    global begun
    now = time.monotonic()
    print(f"{what}: {now - begun:.2f} s")
    begun = now


day = simple.NEXRADRadarDay(FileNames=sys.argv[2:])
scene.UpdateAnimationUsingDataTimeSteps()
say("files and times")
simple.Show(day, view)
say("first volume, and what shows it")
simple.Render(view)
say("first picture")
print(f"from the start to the first picture: {begun - start:.2f} s, {len(day.TimestepValues)} times")
simple.SaveScreenshot(sys.argv[1], view)
