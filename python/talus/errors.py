# SPDX-License-Identifier: MIT
"""What can go wrong, with the sentences of the command line and its exit codes."""

from __future__ import annotations

from typing import NamedTuple, Sequence


class Finding(NamedTuple):
    """One fault of a case. `line` and `column` count from 1; 0 means that it has no place in the text."""

    file: str
    line: int
    column: int
    sentence: str
    is_unknown_key: bool = False  #: no case has a key of that name

    def __str__(self) -> str:
        if self.line > 0:
            return f"{self.file}:{self.line}:{self.column}: error: {self.sentence}"
        return f"{self.file}: error: {self.sentence}" if self.file else f"error: {self.sentence}"


class Error(Exception):
    """An error that is the user's to read. Its text is the sentence that the command line prints."""

    exit_code: int = 1  #: what the command line returns in this case


class InputError(Error):
    """The case, or what was asked for, is wrong; nothing was written."""

    exit_code = 2

    def __init__(self, text: str, findings: Sequence[Finding] = ()) -> None:
        super().__init__(text)
        self.findings: list[Finding] = list(findings)  #: all faults of the case at once

    def __reduce__(self) -> tuple[type, tuple[str, list[Finding]]]:
        return type(self), (str(self), self.findings)


class FolderExists(Error):
    """The folder for the results holds something already, or another run is using it; nothing was written."""

    exit_code = 3


class Unstable(Error):
    """The calculation became unstable; the last good state is saved."""

    exit_code = 4


class Interrupted(Error):
    """The run was stopped; its state is saved, and `resume=True` continues from it."""

    exit_code = 5


class CannotWrite(Error):
    """The disk is full or the folder is not writable; what was written before is complete."""

    exit_code = 6


class NotEnoughMemory(Error):
    """The machine has not enough memory; what was written before is complete."""

    exit_code = 7


def make_error(exit_code: int, text: str, findings: Sequence[tuple[str, int, int, str]] = ()) -> Error:
    """The exception that belongs to an exit code of the command line."""
    if exit_code == InputError.exit_code:
        return InputError(text, [Finding(*finding) for finding in findings])
    for kind in (FolderExists, Unstable, Interrupted, CannotWrite, NotEnoughMemory):
        if kind.exit_code == exit_code:
            return kind(text)
    return Error(text)


def make_input_error(findings: Sequence[Finding]) -> InputError:
    """One error for all findings, one a line."""
    return InputError("\n".join(str(finding) for finding in findings), findings)
