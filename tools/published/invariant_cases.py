# SPDX-License-Identifier: MIT
"""Random slopes as cases for each method, small enough to be calculated in a dozen ways, and what is compared of their results."""
from __future__ import annotations

import math
import random
import re

from .case_file import make_case
from .problem import read_problem
from .random_slopes import draw_slope
from .rewritten import UNITS, read_case

# method → on every how many-th slope it runs
EVERY = {"lem": 1, "seepage": 5, "fem": 10, "timeline": 10, "mpm": 10, "bounds": 10, "supports": 20, "walls": 20, "stages": 20}
# the changes of rewritten.py for what has supports, walls or stages; the other kinds have all
FEW_CHANGES = ("x + 500 km", "y + 200 m", "mirrored", "renamed")
FEW = ("supports", "walls", "stages")
POLYLINES = 20  # the same for critical polylines
SLICES = 30
TRIALS = {"exits": 8, "entries": 8, "depths": 6}


def draw_case(number, entry=None, finite_elements=False):
    """The slope with corners to the micrometre, as a drawing has them; and its height."""
    entry = entry or draw_slope(number)
    case = read_case(make_case(read_problem(entry), SLICES, noncircular=number % POLYLINES == 0, finite_elements=finite_elements))
    for polygon in case["geometry"]["polygon"]:
        polygon["points"] = [[round(x, 6), round(y, 6)] for x, y in polygon["points"]]
    return case, entry["ground"][2][1]


def add_surfaces(case, entry):
    """A circle and a polyline under the face."""
    (x1, y1), (x2, y2) = entry["ground"][1:3]
    height = y2 - y1
    foot = x1 + 0.1 * (x2 - x1)
    case["lem"]["surface"] = [
        {"name": "circle", "centre": [round(0.5 * (x1 + x2), 3), round(y2 + 0.9 * height, 3)], "radius": round(1.75 * height, 3)},
        {"name": "line", "points": [[round(foot, 3), round(y1 + 0.1 * height, 9)], [round(0.6 * x1 + 0.4 * x2, 3), round(y1 + 0.1 * height, 3)],
                                    [x2, round(y1 + 0.45 * height, 3)], [round(x2 + 0.8 * height, 3), y2]]}]
    x = case["lem"]["surface"][1]["points"][0][0]
    case["lem"]["surface"][1]["points"][0][1] = round(y1 + height * (x - x1) / (x2 - x1), 9)


def make_lem(number):
    case, height = draw_case(number)
    # The default is 0.5 m on high slopes, which a larger slope would not share.
    case["lem"].update(smallest_depth=round(0.02 * height, 4), entry_exit=TRIALS, minima=2)
    if case["lem"]["noncircular"]:
        case["lem"]["vertices"] = 8
    add_surfaces(case, draw_slope(number))
    return case


def add_box(case, height):
    points = [p for polygon in case["geometry"]["polygon"] for p in polygon["points"]]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    case["geometry"]["box"] = [[min(xs), min(ys)], [max(xs), round(max(ys) + 0.5 * height, 3)]]


def trace_ground(case, ground):
    """The ground with the corners of all polygons that lie on it up to rounding."""
    def is_on_it(x, y):
        return any(a <= x <= b and abs(ya + (yb - ya) * (x - a) / (b - a) - y) < 1e-5 for (a, ya), (b, yb) in zip(ground, ground[1:]))
    corners = {(x, y) for polygon in case["geometry"]["polygon"] for x, y in polygon["points"] if is_on_it(x, y)}
    return [list(corner) for corner in sorted(corners)]


def add_flow(case, entry, rng):
    """Water in every soil, heads at both sides, rain on the ground or none."""
    height = entry["ground"][2][1]
    for soil in case["materials"].values():
        soil.update(porosity=round(rng.uniform(0.3, 0.45), 3), water={
            "retention": "van_genuchten", "minimum_saturation": 0.1, "reference_pressure": f"{rng.uniform(5, 40):.3f} kPa",
            "lambda": round(rng.uniform(0.3, 0.5), 3), "relative_conductivity": "mualem", "measure": "effective", "air_entry": "0.5 kPa",
            "conductivity": f"{10 ** rng.uniform(-6.5, -4.5):.4e} m/s", "compressibility": "0.0001 kPa-1"})
    case["water"] = {"bulk_modulus": "2200000 kPa"}
    case["mesh"] = {"size": round(height / 8, 3)}
    add_box(case, height)
    case["geometry"]["line"] = [{"name": "ground", "points": trace_ground(case, entry["ground"])}]
    case["initial"] = {"pore_pressure": "seepage"}
    case["hydraulic"] = [{"on": "left", "condition": "total_head", "head": round(rng.choice((-0.1, -0.2)) * height, 3)},
                         {"on": "right", "condition": "total_head", "head": round(rng.uniform(0.3, 0.7) * height, 3)}]
    case["lem"].update(methods=["bishop", "spencer"], noncircular=False, smallest_depth=round(0.02 * height, 4),
                       entry_exit=TRIALS, minima=2)
    add_surfaces(case, entry)


