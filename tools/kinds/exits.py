# SPDX-License-Identifier: MIT
"""Exit gradients and factors against boiling, against series of layers and a dam that is drawn otherwise."""
import copy
import math

from published.rewritten import mirror, move

from .trial import WATER, read_results

DAM = {"title": "Dam", "analysis": {"methods": ["seepage"]}, "regions": {"dam": "sand"}}


def make_soil(trial, conductivity):
    return {"unit_weight": trial.draw(18, 21), "porosity": trial.draw(0.3, 0.5),
            "water": {"retention": "saturated", "conductivity": f"{conductivity} m/s"}}


def judge_layers(trial):
    """Upward flow through columns side by side of two or three layers each: the gradient of a layer is q/k with q = ΔH / Σ d/k, alike in both columns
    where their layers are in proportion. Columns that differ would exchange water, so that all columns have the layers of the first; with one layer they
    may have any conductivity."""
    base, width, count = trial.draw(-5, 5), trial.draw(4, 16), trial.rng.choice((1, 2, 3))
    thicknesses = [trial.draw(1, 4) for _ in range(count)]
    conductivities = [trial.draw_log(1e-8, 1e-4) for _ in range(count)]
    top, middle = round(base + sum(thicknesses), 6), round(width * trial.rng.uniform(0.3, 0.7), 3)
    polygons, soils = [], {}
    level = base
    for i, (thickness, conductivity) in enumerate(zip(thicknesses, conductivities)):
        above = top if i == count - 1 else round(level + thickness, 6)
        for j, (left, right) in enumerate(((0, middle), (middle, width))):
            soils[f"s{i}{j}"] = make_soil(trial, conductivity if count > 1 or j == 0 else trial.draw_log(1e-8, 1e-4))
            polygons.append({"name": f"p{i}{j}", "points": [[left, level], [right, level], [right, above], [left, above]]})
        level = above
    rise, pond = trial.draw(0.2, 6), trial.rng.choice((0, trial.draw(0.1, 3)))
    inner = [round(width * trial.rng.uniform(0.05, 0.3), 3), round(width * trial.rng.uniform(0.6, 0.95), 3)]
    depth = round(thicknesses[-1] * trial.rng.uniform(0.3, 1), 3)
    case = {"title": "Layers", "analysis": {"methods": ["seepage"]}, "geometry": {
        "polygon": polygons, "line": [{"name": "ground", "points": [[0, top], [width, top]]}]},
            "mesh": {"size": trial.draw(0.4, 1.2)}, "materials": soils, "regions": {p["name"]: "s" + p["name"][1:] for p in polygons},
            "seepage": {"heave": [{"name": "block", "x": inner, "level": round(top - depth, 6)}]},
            "hydraulic": [{"on": "bottom", "condition": "total_head", "head": round(top + pond + rise, 6)},
                          {"on": "ground", "condition": "total_head", "head": round(top + pond, 6)}]}
    right = rise / sum(d / k for d, k in zip(thicknesses, conductivities)) / conductivities[-1]
    least = min(soils[f"s{count - 1}{j}"]["unit_weight"] * 1e3 / WATER - 1 for j in (0, 1)) / right
    results = trial.results("drawn", case)
    trial.near("exit gradient", results.get("flow.exit_gradient[ground]"), right, 1e-3)
    trial.near("factor against boiling", results.get("flow.boiling[ground]"), least, 1e-3)
    weights = [soils[f"s{count - 1}{j}"]["unit_weight"] * 1e3 - WATER for j in (0, 1)]
    border = min(max(middle, inner[0]), inner[1])
    block = (weights[0] * (border - inner[0]) + weights[1] * (inner[1] - border)) / (inner[1] - inner[0])
    trial.near("factor against heave", results.get("flow.heave[block]"), block / WATER / right, 2e-3)
    judge_uplift(trial, results.get("flow.uplift"), thicknesses, conductivities, soils, rise)
    trial.expect("flow.exit_gradient[bottom]" not in results, "an exit gradient at 'bottom', where water enters")
    turned = copy.deepcopy(case)
    turned["hydraulic"].reverse()
    turned["geometry"]["polygon"].reverse()
    turned = trial.results("turned", turned)
    for key in ("flow.exit_gradient[ground]", "flow.boiling[ground]"):
        trial.near(f"{key}, sides and polygons in another order", turned.get(key), results.get(key) or 0, 1e-6)
    trial.expect(trial.results("again", case) == results, "the same case again has other results")


