# SPDX-License-Identifier: BSD-3-Clause
"""Readers and writers for paths, and their outputs at a time."""

from __future__ import annotations

import os
from typing import Any, Optional, Union

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .errors import run
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
        run(algorithm, algorithm.UpdateInformation)

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
            run(self.algorithm, self.algorithm.Update)
        else:
            run(self.algorithm, lambda: self.algorithm.UpdateTimeStep(seconds))
        return self.algorithm.GetOutputDataObject(0)

    @property
    def damage(self) -> tuple[str, ...]:
        """What was wrong in the files that were decoded so far."""
        lines = self.algorithm.GetDamage() if hasattr(self.algorithm, "GetDamage") else None
        return texts_of(lines)


def texts_of(strings: Any) -> tuple[str, ...]:
    """The texts of a vtkStringArray; none for None."""
    return tuple(strings.GetValue(index) for index in range(strings.GetNumberOfValues())) if strings else ()


def volume_reader(path: Path, moments: Optional[str] = None) -> Any:
    """A reader of a .nxv file or of an index. Raises FileNotFoundError."""
    reader = vtkNexradVolumeReader()
    reader.SetFileName(existing(path))
    reader.SetMoments(moments or "")
    return reader


def volume_writer(path: Path, code: str) -> Any:
    """A writer of a .nxv file or of a series. Raises ValueError for an unknown code."""
    writer = vtkNexradVolumeWriter()
    writer.SetFileName(os.fspath(path))
    writer.SetEncoding(one_of("code", code, CODES))
    return writer
