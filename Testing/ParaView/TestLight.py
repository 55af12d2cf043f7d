# SPDX-License-Identifier: BSD-3-Clause
"""Shadows beside those of VTK's ray caster, which has them from VTK 9.2 on: synthetic storms, lit from the side."""

import statistics
import time
import unittest

import Plugin  # noqa: F401  (the plugin's classes need it)
import numpy
import vtknexrad
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (vtkColorTransferFunction, vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume,
                                         vtkVolumeProperty, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

TO_LIGHT = (-1.0, -0.3, 1.0)
COLORS = [(5, 0.02, 0.91, 0.91), (20, 0.01, 0.60, 0.96), (30, 0.01, 0.80, 0.01), (40, 0.99, 0.97, 0.01),
          (50, 0.99, 0.10, 0.00), (60, 0.97, 0.00, 0.99)]
OPACITIES = [(5, 0.0), (20, 0.03), (40, 0.15), (60, 0.6)]  # of one length unit


# The highest dBZ, centre and radii in a box of 1 x 1 x 1: a core, its anvil, two showers; and a round cell alone.
STORM = [(62, (0.45, 0.50, 0.35), (0.16, 0.16, 0.45)), (35, (0.60, 0.55, 0.80), (0.30, 0.20, 0.15)),
         (48, (0.25, 0.30, 0.20), (0.08, 0.10, 0.30)), (50, (0.75, 0.30, 0.25), (0.06, 0.06, 0.35))]
CELL = [(55, (0.5, 0.5, 0.5), (0.16, 0.16, 0.30))]


def make_image(bumps, size=128):
    """Reflectivity, dBZ, in a box of 64 x 64 x 24 length units."""
    height = size // 2
    z, y, x = numpy.meshgrid(*(numpy.linspace(0, 1, n) for n in (height, size, size)), indexing="ij")

    dBZ = numpy.maximum.reduce([
        top * numpy.exp(-sum(((axis - c) / r) ** 2 for axis, c, r in zip((x, y, z), centre, radii)))
        for top, centre, radii in bumps])
    image = vtkImageData()
    image.SetDimensions(size, size, height)
    image.SetSpacing(64 / (size - 1), 64 / (size - 1), 24 / (height - 1))
    image.SetOrigin(-32, -32, 0)
    image.GetPointData().SetScalars(numpy_to_vtk(dBZ.astype(numpy.float32).ravel(), deep=True))
    return image


def make_mappers(image):
    theirs = vtkOpenGLGPUVolumeRayCastMapper()
    theirs.AutoAdjustSampleDistancesOff()
    theirs.SetSampleDistance(0.3)
    ours = vtknexrad.vtkOpenGLTextureSliceVolumeMapper()
    ours.SetLightDirection(*TO_LIGHT)
    for mapper in (theirs, ours):
        mapper.SetInputData(image)
    return theirs, ours


class Stage:
    """A volume in a window, with one light, drawn by the ray caster and as slices."""

    def __init__(self, bumps):
        self.mappers = make_mappers(make_image(bumps))
        color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
        for point in COLORS:
            color.AddRGBPoint(*point)
        for point in OPACITIES:
            opacity.AddPoint(*point)
        self.property = vtkVolumeProperty()
        self.property.SetColor(color)
        self.property.SetScalarOpacity(opacity)
        self.property.SetInterpolationTypeToLinear()
        self.property.SetAmbient(0.0)
        self.property.SetDiffuse(1.0)
        self.property.SetSpecular(0.0)
        self.volume = vtkVolume()
        self.volume.SetProperty(self.property)
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetFocalPoint(0, 0, 0)
        light.SetPosition(*(100 * along for along in TO_LIGHT))
        self.renderer = vtkRenderer()
        self.renderer.AddLight(light)
        self.renderer.AddVolume(self.volume)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(400, 300)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(0, 0, 12)
        camera.SetPosition(50, -90, 70)
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCameraClippingRange()
        self.unlit = [self.draw(mapper, False) for mapper in self.mappers]

    def draw(self, mapper, shadows):
        """Brightness of each pixel, and the median milliseconds of a frame while the camera moves."""
        self.volume.SetMapper(mapper)
        slices = mapper is self.mappers[1]
        # The ray caster casts shadows on what it shades, and has no surfaces where all light is scattered.
        self.property.SetShade(shadows and not slices)
        if slices:
            mapper.SetShadowStrength(1.0 if shadows else 0.0)
        else:
            mapper.SetVolumetricScatteringBlending(2.0 if shadows else 0.0)
            mapper.SetGlobalIlluminationReach(1.0)
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        times = []
        for _ in range(5):
            self.renderer.GetActiveCamera().Azimuth(1e-9)
            start = time.perf_counter()
            self.window.Render()
            self.window.WaitForCompletion()
            times.append(1000 * (time.perf_counter() - start))
        pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).astype(float)
        return pixels[:, :3].sum(axis=1).reshape(300, 400), statistics.median(times)


@unittest.skipUnless(hasattr(vtkOpenGLGPUVolumeRayCastMapper, "SetGlobalIlluminationReach"),
                     "this VTK's ray caster casts no shadows: 9.2 and later do")
class Shadows(unittest.TestCase):
    def compare(self, stage, correlation, difference):
        """What is covered, and how bright it is in shadow over what it is without: ray caster, slices."""
        lit = [stage.draw(mapper, True) for mapper in stage.mappers]
        (theirs, their_time), (ours, our_time) = lit
        print(f"a frame of the ray caster {their_time:.0f} ms (unlit "
              f"{stage.unlit[0][1]:.0f}), of slices {our_time:.0f} ms (unlit {stage.unlit[1][1]:.0f})")
        covered = numpy.minimum(stage.unlit[0][0], stage.unlit[1][0]) > 60
        self.assertGreater(covered.mean(), 0.05)
        theirs, ours = (one[0] / numpy.maximum(unlit[0], 1.0) for one, unlit in zip(lit, stage.unlit))
        measured = numpy.corrcoef(theirs[covered], ours[covered])[0, 1]
        apart = abs(theirs[covered] - ours[covered]).mean()
        print(f"correlation of the shading {measured:.4f}, mean difference {apart:.4f}")
        self.assertGreater(measured, correlation)
        self.assertLess(apart, difference)
        return covered, theirs, ours

    def test_the_storm_is_shaded_alike(self):
        self.compare(Stage(STORM), 0.996, 0.06)

    def test_the_same_side_of_a_cell_is_in_shadow(self):
        covered, *shades = self.compare(Stage(CELL), 0.997, 0.07)
        columns = numpy.arange(covered.shape[1])
        middle = numpy.median(numpy.nonzero(covered)[1])
        for shade in shades:
            left, right = shade[covered & (columns < middle)].mean(), shade[covered & (columns > middle)].mean()
            print(f"brightness of the half towards the light {left:.3f}, of the other {right:.3f}")
            self.assertGreater(left, right + 0.12)


if __name__ == "__main__":
    unittest.main(verbosity=2)