def judge_uplift(trial, factor, thicknesses, conductivities, soils, rise):
    """Below each layer that is ten times less permeable than the one under it: weight above over pore pressure, without standing water."""
    flow, found = rise / sum(d / k for d, k in zip(thicknesses, conductivities)), []
    for i in range(1, len(thicknesses)):
        if conductivities[i - 1] >= 10 * conductivities[i]:
            pressure = WATER * sum(d + flow * d / k for d, k in zip(thicknesses[i:], conductivities[i:]))
            found += [sum(d * soils[f"s{n}{j}"]["unit_weight"] * 1e3 for n, d in enumerate(thicknesses) if n >= i) / pressure for j in (0, 1)]
    if found:
        trial.near("factor against uplift", factor, min(found), 5e-3)


def integrate_elliptic(modulus):
    """The complete elliptic integral of the first kind, by the arithmetic-geometric mean."""
    a, b = 1.0, math.sqrt(1 - modulus**2)
    while abs(a - b) > 1e-15:
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return 0.5 * math.pi / a


def judge_pile(trial):
    """A sheet pile s into a layer T (Harr 1962): q = k h K'/(2K), exit gradient π h/(4 K T m) with the modulus m = sin(π s/2T);
    all the water passes below its tip."""
    layer, fall, k = trial.draw(6, 14), trial.draw(0.5, 5), trial.draw_log(1e-7, 1e-4)
    depth = round(layer * trial.rng.uniform(0.2, 0.6), 3)
    at, end, tip = 3 * layer, 6 * layer, round(layer - depth, 3)
    upstream = trial.rng.random() < 0.5
    heads = [round(layer + fall, 3), layer] if upstream else [layer, round(layer + fall, 3)]
    case = {"title": "Sheet pile", "analysis": {"methods": ["seepage"]}, "regions": {"sand": "sand"}, "materials": {"sand": make_soil(trial, k)},
            "geometry": {"polygon": [{"name": "sand", "points": [[0, 0], [end, 0], [end, layer], [at, layer], [0, layer]]}],
                         "line": [{"name": "left bed", "points": [[0, layer], [at, layer]]}, {"name": "right bed", "points": [[at, layer], [end, layer]]}]},
            "mesh": {"size": 0.06 * layer, "refine": [{"near": [[at, layer], [at, tip]], "size": 0.012 * depth, "distance": depth}]},
            "support": {"pile": {"kind": "wall", "line": [[at, layer], [at, tip]], "permeable": False}},
            "seepage": {"section": [{"name": "below", "points": [[at, 0], [at, tip]]}]},
            "hydraulic": [{"on": "left bed", "condition": "total_head", "head": heads[0]}, {"on": "right bed", "condition": "total_head", "head": heads[1]}]}
    modulus = math.sin(0.5 * math.pi * depth / layer)
    whole, other = integrate_elliptic(modulus), integrate_elliptic(math.sqrt(1 - modulus**2))
    exit = "right bed" if upstream else "left bed"
    summary = trial.calculate("drawn", case)
    results, inflow = read_results(summary), summary["flow"]["states"][0]["inflow"]
    trial.near("discharge", inflow, k * fall * other / (2 * whole), 0.02)
    trial.near("discharge below the tip", results.get("flow.section[below]"), inflow if upstream else -inflow, 0.01)
    gradient = math.pi * fall / (4 * whole * layer * modulus)
    trial.near("exit gradient", results.get(f"flow.exit_gradient[{exit}]"), gradient, 0.05)
    trial.near("factor against boiling", results.get(f"flow.boiling[{exit}]"), (case["materials"]["sand"]["unit_weight"] * 1e3 / WATER - 1) / gradient, 0.05)
    trial.expect(len([key for key in results if key.startswith("flow.exit_gradient")]) == 1, "an exit gradient where water enters")


