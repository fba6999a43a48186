# SPDX-License-Identifier: MIT
"""Slopes whose pore pressures follow from steady seepage on the same section, then slices."""
from __future__ import annotations

import re

from .case_file import number, points_text, quantity, write_comment, write_search_ranges, write_stiffness, write_surface
from .flow_case import GAMMA_W
from .problem import METHODS, read_given_surfaces, read_problem
from .runs import Broken
from .seepage import find_level, head_row
from .slices import check_published_only, find, read_factor
from .table import MISS, Row, judge

BAND = 0.02


def find_edge(problem, place):
    """"left" or "right" of a place in words: "x=0 edge", "left edge"."""
    at = re.search(r"\bx\s*=\s*(-?\d+(?:\.\d+)?)", place)
    if at:
        return "left" if abs(float(at[1]) * problem.units.length - problem.ground[0][0]) < 1e-6 else "right"
    for side in ("left", "right"):
        if re.search(rf"\b{side}\b", place):
            return side
    raise Broken(f"seepage_bc names the place '{place}': expected 'x=NUMBER …', 'left …' or 'right …'")


def list_conditions(problem):
    """[(name, points or None, head or None)]: edges and lines of the ground with a total head [m], and the face where water may leave."""
    conditions = []
    for key, place in (problem.entry.get("seepage_bc") or {}).items():
        points = problem.scale(place) if isinstance(place, list) else None
        if key.startswith("head_"):
            name = f"water_{len(conditions)}" if points else find_edge(problem, place)
            conditions.append((name, points, round(float(key[5:]) * problem.units.length, 6)))
        else:
            conditions.append(("ground", points or problem.ground, None))
    return conditions


def write_soil(lines, problem, material, fringe, stiffness=False):
    units, key = problem.units, material["key"]
    dry = number(round(fringe * GAMMA_W, 6))
    lines += [f"[materials.{key}]", 'model = "mohr_coulomb"', f"unit_weight = {quantity(material['gamma'], units.weight_name)}",
              f"saturated_unit_weight = {quantity(material['gamma'], units.weight_name)}",
              "grain_density = 2650  # this and the porosity: for the flow; weights are given", "porosity = 0.4",
              f"cohesion = {quantity(material['c'], units.stress_name)}", f"friction_angle = {number(material['phi'])}",
              'suction_strength = "none"']
    if stiffness:
        write_stiffness(lines, problem, material, "cohesion")
    lines += ["", f"[materials.{key}.water]", 'retention = "linear"', "minimum_saturation = 0.1",
              f"dry_suction = {dry}", f'conductivity = "{number(material.get("k", 1e-5))} m/s"', 'relative_conductivity = "table"',
              f"conductivity_table = [[0, 1], [{dry}, 1e-3]]", ""]


def make_coupled_case(problem, size, fringe, stiffness=False):
    """Heads as the entry says them ("head_40": "x=0 edge" or points of the ground), and the face where water may leave."""
    units, conditions = problem.units, list_conditions(problem)
    lines = []
    write_comment(lines, f"{problem.id}: {problem.entry['title']}")
    lines += [f'title = "{problem.id}"', "", "[analysis]", 'methods = ["lem"]', ""]
    for kind, items in (("polygon", [(name, ring) for name, _, ring in problem.regions]), ("line", [c[:2] for c in conditions if c[1]])):
        for name, points in items:
            lines += [f"[[geometry.{kind}]]", f'name = "{name}"', f"points = {points_text(points)}", ""]
    lines += ["[mesh]", f"size = {number(size)}", ""]
    lines += ["[regions]"] + [f'{name} = "{problem.materials[m]["key"]}"' for name, m, _ in problem.regions] + [""]
    for material in problem.materials:
        write_soil(lines, problem, material, fringe, stiffness)
    lines += ["[initial]", 'pore_pressure = "seepage"', ""]
    if units.imperial:
        lines += ["[water]", f"density = {number(round(62.4 * 157.08746385 / 9.81, 6))}  # 62.4 lbf/ft3", ""]
    for name, _, head in sorted(conditions, key=lambda c: (c[2] is None, c[0])):
        condition = ['condition = "seepage_face"'] if head is None else ['condition = "total_head"', f"head = {number(head)}"]
        lines += ["[[hydraulic]]", f'on = "{name}"', *condition, ""]
    surfaces = read_given_surfaces(problem)
    lines += ["[[hydraulic]]", 'on = "bottom"', 'condition = "no_flow"', "", "[lem]",
              "methods = [" + ", ".join(f'"{m}"' for m in METHODS.values()) + "]", "slices = 100",
              f'search = "{"none" if surfaces else "entry_exit"}"', "noncircular = false", "yield_acceleration = false",
              f"composite = {str(bool(problem.entry.get('composite'))).lower()}", ""]
    if not surfaces:
        write_search_ranges(lines, problem)
    for name, surface in surfaces:
        write_surface(lines, name, surface)
    return "\n".join(lines), [head for _, _, head in conditions if head is not None]


def verify(runner, entry):
    problem = read_problem(entry)
    height = max(y for _, y in problem.ground) - min(y for _, y in problem.ground)
    size = height / 16
    try:
        text, heads = make_coupled_case(problem, size, 1.5 * size)
        summary = runner.run(problem.id, text)
    except Broken as fault:
        return [Row(problem.id, "seepage and slices", "", None, None, "", MISS, None, str(fault))]
    rows = []
    recomputed, length = entry.get("recomputed") or {}, problem.units.length
    table = (summary.get("seepage") or {}).get("water_table")
    drop = max(heads) - min(heads) if len(heads) == 2 else height
    for x, y in recomputed.get("phreatic_xy") or []:
        if table:
            rows.append(head_row(problem.id, f"water table at x = {x:g}", "seepage", find_level(table, x * length), y * length, drop))
    if not recomputed:
        return rows + check_published_only(problem, summary["lem"])
    published = [v for value in entry.get("published", {}).values() for v in (value if isinstance(value, list) else [value])]
    for method, reference in (recomputed.get("F") or {}).items():
        factor, refusal = read_factor(find(summary["lem"].get("critical"), method))
        rows.append(Row(problem.id, "critical circle", METHODS[method], factor, reference, f"±{100 * BAND:g} %",
                        judge(factor, reference, BAND, BAND), (min(published), max(published)), refusal))
    return rows
