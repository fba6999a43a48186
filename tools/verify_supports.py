#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Intervals of limit analysis for slopes with supports and walls, of docs/verification.md.

Usage: tools/verify_supports.py PROGRAM [--only NAME …] [--out FOLDER]

Published problems of tests/data/published/problems.json with tension up to the apex and without tensile strength; sheet piles along a cut of
3 m in sand; a nailed cut. About ten minutes. A bound of 0 or "–" was not found; the reason stands beside it.
"""
import argparse
import json
import pathlib
import tempfile

from published.case_file import make_case
from published.problem import read_problem
from published.runs import Broken, Runner

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROBLEMS = ROOT / "tests" / "data" / "published" / "problems.json"
GAP, TRIANGLES = 0.03, 4000

# A line load on 10 mm would fail the soil below it: it is spread over a metre. A bolt, which pulls at a point, becomes an anchor.
CHANGES = {
    "SH-47-passive": ["surcharge.0.x=[0, 1]", 'surcharge.0.load=["14.6 kPa", "14.6 kPa"]'],
    "DW-85-active": ['support.tieback.kind="anchor"', "support.tieback.bond_length=4.5", 'support.tieback.bond="4000 lbf/ft"',
                     "support.tieback.plate=inf"],
}
PUBLISHED = ["SH-47-passive", "PD-60", "SH-48-45", "BC-31", "DW-86", "LH-87", "DW-85-active", "PD-58"]

SHEET = """
title = "Sheet pile"
[geometry]
ground = [[0, 3], [12, 3], [12, 0], [24, 0]]
[[geometry.layer]]
name = "sand"
level = -9
[regions]
sand = "sand"
[materials.sand]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 0.2
friction_angle = 35
dilatancy_angle = 35
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
[analysis]
methods = ["bounds"]
[support.sheet]
kind = "wall"
line = [[12, 3], [12, {toe}]]
bond_friction = 0
{more}
"""
TIE = """
[support.tie]
kind = "anchor"
heads = [[12, 2]]
inclination = 0
length = 11
bond_length = 4
out_of_plane_spacing = 2
tensile_strength = 1000
plate = 900
bond = 800
"""
CUT = """
title = "Nailed cut"
geometry.polygon = [{ name = "soil", points = [[-6, -4], [26, -4], [26, 8], [12, 8], [8, 0], [-6, 0]] }]
regions.soil = "silt"
analysis.methods = ["bounds"]
[materials.silt]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 6
friction_angle = 28
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
[support.nails]
kind = "nail"
heads = [[11.25, 6.5], [10.25, 4.5], [9.25, 2.5]]
inclination = 10
length = 7
out_of_plane_spacing = 1.5
tensile_strength = 120
plate = 40
bond = 18
"""


def list_cases():
    """[(name, text, settings)]"""
    entries = {entry["id"]: entry for entry in json.loads(PROBLEMS.read_text())["lem"]}
    cases = []
    for name in PUBLISHED:
        text = make_case(read_problem(entries[name]), finite_elements=True)
        for tension in ("apex", "as_given"):
            settings = ['analysis.methods=["bounds"]', "lem=", "fem=", f'bounds.tension="{tension}"'] + CHANGES.get(name, [])
            if tension == "as_given":
                settings += [f"materials.{m['key']}.tensile_strength=0" for m in read_problem(entries[name]).materials]
            cases.append((f"{name}, {'apex' if tension == 'apex' else 'no tension'}", text, settings))
    cases.append(("cantilever of 6 m", SHEET.format(toe=-3, more=""), ["bounds.size=1"]))
    cases.append(("cantilever of 8 m", SHEET.format(toe=-5, more=""), ["bounds.size=1"]))
    cases.append(("cantilever of 8 m, M_p = 40 kN m", SHEET.format(toe=-5, more="plastic_moment = 40"), ["bounds.size=1"]))
    cases.append(("anchored wall of 4.5 m", SHEET.format(toe=-1.5, more=TIE), ["bounds.size=0.7", "bounds.triangles=14000"]))
    cases.append(("nailed cut of 8 m", CUT, ["bounds.gap=0.01"]))
    return cases


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", nargs="*", default=[], metavar="NAME", help="cases whose name begins so")
    parser.add_argument("--out")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(options.program, options.out or scratch, threads=2)
        print("| case | lower bound | upper bound | triangles | s | |\n|---|--:|--:|--:|--:|---|")
        for name, text, settings in list_cases():
            if options.only and not any(name.startswith(start) for start in options.only):
                continue
            limits = [f"bounds.gap={GAP}", f"bounds.triangles={TRIANGLES}"]
            try:
                bounds = runner.run(name, text, limits + settings)["bounds"]
            except Broken as why:
                print(f"| {name} | – | – | – | – | {why} |", flush=True)
                continue
            lower, upper = (f"{bounds[k]:.4f}" if bounds.get(k) else "–" for k in ("lower", "upper"))
            reason = bounds.get("no_lower") or bounds.get("no_upper") or ""
            print(f"| {name} | {lower} | {upper} | {bounds['meshes'][-1]['triangles']} | {bounds['seconds']:.0f} | {reason} |", flush=True)


if __name__ == "__main__":
    main()
