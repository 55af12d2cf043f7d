# SPDX-License-Identifier: BSD-3-Clause
"""Volumes and sweeps as datasets of xarray, with the attributes of the CF conventions."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Optional

import numpy
from numpy.typing import NDArray

from ._version import __version__
from .errors import Error, needed
from .fields import Field, State

if TYPE_CHECKING:
    from .radar import Sweep
    from .series import VolumeSeries
    from .volume import Volume

#: A variable as xarray takes it: dimensions, values, attributes.
Variable = tuple[Any, Any, dict[str, Any]]

#: An array of numpy or dask, and its attributes.
Array = tuple[Any, dict[str, Any]]

#: Names of the table of CF standard names. The other moments have none.
STANDARD_NAMES = {"REF": "equivalent_reflectivity_factor",
                  "VEL": "radial_velocity_of_scatterers_away_from_instrument"}

RANGE = {"standard_name": "projection_range_coordinate", "long_name": "slant range to the centre of the gate",
         "units": "m", "axis": "radial_range_coordinate"}

#: Units as UDUNITS writes them, where VTK's text differs.
UNITS = {"m/s": "m s-1", "1/s": "s-1", "degrees": "degree", "degrees/km": "degree km-1", "": "1"}

LATITUDE = {"standard_name": "latitude", "long_name": "latitude on WGS84", "units": "degrees_north"}
LONGITUDE = {"standard_name": "longitude", "long_name": "longitude on WGS84", "units": "degrees_east"}
ALTITUDE = {"standard_name": "altitude", "long_name": "height above mean sea level", "units": "m",
            "positive": "up"}


def import_xarray() -> Any:
    """The package xarray. Raises ImportError, in one line, where it is not installed."""
    return needed("to_xarray needs", "xarray", "python3-xarray")


def dataset_of_volumes(volumes: Sequence[Volume]) -> Any:
    """A dataset (time, z, y, x) of volumes of one grid. Raises Error for others, and for none."""
    xarray = import_xarray()
    variables, coordinates, attributes = volume_variables(volumes)
    return xarray.Dataset(variables, coordinates, attributes)


def lazy_dataset(series: VolumeSeries, chunks: Any) -> Any:
    """The same in chunks of dask, as xarray's Dataset.chunk takes them."""
    xarray = import_xarray()
    variables, coordinates, attributes = lazy_variables(series)
    return xarray.Dataset(variables, coordinates, attributes).chunk(chunks)


def dataset_of_sweep(sweep: Sweep, georeference: bool) -> Any:
    """A dataset (azimuth, range) of a sweep."""
    xarray = import_xarray()
    variables, coordinates, attributes = sweep_variables(sweep, georeference)
    return xarray.Dataset(variables, coordinates, attributes)


def volume_variables(volumes: Sequence[Volume]) -> tuple[dict[str, Variable], dict[str, Variable], dict[str, Any]]:
    """Variables, coordinates and attributes of the dataset of volumes."""
    first = _first_of(volumes)
    arrays: dict[str, Array] = {}
    times: list[numpy.datetime64] = []
    sites: list[str] = []
    synthetic = False
    for index in range(len(volumes)):
        volume = volumes[index] if index > 0 else first
        times.append(volume.time)
        synthetic = synthetic or volume.synthetic
        sites += [site for site in volume.sites if site not in sites]
        for part, (values, attributes) in _arrays_of(volume, first, sites).items():
            if part not in arrays:
                arrays[part] = numpy.empty((len(volumes), *values.shape), values.dtype), attributes
            arrays[part][0][index] = values
    return _join(first, arrays, times, sites, synthetic)


def lazy_variables(series: VolumeSeries) -> tuple[dict[str, Variable], dict[str, Variable], dict[str, Any]]:
    """The same of volumes of which dask reads or merges each when its values are asked for, one at a time."""
    array = needed("chunks need", "dask.array", "python3-dask")
    delayed = needed("chunks need", "dask.delayed", "python3-dask").delayed
    first = _first_of(series)
    sites = list(series.sites)
    alone = threading.Lock()  # a reader has one output

    def arrays_at(index: int) -> dict[str, Array]:
        with alone:
            return _arrays_of(series[index], first, sites)

    volumes = [delayed(arrays_at, pure=False)(index) for index in range(len(series))]
    arrays = {part: (array.stack([array.from_delayed(volume[part][0], values.shape, values.dtype) for volume in volumes]),
                     attributes)
              for part, (values, attributes) in _arrays_of(first, first, sites).items()}
    return _join(first, arrays, list(series.times), sites, first.synthetic)


def _first_of(volumes: Sequence[Volume]) -> Volume:
    if not len(volumes):
        raise Error("there are no volumes")
    return volumes[0]


def _arrays_of(volume: Volume, first: Volume, sites: Sequence[str]) -> dict[str, Array]:
    """The arrays of a volume and their attributes, by the names of their variables. Radars are numbered as in `sites`.

    Raises Error for a volume of another grid or other arrays than the first, or of a radar that is not in `sites`.
    """
    _check_like(volume, first)
    arrays: dict[str, Array] = {}
    for name in first.moments + first.ancillary:
        for part, values, attributes in _parts(volume[name], first.ancillary):
            arrays[part] = _renumber(values, volume, sites) if name.endswith("_site") else values, attributes
    return arrays


