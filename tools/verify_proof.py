#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the fields of a bounds.json prove, evaluated against the case by other code than the program's.

Usage: tools/verify_proof.py FOLDER … [--tolerance 5e-4] [--points 7]

FOLDER is a results folder with summary.json and bounds.json of `methods = ["bounds"]`. For the lower bound: equilibrium of each
triangle with the weights of the case, tractions across edges and on free sides, and the strength of the case at points inside.
For the upper bound: the work of weights, loads and pore pressures of the case, and its dissipation, at points inside; the flow rule;
the fixed sides; continuity. --points: points on a side of the lattice of each triangle.
Ends with 1 where a printed bound is not proven within the tolerance, with 2 where a part of the case was not evaluated, which it names.
Formulas: docs/theory/21-proven-bounds.md. Stress is positive in tension, pore pressure in compression; SI units.
"""
import argparse
import pathlib
import sys

from proof.judge import judge_folder


def verify(folder, points, tolerance):
    """Prints the row of a folder; returns the exit status."""
    found = judge_folder(folder, points, tolerance)
    reasons = "; ".join(found.reasons)
    print(f"{folder}: {found.text}" if found.status < 2 else f"{'PART' if found.word == 'in part' else 'SKIP'}: {folder}: {found.word}: {reasons}"
          + (f" ({found.text})" if found.text else ""), flush=True)
    return found.status


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=7)
    parser.add_argument("--tolerance", type=float, default=5e-4)
    args = parser.parse_args()
    found = [verify(folder, args.points, args.tolerance) for folder in args.folders]
    sys.exit(1 if 1 in found else 2 if 2 in found else 0)


if __name__ == "__main__":
    main()
