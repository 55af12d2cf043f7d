# SPDX-License-Identifier: BSD-3-Clause
"""Values of a moment with what belongs to them: unit, states, and why a value is missing."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

import numpy
from numpy.typing import NDArray

from .errors import UnknownName
from .vtkNexradIO import vtkNexradMoments

if TYPE_CHECKING:
    MaskedArray = numpy.ma.MaskedArray[Any, Any]


class State(enum.IntEnum):
    """What a gate of a sweep or a voxel of a merged volume has. Only ECHO has a value.

    Gates and voxels have names of their own for three of them: VALID is ECHO, BELOW_THRESHOLD is
    NO_ECHO, and NOT_SAMPLED is NOT_SCANNED.

    >>> State.BELOW_THRESHOLD is State.NO_ECHO
    True
    """

    ECHO = 0
    NO_ECHO = 1
    RANGE_FOLDED = 2
    NOT_SCANNED = 3
    FILTERED = 4

    VALID = 0
    BELOW_THRESHOLD = 1
    NOT_SAMPLED = 3


@dataclass(frozen=True, eq=False, repr=False)
class Field:
    """One array of a sweep or of a merged volume.

    numpy takes it as an array of floats with NaN where there is no value.

    >>> field = Field("REF", "Reflectivity", "dBZ", numpy.ma.masked_array([30.0, -33.0], [False, True]),
    ...               numpy.array([0, 2], numpy.uint8))
    >>> field
    <Field REF: Reflectivity, dBZ, shape (2,), 1 value>
    >>> numpy.asarray(field)
    array([30., nan])
    >>> field.where(State.RANGE_FOLDED)
    array([False,  True])
    """

    name: str  #: as "REF" or "REF_age"
    title: str  #: as "Reflectivity"
    unit: str  #: as "dBZ"; empty for a number without unit
    values: MaskedArray  #: masked where there is no value; (z, y, x) or (ray, gate)
    states: NDArray[numpy.uint8]  #: State of each value
    ranges: Optional[NDArray[numpy.float64]] = None  #: of a sweep: m, slant range of each gate's centre

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the values."""
        return self.values.shape

    def where(self, state: State) -> NDArray[numpy.bool_]:
        """Where the gate or voxel has that state."""
        return self.states == int(state)

    def filled(self, value: float = numpy.nan) -> NDArray[Any]:
        """The values as a plain array, with `value` where there is none."""
        return numpy.ma.filled(self.values, value)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        filled = self.filled() if self.values.dtype.kind == "f" else numpy.ma.filled(self.values)
        return numpy.asarray(filled, dtype=dtype)

    def __repr__(self) -> str:
        count = int(self.values.count())
        unit = f", {self.unit}" if self.unit else ""
        return (f"<Field {self.name}: {self.title}{unit}, shape {self.shape}, "
                f"{count} value{'' if count == 1 else 's'}>")


#: The ancillary arrays of a moment: ending of the name, title, unit.
ANCILLARY = (("age", "Age of the nearest ray", "s"), ("radars", "Number of radars", ""),
             ("weight", "Sum of the weights of the radars", ""), ("site", "Nearest radar, number in sites", ""))


def moment_names() -> tuple[str, ...]:
    """Names of all moments, measured and derived.

    >>> moment_names()[:3]
    ('REF', 'VEL', 'SW')
    """
    return tuple(vtkNexradMoments.GetMomentName(index)
                 for index in range(vtkNexradMoments.GetNumberOfMoments()))


def masked(values: NDArray[Any], mask: NDArray[numpy.bool_]) -> MaskedArray:
    """A masked array that keeps the memory of `values`; what fills it is NaN where it can be.

    >>> masked(numpy.array([1.0, 2.0]), numpy.array([False, True])).filled()
    array([ 1., nan])
    """
    return numpy.ma.masked_array(values, mask, fill_value=numpy.nan if values.dtype.kind == "f" else None)


def missing(name: str, there: tuple[str, ...], owner: str) -> UnknownName:
    """The error of a name that is not there."""
    return UnknownName(f"{owner} has no {name!r}; it has {', '.join(there) or 'none'}")
