# SPDX-License-Identifier: BSD-3-Clause
"""Volumes that turn in a cell of a notebook: the page of `nexrad3d web`, without a server."""

from __future__ import annotations

import html
import os
import pathlib
import shutil
import subprocess
import tempfile
from typing import Any, Callable

from .errors import Error


class Page:
    """A page in one text, which a notebook shows in the cell that it is the result of."""

    def __init__(self, text: str, height: int) -> None:
        self.text = text  #: HTML, which a browser also opens as a file
        self.height = height  #: of the cell, in pixels

    def _repr_html_(self) -> str:
        # A document of its own: its styles and scripts do not meet those of the notebook.
        return (f'<iframe srcdoc="{html.escape(self.text, quote=True)}" style="border:0;width:100%;height:{self.height}px" '
                'allowfullscreen></iframe>')

    def __repr__(self) -> str:
        return f"<Page of {len(self.text)} characters>"


def make_page(write: Callable[[str], Any], height: int, options: dict[str, Any]) -> Page:
    """The page of the volumes that `write` writes. It is given a path for a volume, and returns that of what it wrote
    where it is another one.

    Raises Error with the program's line when it refuses an option or cannot make the page.
    """
    with tempfile.TemporaryDirectory(prefix="vtknexrad-") as folder:
        volumes, page = os.path.join(folder, "volumes.nxv"), os.path.join(folder, "page.html")
        written = write(volumes) or volumes
        done = subprocess.run([_program(), "web", written, "-o", page, "--quiet", *_arguments(options)],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Error(done.stderr.strip().partition("\n")[0] or f"nexrad3d web ended with the status {done.returncode}")
        return Page(pathlib.Path(page).read_text(encoding="utf-8"), height)


def _arguments(options: dict[str, Any]) -> list[str]:
    """Options of the program: zoom=2 is --zoom=2, parallel=True is --parallel."""
    words = []
    for name, value in options.items():
        if value is not False:
            text = ",".join(map(str, value)) if isinstance(value, (tuple, list)) else str(value)
            words.append(f"--{name.replace('_', '-')}" + ("" if value is True else f"={text}"))
    return words


def _program() -> str:
    """The program nexrad3d: the one that was installed with the package, else that in the PATH."""
    beside = pathlib.Path(__file__).resolve().parents[4] / "bin" / "nexrad3d"
    found = str(beside) if beside.exists() else shutil.which("nexrad3d")
    if found is None:
        raise Error("the program nexrad3d, which makes the page, is neither beside the package nor in the PATH")
    return found
