# SPDX-License-Identifier: BSD-3-Clause
"""One function that opens every file of the project."""

from __future__ import annotations

import glob
import os
from typing import Any, Union

from . import files
from .errors import Error
from .files import Path
from .radar import RadarVolume
from .series import VolumeSeries
from .volume import Volume
from .vtkNexradIO import vtkNexradLevel2Reader, vtkNexradSeriesReader, vtkNexradVolumeReader


def open(path: Path, **options: Any) -> Union[RadarVolume, Volume, VolumeSeries]:
    """Opens a file or folder by what it contains.

    - A Level II file, also in a tar archive ("day.tar/KLSX20060312_180145"), or a folder of real-time chunks: a
      RadarVolume.
    - A merged volume (.nxv): a Volume.
    - An index (.nxv.series), or a folder with one or with .nxv files: a VolumeSeries.

    options: those of the class: `quality`, `site` and `position` of RadarVolume, `moments` of the others, `level`
    and `rows` of Volume.

    Raises FileNotFoundError for a path that does not exist, and Error, in one line, for a file of another
    kind, one that cannot be read, and a folder or tar archive of radar files, which `merge` takes.

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
    text = files.existing(path)
    if os.path.isdir(text):
        return _open_folder(text, options)
    if text.endswith(".nxv.series"):
        return VolumeSeries.open(text, **options)
    if text.endswith(".nxv") or vtkNexradVolumeReader.CanReadFile(text):
        return Volume.open(text, **options)
    if not vtkNexradLevel2Reader.CanReadFile(text) and vtkNexradSeriesReader.CanReadFile(text):
        raise _several(text, "a tar archive")
    return RadarVolume(text, **options)


def _open_folder(folder: str, options: dict[str, Any]) -> Union[RadarVolume, VolumeSeries]:
    if glob.glob(os.path.join(glob.escape(folder), "*.nxv*")):
        return VolumeSeries.open(folder, **options)
    if vtkNexradLevel2Reader.CanReadFile(folder):
        return RadarVolume(folder, **options)
    if vtkNexradSeriesReader.CanReadFile(folder):
        raise _several(folder, "a folder")
    raise Error(f"{folder}: no radar file and no merged volume in the folder")


def _several(path: str, kind: str) -> Error:
    return Error(f"{path}: {kind} of radar files: vtknexrad.merge merges them, vtknexrad.open opens one of them")
