# SPDX-License-Identifier: BSD-3-Clause
"""Merges radar files into a Zarr store, as tasks of Dask: merge_with_dask.py STORE.zarr TIME[,TIME...] INPUT...

Tasks run `nexrad3d grid`, which writes volumes into the folder STORE.zarr.volumes: one for each time,
or with --parts one for each part of the radars, then one for each part of the rows, and one that joins
these. Then one task for each 64 rows of each volume reads these rows and writes them into the store.
All workers must see these paths.

Group 0 of the store is the dataset that Volume.to_xarray gives; 1, 2, ... have the levels of a large volume.
With zarr 3 the store has format 3, and a task writes one shard of each array. zarr 2 writes format 2,
in which each chunk is a file.
"""

import argparse
import glob
import os
import resource
import shlex
import subprocess
import sys

import dask.array
import numpy
import vtknexrad
import xarray
import zarr
from dask.distributed import Client
from vtknexrad.dataset import dataset_of_volumes

CHUNK = {"time": 1, "z": 8, "y": 64, "x": 64}  # the bricks of a large .nxv file
SHARDED = int(zarr.__version__.split(".")[0]) >= 3
CONVENTION = {"name": "multiscales", "uuid": "d35379db-88df-4056-af3a-620245f8e347",
              "spec_url": "https://github.com/zarr-conventions/multiscales/blob/v0.1/README.md"}


def merge(job, task=None, after=()):
    """A task: merges the files at a time, or does a part of that when the tasks before it are done. Gives the path of the volume."""
    folder, time, inputs, options = job
    command = ["nexrad3d", "grid", *inputs, "-o", folder, "--begin", time, "--end", time, "--quiet", *options]
    # Dask sets this for its workers; a merge would return memory all the time, and take twice as long.
    environment = {name: value for name, value in os.environ.items() if name != "MALLOC_TRIM_THRESHOLD_"}
    done = subprocess.run(command + (["--task", task] if task else []), stderr=subprocess.PIPE, text=True, env=environment)
    if done.returncode not in (0, 3):  # 3: some input was damaged or left out
        raise vtknexrad.Error(done.stderr.strip().splitlines()[-1])
    sys.stderr.write(done.stderr)
    return next(iter(glob.glob(os.path.join(glob.escape(folder), "*.nxv"))), None)


def merge_in_parts(client, job, parts):
    """The future of a volume, of which tasks decode and make a part each."""
    if parts == 1:
        return client.submit(merge, job)
    scans = [client.submit(merge, job, f"scan:{part}/{parts}") for part in range(1, parts + 1)]
    rows = [client.submit(merge, job, f"rows:{part}/{parts}", scans) for part in range(1, parts + 1)]
    return client.submit(merge, job, "join", rows)


def write_rows(volume, store, level, index, rows):
    """A task: writes rows of a level as those of time number `index`. Gives the process's largest memory, bytes."""
    data = vtknexrad.Volume.open(volume, level=level, rows=rows).to_xarray()
    # The frame has the attributes, and what has no rows. Tasks of the first time write what has no time.
    needed = {"y"} if index == 0 else {"time", "y"}
    data = data.drop_vars([name for name in data.variables if not needed <= set(data[name].dims)])
    for name in data.variables:
        data[name].attrs.clear()
    data.to_zarr(store, group=str(level), consolidated=False,
                 region={"time": slice(index, index + 1), "y": slice(*rows)})
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def write_frame(volumes, store, level, rows):
    """Writes coordinates, attributes and the sizes of the arrays. Gives the spacing along z, y and x."""
    parts = [vtknexrad.Volume.open(volume, level=level, rows=(0, 1)) for volume in volumes]
    if parts[0].ancillary and len({part.sites for part in parts}) > 1:
        raise vtknexrad.Error("the times have other radars, and ancillary arrays number them")
    data, image = dataset_of_volumes(parts), parts[0].image
    sizes = {**data.sizes, "y": rows}
    values = {"y": image.GetOrigin()[1] + image.GetSpacing()[1] * numpy.arange(rows)}
    divided = [name for name in data.variables if "y" in data[name].dims and name != "y"]
    for name in divided:  # dask computes none of these values
        shape = [sizes[dimension] for dimension in data[name].dims]
        values[name] = dask.array.empty(shape, dtype=data[name].dtype, chunks=-1)
    variables = {name: (data[name].dims, values.get(name, data[name].values), data[name].attrs)
                 for name in data.variables}
    frame = xarray.Dataset(variables, attrs=data.attrs).set_coords(list(data.coords))
    frame.to_zarr(store, group=str(level), mode="w-", compute=False, consolidated=False,
                  encoding={name: division(frame[name]) for name in divided})
    return numpy.array(image.GetSpacing()[::-1])


