# SPDX-License-Identifier: BSD-3-Clause
"""One volume of one radar, as its Level II file has it: sweeps of rays of gates."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import Any, Iterator, Optional, Union, overload

import numpy
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection

from . import data, files
from .errors import OutOfRange, run, texts_of
from .fields import Field, State, masked, missing, moment_names
from .files import Path, one_of
from .merging import QUALITIES
from .times import datetime64_of, datetime64s_of, text_of
from .vtkNexradFilters import vtkNexradEchoClasses
from .vtkNexradIO import vtkNexradLevel2Reader, vtkNexradMoments


class RadarVolume(Sequence["Sweep"]):
    """A Level II file: a sequence of Sweep, in the order in which the radar scanned them.

    >>> radar = vtknexrad.open("KLSX20060312_180145")
    >>> radar
    <RadarVolume KLSX, VCP 11, 2006-03-12 18:01:45 UTC, 16 sweeps: REF, VEL, SW, SYNTHETIC>
    >>> str(radar.time)
    '2006-03-12T18:01:45.057000000'
    >>> [f"{elevation:.1f}" for elevation in radar.elevations[-3:]]
    ['14.0', '16.7', '19.5']
    >>> reflectivity = radar[0]["REF"]
    >>> reflectivity.unit, reflectivity.values.shape == (len(radar[0].azimuths), len(reflectivity.ranges))
    ('dBZ', True)
    """

    def __init__(self, path: Path, *, quality: str = "off", site: str = "",
                 position: Optional[tuple[float, float, float]] = None) -> None:
        """path: a Level II file in any form in which the archive has it, or a folder of real-time chunks.
        quality: gates of REF that quality control takes out at this level ("off", "standard" or
            "strict") have the state FILTERED and no value.
        site: name of the radar in place of the file's.
        position: latitude and longitude in degrees and height of the antenna in metres above mean sea
            level, in place of the file's (or of the table of sites).

        Raises FileNotFoundError, Error for a file without any ray, and ValueError for another quality.
        Warns with DamageWarning of a damaged file.
        """
        self.path = files.existing(path)  #: of the file
        self._level = one_of("quality", quality, QUALITIES)
        self._reader = vtkNexradLevel2Reader()
        self._reader.SetFileName(self.path)
        self._reader.SetSiteName(site)
        if position is not None:
            self._reader.SetSitePosition(*position)
            self._reader.SetUseSitePosition(True)
        #: the vtkPartitionedDataSetCollection, its points in metres east, north and up of the antenna
        self.collection = self._read()
        if self._level:
            self.collection = _with_classes(self.collection)

    @functools.cached_property
    def radar(self) -> str:
        """Name of the radar, as "KLSX"; empty when the file does not say it."""
        site = self.collection.GetFieldData().GetAbstractArray("Site")
        return "".join(texts_of(site)[:1])

    @functools.cached_property
    def position(self) -> Optional[tuple[float, float, float]]:
        """Latitude and longitude in degrees, height of the antenna in metres above mean sea level; None
        when unknown."""
        position = self.collection.GetFieldData().GetArray("Position")
        return None if position is None else position.GetTuple3(0)

    @functools.cached_property
    def vcp(self) -> Optional[int]:
        """Number of the volume coverage pattern; None when unknown."""
        number = self._number("VCP")
        return None if number is None else int(number)

    @functools.cached_property
    def time(self) -> numpy.datetime64:
        """The time of the first ray, in UTC."""
        return datetime64_of(self._number("StartTime") or 0.0)

    @functools.cached_property
    def end_time(self) -> numpy.datetime64:
        """The time of the last ray, in UTC."""
        return datetime64_of(self._number("EndTime") or 0.0)

    @functools.cached_property
    def synthetic(self) -> bool:
        """Whether the file was simulated: pictures must say so."""
        return bool(self._number("Synthetic"))

    @property
    def damage(self) -> tuple[str, ...]:
        """What was wrong in the file, one line each."""
        return texts_of(self._reader.GetDamage())

    @functools.cached_property
    def moments(self) -> tuple[str, ...]:
        """Names of the moments that any sweep has."""
        there = {name for sweep in self for name in sweep.moments}
        return tuple(name for name in moment_names() if name in there)

    @functools.cached_property
    def sweeps(self) -> tuple[Sweep, ...]:
        """The sweeps, in the order scanned."""
        return tuple(Sweep(self, index) for index in range(self.collection.GetNumberOfPartitionedDataSets()))

    @functools.cached_property
    def elevations(self) -> NDArray[numpy.float64]:
        """Degrees, mean of each sweep."""
        return numpy.array([sweep.elevation for sweep in self])

    def __len__(self) -> int:
        return self.collection.GetNumberOfPartitionedDataSets()  # type: ignore[no-any-return]

    @overload
    def __getitem__(self, index: int) -> Sweep: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Sweep, ...]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Sweep, tuple[Sweep, ...]]:
        """A sweep, counted from 0 in the order scanned. Raises OutOfRange, which is an IndexError."""
        if not isinstance(index, slice) and not -len(self) <= index < len(self):
            raise OutOfRange(f"no sweep {index}; there are {len(self)}, counted from 0")
        return self.sweeps[index]

    def __iter__(self) -> Iterator[Sweep]:
        return iter(self.sweeps)

    def geographic(self) -> Any:
        """The sweeps as `collection` has them, with points in degrees of longitude and latitude and metres
        above mean sea level. Raises Error when the position of the radar is unknown."""
        if self._geographic is None:
            self._reader.SetCoordinatesToGeographic()
            try:
                self._geographic = self._read()
            finally:
                self._reader.SetCoordinatesToLocal()
        return self._geographic

    _geographic: Any = None

    def to_xarray(self, states: bool = False) -> Any:
        """An xarray.DataTree in the groups, names and attributes of WMO FM301 and CfRadial 2.1, as xradar has them.

        The root has position and times; the group sweep_N has the sweep of the index N with the dimensions
        (azimuth, range), its rays in the order of their azimuths, and DBZH, VRADH, WRADH, ZDR, PHIDP, RHOHV and
        CCORH for REF, VEL, SW, ZDR, PHI, RHO and CFP. Where gates of moments differ, all stand on the finest
        ones; the others are repeated over these.

        states: adds NAME_state (State), which says why a gate has no value.

        Raises ImportError when xarray is not installed, or has no DataTree (before 2024.10).
        """
        from .cfradial import tree_of_radar
        return tree_of_radar(self, states)

    def write(self, path: Path) -> None:
        """Writes a CfRadial 2 file (NetCDF-4) with the groups of to_xarray, rays in the order of their times.

        Raises Error when it cannot be written, and ImportError when xarray or netCDF4 is not installed.
        """
        from .cfradial import write_radar
        write_radar(self, path)

    def __repr__(self) -> str:
        pattern = "" if self.vcp is None else f", VCP {self.vcp}"
        return (f"<RadarVolume {self.radar or 'of an unknown radar'}{pattern}, {text_of(self.time)}, "
                f"{len(self)} sweeps: {', '.join(self.moments)}{', SYNTHETIC' * self.synthetic}>")

    def _repr_html_(self) -> str:
        from .pictures import radar_html
        return radar_html(self)

    def _read(self) -> Any:
        run(self._reader, "Update")
        sweeps = vtkPartitionedDataSetCollection()
        sweeps.ShallowCopy(self._reader.GetOutputDataObject(0))
        return sweeps

    def _number(self, name: str) -> Optional[float]:
        values = self.collection.GetFieldData().GetArray(name)
        return None if values is None else float(values.GetComponent(0, 0))


def _with_classes(sweeps: Any) -> Any:
    classes = vtkNexradEchoClasses()
    classes.SetInputDataObject(0, sweeps)
    run(classes, "Update")
    return classes.GetOutputDataObject(0)


class Sweep:
    """One sweep: rays at an elevation, each with gates. A sweep without any moment has no rays.

    `sweep["REF"]` is a Field of shape (ray, gate), whose `ranges` are those of its gates.

    >>> sweep = vtknexrad.open("KLSX20060312_180145")[0]
    >>> sweep.moments
    ('REF',)
    >>> field = sweep["REF"]
    >>> field.ranges[:3]
    array([   0., 1000., 2000.])
    >>> bool((field.values.mask == ~field.where(State.VALID)).all())
    True
    """

    def __init__(self, volume: RadarVolume, index: int) -> None:
        self.volume = volume
        self.index = index  #: from 0, in the order scanned
        grids = volume.collection.GetPartitionedDataSet(index)
        self._grids = [grids.GetPartition(part) for part in range(grids.GetNumberOfPartitions())]

    @functools.cached_property
    def moments(self) -> tuple[str, ...]:
        """Names of the moments that the sweep has."""
        return tuple(name for name in moment_names()
                     if any(grid.GetPointData().HasArray(name) for grid in self._grids))

    @property
    def azimuths(self) -> NDArray[numpy.float32]:
        """Degrees clockwise from north, of each ray, in the order scanned."""
        return self._of_rays("RayAzimuth")

    @property
    def elevations(self) -> NDArray[numpy.float32]:
        """Degrees above the horizon, of each ray."""
        return self._of_rays("RayElevation")

    @functools.cached_property
    def elevation(self) -> float:
        """Degrees, mean of the rays; NaN for a sweep without moments."""
        return float(numpy.mean(self.elevations, dtype=float)) if self._grids else numpy.nan

    @functools.cached_property
    def times(self) -> NDArray[numpy.datetime64]:
        """The time of each ray, in UTC."""
        return datetime64s_of(self._of_rays("RayTime"))

    @property
    def ranges(self) -> NDArray[numpy.float64]:
        """Metres of slant range to the centres of the gates, of the first moment. Other moments may have
        other gates: see Field.ranges."""
        return self._ranges(self._grid(None))

    @property
    def nyquist_velocity(self) -> NDArray[numpy.float32]:
        """m/s, of each ray; 0 when unknown."""
        return self._of_rays("NyquistVelocity")

    @property
    def unambiguous_range(self) -> NDArray[numpy.float32]:
        """Metres, of each ray; 0 when unknown."""
        return self._of_rays("UnambiguousRange")

    @property
    def cut(self) -> int:
        """Number of the cut in the volume coverage pattern, from 1; 0 for a sweep without moments."""
        if not self._grids:
            return 0
        return int(self._grids[0].GetFieldData().GetArray("ElevationNumber").GetTuple1(0))

    def __getitem__(self, moment: str) -> Field:
        """The field of a moment. Raises UnknownName, which is a KeyError, with the moments that are
        there."""
        grid = self._grid(moment)
        values = self._rows(grid, moment)
        states = self._rows(grid, f"{moment}_state")
        if moment == "REF" and grid.GetPointData().HasArray("REF_class"):
            states = numpy.where(_taken_out(self.volume._level)[self._rows(grid, "REF_class")],
                                 numpy.uint8(State.FILTERED), states)
        return Field(moment, vtkNexradMoments.GetTitle(moment), vtkNexradMoments.GetUnit(moment),
                     masked(values, states != State.VALID), states, self._ranges(grid))

    def __contains__(self, moment: object) -> bool:
        return moment in self.moments

    def __iter__(self) -> Iterator[str]:
        return iter(self.moments)

    def xyz(self, moment: Optional[str] = None) -> NDArray[numpy.float64]:
        """Metres east, north and up of the antenna, (ray, gate, 3), of a moment's gates.

        moment: None for the first.
        """
        return self._points(self._grid(moment))

    def places(self, moment: Optional[str] = None) -> NDArray[numpy.float64]:
        """Longitude and latitude in degrees and metres above mean sea level, (ray, gate, 3), of a moment's
        gates. Longitudes count on past 180 degrees where a sweep crosses the antimeridian.

        moment: None for the first. Raises Error when the position of the radar is unknown.
        """
        self._grid(moment)  # raises for a moment that is not there
        return self._points(data.sweep(self.volume.geographic(), self.index, moment or self.moments[0]))

    def to_xarray(self, georeference: bool = False) -> Any:
        """An xarray.Dataset with the dimensions (azimuth, range), its rays in the order of their azimuths.

        Coordinates: azimuth, range, of each ray elevation and time, and of each gate of the first moment x, y
        and z, in metres east and north of the radar and above mean sea level (above the antenna where its
        position is unknown). Moments NAME whose gates differ from those of the first have a dimension of
        their own, range_NAME. Each is float32 with NaN where there is no value, and has NAME_state (State)
        beside it. Every variable has its unit.

        georeference: adds latitude and longitude of each gate of the first moment.

        Raises ImportError when xarray is not installed.
        """
        from .dataset import dataset_of_sweep
        return dataset_of_sweep(self, georeference)

    def plot(self, moment: Optional[str] = None, ax: Any = None) -> Any:
        """Draws the sweep with matplotlib, as seen from above, and returns its axes.

        moment: None for the first. ax: matplotlib axes; None for new ones.
        """
        from .pictures import plot_sweep
        return plot_sweep(self, moment, ax)

    def __repr__(self) -> str:
        return (f"<Sweep {self.index} at {self.elevation:.2f} degrees: {', '.join(self.moments)}, "
                f"{len(self.azimuths)} rays>")

    def _repr_html_(self) -> str:
        from .pictures import sweep_html
        return sweep_html(self)

    def _grid(self, moment: Optional[str]) -> Any:
        """The grid of a moment; None: of the first."""
        wanted = moment or (self.moments[0] if self.moments else "moment")
        for grid in self._grids:
            if grid.GetPointData().HasArray(wanted) and wanted in self.moments:
                return grid
        raise missing(wanted, self.moments, f"sweep {self.index}")

    def _of_rays(self, name: str) -> NDArray[Any]:
        if not self._grids:
            return numpy.empty(0, numpy.float32)
        return vtk_to_numpy(self._grids[0].GetFieldData().GetArray(name))

    def _rows(self, grid: Any, name: str) -> NDArray[Any]:
        # The grid of a full circle has the first ray once more at its end.
        return data.array(grid, name)[:grid.GetFieldData().GetArray("RayTime").GetNumberOfTuples()]

    def _points(self, grid: Any) -> NDArray[numpy.float64]:
        gates, rows, _ = _dimensions(grid)
        points = vtk_to_numpy(grid.GetPoints().GetData()).reshape(rows, gates, 3)
        return points[:grid.GetFieldData().GetArray("RayTime").GetNumberOfTuples()]

    def _ranges(self, grid: Any) -> NDArray[numpy.float64]:
        first, spacing = grid.GetFieldData().GetArray("GateGeometry").GetTuple2(0)
        return first + spacing * numpy.arange(_dimensions(grid)[0])


def _dimensions(grid: Any) -> list[int]:
    dimensions = [0, 0, 0]
    grid.GetDimensions(dimensions)
    return dimensions


def _taken_out(level: int) -> NDArray[numpy.bool_]:
    """Of each echo class, whether quality control at the level takes it out."""
    return numpy.array([vtkNexradEchoClasses.IsTakenOut(level, number)
                        for number in range(vtkNexradEchoClasses.GetNumberOfEchoClasses())])
