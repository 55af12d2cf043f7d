# SPDX-License-Identifier: BSD-3-Clause
"""Times as users write them, as VTK has them (seconds since 1970), and as numpy has them."""

from __future__ import annotations

import datetime
import re
from typing import Iterable, Union

import numpy
from numpy.typing import NDArray

#: A time: seconds since 1970-01-01T00:00:00Z, a datetime or numpy.datetime64, or ISO 8601 text. UTC
#: where it has no zone of its own.
Time = Union[float, datetime.datetime, numpy.datetime64, str]

#: A duration: seconds, a timedelta, a numpy.timedelta64, or text as the program takes it: "5min".
Duration = Union[float, datetime.timedelta, "numpy.timedelta64", str]

SECONDS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}


def seconds_of(time: Time) -> float:
    """Seconds since 1970-01-01T00:00:00Z.

    >>> seconds_of("2006-03-12T18:05") == seconds_of(numpy.datetime64("2006-03-12T18:05"))
    True

    Raises ValueError for text that is no time, and for the missing time NaT.
    """
    if isinstance(time, str):
        try:
            time = datetime.datetime.fromisoformat(time.replace("Z", "+00:00"))
        except ValueError:
            raise ValueError(f"{time!r} is no time; write it as 2006-03-12T18:05") from None
    if isinstance(time, datetime.datetime):
        if time.tzinfo is None:
            time = time.replace(tzinfo=datetime.timezone.utc)
        return time.timestamp()
    if isinstance(time, numpy.datetime64):
        if numpy.isnat(time):
            raise ValueError("the time is missing (NaT)")
        return float((time.astype("datetime64[us]") - numpy.datetime64(0, "us")).astype(int)) / 1e6
    return float(time)


def duration_of(duration: Duration) -> float:
    """Seconds.

    >>> duration_of(datetime.timedelta(minutes=5)), duration_of("5min")
    (300.0, 300.0)

    Raises ValueError for text that is no duration.
    """
    if isinstance(duration, str):
        match = re.fullmatch(r"(\d+\.?\d*|\.\d+)\s*([a-z]+)", duration.strip())
        if not match or match[2] not in SECONDS:
            raise ValueError(f"{duration!r} is no duration; write a number and {', '.join(SECONDS)}, as in '5min'")
        return float(match[1]) * SECONDS[match[2]]
    if isinstance(duration, datetime.timedelta):
        return duration.total_seconds()
    if isinstance(duration, numpy.timedelta64):
        return float(duration / numpy.timedelta64(1, "s"))
    return float(duration)


def datetime64_of(seconds: float) -> numpy.datetime64:
    """A time in UTC, to the millisecond, in the nanoseconds that pandas and xarray take.

    >>> str(datetime64_of(1142186700.0))
    '2006-03-12T18:05:00.000000000'
    """
    return numpy.datetime64(round(seconds * 1000.0), "ms").astype("datetime64[ns]")


def datetime64s_of(seconds: Iterable[float]) -> NDArray[numpy.datetime64]:
    """The times of datetime64_of as an array."""
    return numpy.array([datetime64_of(one) for one in seconds], dtype="datetime64[ns]")


def text_of(time: numpy.datetime64) -> str:
    """A time as people read it.

    >>> text_of(numpy.datetime64("2006-03-12T18:05:00"))
    '2006-03-12 18:05:00 UTC'
    """
    return str(time.astype("datetime64[s]")).replace("T", " ") + " UTC"
