# SPDX-License-Identifier: BSD-3-Clause
"""SYNTHETIC radar files and what nexrad3d makes of them, once for all tests of a process."""

import functools
import os
import pathlib
import subprocess
import tempfile

FOLDER = tempfile.TemporaryDirectory()


def nexrad3d(*arguments):
    run = subprocess.run([os.environ["NEXRAD3D"], *map(str, arguments)], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(run.stderr)
    return run.stdout


@functools.lru_cache(None)
def radar_files():
    """A quarter of an hour of three radars."""
    folder = pathlib.Path(FOLDER.name) / "radars"
    nexrad3d("simulate", folder, "--hours", "0.25", "--quiet")
    return folder


@functools.lru_cache(None)
def gridded(*options):
    """The folder with what `grid` makes with these options."""
    folder = pathlib.Path(tempfile.mkdtemp(dir=FOLDER.name))
    nexrad3d("grid", radar_files(), "-o", folder, "--dims", "96x80x24", "--quiet", *options)
    return folder


def volumes():
    """One NetCDF file of several times, of two moments with their ancillary arrays."""
    return gridded("--format", "nc", "--one-file", "--moment", "REF,VEL", "--ancillary") / "volumes.nc"
