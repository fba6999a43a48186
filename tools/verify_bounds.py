#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares LEM and FEM with the lower and upper bounds of limit analysis, on every published slope and on closed forms, in one table.

Usage: tools/verify_bounds.py PROGRAM [--file problems.json] [--only ID …] [--gap G] [--triangles N] [--jobs N] [--out FOLDER] [--wet] [--write]

Each slope of tests/data/published/problems.json runs by LEM, by FEM on two meshes and by limit analysis, with ψ = φ and no
limit of tension below the apex, as LEM assumes. Closed forms run by limit analysis alone. --write stores the table in docs/verification_data/bounds.md.
--wet runs limit analysis alone on the slopes with water, loads or an earthquake, with tension up to the apex and without any, and writes
bounds_wet.md. --out keeps cases and results. Ends with 1 where a closed form lies outside its interval, or a slope has no interval.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import sys
import tempfile

from published.case_file import make_case
from published.elements import COARSE, choose_level, find_height
from published.problem import read_problem
from published.runs import Broken, Runner

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROBLEMS = ROOT / "tests" / "data" / "published" / "problems.json"
TABLE = ROOT / "docs" / "verification_data" / "bounds.md"
WET_TABLE = TABLE.with_name("bounds_wet.md")
WET = ("ACADS-1d ACADS-3a ACADS-3b ACADS-4 AT-3 FK-3 FK-4 FK-5 FK-6 SP-69 ZHU-51 DW-70a DW-70b DW-71b GL-5-LH-0.2 GL-5-LH0.0 GL-5-LH0.2 GL-5-LH0.5 GL-5-LH0.7 "
       "GL-5-LH1.0 GL-6-wet").split()
KINDS = ("circle", "polyline", "elements")
#: Reasons for LEM factors outside the bounds that the numbers alone do not explain.
REASONS = {
    **dict.fromkeys(("ACADS-1d", "DW-71b", "GL-4-0.6", "GL-4-1.0"), "the weakest surface is no circle"),
    **dict.fromkeys(("ACADS-3a", "ACADS-3b", "ACADS-4"), "no circle follows the weak seam"),
    **dict.fromkeys(("ACADS-2a", "ACADS-2b"), "LEM searched the upstream face; the downstream face is weaker, tan 45°/tan β = 1.669"),
    "ACADS-1b": "LEM has a tension crack, limit analysis has none",
    "LOW-1": "Spencer's method has spurious branches; Bishop's 1.148 and the published 1.17 lie at the lower end and inside",
    "LL-36": "interslice forces are an assumption, and not a bound",
    "DW-78": "the base circle passes close to the ends of the section, where limit analysis and FEM slide freely",
    "GL-6-wet": "pressures are linear in the triangles of the first mesh: with `size = 1.5`, 1.891 … 1.918",
}
SLICES_BELOW = "polyline: kinks without resistance"
WITHIN_BRACKETS = "FEM: within its brackets"
BEYOND_BRACKETS = "FEM: the extrapolation over two meshes goes too far"
TOO_COARSE = "FEM: too few elements in the weak seam"


def make_section(name, polygon, soil, more=""):
    """A case of one soil; `soil` as lines of TOML."""
    points = ", ".join(f"[{x!r}, {y!r}]" for x, y in polygon)
    return (f'title = "{name}"\n\n[analysis]\nmethods = ["bounds"]\n\n[[geometry.polygon]]\nname = "soil"\npoints = [{points}]\n\n'
            f'[regions]\nsoil = "soil"\n\n[materials.soil]\nmodel = "mohr_coulomb"\ntensile_strength = 0\n{soil}\n\n{more}')


def find_spiral_need(tangent, slope, parts=220):
    """Largest c/(γH) that a log-spiral through the toe of a slope needs in soil of that tan φ, W. F. Chen (1975), Limit analysis and soil
    plasticity, chapter 9: work of the weight over the dissipation of one kPa. A grid of spirals, so an upper bound by itself."""
    most = 0.0
    for i in range(parts):
        start = math.radians(5 + 85 * i / parts)
        for j in range(parts):
            end = start + math.radians(5 + 110 * j / parts)
            if end >= math.radians(175):
                break
            growth = math.exp((end - start) * tangent)
            height = math.sin(end) * growth - math.sin(start)
            crest = math.sin(end - start) / math.sin(end) - math.sin(end + slope) / (math.sin(end) * math.sin(slope)) * height
            if height <= 0 or crest < 0:
                continue
            whole = ((3 * tangent * math.cos(end) + math.sin(end)) * growth**3 - 3 * tangent * math.cos(start) - math.sin(start)) / (
                3 * (1 + 9 * tangent**2))
            above = crest / 6 * (2 * math.cos(start) - crest) * math.sin(start)
            before = growth / 6 * (math.sin(end - start) - crest * math.sin(end)) * (math.cos(start) - crest + math.cos(end) * growth)
            dissipation = (growth**2 - 1) / (2 * tangent)
            most = max(most, (whole - above - before) / (dissipation * height))
    return most


