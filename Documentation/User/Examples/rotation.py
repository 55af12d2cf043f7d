# SPDX-License-Identifier: BSD-3-Clause
"""Draws the rotation inside storms: rotation.py VOLUME.nxv PICTURE.png [SHEAR]

VOLUME has the moments REF and AZSHEAR (`nexrad3d grid --moment REF,AZSHEAR`). The picture shows the
reflectivity as a veil, and in it the surface of the azimuthal shear of SHEAR per second (0.01 unless
said, that of a mesocyclone) in echo of 20 dBZ and more. Surfaces that are less than 3 km high are
left out: they are gust fronts and noise.
"""

import argparse
import sys

import numpy
import vtknexrad
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (vtkFlyingEdges3D, vtkPolyDataConnectivityFilter,
                                       vtkWindowedSincPolyDataFilter)
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)

LEAST_HEIGHT = 3000.0  # m
LEAST_ECHO = 20.0  # dBZ
VEIL = ((15.0, 0.0), (20.0, 0.02), (35.0, 0.07), (45.0, 0.2), (60.0, 0.5))  # dBZ, opacity


def shear_in_echo(volume):
    """The grid of the volume with the shear where there is echo, and 0 elsewhere."""
    echo = ((vtknexrad.array(volume, "AZSHEAR_state") == 0) & (vtknexrad.array(volume, "REF_state") == 0)
            & (vtknexrad.array(volume, "REF") >= LEAST_ECHO))
    shear = numpy.where(echo, vtknexrad.array(volume, "AZSHEAR"), 0.0)
    grid = volume.NewInstance()
    grid.CopyStructure(volume)
    grid.GetPointData().SetScalars(numpy_to_vtk(shear.ravel(), deep=True))
    return grid


def high_surface(volume, shear):
    """The filter that gives the surface of a shear without its low parts, and their number."""
    surface = vtkFlyingEdges3D()
    surface.SetInputData(shear_in_echo(volume))
    surface.SetValue(0, shear)
    smooth = vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(surface.GetOutputPort())
    smooth.NormalizeCoordinatesOn()
    parts = vtkPolyDataConnectivityFilter()
    parts.SetInputConnection(smooth.GetOutputPort())
    parts.SetExtractionModeToAllRegions()
    parts.ColorRegionsOn()
    parts.Update()
    numbers = vtk_to_numpy(parts.GetOutput().GetPointData().GetArray("RegionId"))
    heights = vtk_to_numpy(parts.GetOutput().GetPoints().GetData())[:, 2]
    high = [part for part in range(parts.GetNumberOfExtractedRegions())
            if numpy.ptp(heights[numbers == part]) >= LEAST_HEIGHT]
    parts.ColorRegionsOff()
    parts.SetExtractionModeToSpecifiedRegions()
    parts.InitializeSpecifiedRegionList()
    for part in high:
        parts.AddSpecifiedRegion(part)
    parts.Update()
    return parts, len(high)


def volume_to_scene(scene):
    """The transform of the volume's coordinates to those of the scene, which has been drawn."""
    zero, one = [0.0] * 3, [0.0] * 3
    scene.VolumeToScene((0.0, 0.0, 0.0), zero)
    scene.VolumeToScene((1000.0, 1000.0, 1000.0), one)
    transform = vtkTransform()
    transform.Translate(zero)
    transform.Scale([(b - a) / 1000.0 for a, b in zip(zero, one)])
    return transform


def arguments():
    parser = argparse.ArgumentParser(description="Draws the rotation inside storms.")
    parser.add_argument("volume", metavar="VOLUME.nxv", help="merged volume with the moments REF and AZSHEAR")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("shear", metavar="SHEAR", nargs="?", type=float, default=0.01, help="per second (default 0.01)")
    return parser.parse_args()


def main():
    given = arguments()
    shear = given.shear
    volume = vtknexrad.Volume.open(given.volume, moments="REF,AZSHEAR").image
    scene = vtknexrad.vtkNexradVolumeScene()
    scene.SetVolume(volume)
    scene.SetAzimuth(165.0)
    scene.SetTilt(14.0)
    scene.SetZoom(1.25)

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(4)
    window.SetSize(1280, 720)
    window.AddRenderer(scene.GetRenderer())
    window.Render()
    veil = scene.GetTransferFunction()
    veil.RemoveAllNodes(veil.OPACITY)
    for reflectivity, opacity in VEIL:
        veil.AddNode(veil.OPACITY, reflectivity, opacity)

    surface, count = high_surface(volume, shear)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    rotation = vtkActor()
    rotation.SetMapper(mapper)
    rotation.SetUserTransform(volume_to_scene(scene))
    rotation.GetProperty().SetAmbient(0.1)
    rotation.GetProperty().SetColor(0.85, 0.85, 0.85)
    scene.GetRenderer().AddActor(rotation)
    caption = vtkTextActor()
    caption.SetInput(f"Grey: azimuthal shear of {shear:g}/s and more")
    caption.SetPosition(26, 606)
    caption.GetTextProperty().SetFontSize(18)
    caption.GetTextProperty().SetColor(0.3, 0.3, 0.3)
    scene.GetRenderer().AddActor(caption)
    window.Render()

    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(given.picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    print(f"surfaces of {shear:g}/s that are at least {LEAST_HEIGHT / 1000:g} km high: {count}")


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"rotation.py: {error}")
