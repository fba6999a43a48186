# SPDX-License-Identifier: MIT
"""Equivalent descriptions of a slope: case files as nested tables, and changes that must not affect the results."""
from __future__ import annotations

import copy
import json
import math
import re
import tomllib

from .problem import FOOT, PCF, PSF

# Lengths that a case file gives as plain numbers [m]; every other quantity is a text with its unit.
PLACES = {"points", "water_table", "x", "box", "near", "at", "exit", "entry", "corners", "centre", "ends", "heads"}
LEVELS = {"head", "cohesion_level", "undrained_level", "levels"}
LENGTHS = {"smallest_depth", "size", "depth", "water", "distance", "radius", "thickness"}
# unit → (its dimension in masses, lengths and times, the unit of practice, SI of one over SI of the other)
UNITS = {
    "m": ((0, 1, 0), "ft", 1 / FOOT),
    "kPa": ((1, -1, -2), "psf", 1e3 / PSF),
    "MPa": ((1, -1, -2), "psi", 1e6 / (144 * PSF)),
    "kN/m3": ((1, -2, -2), "pcf", 1e3 / PCF),
    "kPa/m": ((1, -2, -2), "psf/ft", 1e3 / PCF),
    "kPa-1": ((-1, 1, 2), "ft2/lbf", PSF / 1e3),
    "m/s": ((0, 1, -1), "ft/s", 1 / FOOT),
    "mm/h": ((0, 1, -1), "in/h", 1 / 25.4),
    "s": ((0, 0, 1), "s", 1),
    "day": ((0, 0, 1), "day", 1),
}

def read_case(text):
    return tomllib.loads(text)