def _join(first: Volume, arrays: dict[str, Array], times: Sequence[numpy.datetime64], sites: Sequence[str],
          synthetic: bool) -> tuple[dict[str, Variable], dict[str, Variable], dict[str, Any]]:
    """Variables of volumes like the first, from their arrays (time, z, y, x)."""
    variables: dict[str, Variable] = {part: (("time", "z", "y", "x"), values, {**attributes, "grid_mapping": "projection"})
                                      for part, (values, attributes) in arrays.items()}
    variables["projection"] = ((), numpy.int32(0), _grid_mapping(first))
    coordinates = {"time": ("time", numpy.array(times, "datetime64[ns]"),
                            {"standard_name": "time", "long_name": "time of the volume, UTC", "axis": "T"}),
                   **_places(first)}
    return variables, coordinates, _global_attributes(first.method, sites, synthetic)


def _check_like(volume: Volume, first: Volume) -> None:
    """Raises Error for a volume of another grid or other arrays than the first."""
    same = (volume.shape == first.shape and volume.projection == first.projection and
            volume.image.GetOrigin() == first.image.GetOrigin() and
            volume.image.GetSpacing() == first.image.GetSpacing())
    if not same:
        raise Error(f"the volume of {volume.time} has another grid than that of {first.time}")
    absent = [name for name in first.moments + first.ancillary if name not in volume]
    if absent:
        raise Error(f"the volume of {volume.time} has no {absent[0]}, which that of {first.time} has")


def ranges_of(field: Field) -> NDArray[numpy.float64]:
    """Metres of slant range to the gates of a sweep's field."""
    assert field.ranges is not None
    return field.ranges


def _parts(field: Field, ancillary: tuple[str, ...] = ()) -> list[tuple[str, Any, dict[str, Any]]]:
    """The variables of a field: names, values, attributes."""
    attributes = {"long_name": field.title, "units": UNITS.get(field.unit, field.unit)}
    if field.name in ancillary:
        if field.values.dtype.kind == "u":
            return [(field.name, numpy.ma.filled(field.values, 255), {**attributes, "missing_value": numpy.uint8(255)})]
        return [(field.name, field.filled(), attributes)]
    if field.name in STANDARD_NAMES:
        attributes["standard_name"] = STANDARD_NAMES[field.name]
    beside = [f"{field.name}_state", *(name for name in ancillary if name.startswith(f"{field.name}_"))]
    attributes["ancillary_variables"] = " ".join(beside)
    return [(field.name, field.filled(), attributes),
            (beside[0], field.states, state_attributes(field, STANDARD_NAMES.get(field.name)))]


def state_attributes(field: Field, standard_name: Optional[str]) -> dict[str, Any]:
    """Attributes of the states of a field that has this CF standard name, or none."""
    attributes = {"long_name": f"State of {field.title}",
                  "flag_values": numpy.array([int(state) for state in State], numpy.uint8),
                  "flag_meanings": " ".join(state.name.lower() for state in State)}
    if standard_name:
        attributes["standard_name"] = f"{standard_name} status_flag"
    return attributes


def _renumber(values: Any, volume: Volume, sites: Sequence[str]) -> Any:
    """Numbers of radars of one volume as those in `sites`; 255 stays."""
    absent = [site for site in volume.sites if site not in sites]
    if absent:
        raise Error(f"the volume of {volume.time} has the radar {absent[0]}, which the others lack: read them without chunks")
    table = numpy.full(256, 255, numpy.uint8)
    for number, site in enumerate(volume.sites):
        table[number] = sites.index(site)
    return table[values]


def _places(volume: Volume) -> dict[str, Variable]:
    if volume.is_geographic:
        x, y = dict(LONGITUDE), dict(LATITUDE)
    else:
        x = {"standard_name": "projection_x_coordinate", "long_name": "distance east of the centre", "units": "m"}
        y = {"standard_name": "projection_y_coordinate", "long_name": "distance north of the centre", "units": "m"}
    return {"z": ("z", volume.z, {**ALTITUDE, "axis": "Z"}),
            "y": ("y", volume.y, {**y, "axis": "Y"}),
            "x": ("x", volume.x, {**x, "axis": "X"}),
            "latitude": (("y", "x"), volume.latitude, LATITUDE),
            "longitude": (("y", "x"), volume.longitude, LONGITUDE)}


def _grid_mapping(volume: Volume) -> dict[str, Any]:
    ellipsoid = {"semi_major_axis": 6378137.0, "inverse_flattening": 298.257223563, "proj4_params": volume.projection}
    if volume.is_geographic:
        return {"grid_mapping_name": "latitude_longitude", **ellipsoid}
    latitude, longitude = volume.centre
    return {**_equidistant(latitude, longitude), **ellipsoid}


