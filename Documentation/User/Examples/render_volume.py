# SPDX-License-Identifier: BSD-3-Clause
"""Draws a merged volume, off screen: render_volume.py VOLUME.nxv PICTURE.png [PRESET]"""

import argparse
import sys

import vtknexrad
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkRenderer, vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)


def arguments():
    look = vtknexrad.vtkNexradTransferFunction
    presets = [look.GetPresetName(index) for index in range(look.GetNumberOfPresets())]
    parser = argparse.ArgumentParser(description="Draws a merged volume, off screen.")
    parser.add_argument("volume", metavar="VOLUME.nxv", help="merged volume")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("preset", metavar="PRESET", nargs="?", default="all echo", choices=presets,
                        help=f"{', '.join(presets)} (default all echo)")
    return parser.parse_args()


def main():
    given = arguments()
    reader = vtknexrad.vtkNexradVolumeReader()
    reader.SetFileName(given.volume)
    vtknexrad.update(reader)  # an error in the file stops here, in one line

    mapper = vtknexrad.vtkOpenGLTextureSliceVolumeMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    mapper.SetNumberOfSlices(256)

    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetScale(1.0, 1.0, 8.0)  # heights stretched eight times
    volume.GetProperty().SetScalarOpacityUnitDistance(5000.0)  # m
    volume.GetProperty().SetInterpolationTypeToLinear()
    look = vtknexrad.vtkNexradTransferFunction()
    look.ApplyPreset(given.preset)
    look.FillProperty(volume.GetProperty())

    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Elevation(-50.0)
    renderer.GetActiveCamera().Zoom(1.6)
    renderer.ResetCameraClippingRange()
    window.Render()

    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetFileName(given.picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"render_volume.py: {error}")
