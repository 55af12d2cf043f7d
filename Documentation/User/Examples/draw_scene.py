# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture that `nexrad3d render` draws, off screen: draw_scene.py INPUT PICTURE.png

INPUT is a merged volume or a folder of them, or a folder of radar files, which are merged first. The
picture shows the first time.
"""

import sys

import vtknexrad
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter


def main():
    session = vtknexrad.vtkNexradSession()
    session.AddFileName(sys.argv[1])
    if not session.ShowTimeStep(0):
        sys.exit("nothing to draw")

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(4)
    window.SetSize(1280, 720)
    window.AddRenderer(session.GetScene().GetRenderer())
    window.Render()

    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()  # the front buffer of a window off screen has no smooth edges
    writer = vtkPNGWriter()
    writer.SetFileName(sys.argv[2])
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
