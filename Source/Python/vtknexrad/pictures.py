# SPDX-License-Identifier: BSD-3-Clause
"""Maps of volumes and sweeps with matplotlib, and what a notebook shows of them."""

from __future__ import annotations

import base64
import html
import io
from typing import TYPE_CHECKING, Any, Callable, Optional

import numpy
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from .errors import UnknownName, needed
from .times import text_of
from .vtkNexradScene import vtkNexradTransferFunction

if TYPE_CHECKING:
    from .fields import Field
    from .radar import RadarVolume, Sweep
    from .volume import Volume


def colours(moment: str = "REF") -> tuple[Any, Any]:
    """The colour map and the norm of a moment for matplotlib: the parameters cmap and norm.

    Values are in the moment's unit. Those of REF are the National Weather Service's; echo below 5 dBZ is
    transparent.

    >>> colour_map, norm = vtknexrad.colours("REF")
    >>> [float(edge) for edge in norm.boundaries[:3]]
    [5.0, 10.0, 15.0]

    Raises UnknownName, which is a KeyError, for a name that has no colours, and ImportError when matplotlib is not installed.
    """
    colors = _matplotlib("colors")
    function = vtkNexradTransferFunction()
    preset = function.FindPreset(moment)
    if preset is None:
        raise UnknownName(f"{moment!r} has no colours")
    function.ApplyPreset(preset)
    bins = _bins(function)
    if bins and all(lower == upper for _, lower, upper in bins):
        colour_map = colors.ListedColormap([lower for _, lower, _ in bins[:-1]])
        colour_map.set_over(bins[-1][1])
        if moment == "REF":
            colour_map.set_under((0.0, 0.0, 0.0, 0.0))  # the table begins at 5 dBZ
        return colour_map, colors.BoundaryNorm([first for first, _, _ in bins], len(bins) - 1)
    smooth = vtkColorTransferFunction()
    function.FillSteppedColorFunction(smooth)
    first, last = smooth.GetRange()
    samples = [smooth.GetColor(value) for value in numpy.linspace(first, last, 256)]
    return colors.ListedColormap(samples), colors.Normalize(first, last)


def _bins(function: Any) -> list[tuple[float, list[float], list[float]]]:
    bins = []
    for index in range(function.GetNumberOfBins()):
        edges, lower, upper = [0.0] * 2, [0.0] * 3, [0.0] * 3
        function.GetBin(index, edges, lower, upper)
        bins.append((edges[0], lower, upper))
    return bins


def plot_volume(volume: Volume, moment: Optional[str], height: Optional[float], ax: Any) -> Any:
    """Volume.plot."""
    name = moment or volume.moments[0]
    field = volume[name]
    if height is None:
        values, what = volume.composite(name), "composite"
    else:
        level = int(numpy.abs(volume.z - height).argmin())
        values, what = field.values[level], f"{volume.z[level] / 1000.0:.2f} km above mean sea level"
    scale, unit = (1.0, "degrees") if volume.is_geographic else (1000.0, "km")
    return _draw(ax, _edges(volume.x / scale), _edges(volume.y / scale), values, field, unit,
                 f"{text_of(volume.time)}\n{what}", volume.synthetic)


def plot_sweep(sweep: Sweep, moment: Optional[str], ax: Any) -> Any:
    """Sweep.plot."""
    x, y, _ = numpy.moveaxis(sweep.xyz(moment), -1, 0) / 1000.0
    name = moment or sweep.moments[0]
    away = _edges_between(numpy.hypot(x, y).mean(axis=0))
    edges, rays = ray_cells(sweep.azimuths)
    angles = numpy.radians(edges)[:, None]
    title = f"{sweep.volume.radar} {text_of(sweep.volume.time)}\n{sweep.elevation:.2f} degrees"
    field = sweep[name]
    values = numpy.ma.masked_where((rays < 0)[:, None] | numpy.zeros(len(away) - 1, bool), field.values[rays])
    return _draw(ax, numpy.sin(angles) * away, numpy.cos(angles) * away, values, field, "km", title,
                 sweep.volume.synthetic)


