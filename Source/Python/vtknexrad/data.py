# SPDX-License-Identifier: BSD-3-Clause
"""From the classes to numpy: outputs at a time, arrays in the shape of their grid."""

from __future__ import annotations

import datetime
from typing import Any, Optional

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import numpy
from numpy.typing import NDArray

from .errors import Error, Messages, OutOfRange, UnknownName
from .times import Time, seconds_of
from .vtkNexradFilters import vtkNexradEchoClasses


def update(algorithm: Any, time: Optional[Time] = None) -> Any:
    """Runs a reader or filter and gives its output.

    time: a datetime, numpy.datetime64 or ISO 8601 text (UTC where it has no zone of its own) or
        seconds since 1970-01-01T00:00:00Z; None for the time that the algorithm chooses, its first
        as a rule.

    Raises Error, which is a RuntimeError, with the algorithm's own line when it reports an error.
    Warnings, such as damage in a file, go where VTK's warnings go.

    >>> reader = vtknexrad.vtkNexradVolumeReader()
    >>> reader.SetFileName("volumes/volumes.nxv.series")
    >>> vtknexrad.update(reader, "2006-03-12T18:05").GetDimensions()
    (64, 64, 32)
    """
    with Messages(algorithm) as messages:
        algorithm.UpdateInformation()
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(seconds_of(time))
    if messages.errors:
        raise Error(messages.errors[0])
    return algorithm.GetOutputDataObject(0)


def time_steps(algorithm: Any) -> list[datetime.datetime]:
    """The time steps of a reader, as a list of datetimes in UTC; empty for none.

    Raises Error as update does.

    >>> reader = vtknexrad.vtkNexradVolumeReader()
    >>> reader.SetFileName("volumes/volumes.nxv.series")
    >>> [f"{time:%H:%M}" for time in vtknexrad.time_steps(reader)]
    ['18:05', '18:10', '18:15']
    """
    with Messages(algorithm) as messages:
        algorithm.UpdateInformation()
    if messages.errors:
        raise Error(messages.errors[0])
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    steps = algorithm.GetOutputInformation(0).Get(key) or ()
    return [datetime.datetime.fromtimestamp(step, datetime.timezone.utc) for step in steps]


def array(data_set: Any, name: str = "REF") -> NDArray[Any]:
    """The values of a point array in the shape of the grid: a view, nothing is copied.

    A merged volume (vtkImageData) gives (z, y, x); the grid of a sweep gives (ray, gate), its first
    ray once more at the end when the sweep goes all the way round. In a sweep NaN stands where
    there is no value; in a merged volume the fill value does, and NAME_state says why (0 echo,
    1 no echo, 2 range folded, 3 not scanned, 4 filtered: taken out by quality control).

    Raises UnknownName, which is a KeyError, when there is no such array.
    """
    values = data_set.GetPointData().GetArray(name)
    if values is None:
        data = data_set.GetPointData()
        there = [data.GetArrayName(index) for index in range(data.GetNumberOfArrays())]
        raise UnknownName(f"no array {name!r}; there are {', '.join(there) or 'none'}")
    dimensions = [0, 0, 0]
    data_set.GetDimensions(dimensions)
    shape = tuple(reversed(dimensions))
    if shape[0] == 1:
        shape = shape[1:]
    return vtk_to_numpy(values).reshape(shape)


def axes(volume: Any) -> tuple[NDArray[numpy.float64], NDArray[numpy.float64], NDArray[numpy.float64]]:
    """The coordinates of a vtkImageData along x, y and z, as three arrays: of a merged volume the
    centres of its voxels, in metres east and north of the domain's centre and above mean sea level.
    """
    # A whole index times a spacing, so that the last coordinate has no sum of roundings.
    extent = numpy.reshape(volume.GetExtent(), (3, 2))
    east, north, up = (
        start + spacing * numpy.arange(first, last + 1)
        for start, spacing, (first, last) in zip(volume.GetOrigin(), volume.GetSpacing(), extent))
    return east, north, up


def sweep(sweeps: Any, index: int, moment: str = "REF") -> Any:
    """The grid (vtkStructuredGrid) of a moment in sweep number `index`, counted from 0 in the order
    scanned, of a vtkNexradLevel2Reader's or vtkNexradSeriesReader's output.

    Raises OutOfRange, which is an IndexError, when there is no such sweep, and UnknownName, which is a
    KeyError, when it has no such moment.
    """
    count = sweeps.GetNumberOfPartitionedDataSets()
    if not 0 <= index < count:
        raise OutOfRange(f"no sweep {index}; there are {count}, counted from 0")
    grids = sweeps.GetPartitionedDataSet(index)
    for partition in range(grids.GetNumberOfPartitions()):
        grid = grids.GetPartition(partition)
        if grid.GetPointData().HasArray(moment):
            return grid
    raise UnknownName(f"sweep {index} has no moment {moment!r}")


def echo_classes(sweeps: Any) -> list[Optional[tuple[NDArray[numpy.uint8], NDArray[numpy.uint8]]]]:
    """What the echo of each gate of reflectivity comes from, as quality control finds it.

    sweeps: the output of a vtkNexradLevel2Reader or vtkNexradSeriesReader with all its moments.

    Gives a list with an entry for each sweep in the order scanned: a pair of arrays (class, reason)
    of uint8 in the shape of array(grid, "REF"), or None for a sweep without REF. 0 stands where
    there is no value. vtkNexradEchoClasses.GetEchoClassName and GetEchoReasonName name the numbers,
    as "ground" and "ground texture".

    Raises Error as update does.
    """
    classes = vtkNexradEchoClasses()
    classes.SetInputDataObject(0, sweeps)
    found = update(classes)
    pairs: list[Optional[tuple[NDArray[numpy.uint8], NDArray[numpy.uint8]]]] = []
    for index in range(found.GetNumberOfPartitionedDataSets()):
        try:
            grid = sweep(found, index)
        except KeyError:
            pairs.append(None)
            continue
        # The arrays live on when the output does not.
        pairs.append((array(grid, "REF_class").copy(), array(grid, "REF_reason").copy()))
    return pairs
