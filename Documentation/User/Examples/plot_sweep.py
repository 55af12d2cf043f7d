# SPDX-License-Identifier: BSD-3-Clause
"""Plots one sweep of a radar file: plot_sweep.py FILE PICTURE.png [SWEEP [MOMENT]]"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.colors
import matplotlib.pyplot
import numpy
import vtknexrad
from vtkmodules.util.numpy_support import vtk_to_numpy


def weather_service_colours():
    """The National Weather Service's steps of 5 dBZ, as matplotlib has them."""
    function = vtknexrad.vtkNexradTransferFunction()
    edges, colours = [], []
    for index in range(function.GetNumberOfBins()):
        step, lower, upper = [0.0] * 2, [0.0] * 3, [0.0] * 3
        function.GetBin(index, step, lower, upper)
        edges.append(step[0])
        colours.append(lower)
    colour_map = matplotlib.colors.ListedColormap(colours[:-1])
    colour_map.set_over(colours[-1])
    return colour_map, matplotlib.colors.BoundaryNorm(edges, len(colours) - 1)


def corners(centres):
    """Corners of the cells about the centres: half-way to the neighbours."""
    wider = numpy.pad(centres, 1, mode="reflect", reflect_type="odd")
    return (wider[:-1, :-1] + wider[:-1, 1:] + wider[1:, :-1] + wider[1:, 1:]) / 4.0


def main():
    file, picture = sys.argv[1:3]
    index = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    moment = sys.argv[4] if len(sys.argv) > 4 else "REF"

    reader = vtknexrad.vtkNexradLevel2Reader()
    reader.SetFileName(file)
    grid = vtknexrad.sweep(vtknexrad.update(reader), index, moment)
    values = vtknexrad.array(grid, moment)  # (ray, gate), NaN where there is no value
    points = vtk_to_numpy(grid.GetPoints().GetData()).reshape(values.shape + (3,))
    km = points / 1000.0  # east, north and up of the antenna

    look = {}
    if moment == "REF":
        look["cmap"], look["norm"] = weather_service_colours()
    figure, plot = matplotlib.pyplot.subplots(figsize=(7, 6))
    mesh = plot.pcolormesh(corners(km[..., 0]), corners(km[..., 1]), values, **look)
    figure.colorbar(mesh, label=moment)
    plot.set(xlabel="km east", ylabel="km north", aspect="equal",
             title=f"{vtknexrad.time_steps(reader)[0]:%Y-%m-%d %H:%M:%S} UTC, sweep {index}")
    figure.savefig(picture, dpi=100)
    print(f"{values.shape[0]} rays of {values.shape[1]} gates, "
          f"largest {moment} {numpy.nanmax(values):.1f}")


if __name__ == "__main__":
    main()
