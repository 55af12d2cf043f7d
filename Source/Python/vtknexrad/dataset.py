# SPDX-License-Identifier: BSD-3-Clause
"""Volumes and sweeps as datasets of xarray, with the attributes of the CF conventions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy

from ._version import __version__
from .errors import Error
from .fields import Field, State

if TYPE_CHECKING:
    from .radar import Sweep
    from .volume import Volume

#: A variable as xarray takes it: dimensions, values, attributes.
Variable = tuple[Any, Any, dict[str, Any]]

#: Names of the table of CF standard names. The other moments have none.
STANDARD_NAMES = {"REF": "equivalent_reflectivity_factor",
                  "VEL": "radial_velocity_of_scatterers_away_from_instrument"}

#: Units as UDUNITS writes them, where VTK's text differs.
UNITS = {"m/s": "m s-1", "1/s": "s-1", "degrees": "degree", "degrees/km": "degree km-1", "": "1"}

LATITUDE = {"standard_name": "latitude", "long_name": "latitude on WGS84", "units": "degrees_north"}
LONGITUDE = {"standard_name": "longitude", "long_name": "longitude on WGS84", "units": "degrees_east"}
ALTITUDE = {"standard_name": "altitude", "long_name": "height above mean sea level", "units": "m",
            "positive": "up"}


def _xarray() -> Any:
    try:
        import xarray
    except ImportError:
        raise ImportError("to_xarray needs the package xarray, which is not installed "
                          "(Debian: python3-xarray)") from None
    return xarray


def dataset_of_volumes(volumes: Sequence[Volume]) -> Any:
    """A dataset (time, z, y, x) of volumes of one grid. Raises Error for others, and for none."""
    xarray = _xarray()
    variables, coordinates, attributes = volume_variables(volumes)
    return xarray.Dataset(variables, coordinates, attributes)


def dataset_of_sweep(sweep: Sweep, georeference: bool) -> Any:
    """A dataset (azimuth, range) of a sweep."""
    xarray = _xarray()
    variables, coordinates, attributes = sweep_variables(sweep, georeference)
    return xarray.Dataset(variables, coordinates, attributes)


def volume_variables(volumes: Sequence[Volume]) -> tuple[dict[str, Variable], dict[str, Variable], dict[str, Any]]:
    """Variables, coordinates and attributes of the dataset of volumes."""
    if not len(volumes):
        raise Error("there are no volumes")
    first = volumes[0]
    arrays: dict[str, numpy.ndarray[Any, Any]] = {}
    details: dict[str, dict[str, Any]] = {}
    times: list[numpy.datetime64] = []
    sites: list[str] = []
    synthetic = False
    for index, volume in enumerate(volumes):
        _check_like(volume, first)
        times.append(volume.time)
        synthetic = synthetic or volume.synthetic
        sites += [site for site in volume.sites if site not in sites]
        for name in first.moments + first.ancillary:
            field = volume[name]
            for part, values, attributes in _parts(field, first.ancillary):
                if name.endswith("_site"):
                    values = _renumber(values, volume.sites, sites)
                if part not in arrays:
                    arrays[part] = numpy.empty((len(volumes), *values.shape), values.dtype)
                    details[part] = {**attributes, "grid_mapping": "projection"}
                arrays[part][index] = values
    variables: dict[str, Variable] = {name: (("time", "z", "y", "x"), values, details[name]) for name, values in arrays.items()}
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
    return [(field.name, field.filled(), attributes), (beside[0], field.states, _state_attributes(field))]


def _state_attributes(field: Field) -> dict[str, Any]:
    attributes = {"long_name": f"State of {field.title}",
                  "flag_values": numpy.array([int(state) for state in State], numpy.uint8),
                  "flag_meanings": " ".join(state.name.lower() for state in State)}
    if field.name in STANDARD_NAMES:
        attributes["standard_name"] = f"{STANDARD_NAMES[field.name]} status_flag"
    return attributes


def _renumber(values: Any, own: Sequence[str], all_sites: Sequence[str]) -> Any:
    """Numbers of sites of one volume as those of all volumes; 255 stays."""
    table = numpy.full(256, 255, numpy.uint8)
    for number, site in enumerate(own):
        table[number] = all_sites.index(site)
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
    return {"grid_mapping_name": "azimuthal_equidistant", "latitude_of_projection_origin": latitude,
            "longitude_of_projection_origin": longitude, "false_easting": 0.0, "false_northing": 0.0, **ellipsoid}


def _global_attributes(method: str, sites: Sequence[str], synthetic: bool) -> dict[str, Any]:
    title = "Merged weather radar volumes" + (" (SYNTHETIC)" if synthetic else "")
    return {"Conventions": "CF-1.8", "title": title, "source": "weather radars: " + ", ".join(sites),
            "history": f"made by vtknexrad {__version__}", "sites": ", ".join(sites), "method": method,
            "synthetic": int(synthetic)}


def sweep_variables(sweep: Sweep, georeference: bool) -> tuple[dict[str, Variable], dict[str, Variable],
                                                               dict[str, Any]]:
    """Variables, coordinates and attributes of the dataset of a sweep."""
    variables: dict[str, Variable] = {}
    coordinates = _ray_coordinates(sweep)
    dimensions: list[tuple[str, Any]] = []
    for name in sweep.moments:
        field = sweep[name]
        assert field.ranges is not None
        dimension = next((known for known, ranges in dimensions if numpy.array_equal(ranges, field.ranges)), None)
        if dimension is None:
            dimension = f"range_{name}" if dimensions else "range"
            dimensions.append((dimension, field.ranges))
            coordinates[dimension] = (dimension, field.ranges, {
                "standard_name": "projection_range_coordinate", "long_name": "slant range to the centre of the gate",
                "units": "m", "axis": "radial_range_coordinate"})
        for part, values, attributes in _parts(field):
            variables[part] = (("azimuth", dimension), values, attributes)
    if georeference:
        places = sweep.places()
        for index, (name, attributes) in enumerate(
                (("longitude", LONGITUDE), ("latitude", LATITUDE), ("altitude", ALTITUDE))):
            coordinates[name] = (("azimuth", "range"), places[..., index], attributes)
    return variables, coordinates, _sweep_attributes(sweep)


def _ray_coordinates(sweep: Sweep) -> dict[str, Variable]:
    return {"azimuth": ("azimuth", sweep.azimuths, {
                "standard_name": "ray_azimuth_angle", "long_name": "clockwise from north", "units": "degrees",
                "axis": "radial_azimuth_coordinate"}),
            "elevation": ("azimuth", sweep.elevations, {
                "standard_name": "ray_elevation_angle", "long_name": "above the horizon", "units": "degrees",
                "axis": "radial_elevation_coordinate"}),
            "time": ("azimuth", sweep.times, {"standard_name": "time", "long_name": "time of the ray, UTC"})}


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
