# SPDX-License-Identifier: MIT
"""Attribute and item access to the tables of a case. The classes are made from the library's declarations."""

from __future__ import annotations

import datetime
import decimal
import numbers
import os
from collections.abc import Iterable, Mapping, Set
from typing import Any, ItemsView, Iterator, KeysView, Union, ValuesView

import numpy as np
import tomli_w

from . import _core
from .declarations import Block, to_attribute, to_key
from .errors import Finding, InputError, make_input_error

Path = tuple[Union[str, int], ...]


def to_plain(value: Any, name: str) -> Any:
    """The value in the types of TOML: tuples, ranges and arrays become lists, NumPy's numbers Python's; None is left out.
    `name` is the key that it is for. Raises InputError for a value that a case file cannot hold."""
    if isinstance(value, (Table, NamedTables, TableList)):
        value = value._data
    if isinstance(value, Mapping):
        return {to_key(str(k)): to_plain(v, f"{name}.{k}") for k, v in value.items() if v is not None}
    if isinstance(value, (str, bool, int, datetime.date, datetime.time)):
        return str(value) if isinstance(value, str) else value  # of NumPy's texts the plain one
    if isinstance(value, (numbers.Real, decimal.Decimal)):
        return value.item() if isinstance(value, np.generic) else float(value)
    if isinstance(value, (np.ndarray, np.generic)) or hasattr(value, "tolist"):
        return to_plain(value.tolist(), name)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Iterable) and not isinstance(value, (bytes, bytearray, Set)):
        return [to_plain(v, name) for v in value]
    return _refuse(value, name)


def _refuse(value: Any, name: str) -> Any:
    kind = "None in a list" if value is None else f"a value of the type {type(value).__name__}"
    sentence = f"'{name}' cannot be {kind}: a case holds numbers, texts, True and False, and lists and dicts of them"
    raise make_input_error([Finding("<case>", 0, 0, sentence)])


def keep_given(block: Block, data: Any) -> Any:
    """The data without the empty tables and lists that reading has created."""
    if not isinstance(data, dict) or block.kind == "entries":
        return data
    kept: dict[str, Any] = {}
    for name, value in data.items():
        inner = block.blocks.get(name)
        if inner is not None and isinstance(value, (dict, list)):
            if inner.kind == "named" and isinstance(value, dict):
                value = {label: keep_given(inner, item) for label, item in value.items()}
            elif inner.kind == "list" and isinstance(value, list):
                value = [keep_given(inner, item) for item in value]
            else:
                value = keep_given(inner, value)
            if not value:
                continue
        kept[name] = value
    return kept


def write_path(path: Path) -> str:
    return ".".join(str(step) for step in path)


def find_unknown(path: Path, name: str) -> InputError:
    """The library's own sentence about a name that it does not know: it reads a case with this one key."""
    data: Any = {name: True}
    for step in reversed(path):
        data = [data] if isinstance(step, int) else {step: data}
    try:
        _core.read_case_text(tomli_w.dumps(data), "<case>")
    except InputError as error:
        for finding in error.findings:
            if finding.is_unknown_key:
                return make_input_error([Finding("<case>", 0, 0, finding.sentence)])
    return make_input_error([Finding("<case>", 0, 0, f"unknown key '{name}' in '{write_path(path)}'")])


def check_names(block: Block, data: Any, path: Path) -> None:
    """Refuses unknown names at and under a table; values of the wrong kind are left to the library's reader."""
    if block.kind == "list" and not (path and isinstance(path[-1], int)):
        for i, item in enumerate(data if isinstance(data, list) else []):
            check_names(block, item, (*path, i))
        return
    if not isinstance(data, dict) or block.kind == "entries":
        return
    if block.kind == "named" and path[-1] == block.key:
        for label, item in data.items():
            _check_table(block, item, (*path, label))
        return
    _check_table(block, data, path)


def _want_table(name: str, value: Any) -> InputError:
    sentence = f"'{name}' is a table of keys: give a dict, not {value!r}"
    return make_input_error([Finding("<case>", 0, 0, sentence)])


def check_kind(block: Block, name: str, value: Any, path: Path) -> None:
    """Refuses a value where a table belongs: a key of it, set next, would have no place."""
    inner = block.blocks.get(name)
    full = write_path((*path, name))
    if inner is None:
        return
    if inner.kind == "list":
        if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
            sentence = f"'{full}' is a list of tables: give a list of dicts, not {value!r}"
            raise make_input_error([Finding("<case>", 0, 0, sentence)])
        return
    if not isinstance(value, dict):
        raise _want_table(full, value)
    if inner.kind == "named":
        for label, item in value.items():
            if not isinstance(item, dict):
                raise _want_table(f"{full}.{label}", item)
        return
    for key, item in value.items():
        check_kind(inner, key, item, (*path, name))


