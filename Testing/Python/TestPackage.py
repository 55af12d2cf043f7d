# SPDX-License-Identifier: BSD-3-Clause
"""The package as a user meets it: classes, help, times, errors, arrays in the shape of their grid."""

import datetime
import inspect
import os
import subprocess
import sys
import unittest

import numpy
import vtknexrad
from vtkmodules.vtkCommonDataModel import vtkImageData

import SyntheticFiles

UTC = datetime.timezone.utc


def level2_reader(path):
    reader = vtknexrad.vtkNexradLevel2Reader()
    reader.SetFileName(path)
    return reader


def day_reader():
    day = vtknexrad.vtkNexradDayReader()
    for path in SyntheticFiles.files():
        day.AddFileName(path)
    day.SetDimensions(20, 16, 12)
    return day


class Classes(unittest.TestCase):
    concrete = (
        "vtkNexradLevel2Reader", "vtkNexradSeriesReader", "vtkNexradVolumeReader",
        "vtkNexradVolumeWriter", "vtkNexradNetCDFWriter", "vtkNexradDayReader",
        "vtkOpenGLTextureSliceVolumeMapper",
        "vtkNexradTransferFunction", "vtkTextureSliceObjectFactory", "vtkNexradVolumeScene",
        "vtkNexradSession")

    def test_every_class_can_be_made_and_has_help(self):
        for name in self.concrete:
            made = getattr(vtknexrad, name)()
            self.assertEqual(made.GetClassName(), name)
            self.assertGreater(len(made.__doc__.split()), 20, name)

    def test_help_has_unit_and_default(self):
        text = vtknexrad.vtkNexradDayReader.SetMaximumGap.__doc__
        self.assertIn("seconds", text)
        self.assertIn("900 by default", text)


class Names(unittest.TestCase):
    def test_completion_offers_no_modules(self):
        names = dir(vtknexrad)
        self.assertTrue({"open", "merge", "State", "RadarVolume", "vtkNexradDayReader"} <= set(names))
        self.assertEqual([name for name in names if inspect.ismodule(getattr(vtknexrad, name))], [])

    def test_keywords_of_open(self):
        self.assertEqual([*inspect.signature(vtknexrad.open).parameters],
                         ["path", "quality", "site", "position", "moments", "level", "rows"])
        path = SyntheticFiles.files()[0]
        with self.assertRaises(TypeError) as caught:
            vtknexrad.open(path, moments="REF")
        self.assertEqual(str(caught.exception),
                         f"{path}: a radar file has no parameter moments; it has quality, site, position")
        self.assertEqual(vtknexrad.open(path, site="KXXX", position=(1.0, 2.0, 3.0)).position, (1.0, 2.0, 3.0))


class Updates(unittest.TestCase):
    def test_error_is_an_exception_of_one_line(self):
        with self.assertRaises(RuntimeError) as caught:
            vtknexrad.update(level2_reader("/nowhere/file"))
        self.assertEqual(str(caught.exception),
                         "vtkNexradLevel2Reader: /nowhere/file: no such file or folder")

    def test_error_of_the_time_steps_is_one_too(self):
        day = vtknexrad.vtkNexradDayReader()
        day.AddFileName("/nowhere/file")
        with self.assertRaises(RuntimeError):
            vtknexrad.time_steps(day)

    def test_a_reader_works_after_an_error(self):
        reader = level2_reader("/nowhere/file")
        with self.assertRaises(RuntimeError):
            vtknexrad.update(reader)
        reader.SetFileName(SyntheticFiles.files()[0])
        self.assertGreater(vtknexrad.update(reader).GetNumberOfPartitionedDataSets(), 0)

    def test_time_steps_are_multiples_of_the_step(self):
        steps = vtknexrad.time_steps(day_reader())
        self.assertEqual(steps[0].tzinfo, UTC)
        self.assertEqual({step.minute % 5 for step in steps}, {0})
        self.assertEqual(len(set(steps)), len(steps))

    def test_a_datetime_and_its_seconds_give_the_same_volume(self):
        day = day_reader()
        when = vtknexrad.time_steps(day)[1]
        by_datetime = vtknexrad.array(vtknexrad.update(day, when)).copy()
        other = vtknexrad.array(vtknexrad.update(day, vtknexrad.time_steps(day)[0])).copy()
        without_zone = vtknexrad.array(vtknexrad.update(day, when.replace(tzinfo=None))).copy()
        by_seconds = vtknexrad.array(vtknexrad.update(day, when.timestamp()))
        numpy.testing.assert_array_equal(by_datetime, by_seconds)
        numpy.testing.assert_array_equal(by_datetime, without_zone)
        self.assertTrue((by_datetime != other).any())


