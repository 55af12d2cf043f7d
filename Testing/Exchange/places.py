# SPDX-License-Identifier: BSD-3-Clause
"""Places on the ground: where a file has its columns, and where GDAL puts them."""

import json
import math
import subprocess

MOST_METRES = 50.0


def metres(first, second):
    """The distance of two places (longitude, latitude) that are near to each other."""
    north = (first[1] - second[1]) * 111_200.0
    east = math.remainder(first[0] - second[0], 360.0) * 111_320.0 * math.cos(math.radians(first[1]))
    return math.hypot(north, east)


def some_columns(dataset):
    """x, y, longitude and latitude of the corners and of some columns between them."""
    x, y = dataset["x"][:], dataset["y"][:]
    for row in range(0, len(y), 11):
        for column in range(0, len(x), 19):
            yield (x[column], y[row], dataset["longitude"][row, column], dataset["latitude"][row, column])


def gdal_info(source):
    return json.loads(
        subprocess.run(["gdalinfo", "-json", str(source)], capture_output=True, text=True, check=True).stdout
    )


def gdal_places(info, points, near):
    """Longitudes and latitudes of points in the projection of a file that `gdalinfo` described. The order of the two
    follows the version of GDAL: it is the one in which the first point is not far from `near`."""
    moved = subprocess.run(
        ["gdaltransform", "-s_srs", info["coordinateSystem"]["wkt"], "-t_srs", "EPSG:4326"],
        input="".join(f"{x} {y}\n" for x, y in points),
        capture_output=True,
        text=True,
        check=True,
    )
    places = [tuple(float(number) for number in line.split()[:2]) for line in moved.stdout.splitlines()]
    turned = abs(places[0][0] - near[0]) > abs(places[0][1] - near[0])
    return [place[::-1] for place in places] if turned else places
