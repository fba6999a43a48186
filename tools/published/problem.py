# SPDX-License-Identifier: MIT
"""A published problem of the limit-equilibrium kind, read from its JSON entry into metres, newtons and degrees."""
from __future__ import annotations

from dataclasses import dataclass, field

from .layers import extend_line, split_layers

FOOT = 0.3048
PSF = 47.880258980336  # lbf/ft² in Pa
PCF = 157.08746385  # lbf/ft³ in N/m³

# method of the file → method of the case file
METHODS = {
    "oms": "fellenius",
    "bishop": "bishop",
    "janbu": "janbu",
    "janbu_corr": "janbu_corrected",
    "spencer": "spencer",
    "mp": "morgenstern_price",
}
# whose factor a published value without the name of a method is compared with
RIGOROUS = ("bishop", "spencer", "mp")
# other names of the same methods among the published values
ALIASES = {"janbu_corrected": "janbu_corr", "gle": "mp", "morgenstern_price": "mp", "fellenius": "oms"}

KNOWN = {
    "id", "title", "units", "ground", "ground_full", "materials", "material", "base_elev", "layer_lines", "polygons", "piezo",
    "mirror", "extend", "search_exit", "search_entry", "dloads", "tension_crack", "circles", "surfaces", "composite", "mindepth",
    "kh", "kv", "nsearch", "ru", "published", "recomputed", "source", "notes", "caveat", "recomputed_fem_srm_bracket",
    "log_spiral_upper_bound", "seepage_bc", "search", "drawdown", "supports",
}


@dataclass
class Units:
    """Units of the problem: their value in SI, and the text of a stress or a unit weight in a case file."""

    imperial: bool
    length: float
    stress: float
    weight: float
    stress_name: str
    weight_name: str
    gradient_name: str
    water_weight: float

    @staticmethod
    def choose(name):
        if str(name).lower().startswith("imp"):
            return Units(True, FOOT, PSF, PCF, "lbf/ft2", "lbf/ft3", "lbf/ft3", 62.4)
        return Units(False, 1.0, 1e3, 1e3, "kPa", "kN/m3", "kPa/m", 9.81)


@dataclass
class Problem:
    """Lengths in metres; strengths and weights as given, in the units of `units`."""

    entry: dict
    units: Units
    ground: list
    regions: list  # (name, material index, ring)
    materials: list
    water_table: list
    base: float
    unknown: list = field(default_factory=list)  # keys that are not of the schema

    @property
    def id(self):
        return self.entry["id"]

    def scale(self, points):
        return [tuple(round(v * self.units.length, 9) for v in p) for p in points]


def clean_name(text, taken):
    """A bare TOML key that no other soil has."""
    name = "".join(c if c.isascii() and (c.isalnum() or c in "_-") else "_" for c in text.strip().lower()) or "soil"
    unique, number = name, 2
    while unique in taken:
        unique, number = f"{name}_{number}", number + 1
    return unique


def read_problem(entry):
    units = Units.choose(entry.get("units", "SI"))
    ground = [tuple(p) for p in entry.get("ground_full") or entry["ground"]]
    if ground[0][0] > ground[-1][0]:
        ground.reverse()
    if entry.get("extend"):
        ground = extend_line(ground, min(entry["extend"]), max(entry["extend"]))
    base = entry.get("base_elev", min(y for _, y in ground))
    materials = [dict(m) for m in entry.get("materials") or [entry["material"]]]
    taken = set()
    for number, material in enumerate(materials):
        material["key"] = clean_name(material.get("name", f"soil_{number + 1}"), taken)
        taken.add(material["key"])
        material.setdefault("ru", entry.get("ru", 0))
    if entry.get("polygons"):
        rings = [(m, [tuple(p) for p in ring]) for m, ring in entry["polygons"]]
        rings = [(m, ring[:-1] if ring[0] == ring[-1] else ring) for m, ring in rings]
    else:
        rings = split_layers(ground, base, entry.get("layer_lines") or [[0, ground]])
    problem = Problem(entry, units, [], [], materials, [], base * units.length)
    problem.ground = problem.scale(ground)
    count = {}
    for material, ring in rings:
        key = materials[material]["key"]
        count[key] = count.get(key, 0) + 1
        problem.regions.append((key if count[key] == 1 else f"{key}_{count[key]}", material, problem.scale(ring)))
    if entry.get("piezo"):
        problem.water_table = problem.scale(sorted(entry["piezo"], key=lambda p: p[0]))
    problem.unknown = sorted(set(entry) - KNOWN)
    return problem


def cut_strip(strip, left, right):
    """The part of a load, [(x, q)], between two x."""
    strip = sorted(strip, key=lambda p: p[0])
    cut = [p for p in strip if left <= p[0] <= right]
    for x in (left, right):
        for (ax, aq), (bx, bq) in zip(strip, strip[1:]):
            if ax < x < bx:
                cut.append((x, aq + (bq - aq) * (x - ax) / (bx - ax)))
    return sorted(cut, key=lambda p: p[0])


def read_strips(problem):
    """Surcharges: lists of (x [m], load in the problem's unit of stress), as far as the ground goes."""
    loads = problem.entry.get("dloads") or []
    if loads and not isinstance(loads[0][0], (list, tuple)):
        loads = [loads]
    left, right = problem.ground[0][0], problem.ground[-1][0]
    strips = [cut_strip([(round(x * problem.units.length, 9), q) for x, q in strip], left, right) for strip in loads]
    return [strip for strip in strips if len(strip) > 1]


def read_given_surfaces(problem):
    """[(name, {"circle": (xc, yc, R), "ends": [a, b]} or {"points": …})] of every surface whose factor is known."""
    entry, scale = problem.entry, problem.units.length
    found = []

    def add_circle(name, values):
        values = [v * scale for v in values]
        found.append((name, {"circle": tuple(round(v, 9) for v in values[:3]), "ends": sorted(round(v, 9) for v in values[3:5])}))

    for number, circle in enumerate(entry.get("circles") or []):
        add_circle(f"circle{number}", circle)
    for number, points in enumerate(entry.get("surfaces") or []):
        found.append((f"surface{number}", {"points": sorted(problem.scale(points))}))
    recomputed = entry.get("recomputed") or {}
    for name, fixed in (recomputed.get("fixed_circle_400_slices") or {}).items():
        values = [fixed["xc"], fixed["yc"], fixed["R"]]
        if "x_exit" in fixed and "x_entry" in fixed:
            values += [fixed["x_exit"], fixed["x_entry"]]
        add_circle(name, values)
    return found


def find_published(problem, method):
    """(lowest, highest) of the published values of a method of the file; None without any."""
    values = []
    for answers in (problem.entry.get("published") or {}).values():
        if not isinstance(answers, dict):
            answers = {"any": answers}
        for name, value in answers.items():
            if ALIASES.get(name, name) == method or (name == "any" and method in RIGOROUS):
                values += value if isinstance(value, list) else [value]
    values = [v for v in values if isinstance(v, (int, float))]
    return (min(values), max(values)) if values else None
