# SPDX-License-Identifier: MIT
"""Axes, colours and labels of the plots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Okabe and Ito: told apart with every common kind of colour vision.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]


def make_axes(ax: Optional["Axes"]) -> "Axes":
    """These axes, or those of a new figure."""
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError as missing:
        raise ImportError("talus.plot needs matplotlib (Debian: python3-matplotlib)") from missing
    return pyplot.subplots(constrained_layout=True)[1]


def write_label(words: str, unit: str) -> str:
    """Words and unit as they stand at an axis."""
    unit = unit.replace("^2", "²").replace("^3", "³").replace("m2", "m²").replace("m3", "m³")
    return words if unit in ("", "-") else f"{words} [{unit}]"
