"""Runs a case, with progress, stop and resumption."""

from __future__ import annotations

import contextlib
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Optional, Union

from . import _core
from .case import Case
from .errors import Error, FolderExists, InputError
from .results import Results


@dataclass(frozen=True)
class Progress:
    """How far a run is. Trials that run side by side report in turn."""

    line: str  #: what the command line shows
    label: str  #: which of several trials or meshes, "[3 of 24]", "mesh 1 of 2: SRF 1.412"; empty in the case's stages
    stage: str  #: name of the stage or trial
    time: float  #: simulated time since its start [s]
    duration: float  #: its whole time, or the longest that it may take to rest [s]; 0: not known

    @property
    def fraction(self) -> Optional[float]:
        """Done of this stage or trial, 0 to 1; one that ends at rest may end earlier. None: not known."""
        return min(1.0, self.time / self.duration) if self.duration > 0 else None

    def __str__(self) -> str:
        return self.line


def run(
    case: Union[Case, str, os.PathLike[str]],
    folder: Union[str, os.PathLike[str]],
    *,
    threads: Optional[int] = None,
    resume: bool = False,
    overwrite: bool = False,
    progress: Optional[Callable[[Progress], object]] = None,
    report: bool = True,
) -> Results:
    """Calculates a case, or a case file, into `folder` as `talus run` does, and returns the results.

    threads: how many to use; by default all cores. Results do not depend on it.
    resume: go on with an interrupted run in the folder; a finished one is not run again.
    overwrite: replace results that are in the folder.
    progress: called with a Progress, at most five times a second, in the calling thread; the calculation goes on
        meanwhile. When it returns False or raises an exception, the state is saved and Interrupted is raised, with that
        exception as its cause; `resume=True` goes on from there.

    report: write `folder`/report.html at the end, also of a run that was stopped.

    Ctrl-C saves the state as well before KeyboardInterrupt is raised. One run at a time in a process.
    Raises InputError, FolderExists, Unstable, CannotWrite with the sentences of the command line.
    """
    if resume and overwrite:
        raise ValueError("resume and overwrite exclude each other")
    if threads is not None and threads < 1:
        raise ValueError(f"threads must be at least 1, not {threads}")
    if not isinstance(case, Case):
        case = Case.read(case)

    def pass_on(line: str, label: str, stage: str, time: float, duration: float) -> object:
        assert progress is not None
        return progress(Progress(line, label.strip(" :,"), stage, time, duration))

    loaded = case._load()
    results = Path(folder)
    try:
        _core.run(
            loaded,
            results,
            threads if threads is not None else _core.default_threads(),
            resume,
            overwrite,
            pass_on if progress is not None else None,
        )
    except (InputError, FolderExists):
        raise  # what lies there is of another run
    except BaseException:
        if report:
            with contextlib.suppress(Error):  # the first error is the one to tell
                _core.write_report(results)
        raise
    if report:
        _core.write_report(results)
    return Results(results)
