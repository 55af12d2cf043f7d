# SPDX-License-Identifier: BSD-3-Clause
"""Readers and writers for paths, and their outputs at a time."""

from __future__ import annotations

import os
from typing import Any, Optional, Union

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .errors import OutOfRange, run, texts_of
from .vtkNexradIO import vtkNexradLevel2Reader, vtkNexradVolumeReader, vtkNexradVolumeWriter

Path = Union[str, "os.PathLike[str]"]

#: What the parameter `code` can be, and the encoding of vtkNexradVolumeWriter that it means.
CODES = {"automatic": 0, "radar": 1, "exact": 2}


def existing(path: Path) -> str:
    """The path as text, also of a member of a tar archive. Raises FileNotFoundError where there is nothing."""
    text = os.fspath(path)
    if not os.path.exists(text) and not vtkNexradLevel2Reader.CanReadFile(text):
        raise FileNotFoundError(f"{text}: no such file or folder")
    return text


def one_of(name: str, value: Any, choices: dict[str, int]) -> int:
    """The number of a choice. Raises ValueError with the choices for another one."""
    if value not in choices:
        raise ValueError(f"{name} is {value!r}; it must be one of {', '.join(choices)}")
    return choices[value]


class Output:
    """The volumes that a reader gives."""

    def __init__(self, algorithm: Any) -> None:
        """Raises Error when the algorithm reports one."""
        self.algorithm = algorithm
        run(algorithm, "Information")

    @property
    def seconds(self) -> list[float]:
        """The time steps, seconds since 1970."""
        key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        return list(self.algorithm.GetOutputInformation(0).Get(key) or ())

    @property
    def extent(self) -> tuple[int, ...]:
        """The extent of the volumes."""
        return tuple(self.algorithm.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT()))

    def at(self, seconds: Optional[float] = None) -> Any:
        """The image at a time; None: of the first time step. It is that of the algorithm, which the next call
        fills anew. Raises Error as the algorithm does."""
        if seconds is None:
            run(self.algorithm, "Update")
        else:
            run(self.algorithm, "TimeStep", seconds)
        return self.algorithm.GetOutputDataObject(0)

    @property
    def damage(self) -> tuple[str, ...]:
        """What was wrong in the files that were decoded so far."""
        lines = self.algorithm.GetDamage() if hasattr(self.algorithm, "GetDamage") else None
        return texts_of(lines)


def volume_reader(path: Path, moments: Optional[str] = None) -> Any:
    """A reader of a .nxv file or of an index. Raises FileNotFoundError."""
    reader = vtkNexradVolumeReader()
    reader.SetFileName(existing(path))
    reader.SetMoments(moments or "")
    return reader


def levels_of_volume(path: Path) -> list[tuple[int, int, int]]:
    """Voxels along z, y and x of the volume in a .nxv file and of its coarser levels. Raises FileNotFoundError
    and Error."""
    reader = volume_reader(path)
    shapes: list[tuple[int, int, int]] = []
    while True:
        reader.SetLevel(len(shapes))
        _, east, _, north, _, top = Output(reader).extent
        shape = (top + 1, north + 1, east + 1)
        if shape in shapes:  # after the coarsest level the reader gives it again
            return shapes
        shapes.append(shape)


def part_of_volume(path: Path, moments: Optional[str], level: int, rows: Optional[tuple[int, int]]) -> Any:
    """The image of some rows of a level of a .nxv file. Raises FileNotFoundError, Error and OutOfRange."""
    reader = volume_reader(path, moments)
    if level != 0:
        count = len(levels_of_volume(path))
        if not 0 <= level < count:
            raise OutOfRange(f"{os.fspath(path)}: no level {level}; there are {count}, counted from 0")
        reader.SetLevel(level)
    output = Output(reader)
    if rows is None:
        return output.at()
    west, east, _, north, bottom, top = output.extent
    first, end = rows
    if not 0 <= first < end <= north + 1:
        raise OutOfRange(f"{os.fspath(path)}: no rows {first} to {end}; there are {north + 1}, counted from 0")
    run(reader, "Extent", (west, east, first, end - 1, bottom, top))
    return reader.GetOutputDataObject(0)


def volume_writer(path: Path, code: str) -> Any:
    """A writer of a .nxv file or of a series. Raises ValueError for an unknown code."""
    writer = vtkNexradVolumeWriter()
    writer.SetFileName(os.fspath(path))
    writer.SetEncoding(one_of("code", code, CODES))
    return writer
