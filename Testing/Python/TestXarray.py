# SPDX-License-Identifier: BSD-3-Clause
"""Datasets: their variables, coordinates and attributes, and xarray's own reading of them where it is installed."""

import functools
import importlib.util
import os
import subprocess
import sys
import types
import unittest
from unittest import mock

import numpy
import vtknexrad
from vtknexrad import State, dataset
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData

import SyntheticFiles

HAS_XARRAY = importlib.util.find_spec("xarray") is not None
HAS_NETCDF4 = importlib.util.find_spec("netCDF4") is not None
DIMS = (24, 20, 12)


@functools.lru_cache(maxsize=None)
def series():
    """Volumes that do not change; merged once."""
    merged = vtknexrad.merge(SyntheticFiles.files(), dims=DIMS, moments="REF,VEL", ancillary=True)
    return [merged[0], merged[1]]


def two_ranges():
    """A sweep whose reflectivity has gates of a kilometre, and velocity gates of 250 m."""
    return vtknexrad.open(SyntheticFiles.files()[0])[10]


def volume_of(time, sites, nearest):
    """A volume of 1 x 1 x 2 voxels whose nearest radar is the number `nearest` of `sites`."""
    image = vtkImageData()
    image.SetDimensions(1, 1, 2)
    for name, values in (("REF", numpy.array([30.0, 20.0], numpy.float32)), ("REF_state", numpy.array([0, 3], numpy.uint8)),
                         ("REF_site", numpy.array([nearest, 0], numpy.uint8))):
        scalars = numpy_to_vtk(values, deep=True)
        scalars.SetName(name)
        image.GetPointData().AddArray(scalars)
    image.GetPointData().SetActiveScalars("REF")
    names = vtkStringArray()
    names.SetName("Sites")
    for site in sites:
        names.InsertNextValue(site)
    seconds = numpy_to_vtk(numpy.array([time]), deep=True)
    seconds.SetName("TimeValue")
    for values in (names, seconds):
        image.GetFieldData().AddArray(values)
    return vtknexrad.Volume(image)


