# SPDX-License-Identifier: BSD-3-Clause
"""Radar files merged into volumes: the options of `nexrad3d grid` as parameters of one function."""

from __future__ import annotations

import os
from typing import Any, Iterable, Mapping, Optional, Union

from . import files
from .files import Path, one_of
from .series import VolumeSeries
from .times import Duration, Time, duration_of, seconds_of
from .vtkNexradFilters import vtkNexradDayReader

METHODS = {"beam": vtkNexradDayReader.BEAM, "thesis": vtkNexradDayReader.THESIS}
OVERLAPS = {"distance": vtkNexradDayReader.DISTANCE, "nearest": vtkNexradDayReader.NEAREST,
            "mean": vtkNexradDayReader.MEAN, "maximum": vtkNexradDayReader.MAXIMUM}
QUALITIES = {"off": vtkNexradDayReader.QUALITY_OFF, "standard": vtkNexradDayReader.QUALITY_STANDARD,
             "strict": vtkNexradDayReader.QUALITY_STRICT}
AXES = {"projected": vtkNexradDayReader.PROJECTED, "geographic": vtkNexradDayReader.GEOGRAPHIC}

Motion = tuple[float, float]


def merge(paths: Union[Path, Iterable[Path]], *,
          moments: Union[str, Iterable[str]] = "REF",
          step: Duration = 300.0,
          begin: Optional[Time] = None,
          end: Optional[Time] = None,
          max_gap: Duration = 900.0,
          dims: tuple[int, int, int] = (256, 256, 128),
          range: float = 230e3,
          bounds: Optional[tuple[float, float, float, float]] = None,
          height: tuple[float, float] = (0.0, 20e3),
          axes: str = "projected",
          method: str = "beam",
          quality: str = "standard",
          despeckle: int = 0,
          dealiasing: bool = True,
          storm_motion: Optional[Motion] = None,
          bias: Union[str, Mapping[str, float]] = "off",
          overlap: str = "distance",
          overlap_length: float = 100e3,
          fill_columns: bool = False,
          linear_reflectivity: bool = False,
          sharpening: bool = True,
          ancillary: bool = False,
          motion: Union[str, Motion] = "estimated",
          memory: int = 1 << 30,
          site: str = "") -> VolumeSeries:
    """Merges the files of any number of radars; gives one volume for each time step.

    The files are looked at now, the volumes are merged when they are asked for. The parameters are the
    options of `nexrad3d grid` (user guide, chapter 3), and have their defaults. Lengths are in metres,
    durations in seconds (or timedelta), times as in `Time` (UTC).

    paths: Level II files, folders and tar archives of them (with those within), and folders of real-time chunks.
    moments: names, as "REF,VEL" or ["REF", "VEL"]; the first is the volumes' own.
    step: between two volumes; the times are multiples of it in UTC.
    begin, end: the first and the last time that count, both included; None for those of the data.
    max_gap: rays (method "thesis": volumes) farther than this from a time are not used for it.
    dims: voxels to the east, to the north and upward.
    range: the domain is the smallest box about the circles of this radius about all radars.
    bounds: west, south, east, north in degrees, in place of `range`.
    height: lower and upper face of the domain, above mean sea level.
    axes: "projected" (metres) or "geographic" (degrees).
    method: "beam" or "thesis".
    quality: what quality control takes out of REF: "off", "standard" or "strict".
    despeckle: takes out gates that have fewer neighbours with a value than this, 0 to 26.
    dealiasing: whether the velocities of VEL are unfolded.
    storm_motion: that SRV is relative to: m/s to the east and to the north; None: estimated.
    bias: "off", "auto", or what radars measure too high in dB: {"KLSX": 2} or "KLSX:2".
    overlap: "distance", "nearest", "mean" or "maximum": how radars that overlap are combined.
    overlap_length: of "distance": where the weight of a radar is 1/e.
    fill_columns: fills columns between and below what was scanned.
    linear_reflectivity: interpolates and averages Z in place of dBZ.
    sharpening: beam-width deconvolution in elevation.
    ancillary: adds the ancillary arrays (NAME_age, NAME_radars, NAME_weight, NAME_site).
    motion: of the echo between two scans: "estimated", "none", or m/s to the east and to the north.
    memory: bytes for rays that are kept for further volumes.
    site: name of the radar in place of those in the files; all then count as this one's.

    Raises ValueError for a parameter that cannot be, FileNotFoundError for a path that does not exist,
    and Error for files that hold no ray and a request that cannot be met. Warns with DamageWarning of
    files that are damaged or left out.

    >>> series = vtknexrad.merge("KLSX", dims=(64, 64, 32), moments="REF,VEL")
    >>> series
    <VolumeSeries of 3 volumes, 2006-03-12 18:05:00 UTC to 2006-03-12 18:15:00 UTC>
    >>> volume = series[0]
    >>> volume.moments, volume["VEL"].unit
    (('REF', 'VEL'), 'm/s')
    """
    day = _day_reader(paths)
    day.SetMoment(moments if isinstance(moments, str) else ",".join(moments))
    _set_times(day, step, begin, end, max_gap)
    _set_grid(day, dims, range, bounds, height, axes)
    day.SetMethod(one_of("method", method, METHODS))
    day.SetQuality(one_of("quality", quality, QUALITIES))
    day.SetFewestNeighbours(_whole("despeckle", despeckle, 0, 26))
    day.SetDealiasing(dealiasing)
    day.SetBias(bias if isinstance(bias, str) else
                ",".join(f"{name}:{value:g}" for name, value in bias.items()) or "off")
    day.SetOverlapStrategy(one_of("overlap", overlap, OVERLAPS))
    day.SetOverlapLength(_positive("overlap_length", overlap_length))
    day.SetColumnFilling(fill_columns)
    day.SetLinearReflectivity(linear_reflectivity)
    day.SetSharpening(sharpening)
    day.SetAncillaryArrays(ancillary)
    _set_motions(day, motion, storm_motion)
    day.SetMemoryLimit(int(memory))
    day.SetSiteName(site)
    return VolumeSeries(files.Output(day))


