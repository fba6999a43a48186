# SPDX-License-Identifier: MIT
"""The material points of a frame as a picture, or of all frames as an animation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from .axes import make_axes, write_label
from .errors import InputError
from .fields import COMPONENTS
from .frames import Frame
from .results import Results

if TYPE_CHECKING:
    from matplotlib.animation import FuncAnimation
    from matplotlib.axes import Axes


def _get_shown(frame: Frame, field: str) -> tuple[NDArray[Any], str, str]:
    """What is drawn of each point, its unit as `[output]` has it, and both in words."""
    values, unit, words = _reduce(frame, field)
    units = frame.results.units
    shown = {"Pa": units["stress"], "m": units["displacement"]}.get(unit, unit)
    if shown != unit:
        values = values / _core.get_si_factor(shown)
    return values, shown, words


def _reduce(frame: Frame, field: str) -> tuple[NDArray[Any], str, str]:
    """One number a point of `field`, `field.xx`, `field.magnitude` or `field.mean`; its SI unit, and it in words."""
    name, _, component = field.partition(".") if field not in frame.fields else (field, "", "")
    values = frame.field(name)
    unit = frame.unit(name)
    if values.ndim == 1:
        if component:
            raise InputError(f"'{name}' has no component '{component}'")
        return values, unit, name.replace("_", " ")
    axes = COMPONENTS[values.shape[1]]
    first = "magnitude" if len(axes) == 3 else "mean"
    component = component or first
    if component not in (first, *axes):
        raise InputError(f"'{name}' has no component '{component}'; it has {', '.join((first, *axes))}")
    if component == "magnitude":
        shown = np.linalg.norm(values, axis=1)
    elif component == "mean":
        shown = values[:, :3].mean(axis=1)
    else:
        shown = values[:, axes.index(component)]
    return shown, unit, f"{name.replace('_', ' ')}, {component}"


def _diameters(frame: Frame, dimension: int) -> NDArray[Any]:
    """Diameters [m] of discs that cover the square (cube) of each point's volume."""
    if "volume" in frame.fields:
        volume = frame.field("volume")
        return np.asarray(np.sqrt(2) * np.cbrt(volume) if dimension == 3 else np.sqrt(2 * volume))
    extent = np.ptp(frame.positions[:, :2], axis=0)
    return np.full(len(frame), np.sqrt(2 * max(extent.prod(), 1e-12) / max(len(frame), 1)))


def plot_section(
    results: Union[Results, Frame],
    field: str = "deviatoric_strain",
    ax: Optional["Axes"] = None,
    outline: bool = True,
    frame: int = -1,
    range: Optional[tuple[float, float]] = None,
    colorbar: bool = True,
) -> "Axes":
    """The material points of a frame, true to scale and seen along z, coloured by a field. Returns the axes.

    results: results, of which the frame with the index `frame` is drawn (the last one by default), or a frame.
    field: a name of `Results.fields`; a component as "stress.xx", "displacement.magnitude", "stress.mean".
    outline: draw the soil as it was at the start.
    range: ends of the colour bar in the unit that it shows; by default those of the values. With zero between them the
        colours are blue, white and red, else those of viridis.
    """
    moment = results.frame(frame) if isinstance(results, Results) else results
    values, unit, words = _get_shown(moment, field)
    if len(values) == 0:
        raise InputError(f"there are no points in frame {moment.index} of '{moment.results.folder}'")
    ax = make_axes(ax)
    from matplotlib.collections import EllipseCollection

    units = moment.results.units
    length = 1 / _core.get_si_factor(units["length"])
    dimension = 3 if np.any(moment.positions[:, 2]) else 2
    order = np.argsort(moment.positions[:, 2], kind="stable")
    centres = moment.positions[order, :2] * length
    widths = _diameters(moment, dimension)[order] * length
    low, high = range or _find_range([values])
    points = EllipseCollection(
        widths, widths, np.zeros(len(widths)), units="xy", offsets=centres, offset_transform=ax.transData, linewidths=0
    )
    points.set_array(values[order])
    points.set_cmap("RdBu_r" if low < 0 < high else "viridis")
    points.set_clim(low, high)
    points.set_rasterized(len(moment) > 10000)  # an SVG or PDF would have tens of megabytes
    ax.add_collection(points)
    if outline:
        for polygon in moment.results.run_summary.get("outlines", []):
            corners = np.array([*polygon, polygon[0]]) * length
            ax.plot(corners[:, 0], corners[:, 1], color="#404040", linewidth=1)
    ax.update_datalim(centres)
    ax.autoscale_view()
    ax.set_aspect("equal")
    ax.set_xlabel(write_label("x", units["length"]))
    ax.set_ylabel(write_label("y", units["length"]))
    ax.set_title(f"t = {moment.time:.4g} s, {moment.stage}" + (", seen along z" if dimension == 3 else ""))
    if colorbar:
        ax.figure.colorbar(points, ax=ax, orientation="horizontal", shrink=0.7, label=write_label(words, unit))
    return ax


def animate_section(
    results: Results,
    field: str = "deviatoric_strain",
    ax: Optional["Axes"] = None,
    interval: float = 100,
    **options: Any,
) -> "FuncAnimation":
    """All frames of a run as an animation with one colour bar; keep what it returns for as long as it is shown.

    interval: time between two frames [ms].
    options: outline and range of `plot_section`.

    talus.plot.animate_section(results.trials[1.75]).save("runout.gif")   # in a notebook: HTML(….to_jshtml())
    """
    axes = make_axes(ax)
    from matplotlib.animation import FuncAnimation

    frames = list(results)
    if options.get("range") is None:
        options["range"] = _find_range([_get_shown(frame, field)[0] for frame in frames])
    length = 1 / _core.get_si_factor(results.units["length"])
    corners = [end(frame.positions[:, :2], axis=0) * length for frame in frames for end in (np.min, np.max)]
    low, high = np.min(corners, axis=0), np.max(corners, axis=0)
    margin = 0.03 * float((high - low).max())
    plot_section(frames[-1], field, ax=axes, **options)

    def draw(index: int) -> list[Any]:
        axes.clear()
        plot_section(frames[index], field, ax=axes, colorbar=False, **options)
        axes.set_xlim(low[0] - margin, high[0] + margin)
        axes.set_ylim(low[1] - margin, high[1] + margin)
        return []

    return FuncAnimation(axes.figure, draw, frames=len(frames), interval=interval)


def _find_range(values: list[NDArray[Any]]) -> tuple[float, float]:
    """Ends of the colour bar: with zero in the middle where there are both signs."""
    low, high = (float(end([end(v) for v in values])) for end in (np.min, np.max))
    if low < 0 < high:
        high = max(-low, high)
        low = -high
    return low, high
