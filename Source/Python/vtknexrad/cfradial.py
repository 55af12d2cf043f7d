# SPDX-License-Identifier: BSD-3-Clause
"""A volume of one radar in the groups, names and attributes of WMO FM301 and CfRadial 2.1."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy
from numpy.typing import NDArray

from . import dataset
from ._version import __version__
from .errors import Error, needed
from .fields import State
from .files import Path
from .vtkNexradIO import vtkNexradMoments

if TYPE_CHECKING:
    from .radar import RadarVolume, Sweep

#: Moments as FM301 names them, and its standard names. Others keep their names.
MOMENTS = {"REF": ("DBZH", "radar_equivalent_reflectivity_factor_h"),
           "VEL": ("VRADH", "radial_velocity_of_scatterers_away_from_instrument_h"),
           "SW": ("WRADH", "radar_doppler_spectrum_width_h"),
           "ZDR": ("ZDR", "radar_differential_reflectivity_hv"),
           "PHI": ("PHIDP", "radar_differential_phase_hv"),
           "RHO": ("RHOHV", "radar_correlation_coefficient_hv"),
           "CFP": ("CCORH", "clutter_correction_h")}

LACKING = ("a tree needs xarray 2024.10 or later, or the package xarray-datatree beside an older one; Sweep.to_xarray and "
           "RadarVolume.write need neither")


def tree_of_radar(radar: RadarVolume, states: bool) -> Any:
    """An xarray.DataTree of the groups. Raises ImportError where xarray has none."""
    xarray = dataset.import_xarray()
    from_dict = getattr(getattr(xarray, "DataTree", None), "from_dict", None)
    if from_dict is None:
        try:
            from datatree import DataTree
        except ImportError:
            raise ImportError(LACKING) from None
        from_dict = DataTree.from_dict
    return from_dict(datasets_of_radar(radar, states), name="root")


def write_radar(radar: RadarVolume, path: Path) -> None:
    """Writes the groups as a CfRadial 2 file, in which rays stand in the order of their times."""
    needed("write needs", "netCDF4", "python3-netcdf4")
    datasets = datasets_of_radar(radar, False)
    unfinished = f"{os.fspath(path)}.unfinished"
    try:
        datasets.pop("/").to_netcdf(unfinished, mode="w", engine="netcdf4")
        for name, sweep in datasets.items():
            by_time = sweep.sortby("time").swap_dims({"azimuth": "time"})
            packed = {field: {"zlib": True, "complevel": 1} for field in by_time.data_vars if by_time[field].ndim == 2}
            by_time.to_netcdf(unfinished, mode="a", group=name, engine="netcdf4", encoding=packed)
        os.replace(unfinished, path)
    except (OSError, ValueError) as error:
        raise Error(f"{os.fspath(path)}: cannot be written: {error}") from None
    finally:
        if os.path.exists(unfinished):
            os.remove(unfinished)


def datasets_of_radar(radar: RadarVolume, states: bool) -> dict[str, Any]:
    """Datasets by the names of their groups: "/", then "sweep_0" and so on. Sweeps without moments are left out; the
    others keep their numbers."""
    xarray = dataset.import_xarray()
    sweeps = [sweep for sweep in radar if sweep.moments]
    datasets = {"/": xarray.Dataset(_root_variables(radar, sweeps), attrs=_root_attributes(radar))}
    for sweep in sweeps:
        variables, coordinates = sweep_group(sweep, states)
        datasets[f"sweep_{sweep.index}"] = xarray.Dataset(variables, coordinates)
    return datasets


def _root_variables(radar: RadarVolume, sweeps: list[Sweep]) -> dict[str, dataset.Variable]:
    return {"volume_number": ((), numpy.int32(0), {}),
            "platform_type": ((), "fixed", {}),
            "instrument_type": ((), "radar", {}),
            "primary_axis": ((), "axis_z", {}),
            "time_coverage_start": ((), _second(radar.time), {}),
            "time_coverage_end": ((), _second(radar.end_time), {}),
            **_position(radar),
            "sweep_group_name": ("sweep", [f"sweep_{sweep.index}" for sweep in sweeps], {}),
            "sweep_fixed_angle": ("sweep", numpy.array([sweep.elevation for sweep in sweeps]), {"units": "degrees"})}


def _root_attributes(radar: RadarVolume) -> dict[str, Any]:
    return {"Conventions": "Cf/Radial", "version": "2.1",
            "title": "Volume of a weather radar" + (" (SYNTHETIC)" if radar.synthetic else ""),
            "instrument_name": radar.radar, "institution": "", "references": "",
            "source": os.path.basename(radar.path), "history": f"made by vtknexrad {__version__}", "comment": "",
            "platform_is_mobile": "false", "site_name": radar.radar,
            "scan_name": "" if radar.vcp is None else f"VCP-{radar.vcp}",
            "simulated": "true" if radar.synthetic else "false"}


def _second(time: numpy.datetime64) -> str:
    return f"{time.astype('datetime64[s]')}Z"


def _position(radar: RadarVolume) -> dict[str, dataset.Variable]:
    """Where the antenna is; NaN where that is unknown."""
    position = radar.position or (numpy.nan,) * 3
    attributes = (dataset.LATITUDE, dataset.LONGITUDE, dataset.ALTITUDE)
    return {details["standard_name"]: ((), value, details) for details, value in zip(attributes, position)}


def sweep_group(sweep: Sweep, states: bool) -> tuple[dict[str, dataset.Variable], dict[str, dataset.Variable]]:
    """Variables and coordinates of a sweep's group. All moments stand on one range, as FM301 has it: that of the finest
    gates. A gate of another moment is repeated over the finer ones that are nearest to it."""
    order, rays = dataset.ray_coordinates(sweep)
    fields = [sweep[name] for name in sweep.moments]
    gates = common_ranges([dataset.ranges_of(field) for field in fields])
    variables: dict[str, dataset.Variable] = {
        "sweep_number": ((), numpy.int32(sweep.index), {}),
        "sweep_mode": ((), "azimuth_surveillance", {}),
        "follow_mode": ((), "not_set", {}),
        "prt_mode": ((), "not_set", {}),
        "sweep_fixed_angle": ((), sweep.elevation, {"units": "degrees"}),
        "nyquist_velocity": ("azimuth", sweep.nyquist_velocity[order], {"long_name": "Nyquist velocity", "units": "m s-1"}),
        "unambiguous_range": ("azimuth", sweep.unambiguous_range[order], {"long_name": "unambiguous range", "units": "m"})}
    for field in fields:
        name, standard_name = MOMENTS.get(field.name, (field.name, None))
        unit = vtkNexradMoments.GetUnit(field.name)
        attributes = {"long_name": field.title, "units": dataset.UNITS.get(unit, unit)}
        if standard_name:
            attributes["standard_name"] = standard_name
        nearest = nearest_gates(gates, dataset.ranges_of(field))
        variables[name] = (("azimuth", "range"), _at(field.filled()[order], nearest, numpy.nan), attributes)
        if states:
            variables[f"{name}_state"] = (("azimuth", "range"), _at(field.states[order], nearest, State.NOT_SAMPLED),
                                          dataset.state_attributes(field, standard_name))
    range_attributes = {**dataset.RANGE, "spacing_is_constant": "true", "meters_to_center_of_first_gate": float(gates[0]),
                        "meters_between_gates": float(gates[1] - gates[0]) if len(gates) > 1 else numpy.nan}
    return variables, {**rays, "range": ("range", gates, range_attributes), **_position(sweep.volume)}


def common_ranges(all_ranges: list[NDArray[numpy.float64]]) -> NDArray[numpy.float64]:
    """Centres of the finest gates, from the nearest to the farthest of all.

    >>> common_ranges([numpy.array([0.0, 1000.0]), numpy.array([-250.0, 0.0, 250.0])]).tolist()
    [-250.0, 0.0, 250.0, 500.0, 750.0, 1000.0]
    """
    finest = min(all_ranges, key=lambda ranges: ranges[1] - ranges[0] if len(ranges) > 1 else numpy.inf)
    spacing = finest[1] - finest[0] if len(finest) > 1 else 1.0
    before = round((finest[0] - min(ranges[0] for ranges in all_ranges)) / spacing)
    after = round((max(ranges[-1] for ranges in all_ranges) - finest[-1]) / spacing)
    return finest[0] + spacing * numpy.arange(-before, len(finest) + after)


def nearest_gates(gates: NDArray[numpy.float64], ranges: NDArray[numpy.float64]) -> NDArray[numpy.int64]:
    """Of each gate the number of the one of `ranges` in which its centre lies; -1 in none.

    >>> nearest_gates(numpy.array([-250.0, 0.0, 250.0, 500.0, 1600.0]), numpy.array([0.0, 1000.0])).tolist()
    [0, 0, 0, 1, -1]
    """
    spacing = ranges[1] - ranges[0] if len(ranges) > 1 else 1.0
    number = numpy.floor((gates - ranges[0]) / spacing + 0.5).astype(numpy.int64)
    return numpy.where((number >= 0) & (number < len(ranges)), number, -1)


def _at(rows: NDArray[Any], gates: NDArray[numpy.int64], nothing: float) -> NDArray[Any]:
    """The columns of these numbers; `nothing` for -1."""
    return numpy.where(gates >= 0, rows[:, gates], rows.dtype.type(nothing))
