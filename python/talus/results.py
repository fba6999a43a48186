# SPDX-License-Identifier: MIT
"""The results of a run as NumPy arrays, read by the library itself."""

from __future__ import annotations

import functools
import html
import json
import operator
import os
from pathlib import Path
from typing import Any, Iterator, Optional, Sequence, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from .errors import InputError
from .fields import Fields, History
from .frames import Frame, Mesh, follow_points
from .methods import MethodTable, Surface, read_methods, read_surfaces
from .named import Comparison, ResultTable, read_results
from .records import Record, make_rows


def read_summary(path: Path) -> dict[str, Any]:
    """Reads summary.json or study.json. Raises InputError where it is damaged or of another format."""
    try:
        summary = dict(json.loads(path.read_text(encoding="utf-8")))
    except ValueError as error:
        raise InputError(f"cannot read '{path}': {error}") from error
    if summary.get("format", 1) != _core.result_format:
        raise InputError(
            f"'{path}' was written by another version of Talus (result format {summary.get('format', 1)}, this is "
            f"{_core.result_format}): run the case again"
        )
    return summary


class Trials(dict[float, "Results"]):
    """The trials of a curve by their factor; rounding errors of the factor do not matter."""

    def __missing__(self, factor: float) -> "Results":
        for known, trial in self.items():
            if abs(known - factor) <= 1e-9 * known:
                return trial
        raise KeyError(f"there is no trial at SRF {factor}; there are {', '.join(f'{known:g}' for known in self)}")

    def __repr__(self) -> str:
        return f"talus.Trials({', '.join(f'{known:g}' for known in self)})"


