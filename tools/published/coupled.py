# SPDX-License-Identifier: MIT
"""Slopes whose pore pressures follow from steady seepage on the same section, then slices."""
from __future__ import annotations

import re

from .case_file import number, quantity, write_comment
from .flow_case import GAMMA_W
from .problem import FOOT, METHODS, read_problem
from .runs import Broken
from .seepage import find_level, head_row
from .slices import find, read_factor
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


def make_coupled_case(problem, size, fringe):
    """Heads at the two edges as the entry says them ("head_40": "x=0 edge"), the ground a face where water may leave."""
    units, material = problem.units, problem.materials[0]
    heads = {}
    for key, place in (problem.entry.get("seepage_bc") or {}).items():
        if key.startswith("head_"):
            heads[find_edge(problem, place)] = round(float(key[5:]) * units.length, 6)
    ring = problem.regions[0][2]
    ground = ", ".join(f"[{number(x)}, {number(y)}]" for x, y in problem.ground)
    lines = []
    write_comment(lines, f"{problem.id}: {problem.entry['title']}")
    lines += [f'title = "{problem.id}"', "", "[analysis]", 'methods = ["lem"]', "", "[[geometry.polygon]]", 'name = "soil"',
              "points = [" + ", ".join(f"[{number(x)}, {number(y)}]" for x, y in ring) + "]", "", "[[geometry.line]]",
              'name = "ground"', f"points = [{ground}]", "", "[mesh]", f"size = {number(size)}", "", "[regions]",
              'soil = "soil"', "", "[materials.soil]", 'model = "mohr_coulomb"',
              f"unit_weight = {quantity(material['gamma'], units.weight_name)}",
              f"saturated_unit_weight = {quantity(material['gamma'], units.weight_name)}",
              "grain_density = 2650  # this and the porosity: for the flow; weights are given", "porosity = 0.4",
              f"cohesion = {quantity(material['c'], units.stress_name)}", f"friction_angle = {number(material['phi'])}",
              'suction_strength = "none"', "", "[materials.soil.water]", 'retention = "linear"', "minimum_saturation = 0.1",
              f"dry_suction = {number(round(fringe * GAMMA_W, 6))}", 'conductivity = "1e-5 m/s"',
              'relative_conductivity = "table"', f"conductivity_table = [[0, 1], [{number(round(fringe * GAMMA_W, 6))}, 1e-3]]",
              "", "[initial]", 'pore_pressure = "seepage"', ""]
    if units.imperial:
        lines += ["[water]", f"density = {number(round(62.4 * 157.08746385 / 9.81, 6))}  # 62.4 lbf/ft3", ""]
    for side, head in sorted(heads.items()):
        lines += ["[[hydraulic]]", f'on = "{side}"', 'condition = "total_head"', f"head = {number(head)}", ""]
    lines += ["[[hydraulic]]", 'on = "ground"', 'condition = "seepage_face"', "", "[[hydraulic]]", 'on = "bottom"',
              'condition = "no_flow"', "", "[lem]",
              "methods = [" + ", ".join(f'"{m}"' for m in METHODS.values()) + "]", "slices = 100", "noncircular = false",
              "yield_acceleration = false", ""]
    return "\n".join(lines), heads


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
    drop = max(heads.values()) - min(heads.values()) if len(heads) == 2 else height
    for x, y in recomputed.get("phreatic_xy") or []:
        if table:
            rows.append(head_row(problem.id, f"water table at x = {x:g}", "seepage", find_level(table, x * length), y * length, drop))
    published = [v for value in entry.get("published", {}).values() for v in (value if isinstance(value, list) else [value])]
    for method, reference in (recomputed.get("F") or {}).items():
        factor, refusal = read_factor(find(summary["lem"].get("critical"), method))
        rows.append(Row(problem.id, "critical circle", METHODS[method], factor, reference, f"±{100 * BAND:g} %",
                        judge(factor, reference, BAND, BAND), (min(published), max(published)), refusal))
    return rows
