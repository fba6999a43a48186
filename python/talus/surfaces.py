# SPDX-License-Identifier: MIT
"""The section of a run with the slip surfaces of its methods."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

import numpy as np

from . import _core
from .axes import COLOURS, make_axes, write_label
from .errors import InputError
from .results import Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def plot_surfaces(results: Results, *names: str, ax: Optional["Axes"] = None) -> "Axes":
    """The soils, true to scale, and the slip surfaces that the methods found, with their factors; shear
    bands of FEM are wide and pale. Returns the axes.

    names: of the surfaces, as in `Results.surfaces`; all of them by default.
    """
    known = results.surfaces
    for name in names:
        if name not in known:
            raise InputError(f"there is no surface '{name}'; there are {', '.join(known) or 'none'}")
    shown = [known[name] for name in names or known]
    if not shown:
        raise InputError(f"there are no slip surfaces in '{results.folder}'")
    ax = make_axes(ax)
    from matplotlib.transforms import ScaledTranslation

    unit = results.units["length"]
    length = 1 / _core.get_si_factor(unit)
    for polygon in results.run_summary.get("outlines", []):
        corners = np.array([*polygon, polygon[0]]) * length
        ax.plot(corners[:, 0], corners[:, 1], color="#404040", linewidth=1)
    for i, surface in enumerate(shown):
        is_band = surface.method == "fem"
        ax.plot(
            *(surface.points * length).T,
            color=COLOURS[i % len(COLOURS)],
            linestyle="-" if is_band else ("-", "--", ":", "-.")[i // len(COLOURS) % 4],
            linewidth=7 if is_band else 1.8,
            alpha=0.4 if is_band else 1,
            label=surface.title if surface.factor is None else f"{surface.factor:.3f}  {surface.title}",
        )
    ax.set_aspect("equal")
    ax.set_xlabel(write_label("x", unit))
    ax.set_ylabel(write_label("y", unit))
    ax.set_title(results.summary.get("title", ""))
    below = ax.transAxes + ScaledTranslation(0, -0.5, ax.figure.dpi_scale_trans)  # half an inch, for the tics and x
    ax.legend(frameon=False, fontsize="small", loc="upper center", bbox_to_anchor=(0.5, 0), bbox_transform=below)
    return ax