def make_seepage(number):
    entry, rng = draw_slope(number), random.Random(5000 + number)
    entry.pop("piezo", None)
    for soil in entry["materials"]:
        soil.pop("gamma_sat", None)
    case, _ = draw_case(number, entry)
    add_flow(case, entry, rng)
    if rng.random() < 0.5:
        case["hydraulic"].append({"on": "ground", "condition": "rain", "rate": f"{rng.uniform(0.1, 2):.3f} mm/h"})
    return case


def make_timeline(number):
    case, rng = make_seepage(number), random.Random(7000 + number)
    case["hydraulic"] = case["hydraulic"][:2] + [{
        "on": "ground", "condition": "rain", "series": "steps", "suction_limit": "300 kPa",
        "rate": [["0 day", "2 mm/h"], ["1 day", f"{rng.uniform(3, 15):.3f} mm/h"], ["2 day", "0 mm/h"]]}]
    case["mesh"] = {"size": round(draw_slope(number)["ground"][2][1] / 4, 3)}
    case["timeline"] = {"duration": "3 day", "times": ["1 day", "2 day", "3 day"]}
    case["lem"]["methods"] = ["bishop"]
    return case


def make_fem(number):
    case, height = draw_case(number, finite_elements=True)
    del case["lem"]
    case["analysis"]["methods"] = ["fem"]
    case["fem"] = {"flow": "associated", "size": round(height / 4, 3), "meshes": 2, "resolution": 0.01}
    return case


def make_bounds(number):
    case, height = draw_case(number, finite_elements=True)
    del case["lem"], case["fem"]
    case["analysis"]["methods"] = ["bounds"]
    case["bounds"] = {"gap": 0.5, "triangles": 100, "size": round(height / 2, 3)}
    return case


def make_mpm(number):
    """Gravity on soil that does not yield: where it does, rounding grows without limit in any explicit step."""
    case, height = draw_case(number, finite_elements=True)
    del case["lem"], case["fem"]
    case["analysis"]["methods"] = ["mpm"]
    add_box(case, height)
    case["mesh"] = {"size": round(height / 4, 3)}
    case["boundary"] = [{"on": "bottom", "fix": "full"}, {"on": "left", "fix": "normal"}, {"on": "right", "fix": "normal"}]
    second = math.sqrt(height / 10)
    case["stage"] = [{"name": "gravity", "duration": f"{2 * second:.4f} s", "damping": 0.5, "gravity_ramp": f"{second:.4f} s",
                      "cohesion": "2000 kPa"}]
    ground = draw_slope(number)["ground"]
    case["output"] = {"monitor": [{"name": "crest", "at": list(ground[2])}, {"name": "toe", "at": list(ground[1])}]}
    return case


def make_supports(number):
    """Two rows of nails in the face, by LEM with polylines and FEM on one mesh."""
    case, height = make_fem(number), draw_slope(number)["ground"][2][1]
    (x1, y1), (x2, y2) = draw_slope(number)["ground"][1:3]
    places = [round(x1 + t * (x2 - x1), 6) for t in (0.4, 0.7)]
    heads = [[x, y1 + (y2 - y1) * (x - x1) / (x2 - x1)] for x in places]
    case["support"] = {"nails": {
        "kind": "nail", "heads": heads, "ends": [[round(x + 0.8 * height, 6), round(y - 0.2 * height, 6)] for x, y in heads],
        "out_of_plane_spacing": 1.5, "tensile_strength": "150 kN", "plate": "70 kN", "bond": "25 kN/m", "axial_stiffness": "40000 kN"}}
    case["analysis"]["methods"] = ["lem", "fem"]
    case["fem"]["meshes"] = 1
    case["lem"] = {"methods": ["bishop", "spencer"], "slices": SLICES, "vertices": 8, "entry_exit": TRIALS, "minima": 2,
                   "smallest_depth": round(0.02 * height, 4)}
    return case


