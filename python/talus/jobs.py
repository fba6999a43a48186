# SPDX-License-Identifier: MIT
"""The jobs of a study on the workers of an executor, which may be processes, MPI ranks or other machines."""

from __future__ import annotations

import concurrent.futures
import os
import threading
import time
from pathlib import Path
from typing import Any, Callable, Optional, Sequence, Union

from . import _core
from .errors import Error, Interrupted

#: A job whose worker was lost is given to another one so many times.
TRIES = 3

_turn = threading.Lock()


def calculate_job(folder: Union[str, os.PathLike[str]], job: int, threads: int = 1) -> None:
    """Calculates one job of the study that was prepared in `folder`, as `talus study FOLDER --job JOB` does.

    This is what workers are given: a name and two numbers. They need nothing else than this package and the folder.
    A job with failures has ended as well; the results name them. Jobs in threads of one process take turns."""
    with _turn:
        _core.calculate_job(Path(folder), job, threads)


class _Run:
    """Jobs under way."""

    def __init__(self, executor: concurrent.futures.Executor, folder: Path, threads: int) -> None:
        self.executor, self.folder, self.threads = executor, str(folder.absolute()), threads
        self.waiting: dict[concurrent.futures.Future[None], tuple[int, int]] = {}
        self.loss: Optional[BaseException] = None  #: what lost a job for good

    def submit(self, job: int, tries: int) -> None:
        try:
            future = self.executor.submit(calculate_job, self.folder, job, self.threads)
        except concurrent.futures.BrokenExecutor as error:
            self.loss = self.loss or error
        else:
            self.waiting[future] = (job, tries)

    def end(self, future: concurrent.futures.Future[None]) -> None:
        job, tries = self.waiting.pop(future)
        try:
            future.result()
        except (Error, concurrent.futures.BrokenExecutor) as error:
            self.loss = self.loss or error
        except Exception as error:  # of the executor: its worker was killed, say
            if tries < TRIES:
                self.submit(job, tries + 1)
            else:
                self.loss = self.loss or error


def calculate_jobs(
    executor: concurrent.futures.Executor,
    folder: Path,
    numbers: Sequence[int],
    threads: int,
    tell: Optional[Callable[[str], Any]],
) -> Optional[BaseException]:
    """Calculates the jobs with these numbers. `tell` hears how many are done; when it returns False or raises, no other
    job is begun and Interrupted is raised. Returns what lost a job, or None: `_core.list_jobs` lists the missing ones."""
    run, start, total = _Run(executor, folder, threads), time.monotonic(), len(numbers)
    try:
        for job in numbers:
            run.submit(job, 1)
        while run.waiting:
            ended, _ = concurrent.futures.wait(run.waiting, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in ended:
                run.end(future)
            if tell is not None:
                line = f"{total - len(run.waiting)} of {total} jobs ended after {time.monotonic() - start:.0f} s"
                _ask(tell, line)
    finally:
        for future in run.waiting:
            future.cancel()
    return run.loss


def _ask(tell: Callable[[str], Any], line: str) -> None:
    sentence = f"stopped: {line}; those that are calculated now end, and resume=True continues with the others"
    try:
        goes_on = tell(line) is not False
    except Exception as error:
        raise Interrupted(sentence) from error
    if not goes_on:
        raise Interrupted(sentence)
