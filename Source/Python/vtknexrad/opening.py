# SPDX-License-Identifier: BSD-3-Clause
"""One function that opens every file of the project."""

from __future__ import annotations

import glob
import os
from typing import Any, Optional, Union

from . import files
from .errors import Error
from .files import Path
from .radar import RadarVolume
from .series import VolumeSeries
from .volume import Volume
from .vtkNexradIO import vtkNexradLevel2Reader, vtkNexradSeriesReader, vtkNexradVolumeReader


def open(path: Path, *, quality: Optional[str] = None, site: Optional[str] = None,
         position: Optional[tuple[float, float, float]] = None, moments: Optional[str] = None,
         level: Optional[int] = None, rows: Optional[tuple[int, int]] = None) -> Union[RadarVolume, Volume, VolumeSeries]:
    """Opens a file or folder by what it contains.

    - A Level II file, also in a tar archive ("day.tar/KLSX20060312_180145"), or a folder of real-time chunks: a
      RadarVolume.
    - A merged volume (.nxv): a Volume.
    - An index (.nxv.series), or a folder with one or with .nxv files: a VolumeSeries.

    quality, site, position: as RadarVolume has them, of radar files alone.
    moments: names of moments to read, as "VEL,REF", of volumes and series of them.
    level, rows: as Volume.open has them, of single volumes.

    Raises FileNotFoundError for a path that does not exist, TypeError for a parameter that what the path holds
    does not have, and Error, in one line, for a file of another kind, one that cannot be read, and a folder or
    tar archive of radar files, which `merge` takes.

    >>> vtknexrad.open("KLSX20060312_180145").radar
    'KLSX'
    >>> len(vtknexrad.open(pathlib.Path("volumes", "volumes.nxv.series")))
    3
    >>> vtknexrad.open("KLSX")
    Traceback (most recent call last):
    vtknexrad.errors.Error: KLSX: a folder of radar files: vtknexrad.merge merges them, vtknexrad.open opens one of them
    >>> vtknexrad.open("nowhere")
    Traceback (most recent call last):
    FileNotFoundError: nowhere: no such file or folder
    """
    given = {"quality": quality, "site": site, "position": position, "moments": moments, "level": level, "rows": rows}
    options = {name: value for name, value in given.items() if value is not None}
    text = files.existing(path)
    opens, what, parameters = _kind(text)
    for name in options:
        if name not in parameters:
            raise TypeError(f"{text}: {what} has no parameter {name}; it has {', '.join(parameters)}")
    return opens(text, **options)  # type: ignore[no-any-return]


def _kind(path: str) -> tuple[Any, str, tuple[str, ...]]:
    """What opens a path, what the path holds, and the parameters of this."""
    series = VolumeSeries.open, "a series of volumes", ("moments",)
    radar = RadarVolume, "a radar file", ("quality", "site", "position")
    if os.path.isdir(path):
        return series if _holds_volumes(path) else radar
    if path.endswith(".nxv.series"):
        return series
    if path.endswith(".nxv") or vtkNexradVolumeReader.CanReadFile(path):
        return Volume.open, "a volume", ("moments", "level", "rows")
    if not vtkNexradLevel2Reader.CanReadFile(path) and vtkNexradSeriesReader.CanReadFile(path):
        raise _several(path, "a tar archive")
    return radar


def _holds_volumes(folder: str) -> bool:
    """Whether a folder holds volumes, and not the chunks of a radar. Raises Error where it holds neither."""
    if glob.glob(os.path.join(glob.escape(folder), "*.nxv*")):
        return True
    if vtkNexradLevel2Reader.CanReadFile(folder):
        return False
    if vtkNexradSeriesReader.CanReadFile(folder):
        raise _several(folder, "a folder")
    raise Error(f"{folder}: no radar file and no merged volume in the folder")


def _several(path: str, kind: str) -> Error:
    return Error(f"{path}: {kind} of radar files: vtknexrad.merge merges them, vtknexrad.open opens one of them")
