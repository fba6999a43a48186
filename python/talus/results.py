"""The results of a run as NumPy arrays, read by the library itself."""

from __future__ import annotations

import functools
import json
import os
from pathlib import Path
from typing import Any, Iterator, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from .errors import InputError

_CURVE_TYPE = np.dtype(
    [
        ("srf", "f8"),
        ("displacement", "f8"),
        ("end", "U8"),
        ("time", "f8"),
        ("steps", "i8"),
        ("force_ratio", "f8"),
        ("nodal_speed", "f8"),
        ("largest_nodal_speed", "f8"),
    ]
)


class Fields(dict[str, NDArray[Any]]):
    """Arrays by name, with `units[name]`."""

    def __init__(self, columns: dict[str, tuple[str, NDArray[Any]]]) -> None:
        super().__init__({name: values for name, (_, values) in columns.items()})
        self.units: dict[str, str] = {name: unit for name, (unit, _) in columns.items()}

    def __missing__(self, name: str) -> NDArray[Any]:
        raise KeyError(f"there is no '{name}'; there are {', '.join(self)}")


class History(Fields):
    """Columns of a table over time: history["time"], history.units["kinetic_energy"]."""


class Mesh:
    """The background mesh of a frame. The arrays are the library's own memory and cannot be written to."""

    def __init__(self, mesh: _core.MeshFrame) -> None:
        self.nodes: NDArray[Any] = mesh.nodes  #: (nodes, 3) [m]
        self.elements: NDArray[Any] = mesh.elements  #: (elements, 3 or 4) numbers of nodes
        self.element_fields = Fields(mesh.element_fields)
        self.node_fields = Fields(mesh.node_fields)


class Frame:
    """All material points at one time, in SI units, stress positive in tension.

    The arrays are the library's own memory: no copy, alive as long as one of them is, not to be written to. Points that
    left the grid are missing: follow a point by its id, not by its row."""

    def __init__(self, frame: _core.Frame, results: "Results", index: int) -> None:
        self._frame = frame
        self.results = results
        self.index: int = index
        self.time: float = frame.time  #: simulated [s]
        self.step: int = frame.step
        self.stage: str = frame.stage  #: name of the stage or trial
        self.positions: NDArray[Any] = frame.positions  #: (points, 3) [m]; z = 0 in 2D
        self.ids: NDArray[Any] = frame.ids  #: number of each point, for its whole life
        self.materials: NDArray[Any] = frame.materials  #: 0, 1, … in the order of `Results.materials`
        self.fields = Fields(frame.fields)
        mesh = frame.mesh
        self.mesh: Optional[Mesh] = Mesh(mesh) if mesh is not None else None  #: where the case stores it

    def field(self, name: str) -> NDArray[Any]:
        """A field of the points: (points,), or (points, 3) for vectors, (points, 6) for xx yy zz xy yz xz."""
        if name not in self.fields:
            raise InputError(
                f"there is no field '{name}' in '{self.results.folder}'; the fields are {', '.join(self.fields)}"
            )
        return self.fields[name]

    def unit(self, name: str) -> str:
        """The SI unit of a field; "-" for a number without one."""
        self.field(name)
        return self.fields.units[name]

    def __len__(self) -> int:
        return len(self.ids)

    def __repr__(self) -> str:
        return f"talus.Frame({self.index}: t = {self.time:.4g} s, {self.stage!r}, {len(self)} points)"


class Results:
    """The folder of a run, of a trial, or of a run that is still going on: what is read is what lay there then."""

    def __init__(self, folder: Union[str, os.PathLike[str]], parent: Optional["Results"] = None) -> None:
        self.folder = Path(folder)
        self.parent = parent  #: the run that a trial belongs to
        if self.folder.name == "results.vtkhdf":
            self.folder = self.folder.parent
        if not self.folder.is_dir():
            raise InputError(f"there is no folder '{self.folder}'")

    @functools.cached_property
    def _reader(self) -> _core.Reader:
        return _core.Reader(self.folder)

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json, or trial.json of a trial; empty when there is neither yet."""
        for name in ("summary.json", "trial.json"):
            path = self.folder / name
            if path.exists():
                try:
                    return dict(json.loads(path.read_text(encoding="utf-8")))
                except ValueError as error:
                    raise InputError(f"cannot read '{path}': {error}") from error
        return {}

    @property
    def status(self) -> str:
        """finished, interrupted, unstable, failed; "unknown" without a summary."""
        return self.summary.get("status", "unknown")

    @property
    def warnings(self) -> list[str]:
        """What must be known before the results are used."""
        return self.summary.get("warnings", [])

    @property
    def run_summary(self) -> dict[str, Any]:
        """The summary of the run, also from one of its trials."""
        return self.parent.run_summary if self.parent else self.summary

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
        """The factor of safety (frozen geometry), or None where none was calculated."""
        value: Optional[float] = self.summary.get("factor_of_safety", {}).get("value")
        return value

    @property
    def criteria(self) -> dict[str, Optional[float]]:
        """The factors by every criterion; None for a criterion that found none."""
        listed = self.summary.get("curve", {}).get("criteria", [])
        return {criterion["name"]: criterion["factor"] for criterion in listed}

    @property
    def curve(self) -> Optional[Any]:
        """A record array with a row for each trial of the curve, in SI units: srf, displacement, end, …; or None."""
        block = self.summary.get("curve")
        if block is None:
            return None
        rows = [tuple(point[name] for name in _CURVE_TYPE.names or ()) for point in block["points"]]
        return np.array(rows, dtype=_CURVE_TYPE).view(np.recarray)

    @property
    def times(self) -> NDArray[Any]:
        """Time of each frame [s]."""
        return np.array(self._reader.times)

    @property
    def steps(self) -> NDArray[Any]:
        """Number of the time step of each frame."""
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
        count = len(self)
        return Frame(self._reader.read(index + count if index < 0 else index), self, index % count)

    def frame_at(self, time: float) -> Frame:
        """The frame nearest to `time` [s]; the later of two at the same time."""
        return self.frame(self._reader.find_nearest(time))

    def __len__(self) -> int:
        return len(self._reader.times)

    def __getitem__(self, index: int) -> Frame:
        if not -len(self) <= index < len(self):
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
    def trials(self) -> dict[float, "Results"]:
        """The trials of the curve by their factor; each has its last frame, one with a runout more of them."""
        found: dict[float, Results] = {}
        for path in sorted(self.folder.glob("trials/*/trial.json")):
            trial = Results(path.parent, self)
            found[trial.summary["srf"]] = trial
        return dict(sorted(found.items()))

    def write_report(self) -> Path:
        """Writes report.html into the folder, as `talus report` does, and returns its path."""
        return _core.write_report(self.folder)

    def _read_history(self, name: str) -> History:
        path = self.folder / name
        return History(_core.read_history(path).columns if path.exists() else {})

    def __repr__(self) -> str:
        state = f"trial at SRF {self.summary['srf']:g}" if "srf" in self.summary else self.status
        return f"talus.Results({str(self.folder)!r}, {state})"
