# SPDX-License-Identifier: MIT
"""The numbers of a run under the names of the manual, and what the case compares them with."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional


@dataclass(frozen=True)
class Result:
    """A number of a run in the unit in which the report shows it."""

    name: str  #: as in [[compare]], "runout[1.75].front_advance"
    title: str  #: in words
    value: float  #: in `unit`
    unit: str  #: "-" for a number without one
    si: float  #: the value in SI units

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return f"{self.title}: {self.value:.4g}{_write_unit(self.unit)}"


@dataclass(frozen=True)
class Comparison:
    """A number of a run beside the one that the case expects, all in `unit`."""

    name: str  #: as in [[compare]]
    title: str  #: in words
    computed: Optional[float]  #: None: `note` says why there is none
    published: float
    tolerance: float  #: how far they may be apart
    unit: str  #: "-" for a number without one
    passes: bool  #: False as well where nothing was computed
    source: str  #: where the published number stands
    note: str

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
        return "\n".join(f"{name}: {result.value:.6g}{_write_unit(result.unit)}" for name, result in self.items())


def read_results(summary: dict[str, Any]) -> ResultTable:
    """`results` of a summary.json."""
    listed = ResultTable()
    for entry in summary.get("results", []):
        unit, value = entry["unit"], entry["value"]
        listed[entry["name"]] = Result(
            entry["name"], entry["title"], value / unit["si"], unit["name"] or "-", value
        )
    return listed


def read_comparisons(summary: dict[str, Any]) -> list[Comparison]:
    """`comparisons` of a summary.json."""
    listed = []
    for entry in summary.get("comparisons", []):
        factor = entry["unit"]["si"]
        computed = entry["computed"]
        listed.append(
            Comparison(
                name=entry["name"],
                title=entry["title"],
                computed=None if computed is None else computed / factor,
                published=entry["published"] / factor,
                tolerance=entry["tolerance"] / factor,
                unit=entry["unit"]["name"] or "-",
                passes=entry["passes"],
                source=entry["source"],
                note=entry["note"],
            )
        )
    return listed


def _write_unit(unit: str) -> str:
    return "" if unit == "-" else f" {unit}"
