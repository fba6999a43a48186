# SPDX-License-Identifier: MIT
"""Supports in LEM: a plane with its closed form, capacities, and what must never lower a factor."""
import copy
import math

MORE = 1e-6  # relative; what a support that is longer, stronger or added may lower a factor of Bishop's method by


def make_slope(trial, height, run):
    """A cut of `height` over `run`, with its toe at (0, 0) and the crest at the left."""
    return {"title": "Supported cut", "analysis": {"methods": ["lem"]}, "regions": {"soil": "soil"},
            "geometry": {"ground": [[-5 * height, height], [-run, height], [0, 0], [4 * height, 0]], "layer": [{"name": "soil", "level": -2 * height}]},
            "materials": {"soil": {"model": "mohr_coulomb", "unit_weight": trial.draw(16, 21), "cohesion": trial.draw(1, 20),
                                   "friction_angle": trial.draw(15, 40)}},
            "lem": {"search": "none", "referee": False, "yield_acceleration": False, "slices": 100}}


def draw_bar(trial, height, run, kind):
    """One row on the face [kN, m]."""
    y = round(trial.rng.uniform(0.25, 0.8) * height, 3)
    bar = {"kind": kind, "heads": [[-run * y / height, y]], "inclination": trial.draw(0, 30, 1), "length": round(trial.draw(0.8, 2.5) * height, 3),
           "out_of_plane_spacing": trial.draw(1, 3), "tensile_strength": trial.draw(20, 400, 1), "plate": trial.draw(0, 150, 1), "bond": trial.draw(5, 80, 1),
           "sense": trial.rng.choice(("active", "passive"))}
    if kind == "anchor":
        bar["bond_length"] = round(0.4 * bar["length"], 3)
    return bar


def compute_capacity(bar, distance):
    """The least of tensile strength, bond behind and head with bond in front [N/m] where the plane cuts the bar `distance` from its head."""
    free = bar["length"] - bar.get("bond_length", bar["length"])
    behind, front = bar["length"] - max(distance, free), max(0, distance - free)
    forces = bar["tensile_strength"], bar["bond"] * max(0, behind), bar["plate"] + bar["bond"] * front
    return max(0.0, min(forces)) * 1e3 / bar["out_of_plane_spacing"]


def solve_plane(driving, normal, cohesion, tan, force, angle, is_active):
    """The factor on a plane; `angle` is that between bar and plane. The factor divides the capacity of a passive bar as it divides the strength of the soil."""
    along, across = force * math.cos(angle), force * math.sin(angle)
    if is_active:
        return (cohesion + (normal + across) * tan) / (driving - along)
    rest = cohesion + normal * tan + along
    return (rest + math.sqrt(rest**2 + 4 * driving * across * tan)) / (2 * driving)


def judge_plane(trial):
    """A bar across a plane through the toe, with an earthquake or without: closed form, for every method of force equilibrium; its force is at most its capacity."""
    height = trial.draw(4, 12)
    run = round(height * trial.rng.uniform(0.15, 0.9), 3)
    face = math.atan2(height, run)
    case, kind = make_slope(trial, height, run), trial.rng.choice(("nail", "anchor"))
    slope = trial.rng.uniform(0.45, 0.85) * face
    top = -height / math.tan(slope)
    soil, bar = case["materials"]["soil"], draw_bar(trial, height, run, kind)
    (x, y), dip = bar["heads"][0], math.radians(bar["inclination"])
    # the plane is y = -x tan(slope); the bar is x - s cos, y - s sin
    distance = (-y - x * math.tan(slope)) / (-math.sin(dip) - math.cos(dip) * math.tan(slope))
    length = height / math.sin(slope)
    weight = 0.5 * soil["unit_weight"] * 1e3 * height * (-top - run)
    tan = math.tan(math.radians(soil["friction_angle"]))
    force = compute_capacity(bar, distance) if 0 < distance < bar["length"] else 0.0
    shake = trial.rng.choice((0, trial.draw(0.02, 0.2)))
    if shake:
        case["earthquake"] = {"horizontal": shake}
    driving, normal = weight * (math.sin(slope) + shake * math.cos(slope)), weight * (math.cos(slope) - shake * math.sin(slope))
    cohesion = soil["cohesion"] * 1e3 * length
    if bar["sense"] == "active":
        force = min(force, 0.8 * driving)  # more holds the mass without any strength
        bar["tensile_strength"] = min(bar["tensile_strength"], force * bar["out_of_plane_spacing"] / 1e3) if force else bar["tensile_strength"]
    if kind == "anchor":
        bar["prestress"] = bar["tensile_strength"] if bar["sense"] == "active" else 0
        if bar["sense"] == "passive":
            del bar["prestress"]
    right = solve_plane(driving, normal, cohesion, tan, force, slope + dip, bar["sense"] == "active")
    case["support"] = {"bar": bar}
    case["lem"]["surface"] = [{"name": "plane", "points": [[top, height], [0, 0]]}]
    case["lem"]["methods"] = ["janbu", "morgenstern_price", "spencer"]
    summary = trial.calculate("drawn", case)
    for given in summary["lem"]["given"]:
        if given["factor"] is None and given["method"] != "janbu":  # no line of thrust that the method accepts
            continue
        trial.near(f"factor by {given['method']}, {bar['sense']} {kind}", given["factor"], right, 2e-3)
        for used in given["supports"]:
            trial.expect(used["force"] <= force * (1 + 1e-6), f"force {used['force']:.6g} N/m of a capacity of {force:.6g}, F = {given['factor']}")