class Arrays(unittest.TestCase):
    def test_a_volume_is_z_y_x(self):
        day = day_reader()
        volume = vtknexrad.update(day)
        values = vtknexrad.array(volume)
        self.assertEqual(values.shape, (12, 16, 20))
        for z, y, x in ((0, 0, 0), (3, 8, 17), (11, 15, 19)):
            self.assertEqual(values[z, y, x], volume.GetScalarComponentAsDouble(x, y, z, 0))

    def test_axes_are_the_points(self):
        volume = vtkImageData()
        volume.SetExtent(2, 5, -1, 1, 0, 1)
        volume.SetOrigin(10.0, 20.0, 30.0)
        volume.SetSpacing(0.1, 0.5, 2.0)
        east, north, up = vtknexrad.axes(volume)
        last = volume.GetPoint(volume.GetNumberOfPoints() - 1)
        self.assertEqual([len(axis) for axis in (east, north, up)], [4, 3, 2])
        self.assertEqual((east[-1], north[-1], up[-1]), last)
        self.assertEqual((east[0], north[0], up[0]), volume.GetPoint(0))

    def test_a_view_copies_nothing(self):
        volume = vtknexrad.update(day_reader())
        vtknexrad.array(volume)[1, 2, 3] = 77.0
        self.assertEqual(volume.GetScalarComponentAsDouble(3, 2, 1, 0), 77.0)

    def test_derived_moments_are_arrays_of_a_merged_volume(self):
        day = day_reader()
        day.SetMoment("VEL,SRV,AZSHEAR,DIV")
        day.SetOption("storm-motion", "0,0")
        volume = vtknexrad.update(day)
        echo = vtknexrad.array(volume, "VEL_state") == 0
        self.assertGreater(echo.sum(), 100)
        velocity = vtknexrad.array(volume, "VEL")[echo]
        numpy.testing.assert_allclose(vtknexrad.array(volume, "SRV")[echo], velocity, atol=0.01)
        for name in ("AZSHEAR", "DIV"):
            derivative = vtknexrad.array(volume, name)[vtknexrad.array(volume, name + "_state") == 0]
            self.assertGreater(derivative.size, 100)
            self.assertLess(abs(derivative).max(), 0.1)  # per second
            self.assertGreater(abs(derivative).max(), 0.0005)

    def test_an_unknown_moment_is_answered_with_the_names(self):
        day = day_reader()
        day.SetMoment("SHEAR")
        with self.assertRaisesRegex(Exception, "SRV, AZSHEAR, DIV or KDP"):
            vtknexrad.update(day)

    def test_a_bias_is_taken_off_and_what_is_none_is_refused(self):
        day = day_reader()
        measured = vtknexrad.array(vtknexrad.update(day), "REF").max()
        day.SetOption("bias", "KLSX:2")
        self.assertAlmostEqual(vtknexrad.array(vtknexrad.update(day), "REF").max(), measured - 2.0, delta=0.5)
        day.SetOption("bias", "KLSX")
        with self.assertRaisesRegex(Exception, "write auto, off, or radars"):
            vtknexrad.update(day)

    def test_a_sweep_is_ray_gate(self):
        sweeps = vtknexrad.update(level2_reader(SyntheticFiles.files()[0]))
        grid = vtknexrad.sweep(sweeps, 0)
        values = vtknexrad.array(grid)
        dimensions = [0, 0, 0]
        grid.GetDimensions(dimensions)
        gates, rays, _ = dimensions
        self.assertEqual(values.shape, (rays, gates))
        numpy.testing.assert_array_equal(values[0], values[-1])  # all the way round
        self.assertEqual(vtknexrad.array(grid, "REF_state").dtype, numpy.uint8)

    def test_echo_classes_are_arrays_of_the_gates(self):
        sweeps = vtknexrad.update(level2_reader(SyntheticFiles.files()[0]))
        pairs = vtknexrad.echo_classes(sweeps)
        self.assertEqual(len(pairs), sweeps.GetNumberOfPartitionedDataSets())
        self.assertIn(None, pairs)  # the Doppler halves of split cuts have no REF
        values = vtknexrad.array(vtknexrad.sweep(sweeps, 0))
        classes, reasons = pairs[0]
        self.assertEqual(classes.dtype, numpy.uint8)
        numpy.testing.assert_array_equal(classes == 0, numpy.isnan(values))
        numpy.testing.assert_array_equal(reasons == 0, numpy.isnan(values))
        names = [vtknexrad.vtkNexradEchoClasses.GetEchoClassName(number) for number in range(7)]
        share = [(classes == number).sum() / (classes > 0).sum() for number in range(7)]
        self.assertGreater(share[names.index("weather")], 0.5)
        self.assertLess(share[names.index("ground")], 0.05)  # the synthetic day has none

    def test_quality_control_can_be_switched_off(self):
        day = day_reader()
        self.assertEqual(day.GetOption("quality"), "standard")
        states = {}
        for quality in (0, 1):
            day.SetOption("quality", quality)
            states[quality] = vtknexrad.array(vtknexrad.update(day), "REF_state").copy()
        self.assertNotIn(4, states[0])
        self.assertFalse(numpy.array_equal(states[0], states[1]))

    def test_what_is_not_there_is_named(self):
        sweeps = vtknexrad.update(level2_reader(SyntheticFiles.files()[0]))
        with self.assertRaisesRegex(IndexError, "no sweep 99; there are"):
            vtknexrad.sweep(sweeps, 99)
        with self.assertRaisesRegex(KeyError, "CFP"):
            vtknexrad.sweep(sweeps, 0, "CFP")
        with self.assertRaisesRegex(KeyError, "no array 'XYZ'; there are REF"):
            vtknexrad.array(vtknexrad.sweep(sweeps, 0), "XYZ")


class Override(unittest.TestCase):
    ask = ("from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper\n"
           "import vtkmodules.vtkRenderingVolumeOpenGL2\n"
           "print(vtkGPUVolumeRayCastMapper().GetClassName())")

    def class_in_a_program_without_us(self, **environment):
        return subprocess.run([sys.executable, "-c", self.ask], check=True, capture_output=True,
                              text=True, env=dict(os.environ, **environment)).stdout.strip()

    def test_a_program_that_does_not_know_us_gets_slices_when_asked_to(self):
        self.assertEqual(self.class_in_a_program_without_us(), "vtkOpenGLGPUVolumeRayCastMapper")
        self.assertEqual(
            self.class_in_a_program_without_us(VTK_AUTOLOAD_PATH=os.environ["NEXRAD_OVERRIDE"]),
            "vtkOpenGLTextureSliceVolumeMapper")


if __name__ == "__main__":
    unittest.main()
