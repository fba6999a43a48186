# SPDX-License-Identifier: MIT
"""Writes a published problem as a Talus case file that an engineer can read."""
from __future__ import annotations

import json
import math
import textwrap

from .problem import METHODS, read_given_surfaces, read_strips


def number(value):
    """As short as it is exact."""
    value = float(value)
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(value)


def points_text(points, indent="  "):
    pairs = [f"[{number(x)}, {number(y)}]" for x, y in points]
    line = "[" + ", ".join(pairs) + "]"
    if len(line) <= 100:
        return line
    return "[\n" + textwrap.fill(", ".join(pairs), 110, initial_indent=indent, subsequent_indent=indent,
                                 break_long_words=False, break_on_hyphens=False) + ",\n]"


def quantity(value, unit):
    return json.dumps(f"{number(value)} {unit}")


def write_comment(lines, text):
    for line in textwrap.wrap(text, 116):
        lines.append(f"# {line}")


def write_header(lines, problem):
    entry = problem.entry
    write_comment(lines, f"{entry['id']}: {entry.get('title', '')}")
    for key in ("notes", "caveat"):
        if entry.get(key):
            write_comment(lines, f"{key.capitalize()}: {entry[key]}")
    if entry.get("source"):
        write_comment(lines, f"Source: {entry['source']}")
    if problem.units.imperial:
        lines.append("# Given in feet and pounds: lengths stand here in metres, strengths and weights as they were given.")
    lines += [f"title = {json.dumps(entry['id'] + ': ' + entry.get('title', ''), ensure_ascii=False)}", ""]


def write_geometry(lines, problem):
    for name, _, ring in problem.regions:
        lines += ["[[geometry.polygon]]", f'name = "{name}"', f"points = {points_text(ring)}", ""]
    lines.append("[regions]")
    lines += [f'{name} = "{problem.materials[material]["key"]}"' for name, material, _ in problem.regions]
    lines.append("")


def write_history(lines, material):
    """Undrained strengths of a profile or a stress history [kPa, m]."""
    lines.append(f'model = "{"shansep" if material.get("strength_ratio") else "tresca"}"')
    for key in ("strength_ratio", "strength_exponent", "added_strength", "ocr", "profile_depths", "profile_levels", "profile_strengths",
                "profile_preconsolidation"):
        if material.get(key) is not None:
            value = material[key]
            lines.append(f"{key} = [{', '.join(map(number, value))}]" if isinstance(value, list) else f"{key} = {number(value)}")


def write_strength(lines, problem, material):
    """Model and strength of a soil; the words of its [materials.NAME]."""
    units, c, phi = problem.units, material.get("c", 0), material.get("phi", 0)
    if material.get("elastic"):
        lines.append('model = "linear_elastic"')
    elif material.get("strength_ratio") or material.get("profile_strengths"):
        write_history(lines, material)
    elif material.get("table"):
        lines.append('model = "strength_table"')
        lines += [f"{key} = [{', '.join(map(number, values))}]" for key, values in zip(("normal_stresses", "shear_strengths"), material["table"])]
    elif material.get("bedding"):
        angle, cohesion, friction = material["bedding"]
        lines += ['model = "bedding"', f"cohesion = {quantity(c, units.stress_name)}", f"friction_angle = {number(phi)}", f"bedding_angle = {number(angle)}",
                  f"bedding_cohesion = {quantity(cohesion, units.stress_name)}", f"bedding_friction = {number(friction)}", "bedding_range = 5"]
    elif material.get("power"):
        factor, exponent, shift = material["power"]
        lines += ['model = "power_curve"', f"power_factor = {number(factor)}", f"power_exponent = {number(exponent)}"]
        lines += [f"power_shift = {quantity(shift, units.stress_name)}"] if shift else []
    elif material.get("hoek_brown"):
        strength, gsi, constant = material["hoek_brown"]
        lines += ['model = "hoek_brown"', f"intact_strength = {quantity(strength, 'MPa')}", f"gsi = {number(gsi)}", f"intact_constant = {number(constant)}"]
    elif c or phi or material.get("cu_rate_per_depth"):
        lines += ['model = "mohr_coulomb"', f"cohesion = {quantity(c, units.stress_name)}", f"friction_angle = {number(phi)}"]
        if material.get("cu_rate_per_depth"):
            lines += [f"cohesion_gradient = {quantity(material['cu_rate_per_depth'], units.gradient_name)}",
                      f"cohesion_level = {number(round(material['cu_ref_elev'] * units.length, 9))}"]
    else:
        lines.append('model = "no_strength"')