def ray_cells(azimuths: NDArray[Any]) -> tuple[NDArray[numpy.float64], NDArray[numpy.int64]]:
    """Edges in degrees of cells about rays, and the index of each cell's ray; -1 for a cell between rays that
    lie apart by more than one and a half times the usual step, where rays are missing.

    >>> edges, rays = ray_cells(numpy.array([0.0, 1.0, 2.0, 5.0, 6.0]))
    >>> edges.tolist(), rays.tolist()
    ([-0.5, 0.5, 1.5, 2.5, 4.5, 5.5, 6.5], [0, 1, 2, -1, 3, 4])
    """
    turned = numpy.degrees(numpy.unwrap(numpy.radians(numpy.asarray(azimuths, float))))
    steps = numpy.diff(turned)
    step = float(numpy.median(steps)) if len(steps) else 1.0
    edges, rays = [turned[0] - step / 2.0], [0]
    for ray, apart in enumerate(steps, 1):
        if abs(apart) > 1.5 * abs(step):
            edges += [turned[ray - 1] + step / 2.0, turned[ray] - step / 2.0]
            rays += [-1, ray]
        else:
            edges.append((turned[ray - 1] + turned[ray]) / 2.0)
            rays.append(ray)
    edges.append(turned[-1] + step / 2.0)
    return numpy.round(edges, 9), numpy.array(rays)


def _draw(ax: Any, x: Any, y: Any, values: Any, field: Field, unit: str, title: str, synthetic: bool) -> Any:
    if ax is None:
        ax = _matplotlib("pyplot").subplots(figsize=(6.5, 5.5))[1]
    colour_map, norm = colours(field.name)
    mesh = ax.pcolormesh(x, y, values, cmap=colour_map, norm=norm)
    label = f"{field.title}, {field.unit}" if field.unit else field.title
    ax.figure.colorbar(mesh, ax=ax, label=label, fraction=0.046, pad=0.04)
    ax.set(xlabel=f"{unit} east", ylabel=f"{unit} north", aspect="equal",
           title=f"{'SYNTHETIC ' * synthetic}{title}")
    return ax


def _edges(centres: NDArray[numpy.float64]) -> NDArray[numpy.float64]:
    """Edges of the cells about equidistant centres."""
    if len(centres) == 1:
        return numpy.array([centres[0] - 0.5, centres[0] + 0.5])
    half = (centres[1] - centres[0]) / 2.0
    return numpy.append(centres - half, centres[-1] + half)


def _edges_between(centres: NDArray[numpy.float64]) -> NDArray[numpy.float64]:
    """Edges of the cells about centres: half-way to the neighbours."""
    wider = numpy.pad(centres, 1, mode="reflect", reflect_type="odd") if len(centres) > 1 else \
        centres[0] + numpy.array([-1.0, 0.0, 1.0])
    return (wider[:-1] + wider[1:]) / 2.0


def _matplotlib(module: str) -> Any:
    return needed("pictures need", f"matplotlib.{module}", "python3-matplotlib")


def volume_html(volume: Volume) -> str:
    """What a notebook shows of a volume: its description, and the composite where matplotlib is installed."""
    return _html(repr(volume), lambda ax: plot_volume(volume, None, None, ax))


def sweep_html(sweep: Sweep) -> str:
    """What a notebook shows of a sweep."""
    if not sweep.moments:
        return f"<p>{html.escape(repr(sweep))}</p>"
    return _html(repr(sweep), lambda ax: plot_sweep(sweep, None, ax))


def radar_html(radar: RadarVolume) -> str:
    """What a notebook shows of a Level II file: its description and a table of its sweeps."""
    rows = "".join(f"<tr><td>{sweep.index}</td><td>{sweep.elevation:.2f}</td><td>{len(sweep.azimuths)}</td>"
                   f"<td>{', '.join(sweep.moments)}</td></tr>" for sweep in radar)
    return (f"<p>{html.escape(repr(radar))}</p><table><tr><th>sweep</th><th>elevation, degrees</th><th>rays</th>"
            f"<th>moments</th></tr>{rows}</table>")


def _html(text: str, draw: Callable[[Any], Any]) -> str:
    line = f"<p>{html.escape(text)}</p>"
    try:
        figure = _matplotlib("figure").Figure(figsize=(5.2, 4.4))
    except ImportError:
        return line
    draw(figure.subplots())
    png = io.BytesIO()
    figure.savefig(png, format="png", dpi=80)
    picture = base64.b64encode(png.getvalue()).decode()
    return f'{line}<img alt="{html.escape(text, quote=True)}" src="data:image/png;base64,{picture}">'
