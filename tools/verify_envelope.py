#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the three slopes of the source over the choices that it leaves open, and says which of its statements hold together.

Usage: tools/verify_envelope.py PROGRAM FOLDER [--only unsaturated|vegetated|centrifuge] [--samples N] [--runs FOLDER] [--evaluate]
                                [--sensitivity] [--meshes]
Draws a Latin hypercube (200, 100 and 60 samples; 200, 400 and 120 runs; a run of the last takes minutes) and runs it as a study of the program, which resumes.
Writes envelope_<slope>.csv and .md to FOLDER and prints the tables. --runs keeps the studies there: envelope_<slope>.toml and runs_<slope>.
--evaluate starts nothing and evaluates the samples that have finished; --sensitivity also runs the unsaturated slope with one numerical
parameter changed, for the ten samples nearest to the printed factor; --meshes also runs the most central sample with the other mesh
generators. Misses are reported, and do not make the program fail.
Needs python3 with numpy and h5py.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

from envelope.design import SLOPES, make_study, write_design
from envelope.evaluation import Evaluation
from envelope.page import make_page


def run_study(program, file, target, rows, slope):
    """Runs the rows as a study into the folder `target`; finished runs of an earlier call are taken as they are."""
    file.write_text(make_study(slope, rows))
    command = [program, "study", str(file), "-o", str(target), "--threads", "2", "--no-report"]
    return subprocess.run(command + (["--resume"] if target.exists() else [])).returncode


def run_extra(program, runs, evaluation, evaluate):
    """Further runs of the samples nearest to the printed factor, and their statements."""
    values = dict(zip((s.number for s in evaluation.finished), evaluation.get_values("U4")))
    samples = evaluation.module.select_nearest(values)
    if not evaluate:
        rows = evaluation.module.list_extra_rows(evaluation.slope, [s.choices for s in evaluation.samples], samples)
        run_study(program, runs / f"extra_{evaluation.name}.toml", runs / f"extra_{evaluation.name}", rows, evaluation.slope)
    evaluation.read_extra(runs, samples)
    print(f"{evaluation.name}: sensitivities of {len(evaluation.extra)} of {len(samples)} samples")


def run_meshes(program, runs, evaluation, evaluate):
    """The most central sample with the other mesh generators."""
    central = evaluation.choose_central()
    if central and not evaluate:
        name, sample = evaluation.get_meshes_name(), central[2]
        run_study(program, runs / f"{name}.toml", runs / name, evaluation.slope.list_mesh_rows(sample.number, sample.choices),
                  evaluation.slope)
    evaluation.read_meshes(runs)


def verify(program, folder, runs, name, options):
    slope = SLOPES[name]
    design = slope.draw(options.samples)
    if not options.evaluate:
        write_design(runs / f"envelope_{name}.csv", slope.factors, design)
        run_study(program, runs / f"envelope_{name}.toml", runs / f"runs_{name}", slope.list_rows(design), slope)
    evaluation = Evaluation(name, slope, design)
    evaluation.read(runs / f"runs_{name}")
    print(f"{name}: {len(evaluation.finished)} of {len(design)} samples have finished", flush=True)
    if name == "unsaturated" and (options.sensitivity or options.evaluate):
        run_extra(program, runs, evaluation, options.evaluate)
    if options.meshes or options.evaluate:
        run_meshes(program, runs, evaluation, options.evaluate)
    text = make_page(evaluation)
    evaluation.write_csv(folder / f"envelope_{name}.csv")
    (folder / f"envelope_{name}.md").write_text(text)
    print("\n" + text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", choices=SLOPES, default=list(SLOPES))
    parser.add_argument("--samples", type=int)
    parser.add_argument("--runs", type=pathlib.Path)
    parser.add_argument("--evaluate", action="store_true")
    parser.add_argument("--sensitivity", action="store_true")
    parser.add_argument("--meshes", action="store_true")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        runs = (options.runs or pathlib.Path(scratch)).resolve()
        runs.mkdir(parents=True, exist_ok=True)
        for name in options.only:
            verify(os.path.abspath(options.program), options.folder, runs, name, options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
