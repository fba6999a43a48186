#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the verification problems of coupled water (examples/verification) and compares them with their closed forms.

Usage: tools/verify_water.py PROGRAM FOLDER [--only NAME,...] [--runs FOLDER] [--threads N]
Writes water.csv, water.md and one SVG for each problem to FOLDER, prints the table, and ends with 1 when a number is
outside its band, known misses excepted. --runs keeps the results of the runs there and takes finished ones as they are. Needs python3 with
numpy, h5py and matplotlib.
"""
import argparse
import csv
import importlib
import os
import pathlib
import sys
import tempfile

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "talus", "font.size": 9, "legend.fontsize": 8})
import matplotlib.pyplot as plt  # noqa: E402

from pictures import save_svg  # noqa: E402
from water_checks.runs import Runner  # noqa: E402

PROBLEMS = ("wave", "terzaghi", "still", "infiltration", "drainage", "corner", "dam", "seeping", "poroelastic")


def draw(count):
    figure, axes = plt.subplots(1, count, figsize=(4.6 * count, 3.4), layout="constrained")
    return figure, axes


def show(value, unit):
    return f"{value:.4g} {unit}".rstrip()


HEADING = """# Coupled water: every number

Written by `tools/verify_water.py PROGRAM FOLDER`. The results are discussed in [the summary](water_summary.md).
Times are processor times of one thread of the machine it ran on.
"""


def describe_run(run):
    if run is None:  # it broke
        return [""] * 5
    return [f"{run.step:.4g}", run.steps, run.points, f"{run.seconds:.1f}", f"{run.rate:.3g}"]


def write_tables(rows, target, figures):
    with open(target / "water.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["problem", "quantity", "computed", "exact", "difference", "bound", "unit", "passes", "time step [s]",
                      "steps", "points", "processor time [s]", "point-steps per second", "note", "command"])
        for r in rows:
            out.writerow([r.problem, r.quantity, f"{r.computed:.7g}", f"{r.exact:.7g}", f"{r.computed - r.exact:.3g}",
                          f"{r.bound:.3g}", r.unit, r.passes, *describe_run(r.run), r.note, r.run.command if r.run else ""])
    lines = ["| problem | quantity | computed | exact or published | difference | bound | |", "|---|---|---|---|---|---|---|"]
    last = None
    for r in rows:
        difference = f"{100 * (r.computed / r.exact - 1):+.2f} %" if r.exact else show(r.computed, r.unit)
        bound = f"{100 * r.bound / abs(r.exact):.2g} %" if r.exact else show(r.bound, r.unit)
        verdict = ("pass" if r.passes else "**miss**") + (f": {r.note}" if r.note else "")
        lines.append(f"| {r.problem if r.problem != last else ''} | {r.quantity} | {show(r.computed, r.unit)} | "
                     f"{show(r.exact, r.unit)} | {difference} | {bound} | {verdict} |")
        last = r.problem
    lines += ["", "| run | time step | steps | points | processor time [s] | point-steps per second | command |", "|---|---|---|---|---|---|---|"]
    for run in {r.run.command: r.run for r in rows if r.run}.values():
        lines.append(f"| {run.folder.name} | {run.step:.3g} s | {run.steps} | {run.points} | {run.seconds:.1f} | {run.rate:.2g} | "
                     f"`{run.command}` |")
    text = "\n".join(lines) + "\n"
    pictures = "".join(f"\n![{name}](water_{name}.svg)\n" for name in figures)
    (target / "water.md").write_text(f"{HEADING}\n{text}{pictures}")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", default=",".join(PROBLEMS))
    parser.add_argument("--runs", type=pathlib.Path)
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        runs = options.runs or pathlib.Path(scratch)
        runs.mkdir(parents=True, exist_ok=True)
        runner = Runner(os.path.abspath(options.program), runs.resolve(), options.threads, options.runs is not None)
        for name in options.only.split(","):
            found, figure = importlib.import_module(f"water_checks.{name}").check(runner, draw)
            save_svg(figure, options.folder / f"water_{name}.svg")
            plt.close(figure)
            rows += found
            for r in found:
                print(f"{'pass' if r.passes else 'MISS'}  {r.problem}: {r.quantity}: {show(r.computed, r.unit)} "
                      f"({show(r.exact, r.unit)} ± {show(r.bound, r.unit)})", flush=True)
    print("\n" + write_tables(rows, options.folder, options.only.split(",")))
    return 0 if all(r.passes or r.known_miss for r in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
