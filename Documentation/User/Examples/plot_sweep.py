# SPDX-License-Identifier: BSD-3-Clause
"""Plots one sweep of a radar file: plot_sweep.py FILE PICTURE.png [SWEEP [MOMENT]]"""

import argparse
import sys

import matplotlib

matplotlib.use("Agg")
import vtknexrad


def arguments():
    parser = argparse.ArgumentParser(description="Plots one sweep of a radar file.")
    parser.add_argument("file", metavar="FILE", help="Level II file")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("sweep", metavar="SWEEP", nargs="?", type=int, default=0, help="number, from 0 (default 0)")
    parser.add_argument("moment", metavar="MOMENT", nargs="?", default="REF", help="REF, VEL, ... (default REF)")
    return parser.parse_args()


def main():
    given = arguments()
    sweep = vtknexrad.RadarVolume(given.file)[given.sweep]
    field = sweep[given.moment]  # values masked where there is none, with unit, states and ranges
    sweep.plot(given.moment).figure.savefig(given.picture, dpi=100)
    rays, gates = field.shape
    print(f"{rays} rays of {gates} gates, largest {field.name} {field.values.max():.1f}")


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"plot_sweep.py: {error}")