def _equidistant(latitude: float, longitude: float) -> dict[str, Any]:
    return {"grid_mapping_name": "azimuthal_equidistant", "latitude_of_projection_origin": latitude,
            "longitude_of_projection_origin": longitude, "false_easting": 0.0, "false_northing": 0.0}


def _global_attributes(method: str, sites: Sequence[str], synthetic: bool) -> dict[str, Any]:
    title = "Merged weather radar volumes" + (" (SYNTHETIC)" if synthetic else "")
    return {"Conventions": "CF-1.8", "title": title, "source": "weather radars: " + ", ".join(sites),
            "history": f"made by vtknexrad {__version__}", "sites": ", ".join(sites), "method": method,
            "synthetic": int(synthetic)}


def sweep_variables(sweep: Sweep, georeference: bool) -> tuple[dict[str, Variable], dict[str, Variable],
                                                               dict[str, Any]]:
    """Variables, coordinates and attributes of the dataset of a sweep."""
    variables: dict[str, Variable] = {}
    order, coordinates = ray_coordinates(sweep)
    dimensions: list[tuple[str, Any]] = []
    for name in sweep.moments:
        field = sweep[name]
        gates = ranges_of(field)
        dimension = next((known for known, ranges in dimensions if numpy.array_equal(ranges, gates)), None)
        if dimension is None:
            dimension = f"range_{name}" if dimensions else "range"
            dimensions.append((dimension, gates))
            coordinates[dimension] = (dimension, gates, RANGE)
        for part, values, attributes in _parts(field):
            variables[part] = (("azimuth", dimension), values[order], attributes)
    for name, (values, attributes) in _gate_coordinates(sweep, georeference).items() if sweep.moments else ():
        coordinates[name] = (("azimuth", "range"), values[order], attributes)
    if sweep.volume.position is not None:
        for _, _, attributes in variables.values():
            attributes["grid_mapping"] = "projection"
        coordinates["projection"] = ((), numpy.int32(0), _equidistant(*sweep.volume.position[:2]))
    return variables, coordinates, _sweep_attributes(sweep)


def ray_coordinates(sweep: Sweep) -> tuple[NDArray[numpy.int64], dict[str, Variable]]:
    """The rays of a sweep in the order of their azimuths, and azimuth, elevation and time of each in this order.

    Azimuths increase: of two rays at the same azimuth the later one has the next larger number, so that rays can be
    selected by azimuth.
    """
    order = numpy.argsort(sweep.azimuths, kind="stable")
    azimuths = sweep.azimuths[order]
    for ray in numpy.flatnonzero(numpy.diff(azimuths) == 0.0) + 1:
        azimuths[ray:] = numpy.maximum(azimuths[ray:], numpy.nextafter(azimuths[ray - 1], numpy.float32(numpy.inf)))
    return order, {
        "azimuth": ("azimuth", azimuths, {
            "standard_name": "ray_azimuth_angle", "long_name": "clockwise from north", "units": "degrees",
            "axis": "radial_azimuth_coordinate"}),
        "elevation": ("azimuth", sweep.elevations[order], {
            "standard_name": "ray_elevation_angle", "long_name": "above the horizon", "units": "degrees",
            "axis": "radial_elevation_coordinate"}),
        "time": ("azimuth", sweep.times[order], {"standard_name": "time", "long_name": "time of the ray, UTC"})}


def _gate_coordinates(sweep: Sweep, georeference: bool) -> dict[str, tuple[Any, dict[str, str]]]:
    """x, y and z of the gates of the first moment, in metres, as float32: to 3 cm at 460 km. With `georeference`,
    longitude and latitude, too."""
    x, y, z = numpy.moveaxis(sweep.xyz().astype(numpy.float32), -1, 0)
    altitude = sweep.volume.position[2] if sweep.volume.position is not None else None
    away = {"standard_name": "projection_x_coordinate", "long_name": "distance east of the radar", "units": "m"}
    ahead = {"standard_name": "projection_y_coordinate", "long_name": "distance north of the radar", "units": "m"}
    height = {"standard_name": "height", "long_name": "height above the antenna", "units": "m", "positive": "up"}
    places = {"x": (x, away), "y": (y, ahead),
              "z": (z, height) if altitude is None else (z + numpy.float32(altitude), ALTITUDE)}
    if georeference:
        longitude, latitude, _ = numpy.moveaxis(sweep.places(), -1, 0)
        places.update(longitude=(longitude, LONGITUDE), latitude=(latitude, LATITUDE))
    return places


def _sweep_attributes(sweep: Sweep) -> dict[str, Any]:
    volume = sweep.volume
    attributes: dict[str, Any] = {
        "Conventions": "CF-1.8", "title": "Sweep of a weather radar" + (" (SYNTHETIC)" if volume.synthetic else ""),
        "instrument_name": volume.radar, "sweep_number": sweep.index, "fixed_angle": sweep.elevation,
        "history": f"made by vtknexrad {__version__}", "synthetic": int(volume.synthetic)}
    if volume.vcp is not None:
        attributes["vcp"] = volume.vcp
    if volume.position is not None:
        attributes.update(zip(("latitude", "longitude", "altitude"), volume.position))
    return attributes