def draw_dam(trial):
    """A dam on its base with a pool at the left, dry air or a pool at the right, and the toe inside level ground."""
    height, crest = trial.draw(5, 12), trial.draw(2, 5)
    left, right = trial.draw(1.2, 2.5) * height, trial.draw(1.2, 2.5) * height
    depth, front = trial.draw(2, 6), trial.draw(4, 8)
    foot = round(left + crest + right, 6)
    ground = [[-front, 0], [0, 0], [round(left, 6), height], [round(left + crest, 6), height], [foot, 0], [round(foot + front, 6), 0]]
    pool = round(trial.rng.uniform(0.15, 0.9) * height, 3)
    case = copy.deepcopy(DAM) | {
        "geometry": {"polygon": [{"name": "dam", "points": [[-front, -depth], [ground[-1][0], -depth], *reversed(ground)]}],
                     "line": [{"name": "pool", "points": ground[:3]}, {"name": "air", "points": ground[3:]}]},
        "mesh": {"size": round(height / trial.rng.choice((4, 5, 6, 8)), 3)},
        "materials": {"sand": {"unit_weight": trial.draw(18, 21), "porosity": 0.4, "water": {
            "retention": "van_genuchten", "reference_pressure": trial.draw(2, 20), "lambda": trial.draw(0.35, 0.7), "conductivity": "1e-5 m/s",
            "relative_conductivity": trial.rng.choice(("constant", "mualem"))}}},
        "hydraulic": [{"on": "pool", "condition": "total_head", "head": pool}, {"on": "air", "condition": "seepage_face"}]}
    return case, pool


def judge_dam(trial):
    """Water leaves at 'air' only, below the pool, under a gradient of the order of 1; mirrored, in another order and again the same."""
    case, pool = draw_dam(trial)
    summary = trial.calculate("drawn", case)
    results = read_results(summary)
    for exit in summary["flow"]["states"][0]["exits"]:
        trial.expect(exit["name"] != "pool", f"exit gradient {exit['gradient']:.3g} at 'pool' ({exit['at']}), where water enters")
        trial.expect(0 < exit["gradient"] < 3, f"exit gradient {exit['gradient']:.3g} at '{exit['name']}'")
        trial.expect(exit["at"][1] < pool, f"the exit gradient lies at {exit['at']}, above the pool at {pool}")
    trial.expect("flow.exit_gradient[air]" in results, "no exit gradient at 'air', where all the water leaves")
    image = mirror(case)
    for line in image["geometry"]["line"]:
        line["points"].reverse()
    turned = copy.deepcopy(case)
    turned["hydraulic"].reverse()
    turned["geometry"]["line"].reverse()
    for name, other, tolerance in (("mirrored", image, 1e-6), ("turned", turned, 1e-6), ("again", case, 0),
                                   ("moved", move(case, trial.draw(1e5, 6e5), trial.draw(-200, 2000)), 1e-5)):
        others = trial.results(name, other)
        for key in sorted(k for k in results.keys() | others.keys() if k.startswith("flow.")):
            if key in results and key in others:
                trial.near(f"{key}, {name}", others[key], results[key], tolerance)
            else:
                trial.expect(False, f"{key} is in one of the two only: drawn, {name}")


def judge_beds(trial):
    """Horizontal flow through layers between heads at both ends: the exit gradient is ΔH/L, whatever the conductivities."""
    length, count = trial.draw(10, 40), trial.rng.choice((2, 3))
    levels = [0.0]
    for _ in range(count):
        levels.append(round(levels[-1] + trial.draw(1, 4), 3))
    names = [f"bed{i}" for i in range(count)]
    fall = trial.draw(0.5, 4)
    high = round(levels[-1] + fall + trial.draw(0.5, 3), 3)
    ends = ["left", "right"] if trial.rng.random() < 0.5 else ["right", "left"]
    case = {"title": "Beds", "analysis": {"methods": ["seepage"]}, "mesh": {"size": trial.draw(0.6, 1.5)},
            "geometry": {"polygon": [{"name": n, "points": [[0, a], [length, a], [length, b], [0, b]]} for n, a, b in zip(names, levels, levels[1:])],
                         "line": [{"name": "roof", "points": [[0, levels[-1]], [length, levels[-1]]]}]},
            "materials": {n: make_soil(trial, trial.draw_log(1e-8, 1e-4)) for n in names}, "regions": {n: n for n in names},
            "hydraulic": [{"on": ends[0], "condition": "total_head", "head": high}, {"on": ends[1], "condition": "total_head", "head": round(high - fall, 3)},
                          {"on": "roof", "condition": "no_flow"}]}
    results = trial.results("drawn", case)
    trial.near("exit gradient", results.get(f"flow.exit_gradient[{ends[1]}]"), fall / length, 1e-3)
    for side in (ends[0], "roof", "bottom"):
        trial.expect(f"flow.exit_gradient[{side}]" not in results, f"an exit gradient at '{side}'")