def make_walls(number):
    """A wall from the face down, by FEM on two meshes."""
    case, height = make_fem(number), draw_slope(number)["ground"][2][1]
    (x1, _), (x2, _) = draw_slope(number)["ground"][1:3]
    case["support"] = {"sheet": {
        "kind": "wall", "x": [round(x1 + 0.3 * (x2 - x1), 3)], "length": round(0.6 * height, 3), "interface_strength": 0.67,
        "axial_stiffness": "2e6 kN", "bending_stiffness": 5e4, "plastic_moment": 180}}
    return case


def make_stages(number):
    """A load on the crest in the second of two drained stages, by FEM on one mesh."""
    case, height = make_fem(number), draw_slope(number)["ground"][2][1]
    x = draw_slope(number)["ground"][2][0]
    case["surcharge"] = [{"name": "fill", "x": [round(x + 0.2 * height, 3), round(x + height, 3)], "load": ["20 kPa", "20 kPa"]}]
    case["fem"]["meshes"] = 1
    case["construction"] = [{"name": "before", "drainage": "drained", "duration": 1},
                            {"name": "after", "drainage": "drained", "duration": 1, "add": ["fill"]}]
    return case


MAKE = {"lem": make_lem, "seepage": make_seepage, "timeline": make_timeline, "fem": make_fem, "bounds": make_bounds, "mpm": make_mpm,
        "supports": make_supports, "walls": make_walls, "stages": make_stages}


def measure_unit(unit, times):
    """How much larger a quantity of this unit is where all lengths are so much larger, with densities and gravity as they are."""
    dimensions = {"m": (0, 1, 0), "mm": (0, 1, 0), "s": (0, 0, 1), "day": (0, 0, 1), **{name: u[0] for name, u in UNITS.items()}}
    power = 0.0
    for number, part in enumerate(unit.split("/") if unit not in dimensions else [unit]):
        name, exponent = (part, 1) if part in dimensions else (re.match(r"[A-Za-z]+", part)[0], int(re.search(r"\d+", part)[0]))
        m, l, t = dimensions[name]
        power += (exponent if number == 0 else -exponent) * (3 * m + l + 0.5 * t)
    return times**power


def read_results(kind, summary, times=1):
    """Name → value of what is compared, brought back to the size of the slope as it was drawn; and the intervals of its factors."""
    values, intervals = {}, {}
    for result in summary["results"]:
        name, unit = result["name"], result["unit"]["name"]
        if result["value"] is None or not is_compared(kind, name):
            continue
        if name.startswith("timeline.factor["):  # by its number: times differ with the size
            name = f"timeline.factor[{sum(key.startswith('timeline.factor[') for key in values)}]"
        values[name] = result["value"] / (measure_unit(unit, times) if unit else 1)
    if kind == "seepage":  # by number, since lines may have other names; both flows, since their difference may be small
        for i, side in enumerate(summary["seepage"]["discharges"]):
            for flow in ("inflow", "outflow"):
                values[f"seepage.discharge[{i}].{flow}"] = side[flow] / measure_unit("m3/s/m", times)
    if kind == "bounds" and summary["bounds"].get("lower") and summary["bounds"].get("upper"):
        values["bounds.lower"], values["bounds.upper"] = summary["bounds"]["lower"], summary["bounds"]["upper"]
        intervals["bounds"] = (summary["bounds"]["lower"], summary["bounds"]["upper"])
    for run in (summary.get("fem") or {}).get("runs", []):
        if run.get("interval"):
            intervals["fem"] = (run["interval"]["lower"], run["interval"]["upper"])
    return values, intervals


def is_compared(kind, name):
    starts = {"lem": "lem.", "seepage": "lem.surface", "timeline": "timeline.factor", "fem": "fem.associated.factor",
              "mpm": ("displacement", "stage["), "bounds": "bounds.", "supports": ("lem.bishop", "lem.spencer", "lem.noncircular", "fem.associated.factor"), "walls": "fem.associated.factor",
              "stages": "construction."}[kind]
    return name.startswith(starts) and name != "lem.factor" and not name.endswith(".time")


def group(kind, name):
    """The column of the table that a result belongs to."""
    if kind != "lem" and not (kind == "supports" and name.startswith("lem.")):
        return kind
    return "given surfaces" if ".surface[" in name else "polylines" if ".noncircular." in name else "circles"