def write_stiffness(lines, problem, material, largest_tension):
    """What FEM needs besides. Tensile strength: up to the apex, or not above c where `largest_tension` is "cohesion"."""
    c, phi = material.get("c", 0), material.get("phi", 0)
    lines += ['young_modulus = "100 MPa"', "poisson_ratio = 0.3"]
    if material.get("elastic"):
        return
    if material.get("strength_ratio") or material.get("profile_strengths"):
        return
    if material.get("power") or material.get("hoek_brown") or material.get("table"):
        lines.append("dilatancy_ratio = 0")
    elif c or phi or material.get("cu_rate_per_depth"):
        apex = c / math.tan(math.radians(phi)) if phi > 0 else 10 * c
        remark = "the apex: no tension cut-off" if phi > 0 else "far off: no tension cut-off"
        if largest_tension == "cohesion" and c < apex:
            apex, remark = c, "as large as the cohesion"
        lines += ["dilatancy_angle = 0",
                  f"tensile_strength = {quantity(round(apex * (1 - 1e-9), 9), problem.units.stress_name)}  # {remark}"]


def write_materials(lines, problem, stiffness, largest_tension="apex"):
    units = problem.units
    for material in problem.materials:
        lines.append(f"[materials.{material['key']}]")
        write_strength(lines, problem, material)
        lines.append(f"unit_weight = {quantity(material['gamma'], units.weight_name)}")
        if material.get("gamma_sat"):
            lines.append(f"saturated_unit_weight = {quantity(material['gamma_sat'], units.weight_name)}")
        if material.get("ru"):
            lines.append(f"pore_pressure_ratio = {number(material['ru'])}")
        if stiffness:
            write_stiffness(lines, problem, material, largest_tension)
        if material.get("envelope"):
            envelope = material["envelope"]
            lines += ["", f"[materials.{material['key']}.undrained_envelope]", f"cohesion = {quantity(envelope['c'], units.stress_name)}",
                      f"friction_angle = {number(envelope['phi'])}"]
        lines.append("")


def write_loads(lines, problem):
    entry, units = problem.entry, problem.units
    if units.imperial and problem.water_table:
        lines += ["[water]", f"density = {number(round(62.4 * 157.08746385 / 9.81, 6))}  # 62.4 lbf/ft3", ""]
    if problem.water_table:
        lines += ["[initial]", 'pore_pressure = "water_table"', f"water_table = {points_text(problem.water_table)}", ""]
    for count, strip in enumerate(read_strips(problem), 1):
        lines += ["[[surcharge]]", f'name = "load_{count}"', f"x = [{', '.join(number(x) for x, _ in strip)}]",
                  f"load = [{', '.join(quantity(q, units.stress_name) for _, q in strip)}]", ""]
    if entry.get("kh") or entry.get("kv"):
        lines.append("[earthquake]")
        lines += [f"{key} = {number(entry[k])}" for k, key in (("kh", "horizontal"), ("kv", "vertical")) if entry.get(k)]
        lines.append("")


# Keys of [support.NAME] that are lengths or points in the unit of the problem.
SUPPORT_POINTS = ("heads", "ends")
SUPPORT_LENGTHS = ("x", "length", "lengths", "out_of_plane_spacing", "diameter", "free_length", "bond_length")


def write_supports(lines, problem):
    scale = problem.units.length
    for name, support in (problem.entry.get("supports") or {}).items():
        lines.append(f"[support.{name}]")
        for key, value in support.items():
            if key in SUPPORT_POINTS:
                value = points_text(problem.scale(value))
            elif key in SUPPORT_LENGTHS:
                scaled = [round(v * scale, 9) for v in (value if isinstance(value, list) else [value])]
                value = f"[{', '.join(number(v) for v in scaled)}]" if isinstance(support[key], list) else number(scaled[0])
            else:
                value = json.dumps(value)
            lines.append(f"{key} = {value}")
        lines.append("")


