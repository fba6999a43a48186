#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the vegetated slope (examples/vegetated_slope) and compares it with section 4.4 of the source, statement by
statement.

Usage: tools/verify_roots.py PROGRAM FOLDER [--only slope,choices,crutches|sizes] [--runs FOLDER [--finished]] [--threads N]
Writes vegetated_slope.csv and .md and pictures to FOLDER, or vegetated_sizes.csv and .md (Darcy formulation, elements of
four sizes, an hour and a half), and prints the tables. Differences from the source are
reported, and do not make the program fail. --runs keeps the results of the runs there and takes finished ones as they
are; with --finished it leaves out the choices that are not there. Needs python3 with numpy, h5py and matplotlib.
"""
import argparse
import os
import pathlib
import sys
import tempfile

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "talus", "font.size": 8, "legend.fontsize": 7})

from pictures import save_png  # noqa: E402
from roots_checks import figures, tables  # noqa: E402
from roots_checks.runs import Runner  # noqa: E402
from roots_checks.statements import find_all  # noqa: E402
from roots_checks.variants import CHOICES, CRUTCHES, PAIR, SIZES, SLOPES  # noqa: E402

THRESHOLD = 0.1  # output.onset_displacement of the case [m]


def run(runner, variant):
    found = {}
    for content, name, settings, case in variant.runs():
        found[content] = runner.run(name, settings, case)
        print(f"{name}: {'; '.join(tables.describe(found[content])) if found[content] else 'ended with an error'}", flush=True)
    return found


def run_all(runner, variants):
    """The runs of each variant, without those that are not finished where only these are read."""
    found = {v.name: run(runner, v) for v in variants}
    return {name: {c: r for c, r in runs.items() if r} for name, runs in found.items() if any(runs.values())}


def compare_sizes(runner, folder):
    found = {v.name: run(runner, v) for v in SIZES}
    text = tables.show_variants(found, "size, and length of what softens")
    (folder / "vegetated_sizes.md").write_text(tables.SIZES_HEADING + "\n" + text)
    tables.write_csv(folder / "vegetated_sizes.csv", found)
    print("\n" + text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", default="slope,choices,crutches")
    parser.add_argument("--runs", type=pathlib.Path)
    parser.add_argument("--finished", action="store_true", help="leave out what --runs does not have")
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    parts = options.only.split(",")

    def save(figure, name, **how):
        figure.savefig(options.folder / name, **how)

    with tempfile.TemporaryDirectory() as scratch:
        runs = (options.runs or pathlib.Path(scratch)).resolve()
        runs.mkdir(parents=True, exist_ok=True)
        runner = Runner(os.path.abspath(options.program), runs, options.threads, options.runs is not None, options.finished)
        if "sizes" in parts:
            compare_sizes(runner, options.folder)
            return 0
        slopes = run(runner, SLOPES)
        if None in slopes.values():
            return 1
        choices = run_all(runner, CHOICES) if "choices" in parts else {}
        crutches = {"5 MPa, β = 80 (the source)": {name: slopes[name] for name in PAIR}}
        crutches |= run_all(runner, CRUTCHES) if "crutches" in parts else {}
        longer = choices.get("rain for 1,200 s", {})
        statements = list(find_all(slopes, tuple(longer[name] for name in PAIR) if longer else None,
                                   choices.get("layer as conductive as the soil", {}).get("1.29 %"),
                                   choices.get("rain on the face itself", {}).get("bare")))
        save(figures.draw_histories(slopes, THRESHOLD), "vegetated_histories.svg", metadata={"Date": None})
        save(figures.draw_profiles(slopes), "vegetated_profiles.svg", metadata={"Date": None})
        save_png(figures.draw_strain(slopes), options.folder / "vegetated_strain.png", 90)
        text = [tables.show_statements(statements), tables.show_slopes(slopes), tables.show_thresholds(slopes)]
        if choices:
            text.append(tables.show_variants({"as the case has it": {name: slopes[name] for name in PAIR}} | choices))
        if "crutches" in parts:
            text.append(tables.show_variants(crutches, "water, mass scaling"))
            save(figures.draw_crutches(crutches), "vegetated_crutches.svg", metadata={"Date": None})
        (options.folder / "vegetated_slope.md").write_text(tables.HEADING + "\n" + "\n".join(text))
        tables.write_csv(options.folder / "vegetated_slope.csv",
                         {"the source's four": slopes} | choices | {k: v for k, v in list(crutches.items())[1:]})
        print("\n" + "\n".join(text))
    return 0


if __name__ == "__main__":
    sys.exit(main())
