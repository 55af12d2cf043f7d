# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the ParaView plugin share: the plugin itself, radar files, arrays and pictures."""

import glob
import os
import unittest

import numpy
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

simple.LoadPlugin(os.environ["NEXRAD_PLUGIN"], remote=False, ns=vars(simple))

SOURCES = {
    "NexradRadarDay": "vtkNexradDayReader",
    "NexradLevel2Series": "vtkNexradSeriesReader",
    "NexradLevel2Reader": "vtkNexradLevel2Reader",
}
FILTERS = {
    "NexradEchoClasses": "vtkNexradEchoClasses",
    "NexradEchoOnly": "vtkNexradEchoOnly",
    "NexradTwoFields": "vtkNexradTwoFields",
}


def make(group, name):
    """The proxy of the server manager, as XML defines it."""
    return servermanager.ProxyManager().SMProxyManager.NewProxy(group, name)


def real_files(folder):
    """The files of a folder of level2/, in the order of their names; skips the test without them."""
    root = os.environ.get("NEXRAD_TEST_DATA") or os.environ.get("NEXRAD_DEFAULT_TEST_DATA", "")
    found = sorted(glob.glob(os.path.join(root, "level2", folder, "*")))
    if not found:
        raise unittest.SkipTest("real radar files not found: set NEXRAD_TEST_DATA")
    return found


def point_arrays(image):
    """The point data of an image by name."""
    data = image.GetPointData()
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())}


def fetch(source, time=None):
    """The output of a pipeline source at a time, as a VTK object."""
    source.UpdatePipeline() if time is None else source.UpdatePipeline(time)
    return source.GetClientSideObject().GetOutputDataObject(0)


def picture(path):
    """The pixels of a PNG file, 0 to 255."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(float)


def difference(first, second):
    """Mean and largest difference of two pictures, in 255ths."""
    apart = numpy.abs(first - second)
    return apart.mean(), apart.max()
