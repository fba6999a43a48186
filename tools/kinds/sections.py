# SPDX-License-Identifier: MIT
"""One section for all methods: soils with and without pore water, stages that change nothing, other units, mirrored, at map coordinates."""
import copy
import json
import math

from published.rewritten import mirror, move, to_practice

from .refusals import make_nails
from .supports import collect, draw_circles

METHODS = "bishop", "spencer"


def draw_slope(trial):
    """Two soils under one water table; saturated soil has one weight above and below it, so that [water] changes none."""
    height = trial.draw(5, 10)
    run = round(height * trial.rng.uniform(1.2, 2.5), 3)
    border = round(trial.rng.uniform(-0.3, 0.6) * height, 3)
    left, right, base = -run - 3 * height, 3 * height, -height
    x = -run * border / height
    upper = [[left, border], [x, border], [-run, height], [left, height]] if border > 0 else [
        [left, border], [right, border], [right, 0], [0, 0], [-run, height], [left, height]]
    lower = [[left, base], [right, base], [right, 0], [0, 0], [x, border], [left, border]] if border > 0 else [
        [left, base], [right, base], [right, border], [left, border]]
    soils = {}
    for name in ("upper", "lower"):
        porosity, density = trial.draw(0.3, 0.5), trial.draw(2600, 2750, 0)
        weight = round(((1 - porosity) * density + porosity * 1000) * 9.81e-3, 9)
        soils[name] = {"model": "mohr_coulomb", "unit_weight": f"{weight} kN/m3", "cohesion": f"{trial.draw(3, 20)} kPa", "friction_angle": trial.draw(18, 35),
                       "dilatancy_angle": 0, "tensile_strength": "0 kPa", "young_modulus": "30 MPa", "poisson_ratio": 0.3, "suction_strength": "none"}
        soils[name]["_water"] = {"grain_density": density, "porosity": porosity}
    inland, front = round(trial.rng.uniform(0.3, 0.8) * height, 3), round(trial.rng.uniform(-0.3, 0.25) * height, 3)
    front = min(front, 0)
    case = {"title": "Two soils", "analysis": {"methods": ["lem"]}, "geometry": {"polygon": [{"name": "upper", "points": upper}, {"name": "lower", "points": lower}]},
            "materials": soils, "regions": {"upper": "upper", "lower": "lower"},
            "initial": {"stress": "k0", "pore_pressure": "water_table", "water_table": [[left, inland], [-run, round(0.8 * inland, 3)], [0, front], [right, front]]},
            "lem": {"methods": list(METHODS), "search": "none", "referee": False, "yield_acceleration": False, "reject": False, "slices": 40,
                    "surface": draw_circles(trial, height, run)}}
    return case, height


def give_water(case, names):
    """The case with [materials.NAME.water] in the soils `names`, without the helper keys."""
    case = copy.deepcopy(case)
    for name, soil in case["materials"].items():
        water = soil.pop("_water")
        if name in names:
            del soil["unit_weight"]
            soil |= water | {"water": {"retention": "saturated", "conductivity": "1e-8 m/s"}}
    return case


def add_stage(case, size, is_drained):
    """A stage that adds a load which no surface feels: 1e-9 kPa far behind the crest."""
    case = copy.deepcopy(case)
    left = min(x for x, _ in case["geometry"]["polygon"][1]["points"])
    case["surcharge"] = [{"name": "hut", "x": [left, left + 0.01], "load": [1e-9, 1e-9]}]
    case["construction"] = [{"name": "hut", "duration": 1 if is_drained else 0, "drainage": "drained" if is_drained else "undrained", "add": ["hut"]}]
    case["analysis"]["methods"] = ["fem", "lem"]
    case["fem"] = {"size": size, "meshes": 1, "resolution": 0.2}
    return case


def judge_water(trial):
    """LEM on given circles: soils with and without [water], and after a stage that changes nothing."""
    drawn, height = draw_slope(trial)
    plain = collect(trial.calculate("plain", give_water(drawn, ())), METHODS)
    trial.expect(len(plain) >= 2, f"{len(plain)} of 8 factors only")
    for name, wet in (("upper wet", ["upper"]), ("lower wet", ["lower"]), ("both wet", ["upper", "lower"])):
        found = collect(trial.calculate(name.replace(" ", "_"), give_water(drawn, wet)), METHODS)
        for key, factor in plain.items():
            trial.near(f"{key}, {name}", found.get(key), factor, 1e-9)
    wet = trial.rng.choice(([], ["upper"], ["lower"], ["upper", "lower"]))
    # Wet soil below the water level of other soil has steady flow from it in a drained stage, which a table of straight lines is not.
    trial.calculate("stage", add_stage(give_water(drawn, wet), 0.4 * height, wet != ["lower"]))
    found = collect(json.loads((trial.folder / "stage" / "stage_1" / "summary.json").read_text()), METHODS)
    for key, factor in plain.items():  # pore pressures of wet soil are linear in elements of FEM, of 0.4 H here
        trial.near(f"{key}, after a stage without effect (water in {wet})", found.get(key), factor, 5e-3 if wet else 1e-9)


