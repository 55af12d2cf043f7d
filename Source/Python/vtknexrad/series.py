# SPDX-License-Identifier: BSD-3-Clause
"""Merged volumes in the order of their times, read or merged when they are asked for."""

from __future__ import annotations

import bisect
import glob
import os
from collections.abc import Sequence
from typing import Any, Optional, Union, overload

import numpy
from numpy.typing import NDArray
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from . import files
from .errors import Error, Messages, OutOfRange, texts_of, without_class
from .files import Path
from .pages import Page, make_page
from .times import Time, datetime64_of, datetime64s_of, seconds_of, text_of
from .volume import Volume


class VolumeSeries(Sequence[Volume]):
    """A sequence of Volume. Nothing is kept: each access reads or merges a volume.

    >>> series = vtknexrad.open("volumes")
    >>> series
    <VolumeSeries of 3 volumes, 2006-03-12 18:05:00 UTC to 2006-03-12 18:15:00 UTC>
    >>> str(series.times[0])
    '2006-03-12T18:05:00.000000000'
    >>> [volume.sites for volume in series]
    [('KLSX',), ('KLSX',), ('KLSX',)]
    >>> bool(series.at("2006-03-12T18:10").time == series[1].time)
    True
    """

    def __init__(self, source: Any, seconds: Optional[list[float]] = None) -> None:
        """source: a files.Output or SeparateFiles. seconds: the times that count; None for all."""
        self._source = source
        self._seconds = list(source.seconds) if seconds is None else seconds

    @classmethod
    def open(cls, path: Path, moments: Optional[str] = None) -> VolumeSeries:
        """Opens an index (.nxv.series), or a folder: by its index, else by its .nxv files.

        moments: names of moments to read, as "VEL,REF"; None for all.

        Raises FileNotFoundError, and Error for what has no volumes, and for a folder of several
        indices.
        """
        text = files.existing(path)
        if not os.path.isdir(text):
            return cls(files.Output(files.volume_reader(text, moments)))
        indices = sorted(glob.glob(os.path.join(glob.escape(text), "*.nxv.series")))
        if len(indices) > 1:
            names = ", ".join(os.path.basename(index) for index in indices)
            raise Error(f"{text}: several indices: {names}; open one of them")
        if indices:
            return cls(files.Output(files.volume_reader(indices[0], moments)))
        volumes = sorted(glob.glob(os.path.join(glob.escape(text), "*.nxv")))
        if not volumes:
            raise Error(f"{text}: no .nxv file in the folder")
        return cls(SeparateFiles(volumes, moments))

    @property
    def times(self) -> NDArray[numpy.datetime64]:
        """The times of the volumes in UTC."""
        return datetime64s_of(self._seconds)

    @property
    def sites(self) -> tuple[str, ...]:
        """Names of the radars: of a merge, those of all files; of volume files, those of the first."""
        known = self._of_merge("GetSites")
        if known:
            return texts_of(known())
        return self[0].sites if len(self) else ()

    @property
    def damage(self) -> tuple[str, ...]:
        """What was wrong in the radar files that were decoded so far, one line each."""
        return self._source.damage

    @property
    def radar_comparison(self) -> tuple[str, ...]:
        """Of a merge of several radars: what the comparison of their reflectivity finds so far."""
        compare = self._of_merge("GetRadarComparison")
        return texts_of(compare()) if compare else ()

    def _of_merge(self, method: str) -> Any:
        """A method of the reader that merges; None where volumes are read from files."""
        return getattr(getattr(self._source, "algorithm", None), method, None)

    def at(self, time: Time) -> Volume:
        """The volume at a time. Of a merge, one that is merged for this time, whether it is a time step
        or not; of files, the latest at or before the time.

        Raises OutOfRange, which is an IndexError, for a time at which no radar scanned anything: of files, one
        that is not from the first to the last; ValueError for text that is no time; Error as the readers do.
        """
        seconds = seconds_of(time)
        if not self._seconds:
            raise OutOfRange("there are no volumes")
        merges = self._of_merge("GetSites") is not None
        if merges or self._seconds[0] <= seconds <= self._seconds[-1]:
            volume = Volume(self._source.at(seconds))
            if volume.sites or not merges:
                return volume
        asked, first, last = (text_of(datetime64_of(one)) for one in (seconds, self._seconds[0], self._seconds[-1]))
        raise OutOfRange(f"no radar scanned anything at {asked}; the volumes are of {first} to {last}")

    def __len__(self) -> int:
        return len(self._seconds)

    @overload
    def __getitem__(self, index: int) -> Volume: ...
    @overload
    def __getitem__(self, index: slice) -> VolumeSeries: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Volume, VolumeSeries]:
        """A volume, or the series of a slice. Raises OutOfRange, which is an IndexError."""
        if isinstance(index, slice):
            return VolumeSeries(self._source, self._seconds[index])
        if not -len(self) <= index < len(self):
            raise OutOfRange(f"no volume {index}; there are {len(self)}, counted from 0")
        return Volume(self._source.at(self._seconds[index]))

    def write(self, folder: Path, code: str = "automatic", name: str = "volumes.nxv.series") -> str:
        """Writes the volumes as .nxv files, named by their times, and their index; returns its path.

        folder: is made where it does not exist. code: as that of Volume.write. name: of the index.

        Raises Error when a volume cannot be made or written; no index is written then.
        """
        if not self._seconds:
            raise Error("there are no volumes to write")
        os.makedirs(folder, exist_ok=True)
        writer = files.volume_writer(os.path.join(folder, name), code)
        pipeline = _Pipeline(self._source, self._seconds)
        writer.SetInputConnection(pipeline.GetOutputPort())
        with Messages(writer) as messages:
            writer.Write()
        if pipeline.failure is not None:
            raise pipeline.failure
        if messages.errors:
            raise Error(without_class(messages.errors[0]))
        return os.path.join(folder, name)

    def show(self, height: int = 480, **options: Any) -> Page:
        """A page that plays the volumes, as Volume.show has one. It holds all of them: take a slice of a long
        series."""
        return make_page(lambda path: self.write(os.path.dirname(path)), height, options)

    def to_xarray(self, chunks: Any = None) -> Any:
        """An xarray.Dataset of all volumes, as Volume.to_xarray has it. The numbers in NAME_site count in the
        attribute `sites`.

        chunks: None reads or merges all volumes now, into memory. {} or {"time": 1} gives arrays of dask: each
            volume is read or merged when its values are asked for, the first one now as well. Others divide
            the volumes further, as Dataset.chunk does. dask's threads can compute it, its processes cannot.

        Raises ImportError when xarray, or dask for chunks, is not installed, and Error for volumes of several
        grids, of which chunks tell when they are read.
        """
        from .dataset import dataset_of_volumes, lazy_dataset
        return dataset_of_volumes(self) if chunks is None else lazy_dataset(self, chunks)

    def __repr__(self) -> str:
        if not self._seconds:
            return "<VolumeSeries of 0 volumes>"
        times = self.times
        count = f"{len(self)} volume{'s' * (len(self) != 1)}"
        return f"<VolumeSeries of {count}, {text_of(times[0])} to {text_of(times[-1])}>"


