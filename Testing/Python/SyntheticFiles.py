# SPDX-License-Identifier: BSD-3-Clause
"""A few synthetic radar files: those of NEXRAD_SYNTHETIC_FILES, else simulated once for all tests of a program."""

import atexit
import functools
import glob
import os
import shutil
import subprocess
import tempfile


@functools.lru_cache(maxsize=None)
def folder():
    """A folder that goes when the program ends."""
    path = tempfile.mkdtemp(prefix="nexrad-python-")
    atexit.register(shutil.rmtree, path)
    return path


@functools.lru_cache(maxsize=None)
def files():
    """Paths of 12 minutes of KLSX, from 18:00 UTC, in the order of time."""
    radar = os.environ.get("NEXRAD_SYNTHETIC_FILES")
    if radar is None:
        radar = os.path.join(folder(), "files")
        subprocess.run([os.environ["NEXRAD3D"], "simulate", radar, "--sites", "KLSX", "--hours", "0.2",
                        "--quiet"], check=True)
    paths = [path for path in glob.glob(os.path.join(radar, "**", "*"), recursive=True)
             if os.path.isfile(path)]
    return tuple(sorted(paths))


#: A domain that is so large that `nexrad3d grid` writes it in bricks and with levels (more than 2^27 voxels). Most of it
#: is far from the radar, so it takes a second.
LARGE = ("--dims", "4100x4100x8", "--axes", "geographic", "--bounds=-110,25,-72,55")


@functools.lru_cache(maxsize=None)
def large_volume():
    """Path of the volume of 18:05 UTC in the large domain."""
    path = os.path.join(folder(), "large")
    subprocess.run([os.environ["NEXRAD3D"], "grid", *files(), "-o", path, *LARGE, "--end", "2006-03-12T18:05", "--quiet"],
                   check=True)
    return glob.glob(os.path.join(path, "*.nxv"))[0]
