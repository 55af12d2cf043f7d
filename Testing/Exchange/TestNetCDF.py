# SPDX-License-Identifier: BSD-3-Clause
"""A NetCDF file of nexrad3d grid as xarray, PROJ, GDAL, CDO, UDUNITS and checkers of the CF conventions read it."""

import subprocess
import unittest

import files
from places import MOST_METRES, gdal_info, gdal_places, metres, some_columns


class Xarray(unittest.TestCase):
    def test_dataset(self):
        import numpy
        import xarray

        with xarray.open_dataset(files.volumes(), mask_and_scale=True) as dataset:
            self.assertEqual(dataset.REF.dims, ("time", "z", "y", "x"))
            self.assertEqual(str(dataset.time.values[0]), "2006-03-12T18:05:00.000000000")
            self.assertGreater(dataset.sizes["time"], 1)
            self.assertEqual(set(dataset.REF.coords), {"time", "z", "y", "x", "latitude", "longitude"})
            self.assertEqual(list(dataset.radar_name.values), ["KEAX", "KILX", "KLSX"])
            self.assertTrue((dataset.radar_used == 1).all())
            self.assertIn("SYNTHETIC", dataset.title)
            # Where the state is echo there is a value, and nowhere else.
            numpy.testing.assert_array_equal(dataset.REF_state.values == 0, numpy.isfinite(dataset.REF.values))
            self.assertGreater(int((dataset.REF_state == 0).sum()), 1000)
            meanings = dataset.REF_state.flag_meanings.split()
            self.assertEqual(meanings, ["echo", "no_echo", "range_folded", "not_scanned", "filtered"])
            seen = dataset.REF_radars.values > 0
            numpy.testing.assert_array_equal(seen, numpy.isfinite(dataset.REF_age.values))
            for name in dataset.REF.ancillary_variables.split():
                self.assertIn(name, dataset)

    def test_one_file_for_each_time_has_the_same(self):
        import xarray

        folder = files.gridded("--format", "nc", "--moment", "REF,VEL", "--ancillary")
        paths = sorted(folder.glob("*.nc"))
        with xarray.open_dataset(files.volumes()) as all_times:
            self.assertEqual(len(paths), all_times.sizes["time"])
            for index, path in enumerate(paths):
                with xarray.open_dataset(path) as one:
                    for name in ("REF", "REF_state", "VEL", "REF_age", "latitude"):
                        expected = all_times[name].isel(time=[index]) if "time" in all_times[name].dims else all_times[name]
                        self.assertTrue(one[name].equals(expected), name)


class Proj(unittest.TestCase):
    def test_positions(self):
        import netCDF4
        import pyproj

        with netCDF4.Dataset(files.volumes()) as dataset:
            mapping = {name: dataset["projection"].getncattr(name) for name in dataset["projection"].ncattrs()}
            by_attributes = {name: value for name, value in mapping.items() if name not in ("crs_wkt", "proj4")}
            for crs in (pyproj.CRS.from_cf(by_attributes), pyproj.CRS.from_wkt(mapping["crs_wkt"])):
                to_places = pyproj.Transformer.from_crs(crs, "EPSG:4326", always_xy=True)
                away = max(
                    metres(to_places.transform(x, y), (longitude, latitude))
                    for x, y, longitude, latitude in some_columns(dataset)
                )
                print(f"largest distance between PROJ and the file: {away:.2f} m")
                self.assertLess(away, MOST_METRES)


class Gdal(unittest.TestCase):
    def test_positions_and_values(self):
        import netCDF4

        source = f"NETCDF:{files.volumes()}:REF"
        info = gdal_info(source)
        left, width, _, top, _, height = info["geoTransform"]
        self.assertLess(height, 0.0)
        with netCDF4.Dataset(files.volumes()) as dataset:
            columns = list(some_columns(dataset))
            self.assertEqual(len(info["bands"]), len(dataset["time"]) * len(dataset["z"]))
            self.assertAlmostEqual(left + 0.5 * width, dataset["x"][0], 3)
            self.assertAlmostEqual(top + 0.5 * height, dataset["y"][-1], 3)
        places = gdal_places(info, [column[:2] for column in columns], near=columns[0][2:])
        away = max(metres(place, column[2:]) for place, column in zip(places, columns, strict=True))
        print(f"largest distance between GDAL and the file: {away:.2f} m")
        self.assertLess(away, MOST_METRES)