def _check_table(block: Block, data: Any, path: Path) -> None:
    if not isinstance(data, dict):
        return
    for name, value in data.items():
        if name in block.blocks:
            check_names(block.blocks[name], value, (*path, name))
        elif name not in block.keys:
            raise find_unknown(path, name)


class Table:
    """One table of a case."""

    _block: Block
    _classes: dict[str, type["Table"]]

    def __init__(self, data: dict[str, Any], path: Path) -> None:
        object.__setattr__(self, "_data", data)
        object.__setattr__(self, "_path", path)

    def __getitem__(self, name: str) -> Any:
        name, _, rest = name.partition(".")
        name = to_key(name)
        if name not in self._block.keys and name not in self._block.blocks:
            raise KeyError(find_unknown(self._path, name).findings[0].sentence)
        value = self._wrap(name) if name in self._block.blocks else self._data.get(name)
        return value[rest] if rest else value

    def __setitem__(self, name: str, value: Any) -> None:
        name, _, rest = name.partition(".")
        name = to_key(name)
        if rest:
            self[name][rest] = value
        elif value is None:
            self._data.pop(name, None)
        else:
            plain = to_plain(value, write_path((*self._path, name)))
            check_kind(self._block, name, plain, self._path)
            _check_table(self._block, {name: plain}, self._path)
            self._data[name] = plain

    def __delitem__(self, name: str) -> None:
        self[name] = None

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        raise AttributeError(find_unknown(self._path, to_key(name)).findings[0].sentence)

    def __setattr__(self, name: str, value: Any) -> None:
        self[name] = value

    def __contains__(self, name: str) -> bool:
        return to_key(name) in self._get_given()

    def __iter__(self) -> Iterator[str]:
        return iter(self._get_given())

    def __len__(self) -> int:
        return len(self._get_given())

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Table):
            return self._block is other._block and dict(self.items()) == dict(other.items())
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def keys(self) -> KeysView[str]:
        """Names of what is given."""
        return self._get_given().keys()

    def values(self) -> ValuesView[Any]:
        """What is given, as plain dicts and lists."""
        return self._get_given().values()

    def items(self) -> ItemsView[str, Any]:
        """Names and values of what is given, as plain dicts and lists."""
        return self._get_given().items()

    def update(self, table: Any = None, /, **keys: Any) -> None:
        """Sets several keys, given as a dict or by name."""
        for name, value in {**(table or {}), **keys}.items():
            self[name] = value

    def _get_given(self) -> dict[str, Any]:
        return dict(keep_given(self._block, self._data))

    def __repr__(self) -> str:
        names = ".".join(step for step in self._path if isinstance(step, str))
        header = f"[[{names}]]" if self._block.kind == "list" else f"[{names}]"
        return f"{header if names else ''} {self._get_given()}".lstrip()

    def _wrap(self, name: str) -> Any:
        """The block `name` for reading and changing; what is no table or list is returned as it is."""
        block = self._block.blocks[name]
        data = self._data.setdefault(name, [] if block.kind == "list" else {})
        path = (*self._path, name)
        if block.kind == "list":
            return TableList(self._classes[name], data, path) if isinstance(data, list) else data
        if not isinstance(data, dict):
            return data
        if block.kind == "table":
            return self._classes[name](data, path)
        return NamedTables(self._classes[name], data, path)


