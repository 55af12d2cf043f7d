# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's filters on the echo of a volume alone: nothing that was not measured acts as a number."""

import unittest

import numpy
import Plugin
import SyntheticFiles
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

ECHO, NO_ECHO = 0, 1


def triangles(surface):
    """Middle and area of each triangle."""
    split = vtkTriangleFilter()
    split.SetInputData(surface)
    split.Update()
    points = vtk_to_numpy(split.GetOutput().GetPoints().GetData()).astype(float)
    corners = points[vtk_to_numpy(split.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    normal = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return corners.mean(axis=1), numpy.linalg.norm(normal, axis=1) / 2


class EchoOnly(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.day = simple.NEXRADRadarDay(FileNames=list(SyntheticFiles.files()), Dimensions=[96, 96, 48])
        cls.image = Plugin.fetch(cls.day)
        arrays = Plugin.point_arrays(cls.image)
        cls.states, cls.values = arrays["REF_state"], arrays["REF"]
        cls.echo = cls.values[cls.states == ECHO].astype(float)
        cls.voxel = numpy.prod(cls.image.GetSpacing())

    def between(self, **settings):
        return simple.NEXRADEchoOnly(Input=self.day, **settings)

    def voxels(self):
        return self.between(Cells="Voxels")

    def share_of_false_walls(self, source):
        """Of a surface of 15 dBZ: how much of its area lies in a cell with a corner that was not measured."""
        surface = simple.Contour(Input=source, ContourBy=["POINTS", "REF"], Isosurfaces=[15.0])
        middles, areas = triangles(Plugin.fetch(surface))
        cell = numpy.floor((middles - self.image.GetOrigin()) / self.image.GetSpacing()).astype(int)
        states = self.states.reshape(self.image.GetDimensions()[::-1])
        unmeasured = numpy.zeros(len(areas), bool)
        for corner in numpy.ndindex(2, 2, 2):
            x, y, z = numpy.minimum(cell + corner, numpy.array(states.shape[::-1]) - 1).T
            unmeasured |= states[z, y, x] > NO_ECHO
        return areas[unmeasured].sum() / areas.sum()

    def test_cells_are_those_whose_corners_are_echo(self):
        states = self.states.reshape(self.image.GetDimensions()[::-1])
        echo = states == ECHO
        whole = numpy.ones(tuple(n - 1 for n in echo.shape), bool)
        for z, y, x in numpy.ndindex(2, 2, 2):
            whole &= echo[z:echo.shape[0] - 1 + z, y:echo.shape[1] - 1 + y, x:echo.shape[2] - 1 + x]
        cells = Plugin.fetch(self.between())
        self.assertEqual(cells.GetNumberOfCells(), whole.sum())
        self.assertGreater(cells.GetNumberOfCells(), 500)
        self.assertTrue((vtk_to_numpy(cells.GetPointData().GetArray("REF_state")) == ECHO).all())
        self.assertEqual(Plugin.fetch(self.voxels()).GetNumberOfCells(), len(self.echo))

    def test_contour_has_no_walls_beside_what_was_not_scanned(self):
        raw = self.share_of_false_walls(self.day)
        print(f"false walls of a surface of 15 dBZ: {100 * raw:.1f} % of the volume's")
        self.assertGreater(raw, 0.01, "else there is nothing to leave out")
        for settings in ({}, {"NoEchoCounts": 1}):
            self.assertEqual(self.share_of_false_walls(self.between(**settings)), 0)

    def test_integral_is_the_volume_of_the_echo(self):
        whole = Plugin.fetch(simple.IntegrateVariables(Input=self.voxels())).GetCellData()
        self.assertAlmostEqual(whole.GetArray("Volume").GetTuple1(0) / (len(self.echo) * self.voxel), 1, places=5)
        self.assertAlmostEqual(whole.GetArray("REF").GetTuple1(0) / (self.echo.sum() * self.voxel), 1, places=4)

    def test_histogram_and_threshold_count_echo(self):
        table = Plugin.fetch(simple.Histogram(Input=self.voxels(), SelectInputArray=["CELLS", "REF"]))
        self.assertEqual(vtk_to_numpy(table.GetRowData().GetArray("bin_values")).sum(), len(self.echo))
        threshold = simple.Threshold(Input=self.voxels(), Scalars=["CELLS", "REF"])
        threshold.LowerThreshold, threshold.UpperThreshold = -100.0, 10.0
        self.assertEqual(Plugin.fetch(threshold).GetNumberOfCells(), (self.echo <= 10.0).sum())

    def test_statistics_are_of_echo(self):
        statistics = simple.DescriptiveStatistics(
            Input=self.voxels(), VariablesofInterest=["REF"], AttributeMode="Cell Data")
        blocks = Plugin.fetch(statistics)
        table = blocks.GetBlock(0)
        found = {table.GetColumnName(i): table.GetValue(0, i).ToDouble() for i in range(1, table.GetNumberOfColumns())}
        self.assertEqual(found["Cardinality"], len(self.echo))
        self.assertAlmostEqual(found["Minimum"], self.echo.min(), places=4)
        self.assertAlmostEqual(found["Mean"], self.echo.mean(), places=3)

    def test_gradient_has_no_step_down_to_the_fill_value(self):
        def steepest(source):
            gradient = simple.Gradient(Input=source, ScalarArray=["POINTS", "REF"])
            return numpy.nanmax(numpy.abs(vtk_to_numpy(Plugin.fetch(gradient).GetPointData().GetArray("Gradient"))))

        raw, echo = steepest(self.day), steepest(self.between())
        print(f"steepest gradient: {raw:.4f} dB/m in the volume, {echo:.4f} dB/m in its echo")
        self.assertLess(echo, raw)


if __name__ == "__main__":
    unittest.main(verbosity=2)
