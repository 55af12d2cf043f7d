# SPDX-License-Identifier: BSD-3-Clause
"""Draws a binary glTF file of surfaces as VTK reads it, off screen: draw_model.py STORM.glb PICTURE.png"""

import argparse
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  draws
from vtkmodules.vtkIOGeometry import vtkGLTFReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)


def arguments():
    parser = argparse.ArgumentParser(description="Draws a binary glTF file of surfaces as VTK reads it, off screen.")
    parser.add_argument("model", metavar="STORM.glb")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("--azimuth", type=float, default=0.0, metavar="DEGREES",
                        help="how far the camera goes round from south to east (default 0)")
    parser.add_argument("--elevation", type=float, default=30.0, metavar="DEGREES")
    parser.add_argument("--zoom", type=float, default=1.6, metavar="FACTOR")
    return parser.parse_args()


def meshes(path):
    """The meshes of a file. The reader has no one line for a file that is none."""
    with open(path, "rb") as file:
        if file.read(4) != b"glTF":
            raise OSError(f"{path}: is no binary glTF file")
    reader = vtkGLTFReader()
    reader.SetFileName(path)
    reader.Update()
    blocks = reader.GetOutput().NewIterator()
    blocks.InitTraversal()
    while not blocks.IsDoneWithTraversal():
        yield blocks.GetCurrentDataObject()
        blocks.GoToNextItem()


def shown(light):
    """The sRGB value of a screen for an amount of light, both 0 to 1: colours of glTF are amounts of light."""
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1.0 / 2.4) - 0.055


def actor_of(mesh):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    *light, opacity = mesh.GetFieldData().GetArray("BaseColorMultiplier").GetTuple(0)
    actor.GetProperty().SetColor([shown(one) for one in light])
    actor.GetProperty().SetOpacity(opacity)
    if mesh.GetPointData().GetNormals() is None:
        actor.GetProperty().LightingOff()  # ground and map
    return actor


def main():
    given = arguments()
    renderer = vtkRenderer()
    renderer.SetBackground(0.93, 0.95, 0.98)
    renderer.SetUseDepthPeeling(True)  # surfaces behind each other
    renderer.SetMaximumNumberOfPeels(20)
    renderer.SetOcclusionRatio(0.0)
    for mesh in meshes(given.model):
        renderer.AddActor(actor_of(mesh))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(1280, 720)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(True)
    window.AddRenderer(renderer)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.0, 0.0, 1.0)  # south of the storm, y up
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    camera.Elevation(given.elevation)
    camera.Azimuth(given.azimuth)
    renderer.ResetCamera()
    camera.Zoom(given.zoom)
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
    except OSError as error:
        sys.exit(f"draw_model.py: {error}")
