# SPDX-License-Identifier: BSD-3-Clause
"""What the package raises and warns of, and how VTK's errors and warnings become these."""

from __future__ import annotations

import contextlib
import re
import sys
import warnings
from types import TracebackType
from typing import Any, Iterator

from vtkmodules.vtkCommonCore import vtkCommand


class Error(RuntimeError):
    """A file that cannot be read or a request that cannot be met: one line that says what is wrong."""


class UnknownName(Error, KeyError):
    """A moment, array or other name that is not there: one line with those that are."""

    __str__ = Exception.__str__  # that of KeyError adds quotation marks


class OutOfRange(Error, IndexError):
    """A sweep or volume that is not there: one line that says how many there are."""


class DamageWarning(UserWarning):
    """A file is damaged or was left out; what can be read of it is there."""


class Messages:
    """Gathers the errors, and on demand the warnings, that an algorithm reports while the block runs.

    Warnings that are not gathered go where VTK's warnings go.
    """

    def __init__(self, algorithm: Any, keep_warnings: bool = False) -> None:
        self.errors: list[str] = []
        self.warnings: list[str] = []
        self._observed = [algorithm]
        if hasattr(algorithm, "GetExecutive"):
            self._observed.append(algorithm.GetExecutive())
        self._lists = {vtkCommand.ErrorEvent: self.errors}
        if keep_warnings:
            self._lists[vtkCommand.WarningEvent] = self.warnings
        self._tags: list[tuple[Any, int]] = []

    def __enter__(self) -> Messages:
        for event, lines in self._lists.items():
            def keep(_caller: Any, _event: str, text: str, lines: list[str] = lines) -> None:
                # "vtkClass (0x55d0): what is wrong", below the place in the source.
                line = text.strip().splitlines()[-1]
                lines.append(re.sub(r"^(\w+) \(0x[0-9a-f]+\): ", r"\1: ", line))

            keep.CallDataType = "string0"  # type: ignore[attr-defined]
            for one in self._observed:
                self._tags.append((one, one.AddObserver(event, keep)))
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None,
                 trace: TracebackType | None) -> None:
        for one, tag in self._tags:
            one.RemoveObserver(tag)


def without_class(line: str) -> str:
    """The line without the name of the VTK class that reported it."""
    return re.sub(r"^vtk\w+: ", "", line)


@contextlib.contextmanager
def errors_of(vtk_object: Any) -> Iterator[None]:
    """Raises Error with the first line that a VTK object reports as an error while the block runs.

    >>> session = vtknexrad.vtkNexradSession()
    >>> session.AddFileName("nowhere")
    >>> with vtknexrad.errors_of(session):
    ...     shown = session.ShowTimeStep(0)
    Traceback (most recent call last):
    vtknexrad.errors.Error: nowhere: no such file or folder
    """
    with Messages(vtk_object) as messages:
        yield
    if messages.errors:
        raise Error(without_class(messages.errors[0]))


def run(algorithm: Any, work: Any) -> None:
    """Calls `work`. Raises Error with the first line that the algorithm reports; warns of damage."""
    with Messages(algorithm, keep_warnings=True) as messages:
        work()
    if messages.errors:
        raise Error(without_class(messages.errors[0]))
    if messages.warnings:
        more = len(messages.warnings) - 1
        rest = f" (and {more} more: see the attribute damage)" if more else ""
        warnings.warn(without_class(messages.warnings[0]) + rest, DamageWarning,
                      stacklevel=_outside())


def _outside() -> int:
    """How far up the first caller is that is not of this package, for warnings.warn in the caller."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] in (__package__, "_collections_abc"):
        frame, level = frame.f_back, level + 1
    return level
