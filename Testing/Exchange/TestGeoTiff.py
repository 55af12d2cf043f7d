# SPDX-License-Identifier: BSD-3-Clause
"""Maps of nexrad3d render as GDAL reads them."""

import pathlib
import unittest

import files
from places import MOST_METRES, gdal_info, gdal_places, metres, some_columns


class Gdal(unittest.TestCase):
    def test_maps_are_placed_and_named(self):
        import netCDF4

        volume = sorted(files.gridded("--format", "nxv").glob("*.nxv"))[0]
        for which, unit in (("composite", "dBZ"), ("echo-top", "m"), ("vil", "kg/m^2"),
                            ("vil-density", "g/m^3")):
            path = pathlib.Path(files.FOLDER.name) / f"{which}.tif"
            files.nexrad3d("render", volume, "-o", path, "--map", which, "--quiet")
            info = gdal_info(path)
            values, states = info["bands"]
            self.assertEqual((values["type"], values["noDataValue"]), ("Float32", -9999.0))
            self.assertEqual(values.get("unit"), unit)
            self.assertTrue(values["description"].startswith("SYNTHETIC: "))
            self.assertTrue(states["description"].startswith("State: "))
            left, width, _, top, _, height = info["geoTransform"]
            with netCDF4.Dataset(files.volumes()) as dataset:  # of the same grid
                columns = list(some_columns(dataset))
                x, y = dataset["x"][:], dataset["y"][:]
                self.assertAlmostEqual(left + 0.5 * width, x[0], 3)
                self.assertAlmostEqual(top + 0.5 * height, y[-1], 3)
                self.assertEqual(info["size"], [len(x), len(y)])
            places = gdal_places(info, [column[:2] for column in columns], near=columns[0][2:])
            away = max(metres(place, column[2:]) for place, column in zip(places, columns, strict=True))
            print(f"{which}: largest distance between GDAL and the columns: {away:.2f} m")
            self.assertLess(away, MOST_METRES)


if __name__ == "__main__":
    unittest.main()
