# SPDX-License-Identifier: BSD-3-Clause
"""Merges radar files into volumes, one for each time step: merge_day.py FOLDER INPUT..."""

import os
import sys

import vtknexrad


def main():
    folder, inputs = sys.argv[1], sys.argv[2:]

    day = vtknexrad.vtkNexradDayReader()
    for path in inputs:  # files and folders, of any number of radars
        day.AddFileName(path)
    day.SetDimensions(128, 128, 64)
    day.SetTimeStep(300.0)  # s

    steps = vtknexrad.time_steps(day)
    sites = day.GetSites()
    names = [sites.GetValue(index) for index in range(sites.GetNumberOfValues())]
    print(f"{', '.join(names)}: {len(steps)} volumes from {steps[0]:%Y-%m-%d %H:%M} UTC")

    # The writer asks the reader for one time step after the other.
    os.makedirs(folder, exist_ok=True)
    writer = vtknexrad.vtkNexradVolumeWriter()
    writer.SetInputConnection(day.GetOutputPort())
    writer.SetFileName(os.path.join(folder, "day.nxv.series"))
    if not writer.Write():
        sys.exit("not all volumes were written")
    print(f"{writer.GetNumberOfWrittenFiles()} files in {folder}")


if __name__ == "__main__":
    main()
