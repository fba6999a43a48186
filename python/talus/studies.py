# SPDX-License-Identifier: MIT
"""The folder of a study: its table, and the results of every variant."""

from __future__ import annotations

import csv
import functools
import html
import os
from pathlib import Path
from typing import Any, Iterator, Optional, Union

import numpy as np
from numpy.typing import NDArray

from .errors import InputError
from .fields import Fields
from .records import Record
from .results import Results, read_summary


class Table(Fields):
    """The columns of a study's table, a row for each variant: numbers as (variants,) floats, NaN where a variant has no
    such result; names as texts."""


class Study:
    """The results of `talus study` or `talus.study`, also of one that has not ended or was stopped.

    study.table["FoS, frozen"], study.table["mesh.size"], study.table.units["mesh.size"]
    study["size_0.5"].frame()                # the results of a variant, by the name of its folder or its number
    """

    def __init__(self, folder: Union[str, os.PathLike[str]]) -> None:
        """Reads study.json in `folder`. Raises InputError where there is none."""
        self.folder = Path(folder)
        path = self.folder / "study.json"
        if not path.is_file():
            raise InputError(f"there is no study in '{self.folder}': it has no study.json")
        self.summary: dict[str, Any] = read_summary(path)  #: study.json
        self.record = Record(self.summary, "StudyResult")  #: the same with its names as attributes

    @property
    def title(self) -> str:
        """Title of the case."""
        return str(self.record.title)

    @property
    def names(self) -> list[str]:
        """Names of the variants, which are those of their folders; the first is "base"."""
        return [variant.folder for variant in self.record.variants]

    @property
    def labels(self) -> list[str]:
        """The variants for people, "size = 0.5"."""
        return [variant.name for variant in self.record.variants]

    @property
    def statuses(self) -> dict[str, str]:
        """How each variant went: finished, unstable, failed, interrupted, not started."""
        return {variant.folder: variant.status for variant in self.record.variants}

    @property
    def reasons(self) -> dict[str, str]:
        """Why variants did not finish; only those that did not."""
        return {variant.folder: variant.reason for variant in self.record.variants if variant.reason}

    @property
    def sampling(self) -> Optional[dict[str, Any]]:
        """The statistics of samples, as study.json has them; None where values were listed. `record.sampling` has the
        same with names as attributes."""
        sampling: Optional[dict[str, Any]] = self.summary.get("sampling")
        return sampling

    @property
    def back_analysis(self) -> Optional[dict[str, Any]]:
        """The outcome of `talus find`, as study.json has it: value, bracket, interval, runs; None for other studies."""
        finding: Optional[dict[str, Any]] = self.summary.get("back_analysis")
        return finding

    @functools.cached_property
    def samples(self) -> Table:
        """samples.csv as arrays by the name of the column, a row for each sample; NaN where it has no result."""
        path = self.folder / "samples.csv"
        if not path.is_file():
            raise InputError(f"the study in '{self.folder}' has no samples")
        with open(path, encoding="utf-8", newline="") as file:
            heads, *rows = csv.reader(file)
        columns = {}
        for i, head in enumerate(heads):
            name, _, unit = head.rstrip("]").partition(" [")
            columns[name] = (unit or "-", _to_array([row[i] for row in rows]))
        return Table(columns)

    @property
    def keys(self) -> list[str]:
        """The varied keys, "mesh.size": each is a column of the table."""
        return [key.key for key in self.record.vary]

    @functools.cached_property
    def table(self) -> Table:
        """study.csv as arrays by the name of the column, with units; numbers in full."""
        columns = self.record.columns
        return Table({c.name: (c.unit or "-", _to_array([cell.full for cell in c.cells])) for c in columns})

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The table as a dict for each variant."""
        table = self.table
        return [{name: values[i].item() for name, values in table.items()} for i in range(len(self))]

    def to_dataframe(self) -> Any:
        """The table as a pandas.DataFrame. Needs pandas."""
        return self.table.to_dataframe()

    @functools.cached_property
    def results(self) -> dict[str, Results]:
        """The results of the variants that have begun, by name, base first."""
        return {name: Results(self.folder / name) for name in self.names if (self.folder / name).is_dir()}

    def __getitem__(self, variant: Union[str, int]) -> Results:
        name = variant if isinstance(variant, str) else self.names[variant]
        if name not in self.names:
            raise KeyError(f"there is no variant '{name}'; there are {', '.join(self.names)}")
        if name not in self.results:
            raise InputError(f"the variant '{name}' has no results: it is {self.statuses[name]}")
        return self.results[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        if not self.names:
            return f"talus.Study({str(self.folder)!r}, {(self.sampling or {}).get('samples', 0)} samples)"
        finished = sum(status == "finished" for status in self.statuses.values())
        return f"talus.Study({str(self.folder)!r}, {finished} of {len(self)} variants finished)"

    def _repr_html_(self) -> str:
        def row(cells: list[str], tag: str) -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

        columns = self.record.columns
        heads = [column.title + (f" [{column.unit}]" if column.unit else "") for column in columns]
        shown = [[cell.shown for cell in column.cells] for column in columns]
        lines = [row(list(cells), "td") for cells in zip(*shown)]
        return f"<table><thead>{row(heads, 'th')}</thead><tbody>{''.join(lines)}</tbody></table>"


def _to_array(texts: list[str]) -> NDArray[Any]:
    """Floats where all cells are numbers or empty, else texts."""
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)
