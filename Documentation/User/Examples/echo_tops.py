# SPDX-License-Identifier: BSD-3-Clause
"""Draws a map of the heights of echo tops: echo_tops.py VOLUME.nxv PICTURE.png [DBZ]

The echo top is the height of the highest voxel with at least that reflectivity (18 dBZ by default),
above mean sea level. Its error is up to half the distance between two levels of voxels.
"""

import argparse
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot
import numpy
import vtknexrad


def echo_tops(volume, threshold):
    """Heights in metres (y, x); NaN where no voxel reaches the threshold."""
    reached = vtknexrad.array(volume, "REF") >= threshold  # (z, y, x)
    height = vtknexrad.axes(volume)[2]
    highest = reached.shape[0] - 1 - numpy.argmax(reached[::-1], axis=0)
    return numpy.where(reached.any(axis=0), height[highest], numpy.nan)


def arguments():
    parser = argparse.ArgumentParser(description="Draws a map of the heights of echo tops.")
    parser.add_argument("volume", metavar="VOLUME.nxv", help="merged volume")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("threshold", metavar="DBZ", nargs="?", type=float, default=18.0, help="default 18")
    return parser.parse_args()


def main():
    given = arguments()
    volume = vtknexrad.Volume.open(given.volume)
    tops = echo_tops(volume.image, given.threshold)

    figure, plot = matplotlib.pyplot.subplots(figsize=(7, 6))
    mesh = plot.pcolormesh(volume.x / 1000.0, volume.y / 1000.0, tops / 1000.0, shading="nearest",
                           vmin=0.0, vmax=16.0)
    figure.colorbar(mesh, label=f"top of {given.threshold:g} dBZ, km above mean sea level")
    plot.set(xlabel="km east", ylabel="km north", aspect="equal",
             title=f"Echo tops, {str(volume.time)[:16].replace('T', ' ')} UTC")
    figure.savefig(given.picture, dpi=100)
    print(f"{numpy.isfinite(tops).sum()} columns, highest {numpy.nanmax(tops) / 1000.0:.1f} km")


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"echo_tops.py: {error}")
