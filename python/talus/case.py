# SPDX-License-Identifier: MIT
"""A case: read from a file or built in code, with the names of `talus manual`, checked by the library itself."""

from __future__ import annotations

import copy
import html
import os
import tomllib
from pathlib import Path
from typing import Any, Optional, Union

import tomli_w

from . import _core
from .declarations import describe, get_root
from .tables import keep_given, make_table_class

__all__ = ["Case", "describe"]

#: How messages name a case that is no file. Their line numbers are those of `Case.to_toml()`.
CODE_NAME = "<case>"

_CaseTable: Any = make_table_class(get_root())


class Case(_CaseTable):  # type: ignore[misc]
    """A case. Blocks and keys are attributes with the names of `talus manual` (`from_` for `from`).

    case = talus.Case(title="Cut", geometry=dict(box=[[0, 0], [44, 17]], polygon=[dict(...)]), ...)
    case = talus.Case.read("case.toml")
    case.mesh.size = 0.5
    case.materials["sand"].cohesion = "3 kPa"
    case.stage["gravity"].damping = 0.7         # by name or number
    case["strength_reduction.curve.step"] = 0.1

    What is not given reads as None; `echo()` tells what the calculation will use. An unknown name is refused at once,
    everything else by `validate()` and `talus.run`.
    """

    def __init__(self, **blocks: Any) -> None:
        super().__init__({}, ())
        object.__setattr__(self, "_file", None)
        object.__setattr__(self, "_text", None)
        object.__setattr__(self, "_as_read", None)
        for name, value in blocks.items():
            self[name] = value

    @classmethod
    def read(cls, path: Union[str, os.PathLike[str]]) -> "Case":
        """Reads a case file. Raises InputError when it cannot be read or is not TOML; faults of its content are found
        by `validate()` and `talus.run`, so that they can be corrected in code first."""
        name = os.fspath(path)
        try:
            text = Path(name).read_bytes().decode("utf-8")
            data = tomllib.loads(text)
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
            _core.read_case(name)  # says it in the words of the command line
            raise
        case = cls()
        case._data.update(data)
        object.__setattr__(case, "_file", name)
        object.__setattr__(case, "_text", text)
        object.__setattr__(case, "_as_read", copy.deepcopy(data))
        return case

    @classmethod
    def from_toml(cls, text: str) -> "Case":
        """A case from TOML text."""
        try:
            data = tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            _core.read_case_text(text, CODE_NAME)
            raise
        case = cls()
        case._data.update(data)
        return case

    @property
    def file(self) -> Optional[str]:
        """The file that the case was read from."""
        file: Optional[str] = self._file
        return file

    def copy(self) -> "Case":
        """A case of its own with the same content."""
        case = type(self)()
        case._data.update(copy.deepcopy(self._data))
        for name in ("_file", "_text", "_as_read"):
            object.__setattr__(case, name, getattr(self, name))
        return case

    def to_dict(self) -> dict[str, Any]:
        """What is given, as plain dicts and lists."""
        return dict(keep_given(get_root(), self._data))

    def to_toml(self) -> str:
        """The case as a case file; the file's own text, with its comments, as long as nothing was changed."""
        if self._is_as_read():
            return str(self._text)
        return tomli_w.dumps(self.to_dict())

    def validate(self) -> None:
        """Checks the case. Raises InputError with all faults, in the words of the command line; `.findings` lists them.

        Lines are those of the file, or of `to_toml()` when the case was built or changed in code."""
        self._load()

    def echo(self) -> dict[str, Any]:
        """Every value that a calculation uses, with its unit and whether it was given or is a default. Validates."""
        return self._load().echo

    def _is_as_read(self) -> bool:
        return self._text is not None and self.to_dict() == keep_given(get_root(), self._as_read)

    def _load(self) -> _core.LoadedCase:
        """Read by the library. Paths in the case are relative to the folder of its file."""
        name = self._file or CODE_NAME
        if self._file and not self._is_as_read():
            name += " (changed)"
        return _core.read_case_text(self.to_toml(), name)

    def __repr__(self) -> str:
        return f"talus.Case({self._data.get('title', 'untitled')!r})"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.to_toml())}</pre>"
