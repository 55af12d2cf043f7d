# SPDX-License-Identifier: BSD-3-Clause
"""Draws a volume without radar data by slices: slices_in_vtk.py PICTURE.png

After Activate, VTK creates the texture-slice mapper wherever a vtkGPUVolumeRayCastMapper is requested.
The script below does not name the mapper.
"""

import argparse

import vtknexrad
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper


def arguments():
    parser = argparse.ArgumentParser(description="Draws a volume without radar data by slices.")
    parser.add_argument("picture", metavar="PICTURE.png")
    return parser.parse_args()


def main():
    given = arguments()
    vtknexrad.vtkTextureSliceObjectFactory.Activate()

    wavelet = vtkRTAnalyticSource()
    mapper = vtkSmartVolumeMapper()
    mapper.SetInputConnection(wavelet.GetOutputPort())
    mapper.SetRequestedRenderModeToGPU()

    colour = vtkColorTransferFunction()
    colour.AddRGBPoint(40.0, 0.23, 0.30, 0.75)
    colour.AddRGBPoint(160.0, 0.87, 0.87, 0.87)
    colour.AddRGBPoint(280.0, 0.71, 0.02, 0.15)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(120.0, 0.0)
    opacity.AddPoint(280.0, 0.6)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetInterpolationTypeToLinear()
    volume.GetProperty().ShadeOn()

    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(400, 400)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    window.Render()

    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetFileName(given.picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
