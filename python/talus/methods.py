# SPDX-License-Identifier: MIT
"""The methods of a run beside one another: their factors, their slip surfaces, and the one factor of the run."""

from __future__ import annotations

import html
from typing import Any, Optional

from .records import Record


class MethodFactor(Record, kind="MethodRow"):
    """A row of the table of methods: .method, .title, .criterion, .factor, .lower, .upper, …"""

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
        return pandas.DataFrame([row.to_dict() for row in self])


class Surface(Record, kind="MethodSurface"):
    """A slip surface of a method: .name, .title, .method, .factor, .points (points, 2) [m], …"""


def read_methods(run: Record) -> MethodTable:
    """The table of a run; empty where there is none."""
    return MethodTable(run.methods.table if run.methods else [])


def read_surfaces(run: Record) -> dict[str, Surface]:
    """The slip surfaces of a run by name; empty where there are none."""
    return {surface.name: surface for surface in run.methods.surfaces} if run.methods else {}


def _show(value: Optional[float]) -> str:
    return "–" if value is None else f"{value:.3f}"
