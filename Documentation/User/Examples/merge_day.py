# SPDX-License-Identifier: BSD-3-Clause
"""Merges radar files into volumes, one for each time step: merge_day.py FOLDER INPUT..."""

import argparse
import sys

import vtknexrad


def arguments():
    parser = argparse.ArgumentParser(description="Merges radar files into volumes, one for each time step.")
    parser.add_argument("folder", metavar="FOLDER", help="takes the volumes")
    parser.add_argument("inputs", metavar="INPUT", nargs="+", help="files and folders, of any number of radars")
    return parser.parse_args()


def main():
    given = arguments()
    series = vtknexrad.merge(given.inputs, dims=(128, 128, 64), step=300.0)  # s
    print(f"{', '.join(series.sites)}: {len(series)} volumes from {str(series.times[0])[:16]} UTC")
    index = series.write(given.folder, name="day.nxv.series")
    print(f"{index} written")


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"merge_day.py: {error}")
