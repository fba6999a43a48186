# SPDX-License-Identifier: MIT
"""The numbers of a run under the names of the manual, and the values that the case compares them with."""

from __future__ import annotations

from typing import Any, Optional

from .records import Record


class _Shown(Record):
    """A record with its numbers in `unit`, in which the report shows them; "-" for numbers without one."""

    def __getitem__(self, name: str) -> Any:
        unit = self._data["unit"]
        if name == "unit":
            return unit["name"] or "-"
        value = super().__getitem__(name)
        return value / unit["si"] if isinstance(value, (int, float)) and not isinstance(value, bool) else value


class Result(_Shown, kind="NamedResult"):
    """A number of a run: .name as in [[compare]], .title, .value in .unit. The value is None where the two meshes of a
    runout do not determine it; .undetermined says why."""

    @property
    def si(self) -> Optional[float]:
        """The value in SI units; None where it is not determined."""
        value = self._data["value"]
        return None if value is None else float(value)

    def __float__(self) -> float:
        if self.value is None:
            raise ValueError(f"{self.name} is {self.undetermined}")
        return float(self.value)

    def __str__(self) -> str:
        return f"{self.title}: {_write_value(self, 4)}"


class Comparison(_Shown, kind="Comparison"):
    """A number of a run beside the one that the case expects: .computed (None: .note says why), .published, .tolerance
    in .unit, .passes."""

    def __str__(self) -> str:
        expected = f"published {self.published:.4g} ± {self.tolerance:.2g}{_write_unit(self.unit)}"
        if self.computed is None:
            return f"{self.title}: {expected}; {self.note}"
        return f"{self.title}: {self.computed:.4g}, {expected}: {'passes' if self.passes else 'does not pass'}"


class ResultTable(dict[str, Result]):
    """Results by name. An unknown name lists those that there are."""

    def __missing__(self, name: str) -> Result:
        raise KeyError(f"there is no result '{name}'; there are {', '.join(self)}")

    def __repr__(self) -> str:
        return "\n".join(f"{name}: {_write_value(result, 6)}" for name, result in self.items())


def read_results(run: Record) -> ResultTable:
    """The results of a run by name."""
    return ResultTable((result.name, result) for result in run.results or [])


def _write_value(result: Result, digits: int) -> str:
    if result.value is None:
        return str(result.undetermined)
    return f"{result.value:.{digits}g}{_write_unit(result.unit)}"


def _write_unit(unit: str) -> str:
    return "" if unit == "-" else f" {unit}"
