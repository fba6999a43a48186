# SPDX-License-Identifier: MIT
"""Case files of plane steady seepage: soil, curves and hydraulic conditions, without motion."""
from __future__ import annotations

from .case_file import number, points_text, write_comment

GAMMA_W = 9.81  # kN/m³


def ramp(fringe):
    """Relative conductivity that falls to 1/1000 over a fringe [m] above the water table."""
    return [(0, 1), (fringe * GAMMA_W, 1e-3)]


def make_flow_case(title, box, polygons, conductivity, curve, lines, conditions, size, refine=()):
    """polygons: [(name, ring)]; conductivity: {name: m/s}; curve: [(suction [kPa], share)] or {name: curve};
    lines: [(name, points)]; conditions: [(on, condition, value or None)]; refine: [(point, size, distance)]."""
    out = []
    write_comment(out, title)
    out += [f'title = "{title}"', "", "[geometry]", f"box = {points_text(box)}", ""]
    for kind, items in (("polygon", polygons), ("line", lines)):
        for name, points in items:
            out += [f"[[geometry.{kind}]]", f'name = "{name}"', f"points = {points_text(points)}", ""]
    out += ["[mesh]", f"size = {number(size)}", ""]
    for near, finer, distance in refine:
        out += ["[[mesh.refine]]", f"near = {points_text(near)}", f"size = {number(finer)}",
                f"distance = {number(distance)}", ""]
    for name, _ in polygons:
        pairs = curve[name] if isinstance(curve, dict) else curve
        last = pairs[-1][0]
        out += [f"[materials.{name}]", 'model = "linear_elastic"', "grain_density = 2650", "porosity = 0.4",
                'young_modulus = "20 MPa"', "poisson_ratio = 0.3", "", f"[materials.{name}.water]", 'retention = "linear"',
                "minimum_saturation = 0.1", f"dry_suction = {number(last)}", f'conductivity = "{number(conductivity[name])} m/s"',
                'relative_conductivity = "table"', f"conductivity_table = {points_text(pairs)}", ""]
    out += ["[regions]"] + [f'{name} = "{name}"' for name, _ in polygons] + [""]
    for on, condition, value in conditions:
        out += ["[[hydraulic]]", f'on = "{on}"', f'condition = "{condition}"']
        if condition in ("total_head", "pressure"):
            out.append(f"{'head' if condition == 'total_head' else 'pressure'} = {number(value)}")
        elif value is not None:
            out.append(f'rate = "{number(value)} m/s"')
        out.append("")
    out += ["[[boundary]]", 'on = "bottom"', 'fix = "full"', "", "[initial]", 'stress = "k0"', 'pore_pressure = "seepage"', ""]
    out += ["# The flow is steady from the start; a moment of motion is calculated so that there are results.", "[[stage]]",
            'name = "moment"', "duration = 1e-9", ""]
    return "\n".join(out)
