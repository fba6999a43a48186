# SPDX-License-Identifier: MIT
"""Arrays by name, with their units."""

from __future__ import annotations

import html
from typing import Any

import numpy as np
from numpy.typing import NDArray

#: Names of the components of vectors and symmetric tensors, by their number.
COMPONENTS = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "xz"]}


class Fields(dict[str, NDArray[Any]]):
    """Arrays by name; `units[name]` is the unit, "-" for a number without one."""

    def __init__(self, columns: dict[str, tuple[str, NDArray[Any]]]) -> None:
        super().__init__({name: values for name, (_, values) in columns.items()})
        self.units: dict[str, str] = {name: unit for name, (unit, _) in columns.items()}

    def __missing__(self, name: str) -> NDArray[Any]:
        raise KeyError(f"there is no '{name}'; there are {', '.join(self)}")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), ({name: (self.units[name], values) for name, values in self.items()},)

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with a column for each field, and one for each component of vectors and tensors
        ("stress.xx"); its `attrs["units"]` are the units. Needs pandas."""
        return make_dataframe({name: (self.units[name], values) for name, values in self.items()})

    def __repr__(self) -> str:
        rows = len(next(iter(self.values()))) if self else 0
        words = ", ".join(f"{name} [{self.units[name]}]" for name in self)
        return f"talus.{type(self).__name__}({rows} rows: {words})"

    def _repr_html_(self) -> str:
        return f"<code>{html.escape(repr(self))}</code>"


class History(Fields):
    """Columns of a table over time: history["time"] is (rows,) in history.units["time"]."""


def make_dataframe(columns: dict[str, tuple[str, NDArray[Any]]]) -> Any:
    """A pandas.DataFrame with a column for each component."""
    try:
        import pandas
    except ImportError as missing:
        raise ImportError("to_dataframe needs pandas (Debian: python3-pandas)") from missing
    data: dict[str, NDArray[Any]] = {}
    units: dict[str, str] = {}
    for name, (unit, values) in columns.items():
        parts = {name: values}
        if values.ndim == 2:
            names = COMPONENTS.get(values.shape[1]) or [str(i) for i in range(values.shape[1])]
            parts = {f"{name}.{axis}": values[:, i] for i, axis in enumerate(names)}
        data.update({part: np.array(column) for part, column in parts.items()})
        units.update(dict.fromkeys(parts, unit))
    frame = pandas.DataFrame(data)
    frame.attrs["units"] = units
    return frame
