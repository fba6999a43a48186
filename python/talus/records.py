# SPDX-License-Identifier: MIT
"""The results as objects. Their names, units and titles are those of the library's description of the results
(`talus schema --results`); no name is declared a second time here."""

from __future__ import annotations

import functools
import json
from typing import Any, Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from . import _core
from .declarations import to_attribute, to_key

_Schema = dict[str, Any]
_NUMBERS = {"number": "f8", "integer": "i8", "boolean": "?"}


@functools.lru_cache(maxsize=None)
def get_types() -> dict[str, _Schema]:
    """The JSON Schema of every type of result by its name."""
    types: dict[str, _Schema] = json.loads(_core.get_result_schema())["$defs"]
    return types


def _resolve(schema: _Schema) -> tuple[str, _Schema]:
    """The name of a type, empty where it has none, and its schema without references and null."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        return name, get_types()[name]
    for choice in [*schema.get("allOf", []), *schema.get("anyOf", [])]:
        if choice.get("type") != "null":
            return _resolve(choice)
    return "", schema


def _find_number(schema: _Schema) -> str:
    """The type of a number, "number" or "integer"; empty for anything else."""
    kind = _resolve(schema)[1].get("type", "")
    name = str(kind[0] if isinstance(kind, list) else kind)  # a number may be null
    return name if name in _NUMBERS else ""


def _wrap(value: Any, schema: _Schema) -> Any:
    """A value of the JSON with its type: objects become records, lists of numbers and of points arrays."""
    name, schema = _resolve(schema)
    if isinstance(value, dict):
        if "properties" in schema:
            return _CLASSES.get(name, Record)(value, name)
        inner = schema.get("additionalProperties")
        return {key: _wrap(entry, inner) for key, entry in value.items()} if isinstance(inner, dict) else value
    if isinstance(value, list):
        items = schema.get("items", {})
        if number := _find_number(items):
            return np.array(value, "f8" if None in value else _NUMBERS[number])
        inner = _resolve(items)[1]
        if "maxItems" in inner and _find_number(inner.get("items", {})):
            return np.array(value, "f8").reshape(-1, inner["maxItems"])
        return [_wrap(entry, items) for entry in value]
    return value


class Record:
    """A part of the results: its names are attributes (`from_` for `from`) and items, None where there is no value.
    Lists of numbers and of points are arrays. `describe()` has titles and units."""

    def __init__(self, data: dict[str, Any], kind: str) -> None:
        """kind: name of the type in `talus schema --results`."""
        object.__setattr__(self, "_data", data)
        object.__setattr__(self, "_kind", kind)

    def __init_subclass__(cls, kind: str = "") -> None:
        if kind:
            _CLASSES[kind] = cls

    @property
    def _properties(self) -> dict[str, _Schema]:
        properties: dict[str, _Schema] = get_types()[self._kind]["properties"]
        return properties

    def __getitem__(self, name: str) -> Any:
        name = to_key(name)
        if name not in self._properties:
            raise KeyError(f"there is no '{name}' in {self._kind}; there are {', '.join(self._properties)}")
        return _wrap(self._data.get(name), self._properties[name])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("results cannot be changed")

    def __iter__(self) -> Iterator[str]:
        """The names that have a value."""
        return (name for name in self._properties if self._data.get(name) is not None)

    def __contains__(self, name: object) -> bool:
        return name in set(self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and (self._kind, self._data) == (other._kind, other._data)

    __hash__ = None  # type: ignore[assignment]

    def __dir__(self) -> Iterable[str]:
        return [*super().__dir__(), *map(to_attribute, self._properties)]

    def to_dict(self) -> dict[str, Any]:
        """The same as plain dicts and lists, as the file has it."""
        return dict(self._data)

    def describe(self) -> str:
        """The title and the unit of each name."""
        return "\n".join(f"{name}: {schema['description']}" for name, schema in self._properties.items())

    def __repr__(self) -> str:
        return f"<{self._kind}: {', '.join(self)}>"


_CLASSES: dict[str, type[Record]] = {}


def make_rows(records: list[Record], kind: str) -> NDArray[Any]:
    """A record array with a row for each record and a column for each number, word and text that all of the kind have."""
    columns: list[tuple[str, str]] = []
    schema = get_types()[kind]
    for name in schema["required"]:
        inner = _resolve(schema["properties"][name])[1]
        if number := _find_number(inner):
            columns.append((name, _NUMBERS[number]))
        elif "enum" in inner:
            columns.append((name, f"U{max(map(len, inner['enum']))}"))
    names = [name for name, _ in columns]
    return np.array([tuple(record[name] for name in names) for record in records], dtype=columns).view(np.recarray)
