# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvbatch in any number of processes: writes a picture of each time step of a radar day.

    pvbatch animate_day.py OUTPUT FILE...
"""

import os
import sys

from paraview import simple

simple.LoadPlugin(os.environ["NEXRAD_PLUGIN"], remote=False, ns=vars(simple))
day = simple.NEXRADRadarDay(FileNames=sys.argv[2:], Dimensions=[96, 96, 48])
view = simple.CreateView("RenderView")
view.ViewSize = [400, 300]
display = simple.Show(day, view)
simple.ColorBy(display, ("POINTS", "REF"))
for function in (simple.GetColorTransferFunction("REF"), simple.GetOpacityTransferFunction("REF")):
    function.ApplyPreset("NEXRAD all echo", False)
display.SetRepresentationType("Volume (slices)")
display.ScalarOpacityUnitDistance = 5000
display.ShadowStrength = display.AmbientOcclusionStrength = 0  # each process would shade its part alone
display.Scale = [1, 1, 10]
view.CameraViewUp = [0, 0, 1]
view.CameraFocalPoint = [0, 0, 60e3]
view.CameraPosition = [-150e3, -800e3, 500e3]
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
simple.SaveAnimation(os.path.join(sys.argv[1], "day.png"), view,
                     FrameWindow=[0, len(day.TimestepValues) - 1])
