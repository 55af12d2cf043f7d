# SPDX-License-Identifier: BSD-3-Clause
"""Radar files merged into volumes: the options of `nexrad3d grid` as parameters of one function."""

from __future__ import annotations

import json
import os
from typing import Any, Iterable, Mapping, Optional, Union

import numpy

from . import files
from .files import Path, one_of
from .series import VolumeSeries
from .times import Duration, Time, duration_of, seconds_of
from .vtkNexradFilters import vtkNexradDayReader

OPTIONS = {option["key"].replace("-", "_"): option for option in json.loads(vtkNexradDayReader.GetOptionTable())}
QUALITIES = {name: number for number, name in enumerate(OPTIONS["quality"]["choices"])}
TIMES = ("step", "begin", "end", "max_gap", "memory", "site")  # are properties of the reader
MEANINGS = {"bounds": ("west", "south", "east", "north"), "heights": ("lower face", "upper face"),
            "motion": ("m/s to the east", "m/s to the north"), "echo motion": ("m/s to the east", "m/s to the north")}

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
          site: str = "",
          **further: Any) -> VolumeSeries:
    """Merges the files of any number of radars; gives one volume for each time step.

    The files are looked at now, the volumes are merged when they are asked for. The parameters are the
    options of `nexrad3d grid` (user guide, chapter 3), and have their defaults. Lengths are in metres,
    durations in seconds, as timedelta or as "5min", times as in `Time` (UTC).

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
    further: options of `nexrad3d grid` that are not named here, with _ for -.

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
    given = {**locals(), **further}
    if not further.keys() <= OPTIONS.keys():
        raise TypeError(f"merge() has no parameter {', '.join(sorted(further.keys() - OPTIONS.keys()))}")
    day = _day_reader(paths)
    day.SetOption("moment", moments if isinstance(moments, str) else ",".join(moments))
    _set_times(day, step, begin, end, max_gap)
    for name in OPTIONS:
        if name in given and name not in TIMES and given[name] is not None:
            day.SetOption(OPTIONS[name]["key"], text_of(name, given[name]))
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


def text_of(name: str, value: Any) -> str:
    """The text of an option. Raises ValueError for a value that it cannot have."""
    option = OPTIONS[name]
    kind = option["kind"]
    if kind == "choice" or (option["choices"] and isinstance(value, str)):
        one_of(name, value, dict.fromkeys(option["choices"], 0))
        return str(value)
    if isinstance(value, str):
        return value
    if kind == "flag":
        return "on" if value else "off"
    if kind == "number":
        return str(_whole(name, value, option["least"], option["most"]))
    if kind == "length":
        return numpy.format_float_positional(_positive(name, value), trim="-") + "m"
    if kind == "bias":
        return ",".join(f"{radar}:{bias:g}" for radar, bias in value.items()) or "off"
    if kind == "dimensions":
        if len(value) != 3:
            raise ValueError(f"dims has {len(value)} numbers; it must have three: voxels to the east, north and upward")
        return "x".join(str(_whole("a number of dims", number, 1, 1 << 30)) for number in value)
    numbers = [numpy.format_float_positional(number, trim="-") for number in _numbers(name, value, *MEANINGS[kind])]
    return ",".join(number + "m" for number in numbers) if kind == "heights" else ",".join(numbers)


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