def judge_methods(trial):
    """FEM with ψ = φ on elements of H/5 lies within 6 % of the interval of limit analysis; LEM's least circle at most 3 % below it."""
    drawn, height = draw_slope(trial)
    wet = trial.rng.choice(([], ["upper"], ["lower"], ["upper", "lower"]))
    case = give_water(drawn, wet)
    case["analysis"]["methods"] = ["lem", "fem", "bounds"]
    case["lem"] = {"methods": list(METHODS), "noncircular": False, "referee": False, "slices": 30, "entry_exit": {"entries": 10, "exits": 10, "depths": 8}}
    case["fem"] = {"size": round(height / 5, 3), "meshes": 1, "flow": "associated", "resolution": 0.02}
    case["bounds"] = {"gap": 0.08, "triangles": 1500, "tension": "apex"}
    for soil in case["materials"].values():
        cohesion = float(soil["cohesion"].split()[0])
        soil["tensile_strength"] = f"{0.999 * cohesion / math.tan(math.radians(soil['friction_angle'])):.6f} kPa"
        soil["dilatancy_angle"] = soil["friction_angle"]
    results = trial.results("drawn", case)
    lower, upper = results.get("bounds.lower"), results.get("bounds.upper")
    trial.expect(bool(lower and upper and lower <= upper), f"bounds {lower} to {upper}")
    if not (lower and upper):
        return
    element, slices = results.get("fem.associated.factor"), results.get("lem.spencer") or results.get("lem.bishop")
    trial.expect(bool(element) and 0.97 * lower <= element <= 1.06 * upper, f"FEM {element} beside bounds {lower:.4f} to {upper:.4f} (water in {wet})")
    trial.expect(bool(slices) and slices >= 0.97 * lower, f"LEM {slices} below the lower bound {lower:.4f} (water in {wet})")


def judge_rewritten(trial):
    """LEM on given circles mirrored, at map coordinates, in feet and pounds."""
    drawn, _ = draw_slope(trial)
    case = give_water(drawn, trial.rng.choice(([], ["upper"], ["lower"])))
    plain = collect(trial.calculate("plain", case), METHODS)
    for name, other in (("mirrored", mirror(case)), ("at map coordinates", move(case, trial.draw(1e5, 6e5), trial.draw(-300, 3000))), ("US units", to_practice(case))):
        found = collect(trial.calculate(name.replace(" ", "_"), other), METHODS)
        for key, factor in plain.items():
            trial.near(f"{key}, {name}", found.get(key), factor, 1e-6)


def judge_water_given(trial):
    """A level water table, the same as a piezometric line of all soils, as a grid of heads and as one of pressures: equal factors on given circles."""
    drawn, height = draw_slope(trial)
    case = give_water(drawn, ())
    level = round(-trial.rng.uniform(0, 0.8) * height, 3)
    left, right = case["geometry"]["polygon"][0]["points"][0][0], 3 * height
    case["initial"]["water_table"] = [[left, level], [right, level]]
    factors = collect(trial.calculate("table", case), METHODS)
    line = copy.deepcopy(case)
    line["initial"] |= {"water_table": [[left, -0.9 * height], [right, -0.9 * height]], "piezometric_line": [{"materials": ["upper", "lower"], "points": [[0, level]]}]}
    found = {"piezometric line": collect(trial.calculate("line", line), METHODS)}
    rows = [(x, y) for x in (left - 5, -0.4 * height, right + 5) for y in (-1.5 * height, 0.3 * height, 1.5 * height)]
    for quantity in ("head", "pressure"):
        unit, values = ("m", [level] * len(rows)) if quantity == "head" else ("kPa", [9.81 * (level - y) for _, y in rows])
        (trial.folder / f"{quantity}.csv").write_text(f"x [m],y [m],{quantity} [{unit}]\n" + "".join(f"{x},{y},{v!r}\n" for (x, y), v in zip(rows, values)))
        grid = copy.deepcopy(case)
        del grid["initial"]["water_table"]
        grid["initial"] |= {"pore_pressure": "grid", "pressure_grid": {"file": f"{quantity}.csv", "quantity": quantity}}
        found[f"grid of {quantity}s"] = collect(trial.calculate(f"grid_{quantity}", grid), METHODS)
    for name, others in found.items():
        for key, factor in factors.items():
            trial.near(f"{key}, {name}", others.get(key), factor, 1e-3)


def judge_stages(trial):
    """A nailed pit in stages, mirrored and moved: displacements, FEM's factor and LEM's on a given arc. (LEM also optimises a polyline from FEM's shear band,
    which rounding moves: it is not compared.)"""
    case = make_nails(trial)
    case["materials"]["silt"]["friction_angle"] = trial.draw(26, 34)
    case["lem"] = {"methods": ["bishop"], "search": "none", "referee": False, "reject": False,
                   "surface": [{"name": "arc", "centre": [trial.draw(13.5, 16), trial.draw(9, 11)], "radius": trial.draw(6.5, 7.5)}]}
    case["fem"]["resolution"] = 0.05
    def compute(name, one):
        found = {k: v for k, v in trial.results(name, one).items() if k.startswith("construction[") and not k.endswith(".lem")}
        arc = collect(json.loads((trial.folder / name / "stage_2" / "summary.json").read_text()))
        return found | {"construction[nail].lem of the arc": arc.get(("arc", "bishop"))}

    plain = compute("plain", case)
    for name, other in (("mirrored", mirror(case)), ("moved", move(case, trial.draw(1e3, 1e5), trial.draw(-100, 900)))):
        found = compute(name, other)
        for key in sorted(k for k in plain if plain[k] is not None):
            size = max(abs(v) for k, v in plain.items() if v is not None and k.split(".")[-1] == key.split(".")[-1])
            trial.near(f"{key}, {name}", found.get(key), plain[key], 1e-4, max(size, 1e-6))
