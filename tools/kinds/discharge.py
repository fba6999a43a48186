# SPDX-License-Identifier: MIT
"""Discharges of sections that end in the soil, against uniform flow, its tensor and conservation."""
import math

from .exits import draw_dam
from .trial import read_results


def draw_sections(trial, inside):
    """Straight and bent lines with random corners; inside(s, t) is a point of the soil with s and t from 0 to 1."""
    sections = []
    for number in range(6):
        if number == 0:  # shorter than an element
            s, t = trial.rng.uniform(0.1, 0.9), trial.rng.uniform(0.1, 0.9)
            points = [inside(s, t), inside(s + 0.008, t + 0.013)]
        else:
            points = [inside(trial.rng.uniform(0.02, 0.98), trial.rng.uniform(0.02, 0.98)) for _ in range(trial.rng.choice((2, 2, 3)))]
        sections.append({"name": f"s{number}", "points": points})
    return sections


def judge_sections(trial, results, sections, q, what):
    """Each discharge is the uniform flux q [m/s] through the line from its first point to its last."""
    for section in sections:
        (ax, ay), (bx, by) = section["points"][0], section["points"][-1]
        right = q[0] * (by - ay) - q[1] * (bx - ax)
        length = math.hypot(bx - ax, by - ay)
        scale = max(abs(right), 0.02 * math.hypot(*q) * length)
        trial.near(f"{what} through '{section['name']}'", results.get(f"flow.section[{section['name']}]"), right, 0.01, scale)


def judge_series(trial):
    """Upward or downward flow through layers: q = ΔH / Σ d/k."""
    width, count = trial.draw(2, 10), trial.rng.choice((2, 3))
    thicknesses, conductivities = [trial.draw(1, 3) for _ in range(count)], [trial.draw_log(1e-9, 1e-4) for _ in range(count)]
    levels = [round(sum(thicknesses[:i]), 6) for i in range(count + 1)]
    names = [f"layer{i}" for i in range(count)]
    head = round(levels[-1] + trial.draw(0.1, 3), 3)
    rise = trial.draw(-0.8, 3)
    sections = draw_sections(trial, lambda s, t: [round(s * width, 4), round(t * levels[-1], 4)])
    case = {"title": "Series", "analysis": {"methods": ["seepage"]}, "mesh": {"size": trial.draw(0.25, 1)},
            "geometry": {"polygon": [{"name": n, "points": [[0, a], [width, a], [width, b], [0, b]]} for n, a, b in zip(names, levels, levels[1:])],
                         "line": [{"name": "bed", "points": [[0, levels[-1]], [width, levels[-1]]]}]},
            "materials": {n: {"unit_weight": 20, "porosity": 0.4, "water": {"retention": "saturated", "conductivity": f"{k} m/s"}}
                          for n, k in zip(names, conductivities)},
            "regions": {n: n for n in names}, "seepage": {"section": sections},
            "hydraulic": [{"on": "bottom", "condition": "total_head", "head": round(head + rise, 3)}, {"on": "bed", "condition": "total_head", "head": head}]}
    q = round(rise, 3) / sum(d / k for d, k in zip(thicknesses, conductivities))
    judge_sections(trial, trial.results("drawn", case), sections, (0, q), "discharge")


