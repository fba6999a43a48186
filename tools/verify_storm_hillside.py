#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How the factor of safety in time converges with the mesh and with the steps of the water: a hillside on a weak bed in a storm.

Usage: tools/verify_storm_hillside.py PROGRAM [--sizes M …] [--stepped WORDS=PROGRAM …] [--jobs N] [--out FOLDER] [--write]

The case is tests/data/storm_hillside.toml. For each size of the elements: the factor after 0, 1, 2 and 3 days, the time of failure, and the factor on one
surface, that which governs after 3 days in elements of 1.5 m, so that searches play no part. The step of the water has no key: --stepped gives programs built with
another tolerance (`head_tolerance` of src/site/season.hpp) or another first step, and what to call them; they run in elements of 1.5 m. --write stores the tables
in docs/verification_data/storm_hillside.md. --out keeps cases and results, and finished runs found there are taken. A quarter of an hour on two cores.
Ends with 1 where a factor of the finest mesh differs from that of 1.5 m by more than 1 %.
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
TABLE = ROOT / "docs" / "verification_data" / "storm_hillside.md"
SIZES = (3, 2.1, 1.5, 1.05, 0.75)
USUAL = 1.5  # [m]
AGREE = 0.01
DAYS = 'timeline.times=["1 day", "2 day", "3 day"]'
HOUR = 3600
USUAL_STEPS = "the program: tolerance of 0.01 m, first step a thousandth of the first time"


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--sizes", nargs="+", type=float, default=SIZES, metavar="M")
    parser.add_argument("--stepped", nargs="+", default=[], metavar="WORDS=PROGRAM")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--write", action="store_true", help=f"write {TABLE.relative_to(ROOT)}")
    return parser.parse_args()


def list_factors(summary):
    return [f["factor"] for f in summary["timeline"]["factors"]]


def say_failure(timeline):
    """Between which times, and with the scatter of searches."""
    if timeline["fails_from_start"]:
        return "from the start"
    failure = timeline["failure"]
    if failure is None:
        return "none"
    late = "–" if failure["latest"] is None else f"{failure['latest'] / HOUR:.1f}"
    return f"{failure['from'] / HOUR:.1f} to {failure['to'] / HOUR:.1f} h ({failure['earliest'] / HOUR:.1f} to {late} h)"


def hold_surface(text, points):
    """The case with one surface in place of the search."""
    corners = ", ".join(f"[{x:.9g}, {y:.9g}]" for x, y in points)
    return text.replace("[lem]\n", '[lem]\nsearch = "none"\n', 1) + f'\n[[lem.surface]]\nname = "held"\npoints = [{corners}]\n'


def measure(runners, options):
    text = CASE.read_text()
    usual = runners[""]
    summary = usual.run(f"days_{USUAL:g}", text, [f"mesh.size={USUAL:g}", DAYS])
    held = hold_surface(text, summary["timeline"]["factors"][-1]["surface"]["points"])

    def follow(size):
        set_size = f"mesh.size={size:g}"
        days = usual.run(f"days_{size:g}", text, [set_size, DAYS])
        chosen = usual.run(f"chosen_{size:g}", text, [set_size])
        fixed = usual.run(f"held_{size:g}", held, [set_size, DAYS])
        return {"size": size, "searched": list_factors(days), "held": list_factors(fixed),
                "failure": say_failure(chosen["timeline"]), "steps": chosen["timeline"]["weather"]["steps"],
                "error": chosen["timeline"]["weather"]["error"]}

    def step(words):
        fixed = runners[words].run("held", held, [f"mesh.size={USUAL:g}", DAYS])
        return {"words": words or USUAL_STEPS, "held": list_factors(fixed), "steps": fixed["timeline"]["weather"]["steps"]}

    with concurrent.futures.ThreadPoolExecutor(max(1, options.jobs)) as pool:
        sizes = list(pool.map(follow, options.sizes))
        steps = list(pool.map(step, runners))
    return sizes, steps


def show(values):
    return " | ".join("–" if v is None else f"{v:.4f}" for v in values)


def write_page(sizes, steps):
    lines = ["# A hillside on a weak bed in a storm: mesh and steps", "",
             "Made by `tools/verify_storm_hillside.py build/release/bin/talus --write`, of `tests/data/storm_hillside.toml`: three days of 5 mm/h, Spencer's polylines.", "",
             "The factor found by searches, and the time of failure; in brackets with the scatter of searches, 0.3 %:", "",
             "| elements | 0 | 1 day | 2 days | 3 days | falls below 1 | steps of the water | water balance error |",
             "|--:|--:|--:|--:|--:|---|--:|--:|"]
    for row in sizes:
        lines.append(f"| {row['size']:g} m | {show(row['searched'])} | {row['failure']} | {row['steps']} | {abs(row['error']):.0e} |")
    lines += ["", f"The same on one surface, that which governs after 3 days in elements of {USUAL:g} m, without a search:", "",
              "| elements | 0 | 1 day | 2 days | 3 days |", "|--:|--:|--:|--:|--:|"]
    lines += [f"| {row['size']:g} m | {show(row['held'])} |" for row in sizes]
    if len(steps) > 1:
        lines += ["", f"That surface in elements of {USUAL:g} m, with other steps of the water (programs built with these constants, `--stepped`):", "",
                  "| steps | 0 | 1 day | 2 days | 3 days | number of them |", "|---|--:|--:|--:|--:|--:|"]
        lines += [f"| {row['words']} | {show(row['held'])} | {row['steps']} |" for row in steps]
    return "\n".join(lines) + "\n"


def find_difference(sizes):
    """The largest between the finest mesh and the usual one, over the factor."""
    usual = next((row for row in sizes if row["size"] == USUAL), None)
    finest = min(sizes, key=lambda row: row["size"])
    if usual is None:
        return 0
    return max(abs(a / b - 1) for key in ("searched", "held") for a, b in zip(usual[key], finest[key]))


def main():
    options = parse_options()
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.out or pathlib.Path(scratch)
        programs = {"": options.program} | dict(words.rsplit("=", 1) for words in options.stepped)
        runners = {words: Runner(os.path.abspath(program), folder / (words.replace(" ", "_") or "usual"), keep=bool(options.out))
                   for words, program in programs.items()}
        sizes, steps = measure(runners, options)
    page = write_page(sizes, steps)
    print(page)
    if options.write:
        TABLE.write_text(page)
    difference = find_difference(sizes)
    print(f"finest mesh against {USUAL:g} m: {difference:.2%} at most")
    return 1 if difference > AGREE else 0


if __name__ == "__main__":
    sys.exit(main())