class Variables(unittest.TestCase):
    def test_dimensions_and_units(self):
        variables, coordinates, attributes = dataset.volume_variables(series())
        for name in ("REF", "VEL", "REF_state", "VEL_state", "REF_age", "VEL_radars", "REF_weight", "VEL_site"):
            dimensions, values, details = variables[name]
            self.assertEqual(dimensions, ("time", "z", "y", "x"))
            self.assertEqual(values.shape, (2, *DIMS[::-1]))
            self.assertIn("long_name", details)
            self.assertEqual(details["grid_mapping"], "projection")
        units = {name: variables[name][2]["units"] for name in ("REF", "VEL", "REF_age", "REF_radars")}
        self.assertEqual(units, {"REF": "dBZ", "VEL": "m s-1", "REF_age": "s", "REF_radars": "1"})
        self.assertEqual({name: coordinate[2].get("units") for name, coordinate in coordinates.items()},
                         {"time": None, "z": "m", "y": "m", "x": "m", "latitude": "degrees_north",
                          "longitude": "degrees_east"})
        self.assertEqual(coordinates["latitude"][0], ("y", "x"))
        self.assertEqual(coordinates["time"][1].dtype, numpy.dtype("datetime64[ns]"))
        self.assertEqual((attributes["sites"], attributes["synthetic"]), ("KLSX", 1))
        self.assertIn("SYNTHETIC", attributes["title"])

    def test_values(self):
        variables, coordinates, _ = dataset.volume_variables(series())
        for index, volume in enumerate(series()):
            self.assertEqual(coordinates["time"][1][index], volume.time)
            for name in ("REF", "VEL"):
                values = variables[name][1][index]
                numpy.testing.assert_array_equal(values, numpy.asarray(volume[name]))
                states = variables[name + "_state"][1][index]
                numpy.testing.assert_array_equal(numpy.isnan(values), states != State.ECHO)
        for axis in "xyz":
            numpy.testing.assert_array_equal(coordinates[axis][1], getattr(series()[0], axis))
        numpy.testing.assert_array_equal(coordinates["latitude"][1], series()[0].latitude)

    def test_states_are_flags(self):
        details = dataset.volume_variables(series())[0]["REF_state"][2]
        self.assertEqual(list(details["flag_values"]), [0, 1, 2, 3, 4])
        self.assertEqual(details["flag_meanings"], "echo no_echo range_folded not_scanned filtered")

    def test_the_grid_mapping_is_the_projection(self):
        volume = series()[0]
        details = dataset.volume_variables(series())[0]["projection"][2]
        self.assertEqual(details["grid_mapping_name"], "azimuthal_equidistant")
        self.assertEqual((details["latitude_of_projection_origin"], details["longitude_of_projection_origin"]),
                         volume.centre)
        self.assertIn(f"+lat_0={volume.centre[0]:g}", details["proj4_params"])

    def test_numbers_of_radars_count_in_all_sites(self):
        volumes = [volume_of(0.0, ["KAAA", "KBBB"], 1), volume_of(1.0, ["KCCC", "KBBB"], 0)]
        variables, _, attributes = dataset.volume_variables(volumes)
        self.assertEqual(attributes["sites"], "KAAA, KBBB, KCCC")
        # The second voxel was not scanned.
        self.assertEqual(variables["REF_site"][1].ravel().tolist(), [1, 255, 2, 255])

    def test_volumes_of_two_grids_are_refused(self):
        other = vtknexrad.merge(SyntheticFiles.files(), dims=(4, 4, 4))[0]
        with self.assertRaisesRegex(vtknexrad.Error, "has another grid than that of"):
            dataset.volume_variables([series()[0], other])
        lacking = vtknexrad.merge(SyntheticFiles.files(), dims=DIMS)[1]
        with self.assertRaisesRegex(vtknexrad.Error, "has no VEL, which that of"):
            dataset.volume_variables([series()[0], lacking])
        with self.assertRaisesRegex(vtknexrad.Error, "there are no volumes"):
            dataset.volume_variables([])

    def test_sweeps(self):
        sweep = two_ranges()
        self.assertEqual(sweep.moments, ("REF", "VEL", "SW"))  # of two gate geometries
        variables, coordinates, attributes = dataset.sweep_variables(sweep, True)
        order = numpy.argsort(sweep.azimuths)
        self.assertGreater(order[0], 0)  # the sweep begins elsewhere
        self.assertEqual(variables["REF"][0], ("azimuth", "range"))
        self.assertEqual(variables["VEL"][0], ("azimuth", "range_VEL"))
        self.assertEqual(variables["SW_state"][0], ("azimuth", "range_VEL"))
        for name in sweep:
            numpy.testing.assert_array_equal(variables[name][1], numpy.asarray(sweep[name])[order])
            numpy.testing.assert_array_equal(coordinates[variables[name][0][1]][1], sweep[name].ranges)
        for name, values in (("azimuth", sweep.azimuths), ("elevation", sweep.elevations), ("time", sweep.times)):
            numpy.testing.assert_array_equal(coordinates[name][1], values[order])
        numpy.testing.assert_array_equal(coordinates["latitude"][1], sweep.places()[order, :, 1])
        x, y, z = (coordinates[name][1] for name in "xyz")
        numpy.testing.assert_allclose(z, sweep.places()[order, :, 2], atol=0.01)
        turned = numpy.degrees(numpy.arctan2(x[:, 100], y[:, 100])) % 360.0
        numpy.testing.assert_allclose(turned, sweep.azimuths[order], atol=1e-4)
        self.assertEqual(coordinates["projection"][2]["latitude_of_projection_origin"], sweep.volume.position[0])
        self.assertEqual((attributes["instrument_name"], attributes["vcp"]), ("KLSX", 11))

    def test_rays_at_one_azimuth(self):
        azimuths = numpy.array([359.0, 1.0, 1.0, 1.0, 0.5], numpy.float32)
        rays = types.SimpleNamespace(azimuths=azimuths, elevations=azimuths, times=numpy.arange(5))
        order, coordinates = dataset.ray_coordinates(rays)
        self.assertEqual(order.tolist(), [4, 1, 2, 3, 0])
        sorted_azimuths = coordinates["azimuth"][1]
        self.assertTrue((numpy.diff(sorted_azimuths) > 0.0).all())
        numpy.testing.assert_allclose(sorted_azimuths, azimuths[order], atol=1e-6)


