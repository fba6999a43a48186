#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares Talus with published problems of slope stability and seepage, in one table.

Usage: tools/verify_published.py PROGRAM [--file problems.json] [--only ID|KIND …] [--out FOLDER] [--jobs N] [--fem]

Reads a file of the schema of tests/data/published/problems.json (its "meta" defines each key), writes a case
file for each problem, runs it, and compares factors, heads and discharges with the recomputed or published ones.
KIND is one of: slices, coupled, seepage, closed, others, fem, reduction. --fem also runs the strength reductions by
FEM (minutes). --out keeps the case files, the results, published.csv and published.md there. Ends with 1 on a miss.
"""
import argparse
import concurrent.futures
import fnmatch
import functools
import json
import os
import pathlib
import sys
import tempfile

from published import closed_forms, coupled, elements, others, reduction, seepage, slices
from published.runs import Runner
from published.table import MISS, NOTE, Row, count, make_markdown, make_summary, print_table, write_csv

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROBLEMS = ROOT / "tests" / "data" / "published" / "problems.json"
REASONS = PROBLEMS.with_name("reasons.json")  # why a row misses, where that is known


def collect_jobs(data, runner, options):
    """[(kind, id, function that gives rows)] of everything in the file."""
    lem = {entry["id"]: entry for entry in data.get("lem", [])}
    jobs = []

    def add(kind, entries, work):
        jobs.extend((kind, entry["id"], functools.partial(work, entry)) for entry in entries)

    add("slices", lem.values(), lambda e: slices.verify(runner, e, options.slices))
    add("coupled", data.get("coupled_seepage_to_stability", []), lambda e: coupled.verify(runner, e))
    add("seepage", data.get("seepage_steady", []), lambda e: seepage.verify(runner, e))
    add("closed", data.get("closed_form_checks", []), lambda e: closed_forms.verify(runner, e, lem))
    add("others", data.get("probabilistic", []), lambda e: others.find_sensitivities(runner, e, lem) + others.sample(runner, e, lem))
    for key in ("seepage_transient", "runout", "rapid_drawdown"):
        add("others", data.get(key, []), others.tell)
    if options.fem:
        with_elements = [e for e in lem.values() if "recomputed_fem_srm_bracket" in e]
        add("fem", with_elements, lambda e: elements.verify(runner, e, options.meshes))
        for name, values in (data.get("limit_analysis") or {}).items():
            if isinstance(values, dict) and "F_UB" in values:
                add("fem", [{"id": name}], lambda e, v=values: others.verify_limit(runner, e["id"], v, options.meshes))
        curves = [e for e in data.get("fem", []) if "my_fem" in e]
        add("fem", curves, lambda e: others.verify_curve(runner, e, lem, options.meshes[-1]))
        add("reduction", data.get("strength_reduction", []), lambda e: reduction.verify(runner, e, lem))
    add("others", [e for e in data.get("fem", []) if "my_fem" not in e], others.tell)
    return jobs


def choose(jobs, only):
    if not only:
        return jobs
    return [job for job in jobs if any(name == job[0] or fnmatch.fnmatch(job[1], name) for name in only)]


def run_job(job):
    kind, name, work = job
    try:
        rows = work()
    except Exception as fault:  # one bad problem must not hide the others
        rows = [Row(name, kind, "", None, None, "", MISS, None, f"{type(fault).__name__}: {fault}")]
    for row in rows:
        row.section = kind
    return rows


def add_reasons(rows):
    """The known reason of a miss behind what the run says."""
    known = json.loads(REASONS.read_text()) if REASONS.exists() else {}
    for row in rows:
        if row.verdict == MISS:
            reasons = known.get(row.problem, {})
            reason = reasons.get(row.method) or reasons.get(row.what)
            row.reason = "; ".join(filter(None, [row.reason, reason]))
            if (reason or "").startswith("impossible: "):  # the reference, which is then no bar
                row.verdict = NOTE


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--file", type=pathlib.Path, default=PROBLEMS)
    parser.add_argument("--only", nargs="+", default=[], metavar="ID|KIND")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=max(1, (os.cpu_count() or 2)))
    parser.add_argument("--fem", action="store_true")
    parser.add_argument("--meshes", type=int, nargs="+", default=[elements.COARSE, elements.FINE],
                        help="elements of the meshes for --fem, about; the last one is judged")
    parser.add_argument("--slices", type=int, default=100)
    parser.add_argument("--keep", action="store_true", help="take results that are in --out as they are")
    options = parser.parse_args()
    data = json.loads(options.file.read_text())
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.out or pathlib.Path(scratch)
        runner = Runner(os.path.abspath(options.program), folder / "runs", keep=options.keep)
        jobs = choose(collect_jobs(data, runner, options), options.only)
        with concurrent.futures.ThreadPoolExecutor(max(1, options.jobs)) as pool:
            rows = [row for part in pool.map(run_job, jobs) for row in part]
        add_reasons(rows)
        print_table(rows, sys.stdout)
        total = count(rows)
        print(", ".join(f"{n} {verdict}" for verdict, n in total.items()) + f"; {sum(runner.seconds.values()):.0f} s of runs")
        if options.out:
            write_csv(rows, options.out / "published.csv")
            (options.out / "published.md").write_text(make_markdown(rows))
        print(make_summary(rows))
    return 1 if total[MISS] else 0


if __name__ == "__main__":
    sys.exit(main())
