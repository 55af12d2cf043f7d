# SPDX-License-Identifier: BSD-3-Clause
"""Draws the seam between two radars in two volumes: radar_seam.py BEFORE.nxv AFTER.nxv FIRST SECOND PICTURE.png [KM]

The volumes have the same grid and the ancillary arrays (`nexrad3d grid --overlap nearest --ancillary`,
with `--bias off` and `--bias auto`). FIRST and SECOND are names of radars. The maps show the
reflectivity KM kilometres above mean sea level (2 unless said), and the line where the nearest radar
changes. Printed is the step at that line at all heights: the mean of SECOND - FIRST over neighbouring
voxels, one on each side, whose own mean is 10 dBZ or more: a weaker value is interpolated with gates
that have none, which a bias does not change.
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot
import numpy
import vtknexrad

LEAST_ECHO = 10.0  # dBZ, mean of two voxels


def read(file):
    reader = vtknexrad.vtkNexradVolumeReader()
    reader.SetFileName(file)
    return vtknexrad.update(reader)


def nearest(volume, name):
    """Where a radar is the nearest that scanned the voxel (z, y, x)."""
    sites = volume.GetFieldData().GetAbstractArray("Sites")
    names = [sites.GetValue(index) for index in range(sites.GetNumberOfValues())]
    return vtknexrad.array(volume, "REF_site") == names.index(name)


def step(volume, first, second):
    """The mean step at the seam in dB, and the number of pairs of voxels that it is of."""
    value = vtknexrad.array(volume, "REF")
    echo = vtknexrad.array(volume, "REF_state") == 0
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
    east, north, _up = (axis / 1000.0 for axis in vtknexrad.axes(volume))
    echo = vtknexrad.array(volume, "REF_state")[level] == 0
    value = numpy.where(echo, vtknexrad.array(volume, "REF")[level], numpy.nan)
    mesh = plot.pcolormesh(east, north, value, shading="nearest", vmin=0.0, vmax=50.0, cmap="turbo")
    side = nearest(volume, second)[level].astype(float) - nearest(volume, first)[level]
    plot.contour(east, north, numpy.where(side == 0.0, numpy.nan, side), [0.0], colors="black", linewidths=1.0)
    plot.set(xlabel="km east", ylabel="km north", aspect="equal", title=title)
    return mesh


def main():
    before, after, first, second, picture = sys.argv[1:6]
    height = 1000.0 * float(sys.argv[6]) if len(sys.argv) > 6 else 2000.0
    figure, plots = matplotlib.pyplot.subplots(1, 2, figsize=(12, 5), layout="constrained", sharey=True)
    for plot, file, name in zip(plots, (before, after), ("biases not taken off", "biases taken off")):
        volume = read(file)
        mean, pairs = step(volume, first, second)
        print(f"{name}: step {second} - {first} {mean:+.2f} dB at {pairs} pairs of voxels")
        level = int(numpy.abs(vtknexrad.axes(volume)[2] - height).argmin())
        mesh = draw(plot, volume, first, second, level, f"{name}: step {mean:+.2f} dB")
    figure.colorbar(mesh, ax=plots, label=f"reflectivity {height / 1000.0:g} km above mean sea level, dBZ")
    synthetic = volume.GetFieldData().GetArray("Synthetic")
    if synthetic and synthetic.GetTuple1(0):
        figure.suptitle("SYNTHETIC")
    figure.savefig(picture, dpi=80)


if __name__ == "__main__":
    main()
