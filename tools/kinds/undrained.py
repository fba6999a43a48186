# SPDX-License-Identifier: MIT
"""Undrained soils with and without pore water, at the start and in stages, against moments about the centre of a circle; suction and strength."""
import copy
import json
import math

from .sections import give_water
from .sections import draw_slope as draw_two_soils
from .supports import collect
from .trial import WATER

COLUMNS = 4000


def draw_clay(trial):
    """A cut in clay under a water table at its toe level or below, and one circle through its crest: (case, height, run, centre, radius)."""
    height, level = trial.draw(4, 10), 0.0
    run = round(height * trial.rng.uniform(0.8, 2.5), 3)
    left, right, base = -run - 3 * height, 3 * height, round(-1.5 * height, 6)
    level = round(-trial.rng.uniform(0, 0.4) * height, 3)
    x0, x1 = trial.draw(-run - 1.2 * height, -run - 0.3 * height), trial.draw(0.05 * height, 0.8 * height)
    chord = math.hypot(x1 - x0, height)
    radius = chord * trial.rng.uniform(0.62, 1.1)
    up = math.sqrt(radius**2 - chord**2 / 4)
    centre = [0.5 * (x0 + x1) + up * height / chord, 0.5 * height + up * (x1 - x0) / chord]
    if centre[1] - radius < base + 0.05 * height or math.hypot(centre[0], centre[1] + 0.03 * height) > radius:
        return draw_clay(trial)  # it meets the base, or leaves the ground in the face
    case = {"title": "Clay", "analysis": {"methods": ["lem"]}, "regions": {"clay": "clay"},
            "geometry": {"polygon": [{"name": "clay", "points": [[left, base], [right, base], [right, 0], [0, 0], [-run, height], [left, height]]}]},
            "initial": {"stress": "k0", "pore_pressure": "water_table", "water_table": [[left, level], [right, level]]},
            "lem": {"methods": ["bishop"], "search": "none", "referee": False, "yield_acceleration": False, "reject": False, "slices": 400,
                    "surface": [{"name": "circle", "centre": centre, "radius": radius}]}}
    return case, height, run, centre, radius


def compute_factor(height, run, centre, radius, weight, strength):
    """Σ s_u R dl / Σ W a about the centre; strength(depth, y) [Pa], weight [N/m³]."""
    x1 = centre[0] + math.sqrt(radius**2 - centre[1] ** 2) if centre[1] < radius else None
    x0 = centre[0] - math.sqrt(radius**2 - (height - centre[1])**2)
    resisting = driving = 0.0
    step = (x1 - x0) / COLUMNS
    for i in range(COLUMNS):
        x = x0 + (i + 0.5) * step
        ground = height if x < -run else 0.0 if x > 0 else -x / run * height
        base = centre[1] - math.sqrt(radius**2 - (x - centre[0])**2)
        depth = ground - base
        cosine = math.sqrt(radius**2 - (x - centre[0])**2) / radius
        resisting += strength(depth, base) * step / cosine * radius
        driving += weight * depth * step * (centre[0] - x)
    return resisting / driving


def draw_material(trial, height, level):
    """(keys of the soil, strength(depth, y))"""
    kind = trial.rng.choice(("tresca", "gradient", "profile", "shansep"))
    if kind == "shansep":
        ratio, exponent, ocr, added = trial.draw(0.25, 0.35), trial.draw(0.7, 0.95, 2), trial.draw(2.5, 6, 2), trial.rng.choice((0, 5))
        keys = {"model": "shansep", "strength_ratio": ratio, "strength_exponent": exponent, "ocr": ocr, "added_strength": added}
        return keys, lambda weight: lambda depth, y: added * 1e3 + ratio * (weight * depth - max(0.0, WATER * (level - y))) * ocr**exponent
    value = trial.draw(5, 11, 2) * height  # above Taylor's 0.18 γ H, so that stages have an equilibrium to start from
    keys = {"model": "tresca", "undrained_strength": value}
    if kind == "gradient":
        growth, at = trial.draw(0.5, 3, 2), trial.draw(-height, height)
        keys |= {"undrained_gradient": growth, "undrained_level": at}
        return keys, lambda weight: lambda depth, y: 1e3 * (value + growth * max(0.0, at - y))
    if kind == "profile":
        deep, top = trial.draw(5, 14, 2) * height, trial.draw(0.5, 2) * height
        keys = {"model": "tresca", "profile_depths": [0, top], "profile_strengths": [value, deep]}
        return keys, lambda weight: lambda depth, y: 1e3 * (value + (deep - value) * min(1.0, depth / top))
    return keys, lambda weight: lambda depth, y: 1e3 * value


