# SPDX-License-Identifier: BSD-3-Clause
"""Writes a merged volume as sparse OpenVDB grid, for Blender and Houdini: volume_to_openvdb.py VOLUME.nxv FILE.vdb

Voxels above a least value (0 by default, as 0 dBZ) are active; all others have this value as
background. Axes are those of the volume, in metres. The volume is read 64 rows at a time.
"""

import argparse
import sys

import numpy
import pyopenvdb
import vtknexrad

ROWS = 64  # those of the bricks of a large .nxv file


def empty_grid(frame, moment, least):
    """An OpenVDB grid with the axes of a volume, without voxels."""
    grid = pyopenvdb.FloatGrid(least)
    (x, y, z), origin = frame.image.GetSpacing(), frame.image.GetOrigin()
    grid.transform = pyopenvdb.createLinearTransform([[x, 0, 0, 0], [0, y, 0, 0], [0, 0, z, 0], [*origin, 1]])
    grid.updateMetadata({"name": moment, "unit": frame[moment].unit, "time": str(frame.time),
                         "radars": " ".join(frame.sites), "projection": frame.projection,
                         "synthetic": frame.synthetic})
    return grid


def grid_of(path, moment, level, least):
    """An OpenVDB grid of one moment of a volume."""
    frame = vtknexrad.Volume.open(path, moment, level, rows=(0, 1))
    if frame.is_geographic:
        raise vtknexrad.Error(f"{path}: its axes are degrees, and those of OpenVDB are metres")
    moment = frame.moments[0]
    grid = empty_grid(frame, moment, least)
    rows = vtknexrad.Volume.levels(path)[level][1]
    for first in range(0, rows, ROWS):
        part = vtknexrad.Volume.open(path, moment, level, rows=(first, min(first + ROWS, rows)))
        values = numpy.maximum(part[moment].filled(least), least).transpose(2, 1, 0)
        grid.copyFromArray(numpy.ascontiguousarray(values), ijk=(0, first, 0))  # OpenVDB does not look at strides
    return grid


def arguments():
    parser = argparse.ArgumentParser(description="Writes a merged volume as sparse OpenVDB grid.")
    parser.add_argument("volume", metavar="VOLUME.nxv", help="merged volume")
    parser.add_argument("file", metavar="FILE.vdb")
    parser.add_argument("--moment", help="as REF (default: the first of the volume)")
    parser.add_argument("--level", type=int, default=0, help="0, or that of coarser voxels in a large file (default 0)")
    parser.add_argument("--least", type=float, default=0.0, help="value of the background (default 0)")
    return parser.parse_args()


def main():
    given = arguments()
    grid = grid_of(given.volume, given.moment, given.level, given.least)
    pyopenvdb.write(given.file, grid)
    print(f"{given.file}: {grid['name']}, {grid.activeVoxelCount()} active voxels")


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"volume_to_openvdb.py: {error}")
