#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does the search for the critical polyline find one minimum, wherever it begins?

Usage: tools/verify_search.py PROGRAM [--starts 20] [--out FOLDER] [--jobs N]

Runs every published problem with a non-circular search (tests/data/published/problems.json), and a weak bed under a storm
(tests/data/misleading/bedding_storm.toml), with seeds 1 to --starts, and seed 0, the default, by Spencer and by Morgenstern and Price. Prints a table: the smallest and the
largest factor over the seeds, their scatter, and how far seed 0 lies above the smallest. Writes it to docs/verification_data/search.md with
--write. Ends with 1 where a published problem scatters by more than 0.2 %.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import sys
import tempfile

from published.case_file import make_case
from published.problem import read_problem
from published.runs import Runner

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "docs" / "verification_data" / "search.md"
RIGOROUS = ("spencer", "morgenstern_price")
MOST_SCATTER = 0.002
SLICES = 50
STORM = "bedding_storm"


def collect_cases():
    """{name: text of the case} of what is searched along polylines."""
    problems = json.loads((ROOT / "tests" / "data" / "published" / "problems.json").read_text())["lem"]
    cases = {e["id"]: make_case(read_problem(e), SLICES, search=True, noncircular=True) for e in problems
             if (e.get("recomputed") or {}).get("noncircular_search")}
    cases[STORM] = (ROOT / "tests" / "data" / "misleading" / "bedding_storm.toml").read_text()
    return cases


def read_polylines(summary):
    """{method: factor} of the critical polylines."""
    return {r["method"]: r["factor"] for r in summary["lem"].get("noncircular") or [] if r.get("factor")}


def make_rows(name, by_seed):
    """A row per method: problem, method, smallest, largest, scatter, seed 0 above the smallest; factors without a solution are counted."""
    rows = []
    for method in sorted({m for factors in by_seed.values() for m in factors}):
        factors = [f[method] for seed, f in by_seed.items() if seed > 0 and method in f]
        if not factors:
            continue
        least, most, default = min(factors), max(factors), by_seed[0].get(method)
        rows.append({"problem": name, "method": method, "found": len(factors), "least": least, "most": most,
                     "scatter": most / least - 1, "default": default / least - 1 if default else None})
    return rows


def write_table(rows, starts):
    lines = ["# One minimum, wherever the search begins", "",
             f"The critical polyline by {starts} random starts (`[lem] seed = 1 … {starts}`) and by the default (seed 0). "
             "Scatter: the largest over the smallest factor. Made by `tools/verify_search.py build/release/bin/talus --write`.", "",
             "| problem | method | starts that found one | smallest | largest | scatter | the default above the smallest |",
             "|---|---|--:|--:|--:|--:|--:|"]
    for r in rows:
        default = "no factor" if r["default"] is None else f"{100 * r['default']:.2f} %"
        lines.append(f"| {r['problem']} | {r['method']} | {r['found']} of {starts} | {r['least']:.4f} | {r['most']:.4f} | "
                     f"{100 * r['scatter']:.2f} % | {default} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--starts", type=int, default=20)
    parser.add_argument("--only", nargs="+", default=[], metavar="PROBLEM")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--write", action="store_true", help=f"write {TABLE.relative_to(ROOT)}")
    options = parser.parse_args()
    cases = {name: text for name, text in collect_cases().items() if not options.only or name in options.only}
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(os.path.abspath(options.program), options.out or pathlib.Path(scratch))

        def run(job):
            name, seed = job
            return job, read_polylines(runner.run(f"{name}={seed}", cases[name], [f"lem.seed={seed}", f"lem.methods={json.dumps(RIGOROUS)}"]))

        with concurrent.futures.ThreadPoolExecutor(max(1, options.jobs)) as pool:
            found = dict(pool.map(run, [(name, seed) for name in cases for seed in range(options.starts + 1)]))
    rows = [row for name in cases
            for row in make_rows(name, {seed: found[(name, seed)] for seed in range(options.starts + 1)})]
    table = write_table(rows, options.starts)
    print(table)
    if options.write:
        TABLE.write_text(table)
    wide = [r for r in rows if r["problem"] != STORM and r["scatter"] > MOST_SCATTER]
    for r in wide:
        print(f"{r['problem']} {r['method']}: scatter {100 * r['scatter']:.2f} %", file=sys.stderr)
    return 1 if wide else 0


if __name__ == "__main__":
    sys.exit(main())
