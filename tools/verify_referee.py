#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The referee on random slopes: intervals of limit analysis, the governing LEM factor, and the interval of FEM.

Usage: tools/verify_referee.py PROGRAM [--count 200] [--only N …] [--out FOLDER] [--jobs N] [--write]

Each random slope of tools/published/random_slopes.py (number N is always the same slope) runs by limit equilibrium with its referee and by finite
elements with ψ = φ on two meshes. Counted are governing factors outside the interval of limit analysis, the factors that would have governed without the
referee and lie outside, intervals wider than 3 %, FEM intervals that do not overlap it, printed factors
that fail a gate (λ, thrust line, tension), and governing factors within 5 % of FEM. tests/data/random_slopes.json has what is known
of those that stand out. --write stores docs/verification_data/referee.csv and .md. Ends with 1 where a governing factor lies outside or a gate failed.
"""
import csv
import pathlib
import statistics
import sys

from published.campaign import judge_all, parse_options, read_reasons
from published.case_file import make_case
from published.elements import choose_level, find_height
from published.problem import read_problem
from published.random_slopes import RIGOROUS, describe, draw_slope, find_gate_faults
from published.runs import Broken

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "docs" / "verification_data"
REASONS = ROOT / "tests" / "data" / "random_slopes.json"
ELEMENTS = 600  # of the coarser of two meshes, about
WIDEST = 0.03  # gap of an interval over its middle
AGREE = 0.05  # of the governing factor and that of FEM
ROUNDING = 1e-3  # bounds are compared as they are shown


def judge(runner, number):
    """A row: the slope, its interval of limit analysis, the governing factor, the one without the referee, the FEM factor."""
    entry = draw_slope(number)
    problem = read_problem(entry)
    size = round(0.7 * find_height(problem) / choose_level(problem, ELEMENTS), 6)
    text = make_case(problem, 50, search=True, noncircular=True, finite_elements=True)
    row = {"slope": number, "what": describe(entry), "faults": [], "misses": False}
    try:
        summary = runner.run(entry["id"], text, ['analysis.methods=["lem","fem"]', "lem.referee=true", "fem.flow=associated", f"fem.size={size}"])
    except Broken as fault:
        row["faults"].append(str(fault))
        return row
    slices = summary["lem"]
    referee = slices.get("referee") or {}
    row["lower"], row["upper"], row["seconds"] = referee.get("lower"), referee.get("upper"), referee.get("seconds")
    row["lem_seconds"] = slices.get("seconds")
    surfaces = [s for key in ("critical", "noncircular") for s in slices.get(key) or [] if s.get("factor")]
    rigorous = [s["factor"] for s in surfaces if s["method"] in RIGOROUS]
    possible = [s for s in surfaces if s.get("verdict", "possible") == "possible"]
    row["before"] = min(rigorous, default=None)
    row["faults"] += find_gate_faults(slices)
    chosen = [s for s in possible if s["method"] in RIGOROUS] or possible
    row["lem"] = min((s["factor"] for s in chosen), default=None)
    run = next((r for r in summary["fem"]["runs"] if r.get("factor")), {})
    row["fem"], interval = run.get("factor"), run.get("interval")
    row["fem_interval"] = [interval["lower"], interval["upper"]] if interval else None
    if row["lower"] and row["upper"]:
        row["gap"] = 2 * (row["upper"] - row["lower"]) / (row["upper"] + row["lower"])
        if row["lem"] and not row["lower"] - ROUNDING <= row["lem"] <= row["upper"] + ROUNDING:
            row["faults"].append(f"{row['lem']:.3f} governs")
        if interval := row["fem_interval"]:
            row["misses"] = interval[1] < row["lower"] or interval[0] > row["upper"]
    return row


def is_outside(row, widened):
    factor, lower, upper = row.get("before"), row.get("lower"), row.get("upper")
    return bool(factor and lower and upper) and not lower * (1 - widened) <= factor <= upper * (1 + widened)


def is_apart(row):
    return bool(row.get("lem") and row.get("fem")) and abs(row["lem"] / row["fem"] - 1) > AGREE


def write_number(value):
    return "–" if value is None else f"{value:.3f}"


def make_page(rows, reasons):
    judged = [r for r in rows if r.get("gap") is not None]
    wide = [r for r in judged if r["gap"] > WIDEST + 5e-4]
    own = [r for r in judged if r.get("lem")]
    lines = ["# The referee on random slopes", "",
             f"{len(rows)} slopes with layers, water, loads and earthquakes, drawn by `tools/verify_referee.py PROGRAM --count {len(rows)} --write`. "
             "*Without* is the smallest factor of Spencer and Morgenstern–Price, which would govern without the referee; *governs* is the one that does, "
             "– where the end of the interval governs. FEM: ψ = φ, two meshes, their interval. Seconds: one thread, beside other work.", "",
             f"- Governing factors outside the interval of limit analysis: {sum(bool(r['faults']) for r in judged)} of {len(judged)}.",
             f"- Without the referee: {sum(is_outside(r, 0) for r in judged)} of {len(judged)} outside, {sum(is_outside(r, 0.02) for r in judged)} outside the interval widened by 2 %.",
             f"- No LEM factor inside, so that the end of the interval governs: {len(judged) - len(own)}.",
             f"- Intervals wider than 3 %: {len(wide)}.",
             f"- FEM intervals that do not overlap it: {sum(r['misses'] for r in judged)}.",
             f"- No interval: {len(rows) - len(judged)}.",
             f"- Printed factors that fail a gate, or govern outside: {sum(len(r['faults']) for r in rows)}.",
             f"- Governing factor and FEM within {100 * AGREE:.0f} %: {len(own) - sum(map(is_apart, own))} of {len(own)}."]
    if judged:
        lines.append(f"- Seconds of the referee: median {statistics.median(r['seconds'] for r in judged):.1f}, largest {max(r['seconds'] for r in judged):.1f}; "
                     f"of the search: median {statistics.median(r['lem_seconds'] for r in judged):.1f}.")
    notes = [r for r in rows if r in wide or r["misses"] or is_apart(r)]
    lines += ["", "| outlier | reason |", "|--:|---|"]
    lines += [f"| {r['slope']}, {r['what']} | {reasons.get(str(r['slope']), 'not looked into')} |" for r in notes]
    lines += ["", "| slope | content | bounds | gap | without | governs | FEM | seconds |", "|--:|---|---|--:|--:|--:|---|--:|"]
    for r in rows:
        interval = f"{write_number(r.get('lower'))} … {write_number(r.get('upper'))}"
        gap = "–" if r.get("gap") is None else f"{100 * r['gap']:.1f} %"
        fem = write_number(r.get("fem"))
        if r.get("fem_interval"):
            fem += f" [{r['fem_interval'][0]:.3f}, {r['fem_interval'][1]:.3f}]"
        lines.append(f"| {r['slope']} | {r['what']} | {interval} | {gap} | {write_number(r.get('before'))} | {write_number(r.get('lem'))} | "
                     f"{fem}{' **misses**' if r['misses'] else ''} | {'–' if r.get('seconds') is None else round(r['seconds'], 1)} |")
    return "\n".join(lines) + "\n"


def main():
    options = parse_options(__doc__, 200, f"referee.csv and .md in {FOLDER.relative_to(ROOT)}")
    rows = judge_all(options, judge)
    page = make_page(rows, read_reasons(REASONS))
    print(page)
    for row in rows:
        for fault in row["faults"]:
            print(f"slope {row['slope']}: {fault}")
    if options.write:
        (FOLDER / "referee.md").write_text(page)
        with open(FOLDER / "referee.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, ["slope", "what", "lower", "upper", "gap", "before", "lem", "fem", "fem_interval", "misses", "seconds", "lem_seconds"],
                                    extrasaction="ignore")
            writer.writeheader()
            writer.writerows(rows)
    return 1 if any(row["faults"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
