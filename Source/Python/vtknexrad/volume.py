# SPDX-License-Identifier: BSD-3-Clause
"""A merged volume: fields on a grid of voxels, with their places and their time."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, Iterator, Optional

import numpy
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData

from . import data, files
from .errors import Error, errors_of, needed, texts_of
from .files import Path
from .fields import ANCILLARY, Field, State, masked, missing, moment_names
from .pages import Page, make_page
from .times import datetime64_of, text_of
from .vtkNexradIO import vtkNexradGeographicCoordinates, vtkNexradMoments

if TYPE_CHECKING:
    from .fields import MaskedArray


class Volume:
    """Radars merged at one time: a field for each moment, on one grid.

    `volume["REF"]` is a Field of shape (z, y, x). Arrays share the memory of `image`.

    >>> volume = vtknexrad.open("volumes/20060312T180500Z.nxv")
    >>> volume
    <Volume 2006-03-12 18:05:00 UTC of KLSX: REF on 64 x 64 x 32 voxels, SYNTHETIC>
    >>> field = volume["REF"]
    >>> field.unit, field.values.shape
    ('dBZ', (32, 64, 64))
    >>> bool(field.values.mask.sum() == field.values.size - field.where(State.ECHO).sum())
    True
    """

    def __init__(self, image: Any) -> None:
        """image: a vtkImageData as vtkNexradVolumeReader and vtkNexradDayReader give it. The volume keeps its
        arrays, also when the reader gives others later.

        >>> reader = vtknexrad.vtkNexradVolumeReader()
        >>> reader.SetFileName("volumes/volumes.nxv.series")
        >>> vtknexrad.Volume(vtknexrad.update(reader, "2006-03-12T18:10"))
        <Volume 2006-03-12 18:10:00 UTC of KLSX: REF on 64 x 64 x 32 voxels, SYNTHETIC>
        """
        self.image = vtkImageData()  #: the vtkImageData
        self.image.ShallowCopy(image)

    @classmethod
    def open(cls, path: Path, moments: Optional[str] = None, level: int = 0,
             rows: Optional[tuple[int, int]] = None) -> Volume:
        """Reads a .nxv file; of an index, its first volume.

        moments: names of moments to read, as "VEL,REF"; None for all.
        level: 0 for the voxels of the volume, 1 for the next larger ones, as `levels` lists them.
        rows: the first row along y, and the one after the last; None for all. Of a file in bricks
            (`nexrad3d grid` writes large volumes so) only those of the rows are read.

        Raises FileNotFoundError, Error for what is no volume or has no such moment, and OutOfRange,
        which is an IndexError, for a level or rows that are not there.

        >>> vtknexrad.Volume.open("volumes/20060312T180500Z.nxv", rows=(16, 24)).shape
        (32, 8, 64)
        """
        return cls(files.part_of_volume(path, moments, level, rows))

    @staticmethod
    def levels(path: Path) -> list[tuple[int, int, int]]:
        """Voxels along z, y and x of the volume in a .nxv file and of its coarser levels.

        Raises FileNotFoundError, and Error for what is no volume.

        >>> vtknexrad.Volume.levels("volumes/20060312T180500Z.nxv")
        [(32, 64, 64)]
        """
        return files.levels_of_volume(path)

    @functools.cached_property
    def time(self) -> numpy.datetime64:
        """The time of the volume, in UTC."""
        return datetime64_of(float(self._values("TimeValue", 0.0)[0]))

    @functools.cached_property
    def sites(self) -> tuple[str, ...]:
        """Names of the radars that took part."""
        return self._texts("Sites")

    @functools.cached_property
    def method(self) -> str:
        """"beam" or "thesis"; empty when unknown."""
        return "".join(self._texts("Method")[:1])

    @functools.cached_property
    def synthetic(self) -> bool:
        """Whether it was made of simulated files: pictures must say so."""
        return bool(self._values("Synthetic", 0)[0])

    @functools.cached_property
    def sharpened(self) -> bool:
        """Whether REF was deconvolved in elevation: column maxima are higher than measured."""
        return bool(self._values("Sharpened", 0)[0])

    @functools.cached_property
    def projection(self) -> str:
        """What x and y are, as a PROJ string."""
        return "".join(self._texts("Projection")[:1])

    @property
    def is_geographic(self) -> bool:
        """Whether x and y are degrees of longitude and latitude in place of metres."""
        return "+proj=longlat" in self.projection

    @functools.cached_property
    def centre(self) -> tuple[float, float]:
        """Latitude and longitude in degrees of the point about which x and y count."""
        latitude, longitude = self._values("ProjectionCenter", numpy.nan, 2)
        return float(latitude), float(longitude)

    @property
    def x(self) -> NDArray[numpy.float64]:
        """Centres of the voxels, metres east of the centre (degrees when is_geographic)."""
        return data.axes(self.image)[0]

    @property
    def y(self) -> NDArray[numpy.float64]:
        """Centres of the voxels, metres north of the centre (degrees when is_geographic)."""
        return data.axes(self.image)[1]

    @property
    def z(self) -> NDArray[numpy.float64]:
        """Centres of the voxels, metres above mean sea level."""
        return data.axes(self.image)[2]

    @property
    def shape(self) -> tuple[int, int, int]:
        """Voxels along z, y and x."""
        x, y, z = self.image.GetDimensions()
        return z, y, x

    @property
    def latitude(self) -> NDArray[numpy.float64]:
        """Degrees north on WGS84, of each column (y, x).

        >>> volume = vtknexrad.open("volumes/20060312T180500Z.nxv")
        >>> volume.latitude.shape
        (64, 64)
        """
        return self._places[..., 1]

    @property
    def longitude(self) -> NDArray[numpy.float64]:
        """Degrees east on WGS84, -180 to 180, of each column (y, x)."""
        return self._places[..., 0]

    def xy(self, latitude: Any, longitude: Any) -> tuple[NDArray[numpy.float64], NDArray[numpy.float64]]:
        """x and y of places, in the units of the attributes x and y; numbers or arrays.

        >>> volume = vtknexrad.open("volumes/20060312T180500Z.nxv")
        >>> x, y = volume.xy(*volume.centre)
        >>> float(abs(x) + abs(y)) < 1e-6
        True
        """
        longitudes, latitudes = numpy.broadcast_arrays(longitude, latitude)
        pairs = self._convert(vtkNexradGeographicCoordinates.FromGeographic,
                              numpy.stack([longitudes, latitudes], axis=-1).astype(float))
        return pairs[..., 0], pairs[..., 1]

    @functools.cached_property
    def moments(self) -> tuple[str, ...]:
        """Names of the moments; the first is the volume's own."""
        points = self.image.GetPointData()
        there = [name for name in moment_names() if points.HasArray(name)]
        first = points.GetScalars().GetName() if points.GetScalars() else None
        return tuple(sorted(there, key=lambda name: name != first))

    @functools.cached_property
    def ancillary(self) -> tuple[str, ...]:
        """Names of the ancillary arrays, as "REF_age"; empty where the merge made none."""
        points = self.image.GetPointData()
        names = [f"{moment}_{ending}" for moment in self.moments for ending, _, _ in ANCILLARY]
        return tuple(name for name in names if points.HasArray(name))

    def __getitem__(self, name: str) -> Field:
        """The field of a moment or of an ancillary array. Ancillary arrays are masked where nothing was
        scanned, and have the states of their moment.

        Raises UnknownName, which is a KeyError, with the names that are there.
        """
        if name in self.moments:
            states = data.array(self.image, f"{name}_state")
            return Field(name, vtkNexradMoments.GetTitle(name), vtkNexradMoments.GetUnit(name),
                         masked(data.array(self.image, name), states != State.ECHO), states)
        if name in self.ancillary:
            moment, ending = name.rsplit("_", 1)
            states = data.array(self.image, f"{moment}_state")
            title, unit = {end: rest for end, *rest in ANCILLARY}[ending]
            return Field(name, title, unit,
                         masked(data.array(self.image, name), states == State.NOT_SCANNED), states)
        raise missing(name, self.moments + self.ancillary, "the volume")

    def __contains__(self, name: object) -> bool:
        return name in self.moments or name in self.ancillary

    def __iter__(self) -> Iterator[str]:
        return iter(self.moments)

    def composite(self, moment: Optional[str] = None) -> MaskedArray:
        """The strongest value of each column (y, x): the largest; of moments with two signs, as VEL,
        the value farthest from 0. Masked where a column has no value.

        >>> volume = vtknexrad.open("volumes/20060312T180500Z.nxv")
        >>> bool(volume.composite().max() == volume["REF"].values.max())
        True
        """
        field = self[moment or self.moments[0]]
        strength = numpy.abs(field.values) if vtkNexradMoments.HasTwoSigns(field.name) else field.values
        level = numpy.argmax(numpy.ma.filled(strength, -numpy.inf), axis=0)
        values = numpy.take_along_axis(field.values.data, level[None], axis=0)[0]
        return masked(values, numpy.ma.getmaskarray(field.values).all(axis=0))

    def write(self, path: Path, code: str = "automatic") -> None:
        """Writes a .nxv file.

        code: how values are stored: "radar" in the steps that radars send, "exact" as floats;
            "automatic" is "radar", but whole dBZ for the method thesis.

        Raises Error when the file cannot be written.
        """
        writer = files.volume_writer(path, code)
        writer.SetInputData(self.image)
        with errors_of(writer):
            writer.Write()

    def to_xarray(self) -> Any:
        """An xarray.Dataset with the dimensions (time, z, y, x), one time; CF conventions.

        Coordinates: time, z, y, x, latitude (y, x) and longitude (y, x). Each moment NAME is float32
        with NaN where there is no value, and NAME_state (State) beside it; ancillary arrays likewise.
        Every variable has its unit. The variable `projection` has the CF grid mapping.

        Raises ImportError when xarray is not installed.
        """
        from .dataset import dataset_of_volumes
        return dataset_of_volumes([self])

    def show(self, height: int = 480, **options: Any) -> Page:
        """A page in which the volume turns, for the last line of a cell in a notebook; it needs no server.

        height: of the cell, in pixels. options: those of `nexrad3d web` (user guide, chapter 4), with _ for -, as
            zoom=2, look_at=(35.3, -97.3), preset="storm cores" or theme="dark".

        Raises Error for an option that cannot be, and when the program nexrad3d is not installed.
        """
        return make_page(self.write, height, options)

    def to_pyvista(self) -> Any:
        """The volume as a pyvista.ImageData (pyvista.UniformGrid before 0.40), which shares its memory.

        Raises ImportError when pyvista is not installed.
        """
        return needed("to_pyvista needs", "pyvista").wrap(self.image)

    def plot(self, moment: Optional[str] = None, height: Optional[float] = None, ax: Any = None) -> Any:
        """Draws a map with matplotlib and returns its axes: the composite, or the level nearest to
        `height` in metres above mean sea level.

        moment: None for the volume's own. ax: matplotlib axes; None for new ones.
        """
        from .pictures import plot_volume
        return plot_volume(self, moment, height, ax)

    def __repr__(self) -> str:
        z, y, x = self.shape
        return (f"<Volume {text_of(self.time)} of {', '.join(self.sites) or 'no radar'}: "
                f"{', '.join(self.moments)} on {x} x {y} x {z} voxels{', SYNTHETIC' * self.synthetic}>")

    def _repr_html_(self) -> str:
        from .pictures import volume_html
        return volume_html(self)

    @functools.cached_property
    def _places(self) -> NDArray[numpy.float64]:
        x, y = numpy.meshgrid(self.x, self.y)
        return self._convert(vtkNexradGeographicCoordinates.ToGeographic, numpy.stack([x, y], axis=-1))

    def _convert(self, convert: Any, pairs: NDArray[numpy.float64]) -> NDArray[numpy.float64]:
        result = vtkDoubleArray()
        given = numpy_to_vtk(numpy.ascontiguousarray(pairs.reshape(-1, 2)))
        if not convert(self.image, given, result):
            raise Error("the axes of the volume are turned: it has no latitudes and longitudes")
        return vtk_to_numpy(result).reshape(pairs.shape)

    def _values(self, name: str, otherwise: float, count: int = 1) -> list[float]:
        values = self.image.GetFieldData().GetArray(name)
        if values is None:
            return [otherwise] * count
        return [values.GetComponent(0, component) for component in range(count)]

    def _texts(self, name: str) -> tuple[str, ...]:
        return texts_of(self.image.GetFieldData().GetAbstractArray(name))
