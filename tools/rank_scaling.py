#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Scaling over ranks: a bank in 3D with as many points for each rank, and one of a fixed size, on 1, 2 and 4 ranks.

Usage: tools/rank_scaling.py PROGRAM [--wet] [--points N] [--ranks R …]

PROGRAM is a build with -DTALUS_MPI=ON. Prints tables in Markdown: time of a step, fraction of it that rank 0 spends with messages (waiting for others included), bytes that it
sends in a step. More ranks than cores compete for the cores: their times are sums, not speeds. Ten minutes on two cores.
"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile

CASES = pathlib.Path(__file__).resolve().parent.parent / "tests" / "ranks"
DRY, WET = CASES / "block_3d.toml", CASES / "wet_bank_3d.toml"  # one bank, without and with pore water (Darcy formulation)
POINTS_OF_CASE = 41000 / 3  # for each metre of its thickness, in elements of 0.35 m
QUIET = ["--set", "output.history_interval=10", "--set", "output.frame_interval=0"]
DURATIONS = (0.1, 0.4)  # s; what a step takes is the difference, without what the run begins and ends with


def run(program, case, ranks, thickness, duration, scratch):
    folder = pathlib.Path(scratch) / f"{ranks}_{thickness:.3g}"
    line = [program, "run", str(case), "-o", str(folder), "-q", "--no-report", "--overwrite", "--set", f"geometry.thickness={thickness}",
            "--set", f"stage=[{{ name = 'let go', duration = {duration}, damping = 0.05 }}]", *QUIET]
    if ranks > 1:
        line = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), *line]
    else:
        line += ["--threads", "1"]
    subprocess.run(line, check=True, env={**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1"})
    summary = json.loads((folder / "summary.json").read_text())
    stage, work = summary["stages"][0], summary.get("ranks", {"bytes": 0, "seconds": 0})
    return summary["mesh"]["points"], [stage["steps"], stage["wall"], work["seconds"], work["bytes"]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--wet", action="store_true", help="with pore water (Darcy formulation)")
    parser.add_argument("--points", type=float, default=250000, help="points for each rank")
    parser.add_argument("--ranks", nargs="+", type=int, default=[1, 2, 4])
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    print(f"{os.cpu_count()} cores")
    with tempfile.TemporaryDirectory() as scratch:
        for title, share in (("as many points for each rank", True), ("the points of one rank", False)):
            print(f"\n{title}\n\n| ranks | points | steps | ms a step | of these with messages | kB sent a step |\n|--:|--:|--:|--:|--:|--:|")
            for ranks in options.ranks:
                thickness = options.points / POINTS_OF_CASE * (ranks if share else 1)
                (points, short), (_, long) = (run(program, WET if options.wet else DRY, ranks, thickness, d, scratch) for d in DURATIONS)
                steps, wall, seconds, sent = (b - a for a, b in zip(short, long))
                print(f"| {ranks} | {points} | {steps} | {1e3 * wall / steps:.1f} | {1e3 * seconds / steps:.1f} | {sent / steps / 1e3:.1f} |", flush=True)


if __name__ == "__main__":
    main()