class NamedTables:
    """Tables, or single values, under names of the user's choice: case.materials["sand"], case.regions["soil"]."""

    def __init__(self, kind: type[Table], data: dict[str, Any], path: Path) -> None:
        object.__setattr__(self, "_kind", kind)
        object.__setattr__(self, "_data", data)
        object.__setattr__(self, "_path", path)

    def __getitem__(self, label: str) -> Any:
        rest = ""
        if label not in self._data:
            label, _, rest = label.partition(".")
        if label not in self._data:
            there = ", ".join(f"'{name}'" for name in self._data) or "none"
            raise KeyError(f"there is no '{label}' in [{write_path(self._path)}]; there are {there}")
        value = self._data[label]
        if self._kind._block.kind == "named" and isinstance(value, dict):
            value = self._kind(value, (*self._path, label))
        return value[rest] if rest else value

    def __setitem__(self, label: str, value: Any) -> None:
        is_named = self._kind._block.kind == "named"
        head, _, rest = label.partition(".")
        if is_named and rest and label not in self._data:
            self._kind(self._data.setdefault(head, {}), (*self._path, head))[rest] = value
        elif value is None:
            self._data.pop(label, None)
        else:
            plain = to_plain(value, write_path((*self._path, label)))
            if is_named:
                if not isinstance(plain, dict):
                    raise _want_table(write_path((*self._path, label)), plain)
                _check_table(self._kind._block, plain, (*self._path, label))
            self._data[label] = plain

    def __delitem__(self, label: str) -> None:
        del self._data[label]

    def __getattr__(self, label: str) -> Any:
        if label.startswith("_"):
            raise AttributeError(label)
        try:
            return self[label]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __setattr__(self, label: str, value: Any) -> None:
        self[label] = value

    def __contains__(self, label: str) -> bool:
        return label in self._data

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)

    def keys(self) -> list[str]:
        """The names of your choice."""
        return list(self._data)

    def values(self) -> list[Any]:
        """The tables, or the values, for reading and changing."""
        return [self[label] for label in self._data]

    def items(self) -> list[tuple[str, Any]]:
        """Names with their tables, or values, for reading and changing."""
        return [(label, self[label]) for label in self._data]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._data]

    def __repr__(self) -> str:
        return f"[{write_path(self._path)}] {self._data}"


class TableList:
    """A list of tables: case.stage[0], or by its name or side case.stage["gravity"], case.boundary["left"]."""

    def __init__(self, kind: type[Table], data: list[Any], path: Path) -> None:
        self._kind = kind
        self._data = data
        self._path = path

    def __getitem__(self, entry: Union[int, str]) -> Any:
        rest = ""
        if isinstance(entry, str):
            entry, rest = self._find(entry)
        value = self._data[entry]
        if isinstance(value, dict):
            value = self._kind(value, (*self._path, entry))
        return value[rest] if rest else value

    def __setitem__(self, entry: Union[int, str], value: Any) -> None:
        rest = ""
        if isinstance(entry, str):
            entry, rest = self._find(entry)
        if rest:
            self[entry][rest] = value
        else:
            self._data[entry] = self._check(value)

    def __delitem__(self, entry: Union[int, str]) -> None:
        del self._data[self._find(entry)[0] if isinstance(entry, str) else entry]

    def append(self, table: Any = None, /, **keys: Any) -> Any:
        """Adds a table, given as a dict or by its keys, and returns it."""
        self._data.append(self._check(self._join(table, keys)))
        return self[len(self._data) - 1]

    def insert(self, index: int, table: Any = None, /, **keys: Any) -> None:
        """The same at a place in the list."""
        self._data.insert(index, self._check(self._join(table, keys)))

    def __iter__(self) -> Iterator[Any]:
        return (self[i] for i in range(len(self._data)))

    def __len__(self) -> int:
        return len(self._data)

    def __repr__(self) -> str:
        return f"[[{write_path(self._path)}]] {self._data}"

    @staticmethod
    def _join(table: Any, keys: dict[str, Any]) -> Any:
        if isinstance(table, Table):
            table = table._data
        return {**(table or {}), **keys} if table is None or isinstance(table, Mapping) else table

    def _check(self, value: Any) -> Any:
        plain = to_plain(value, write_path(self._path))
        if not isinstance(plain, dict):
            raise _want_table(write_path(self._path), plain)
        _check_table(self._kind._block, plain, (*self._path, 0))
        return plain

    def _find(self, entry: str) -> tuple[int, str]:
        """The number of the entry with this name, side or number, and what follows it in a dotted path."""
        label, _, rest = entry.partition(".")
        if label.isdigit() and int(label) < len(self._data):
            return int(label), rest
        for i, table in enumerate(self._data):
            if isinstance(table, dict) and label in (table.get("name"), table.get("on")):
                return i, rest
        raise KeyError(
            f"'{write_path(self._path)}' has no entry '{label}' (entries are named by their name, their side, or "
            "their number from 0)"
        )


def make_table_class(block: Block) -> type[Table]:
    """The class of a block's tables, with a property for each key and block: help() and completion come with them."""

    def add(name: str, text: str) -> property:
        return property(lambda self: self[name], doc=text)  # written by Table.__setattr__

    members: dict[str, Any] = {"__doc__": block.describe(), "_block": block}
    members["_classes"] = {name: make_table_class(inner) for name, inner in block.blocks.items()}
    for name, key in block.keys.items():
        members[to_attribute(name)] = add(name, key.describe())
    for name, inner in block.blocks.items():
        members[to_attribute(name)] = add(name, f"{inner.header}: {inner.meaning}")
    class_name = "".join(part.capitalize() for part in block.key.split("_")) or "CaseTable"
    return type(class_name, (Table,), members)
