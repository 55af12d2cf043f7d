# SPDX-License-Identifier: BSD-3-Clause
"""The example merge_with_dask on clusters of this machine: its Zarr stores against whole merges, bit for bit."""

import functools
import importlib.util
import json
import os
import subprocess
import sys
import unittest

import numpy
import vtknexrad

import SyntheticFiles

MISSING = [name for name in ("dask", "distributed", "xarray", "zarr") if importlib.util.find_spec(name) is None]
DIMS = (80, 150, 20)  # three tasks of rows; no number of voxels is a multiple of those of a chunk
TIMES = ("2006-03-12T18:05", "2006-03-12T18:10")


def path_of(name):
    return os.path.join(SyntheticFiles.folder(), name)


def environment():
    """In which `nexrad3d` is the tested program."""
    return {**os.environ, "PATH": os.path.dirname(os.environ["NEXRAD3D"]) + os.pathsep + os.environ["PATH"]}


def example(*arguments):
    return subprocess.run([sys.executable, os.path.join(os.environ["NEXRAD_EXAMPLES"], "merge_with_dask.py"), *arguments],
                          env=environment(), capture_output=True, text=True)


@functools.lru_cache(maxsize=None)
def small_store():
    """Path of a store of two times in exact values, made by two processes, and what the example said."""
    path = path_of("small.zarr")
    done = example(path, ",".join(TIMES), *SyntheticFiles.files(), "--dims", "x".join(map(str, DIMS)), "--workers", "2",
                   "--grid", "--moment REF,VEL --ancillary --code exact")
    if done.returncode != 0:
        raise AssertionError(f"{done.returncode}\n{done.stderr}")
    return path, done.stdout


#: A cluster that prints its address, and ends with its input.
CLUSTER = """from dask.distributed import LocalCluster
if __name__ == "__main__":
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        print(cluster.scheduler_address, flush=True)
        input()
"""


def large_store():
    """Path of a store with levels, made by the processes of a cluster that runs already."""
    path, script = path_of("large.zarr"), path_of("cluster.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(CLUSTER)
    with subprocess.Popen([sys.executable, script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                          env=environment()) as cluster:
        address = cluster.stdout.readline().strip()
        done = example(path, TIMES[0], *SyntheticFiles.files(), "--dims", SyntheticFiles.LARGE[1], "--scheduler",
                       address, "--parts", "3", "--grid", " ".join(SyntheticFiles.LARGE[2:]))
        cluster.communicate("\n")
    if done.returncode != 0:
        raise AssertionError(f"{done.returncode}\n{done.stderr}")
    return path


def dataset(store, level, **options):
    import xarray
    return xarray.open_zarr(store, group=str(level), consolidated=False, **options)


def plain(attributes):
    """As JSON gives them, without what xarray adds to variables of floats."""
    return {name: numpy.asarray(value).tolist() for name, value in attributes.items() if name != "_FillValue"}


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)}")
class Stores(unittest.TestCase):
    def equal(self, ours, theirs, what=None):
        self.assertEqual((ours.dtype, ours.shape), (theirs.dtype, theirs.shape), what)
        # Of NaN, too.
        bits = [numpy.ascontiguousarray(one).view(f"u{one.itemsize}") for one in (ours, theirs)]
        self.assertTrue(numpy.array_equal(*bits), what)

    def test_every_voxel_is_that_of_the_whole_merge(self):
        store, said = small_store()
        self.assertRegex(said, r"^\S+: 2 times, 6 tasks of rows, largest process \d+ MB\n$")
        data = dataset(store, 0, mask_and_scale=False)  # which makes floats of numbers that may be missing
        merged = vtknexrad.merge(SyntheticFiles.files(), dims=DIMS, begin=TIMES[0], end=TIMES[1], moments="REF,VEL",
                                 ancillary=True).to_xarray()
        self.assertEqual(set(data.variables), set(merged.variables))
        self.assertEqual(set(data.coords), set(merged.coords))
        for name in merged.variables:
            self.equal(data[name].values, merged[name].values, name)
            self.assertEqual(data[name].dims, merged[name].dims, name)
            self.assertEqual(plain(data[name].attrs), plain(merged[name].attrs), name)
        self.assertEqual(plain(data.attrs), plain(merged.attrs))
        for name in ("REF", "VEL"):
            self.assertTrue(numpy.isfinite(data[name].values).any())

    def test_levels_are_those_of_the_file(self):
        store, volume = large_store(), SyntheticFiles.large_volume()
        levels = vtknexrad.Volume.levels(volume)
        self.assertEqual(len(levels), 5)
        for level, shape in enumerate(levels):
            data, whole = dataset(store, level, chunks=None), vtknexrad.Volume.open(volume, level=level)
            self.assertEqual(data.REF.shape, (1, *shape))
            for axis in "xyz":
                self.equal(data[axis].values, getattr(whole, axis), axis)
            field = whole["REF"]
            self.assertTrue(field.values.count())
            for first in range(0, shape[1], 1000):
                rows = slice(first, first + 1000)
                self.equal(data.REF_state[0, :, rows].values, field.states[:, rows])
                self.equal(data.REF[0, :, rows].values, numpy.ma.filled(field.values[:, rows], numpy.nan))
        import zarr
        attributes = zarr.open_group(store, mode="r").attrs
        self.assertEqual(attributes["zarr_conventions"][0]["name"], "multiscales")
        layout = attributes["multiscales"]["layout"]
        self.assertEqual([one["asset"] for one in layout], ["0", "1", "2", "3", "4"])
        self.assertEqual([one["transform"]["scale"] for one in layout], [[1, 1, size, size] for size in (1, 2, 4, 8, 16)])

    def test_chunks_lie_in_shards(self):
        import zarr
        store, _ = small_store()
        array = zarr.open_group(store, mode="r")["0/REF"]
        self.assertEqual(array.chunks, (1, 8, 64, 64))
        if int(zarr.__version__.split(".")[0]) < 3:
            self.skipTest(f"zarr {zarr.__version__} writes no shards; 3 does")
        self.assertEqual(array.shards, (1, 24, 64, 128))
        with open(os.path.join(store, "0", "REF", "zarr.json"), encoding="utf-8") as file:
            described = json.load(file)
        self.assertEqual((described["zarr_format"], described["codecs"][0]["name"]), (3, "sharding_indexed"))

    def test_a_store_that_exists_is_left(self):
        store, _ = small_store()
        done = example(store, TIMES[0], *SyntheticFiles.files())
        self.assertEqual((done.returncode, done.stderr), (1, f"merge_with_dask.py: {store}: exists already\n"))

    def test_what_grid_refuses_is_the_last_line(self):
        store = path_of("none.zarr")
        done = example(store, TIMES[0], "/nowhere/file", "--workers", "1")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.splitlines()[-1],
                         "merge_with_dask.py: nexrad3d grid: /nowhere/file: no such file or folder")
        self.assertFalse(os.path.exists(store))

    def test_without_arguments_it_says_how_it_is_used(self):
        done = example()
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertTrue(done.stderr.startswith("usage: merge_with_dask.py "), done.stderr)


if __name__ == "__main__":
    unittest.main()
