#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Proofs of limit analysis on random slopes, each verified by tools/verify_proof.py.

Usage: tools/verify_random_proofs.py PROGRAM [--count 200] [--only N …] [--out FOLDER] [--keep] [--jobs N] [--write] [--fields-only]

Numbers are those of tools/published/random_slopes.py: 1 and up as in tools/verify_referee.py, 1001 and up with one of its laws. Each slope runs by
limit equilibrium with its referee, and by limit analysis with the assumptions and the gap of the referee (tension up to the apex, fixed ends and base),
because the referee stores no fields. Both intervals have to overlap; the fields are evaluated against the case by other code. Without --only, --count
slopes of each kind run, with --fields-only without limit equilibrium and its referee. --write stores docs/verification_data/proofs.md. Ends with 1
where a bound is not proven, where both intervals do not overlap, or where a governing LEM factor lies outside.
"""
import pathlib
import statistics
import sys
import time

from published.campaign import judge_all, parse_options, show
from published.case_file import make_case
from published.problem import read_problem
from published.random_slopes import RIGOROUS, VARIED, describe, draw_any_slope
from published.runs import Broken
from proof.judge import judge_folder

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "verification_data" / "proofs.md"
POINTS, TOLERANCE = 4, 5e-4
JUDGING = 2e-3  # of a bound: LEM factors as near to it are not judged by it
FIXED = "\n" + "".join(f'[[boundary]]\non = "{side}"\nfix = "full"\n' for side in ("left", "right", "bottom"))
METHODS = 'analysis.methods=["lem","bounds"]', 'analysis.methods=["bounds"]'
SETTINGS = ["lem.referee=true", 'lem.methods=["bishop","spencer"]', "bounds.tension=apex", "bounds.gap=0.03",
            "bounds.triangles=2500"]


def find_governing(slices):
    """The smallest factor that the referee leaves, of methods that satisfy all of the equilibrium if there is one."""
    surfaces = [s for key in ("critical", "noncircular") for s in slices.get(key) or [] if s.get("factor")]
    possible = [s for s in surfaces if s.get("verdict", "possible") == "possible"]
    chosen = [s for s in possible if s["method"] in RIGOROUS] or possible
    return min((s["factor"] for s in chosen), default=None)


def judge_other_direction(runner, entry, text, bounds):
    """The file has the fields of one direction of an earthquake; the lower bound has to hold in the other one too."""
    name, side = entry["id"] + "_other", "left" if bounds["earthquake"]["direction"] > 0 else "right"
    other = runner.run(name, text, [METHODS[1], *SETTINGS, f"earthquake.direction={side}"])["bounds"]
    verdict = judge_folder(runner.get_folder(name), POINTS, TOLERANCE)
    if bounds.get("lower") and not (verdict.lower or 0) >= bounds["lower"] * (1 - TOLERANCE):
        verdict.status, verdict.word = 1, "NOT PROVEN"
        verdict.reasons.append(f"lower: the field of the other direction proves {show(other.get('lower'), '{:.4f}')}")
    return verdict


def judge(runner, number, methods):
    """A row: the slope, its interval, the governing factor, and what the verifier has confirmed."""
    entry = draw_any_slope(number)
    text = make_case(read_problem(entry), 50, search=True, noncircular=True, finite_elements=True) + FIXED
    row = {"slope": number, "what": describe(entry), "faults": [], "proof": "not run"}
    try:
        summary = runner.run(entry["id"], text, [methods, *SETTINGS])
    except Broken as fault:
        row["faults"].append(str(fault))
        return row
    folder = runner.get_folder(entry["id"])
    for name in ("report.html", "lem.json", "water.json"):
        (folder / name).unlink(missing_ok=True)
    bounds, slices = summary.get("bounds") or {}, summary.get("lem") or {}
    referee = slices.get("referee") or {}
    row |= {"lower": bounds.get("lower"), "upper": bounds.get("upper"), "seconds": bounds.get("seconds"), "lem": find_governing(slices),
            "why_not": referee.get("why_not")}
    if all((referee.get("lower"), referee.get("upper"), row["lower"], row["upper"])):
        row["same"] = abs(referee["lower"] / row["lower"] - 1) < 1e-6 and abs(referee["upper"] / row["upper"] - 1) < 1e-6
        if referee["lower"] > row["upper"] or referee["upper"] < row["lower"]:
            row["differs"] = f"referee {referee['lower']:.4f} to {referee['upper']:.4f}"
    if row["lower"] and row["upper"]:
        row["gap"] = 2 * (row["upper"] - row["lower"]) / (row["upper"] + row["lower"])
        row["inside"] = None if not row["lem"] or row["why_not"] else row["lower"] * (1 - JUDGING) <= row["lem"] <= row["upper"] * (1 + JUDGING)
        if row["inside"] is False:
            row["faults"].append(f"{row['lem']:.3f} governs")
    start = time.perf_counter()
    verdict = judge_folder(folder, POINTS, TOLERANCE)
    if verdict.word == "in part" and len(verdict.reasons) == 1 and bounds.get("earthquake"):
        verdict = judge_other_direction(runner, entry, text, bounds)
    row["proof"], row["notes"], row["verified"] = verdict.word, verdict.reasons, time.perf_counter() - start
    if verdict.status == 1:
        row["faults"].append("; ".join(verdict.reasons))
    print(f"{number}: {row['what']}: {show(row['lower'], '{:.4f}')} to {show(row['upper'], '{:.4f}')}, {row['proof']} {'; '.join(row['notes'])} "
          f"{row.get('differs', '')} {'; '.join(row['faults'])}", file=sys.stderr, flush=True)
    return row


def make_page(rows):
    judged = [r for r in rows if r.get("gap") is not None]
    confirmed = [r for r in rows if r["proof"] == "confirmed"]
    lem = [r for r in judged if r.get("inside") is not None]
    lines = ["# Proofs on random slopes", "",
             "Random slopes by `tools/verify_random_proofs.py PROGRAM --write`, with the assumptions of the referee. *Proof*: what `tools/verify_proof.py` has "
             "confirmed of the fields with the case, by code of its own. LEM: the governing factor, – where an end of the interval governs, or with "
             "`--fields-only`. Seconds: limit analysis, one thread, beside other work.", "",
             f"- Slopes: {len(rows)}; with an interval: {len(judged)}.",
             f"- Both bounds confirmed: {len(confirmed)}; not proven: {sum(r['proof'] == 'NOT PROVEN' for r in rows)}; "
             f"in part: {sum(r['proof'] == 'in part' for r in rows)}; not evaluated: {sum(r['proof'] == 'not evaluated' for r in rows)}.",
             f"- Intervals of the referee: {sum('same' in r for r in rows)}, the same {sum(r.get('same', False) for r in rows)}, "
             f"apart {sum('differs' in r for r in rows)}.",
             f"- Governing LEM factors outside by more than {100 * JUDGING:.1f} %: {sum(not r['inside'] for r in lem)} of {len(lem)}.",
             f"- Intervals wider than 3 %: {sum(r['gap'] > 0.0305 for r in judged)}."]
    if judged:
        lines.append(f"- Seconds: median {statistics.median(r['seconds'] for r in judged):.1f}, largest {max(r['seconds'] for r in judged):.1f}.")
    lines += ["", "| slope | content | bounds | gap | LEM | proof | seconds |", "|--:|---|---|--:|--:|---|--:|"]
    for r in rows:
        gap = "–" if r.get("gap") is None else f"{100 * r['gap']:.1f} %"
        notes = "; ".join(r.get("notes") or r["faults"] if r["proof"] != "confirmed" else [])
        lines.append(f"| {r['slope']} | {r['what']} | {show(r.get('lower'), '{:.3f}')} … {show(r.get('upper'), '{:.3f}')} | {gap} | "
                     f"{show(r.get('lem'), '{:.3f}')}{'' if r.get('inside') is not False else ' outside'} | {r['proof']}{': ' + notes if notes else ''}"
                     f"{'; ' + r['differs'] if r.get('differs') else ''} | {show(r.get('seconds'), '{:.1f}')} |")
    return "\n".join(lines) + "\n"


def main():
    methods = METHODS["--fields-only" in sys.argv]
    sys.argv = [word for word in sys.argv if word != "--fields-only"]
    options = parse_options(__doc__, 200, f"{PAGE.relative_to(ROOT)}")
    options.only = options.only or [n + base for base in (0, VARIED) for n in range(1, options.count + 1)]
    rows = judge_all(options, lambda runner, number: judge(runner, number, methods))
    page = make_page(rows)
    print(page)
    if options.write:
        PAGE.write_text(page, encoding="utf-8")
    return 1 if any(row["faults"] or "differs" in row for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