def find_spiral_factor(phi, cohesion_number, slope):
    """Factor of safety of the log-spiral mechanism for c/(γH) and a slope; angles in degrees."""
    low, high = 0.5, 2.5
    while high - low > 1e-4:
        factor = (low + high) / 2
        stands = factor * find_spiral_need(math.tan(math.radians(phi)) / factor, math.radians(slope)) <= cohesion_number
        low, high = (factor, high) if stands else (low, factor)
    return high


def list_closed_forms():
    """(name, source, exact factor or its published interval, case)."""
    forms = []
    # A vertical cut without friction, γH/c = 3.7764 at F = 1.
    cut = [(0, 0), (3, 0), (3, 2), (1, 2), (1, 1), (0, 1)]
    forms.append(("vertical cut, φ = 0", "γH/c between 3.7752 and 3.7776 (Pastor et al. 2000; Lyamin and Sloan 2002)",
                  (3.7752 / 3.7764, 3.7776 / 3.7764), make_section("Vertical cut", [(x, y) for x, y in cut],
                  'unit_weight = "1 kN/m3"\ncohesion = "0.26480245736 kPa"\nfriction_angle = 0')))
    # Prandtl's strip, half of it.
    for phi, width, depth in ((0, 4, 2), (20, 7, 4), (30, 10, 6)):
        tangent = math.tan(math.radians(phi))
        nq = math.exp(math.pi * tangent) * math.tan(math.radians(45 + phi / 2)) ** 2
        load = (nq - 1) / tangent if phi else 2 + math.pi
        forms.append((f"strip on soil without weight, φ = {phi}°", f"Prandtl (1920): N_c = {load:.4f}", (1, 1), make_section(
            "Strip", [(0, 0), (width, 0), (width, depth), (1, depth), (0, depth)],
            f'unit_weight = "0.000001 kN/m3"\ncohesion = "1 kPa"\nfriction_angle = {phi}',
            f'[[surcharge]]\nname = "strip"\nx = [0, 1]\nload = ["{load!r} kPa", "{load!r} kPa"]\n')))
    # Reissner's strip: q beside it carries it.
    nq = math.exp(math.pi * math.tan(math.radians(20))) * math.tan(math.radians(55)) ** 2
    forms.append(("strip beside q, no weight, no cohesion, φ = 20°", f"Reissner (1924): N_q = {nq:.4f}", (1, 1), make_section(
        "Strip beside a load", [(0, 0), (7, 0), (7, 4), (1, 4), (0, 4)],
        'unit_weight = "0.000001 kN/m3"\ncohesion = 0\nfriction_angle = 20',
        f'[[surcharge]]\nname = "strip"\nx = [0, 1]\nload = ["{100 * nq!r} kPa", "{100 * nq!r} kPa"]\n\n'
        '[[surcharge]]\nname = "beside"\nx = [1, 7]\nload = ["100 kPa", "100 kPa"]\n')))
    # A rough rigid footing on sand, half of it.
    for phi, width, factor in ((20, 8, 2.8389), (30, 10, 14.7543)):
        load = 0.5 * 20 * 2 * factor
        forms.append((f"rough footing on sand, φ = {phi}°", f"Martin (2005): N_γ = {factor}", (1, 1), make_section(
            "Rough footing", [(0, 0), (width, 0), (width, 4), (1, 4), (0, 4)], f'unit_weight = "20 kN/m3"\ncohesion = 0\nfriction_angle = {phi}',
            '[[geometry.polygon]]\nname = "block"\npoints = [[0, 4], [1, 4], [1, 4.5], [0, 4.5]]\n\n[materials.block]\nmodel = "mohr_coulomb"\n'
            'unit_weight = "0.000001 kN/m3"\ncohesion = "1e6 kPa"\nfriction_angle = 0\ntensile_strength = "1e9 kPa"\n\n'
            f'[[surcharge]]\nname = "load"\nx = [0, 1]\nload = ["{load!r} kPa", "{load!r} kPa"]\n').replace('soil = "soil"\n', 'soil = "soil"\nblock = "block"\n')))
    # The log-spiral mechanism is an upper bound.
    for phi, cohesion in ((20, 12.38), (25.3, 16.1)):
        most = find_spiral_factor(phi, cohesion / 200, 45)
        forms.append((f"slope of 45°, φ = {phi}°, c/γH = {cohesion / 200:.4f}", f"log-spiral (Chen 1975): below {most:.4f}", (0, most),
                      make_section("Slope of 45 degrees", [(0, 0), (40, 0), (40, 10), (25, 10), (15, 20), (0, 20)],
                                   f'unit_weight = "20 kN/m3"\ncohesion = "{cohesion} kPa"\nfriction_angle = {phi}')))
    return forms


