# SPDX-License-Identifier: BSD-3-Clause
"""Draws the seam between two radars in two volumes: radar_seam.py BEFORE.nxv AFTER.nxv FIRST SECOND PICTURE.png [KM]

The volumes have the same grid and the ancillary arrays (`nexrad3d grid --overlap nearest --ancillary`,
with `--bias off` and `--bias auto`). FIRST and SECOND are names of radars. The maps show the
reflectivity KM kilometres above mean sea level (2 unless said), and the line where the nearest radar
changes. Printed is the step at that line at all heights: the mean of SECOND - FIRST over neighbouring
voxels, one on each side, whose own mean is 10 dBZ or more: a weaker value is interpolated with gates
that have none, which a bias does not change.
"""

import argparse
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot
import numpy
import vtknexrad

LEAST_ECHO = 10.0  # dBZ, mean of two voxels


def nearest(volume, name):
    """Where a radar is the nearest that scanned the voxel (z, y, x)."""
    if name not in volume.sites:
        raise vtknexrad.Error(f"no radar {name} in the volume; there are {', '.join(volume.sites)}")
    return volume["REF_site"].values.data == volume.sites.index(name)


def step(volume, first, second):
    """The mean step at the seam in dB, and the number of pairs of voxels that it is of."""
    reflectivity = volume["REF"]
    value, echo = reflectivity.values.data, reflectivity.where(vtknexrad.State.ECHO)
    sides = [echo & nearest(volume, name) for name in (first, second)]
    differences = []
    for axis in (1, 2):
        low, high = (numpy.s_[:, :-1], numpy.s_[:, 1:]) if axis == 1 else (numpy.s_[..., :-1], numpy.s_[..., 1:])
        for a, b in ((low, high), (high, low)):
            pairs = sides[0][a] & sides[1][b] & (value[a] + value[b] >= 2.0 * LEAST_ECHO)
            differences.append((value[b] - value[a])[pairs])
    differences = numpy.concatenate(differences)
    return differences.mean(), differences.size


def draw(plot, volume, first, second, level, title):
    east, north = volume.x / 1000.0, volume.y / 1000.0
    mesh = plot.pcolormesh(east, north, volume["REF"].values[level], shading="nearest", vmin=0.0, vmax=50.0, cmap="turbo")
    side = nearest(volume, second)[level].astype(float) - nearest(volume, first)[level]
    plot.contour(east, north, numpy.where(side == 0.0, numpy.nan, side), [0.0], colors="black", linewidths=1.0)
    plot.set(xlabel="km east", ylabel="km north", aspect="equal", title=title)
    return mesh


def arguments():
    parser = argparse.ArgumentParser(description="Draws the seam between two radars in two volumes.")
    parser.add_argument("before", metavar="BEFORE.nxv", help="volume with the ancillary arrays")
    parser.add_argument("after", metavar="AFTER.nxv", help="the same without biases")
    parser.add_argument("first", metavar="FIRST", help="name of a radar")
    parser.add_argument("second", metavar="SECOND", help="name of the other")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("height", metavar="KM", nargs="?", type=float, default=2.0, help="of the maps (default 2)")
    return parser.parse_args()


def main():
    given = arguments()
    first, second, height = given.first, given.second, 1000.0 * given.height
    figure, plots = matplotlib.pyplot.subplots(1, 2, figsize=(12, 5), layout="constrained", sharey=True)
    for plot, file, name in zip(plots, (given.before, given.after), ("biases not taken off", "biases taken off")):
        volume = vtknexrad.Volume.open(file)
        mean, pairs = step(volume, first, second)
        print(f"{name}: step {second} - {first} {mean:+.2f} dB at {pairs} pairs of voxels")
        level = int(numpy.abs(volume.z - height).argmin())
        mesh = draw(plot, volume, first, second, level, f"{name}: step {mean:+.2f} dB")
    figure.colorbar(mesh, ax=plots, label=f"reflectivity {height / 1000.0:g} km above mean sea level, dBZ")
    if volume.synthetic:
        figure.suptitle("SYNTHETIC")
    figure.savefig(given.picture, dpi=80)


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"radar_seam.py: {error}")
