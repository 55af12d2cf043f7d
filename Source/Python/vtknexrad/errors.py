# SPDX-License-Identifier: BSD-3-Clause
"""What the package raises and warns of, and how VTK's errors and warnings become these."""

from __future__ import annotations

import contextlib
import importlib
import re
import sys
import time
import warnings
from types import TracebackType
from typing import Any, Iterator

from vtkmodules.vtkCommonCore import vtkCommand

from .vtkNexradIO import vtkNexradBackgroundUpdate


class Error(RuntimeError):
    """A file that cannot be read or a request that cannot be met: one line that says what is wrong."""


class UnknownName(Error, KeyError):
    """A moment, array or other name that is not there: one line with those that are."""

    __str__ = Exception.__str__  # that of KeyError adds quotation marks


class OutOfRange(Error, IndexError):
    """A sweep or volume that is not there: one line that says how many there are."""


class DamageWarning(UserWarning):
    """A file is damaged or was left out; what can be read of it is there."""


def needed(what: str, module: str, debian: str = "") -> Any:
    """Imports a module of a package that need not be there. Raises ImportError, in one line, where it is not.

    what: whoever needs it, as "pictures need". debian: the package of Debian that has it.

    >>> needed("storms need", "thunder.clouds", "python3-thunder")
    Traceback (most recent call last):
    ImportError: storms need the package thunder, which is not installed (Debian: python3-thunder)
    """
    try:
        return importlib.import_module(module)
    except ImportError:
        hint = f" (Debian: {debian})" if debian else ""
        raise ImportError(f"{what} the package {module.partition('.')[0]}, which is not installed{hint}") from None


class Messages:
    """Gathers the errors that an algorithm reports while the block runs. Warnings go where VTK's go."""

    def __init__(self, algorithm: Any) -> None:
        self.errors: list[str] = []
        self._observed = [algorithm]
        if hasattr(algorithm, "GetExecutive"):
            self._observed.append(algorithm.GetExecutive())
        self._tags: list[tuple[Any, int]] = []

    def __enter__(self) -> Messages:
        def keep(_caller: Any, _event: str, text: str) -> None:
            # "vtkClass (0x55d0): what is wrong", below the place in the source.
            line = text.strip().splitlines()[-1]
            self.errors.append(re.sub(r"^(\w+) \(0x[0-9a-f]+\): ", r"\1: ", line))

        keep.CallDataType = "string0"  # type: ignore[attr-defined]
        for one in self._observed:
            self._tags.append((one, one.AddObserver(vtkCommand.ErrorEvent, keep)))
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


def run(algorithm: Any, request: str, *values: Any) -> None:
    """Updates an algorithm while other threads go on.

    request: "Information", "Update", "TimeStep" with the time in seconds since 1970, or "Extent" with the extent.

    Raises Error with the first line that the algorithm reports; warns of damage.
    """
    background = vtkNexradBackgroundUpdate()
    getattr(background, f"Start{request}")(algorithm, *values)
    pause = 2e-5
    try:
        while not background.IsDone():
            time.sleep(pause)  # without the interpreter's lock
            pause = min(1.5 * pause, 2e-3)
    except BaseException:
        background.Stop()
        raise
    errors, lines = texts_of(background.GetErrors()), texts_of(background.GetWarnings())
    if errors:
        raise Error(errors[0])
    if lines:
        more = len(lines) - 1
        rest = f" (and {more} more: see the attribute damage)" if more else ""
        warnings.warn(lines[0] + rest, DamageWarning, stacklevel=_outside())


def texts_of(strings: Any) -> tuple[str, ...]:
    """The texts of a vtkStringArray; none for None."""
    return tuple(strings.GetValue(index) for index in range(strings.GetNumberOfValues())) if strings else ()


def _outside() -> int:
    """How far up the first caller is that is not of this package, for warnings.warn in the caller."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] in (__package__, "_collections_abc"):
        frame, level = frame.f_back, level + 1
    return level