class Xarray(unittest.TestCase):
    def test_without_xarray_there_is_one_line(self):
        text = ("import sys; sys.modules['xarray'] = None\nimport vtknexrad\n"
                f"volume = vtknexrad.open({SyntheticFiles.files()[0]!r})[0]\n"
                "try:\n    volume.to_xarray()\nexcept ImportError as error:\n    print(error)\n")
        said = subprocess.run([sys.executable, "-c", text], check=True, capture_output=True, text=True).stdout
        self.assertEqual(said, "to_xarray needs the package xarray, which is not installed (Debian: python3-xarray)\n")

    @unittest.skipUnless(HAS_XARRAY, "xarray is not installed")
    def test_volumes(self):
        data = vtknexrad.merge(SyntheticFiles.files(), dims=DIMS)[:2].to_xarray()
        self.assertEqual(dict(data.sizes), {"time": 2, "z": 12, "y": 20, "x": 24})
        self.assertEqual(set(data.coords), {"time", "z", "y", "x", "latitude", "longitude"})
        self.assertEqual(data.REF.dims, ("time", "z", "y", "x"))
        first = data.sel(time="2006-03-12T18:05").sel(z=2000.0, method="nearest")
        self.assertEqual(first.REF.squeeze().dims, ("y", "x"))
        self.assertEqual(float(data.REF.max()), float(numpy.nanmax(data.REF.values)))
        self.assertEqual(series()[0].to_xarray().sizes["time"], 1)

    @unittest.skipUnless(HAS_XARRAY, "xarray is not installed")
    def test_sweeps(self):
        data = vtknexrad.open(SyntheticFiles.files()[0])[0].to_xarray()
        self.assertEqual(data.REF.dims, ("azimuth", "range"))
        self.assertEqual(set(data.coords), {"azimuth", "range", "elevation", "time", "x", "y", "z", "projection"})
        west = data.sel(azimuth=270.0, method="nearest")
        self.assertLess(abs(float(west.azimuth) - 270.0), 1.0)
        self.assertLess(float(west.x[100]), 0.0)

    @unittest.skipUnless(HAS_XARRAY and importlib.util.find_spec("dask"), "xarray or dask is not installed")
    def test_chunks_are_merged_when_they_are_asked_for(self):
        merged = vtknexrad.merge(SyntheticFiles.files(), dims=DIMS, moments="REF,VEL", ancillary=True)
        whole = merged.to_xarray()
        source = merged._source  # pylint: disable=protected-access
        with mock.patch.object(source, "at", wraps=source.at) as made:
            data = merged.to_xarray(chunks={"time": 1})
            self.assertEqual(made.call_count, 1)  # for names and attributes
            numpy.testing.assert_array_equal(data.REF[2].values, whole.REF[2].values)
            self.assertEqual(made.call_count, 2)
        self.assertEqual(data.REF.chunks[0], (1, 1, 1))
        self.assertTrue(data.load().identical(whole))
        self.assertEqual(merged.to_xarray(chunks={"x": 10}).REF.chunks[3], (10, 10, 4))

    @unittest.skipUnless(HAS_XARRAY, "xarray is not installed")
    def test_a_tree(self):
        import xarray
        radar = two_ranges().volume
        tree = mock.Mock()
        with mock.patch.object(xarray, "DataTree", tree, create=True):
            radar.to_xarray(states=True)
        (groups,), options = tree.from_dict.call_args
        self.assertEqual(options, {"name": "root"})
        self.assertEqual(list(groups), ["/", *(f"sweep_{index}" for index in range(len(radar)))])
        root = groups["/"]
        self.assertEqual((root.attrs["instrument_name"], root.attrs["simulated"], root.attrs["scan_name"]),
                         ("KLSX", "true", "VCP-11"))
        self.assertEqual((float(root.latitude), float(root.longitude), float(root.altitude)), radar.position)
        self.assertEqual(root.sweep_group_name.values.tolist(), list(groups)[1:])
        self.assertEqual(str(root.time_coverage_start.values), "2006-03-12T18:01:45Z")
        sweep, data = two_ranges(), groups["sweep_10"]
        self.assertEqual(set(data.coords), {"azimuth", "range", "elevation", "time", "latitude", "longitude", "altitude"})
        self.assertEqual(int(data.sweep_number), 10)
        order = numpy.argsort(sweep.azimuths)
        for name, theirs in (("REF", "DBZH"), ("VEL", "VRADH"), ("SW", "WRADH")):
            field = sweep[name]
            reach = data.range.values[(data.range > field.ranges[0] - 1.0) & (data.range < field.ranges[-1] + 1.0)]
            for gate in reach[::50]:
                nearest = int(numpy.abs(field.ranges - gate).argmin())
                at = data.sel(range=gate)
                numpy.testing.assert_array_equal(at[theirs].values, field.filled()[order, nearest])
                numpy.testing.assert_array_equal(at[theirs + "_state"].values, field.states[order, nearest])
            self.assertEqual(data[theirs].count(), numpy.isfinite(data[theirs].values).sum())
            self.assertTrue((numpy.isnan(data[theirs].values) == (data[theirs + "_state"].values != State.ECHO)).all())
        self.assertEqual(float(data.range[1] - data.range[0]), 250.0)

    @unittest.skipUnless(HAS_XARRAY, "xarray is not installed")
    def test_without_trees_there_is_one_line(self):
        import xarray
        if hasattr(xarray, "DataTree") or importlib.util.find_spec("datatree"):
            self.assertEqual(type(two_ranges().volume.to_xarray()).__name__, "DataTree")
        else:
            with self.assertRaisesRegex(ImportError, "^a tree needs xarray 2024.10 or later"):
                two_ranges().volume.to_xarray()

    @unittest.skipUnless(HAS_XARRAY and HAS_NETCDF4, "xarray or netCDF4 is not installed")
    def test_a_file_of_a_radar(self):
        import netCDF4
        import xarray
        sweep, path = two_ranges(), os.path.join(SyntheticFiles.folder(), "radar.nc")
        sweep.volume.write(path)
        with netCDF4.Dataset(path) as file:
            self.assertEqual((file.Conventions, file.version), ("Cf/Radial", "2.1"))
            self.assertEqual(len(file.groups), len(sweep.volume))
            self.assertEqual(file["sweep_10/DBZH"].dimensions, ("time", "range"))
            self.assertEqual(file["sweep_10/VRADH"].units, "m s-1")
        with xarray.open_dataset(path, group="sweep_10") as again:
            numpy.testing.assert_array_equal(again.time.values, numpy.sort(sweep.times))
            numpy.testing.assert_array_equal(again.azimuth.values, sweep.azimuths)
            at = numpy.searchsorted(again.range.values, sweep["VEL"].ranges)
            numpy.testing.assert_array_equal(again.VRADH.values[:, at], sweep["VEL"].filled())
        with self.assertRaisesRegex(vtknexrad.Error, "^/nowhere/radar.nc: cannot be written"):
            sweep.volume.write("/nowhere/radar.nc")
        self.assertFalse(os.path.exists(path + ".unfinished"))
        with mock.patch.dict("sys.modules", netCDF4=None), self.assertRaisesRegex(ImportError, "^write needs the package netCDF4"):
            sweep.volume.write(path)

    @unittest.skipUnless(HAS_XARRAY and HAS_NETCDF4, "xarray or netCDF4 is not installed")
    def test_a_file_of_it(self):
        import xarray
        path = os.path.join(SyntheticFiles.folder(), "volumes.nc")
        data = vtknexrad.merge(SyntheticFiles.files(), dims=DIMS, ancillary=True)[:2].to_xarray()
        data.to_netcdf(path)
        with xarray.open_dataset(path, decode_coords="all") as again:
            numpy.testing.assert_array_equal(again.REF.values, data.REF.values)
            numpy.testing.assert_array_equal(again.time.values, data.time.values)
            self.assertEqual(again.REF.attrs["units"], "dBZ")


if __name__ == "__main__":
    unittest.main()