def bound(runner, name, text, options, tension):
    """The summary of one run; a message where there is none."""
    settings = [f"bounds.gap={options.gap}", f"bounds.triangles={options.triangles}", f'bounds.tension="{tension}"']
    try:
        return runner.run(name, text, settings)
    except Broken as fault:
        return str(fault)


def read_interval(summary):
    bounds = summary.get("bounds", {}) if isinstance(summary, dict) else {}
    return bounds.get("lower"), bounds.get("upper"), bounds


def write_interval(lower, upper):
    if lower is None or upper is None:
        return f"{'–' if lower is None else f'{lower:.4f}'} … {'–' if upper is None else f'{upper:.4f}'} | –"
    return f"{lower:.4f} … {upper:.4f} | {200 * (upper - lower) / (upper + lower):.1f} %"


def check_form(runner, form, options):
    name, source, (low, high), text = form
    summary = bound(runner, name, text, options, "apex")
    lower, upper, told = read_interval(summary)
    holds = lower is not None and upper is not None and lower <= high * (1 + 1e-6) and upper >= low * (1 - 1e-6)
    meshes = told.get("meshes", [{}])[-1]
    line = f"| {name} | {source} | {write_interval(lower, upper)} | {meshes.get('triangles', '–')} | {told.get('seconds') or 0:.0f} |"
    return line, holds, summary if isinstance(summary, str) else ""


def list_factors(summary):
    """Spencer's factor on the critical circle and polyline, and that of FEM, extrapolated from two meshes; each with half the
    width of its brackets."""
    factors = {}
    for kind, list_name in (("circle", "critical"), ("polyline", "noncircular")):
        for found in summary.get("lem", {}).get(list_name) or []:
            if found["method"] == "spencer" and found.get("factor") and not (found.get("checks") or {}).get("refusal"):
                factors[kind] = (found["factor"], 0.0)
    for run in summary.get("fem", {}).get("runs") or []:
        if run.get("factor") and len(run.get("meshes") or []) == 2:
            coarse, fine = ((m["failed"] - m["stable"]) / 2 for m in run["meshes"])
            sizes = [m["size"] for m in run["meshes"]]
            share = sizes[1] / (sizes[0] - sizes[1])
            factors["elements"] = (run["factor"], fine * (1 + share) + coarse * share)
    return factors


def explain(problem, factors, lower, upper):
    """A sentence for each factor that lies outside."""
    reasons = []
    for kind, (factor, bracket) in factors.items():
        below, above = lower is not None and factor < lower, upper is not None and factor > upper
        if kind == "elements" and below:
            reasons.append(WITHIN_BRACKETS if factor + bracket >= lower else BEYOND_BRACKETS)
        elif kind == "elements" and above:
            reasons.append(WITHIN_BRACKETS if factor - bracket <= upper else TOO_COARSE)
        elif kind == "polyline" and below and problem not in ("ACADS-1b", "LL-36"):
            reasons.append(SLICES_BELOW)
        elif below or above:
            reasons.append(REASONS.get(problem, "NOT EXPLAINED"))
    return list(dict.fromkeys(reasons))


def place(factor, lower, upper):
    if lower is not None and factor < lower:
        return f"{100 * (factor / lower - 1):.1f} %"
    if upper is not None and factor > upper:
        return f"+{100 * (factor / upper - 1):.1f} %"
    return "inside"


def check_slope(runner, entry, options):
    problem = read_problem(entry)
    size = 0.5 * find_height(problem) / choose_level(problem, COARSE)  # of the finer of two meshes
    text = make_case(problem, 50, True, noncircular=True, surfaces=[], finite_elements=True)
    text = text.replace('methods = ["lem"]', 'methods = ["lem", "fem", "bounds"]', 1)
    text = text.replace('flow = "both"', f'flow = "associated"\nsize = {size:.6g}')
    summary = bound(runner, entry["id"], text, options, "apex")
    lower, upper, told = read_interval(summary)
    factors = list_factors(summary) if isinstance(summary, dict) else {}
    places = {kind: place(factor, lower, upper) for kind, (factor, _) in factors.items()}
    cells = [f"{factors[kind][0]:.3f}, {places[kind]}" if kind in factors else "–" for kind in KINDS]
    ends = [summary] if isinstance(summary, str) else [told.get("error"), told.get("no_lower"), told.get("no_upper")]
    why = "; ".join(filter(None, ends + explain(entry["id"], factors, lower, upper)))
    meshes = told.get("meshes", [{}])[-1]
    line = (f"| {entry['id']} | {write_interval(lower, upper)} | {' | '.join(cells)} | {meshes.get('triangles', '–')} | "
            f"{told.get('seconds') or 0:.0f} | {why} |")
    return line, lower is not None and upper is not None, places