def write_search_ranges(lines, problem):
    ranges = find_search_ranges(problem)
    if any(ranges):
        lines.append("[lem.entry_exit]")
        lines += [f"{key} = [{number(r[0])}, {number(r[1])}]" for key, r in zip(("exit", "entry"), ranges) if r]
        lines.append("")


def find_search_ranges(problem):
    """Ranges in which circles may leave and enter [m]; from the file, or of the face that the problem means where the ground
    has two of them."""
    entry, length = problem.entry, problem.units.length
    exit_range, entry_range = entry.get("search_exit"), entry.get("search_entry")
    if exit_range or entry_range:
        left, right = problem.ground[0][0], problem.ground[-1][0]
        return tuple([min(max(round(v * length, 9), left), right) for v in sorted(r)] if r else None
                     for r in (exit_range, entry_range))
    heights = [y for _, y in problem.ground]
    rises = any(b > a for a, b in zip(heights, heights[1:]))
    falls = any(b < a for a, b in zip(heights, heights[1:]))
    if not (rises and falls):
        return None, None
    top = max(heights)
    level = [x for x, y in problem.ground if y == top]
    middle, left, right = 0.5 * (level[0] + level[-1]), problem.ground[0][0], problem.ground[-1][0]
    if entry.get("mirror"):
        return [middle, right], [left, level[-1]]
    return [left, middle], [level[0], right]


def write_slices(lines, problem, slices, search, noncircular):
    entry, length = problem.entry, problem.units.length
    lines += ["[lem]", "methods = [" + ", ".join(f'"{m}"' for m in METHODS.values()) + "]", f"slices = {slices}"]
    lines.append(f'search = "{"entry_exit" if search else "none"}"')
    lines.append(f"noncircular = {'true' if noncircular else 'false'}")
    lines += ["yield_acceleration = false", "referee = false"]
    if entry.get("composite"):
        lines.append("composite = true")
    if entry.get("mindepth"):
        lines.append(f"smallest_depth = {number(round(entry['mindepth'] * length, 9))}")
    lines.append("")
    if search:
        write_search_ranges(lines, problem)
    if entry.get("drawdown"):
        line = problem.scale(sorted(entry["drawdown"]["piezo"]))
        lines += ["[lem.drawdown]", f'method = "{entry["drawdown"]["method"]}"', f"water_table = {points_text(line)}", ""]
    if entry.get("tension_crack"):
        crack = entry["tension_crack"]
        lines += ["[lem.tension_crack]", "limit = false  # as deep as published",
                  f"depth = {number(round(crack['depth'] * length, 9))}",
                  f"water = {number(round(crack.get('water', 0) * length, 9))}", ""]


def write_surface(lines, name, surface):
    lines += ["[[lem.surface]]", f'name = "{name}"']
    if "circle" in surface:
        xc, yc, radius = surface["circle"]
        lines += [f"centre = [{number(xc)}, {number(yc)}]", f"radius = {number(radius)}"]
        if surface["ends"]:
            lines.append(f"ends = [{number(surface['ends'][0])}, {number(surface['ends'][1])}]")
    else:
        lines.append(f"points = {points_text(surface['points'])}")
    lines.append("")


def make_case(problem, slices=100, search=True, noncircular=False, surfaces=None, finite_elements=False, largest_tension="apex"):
    """The text of the case file. `surfaces` replaces the surfaces that the problem gives."""
    lines = []
    write_header(lines, problem)
    lines += ["[analysis]", 'methods = ["lem"]', ""]
    write_geometry(lines, problem)
    write_materials(lines, problem, finite_elements, largest_tension)
    write_loads(lines, problem)
    write_supports(lines, problem)
    write_slices(lines, problem, slices, search, noncircular)
    for name, surface in read_given_surfaces(problem) if surfaces is None else surfaces:
        write_surface(lines, name, surface)
    if finite_elements:
        lines += ["[fem]", 'flow = "both"', ""]
    return "\n".join(lines).rstrip() + "\n"
