# SPDX-License-Identifier: MIT
"""Pictures with matplotlib: curves, histories, and sections coloured by a field, also as animations."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Union

import numpy as np

from . import _core
from .axes import COLOURS, make_axes, write_label
from .errors import InputError
from .fields import Fields
from .results import Results
from .section import animate_section, plot_section
from .studies import Study
from .surfaces import plot_surfaces

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["animate_section", "plot_curve", "plot_curves", "plot_history", "plot_section", "plot_surfaces"]


def plot_curve(results: Results, ax: Optional["Axes"] = None, logarithmic: bool = False) -> "Axes":
    """The largest displacement over the strength reduction factor, the two lines of the bilinear construction, and the
    factors by every criterion. Returns the axes."""
    curve = results.curve
    if curve is None:
        raise InputError(f"there is no curve in '{results.folder}'")
    ax = make_axes(ax)
    unit = results.units["displacement"]
    scale = 1 / _core.get_si_factor(unit)
    shown = curve.displacement * scale
    ax.plot(curve.srf, shown, "o-", color="#404040", linewidth=1, markersize=4, label="trials")
    found = results.record.curve
    low, high = float(shown.min()), float(shown.max())
    margin = 0.05 * (high - low) or 1.0
    if found.bilinear:
        factor = np.linspace(curve.srf.min(), curve.srf.max(), 400)
        for part, colour, name in (("first", COLOURS[0], "initial branch"), ("second", COLOURS[1], "final branch")):
            branch = found.bilinear[part]
            line = (branch.slope * factor + branch.intercept) * scale
            inside = (line >= low - margin) & (line <= high + margin)
            ax.plot(factor[inside], line[inside], color=colour, linewidth=2, label=name)
    factors = results.record.factor_of_safety
    for i, criterion in enumerate(found.criteria):
        if criterion.factor is not None:
            is_the_factor = factors is not None and criterion.factor == factors.value
            words = "factor of safety" if is_the_factor else criterion.name.replace("_", " ")
            ax.axvline(
                criterion.factor,
                color="black" if is_the_factor else COLOURS[(i + 2) % len(COLOURS)],
                linestyle="-" if is_the_factor else "--",
                label=f"{criterion.factor:.3f}  {words}",
            )
    if logarithmic:
        ax.set_yscale("log")
    else:
        ax.set_ylim(low - margin, high + margin)
    ax.set_xlabel("strength reduction factor")
    ax.set_ylabel(write_label("largest displacement", unit))
    ax.set_title(results.summary.get("title", ""))
    ax.legend(frameon=False)
    return ax


def plot_curves(study: Study, ax: Optional["Axes"] = None, logarithmic: bool = False) -> "Axes":
    """The displacement curves of all variants of a study that have one. Returns the axes."""
    curves = [(label, study.results.get(name)) for name, label in zip(study.names, study.labels)]
    shown = [(label, results) for label, results in curves if results is not None and results.curve is not None]
    if not shown:
        raise InputError(f"there are no curves in '{study.folder}'")
    ax = make_axes(ax)
    unit = shown[0][1].units["displacement"]
    scale = 1 / _core.get_si_factor(unit)
    markers = "os^vD<>"
    for i, (label, results) in enumerate(shown):
        curve = results.curve
        assert curve is not None
        style = {"color": COLOURS[i % len(COLOURS)], "marker": markers[i % len(markers)]}
        ax.plot(curve.srf, curve.displacement * scale, label=label, linewidth=1, markersize=4, **style)
    if logarithmic:
        ax.set_yscale("log")
    ax.set_xlabel("strength reduction factor")
    ax.set_ylabel(write_label("largest displacement", unit))
    ax.set_title(study.title)
    ax.legend(frameon=False)
    return ax


def plot_history(history: Union[Results, Fields], *columns: str, ax: Optional["Axes"] = None) -> "Axes":
    """Columns of a table over time, which must have one unit. Returns the axes.

    history: `Results.history`, `Results.monitors` or what `Results.point_history` gave; of results the history.
    columns: names; by default the largest displacement.

    plot_history(results, "kinetic_energy", "elastic_energy"); plot_history(results.monitors, "crest.displacement_y")
    """
    table = history.history if isinstance(history, Results) else history
    names = columns or ("largest_displacement",)
    units = {table.units[name] for name in names if table[name] is not None}
    if len(units) > 1:
        words = ", ".join(f"{name} [{table.units[name]}]" for name in names)
        raise InputError(f"columns of one plot must have one unit: {words}; draw each into axes of its own")
    ax = make_axes(ax)
    for i, name in enumerate(names):
        if table[name].ndim != 1:
            raise InputError(f"'{name}' is no single number over time; draw one component or one point")
        ax.plot(table["time"], table[name], color=COLOURS[i % len(COLOURS)], label=name.replace("_", " "))
    ax.set_xlabel(write_label("time", table.units["time"]))
    ax.set_ylabel(write_label(names[0].replace("_", " ") if len(names) == 1 else "", units.pop()).strip())
    if len(names) > 1:
        ax.legend(frameon=False)
    return ax