def check_wet(runner, entry, options):
    """Intervals with tension up to the apex and without any."""
    text = make_case(read_problem(entry), 50, True, noncircular=False, surfaces=[], finite_elements=True)
    text = text.replace('methods = ["lem"]', 'methods = ["bounds"]', 1)
    soils = {"apex": text, "none": re.sub(r"tensile_strength = .*", "tensile_strength = 0", text)}
    summaries = [bound(runner, f"{entry['id']}_{name}", soil, options, "as_given") for name, soil in soils.items()]
    cells = [write_interval(*read_interval(s)[:2]) + f" | {read_interval(s)[2].get('seconds') or 0:.0f}" for s in summaries]
    why = "; ".join(s for s in summaries if isinstance(s, str))
    return f"| {entry['id']} | {' | '.join(cells)} | {why}", all(None not in read_interval(s)[:2] for s in summaries)


def run_wet(runner, slopes, options):
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda entry: check_wet(runner, entry, options), [e for e in slopes if e["id"] in WET]))
    text = "\n".join([
        "# Lower and upper bounds under water and loads", "",
        f"Published slopes with water, loads or an earthquake, `tools/verify_bounds.py PROGRAM --wet --gap {options.gap} --triangles {options.triangles} --write`, with tension "
        "up to the apex c/tan φ and without tensile strength; seconds of one core beside other work.", "",
        "| problem | apex | gap | seconds | no tension | gap | seconds | |", "|---|---|--:|--:|---|--:|--:|---|", *(line + " |" for line, _ in rows)]) + "\n"
    print(text)
    if options.write:
        WET_TABLE.write_text(text, encoding="utf-8")
    return 0 if all(holds for _, holds in rows) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--file", type=pathlib.Path, default=PROBLEMS)
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--gap", type=float, default=0.02)
    parser.add_argument("--triangles", type=int, default=3000)
    parser.add_argument("--jobs", type=int, default=max(1, os.cpu_count() or 2))
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--wet", action="store_true")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    slopes = [e for e in json.loads(options.file.read_text())["lem"] if (e["id"] in options.only if options.only else e.get("recomputed"))]
    forms = [f for f in list_closed_forms() if not options.only or f[0] in options.only]
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(os.path.abspath(options.program), (options.out or pathlib.Path(scratch)) / "runs")
        if options.wet:
            return run_wet(runner, slopes, options)
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            of_forms = list(pool.map(lambda form: check_form(runner, form, options), forms))
            of_slopes = list(pool.map(lambda entry: check_slope(runner, entry, options), slopes))
    lines = [f"Made by `tools/verify_bounds.py PROGRAM --gap {options.gap} --triangles {options.triangles} --write`; seconds of one core beside other "
             "work. [Theory](../theory/21-proven-bounds.md).", "", "## Closed forms", "",
             "| problem | exact | bounds | gap | triangles | seconds |", "|---|---|---|--:|--:|--:|", *(line for line, _, _ in of_forms), "",
             "## Published slopes", "", "Factors of Spencer's critical circle and polyline and of FEM, and their position: inside, or the distance below or above.",
             "", "| problem | bounds for ψ = φ | gap | circle | polyline | FEM | triangles | seconds | explanation |",
             "|---|---|--:|---|---|---|--:|--:|---|", *(line for line, _, _ in of_slopes)]
    counts = []
    for kind in KINDS:
        places = [outside[kind] for _, _, outside in of_slopes if kind in outside]
        counts.append(f"{'FEM' if kind == 'elements' else kind}: {places.count('inside')} of {len(places)} inside, {sum(p.startswith('-') for p in places)} below, "
                      f"{sum(p.startswith('+') for p in places)} above")
    lines += ["", "; ".join(counts) + ".", "", "*Kinks without resistance*: no stress in equilibrium supports so low a factor. Interslice forces do not account for the "
              "dissipation at the kinks of the base ([T18.10](../theory/18-limit-equilibrium.md#eq-t18-10)); the check of wedges leaves 3 %. The error is to the safe side.",
              "*Within its brackets*: the FEM factor is extrapolated from two meshes, and their last brackets contain the end of the interval."]
    text = "# Lower and upper bounds against closed forms and published slopes\n\n" + "\n".join(lines) + "\n"
    print(text)
    if options.write:
        TABLE.write_text(text, encoding="utf-8")
    failed = [line for line, holds, _ in of_forms if not holds] + [line for line, holds, _ in of_slopes if not holds]
    print(*failed, sep="\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
