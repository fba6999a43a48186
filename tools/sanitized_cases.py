#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs case files by a program with sanitizers, and lists what these find.

Usage: sanitized_cases.py PROGRAM [FOLDER …] [--seconds N] [--jobs N]

PROGRAM is that of the preset debug, or of another build with TALUS_SANITIZE=ON. Every case below examples/ and the given
folders is run, in the short form of same_results.py where it has one, for at most N seconds of processor time (30). Prints a
line for each: `whole`, `cut` at the limit, or `refused` with the message. Ends with 1 if a sanitizer found something.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile
import tomllib

import same_results

FINDING = re.compile(r"ERROR: AddressSanitizer|AddressSanitizer:DEADLYSIGNAL|runtime error:")
SETTINGS = {"ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=1", "OMP_NUM_THREADS": "1"}
SHORT = {}
for _command, _file, _overrides in same_results.CASES.values():
    SHORT.setdefault(same_results.ROOT / _file, (_command, _overrides))


def choose_command(path):
    """The command for a case file that same_results.py does not name."""
    try:
        data = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError):
        return "run"
    if "calibration" in data:
        return "calibrate"
    if "study" in data:
        return "study"
    return "point" if "test" in data and "geometry" not in data else "run"


def run(program, path, seconds):
    """The end of a run, and what a sanitizer said of it; empty: nothing."""
    command, overrides = SHORT.get(path) or (choose_command(path), [])
    with tempfile.TemporaryDirectory() as folder:
        ended = subprocess.run(
            [program, command, path, "-q", "-o", f"{folder}/results", *(word for given in overrides for word in ("--set", given))],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", cwd=path.parent, env={**os.environ, **SETTINGS},
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5)))
    found = FINDING.search(ended.stdout)
    if found:
        return "FOUND", ended.stdout[found.start():]
    if ended.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "cut", ""
    return ("whole" if ended.returncode == 0 else "refused: " + ended.stdout.strip().rpartition("\n")[2]), ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folders", nargs="*", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=30)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    chosen = parser.parse_args()
    paths = [path.resolve() for folder in (same_results.ROOT / "examples", *chosen.folders) for path in sorted(folder.rglob("*.toml"))]
    faults = 0
    with concurrent.futures.ThreadPoolExecutor(chosen.jobs) as pool:
        for path, (end, finding) in zip(paths, pool.map(lambda path: run(chosen.program.resolve(), path, chosen.seconds), paths)):
            print(f"{path}: {end}\n{finding}".rstrip("\n"), flush=True)
            faults += finding != ""
    print(f"{len(paths)} cases, {faults} with findings")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