def draw_circles(trial, height, run):
    """Circles through points on the crest and in front of the toe, with their centres above the crest."""
    circles = []
    for number in range(4):
        left, right = trial.draw(-run - 1.2 * height, -run - 0.2 * height), trial.draw(-0.1 * run, 0.8 * height)
        y = 0.0 if right >= 0 else -right / run * height
        chord = math.hypot(right - left, height - y)
        radius = chord * trial.rng.uniform(0.55, 1.2)
        up = math.sqrt(radius**2 - chord**2 / 4)
        centre = [0.5 * (left + right) + up * (height - y) / chord, 0.5 * (height + y) + up * (right - left) / chord]
        if centre[1] > height:
            circles.append({"name": f"c{number}", "centre": centre, "radius": radius})
    return circles


def collect(summary, methods=("bishop",)):
    return {(g["name"], g["method"]): g["factor"] for g in summary["lem"]["given"] if g["method"] in methods and g.get("factor")}


def judge_more(trial):
    """Longer, stronger or more bars never lower a factor of Bishop's method on given circles; nor do piles that are loaded along their axis;
    a passive bar bears at most its resistance."""
    height = trial.draw(4, 12)
    run = round(height * trial.rng.uniform(0.3, 1.8), 3)
    case = make_slope(trial, height, run)
    case["lem"] |= {"surface": draw_circles(trial, height, run), "methods": ["bishop"], "reject": False}
    plain = collect(trial.calculate("plain", case))
    bars = {f"bar{i}": draw_bar(trial, height, run, trial.rng.choice(("nail", "anchor", "bolt"))) for i in range(trial.rng.choice((1, 2, 3)))}
    for bar in bars.values():
        if bar["kind"] == "bolt":
            for key in ("plate", "bond"):
                del bar[key]
        bar["sense"] = "passive"
    case["support"] = bars
    held = trial.calculate("bars", case)
    for given in held["lem"]["given"]:
        for used in given.get("supports") or []:
            trial.expect(used["force"] <= used["resistance"] * (1 + 1e-9),
                         f"'{given['name']}': force {used['force']:.6g} of a resistance of {used['resistance']:.6g} N/m")
    longer, stronger, more, axial = (copy.deepcopy(case) for _ in range(4))
    for bar in longer["support"].values():
        more_length = round(0.4 * bar["length"], 3)  # at the far end, so that the head and the bond in front stay as they are
        bar["length"] += more_length
        if "bond_length" in bar:
            bar["bond_length"] += more_length
    for bar in stronger["support"].values():
        for key in ("tensile_strength", "plate", "bond"):
            if key in bar:
                bar[key] *= 1.7
    more["support"]["another"] = draw_bar(trial, height, run, "nail") | {"sense": "passive"}
    axial["support"] = {"pile": {"kind": "pile", "x": [trial.draw(-0.9 * run, -0.1 * run)], "length": round(1.2 * height, 3), "direction": "axial",
                                 "out_of_plane_spacing": 2, "lateral_resistance": trial.draw(20, 300, 1), "sense": trial.rng.choice(("active", "passive"))}}
    found = collect(held)
    for name, before, after in (("bars", plain, found), ("longer", found, collect(trial.calculate("longer", longer))),
                                ("stronger", found, collect(trial.calculate("stronger", stronger))), ("more", found, collect(trial.calculate("more", more))),
                                ("axial pile", plain, collect(trial.calculate("axial", axial)))):
        for key in before:
            trial.expect(key in after and after[key] >= before[key] * (1 - MORE), f"{name} lower {key} from {before[key]:.6f} to {after.get(key, math.nan):.6f}")


def judge_search(trial):
    """The governing circle of a search: bars, then longer ones, do not lower its factor beyond the scatter of the search, 0.5 %."""
    height = trial.draw(4, 10)
    run = round(height * trial.rng.uniform(0.4, 1.5), 3)
    case = make_slope(trial, height, run)
    case["lem"] |= {"methods": ["bishop"], "search": "entry_exit", "noncircular": False, "entry_exit": {"entries": 8, "exits": 8, "depths": 6}, "slices": 30}
    factors = [trial.calculate("plain", case)["main_factor"]]
    case["support"] = {"bar": draw_bar(trial, height, run, "nail") | {"sense": "passive"}}
    factors.append(trial.calculate("bars", case)["main_factor"])
    case["support"]["bar"]["length"] *= 1.5
    factors.append(trial.calculate("longer", case)["main_factor"])
    trial.expect(factors[0] <= 1.005 * factors[1], f"a bar lowers the least factor from {factors[0]:.4f} to {factors[1]:.4f}")
    trial.expect(factors[1] <= 1.005 * factors[2], f"a longer bar lowers the least factor from {factors[1]:.4f} to {factors[2]:.4f}")


def judge_prestress(trial):
    """The factor of an anchor is continuous in its prestress down to 0."""
    height = trial.draw(4, 10)
    run = round(height * trial.rng.uniform(0.2, 1.0), 3)
    case = make_slope(trial, height, run)
    case["lem"] |= {"methods": ["bishop"], "surface": draw_circles(trial, height, run), "reject": False}
    bar = draw_bar(trial, height, run, "anchor")
    case["support"] = {"tie": bar}
    factors = []
    for number, prestress in enumerate((0, 1e-3)):
        bar["prestress"] = prestress
        factors.append(collect(trial.calculate(f"prestress_{number}", case)))
    for key, factor in factors[0].items():
        trial.near(f"factor {key}, {bar['sense']}, prestress 1 N in place of 0", factors[1].get(key), factor, 1e-3)
