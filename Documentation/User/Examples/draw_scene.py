# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture that `nexrad3d render` draws, off screen: draw_scene.py INPUT PICTURE.png

INPUT is a merged volume or a folder of them, or a folder of radar files, which are merged first. The
picture shows the first time.
"""

import argparse
import sys

import vtknexrad
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter


def arguments():
    parser = argparse.ArgumentParser(description="Draws the picture that nexrad3d render draws, off screen.")
    parser.add_argument("input", metavar="INPUT", help="merged volume, or a folder of volumes or radar files")
    parser.add_argument("picture", metavar="PICTURE.png")
    return parser.parse_args()


def main():
    given = arguments()
    session = vtknexrad.vtkNexradSession()
    session.AddFileName(given.input)
    with vtknexrad.errors_of(session):  # an error in the file ends here, in one line
        session.ShowTimeStep(0)

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
    writer.SetFileName(given.picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"draw_scene.py: {error}")
