#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the centrifuge slope (examples/centrifuge_slope), fallow and rooted, and compares it with section 4.5.

Usage: tools/verify_centrifuge.py PROGRAM FOLDER [--runs FOLDER] [--threads N] [--variants]
Writes centrifuge_slope.csv, .md and .png to FOLDER and prints the tables. Misses are reported, and do not make the
program fail. --runs keeps the results of the runs there and takes finished ones as they are; --variants also runs
what changes one choice at a time. Needs python3 with numpy, h5py and matplotlib."""
import argparse
import csv
import os
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("agg")
matplotlib.rcParams.update({"font.size": 8, "legend.fontsize": 7})

from pictures import save_png  # noqa: E402
from centrifuge_checks.figure import draw  # noqa: E402
from centrifuge_checks.results import Results  # noqa: E402
from centrifuge_checks.table import compare, variants_table, write  # noqa: E402
from centrifuge_checks.variants import RUNS, VARIANTS  # noqa: E402

EXAMPLE = pathlib.Path(__file__).resolve().parent.parent / "examples" / "centrifuge_slope"


def run(program, case, target, settings, threads):
    """The finished run; None when it ended with an error."""
    command = [program, "run", str(EXAMPLE / case), "-o", str(target), "--threads", str(threads), "-q", "--overwrite",
               "--no-report"]
    shown = f"talus run examples/centrifuge_slope/{case}"
    for setting in settings:
        command += ["--set", setting]
        shown += f" --set '{setting}'" if " " in setting else f" --set {setting}"
    record = target / "command.txt"
    if not (record.exists() and record.read_text() == shown):
        if subprocess.run(command).returncode != 0:
            return None
        record.write_text(shown)
    return Results(target, shown)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--runs", type=pathlib.Path)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--variants", action="store_true")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    program = os.path.abspath(options.program)
    with tempfile.TemporaryDirectory() as scratch:
        runs = (options.runs or pathlib.Path(scratch)).resolve()
        runs.mkdir(parents=True, exist_ok=True)
        found = {}
        for name, case, settings in RUNS + (VARIANTS if options.variants else []):
            target = runs / "".join(c if c.isalnum() else "_" for c in name)
            found[name] = run(program, case, target, settings, options.threads)
            print(variants_table([(name, found[name])], heading=False), flush=True)
        if any(found[name] is None for name, _, _ in RUNS):
            return 1
        first = {name: found[name] for name, _, _ in RUNS}
        save_png(draw(first), options.folder / "centrifuge_slope.png", 80)
        rows = compare(found["fallow"], found["rooted"])
        rows += compare(found["fallow, K0 = 0.6"], found["rooted, K0 = 0.6"], ", K0 = 0.6")
        print("\n" + write(rows, found.items(), options.folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
