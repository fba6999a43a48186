# SPDX-License-Identifier: MIT
"""Every key of a case as the library declares it, and the text about it. Nothing is declared a second time here."""

from __future__ import annotations

import functools
import keyword
from dataclasses import dataclass, field
from typing import Any

from . import _core


@dataclass(frozen=True)
class Key:
    """One key of a block."""

    name: str
    type: str
    meaning: str
    range: str
    default: str  #: TOML text; empty where there is none
    required: bool
    condition: str  #: the key has a meaning only with this; empty: always
    needed: bool  #: where the condition holds the key must be given
    words: list[list[str]]  #: of a choice: word and meaning

    def describe(self) -> str:
        """The key as in the manual."""
        facts = [self.type]
        if self.range:
            facts.append(self.range)
        if self.default:
            facts.append(f"default {self.default}")
        if self.required:
            facts.append("must be given")
        if self.condition:
            facts.append(f"{'must be given' if self.needed else 'only'} with {self.condition}")
        words = "".join(f'\n    "{word}": {meaning}' for word, meaning in self.words)
        return f"{self.meaning}\n    {'; '.join(facts)}{words}"


@dataclass(frozen=True)
class Block:
    """A table of keys, a list of tables, or a table whose names the user chooses (`named` tables, `entries` values)."""

    kind: str
    key: str
    header: str  #: [mesh], [[stage]], [materials.NAME]; empty for the whole case
    meaning: str
    keys: dict[str, Key] = field(default_factory=dict)
    blocks: dict[str, "Block"] = field(default_factory=dict)

    @property
    def names(self) -> list[str]:
        return [*self.keys, *self.blocks]

    def describe(self) -> str:
        """The block and all its keys as in the manual."""
        lines = [f"{self.header} {self.meaning}".strip(), ""]
        lines += [f"{name}: {key.describe()}" for name, key in self.keys.items()]
        lines += [f"{block.header}: {block.meaning}" for block in self.blocks.values()]
        return "\n".join(lines)


def make_block(data: dict[str, Any]) -> Block:
    """A block from the extension module's description."""
    keys = {key["name"]: Key(**key) for key in data["keys"]}
    blocks = {block["key"]: make_block(block) for block in data["blocks"]}
    return Block(data["kind"], data["key"], data["header"], data["meaning"], keys, blocks)


@functools.lru_cache(maxsize=None)
def get_root() -> Block:
    """The whole case."""
    return make_block(_core.get_catalogue())


def to_key(name: str) -> str:
    """`from_` stands for the key `from`, which Python does not allow as a name."""
    return name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name


def to_attribute(key: str) -> str:
    return key + "_" if keyword.iskeyword(key) else key


def describe(path: str = "") -> str:
    """What a key or a block means, its unit, range and default: describe("mesh.size"), describe("stage").

    Names of your choice and numbers of list entries may stand in the path or be left out.
    """
    block = get_root()
    steps = [step for step in path.split(".") if step]
    for i, step in enumerate(steps):
        step = to_key(step)
        if step in block.keys:
            return f"{path}: {block.keys[step].describe()}"
        if step in block.blocks:
            block = block.blocks[step]
        elif block.kind == "entries":
            return f"{path}: {block.keys['NAME'].describe()}"
        elif block.kind == "table" or i + 1 == len(steps):
            where = block.header or "a case"
            raise KeyError(f"there is no key '{path}'; {where} has {', '.join(block.names)}")
    return block.describe()