def _day_reader(paths: Union[Path, Iterable[Path]]) -> Any:
    several = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    if not several:
        raise ValueError("there are no files to merge")
    day = vtkNexradDayReader()
    for path in several:
        day.AddFileName(files.existing(path))
    return day


def _set_times(day: Any, step: Duration, begin: Optional[Time], end: Optional[Time], max_gap: Duration) -> None:
    day.SetTimeStep(_positive("step", duration_of(step)))
    if begin is not None:
        day.SetBeginTime(seconds_of(begin))
    if end is not None:
        day.SetEndTime(seconds_of(end))
    gap = duration_of(max_gap)
    if not gap >= 0.0:
        raise ValueError(f"max_gap is {gap:g} s; it must not be negative")
    day.SetMaximumGap(gap)


def _set_grid(day: Any, dims: tuple[int, int, int], radius: float,
              bounds: Optional[tuple[float, float, float, float]], height: tuple[float, float], axes: str) -> None:
    if len(dims) != 3:
        raise ValueError(f"dims has {len(dims)} numbers; it must have three: voxels to the east, north and upward")
    day.SetDimensions(*(_whole("a number of dims", number, 1, 1 << 30) for number in dims))
    day.SetRange(_positive("range", radius))
    if bounds is not None:
        day.SetGeographicBounds(*_numbers("bounds", bounds, "west", "south", "east", "north"))
        day.SetUseGeographicBounds(True)
    day.SetHeightRange(*_numbers("height", height, "lower face", "upper face"))
    day.SetAxes(one_of("axes", axes, AXES))


def _set_motions(day: Any, motion: Union[str, Motion], storm_motion: Optional[Motion]) -> None:
    if isinstance(motion, str):
        linear = one_of("motion", motion, {"estimated": 0, "none": 1})
        day.SetTimeInterpolation(day.LINEAR if linear else day.MOTION)
    else:
        day.SetGivenMotion(*_numbers("motion", motion, "m/s to the east", "m/s to the north"))
        day.SetUseGivenMotion(True)
    if storm_motion is not None:
        day.SetStormMotion(*_numbers("storm_motion", storm_motion, "m/s to the east", "m/s to the north"))
        day.SetUseStormMotion(True)


def _whole(name: str, value: Any, least: int, most: int) -> int:
    if int(value) != value or not least <= value <= most:
        raise ValueError(f"{name} is {value}; it must be a whole number from {least} to {most}")
    return int(value)


def _positive(name: str, value: float) -> float:
    if not 0.0 < value < float("inf"):
        raise ValueError(f"{name} is {value:g}; it must be above 0")
    return float(value)


def _numbers(name: str, values: Iterable[float], *meanings: str) -> list[float]:
    numbers = [float(value) for value in values]
    if len(numbers) != len(meanings):
        raise ValueError(f"{name} has {len(numbers)} numbers; it must have {len(meanings)}: {', '.join(meanings)}")
    return numbers