class Results:
    """The folder of a run, of a trial, or of a run that has not ended, as far as it is written."""

    def __init__(self, folder: Union[str, os.PathLike[str]], parent: Optional["Results"] = None) -> None:
        """Nothing is read yet. Raises InputError where there is no such folder, or where it is a study's."""
        self.folder = Path(folder)
        self.parent = parent  #: the run that a trial belongs to
        if self.folder.name == "results.vtkhdf":
            self.folder = self.folder.parent
        if not self.folder.is_dir():
            raise InputError(f"there is no folder '{self.folder}'")
        if (self.folder / "study.json").exists():
            raise InputError(f"'{self.folder}' is the folder of a study: read it with talus.Study")

    @functools.cached_property
    def _reader(self) -> _core.Reader:
        return _core.Reader(self.folder)

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json, or trial.json of a trial; empty when there is neither yet."""
        if (self.folder / "summary.json").exists():
            return read_summary(self.folder / "summary.json")
        path = self.folder / "trial.json"
        try:
            return dict(json.loads(path.read_text(encoding="utf-8"))) if path.exists() else {}
        except ValueError as error:
            raise InputError(f"cannot read '{path}': {error}") from error

    @property
    def record(self) -> Record:
        """The summary with its names as attributes, as `talus schema --results` describes them:
        record.lem.critical[0].surface.factor. None where the run has no such result; `record.describe()` has titles and
        units."""
        return Record(self.summary, "Trial" if "srf" in self.summary else "RunResult")

    @property
    def status(self) -> str:
        """finished, interrupted, unstable, failed; "unknown" without a summary."""
        return str(self.summary.get("status", "unknown"))

    @property
    def warnings(self) -> list[str]:
        """Warnings on the results."""
        return list(self.summary.get("warnings", []))

    @property
    def run_summary(self) -> dict[str, Any]:
        """The summary of the run, also from one of its trials."""
        return self.parent.run_summary if self.parent else self.summary

    @property
    def _run(self) -> Record:
        """The record of a run; without results of a run for a trial."""
        return Record({} if "srf" in self.summary else self.summary, "RunResult")

    @property
    def units(self) -> dict[str, str]:
        """The units of the histories and of plots: length, displacement, stress."""
        return {"length": "m", "displacement": "mm", "stress": "kPa", **self.run_summary.get("units", {})}

    @property
    def materials(self) -> list[str]:
        """Names of the materials, in the order of their numbers."""
        return sorted(self.run_summary.get("input", {}).get("materials", {}))

    @property
    def factor_of_safety(self) -> Optional[float]:
        """The factor of safety that governs, or None where none was calculated: the smallest of LEM (of all admissible
        surfaces), FEM and MPM. `methods` lists all factors."""
        value: Optional[float] = self._run.main_factor
        return value

    @property
    def disagreement(self) -> Optional[str]:
        """Two factors that lie so far apart that neither may be used, as a sentence; None where there are none."""
        found = self._run.disagreement
        return str(found.text) if found else None

    @property
    def methods(self) -> MethodTable:
        """The factors of all methods beside one another; empty for MPM alone and for trials."""
        return read_methods(self._run)

    @property
    def surfaces(self) -> dict[str, Surface]:
        """The slip surfaces of the methods by name, surfaces["lem.spencer"].points (points, 2) [m]."""
        return read_surfaces(self._run)

    @property
    def criteria(self) -> dict[str, Optional[float]]:
        """The factors by every criterion; None for a criterion that found none."""
        curve = self._run.curve
        return {criterion.name: criterion.factor for criterion in curve.criteria} if curve else {}

    @property
    def results(self) -> ResultTable:
        """Every number of the run by its name, results["runout[1.75].front_advance"].value, .unit, .title, .si."""
        return read_results(self._run)

    @property
    def comparisons(self) -> list[Comparison]:
        """The values that the case's [[compare]] expects, beside what was computed, and whether they pass."""
        return list(self._run.comparisons or [])

    @property
    def failure_time(self) -> Optional[float]:
        """When the slope failed [s], from the start of the last stage or of the trial's runout: when the displacement
        passed `displacement_ratio` of the height. None where it did not, or where it was not looked for."""
        runout: Optional[Record] = self._run
        if self.parent and "srf" in self.summary:
            matches = [r for r in self.parent._run.runouts or [] if r.srf == self.summary["srf"]]
            runout = matches[0] if matches else None
        value: Optional[float] = runout.failure_time if runout else None
        return value

    @property
    def curve(self) -> Optional[Any]:
        """A record array with a row for each trial of the curve, or None: srf, displacement [m], end (rest, time, …),
        time [s], steps, force_ratio, nodal_speed and largest_nodal_speed [m/s]."""
        curve = self._run.curve
        return make_rows(curve.points, "Trial") if curve else None

    @property
    def times(self) -> NDArray[Any]:
        """(frames,) time of each frame [s]."""
        return np.array(self._reader.times)

    @property
    def steps(self) -> NDArray[Any]:
        """(frames,) number of the time step of each frame."""
        return np.array(self._reader.steps)

    @property
    def stages(self) -> list[str]:
        """Name of the stage of each frame."""
        return self._reader.stages

    @property
    def fields(self) -> list[str]:
        """Names of the fields of the points."""
        return self._reader.field_names

    def frame(self, index: int = -1) -> Frame:
        """The frame with this index, counted from 0, or from the end when negative; the last one by default."""
        index, count = operator.index(index), len(self)
        return Frame(self._reader.read(index + count if index < 0 else index), self, index % count)

    def frame_at(self, time: float) -> Frame:
        """The frame nearest to `time` [s]; the later of two at the same time."""
        return self.frame(self._reader.find_nearest(time))

    def point_history(self, ids: Union[int, Sequence[int], NDArray[Any]], *fields: str) -> Fields:
        """A point, or several, through all frames: "time" (frames,) [s] and each field in SI units, (frames,) or
        (frames, components) for one id, (frames, ids, …) for a list of them. NaN where a point has left the grid.

        fields: names of `Results.fields`, or "position"; without any, "displacement".

        crest = results[0].find_point((12, 15)); results.point_history(crest, "displacement", "stress")
        """
        return follow_points(iter(self), ids, fields or ("displacement",))

    def __len__(self) -> int:
        return len(self._reader.times)

    @overload
    def __getitem__(self, index: int) -> Frame: ...
    @overload
    def __getitem__(self, index: slice) -> list[Frame]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Frame, list[Frame]]:
        if isinstance(index, slice):
            return [self.frame(i) for i in range(*index.indices(len(self)))]
        if not -len(self) <= operator.index(index) < len(self):
            raise IndexError(f"there is no frame {index} in '{self.folder}': there are {len(self)}")
        return self.frame(index)

    def __iter__(self) -> Iterator[Frame]:
        return (self.frame(i) for i in range(len(self)))

    def __bool__(self) -> bool:
        return True

    @property
    def mesh(self) -> Optional[Mesh]:
        """The background mesh of the last frame, where the case stores it (output.cells or output.nodes)."""
        return self.frame().mesh

    @functools.cached_property
    def history(self) -> History:
        """history.csv: sums and energies over time; empty where there is none."""
        return self._read_history("history.csv")

    @functools.cached_property
    def monitors(self) -> History:
        """monitors.csv: single points over time, "crest.displacement_x"; empty where there is none."""
        return self._read_history("monitors.csv")

    @functools.cached_property
    def trials(self) -> Trials:
        """The trials of the curve by their factor; each has its last frame, one with a runout more of them."""
        found: dict[float, Results] = {}
        for path in sorted(self.folder.glob("trials/*/trial.json")):
            trial = Results(path.parent, self)
            found[trial.summary["srf"]] = trial
        return Trials(sorted(found.items()))

    def write_report(self) -> Path:
        """Writes report.html into the folder, as `talus report` does, and returns its path."""
        return _core.write_report(self.folder)

    def _read_history(self, name: str) -> History:
        path = self.folder / name
        return History(_core.read_history(path).columns if path.exists() else {})

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.folder, self.parent)  # it is read again where it arrives

    def __repr__(self) -> str:
        state = f"trial at SRF {self.summary['srf']:g}" if "srf" in self.summary else self.status
        return f"talus.Results({str(self.folder)!r}, {state})"

    def _repr_html_(self) -> str:
        lines = [("folder", str(self.folder)), ("status", self.status)]
        if self.factor_of_safety is not None:
            lines.append(("factor of safety", f"{self.factor_of_safety:.3f}"))
        lines += [
            (f"factor by {name.replace('_', ' ')}", "none" if factor is None else f"{factor:.3f}")
            for name, factor in self.criteria.items()
        ]
        lines += [("comparison", str(comparison)) for comparison in self.comparisons]
        lines += [("warning", warning) for warning in self.warnings]
        title = html.escape(str(self.summary.get("title") or self))
        cells = [f"<tr><th>{html.escape(name)}</th><td>{html.escape(text)}</td></tr>" for name, text in lines]
        return f"<table><caption>{title}</caption>{''.join(cells)}</table>"
