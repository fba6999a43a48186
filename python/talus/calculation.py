# SPDX-License-Identifier: MIT
"""Runs a case or a study, with progress, stop and resumption."""

from __future__ import annotations

import concurrent.futures
import contextlib
import operator
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence, Union

from . import _core
from .case import Case
from .errors import Error, FolderExists, InputError
from .jobs import calculate_jobs
from .results import Results
from .studies import Study


@dataclass(frozen=True)
class Progress:
    """How far a run or a study is. Trials that run side by side report in turn."""

    line: str  #: what the command line shows
    label: str  #: which of several trials or meshes, "[3 of 24]", "mesh 1 of 2: SRF 1.412"; empty in the case's stages
    stage: str  #: name of the stage or trial; empty in a study
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
    device: str = "cpu",
) -> Results:
    """Calculates a case, or a case file, into `folder` as `talus run` does, and returns the results.

    threads: how many to use; by default all cores. Results do not depend on it.
    resume: resume an interrupted run in the folder; a finished one is not run again.
    overwrite: replace results that are in the folder.
    progress: called with a Progress, at most five times a second, in the calling thread, during the
        calculation. When it returns False or raises an exception, the state is saved and Interrupted is raised, with that
        exception as its cause; `resume=True` continues from there.
    report: write `folder`/report.html at the end, also of a run that was stopped.
    device: "cpu", "gpu" (the manual's "Calculate on a GPU" says what that needs) or "emulated", as --device has them.

    Ctrl-C saves the state as well before KeyboardInterrupt is raised. One run at a time in a process.
    Raises InputError, FolderExists, Unstable, CannotWrite with the sentences of the command line.
    """
    arguments = _check_arguments(folder, threads, resume, overwrite, progress)
    loaded = _get_case(case)._load()
    with _closing_report(arguments[0], report):
        _core.run(loaded, *arguments, device)
    return Results(arguments[0])


def study(
    case: Union[Case, str, os.PathLike[str]],
    folder: Union[str, os.PathLike[str]],
    vary: Optional[Mapping[str, Sequence[Any]]] = None,
    *,
    threads: Optional[int] = None,
    resume: bool = False,
    overwrite: bool = False,
    progress: Optional[Callable[[Progress], object]] = None,
    report: bool = True,
    executor: Optional[concurrent.futures.Executor] = None,
    jobs: Optional[int] = None,
) -> Study:
    """Calculates a case for every value that its [study] lists, into `folder` as `talus study` does.

    vary: keys and their values, {"mesh.size": [1.0, "150 cm"]}, instead of those that the case lists.
    threads: variants calculated side by side, each by one thread; by default all cores.
    resume: keep finished variants and resume interrupted ones.
    progress: called about ten times a second with a Progress whose `line` says how many variants are done; stops the
        study as `talus.run` is stopped.
    executor: a concurrent.futures.Executor whose workers calculate the study, job by job: processes, MPI ranks or other
        machines, all of which must see `folder`. `threads` are those of each job then, by default one. Progress is told
        when jobs end; when it stops the study, jobs under way come to their end. Jobs whose workers were lost are
        given to others if the executor continues. If it does not, Interrupted is raised: what has ended is kept, and
        `resume=True` with another executor calculates the rest, and repeats jobs with failures.
    jobs: how many; by default one for each run, or for a thousand samples by LEM.

    A variant that fails does not stop the others; when all have ended an Error says which failed and why, and
    `talus.Study(folder)` has the table and the results of those that finished. All else as for `talus.run`.
    """
    if jobs is not None and (executor is None or jobs < 1):
        raise ValueError("jobs must be at least 1, and belong to an executor")
    arguments = _check_arguments(folder, threads, resume, overwrite, progress)
    case = _get_case(case)
    if vary is not None:
        case = case.copy()
        case.study.vary = [dict(key=key, values=values) for key, values in vary.items()]
    loaded = case._load()
    with _closing_report(arguments[0], report):
        if executor is None:
            failure, cause = _core.study(loaded, *arguments), None
        else:
            failure, cause = _study_elsewhere(executor, loaded, arguments, threads or 1, jobs or 0)
    if failure is not None:
        raise failure from cause
    return Study(arguments[0])


def _study_elsewhere(
    executor: concurrent.futures.Executor, loaded: _core.LoadedCase, arguments: _Arguments, threads: int, count: int
) -> tuple[Optional[Exception], Optional[BaseException]]:
    """Prepares the jobs of a study, calculates those that have not ended or have failures, and collects. Returns the
    failure, and what of the executor caused it."""
    folder, _, resume, overwrite, pass_on = arguments
    own_threads = _core.default_threads()
    _core.prepare_jobs(loaded, folder, own_threads, resume, overwrite, count)
    _, missing, failed = _core.list_jobs(folder)
    tell = None if pass_on is None else lambda line: pass_on(line, "", "", 0.0, 0.0)
    cause = calculate_jobs(executor, folder, sorted(missing + failed), threads, tell)
    try:
        return _core.collect_jobs(folder, own_threads), cause
    except Error as error:
        raise error from cause


_Arguments = tuple[Path, int, bool, bool, Optional[Callable[[str, str, str, float, float], object]]]


#: As on the command line: the machine may refuse to start more.
_MOST_THREADS = 1024


def _check_arguments(
    folder: Union[str, os.PathLike[str]],
    threads: Optional[int],
    resume: bool,
    overwrite: bool,
    progress: Optional[Callable[[Progress], object]],
) -> _Arguments:
    """The arguments of the extension module's functions after the case."""
    if resume and overwrite:
        raise ValueError("resume and overwrite exclude each other")
    count = _core.default_threads() if threads is None else operator.index(threads)
    if count < 1:
        raise ValueError(f"threads must be at least 1, not {count}")
    if count > _MOST_THREADS:
        raise ValueError(f"threads must be at most {_MOST_THREADS}, not {count}")
    if progress is None:
        return Path(folder), count, resume, overwrite, None
    if not callable(progress):
        raise TypeError(f"progress must be a function of one argument, not {progress!r}")
    tell = progress

    def pass_on(line: str, label: str, stage: str, time: float, duration: float) -> object:
        return tell(Progress(line, label.strip(" :,"), stage, time, duration))

    return Path(folder), count, resume, overwrite, pass_on


def _get_case(case: Union[Case, str, os.PathLike[str]]) -> Case:
    return case if isinstance(case, Case) else Case.read(case)


@contextlib.contextmanager
def _closing_report(folder: Path, wanted: bool) -> Iterator[None]:
    """Writes the report at the end of what is done inside, also when it was stopped."""
    try:
        yield
    except (InputError, FolderExists):
        raise  # the files there belong to another run
    except BaseException:
        if wanted:
            with contextlib.suppress(Error):  # the first error is the one to report
                _core.write_report(folder)
        raise
    if wanted:
        _core.write_report(folder)
