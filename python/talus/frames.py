# SPDX-License-Identifier: MIT
"""All material points of a run at one time, and the mesh below them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from .errors import InputError
from .fields import Fields, make_dataframe

if TYPE_CHECKING:
    from .results import Results


class Mesh:
    """The background mesh of a frame. The arrays are the library's own memory and cannot be written to."""

    def __init__(self, mesh: _core.MeshFrame) -> None:
        self.nodes: NDArray[Any] = mesh.nodes  #: (nodes, 3) [m]
        self.elements: NDArray[Any] = mesh.elements  #: (elements, 3 or 4) numbers of nodes
        self.element_fields = Fields(mesh.element_fields)  #: (elements,) each, where output.cells is true
        self.node_fields = Fields(mesh.node_fields)  #: (nodes,) or (nodes, 3) each, where output.nodes is true

    def __repr__(self) -> str:
        fields = ", ".join([*self.element_fields, *self.node_fields])
        return f"talus.Mesh({len(self.nodes)} nodes, {len(self.elements)} elements; {fields or 'no fields'})"


class Frame:
    """All material points at one time, in SI units, stress positive in tension.

    The arrays are the library's own memory: no copy, alive as long as one of them is, not to be written to. Points that
    left the grid are missing: follow a point by its id, not by its row."""

    def __init__(self, frame: _core.Frame, results: "Results", index: int) -> None:
        self._frame = frame
        self.results = results
        self.index: int = index
        self.time: float = frame.time  #: simulated [s]
        self.step: int = frame.step  #: number of the time step
        self.stage: str = frame.stage  #: name of the stage or trial
        self.positions: NDArray[Any] = frame.positions  #: (points, 3) [m]; z = 0 in 2D
        self.ids: NDArray[Any] = frame.ids  #: (points,) number of each point, for its whole life
        self.materials: NDArray[Any] = frame.materials  #: (points,) 0, 1, … in the order of `Results.materials`
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

    def find_point(self, at: Sequence[float]) -> int:
        """The id of the material point nearest to `at`, (x, y) or (x, y, z) [m]."""
        place = np.asarray(at, dtype=float)
        if place.shape not in ((2,), (3,)):
            raise InputError(f"a place has two or three coordinates in m, not {at!r}")
        return int(self.ids[np.linalg.norm(self.positions[:, : len(place)] - place, axis=1).argmin()])

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with a row for each point, its index the ids: position.x …, material, and a column for each
        component of each field, in SI units (`attrs["units"]`). Needs pandas."""
        columns = {"position": ("m", self.positions), "material": ("-", self.materials)}
        columns.update({name: (self.fields.units[name], values) for name, values in self.fields.items()})
        frame = make_dataframe(columns)
        return frame.set_axis(np.array(self.ids)).rename_axis("id")

    def __reduce__(self) -> tuple[Any, ...]:
        return _read_again, (self.results, self.index)  # it is read where it arrives

    def __len__(self) -> int:
        return len(self.ids)

    def __repr__(self) -> str:
        return f"talus.Frame({self.index}: t = {self.time:.4g} s, {self.stage!r}, {len(self)} points)"


def _read_again(results: "Results", index: int) -> Frame:
    return results.frame(index)


def follow_points(frames: Iterable[Frame], ids: Union[int, Sequence[int], NDArray[Any]], names: Sequence[str]) -> Fields:
    """See Results.point_history."""
    wanted = np.atleast_1d(np.asarray(ids))
    if wanted.ndim != 1 or not np.issubdtype(wanted.dtype, np.integer):
        raise InputError(f"points are followed by their ids, which are integers (Frame.ids), not by {ids!r}")
    times: list[float] = []
    columns: dict[str, list[NDArray[Any]]] = {name: [] for name in names}
    units: dict[str, str] = {}
    ever_found = np.zeros(len(wanted), dtype=bool)
    for frame in frames:
        order = np.argsort(frame.ids)
        place = order[np.minimum(np.searchsorted(frame.ids, wanted, sorter=order), len(frame) - 1)]
        found = frame.ids[place] == wanted
        ever_found |= found
        times.append(frame.time)
        for name, column in columns.items():
            values = frame.positions if name == "position" else frame.field(name)
            units[name] = "m" if name == "position" else frame.unit(name)
            row = np.full((len(wanted), *values.shape[1:]), np.nan)
            row[found] = values[place[found]]
            column.append(row if np.ndim(ids) else row[0])
    if not ever_found.all():
        raise InputError(f"there is no point {wanted[~ever_found][0]} in any frame; Frame.ids lists the points")
    stacked = {name: (units[name], np.array(column)) for name, column in columns.items()}
    return Fields({"time": ("s", np.array(times)), **stacked})
