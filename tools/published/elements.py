# SPDX-License-Identifier: MIT
"""Strength reduction by quadratic elements, with ψ = 0 and ψ = φ, on two meshes."""
from __future__ import annotations

import math

from .case_file import make_case
from .problem import METHODS, read_problem
from .runs import Broken
from .table import MISS, NOTE, Row, judge

ASSOCIATED, BELOW, ABOVE = 0.02, 0.10, 0.02
STEEP = 1.0  # tangent of a slope that is steep; ψ = 0 is reported only
COHESIONLESS = 0.02  # c/(γH), likewise
COARSE, FINE = 1300, 5200  # elements of the two meshes, about
LEVELS = (4, 8, 16, 32, 64)  # elements over the height that are chosen from


def find_height(problem):
    levels = [y for _, y in problem.ground]
    return max(levels) - min(levels)


def find_steepest(problem):
    return max(abs(b[1] - a[1]) / (b[0] - a[0]) if b[0] > a[0] else 1e9 for a, b in zip(problem.ground, problem.ground[1:]))


def is_homogeneous(problem):
    strengths = {(m["c"], m["phi"], m["gamma"], m.get("cu_rate_per_depth", 0), m["ru"]) for m in problem.materials}
    return len(strengths) == 1


def find_reference(problem):
    """(value or range, what it is): Spencer's factor and the upper bound of limit analysis."""
    entry = problem.entry
    spencer = ((entry.get("recomputed") or {}).get("circular_search") or {}).get("spencer", {}).get("F")
    bound = entry.get("log_spiral_upper_bound")
    values = [v for v in (spencer, bound) if v]
    return (min(values), max(values)) if values else None


def find_bracket(entry, flow):
    """The recomputed bracket of this flow rule; of ψ = 0 the whole range of its variants."""
    found = [v for name, v in (entry.get("recomputed_fem_srm_bracket") or {}).items()
             if (name.startswith("psi=phi") if flow == "associated" else name.startswith("psi=0"))]
    return (min(v[0] for v in found), max(v[1] for v in found)) if found else None


def choose_level(problem, wanted):
    """Elements over the height of the slope that give about the wanted number in all."""
    area = sum(0.5 * abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))) for _, _, ring in problem.regions)
    height = find_height(problem)

    def misfit(level):
        return abs(math.log(area / (math.sqrt(3) / 4 * (height / level) ** 2) / wanted))

    return min(LEVELS, key=misfit)


def judge_run(problem, flow, factor, mesh):
    reference, bracket = find_reference(problem), find_bracket(problem.entry, flow)
    told = f"recomputed {bracket[0]:g}–{bracket[1]:g}" if bracket else ""
    material = problem.materials[0]
    frictionless = all(m["phi"] == 0 for m in problem.materials)
    weak = material["c"] / (material["gamma"] * find_height(problem) / problem.units.length) < COHESIONLESS
    what = f"strength reduction, {mesh}"
    name = "ψ = φ" if flow == "associated" else "ψ = 0"
    if not reference or not is_homogeneous(problem) or (problem.water_table and flow != "associated"):
        near = reference if is_homogeneous(problem) else bracket
        return Row(problem.id, what, name, factor, near or bracket, "report", NOTE, None, told)
    if flow == "associated" or frictionless:
        return Row(problem.id, what, name, factor, reference, "±2 %", judge(factor, reference, ASSOCIATED, ASSOCIATED), None, told)
    if weak or find_steepest(problem) > STEEP:
        return Row(problem.id, what, name, factor, reference, "report", NOTE, None, f"steep or almost without cohesion; {told}")
    return Row(problem.id, what, name, factor, reference, "–10…+2 %", judge(factor, reference, BELOW, ABOVE), None, told)


def verify(runner, entry, meshes=(COARSE, FINE)):
    problem = read_problem(entry)
    height = find_height(problem)
    rows = []
    levels = [choose_level(problem, wanted) for wanted in meshes]
    for over_height in dict.fromkeys(levels):
        text = make_case(problem, search=False, surfaces=[], finite_elements=True)
        size = round(height / over_height, 6)
        name = f"{problem.id}_fem{over_height}"
        last = over_height == levels[-1]
        try:
            summary = runner.run(name, text, ['analysis.methods=["fem"]', f"fem.size={size}", "fem.meshes=1", "fem.resolution=0.005"])
        except Broken as fault:
            rows.append(Row(problem.id, f"strength reduction, H/{over_height}", "", None, None, "", MISS, None, str(fault)))
            continue
        for run in summary["fem"]["runs"]:
            row = judge_run(problem, run["flow"], run.get("factor"), f"H/{over_height}")
            if not last and row.verdict != NOTE:  # the coarse mesh shows the convergence, the fine one is judged
                row.verdict, row.band = NOTE, "report"
            rows.append(row)
    return rows
