#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runout of a hillside on a weak bed after a storm, by MPM released from the timeline, and its dependence on the time of release and the mesh.

Usage: tools/verify_storm_runout.py PROGRAM [--sizes M …] [--jobs N] [--write]

The case is tests/data/storm_hillside.toml with the stages below. MPM is released at the time of failure with the adjacent times on both sides, when FEM
has no equilibrium, and after three days with a time two hours earlier. It starts from the stress of FEM without a holding stage; after
three days also from that of a level ground, with a holding stage until rest. --write stores the table in docs/verification_data/storm_runout.md. A quarter of an hour on two
cores. Ends with 1 where a run fails.
"""
import argparse
import concurrent.futures
import os
import pathlib
import sys
import tempfile

from published.runs import Runner

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "tests" / "data" / "storm_hillside.toml"
TABLE = ROOT / "docs" / "verification_data" / "storm_runout.md"
HOUR = 3600
STAGES = """
[timeline.release]

[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"

[[stage]]
name = "let go"
duration = 10
until = "rest"
damping = 0.05
smoothing = "stable"
reset_displacement = true
"""
HOLD = """
[[stage]]
name = "hold"
duration = 20
until = "rest"
water = "held"
geometry = "frozen"
damping = 0.75
"""
LATE = ['timeline.release.time="3 day"', 'timeline.release.apart="2 h"', "timeline.most_times=6"]
AT = {"of failure": [], "without equilibrium": ['timeline.release.criterion="equilibrium"'], "3 days": LATE, "3 days, held": LATE}


def make_case(when):
    held = when.endswith("held")
    stages = STAGES.replace("[[stage]]", HOLD.strip() + "\n[[stage]]") if held else STAGES
    text = CASE.read_text()
    text = text.replace("[initial]\n", f'[initial]\nstress = "{"k0" if held else "elements"}"\n', 1)
    text = text.replace('methods = ["lem"]', 'methods = ["lem", "mpm"]', 1)
    return text + stages


def write_page(rows):
    lines = ["# A hillside on a weak bed after a storm: how far it runs", "",
             "Made by `tools/verify_storm_runout.py build/release/bin/talus --write`, of `tests/data/storm_hillside.toml` with the stages of that program: three days of 5 mm/h. LEM or FEM determines the time of release; MPM starts from the water of that time "
             "and the stress of FEM, without a holding stage, and runs for 10 s or to rest. *Strength* is the factor of FEM on the strength that gives equilibrium. *Held*: MPM starts from the stress of a level ground instead, with a holding stage of 20 s or to rest; displacements count from the release.", "",
             "| elements | time | released after | F by LEM | strength | largest displacement | front | moved |", "|--:|---|--:|--:|--:|--:|--:|--:|"]
    for size, when, releases in rows:
        for r in sorted(releases, key=lambda r: r["time"]):
            factor = "–" if r["factor"] is None else f"{r['factor']:.4f}"
            strength = "–" if r["start_factor"] is None else f"{1 / r['start_factor']:.3f}"
            lines.append(f"| {size:g} m | {when} | {r['time'] / HOUR:.2f} h | {factor} | {strength} | "
                         f"{r['largest_displacement']:.4f} m | {r['mass_front_advance']:.3f} m | {r['moved_volume']:.0f} m³/m |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--sizes", nargs="+", type=float, default=(1.5, 1.05, 0.75), metavar="M")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--write", action="store_true", help=f"write {TABLE.relative_to(ROOT)}")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(os.path.abspath(options.program), pathlib.Path(scratch), keep=False)

        def follow(job):
            size, when = job
            summary = runner.run(f"{size:g}_{list(AT).index(when)}", make_case(when), [f"mesh.size={size:g}", *AT[when]])
            return size, when, summary["timeline"]["releases"]

        jobs = [(size, when) for size in sorted(options.sizes) for when in AT]
        with concurrent.futures.ThreadPoolExecutor(max(1, options.jobs)) as pool:
            rows = list(pool.map(follow, jobs))
    rows.sort(key=lambda row: (list(AT).index(row[1]), -row[0]))
    page = write_page(rows)
    print(page)
    if options.write:
        TABLE.write_text(page)
    return 1 if any(r["error"] for _, _, releases in rows for r in releases) else 0


if __name__ == "__main__":
    sys.exit(main())
