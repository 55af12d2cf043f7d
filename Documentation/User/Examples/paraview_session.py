# SPDX-License-Identifier: BSD-3-Clause
"""A session in ParaView: shows radar days as volumes, writes an animation, saves the state and opens it again.

    pvpython paraview_session.py PLUGIN FOLDER OUTPUT       FOLDER contains the folders RADARS and STORM
    pvpython paraview_session.py PLUGIN OUTPUT              opens the state that the first run saved

PLUGIN is the path of VTKNexrad.so. The menus of ParaView have every step as well.
"""

import os
import sys

from paraview.simple import *

RADARS, STORM = "multisite-20100911", "run-kbgm-20050821"


def load_plugin(path):
    LoadPlugin(path, remote=False, ns=globals())


def open_day(folder, **settings):
    """Opens all files of a folder, of any number of radars, as one source."""
    day = NEXRADRadarDay(registrationName="Day", FileNames=[folder], **settings)
    day.UpdatePipelineInformation()
    return day


def show(day, view, representation, colours):
    display = Show(day, view)  # coloured, lit, framed
    for function in (GetColorTransferFunction("REF"), GetOpacityTransferFunction("REF")):
        function.ApplyPreset(colours, False)
    display.SetRepresentationType(representation)
    display.SetScalarBarVisibility(view, True)
    return display


def save_picture(view, output, name):
    SaveScreenshot(os.path.join(output, name + ".png"), view)


def several_radars(folder, output):
    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = [900, 600]
    day = open_day(os.path.join(folder, RADARS), MaximumGap=2700)
    GetAnimationScene().AnimationTime = day.TimestepValues[len(day.TimestepValues) // 2]
    show(day, view, "Volume (slices)", "NEXRAD all echo")
    save_picture(view, output, "radars-slices")
    Delete(day)


def sweeps(folder, output):
    view = GetActiveViewOrCreate("RenderView")
    reader = NEXRADLevelIISeries(FileNames=[os.path.join(folder, STORM)])
    reader.Moments = ["REF"]  # moments with other gates are separate grids at the same places
    view.ViewTime = reader.TimestepValues[1]
    display = Show(reader, view)  # the first cut alone
    display.BlockSelectors = ["/"]  # all of them
    GetColorTransferFunction("REF").ApplyPreset("NEXRAD clear air", False)
    view.CameraViewUp = [0, 0, 1]
    view.CameraFocalPoint = [-60e3, 0, 20e3]
    view.CameraPosition = [-120e3, -420e3, 280e3]
    save_picture(view, output, "storm-sweeps")
    Delete(reader)


def storm_in_time(folder, output):
    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = [900, 600]
    day = open_day(os.path.join(folder, STORM))
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToFirst()
    display = show(day, view, "Volume (slices)", "NEXRAD all echo")
    Show(NEXRADMap(Input=day), view)
    save_picture(view, output, "storm-first")
    scene.GoToNext()
    scene.GoToNext()
    save_picture(view, output, "storm-slices")
    display.SetRepresentationType("Volume")
    save_picture(view, output, "storm-paraview")

    display.SetRepresentationType("Volume (slices)")
    display.NumberOfSlices = 512
    opacity = GetOpacityTransferFunction("REF")  # shows echo above 35 dBZ: value, opacity, midpoint, sharpness
    opacity.Points = [35, 0, 0.5, 0, 40, 0.2, 0.5, 0, 55, 0.9, 0.5, 0]
    save_picture(view, output, "storm-cores")

    SetActiveSource(day)
    SaveState(os.path.join(output, "session.pvsm"))
    SaveAnimation(os.path.join(output, "storm.ogv"), view, FrameRate=2)


def again(output):
    LoadState(os.path.join(output, "session.pvsm"))
    SetActiveSource(FindSource("Day"))
    save_picture(GetRenderViews()[0], output, "storm-again")


if __name__ == "__main__":
    load_plugin(sys.argv[1])
    if len(sys.argv) == 4:
        several_radars(sys.argv[2], sys.argv[3])
        sweeps(sys.argv[2], sys.argv[3])
        storm_in_time(sys.argv[2], sys.argv[3])
    else:
        again(sys.argv[2])
