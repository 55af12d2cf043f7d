# SPDX-License-Identifier: BSD-3-Clause
"""From the classes to numpy: outputs at a time, arrays in the shape of their grid."""

import datetime
import re

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import numpy

from .vtkNexradFilters import vtkNexradEchoClasses


class _Errors:
    """Gathers the errors that an algorithm reports while the block runs."""

    def __init__(self, algorithm):
        self.observed = [algorithm, algorithm.GetExecutive()]
        self.lines = []

    def __enter__(self):
        def keep(_caller, _event, text):
            # "vtkClass (0x55d0): what is wrong", below the place in the source.
            line = text.strip().splitlines()[-1]
            self.lines.append(re.sub(r"^(\w+) \(0x[0-9a-f]+\): ", r"\1: ", line))

        keep.CallDataType = "string0"
        self.tags = [one.AddObserver(vtkCommand.ErrorEvent, keep) for one in self.observed]
        return self.lines

    def __exit__(self, *_exception):
        for one, tag in zip(self.observed, self.tags):
            one.RemoveObserver(tag)


def _seconds(time):
    if isinstance(time, datetime.datetime):
        if time.tzinfo is None:
            time = time.replace(tzinfo=datetime.timezone.utc)
        return time.timestamp()
    return float(time)


def update(algorithm, time=None):
    """Runs a reader or filter and gives its output.

    time: a datetime (UTC where it has no zone of its own) or seconds since 1970-01-01T00:00:00Z;
        None for the time that the algorithm chooses, its first as a rule.

    Raises RuntimeError with the algorithm's own line when it reports an error. Warnings, such as
    damage in a file, go where VTK's warnings go.
    """
    with _Errors(algorithm) as lines:
        algorithm.UpdateInformation()
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(_seconds(time))
    if lines:
        raise RuntimeError(lines[0])
    return algorithm.GetOutputDataObject(0)


def time_steps(algorithm):
    """The time steps of a reader, as a list of datetimes in UTC; empty for none.

    Raises RuntimeError as update does.
    """
    with _Errors(algorithm) as lines:
        algorithm.UpdateInformation()
    if lines:
        raise RuntimeError(lines[0])
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    steps = algorithm.GetOutputInformation(0).Get(key) or ()
    return [datetime.datetime.fromtimestamp(step, datetime.timezone.utc) for step in steps]


def array(data_set, name="REF"):
    """The values of a point array in the shape of the grid: a view, nothing is copied.

    A merged volume (vtkImageData) gives (z, y, x); the grid of a sweep gives (ray, gate), its first
    ray once more at the end when the sweep goes all the way round. In a sweep NaN stands where
    there is no value; in a merged volume the fill value does, and NAME_state says why (0 echo,
    1 no echo, 2 range folded, 3 not scanned, 4 filtered: taken out by quality control).

    Raises KeyError when there is no such array.
    """
    values = data_set.GetPointData().GetArray(name)
    if values is None:
        data = data_set.GetPointData()
        there = [data.GetArrayName(index) for index in range(data.GetNumberOfArrays())]
        raise KeyError(f"no array {name!r}; there are {', '.join(there) or 'none'}")
    dimensions = [0, 0, 0]
    data_set.GetDimensions(dimensions)
    shape = tuple(reversed(dimensions))
    if shape[0] == 1:
        shape = shape[1:]
    return vtk_to_numpy(values).reshape(shape)


def axes(volume):
    """The coordinates of a vtkImageData along x, y and z, as three arrays: of a merged volume the
    centres of its voxels, in metres east and north of the domain's centre and above mean sea level.
    """
    # A whole index times a spacing, so that the last coordinate has no sum of roundings.
    extent = numpy.reshape(volume.GetExtent(), (3, 2))
    return tuple(
        start + spacing * numpy.arange(first, last + 1)
        for start, spacing, (first, last) in zip(volume.GetOrigin(), volume.GetSpacing(), extent))


def sweep(sweeps, index, moment="REF"):
    """The grid (vtkStructuredGrid) of a moment in sweep number `index`, counted from 0 in the order
    scanned, of a vtkNexradLevel2Reader's or vtkNexradSeriesReader's output.

    Raises IndexError when there is no such sweep, KeyError when it has no such moment.
    """
    count = sweeps.GetNumberOfPartitionedDataSets()
    if not 0 <= index < count:
        raise IndexError(f"no sweep {index}; there are {count}, counted from 0")
    grids = sweeps.GetPartitionedDataSet(index)
    for partition in range(grids.GetNumberOfPartitions()):
        grid = grids.GetPartition(partition)
        if grid.GetPointData().HasArray(moment):
            return grid
    raise KeyError(f"sweep {index} has no moment {moment!r}")


def echo_classes(sweeps):
    """What the echo of each gate of reflectivity comes from, as quality control finds it.

    sweeps: the output of a vtkNexradLevel2Reader or vtkNexradSeriesReader with all its moments.

    Gives a list with an entry for each sweep in the order scanned: a pair of arrays (class, reason)
    of uint8 in the shape of array(grid, "REF"), or None for a sweep without REF. 0 stands where
    there is no value. vtkNexradEchoClasses.GetEchoClassName and GetEchoReasonName name the numbers,
    as "ground" and "ground texture".

    Raises RuntimeError as update does.
    """
    classes = vtkNexradEchoClasses()
    classes.SetInputDataObject(0, sweeps)
    found = update(classes)
    pairs = []
    for index in range(found.GetNumberOfPartitionedDataSets()):
        try:
            grid = sweep(found, index)
        except KeyError:
            pairs.append(None)
            continue
        # The arrays live on when the output does not.
        pairs.append((array(grid, "REF_class").copy(), array(grid, "REF_reason").copy()))
    return pairs
