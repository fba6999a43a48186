#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mesh convergence of the frozen factor of MPM, on eight slopes and a slab, against limit analysis and FEM.

Usage: tools/verify_frozen_meshes.py PROGRAM [--only SLOPE …] [--coarse N …] [--jobs N] [--out FOLDER] [--write]

Three pairs of meshes, from 6.7 to 26.7 elements over the height, ψ = φ and ψ = 0, by the default mesher and without a second one. The
truth is the middle of the interval of limit analysis for ψ = φ, and for ψ = 0 the factor of quadratic elements, extrapolated from two meshes. The slab,
of tetrahedra between smooth walls, has the factor of its section. --write
stores the table in docs/verification_data/frozen_meshes.md. --out keeps cases and results, and finished runs found there are taken. Twenty
minutes on two cores.
Ends with 1 where the interval of a pair of meshes does not hold the truth.
"""
import argparse
import concurrent.futures
import math
import os
import pathlib
import sys
import tempfile
from typing import NamedTuple

from published.runs import Broken, Runner

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "docs" / "verification_data" / "frozen_meshes.md"
PAIRS = ((6.67, 13.33), (9.43, 18.86), (13.33, 26.67))  # elements over the height
LEVELS = sorted({level for pair in PAIRS for level in pair})
PAIRS_3D = (PAIRS[0], PAIRS[2])
ELEMENTS = (13.33, 26.67)
HEIGHT = 10


def make_face(angle, below, left, right):
    """A slope of that angle [deg], so much soil below its toe, before its crest and behind its toe."""
    width = HEIGHT / math.tan(math.radians(angle))
    return [(0, 0), (left + width + right, 0), (left + width + right, below), (left + width, below), (left, below + HEIGHT),
            (0, below + HEIGHT)]


def make_soil(weight, cohesion, friction, tension=None):
    """kN/m³, kPa, degrees; without `tension` no cut-off below the apex."""
    apex = cohesion / math.tan(math.radians(friction)) * (1 - 1e-9) if friction > 0 else 100 * cohesion
    return weight, cohesion, friction, apex if tension is None else tension


class Slope(NamedTuple):
    name: str
    polygons: list
    soils: list  # one for each polygon
    known: float | None = None  # factor
    width: float | None = None  # between smooth walls [m]; else plane strain


CUT = make_soil(20, 1.3 * 200 / 3.7764, 0)
SLOPES = tuple(Slope(*values) for values in (
    ("dry slope of the source", [[(0, 0), (44, 0), (44, 5), (32, 5), (12, 15), (0, 15)]], [make_soil(15.598, 2, 30, 0)], None),
    ("Griffiths and Lane 1", [[(0, 0), (32, 0), (12, 10), (0, 10)]], [make_soil(20, 10, 20)], None),
    ("vertical cut, φ = 0", [[(0, 0), (25, 0), (25, 10), (15, 10), (15, 20), (0, 20)]], [CUT], 1.3),
    ("45°, φ = 25.3°", [make_face(45, 10, 15, 15)], [make_soil(20, 16.1, 25.3)], None),
    ("30°, φ = 0", [make_face(30, 10, 20, 20)], [make_soil(20, 1.3 * 0.172 * 200, 0)], None),
    ("45°, φ = 10°", [make_face(45, 5, 15, 12)], [make_soil(20, 1.3 * 0.108 * 200, 10)], None),
    ("60°, φ = 15°", [make_face(60, 5, 15, 12)], [make_soil(20, 1.3 * 0.116 * 200, 15)], None),
    ("sand on clay", [[(0, 0), (55, 0), (55, 8), (0, 8)], [(0, 8), (40, 8), (20, 18), (0, 18)]],
     [make_soil(18, 38, 0), make_soil(19, 6, 28)], None),
    ("vertical cut, φ = 0, in 3D", [[(0, 0), (19, 0), (19, 4), (13, 4), (13, 14), (0, 14)]], [CUT], 1.3, 3),
))


def make_case(slope, associated, method):
    name, polygons, soils, _, width = slope
    right = max(x for ring in polygons for x, _ in ring)
    top = max(y for ring in polygons for _, y in ring)
    lines = [f'title = "{name}"', "[geometry]", f"box = [[0, 0], [{right:.6g}, {top + 1:.6g}]]", *(["dimension = 3", f"thickness = {width}"] if width else []), ""]
    for i, ring in enumerate(polygons):
        lines += ["[[geometry.polygon]]", f'name = "soil{i}"', "points = [" + ", ".join(f"[{x:.6g}, {y:.6g}]" for x, y in ring) + "]", ""]
    lines += ["[regions]", *(f'soil{i} = "soil{i}"' for i in range(len(polygons))), ""]
    for i, (weight, cohesion, friction, tension) in enumerate(soils):
        lines += [f"[materials.soil{i}]", 'model = "mohr_coulomb"', f"grain_density = {weight * 1000 / 9.81:.8g}", "porosity = 0",
                  'young_modulus = "100 MPa"', "poisson_ratio = 0.3", f'cohesion = "{cohesion:.8g} kPa"', f"friction_angle = {friction}",
                  f"dilatancy_angle = {friction if associated else 0}", f'tensile_strength = "{tension:.10g} kPa"', ""]
    for side, held in (("bottom", "full"), ("left", "normal"), ("right", "normal"), *((("front", "normal"), ("back", "normal")) if width else ())):
        lines += ["[[boundary]]", f'on = "{side}"', f'fix = "{held}"', ""]
    lines += ["[mesh]", "size = 1", "", "[[stage]]", 'name = "gravity"', "duration = 20", 'until = "rest"', "damping = 0.75",
              'cohesion = "1000 kPa"', "", "[[stage]]", 'name = "real strength"', "duration = 20", 'until = "rest"', "damping = 0.75", "",
              "[analysis]", 'kind = "strength_reduction"', f'methods = ["{method}"]', "", "[strength_reduction.curve]", "enabled = false", "",
              "[strength_reduction.frozen]", "meshes = 2", "mesh_scatter = false", "", "[fem]", 'flow = "as_given"', ""]
    return "\n".join(lines)


def find_factor(runner, slope, associated, level):
    name = f"{slope.name} {'phi' if associated else '0'} mpm {level}"
    return runner.run(name, make_case(slope, associated, "mpm"), [f"mesh.size={HEIGHT / level:.6g}"])["factor_of_safety"]["frozen"]


def find_by_elements(runner, slope, associated, level):
    name = f"{slope.name} {'phi' if associated else '0'} fem {level}"
    summary = runner.run(name, make_case(slope, associated, "fem"), [f"fem.size={HEIGHT / level:.6g}", "fem.meshes=1", "fem.resolution=0.004"])
    return summary["fem"]["runs"][0]["factor"]


def find_truth(runner, slope, associated):
    """(lower, upper, what it is)."""
    if slope.known:
        return slope.known, slope.known, "known"
    if associated or all(soil[2] == 0 for soil in slope.soils):
        bounds = runner.run(f"{slope.name} bounds", make_case(slope, True, "bounds"), ["bounds.gap=0.008"])["bounds"]
        return bounds["lower"], bounds["upper"], "limit analysis"
    coarse, fine = (find_by_elements(runner, slope, associated, level) for level in ELEMENTS)
    return 2 * fine - coarse, fine, "elements"


def check_slope(runner, slope, associated, coarse):
    """A line of the table, and the pairs of meshes whose interval does not hold the truth."""
    lower, upper, source = find_truth(runner, slope, associated)
    middle = 0.5 * (lower + upper)
    one, two, missed = {}, {}, []
    for pair in PAIRS:
        if pair[0] not in coarse or (slope.width and pair not in PAIRS_3D):
            continue
        frozen = find_factor(runner, slope, associated, pair[0])
        one |= {level: mesh["factor"] for level, mesh in zip(pair, frozen["meshes"])}
        factor, half = frozen["factor"], frozen["uncertainty"]
        holds = factor - half <= upper and factor + half >= lower
        two[pair] = f"{factor:.3f} ± {half:.3f} ({100 * (factor / middle - 1):+.1f}{'' if holds else ', MISSES'})"
        if not holds:
            missed.append(f"{slope.name}, H/{pair[0]} and H/{pair[1]}")
    cells = [f"{one[level]:.3f} ({100 * (one[level] / middle - 1):+.1f})" if level in one else "–" for level in LEVELS]
    cells += [two.get(pair, "–") for pair in PAIRS]
    truth = f"{lower:.3f}" if lower == upper else f"{lower:.3f} … {upper:.3f}"
    return f"| {slope.name} | {'φ' if associated else '0'} | {truth}, {source} | {' | '.join(cells)} |", missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--coarse", nargs="+", type=float, default=[coarse for coarse, _ in PAIRS])
    parser.add_argument("--jobs", type=int, default=max(1, os.cpu_count() or 2))
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    tasks = [(slope, associated) for slope in SLOPES if not options.only or slope.name in options.only
             for associated in (True, False) if associated or any(soil[2] > 0 for soil in slope.soils)]
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(os.path.abspath(options.program), options.out or pathlib.Path(scratch), keep=True)

        def check(task):
            try:
                return check_slope(runner, *task, options.coarse)
            except Broken as fault:
                return f"| {task[0].name} | {fault} |", [task[0].name]

        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            found = list(pool.map(check, tasks))
    heads = [f"H/{level:g}" for level in LEVELS] + [f"H/{a:g}, H/{b:g}" for a, b in PAIRS]
    text = "\n".join([
        "# Frozen factors over the mesh", "", "Made by `tools/verify_frozen_meshes.py PROGRAM --write`. In brackets: percent of the middle of the truth. "
        "Pairs of meshes: extrapolated, with the interval that the program prints without a second mesher "
        "([factor of safety](../theory/factor-of-safety.md)).", "",
        "| slope | ψ | truth | " + " | ".join(heads) + " |", "|---|---|---" + "|--:" * len(heads) + "|", *(line for line, _ in found), ""])
    print(text)
    if options.write:
        TABLE.write_text(text, encoding="utf-8")
    missed = [name for _, names in found for name in names]
    print(*(f"does not hold the truth: {name}" for name in missed), sep="\n")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