def judge_circle(trial):
    """tresca (with a gradient, a profile) and shansep on a circle by moments, at the start and at the end of a stage that changes nothing."""
    judge_clay(trial, False)


def judge_wet_circle(trial):
    """The same with [water] in a stage ("undrained B"): the strength is that of the clay, the pore pressures are those of the table."""
    judge_clay(trial, True)


def judge_clay(trial, is_wet):
    case, height, run, centre, radius = draw_clay(trial)
    keys, strength = draw_material(trial, height, case["initial"]["water_table"][0][1])
    porosity, density = trial.draw(0.4, 0.6), trial.draw(2600, 2750, 0)
    weight = ((1 - porosity) * density + porosity * 1000) * WATER / 1e3
    stiffness = {"young_modulus": "5 MPa", "poisson_ratio": 0.33}
    right = compute_factor(height, run, centre, radius, weight, strength(weight))
    plain = copy.deepcopy(case) | {"materials": {"clay": keys | stiffness | {"unit_weight": weight / 1e3}}}
    wet = copy.deepcopy(case) | {"materials": {"clay": keys | stiffness | {"grain_density": density, "porosity": porosity, "water": {
        "retention": "saturated", "conductivity": "1e-9 m/s"}}}}
    if not is_wet:
        trial.near(keys["model"], collect(trial.calculate("drawn", plain)).get(("circle", "bishop")), right, 3e-3)
    left = case["geometry"]["polygon"][0]["points"][0][0]
    staged = wet if is_wet else plain
    staged |= {"surcharge": [{"name": "hut", "x": [left, left + 0.01], "load": [1e-9, 1e-9]}],
               "fem": {"size": round(0.5 * height, 3), "meshes": 1, "resolution": 0.3},
               "construction": [{"name": "hut", "duration": 1, "drainage": trial.rng.choice(("drained", "consolidation")), "add": ["hut"]}]}
    staged["analysis"]["methods"] = ["fem", "lem"]
    trial.calculate("staged", staged)
    factors = collect(json.loads((trial.folder / "staged" / "stage_1" / "summary.json").read_text()))
    trial.near(f"{keys['model']} after a stage", factors.get(("circle", "bishop")), right, 3e-3)


def judge_suction(trial):
    """A retention curve that is given for seepage adds no strength unless the case chooses it: the default has the factor of suction_strength = "none"."""
    drawn, _ = draw_two_soils(trial)
    case = give_water(drawn, ("upper", "lower"))
    for soil in case["materials"].values():
        soil["water"] |= {"retention": "van_genuchten", "reference_pressure": trial.draw(5, 40), "lambda": trial.draw(0.3, 0.6)}
    factors = {}
    for choice in ("default", "none", "saturation"):
        for soil in case["materials"].values():
            soil.pop("suction_strength", None)
            soil |= {} if choice == "default" else {"suction_strength": choice}
        factors[choice] = collect(trial.calculate(choice, case))
    for key, factor in factors["none"].items():
        trial.near(f"{key}, no suction_strength beside a retention curve", factors["default"].get(key), factor, 1e-9)
        trial.expect(factors["saturation"].get(key, 0) >= factor * (1 - 1e-9), f"{key}: suction lowers it from {factor:.4f} to {factors['saturation'].get(key)}")