def write_value(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {write_value(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(write_value, value)) + "]"
    return repr(value) if isinstance(value, float) else json.dumps(value, ensure_ascii=False)


def write_case(case):
    return "".join(f"{json.dumps(key)} = {write_value(value)}\n" for key, value in case.items())


def change_leaves(value, change, key=""):
    """The tables with change(key, leaf) in the place of every number, and of every text with a unit."""
    if isinstance(value, dict):
        return {k: change_leaves(v, change, k) for k, v in value.items()}
    if isinstance(value, list):
        return [change_leaves(v, change, key) for v in value]
    return value if isinstance(value, bool) else change(key, value)


def split_quantity(leaf):
    """(number, unit) of a text such as "18 kN/m3"; None of anything else."""
    parts = re.fullmatch(r"\s*([-+0-9.eE]+) (\S+)\s*", leaf) if isinstance(leaf, str) else None
    return (float(parts[1]), parts[2]) if parts and parts[2] in UNITS else None


def change_points(case, change):
    """Every place of the section through change(x, y); rows of time and head have their head changed."""
    def walk(value, key):
        if isinstance(value, dict):
            return {k: walk(v, k) for k, v in value.items()}
        if key in ("x", "exit", "entry") or (key == "ends" and isinstance(value[0], (int, float))):
            return [change(x, 0)[0] for x in value]
        if key in PLACES:
            return list(change(*value)) if isinstance(value[0], (int, float)) else [list(change(*point)) for point in value]
        if key in LEVELS:
            if isinstance(value, list):
                return [[time, change(0, head)[1]] for time, head in value]
            return change(0, value)[1]
        return [walk(v, key) for v in value] if isinstance(value, list) else value
    return walk(copy.deepcopy(case), "")


def move(case, by_x, by_y):
    return change_points(case, lambda x, y: (round(x + by_x, 9), round(y + by_y, 9)))


def mirror(case):
    """The image at x = 0: lines that run to the right do so again, sides change their names."""
    case = change_points(case, lambda x, y: (-x, y))
    for load in case.get("surcharge", []):
        load["x"].reverse()
        load["load"].reverse()
    for table in (case.get("initial", {}), case.get("lem", {}).get("drawdown", {})):
        if "water_table" in table:
            table["water_table"].reverse()
    for surface in case.get("lem", {}).get("surface", []):
        surface.get("points", []).reverse()
    if "box" in case["geometry"]:
        (a, low), (b, high) = case["geometry"]["box"]
        case["geometry"]["box"] = [[b, low], [a, high]]
    sides = {"left": "right", "right": "left"}
    for key in ("boundary", "hydraulic", "traction"):
        for entry in case.get(key, []):
            entry["on"] = sides.get(entry["on"], entry["on"])
    for key in ("exit", "entry"):
        case.get("lem", {}).get("entry_exit", {}).get(key, []).reverse()
    return case


def turn_outlines(case):
    """Polygons in the opposite order, each from another corner, every other one the other way round."""
    case = copy.deepcopy(case)
    for number, polygon in enumerate(case["geometry"]["polygon"]):
        points = polygon["points"]
        start = (number + 2) % len(points)
        polygon["points"] = points[start:] + points[:start]
        if number % 2 == 0:
            polygon["points"].reverse()
    case["geometry"]["polygon"].reverse()
    case["regions"] = dict(reversed(case["regions"].items()))
    case["materials"] = dict(reversed(case["materials"].items()))
    return case


def cut_ring(ring, at, keep_left):
    """The part of a polygon on one side of the vertical x = at."""
    part = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        inside = ax <= at if keep_left else ax >= at
        if inside:
            part.append([ax, ay])
        if (ax - at) * (bx - at) < 0:
            (px, py), (qx, qy) = sorted(((ax, ay), (bx, by)))  # one number for both neighbours of an edge
            part.append([at, round(py + (qy - py) * (at - px) / (qx - px), 9)])
    return part


def split_soils(case):
    """Every soil twice, with equal numbers: on either side of a vertical through the middle of the section."""
    case = copy.deepcopy(case)
    xs = [x for polygon in case["geometry"]["polygon"] for x, _ in polygon["points"]]
    at = round(0.5 * (min(xs) + max(xs)), 3)
    polygons = []
    for polygon in case["geometry"]["polygon"]:
        material = case["regions"].pop(polygon["name"])
        for side, keep_left in (("west", True), ("east", False)):
            part = cut_ring(polygon["points"], at, keep_left)
            if len(part) < 3 or len({x for x, _ in part}) < 2:
                continue
            name = f"{polygon['name']}_{side}"
            polygons.append({"name": name, "points": part})
            case["regions"][name] = f"{material}_{side}"
            case["materials"][f"{material}_{side}"] = copy.deepcopy(case["materials"][material])
    for material in [m for m in case["materials"] if m not in case["regions"].values()]:
        del case["materials"][material]
    case["geometry"]["polygon"] = polygons
    return case


def add_points(case):
    """A point in every edge of the outlines and of the water table, at fractions of its length that are not round numbers."""
    case = copy.deepcopy(case)

    def refine(points, closed):
        refined = []
        for (ax, ay), (bx, by) in zip(points, points[1:] + (points[:1] if closed else [])):
            (px, py), (qx, qy) = sorted(((ax, ay), (bx, by)))
            t = 0.381966
            refined += [[ax, ay], [px + t * (qx - px), py + t * (qy - py)]]
        return refined if closed else refined + [points[-1]]

    for polygon in case["geometry"]["polygon"]:
        polygon["points"] = refine(polygon["points"], True)
    if "water_table" in case.get("initial", {}):
        case["initial"]["water_table"] = refine(case["initial"]["water_table"], False)
    return case


def rename(case):
    """Other names of soils, polygons, loads and lines, which sort the other way round."""
    case = copy.deepcopy(case)
    materials = {name: f"z{99 - number}_{name[::-1]}" for number, name in enumerate(case["materials"])}
    polygons = {polygon["name"]: f"{'yx'[number % 2]}{50 - number}" for number, polygon in enumerate(case["geometry"]["polygon"])}
    case["materials"] = {materials[name]: soil for name, soil in case["materials"].items()}
    case["regions"] = {polygons[name]: materials[soil] for name, soil in case["regions"].items()}
    for polygon in case["geometry"]["polygon"]:
        polygon["name"] = polygons[polygon["name"]]
    loads = {load["name"]: f"w{9 - number}" for number, load in enumerate(case.get("surcharge", []))}
    for load in case.get("surcharge", []):
        load["name"] = loads[load["name"]]
    for stage in case.get("construction", []):
        stage["add"] = [loads[name] for name in stage.get("add", [])]
    lines = {line["name"]: f"v{9 - number}" for number, line in enumerate(case["geometry"].get("line", []))}
    for line in case["geometry"].get("line", []):
        line["name"] = lines[line["name"]]
    for key in ("boundary", "hydraulic", "traction"):
        for entry in case.get(key, []):
            entry["on"] = lines.get(entry["on"], entry["on"])
    return case


def to_practice(case):
    """Feet, pounds and inches."""
    def change(key, leaf):
        quantity = split_quantity(leaf)
        if quantity:
            _, unit, factor = UNITS[quantity[1]]
            return f"{quantity[0] * factor!r} {unit}"
        if key in PLACES | LEVELS | LENGTHS and isinstance(leaf, (int, float)):
            return f"{leaf / FOOT!r} ft"
        return leaf
    return change_leaves(case, change)


def enlarge(case, times):
    """All lengths so much larger, and every other quantity by its dimension, with densities and gravity as they are."""
    mass, length, time = times**3, times, math.sqrt(times)

    def change(key, leaf):
        quantity = split_quantity(leaf)
        if quantity:
            m, l, t = UNITS[quantity[1]][0]
            return f"{quantity[0] * mass**m * length**l * time**t!r} {quantity[1]}"
        if key in PLACES | LEVELS | LENGTHS and isinstance(leaf, (int, float)):
            return leaf * times
        return leaf
    return change_leaves(case, change)


STRONGER = 1.25


def strengthen(case):
    """Cohesion and tan φ of all soils so much larger: so is every factor."""
    case = copy.deepcopy(case)
    for soil in case["materials"].values():
        number, unit = split_quantity(soil["cohesion"])
        soil["cohesion"] = f"{STRONGER * number!r} {unit}"
        soil["friction_angle"] = math.degrees(math.atan(STRONGER * math.tan(math.radians(soil["friction_angle"]))))
    return case


# name in the table → the change of the case; and how many times as large it is
CHANGES = {
    "x + 500 km": lambda case: move(case, 5e5, 0),
    "x + 500 km, y + 4,000 km": lambda case: move(case, 5e5, 4e6),
    "y + 200 m": lambda case: move(case, 0, 200),
    "y + 300 m": lambda case: move(case, 0, 300),
    "y + 850 m": lambda case: move(case, 0, 850),
    "mirrored": mirror,
    "outlines turned": turn_outlines,
    "soils split": split_soils,
    "points added": add_points,
    "renamed": rename,
    "US units": to_practice,
    "10 times as large": lambda case: enlarge(case, 10),
    "16 times as large": lambda case: enlarge(case, 16),
}
SIZES = {"10 times as large": 10, "16 times as large": 16}