def division(variable):
    """Chunks, and shards that each belong to one task."""
    chunks = [CHUNK[dimension] for dimension in variable.dims]
    shards = [chunk if dimension in ("time", "y") else -(-variable.sizes[dimension] // chunk) * chunk
              for dimension, chunk in zip(variable.dims, chunks)]
    return {"chunks": tuple(chunks), "shards": tuple(shards)} if SHARDED else {"chunks": tuple(chunks)}


def multiscales(spacings):
    """The attributes that tell how the levels belong together."""
    scales = [[1.0, *numpy.rint(spacing / spacings[0])] for spacing in spacings]  # time, z, y, x
    layout = [{"asset": str(level), "derived_from": "0", "transform": {"scale": scale}}
              for level, scale in enumerate(scales)]
    del layout[0]["derived_from"]
    return {"zarr_conventions": [CONVENTION], "multiscales": {"layout": layout}}


def write_store(client, volumes, store):
    """Writes volumes of one grid into a new store. Gives what the tasks gave."""
    root = zarr.open_group(store, mode="w-")
    spacings, tasks = [], []
    for level, (_, rows, _) in enumerate(vtknexrad.Volume.levels(volumes[0])):
        spacings.append(write_frame(volumes, store, level, rows))
        tasks += [client.submit(write_rows, volume, store, level, index, (first, min(first + CHUNK["y"], rows)))
                  for index, volume in enumerate(volumes) for first in range(0, rows, CHUNK["y"])]
    memory = client.gather(tasks)
    root.attrs.update(multiscales(spacings))
    if not SHARDED:
        zarr.consolidate_metadata(store)  # no part of format 3
    return memory


def arguments():
    parser = argparse.ArgumentParser(description="Merges radar files into a Zarr store, as tasks of Dask.")
    parser.add_argument("store", metavar="STORE.zarr", help="is made; must not exist")
    parser.add_argument("times", metavar="TIME[,TIME...]", help="UTC, as in 2010-09-11T01:10")
    parser.add_argument("inputs", metavar="INPUT", nargs="+", help="files and folders, of any number of radars")
    parser.add_argument("--dims", default="256x256x128", help="voxels to the east, to the north and upward "
                        "(default 256x256x128)")
    parser.add_argument("--grid", default="", metavar="OPTIONS", help="further options of `nexrad3d grid`")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a cluster (default: a cluster on this machine)")
    parser.add_argument("--workers", type=int, default=2, help="processes of the cluster on this machine (default 2)")
    parser.add_argument("--parts", type=int, default=1, help="tasks that make a large volume together, best one for "
                        "each machine of the cluster (default 1)")
    return parser.parse_args()


def main():
    given = arguments()
    store = os.path.abspath(given.store)
    if os.path.exists(store):
        raise FileExistsError(f"{store}: exists already")
    times = given.times.split(",")
    folders = [os.path.join(store + ".volumes", time) for time in times]
    local = {"n_workers": given.workers, "threads_per_worker": 1, "dashboard_address": None}
    with Client(given.scheduler) if given.scheduler else Client(**local) as client:
        inputs, options = list(map(os.path.abspath, given.inputs)), ["--dims", given.dims, *shlex.split(given.grid)]
        jobs = [(folder, time, inputs, options) for folder, time in zip(folders, times)]
        volumes = client.gather([merge_in_parts(client, job, given.parts) for job in jobs])
        memory = write_store(client, volumes, store)
    print(f"{given.store}: {len(volumes)} times, {len(memory)} tasks of rows, largest process {max(memory) / 1e6:.0f} MB")


if __name__ == "__main__":
    try:
        main()
    except (OSError, vtknexrad.Error) as error:
        sys.exit(f"merge_with_dask.py: {error}")
