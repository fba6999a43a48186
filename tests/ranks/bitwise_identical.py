#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A case is bitwise identical on one and four ranks, one of them on two, and a checkpoint of four ranks resumes on one and on two.

Usage: bitwise_identical.py PROGRAM

Ends with 77 where there is no mpiexec, or no module of ranks beside the program. Compares histories, frames and the end of every run, byte by byte where
they contain only numbers.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import h5py
import numpy

CASES = pathlib.Path(__file__).resolve().parent
# Keys that depend on the clock, the machine or the division of memory.
OTHER = ("timing", "provenance", "input", "ranks")
faults = []


def start(program, ranks, case, folder, *more):
    line = [program, "run", str(case), "-o", str(folder), "-q", "--no-report", *more]
    if ranks > 1:
        line = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), *line]
    else:
        line += ["--threads", "1"]
    return subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            env={**os.environ, "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1"})


def run(*arguments):
    process = start(*arguments)
    out = process.communicate()[0]
    if process.returncode != 0:
        sys.exit(f"the run ended with {process.returncode}: {out}")


def kill_rank(starter, rank):
    """Ends one of the processes that mpiexec has started, which ends the others."""
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            parent = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            environment = (entry / "environ").read_bytes().split(b"\0")
        except (OSError, ValueError):
            continue
        if parent == starter.pid and f"OMPI_COMM_WORLD_RANK={rank}".encode() in environment:
            os.kill(int(entry.name), signal.SIGKILL)


def read_end(folder):
    """Fields of the points by their numbers, at the end and in every frame."""
    arrays = {}
    for path in sorted(folder.rglob("*.vtkhdf")):
        with h5py.File(path) as file:
            file.visititems(lambda name, item: arrays.__setitem__(f"{path.relative_to(folder)}/{name}", item[()]) if isinstance(item, h5py.Dataset) else None)
    return arrays


def clean(value):
    if isinstance(value, dict):
        return {k: clean(v) for k, v in value.items() if k not in OTHER and k != "wall" and not k.endswith(("seconds", "_per_second"))}
    return [clean(v) for v in value] if isinstance(value, list) else value


def compare(name, one, other):
    for path in [*one.rglob("*.csv"), *one.rglob("trial*.json"), *one.rglob("slip_line.json")]:
        table = path.relative_to(one)
        if not (other / table).exists() or path.read_bytes() != (other / table).read_bytes():
            faults.append(f"{name}: {table} differs, or is missing")
    a, b = (clean(json.loads((f / "summary.json").read_text())) for f in (one, other))
    for key in a:
        if a[key] != b.get(key):
            faults.append(f"{name}: '{key}' of summary.json differs: {str(a[key])[:200]} and {str(b.get(key))[:200]}")
    a, b = read_end(one), read_end(other)
    if a.keys() != b.keys() or not a:
        faults.append(f"{name}: the frames hold other fields, or none")
    for key in a.keys() & b.keys():
        if not numpy.array_equal(a[key], b[key], equal_nan=a[key].dtype.kind == "f"):
            faults.append(f"{name}: {key} differs")


def expect_fault(name, process, sentence, code=2):
    out = process.communicate()[0]
    if process.returncode != code or sentence not in out:
        faults.append(f"{name}: ended with {process.returncode} and said {out!r}, not {sentence!r}")


def check_faults(program, here):
    """Impossible requests end with one message, and nothing is written."""
    case = CASES / "slide.toml"
    expect_fault("folder", start(program, 2, case, here / "slide_1"), "is not empty", 3)
    expect_fault("study", subprocess.Popen(["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "2", program, "study", str(case)],
                                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True), "a study does not run on 2 ranks of MPI")
    # The same program but for the name of its source.
    other = here / "other"
    other.mkdir()
    shutil.copy(pathlib.Path(program).parent / "libtalus_ranks.so", other)
    commit = json.loads((here / "slide_1" / "summary.json").read_text())["provenance"]["commit"].encode()
    (other / "talus").write_bytes(pathlib.Path(program).read_bytes().replace(commit, b"x" * len(commit)))
    (other / "talus").chmod(0o755)
    line = ["run", str(case), "-o", str(here / "fault"), "-q"]
    expect_fault("another build", subprocess.Popen(
        ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "1", program, *line, ":", "-n", "1", str(other / "talus"), *line],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True), "runs another build of Talus")
    if (here / "fault").exists():
        faults.append("something was written before it was refused")


def main():
    program = os.path.abspath(sys.argv[1])
    if shutil.which("mpiexec") is None or not (pathlib.Path(program).parent / "libtalus_ranks.so").exists():
        print("SKIP: there is no mpiexec, or no module of ranks (tools/apt-packages-mpi.txt, then make program CMAKE_ARGS=-DTALUS_MPI=ON): one case on several ranks was NOT tried")
        return 77
    with tempfile.TemporaryDirectory() as scratch:
        here = pathlib.Path(scratch)
        for case in ("slide", "block_3d", "wet_bank", "wet_bank_3d", "reduction"):
            path = CASES / f"{case}.toml"
            run(program, 1, path, here / f"{case}_1")
            for ranks in (2, 4) if case == "slide" else (4,):
                run(program, ranks, path, here / f"{case}_{ranks}")
                compare(f"{case} on {ranks} ranks", here / f"{case}_1", here / f"{case}_{ranks}")
        for ranks in (1, 2):
            run(program, ranks, CASES / "release.toml", here / f"release_{ranks}")
        compare("points that a timeline releases, on more ranks than chunks", here / "release_1", here / "release_2")
        run(program, 2, CASES / "slide.toml", here / "slide_threads", "--threads", "2")
        compare("slide on 2 ranks with two threads each", here / "slide_1", here / "slide_threads")
        # A checkpoint is written at every look: a rank is killed as soon as there is one.
        often = ("--set", "output.checkpoint_interval=1e-6")
        for case, ranks in (("slide", 2), ("wet_bank_3d", 1)):
            path, folder = CASES / f"{case}.toml", here / f"{case}_resumed_on_{ranks}"
            process = start(program, 4, path, folder, *often)
            while process.poll() is None and not (folder / "checkpoint.h5").exists():
                try:
                    process.wait(timeout=0.01)
                except subprocess.TimeoutExpired:
                    pass
            kill_rank(process, 1)
            process.communicate()
            if (folder / "checkpoint.h5").exists():
                run(program, ranks, path, folder, *often, "--resume")
                compare(f"{case} on four ranks, one of them killed, resumed on {ranks}", here / f"{case}_1", folder)
            else:
                print(f"SKIP: the run ended before it was stopped: resumption on {ranks} was NOT tried")
        check_faults(program, here)
    print("\n".join(faults) if faults else "ranks: bitwise identical on 1, 2 and 4 ranks, and after a stop")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
