# SPDX-License-Identifier: MIT
"""The methods of a run beside one another: their factors, their slip surfaces, and the one factor of the run."""

from __future__ import annotations

import html
from dataclasses import astuple, dataclass, fields
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class MethodFactor:
    """A row of the table of methods."""

    method: str  #: "lem", "fem", "bounds", "mpm": slices, finite elements, proven bounds, material points
    name: str  #: "spencer", "as_given", "frozen"
    title: str  #: in words
    criterion: str  #: "critical circle", "non-convergence"
    surface: str  #: name of its surface in `Results.surfaces`; empty where it has none
    factor: Optional[float]
    lower: Optional[float]  #: the largest factor that is known to stand
    upper: Optional[float]  #: the smallest factor that is known to fail
    seconds: Optional[float]  #: of all rows of its method together, at the first of them
    note: str

    def __str__(self) -> str:
        return f"{self.title}, {self.criterion}: {_show(self.factor)}"


class MethodTable(list[MethodFactor]):
    """The factors of all methods in the order of the report."""

    def __repr__(self) -> str:
        return "\n".join(map(str, self))

    def _repr_html_(self) -> str:
        heads = ("method", "criterion", "factor", "from", "to", "seconds", "note")
        lines = [
            (r.title, r.criterion, _show(r.factor), _show(r.lower), _show(r.upper), _show(r.seconds), r.note)
            for r in self
        ]
        cells = ["".join(f"<td>{html.escape(cell)}</td>" for cell in line) for line in lines]
        head = "".join(f"<th>{word}</th>" for word in heads)
        return f"<table><thead><tr>{head}</tr></thead><tbody><tr>{'</tr><tr>'.join(cells)}</tr></tbody></table>"

    def to_dataframe(self) -> Any:
        """The table as a pandas.DataFrame. Needs pandas."""
        try:
            import pandas
        except ImportError as missing:
            raise ImportError("to_dataframe needs pandas (Debian: python3-pandas)") from missing
        return pandas.DataFrame([astuple(row) for row in self], columns=[f.name for f in fields(MethodFactor)])


@dataclass(frozen=True)
class Surface:
    """A slip surface of a method."""

    name: str  #: "lem.spencer", "fem.band", "bounds.mechanism", "mpm.slip_line"
    title: str  #: in words
    method: str  #: "lem", "fem", "bounds", "mpm"
    factor: Optional[float]
    points: NDArray[Any]  #: (points, 2) [m]
    direction: Optional[int] = None  #: 1: its soil moves towards larger x, -1: smaller; None: all soil moves one way


def read_methods(summary: dict[str, Any]) -> MethodTable:
    """`methods.table` of a summary.json; empty where there is none."""
    names = [f.name for f in fields(MethodFactor)]
    return MethodTable(
        MethodFactor(**{name: row[name] for name in names}) for row in summary.get("methods", {}).get("table", [])
    )


def read_surfaces(summary: dict[str, Any]) -> dict[str, Surface]:
    """`methods.surfaces` of a summary.json by name; empty where there are none."""
    listed = summary.get("methods", {}).get("surfaces", [])
    return {
        s["name"]: Surface(
            s["name"],
            s["title"],
            s["method"],
            s["factor"],
            np.array(s["points"], float).reshape(-1, 2),
            s.get("direction"),
        )
        for s in listed
    }


def _show(value: Optional[float]) -> str:
    return "–" if value is None else f"{value:.3f}"
