"""Pictures with matplotlib: the displacement curve and a section coloured by a field."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from .errors import InputError
from .results import Frame, Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Okabe and Ito: told apart with every common kind of colour vision.
_COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]
_COMPONENTS = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "xz"]}


def _make_axes(ax: Optional["Axes"]) -> "Axes":
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError as missing:
        raise ImportError("talus.plot needs matplotlib (Debian: python3-matplotlib)") from missing
    return pyplot.subplots(constrained_layout=True)[1]


def _label(words: str, unit: str) -> str:
    unit = unit.replace("^2", "²").replace("^3", "³")
    return words if unit in ("", "-") else f"{words} [{unit}]"


def plot_curve(results: Results, ax: Optional["Axes"] = None, logarithmic: bool = False) -> "Axes":
    """The largest displacement over the strength reduction factor, the two lines of the bilinear construction, and the
    factors by every criterion. Returns the axes."""
    curve = results.curve
    if curve is None:
        raise InputError(f"there is no curve in '{results.folder}'")
    ax = _make_axes(ax)
    unit = results.units["displacement"]
    scale = 1 / _core.get_si_factor(unit)
    shown = curve.displacement * scale
    ax.plot(curve.srf, shown, "o-", color="#404040", linewidth=1, markersize=4, label="trials")
    block = results.summary["curve"]
    bilinear = block.get("bilinear")
    low, high = float(shown.min()), float(shown.max())
    margin = 0.05 * (high - low) or 1.0
    if bilinear:
        factor = np.linspace(curve.srf.min(), curve.srf.max(), 400)
        for part, colour, name in (("first", _COLOURS[0], "initial branch"), ("second", _COLOURS[1], "final branch")):
            line = (bilinear[part]["slope"] * factor + bilinear[part]["intercept"]) * scale
            inside = (line >= low - margin) & (line <= high + margin)
            ax.plot(factor[inside], line[inside], color=colour, linewidth=2, label=name)
    for i, criterion in enumerate(block["criteria"]):
        if criterion["factor"] is not None:
            is_the_factor = criterion["factor"] == results.factor_of_safety
            words = "factor of safety" if is_the_factor else criterion["name"].replace("_", " ")
            ax.axvline(
                criterion["factor"],
                color="black" if is_the_factor else _COLOURS[(i + 2) % len(_COLOURS)],
                linestyle="-" if is_the_factor else "--",
                label=f"{criterion['factor']:.2f}  {words}",
            )
    if logarithmic:
        ax.set_yscale("log")
    else:
        ax.set_ylim(low - margin, high + margin)
    ax.set_xlabel("strength reduction factor")
    ax.set_ylabel(_label("largest displacement", unit))
    ax.set_title(results.summary.get("title", ""))
    ax.legend(frameon=False)
    return ax


def _reduce(frame: Frame, field: str) -> tuple[NDArray[Any], str, str]:
    """One number a point of `field`, `field.xx`, `field.magnitude` or `field.mean`; its SI unit, and it in words."""
    name, _, component = field.partition(".") if field not in frame.fields else (field, "", "")
    values = frame.field(name)
    unit = frame.unit(name)
    if values.ndim == 1:
        if component:
            raise InputError(f"'{name}' has no component '{component}'")
        return values, unit, name.replace("_", " ")
    axes = _COMPONENTS[values.shape[1]]
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
    range: ends of the colour bar in the unit that it shows; by default those of the values.
    """
    moment = results.frame(frame) if isinstance(results, Results) else results
    values, unit, words = _reduce(moment, field)
    ax = _make_axes(ax)
    from matplotlib.collections import EllipseCollection

    units = moment.results.units
    shown_unit = {"Pa": units["stress"], "m": units["displacement"]}.get(unit, unit)
    if shown_unit != unit:
        values = values / _core.get_si_factor(shown_unit)
    length = 1 / _core.get_si_factor(units["length"])
    dimension = 3 if np.any(moment.positions[:, 2]) else 2
    order = np.argsort(moment.positions[:, 2], kind="stable")
    centres = moment.positions[order, :2] * length
    widths = _diameters(moment, dimension)[order] * length
    colours: dict[str, Any] = {"cmap": "viridis"}
    if values.min() < 0 < values.max():
        end = float(np.abs(values).max())
        colours = {"cmap": "RdBu_r", "clim": (-end, end)}
    if range is not None:
        colours["clim"] = range
    points = EllipseCollection(
        widths, widths, np.zeros(len(widths)), units="xy", offsets=centres, transOffset=ax.transData, linewidths=0
    )
    points.set_array(values[order])
    points.set_cmap(colours["cmap"])
    points.set_clim(*colours.get("clim", (float(values.min()), float(values.max()))))
    points.set_rasterized(len(moment) > 20000)  # an SVG or PDF would have tens of megabytes
    ax.add_collection(points)
    if outline:
        for polygon in moment.results.run_summary.get("outlines", []):
            corners = np.array([*polygon, polygon[0]]) * length
            ax.plot(corners[:, 0], corners[:, 1], color="#404040", linewidth=1)
    ax.update_datalim(centres)
    ax.autoscale_view()
    ax.set_aspect("equal")
    ax.set_xlabel(_label("x", units["length"]))
    ax.set_ylabel(_label("y", units["length"]))
    ax.set_title(f"t = {moment.time:.4g} s, {moment.stage}")
    if colorbar:
        ax.figure.colorbar(points, ax=ax, orientation="horizontal", shrink=0.7, label=_label(words, shown_unit))
    return ax
