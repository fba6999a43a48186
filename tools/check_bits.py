#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that short cases are bitwise identical to their reference hashes: the numbers of every file, for one and for two threads.

Usage: tools/check_bits.py PROGRAM [--write] [--only NAME …]

tests/data/bits.json holds a hash of each file, for each instruction set and compiler; a build for one machine (-march=native) has that of
its processor. Words, names and the echo of the
case do not count, numbers do. Ends with 1 where a file differs, and with 77 where nothing is known of this level and compiler. --write
stores what came out; the new hash of all belongs in CHANGELOG.md, with what changed and why, or this command fails.
"""
import argparse
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py

import same_results

ROOT = pathlib.Path(__file__).resolve().parent.parent
STORED = ROOT / "tests" / "data" / "bits.json"
CASES = ["dry_slope", "layered_embankment", "storm_on_a_bank", "season_before_a_storm", "triaxial_loess", "triaxial_rooted_clay",
         "column_collapse", "sliding_block", "slope_3d", "banks", "wet_bank", "uncertain"]
# Keys on the input, the program and the machine, and texts.
LEFT_OUT = {"input", "input_hash", "program", "architecture", "level", "lane_width", "threads", "provenance", "jobs"}


def list_numbers(node, path):
    """Every number below a node of JSON, with its path."""
    if isinstance(node, dict):
        for key in sorted(node):
            if key not in LEFT_OUT:
                yield from list_numbers(node[key], f"{path}.{key}")
    elif isinstance(node, list):
        for i, entry in enumerate(node):
            yield from list_numbers(entry, f"{path}[{i}]")
    elif isinstance(node, (int, float)):
        yield f"{path} {node!r}"


def hash_hdf5(path):
    found = hashlib.sha256()

    def add(name, node):
        if name.rsplit("/", 1)[-1] in LEFT_OUT:
            return
        if isinstance(node, h5py.Dataset) and node.dtype.kind in "fiu":
            found.update(f"{name} {node.shape} {node.dtype}".encode())
            found.update(node[()].tobytes())

    with h5py.File(path) as file:
        file.visititems(add)
    return found


def hash_file(path):
    """The hash of the numbers of a file; None where it has none that count."""
    if path.suffix in (".vtkhdf", ".h5", ".hdf5"):
        return hash_hdf5(path).hexdigest()[:16]
    if path.suffix == ".json":
        text = "\n".join(list_numbers(same_results.strip(json.loads(path.read_text(encoding="utf-8"))), ""))
    elif path.suffix == ".csv":
        text = same_results.strip_csv(path.read_text(encoding="utf-8"))
    else:
        return None
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def run(program, name, threads):
    """File → hash of one run."""
    with tempfile.TemporaryDirectory() as work:
        out, done = same_results.start_case(program, name, pathlib.Path(work), threads)
        if done.returncode != 0:
            raise SystemExit(f"{name} ended with code {done.returncode}: {done.stderr}")
        hashes = {path.relative_to(out).as_posix(): hash_file(path) for path in sorted(out.rglob("*")) if path.is_file()}
    return {name: value for name, value in hashes.items() if value}


def find_differences(name, stored, found):
    for file in sorted(stored.keys() | found.keys()):
        if stored.get(file) != found.get(file):
            yield f"{name}: {file} " + ("is gone" if file not in found else "is new" if file not in stored else "has other numbers")


def find_place(program):
    """The level and compiler that the hashes depend on: "x86-64-v3, GNU 12.2.0", "native znver3 x86-64-v4, GNU 12.2.0"."""
    version = subprocess.run([program, "version"], check=True, capture_output=True, text=True).stdout
    _, compiler, _, architecture = version.partition("(")[2].rstrip(")\n").split(", ")
    if architecture.startswith("native"):
        told = subprocess.run(["g++", "-march=native", "-Q", "--help=target"], check=True, capture_output=True, text=True).stdout
        tuned = re.search(r"-march=\s+(\S+)", told)[1]
        architecture = f"native {tuned} {architecture.split(': ')[1]}"
    return f"{architecture}, {compiler}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--only", nargs="*", default=CASES)
    options = parser.parse_args()
    if options.write and options.only != CASES:
        parser.error("--write stores all cases")
    place = find_place(options.program)
    stored = json.loads(STORED.read_text(encoding="utf-8")) if STORED.exists() else {}
    if place not in stored and not options.write:
        print(f"SKIP: tests/data/bits.json knows {', '.join(stored)}, and not {place}: the bits were NOT compared")
        return 77
    cases, faults = {}, []
    for name in options.only:
        cases[name] = run(options.program, name, 1)
        faults += [f"2 threads, not 1: {line}" for line in find_differences(name, cases[name], run(options.program, name, 2))]
        if not options.write:
            faults += find_differences(name, stored[place]["cases"].get(name, {}), cases[name])
    if options.write and not faults:
        whole = hashlib.sha256(json.dumps(cases, sort_keys=True).encode()).hexdigest()[:16]
        stored[place] = {"hash": whole, "cases": cases}
        STORED.write_text(json.dumps(stored, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    if place in stored and stored[place]["hash"] not in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"):
        faults.append(f"CHANGELOG.md does not name the hash {stored[place]['hash']} of {place}, and why it changed")
    print("\n".join(faults) if faults else f"{len(cases)} cases have the bits of {place}: {stored[place]['hash']}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
