# SPDX-License-Identifier: BSD-3-Clause
"""Places computed without the project's library: T. Vincenty, Survey Review 23 (1975), direct formula; and the path
of a beam over an earth of 4/3 of its radius (Doviak and Zrnic, Doppler Radar and Weather Observations, 2.28)."""

import numpy

SEMI_MAJOR = 6378137.0  # m, WGS84
FLATTENING = 1.0 / 298.257223563


def destination(latitude, longitude, azimuth, distance):
    """Latitude and longitude in degrees, `distance` metres from a place, `azimuth` degrees from north."""
    b = SEMI_MAJOR * (1.0 - FLATTENING)
    a1 = numpy.radians(azimuth)
    u1 = numpy.arctan((1.0 - FLATTENING) * numpy.tan(numpy.radians(latitude)))
    sin_alpha = numpy.cos(u1) * numpy.sin(a1)
    square = 1.0 - sin_alpha ** 2
    sigma1 = numpy.arctan2(numpy.tan(u1), numpy.cos(a1))
    u2 = square * (SEMI_MAJOR ** 2 - b ** 2) / b ** 2
    A = 1.0 + u2 / 16384.0 * (4096.0 + u2 * (-768.0 + u2 * (320.0 - 175.0 * u2)))
    B = u2 / 1024.0 * (256.0 + u2 * (-128.0 + u2 * (74.0 - 47.0 * u2)))
    sigma = distance / (b * A)
    for _ in range(8):
        middle = numpy.cos(2.0 * sigma1 + sigma)
        sigma = distance / (b * A) + B * numpy.sin(sigma) * (
            middle + B / 4.0 * (numpy.cos(sigma) * (2.0 * middle ** 2 - 1.0) -
                                B / 6.0 * middle * (4.0 * numpy.sin(sigma) ** 2 - 3.0) * (4.0 * middle ** 2 - 3.0)))
    middle = numpy.cos(2.0 * sigma1 + sigma)
    across = numpy.sin(u1) * numpy.sin(sigma) - numpy.cos(u1) * numpy.cos(sigma) * numpy.cos(a1)
    phi = numpy.arctan2(numpy.sin(u1) * numpy.cos(sigma) + numpy.cos(u1) * numpy.sin(sigma) * numpy.cos(a1),
                        (1.0 - FLATTENING) * numpy.hypot(sin_alpha, across))
    turn = numpy.arctan2(numpy.sin(sigma) * numpy.sin(a1),
                         numpy.cos(u1) * numpy.cos(sigma) - numpy.sin(u1) * numpy.sin(sigma) * numpy.cos(a1))
    C = FLATTENING / 16.0 * square * (4.0 + FLATTENING * (4.0 - 3.0 * square))
    more = turn - (1.0 - C) * FLATTENING * sin_alpha * (
        sigma + C * numpy.sin(sigma) * (middle + C * numpy.cos(sigma) * (2.0 * middle ** 2 - 1.0)))
    return numpy.degrees(phi), longitude + numpy.degrees(more)


def beam(elevation, slant_range, radius=4.0 / 3.0 * 6371000.0):
    """Height above the antenna and distance along the ground in metres."""
    angle = numpy.radians(elevation)
    height = numpy.sqrt(slant_range ** 2 + radius ** 2 + 2.0 * slant_range * radius * numpy.sin(angle)) - radius
    return height, radius * numpy.arcsin(slant_range * numpy.cos(angle) / (radius + height))


def distance(latitude, longitude, other_latitude, other_longitude):
    """Metres between places that lie close together."""
    metre = numpy.pi * SEMI_MAJOR / 180.0
    north = (other_latitude - latitude) * metre
    east = (other_longitude - longitude) * metre * numpy.cos(numpy.radians(latitude))
    return numpy.hypot(east, north)
