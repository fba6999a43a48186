#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds slices against proven bounds, on every published slope and on closed forms, in one table.

Usage: tools/verify_bounds.py PROGRAM [--file problems.json] [--only ID …] [--gap G] [--triangles N] [--jobs N] [--out FOLDER] [--write]

Each slope of tests/data/published/problems.json runs by slices and by limit analysis with ψ = φ and no limit of tension below the apex,
which is what slices assume. Closed forms run by limit analysis alone. --write stores the table in docs/verification_data/bounds.md.
--out keeps cases and results. Ends with 1 where a closed form lies outside its interval, or a slope has no interval.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import sys
import tempfile

from published.case_file import make_case
from published.problem import read_problem
from published.runs import Broken, Runner

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROBLEMS = ROOT / "tests" / "data" / "published" / "problems.json"
TABLE = ROOT / "docs" / "verification_data" / "bounds.md"
# Slices differ by so much from each other and from what is printed, in tests of them.
CLOSE = 0.005


def make_section(name, polygon, soil, more=""):
    """A case of one soil; `soil` as lines of TOML."""
    points = ", ".join(f"[{x!r}, {y!r}]" for x, y in polygon)
    return (f'title = "{name}"\n\n[analysis]\nmethods = ["bounds"]\n\n[[geometry.polygon]]\nname = "soil"\npoints = [{points}]\n\n'
            f'[regions]\nsoil = "soil"\n\n[materials.soil]\nmodel = "mohr_coulomb"\ntensile_strength = 0\n{soil}\n\n{more}')


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
    # 45° with φ = 25.3°: what the log-spiral mechanism of Chen (1975) needs is an upper bound.
    forms.append(("slope of 45°, φ = 20°, c/γH = 0.0619", "log-spiral mechanism (Chen 1975) below 1.0001", (0, 1.0001), make_section(
        "Slope of 45 degrees", [(0, 0), (40, 0), (40, 10), (25, 10), (15, 20), (0, 20)],
        'unit_weight = "20 kN/m3"\ncohesion = "12.38 kPa"\nfriction_angle = 20')))
    return forms


def bound(runner, name, text, options, tension):
    """The summary of one run; a sentence where there is none."""
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
    """(method, circle or polyline, factor) of the rigorous slices."""
    for kind, list_name in (("circle", "critical"), ("polyline", "noncircular")):
        for found in summary.get("lem", {}).get(list_name) or []:
            if found["method"] in ("spencer", "morgenstern_price") and found.get("factor") and not (found.get("checks") or {}).get("refusal"):
                yield found["method"], kind, found["factor"]


def place(factor, lower, upper):
    if lower is not None and factor < lower:
        return f"{100 * (factor / lower - 1):.1f} %"
    if upper is not None and factor > upper:
        return f"+{100 * (factor / upper - 1):.1f} %"
    return "inside"


def check_slope(runner, entry, options):
    text = make_case(read_problem(entry), 50, True, noncircular=True, surfaces=[], finite_elements=True).replace(
        'methods = ["lem"]', 'methods = ["lem", "bounds"]', 1)
    summary = bound(runner, entry["id"], text, options, "apex")
    lower, upper, told = read_interval(summary)
    factors = {}
    for method, kind, factor in list_factors(summary) if isinstance(summary, dict) else ():
        factors.setdefault(kind, {})[method] = factor
    cells = []
    for kind in ("circle", "polyline"):
        factor = factors.get(kind, {}).get("spencer")
        cells.append("–" if factor is None else f"{factor:.3f}, {place(factor, lower, upper)}")
    why = summary if isinstance(summary, str) else "; ".join(filter(None, [told.get("error"), told.get("no_lower"), told.get("no_upper")]))
    meshes = told.get("meshes", [{}])[-1]
    line = (f"| {entry['id']} | {write_interval(lower, upper)} | {' | '.join(cells)} | {meshes.get('triangles', '–')} | "
            f"{told.get('seconds') or 0:.0f} | {why} |")
    outside = {kind: place(values["spencer"], lower, upper) for kind, values in factors.items() if "spencer" in values}
    return line, lower is not None and upper is not None, outside


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--file", type=pathlib.Path, default=PROBLEMS)
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--gap", type=float, default=0.02)
    parser.add_argument("--triangles", type=int, default=3000)
    parser.add_argument("--jobs", type=int, default=max(1, os.cpu_count() or 2))
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    slopes = [e for e in json.loads(options.file.read_text())["lem"] if not options.only or e["id"] in options.only]
    forms = [f for f in list_closed_forms() if not options.only or f[0] in options.only]
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(os.path.abspath(options.program), (options.out or pathlib.Path(scratch)) / "runs")
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            of_forms = list(pool.map(lambda form: check_form(runner, form, options), forms))
            of_slopes = list(pool.map(lambda entry: check_slope(runner, entry, options), slopes))
    lines = [f"Made by `tools/verify_bounds.py PROGRAM --gap {options.gap} --triangles {options.triangles} --write`; seconds of one core beside other "
             "work. [What they are](../theory/21-proven-bounds.md).", "", "## Closed forms", "",
             "| problem | exact | proven | gap | triangles | seconds |", "|---|---|---|--:|--:|--:|", *(line for line, _, _ in of_forms), "",
             "## Published slopes", "", "Factors by Spencer's method, and where they lie: inside, or by how much below or above.", "",
             "| problem | proven for ψ = φ | gap | critical circle | critical polyline | triangles | seconds | note |",
             "|---|---|--:|---|---|--:|--:|---|", *(line for line, _, _ in of_slopes)]
    counts = []
    for kind in ("circle", "polyline"):
        places = [outside[kind] for _, _, outside in of_slopes if kind in outside]
        counts.append(f"{places.count('inside')} of {len(places)} {kind}s inside, {sum(p.startswith('-') for p in places)} below, "
                      f"{sum(p.startswith('+') for p in places)} above")
    lines += ["", "; ".join(counts) + "."]
    text = "# Proven bounds against closed forms and published slopes\n\n" + "\n".join(lines) + "\n"
    print(text)
    if options.write:
        TABLE.write_text(text, encoding="utf-8")
    failed = [line for line, holds, _ in of_forms if not holds] + [line for line, holds, _ in of_slopes if not holds]
    print(*failed, sep="\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