def cdo(*words):
    """What the Climate Data Operators print; without the names of the radars, which are text and which they skip."""
    run = subprocess.run(["cdo", "-s", *map(str, words)], capture_output=True, text=True, check=True)
    warnings = [line for line in run.stderr.splitlines() if line and "skipped variable radar_name" not in line]
    assert not warnings, warnings
    return run.stdout


class Cdo(unittest.TestCase):
    """The Climate Data Operators, which take axes, projection and times from the conventions' attributes alone."""

    def test_axes_times_and_values(self):
        import netCDF4
        import numpy

        path = files.volumes()
        grid = dict(line.split(" = ", 1) for line in map(" ".join, map(str.split, cdo("griddes", path).splitlines()))
                    if " = " in line)
        with netCDF4.Dataset(path) as dataset:
            mapping = dataset["projection"]
            self.assertEqual(grid["grid_mapping_name"], mapping.grid_mapping_name)
            self.assertAlmostEqual(float(grid["latitude_of_projection_origin"]), mapping.latitude_of_projection_origin, 4)
            self.assertEqual((int(grid["xsize"]), int(grid["ysize"])), (len(dataset["x"]), len(dataset["y"])))
            self.assertAlmostEqual(float(grid["xinc"]), dataset["x"].spacing, 2)
            times = netCDF4.num2date(dataset["time"][:], dataset["time"].units)
            self.assertEqual(cdo("showtimestamp", path).split(), [time.strftime("%Y-%m-%dT%H:%M:%S") for time in times])
            levels = [float(word) for word in cdo("showlevel", "-selname,REF", path).split()]
            numpy.testing.assert_allclose(levels, dataset["z"][:], rtol=1e-5)
            mean = float(cdo("outputf,%.9g", "-fldmean,weights=FALSE", "-vertmean,weights=FALSE", "-timmean", "-selname,REF_state", path))
            self.assertAlmostEqual(mean, float(dataset["REF_state"][:].mean(dtype=float)), 3)


class Units(unittest.TestCase):
    """Each unit is one of UDUNITS, and can be converted to that of the standard name in the conventions' table."""

    CANONICAL = {
        "time": "s since 1970-01-01", "altitude": "m", "latitude": "degree_north", "longitude": "degree_east",
        "projection_x_coordinate": "m", "projection_y_coordinate": "m", "equivalent_reflectivity_factor": "dBZ",
        "radial_velocity_of_scatterers_away_from_instrument": "m s-1",
    }

    def test_units_are_those_of_udunits(self):
        import netCDF4

        with netCDF4.Dataset(files.volumes()) as dataset:
            known = [variable for variable in dataset.variables.values() if "units" in variable.ncattrs()]
            self.assertGreater(len(known), 10)
            for variable in known:
                name = getattr(variable, "standard_name", "")
                canonical = self.CANONICAL[name] if name and not name.endswith("status_flag") else "1"
                canonical = variable.units if not name else canonical
                with self.subTest(variable=variable.name):
                    run = subprocess.run(["udunits2", "-H", variable.units, "-W", canonical],
                                         capture_output=True, text=True, check=False)
                    self.assertEqual(run.returncode, 0, run.stderr)


class ConventionsIoos(unittest.TestCase):
    """IOOS's compliance-checker (pip install compliance-checker)."""

    def test_no_errors(self):
        run = subprocess.run(
            ["compliance-checker", "--test=cf:1.8", "--criteria=normal", str(files.volumes())],
            capture_output=True,
            text=True,
            check=False,
        )
        print(run.stdout)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)


class ConventionsCeda(unittest.TestCase):
    """The CF checker of CEDA (pip install cfchecker)."""

    def test_no_errors(self):
        run = subprocess.run(
            ["cfchecks", "-v", "1.8", str(files.volumes())], capture_output=True, text=True, check=False
        )
        print(run.stdout)
        self.assertIn("ERRORS detected: 0", run.stdout, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