class SeparateFiles:
    """The volumes of .nxv files, as files.Output has those of an index."""

    damage: tuple[str, ...] = ()

    def __init__(self, paths: list[str], moments: Optional[str]) -> None:
        self._moments = moments
        found = []
        for path in paths:
            found += [(seconds, path) for seconds in files.Output(files.volume_reader(path)).seconds]
        found.sort()
        self.seconds = [seconds for seconds, _ in found]
        self._paths = [path for _, path in found]

    @property
    def extent(self) -> tuple[int, ...]:
        """The extent of the first volume."""
        return files.Output(files.volume_reader(self._paths[0])).extent

    def at(self, seconds: float) -> Any:
        """The image of the latest file at or before the time; before the first, the first."""
        index = max(bisect.bisect_right(self.seconds, seconds) - 1, 0)
        return files.Output(files.volume_reader(self._paths[index], self._moments)).at()


class _Pipeline(VTKPythonAlgorithmBase):  # type: ignore[misc]
    """The volumes of a series as time steps of a VTK pipeline."""

    def __init__(self, source: Any, seconds: list[float]) -> None:
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkImageData")
        self._source = source
        self._seconds = seconds
        self.failure: Optional[Exception] = None  #: what the last request raised

    def RequestInformation(self, _request: Any, _inputs: Any, outputs: Any) -> int:
        keys = vtkStreamingDemandDrivenPipeline
        information = outputs.GetInformationObject(0)
        information.Set(keys.TIME_STEPS(), self._seconds, len(self._seconds))
        information.Set(keys.TIME_RANGE(), [self._seconds[0], self._seconds[-1]], 2)
        information.Set(keys.WHOLE_EXTENT(), self._source.extent, 6)
        return 1

    def RequestData(self, _request: Any, _inputs: Any, outputs: Any) -> int:
        time = outputs.GetInformationObject(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
        try:
            self.GetOutputDataObject(0).ShallowCopy(self._source.at(time))
        except Exception as error:  # VTK would print it and go on
            self.failure = error
            return 0
        return 1