def judge_tensor(trial):
    """A slab between vertical ends whose roof and floor follow the flux of a horizontal gradient J in bedded soil: q = J (K_xx, K_xy) everywhere."""
    along, ratio, dip = trial.draw_log(1e-7, 1e-4), trial.draw_log(0.02, 1), trial.draw(-60, 60, 1)
    c, s = math.cos(math.radians(dip)), math.sin(math.radians(dip))
    kxx, kxy = along * (c * c + ratio * s * s), along * (1 - ratio) * s * c
    length, height, fall = trial.draw(6, 12), trial.draw(2, 5), trial.draw(0.5, 3)
    rise = kxy / kxx * length
    corners = [[0, 0], [length, rise], [length, rise + height], [0, height]]
    high = max(y for _, y in corners) + fall + 1
    sections = draw_sections(trial, lambda s, t: [round(s * length, 4), round(s * rise + t * height, 4)])
    case = {"title": "Bedded slab", "analysis": {"methods": ["seepage"]}, "mesh": {"size": trial.draw(0.4, 1)},
            "geometry": {"polygon": [{"name": "slab", "points": corners}], "line": [
                {"name": "inlet", "points": [corners[0], corners[3]]}, {"name": "outlet", "points": [corners[1], corners[2]]},
                {"name": "roof", "points": [corners[3], corners[2]]}, {"name": "floor", "points": [corners[0], corners[1]]}]},
            "materials": {"bedded": {"unit_weight": 20, "porosity": 0.4, "water": {"retention": "saturated", "conductivity": f"{along} m/s",
                                     "conductivity_ratio": ratio, "conductivity_inclination": dip}}},
            "regions": {"slab": "bedded"}, "seepage": {"section": sections},
            "hydraulic": [{"on": "inlet", "condition": "total_head", "head": high}, {"on": "outlet", "condition": "total_head", "head": high - fall},
                          {"on": "roof", "condition": "no_flow"}, {"on": "floor", "condition": "no_flow"}]}
    q = (kxx * fall / length, kxy * fall / length)
    summary = trial.calculate("drawn", case)
    trial.near("inflow", summary["flow"]["states"][0]["inflow"], q[0] * height, 1e-3)
    trial.near("exit gradient", read_results(summary).get("flow.exit_gradient[outlet]"), fall / length, 1e-3)
    judge_sections(trial, read_results(summary), sections, q, "discharge")


def judge_whole(trial):
    """All the water of a dam on permeable ground crosses every line from its base to the air: sections agree with the inflow and the outflow."""
    case, _ = draw_dam(trial)
    polygon = case["geometry"]["polygon"][0]["points"]
    base, (_, _), crest, other = polygon[0][1], polygon[2], case["geometry"]["line"][0]["points"][2], case["geometry"]["line"][1]["points"][0]
    top = crest[1]
    case["seepage"] = {"section": [{"name": f"s{i}", "points": [
        [trial.draw(crest[0] - 1, other[0] + 1), base], [trial.draw(crest[0], other[0]), round(0.5 * top, 3)], [trial.draw(crest[0], other[0]), top + 1]]}
        for i in range(3)]}
    summary = trial.calculate("drawn", case)
    state = summary["flow"]["states"][0]
    trial.near("outflow", state["outflow"], state["inflow"], 1e-6)
    for section in state["sections"]:
        trial.near(f"discharge through '{section['name']}'", section["discharge"], state["inflow"], 0.01)


def judge_drainage(trial):
    """Rain q < k on a column with free drainage at its base: q runs through, under a gradient of 1 and at the suction ln(k/q)/decay."""
    width, height, k, decay = trial.draw(1, 3), trial.draw(3, 8), trial.draw_log(1e-7, 1e-5), trial.draw(0.03, 0.2)
    part = trial.draw(0.05, 0.8)
    sections = [{"name": "across", "points": [[width + 1, round(0.4 * height, 3)], [-1, round(0.6 * height, 3)]]}]
    case = {"title": "Drained column", "analysis": {"methods": ["seepage"]}, "mesh": {"size": 0.3},
            "geometry": {"polygon": [{"name": "column", "points": [[0, 0], [width, 0], [width, height], [0, height]]}]},
            "materials": {"sand": {"unit_weight": 20, "porosity": 0.4, "water": {"retention": "exponential", "decay": decay, "minimum_saturation": 0.1,
                                   "relative_conductivity": "exponential", "conductivity": f"{k} m/s"}}},
            "regions": {"column": "sand"}, "seepage": {"section": sections},
            "hydraulic": [{"on": "top", "condition": "rain", "rate": f"{part * k} m/s"}, {"on": "bottom", "condition": "free_drainage"}]}
    summary = trial.calculate("drawn", case)
    state = summary["flow"]["states"][0]
    for what, value in (("inflow", state["inflow"]), ("outflow", state["outflow"]), ("discharge upwards", -state["sections"][0]["discharge"])):
        trial.near(what, value, part * k * width, 0.01)
    trial.near("suction", read_results(summary).get("seepage.largest_suction"), -math.log(part) / decay * 1e3, 0.02)
