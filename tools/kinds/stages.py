# SPDX-License-Identifier: MIT
"""Stages of construction of one-dimensional ground against closed forms: drained cuts, Terzaghi's consolidation, excess pressure at rest."""
import math

from .trial import WATER, read_results

DAY = 86400.0


def make_column(trial, levels, size):
    """Regions one upon the other between these levels, 1 to 3 m wide, of one soil with water."""
    width = trial.draw(1, 3)
    names = [f"part{i}" for i in range(len(levels) - 1)]
    stiffness, ratio = trial.draw(2, 30, 2), trial.draw(0.1, 0.4)
    soil = {"model": "linear_elastic", "grain_density": round(trial.rng.uniform(2600, 2750)), "porosity": trial.draw(0.35, 0.6), "poisson_ratio": ratio,
            "young_modulus": f"{stiffness} MPa", "water": {"retention": "saturated", "conductivity": f"{trial.draw_log(1e-10, 1e-8)} m/s"}}
    case = {"title": "Column", "analysis": {"methods": ["fem"]}, "fem": {"size": size, "meshes": 1}, "mesh": {"size": size},
            "geometry": {"polygon": [{"name": n, "points": [[0, a], [width, a], [width, b], [0, b]]} for n, a, b in zip(names, levels, levels[1:])],
                         "line": [{"name": "ground", "points": [[0, levels[-1]], [width, levels[-1]]]}]},
            "materials": {"soil": soil}, "regions": {n: "soil" for n in names},
            "initial": {"stress": "k0", "pore_pressure": "water_table", "water_table": [[0, levels[-1]], [width, levels[-1]]]}}
    oedometric = stiffness * 1e6 * (1 - ratio) / ((1 + ratio) * (1 - 2 * ratio))
    weight = ((1 - soil["porosity"]) * soil["grain_density"] + soil["porosity"] * 1000) * WATER / 1000
    return case, width, oedometric, weight


def get_steps(summary, stage):
    return summary["construction"]["stages"][stage]["steps"]


def judge_cut(trial):
    """A drained cut without any [[hydraulic]], water table at or below the floor: the pore pressures stay, so that the floor rises by
    γ d H/E_oed; no excess. In half of them strong frictional soil in place of elastic soil."""
    height, depth = trial.draw(4, 9, 2), trial.draw(1, 4, 2)
    top = round(height + depth, 2)
    case, width, stiffness, weight = make_column(trial, [0, height, top], trial.draw(0.4, 0.8))
    level = trial.rng.choice((0, height, trial.draw(0, height)))
    case["initial"]["water_table"] = [[0, level], [width, level]]
    if trial.rng.random() < 0.5:
        case["materials"]["soil"] |= {"model": "mohr_coulomb", "cohesion": 2000, "friction_angle": 25, "dilatancy_angle": 0, "tensile_strength": 2000}
        case["unusual"] = ["materials.soil.cohesion", "materials.soil.tensile_strength"]
    case["construction"] = [{"name": "dig", "duration": trial.draw(1, 50, 1), "drainage": "drained", "remove": ["part1"], "factor": False}]
    summary = trial.calculate("drawn", case)
    last = get_steps(summary, 0)[-1]
    trial.near("heave", last["heave"], weight * depth * height / stiffness, 0.01)
    trial.near("excess pressure", last["excess"], 0, 1e-3, weight * depth)
    trial.near("least excess pressure", last.get("least_excess") or 0, 0, 1e-3, weight * depth)
    trial.expect(any("hydraulic" in w for w in summary["warnings"]), "no warning names the missing [[hydraulic]]")


def compute_terzaghi(time_factor):
    """Degree of consolidation, and the excess pressure at the impervious end over that at the start."""
    degree, end = 1.0, 0.0
    for i in range(200):
        m = math.pi * (2 * i + 1) / 2
        degree -= 2 / m**2 * math.exp(-m * m * time_factor)
        end += 2 / m * math.sin(m) * math.exp(-m * m * time_factor)
    return degree, end


def judge_terzaghi(trial):
    """A wide load at once on elastic ground that drains at the top: settlement and pore pressure in time, and none left at the end; also as a
    wide cut, which heaves and leaves suction."""
    height = trial.draw(4, 10, 2)
    is_cut = trial.rng.random() < 0.4
    depth = trial.draw(1, 3, 2)
    case, width, stiffness, weight = make_column(trial, [0, height, round(height + depth, 2)] if is_cut else [0, height], round(height / 14, 3))
    load = weight * depth if is_cut else trial.draw(5, 60, 1) * 1e3
    change = {"remove": ["part1"]} if is_cut else {"add": ["fill"]}
    if not is_cut:
        case["surcharge"] = [{"name": "fill", "x": [0, width], "load": [load / 1e3, load / 1e3]}]
    else:
        case["initial"]["water_table"] = [[0, height], [width, height]]
        case["geometry"]["line"][0]["points"] = [[0, height], [width, height]]
    case["hydraulic"] = [{"on": "ground", "condition": "total_head", "head": height}]
    speed = float(case["materials"]["soil"]["water"]["conductivity"].split()[0]) * stiffness / WATER
    factor = trial.draw(0.08, 0.6)
    duration = factor * height**2 / speed / DAY
    case["construction"] = [{"name": "change", "duration": 0, "factor": False, **change}, {"name": "pause", "duration": duration, "factor": False},
                            {"name": "end", "duration": 20 * height**2 / speed / DAY, "factor": False}]
    case["output"] = {"monitor": [{"name": "top", "at": [0.5 * width, height]}, {"name": "base", "at": [0.5 * width, 0]}]}
    summary = trial.calculate("drawn", case)
    sign = -1 if is_cut else 1
    whole = load * height / stiffness
    degree, base = compute_terzaghi(factor)
    ends = [get_steps(summary, i)[-1] for i in range(3)]
    excess = "least_excess" if is_cut else "excess"
    settlement = "heave" if is_cut else "settlement"
    trial.near(f"{excess} at once", ends[0].get(excess), sign * load, 0.02)
    trial.near(f"{settlement} at T = {factor}", ends[1].get(settlement), degree * whole, 0.02)
    trial.near(f"{excess} at T = {factor}", ends[1].get(excess), sign * base * load, 0.02, load)
    trial.near(f"{settlement} at the end", ends[2].get(settlement), whole, 0.01)
    trial.near(f"{excess} at the end", ends[2].get(excess) or 0, 0, 2e-3, load)
    results = read_results(summary)
    trial.near(f"construction[end].{settlement}", results.get(f"construction[end].{settlement}"), whole, 0.01)


def judge_rest(trial):
    """Pool and groundwater rise or fall together and stay for years: the flow is at rest, so that nothing is left of the excess pressure."""
    height, rise = trial.draw(3, 8, 2), trial.draw(-2, 5, 2)
    case, _, _, _ = make_column(trial, [0, height], round(height / 8, 3))
    case["materials"]["soil"] |= {"model": "mohr_coulomb", "cohesion": trial.draw(5, 30), "friction_angle": trial.draw(20, 35), "dilatancy_angle": 0,
                                  "tensile_strength": 0, "water": {"retention": "saturated", "conductivity": "1e-7 m/s"}}
    end = round(height + (rise if rise > 0 else 0.3 * rise), 3)
    case["hydraulic"] = [{"on": "ground", "condition": "total_head", "head": [["0 day", height], ["30 day", end]]}]
    case["construction"] = [{"name": "rise", "duration": 30, "factor": False}, {"name": "rest", "duration": 3000, "factor": False}]
    last = get_steps(trial.calculate("drawn", case), 1)[-1]
    scale = max(abs(end - height), 0.1) * WATER
    trial.near("excess pressure at rest", last["excess"], 0, 2e-3, scale)
    trial.near("least excess pressure at rest", last.get("least_excess") or 0, 0, 2e-3, scale)


def judge_dry_cut(trial):
    """A wide cut in soil without water: heave γ d H/E_oed, in the results under its name."""
    height, depth = trial.draw(4, 9, 2), trial.draw(1, 4, 2)
    case, _, stiffness, _ = make_column(trial, [0, height, round(height + depth, 2)], trial.draw(0.4, 0.8))
    soil = case["materials"]["soil"]
    for key in ("water", "grain_density", "porosity"):
        del soil[key]
    soil["unit_weight"] = trial.draw(16, 21)
    case["initial"] = {"stress": "k0"}
    case["construction"] = [{"name": "dig", "duration": trial.draw(0, 20, 0), "remove": ["part1"], "factor": False}]
    results = trial.results("drawn", case)
    trial.near("construction[dig].heave", results.get("construction[dig].heave"), soil["unit_weight"] * 1e3 * depth * height / stiffness, 0.01)


def judge_layers(trial):
    """Layers of elastic soil under a wide load: Σ q d/E_oed, dry or drained, and nothing is left when the load is taken away."""
    count = trial.rng.choice((1, 2, 3))
    levels = [0.0]
    for _ in range(count):
        levels.append(round(levels[-1] + trial.draw(1, 4, 2), 2))
    case, width, _, _ = make_column(trial, levels, 0.5)
    right, load = 0.0, trial.draw(5, 80, 1)
    case["materials"] = {}
    for i, (a, b) in enumerate(zip(levels, levels[1:])):
        other, _, stiffness, _ = make_column(trial, [0, 1], 1)
        case["materials"][f"soil{i}"], case["regions"][f"part{i}"] = other["materials"]["soil"], f"soil{i}"
        right += load * 1e3 * (b - a) / stiffness
        if trial.rng.random() < 0.4:
            del case["materials"][f"soil{i}"]["water"]
    case["surcharge"] = [{"name": "fill", "x": [0, width], "load": [load, load]}]
    case["hydraulic"] = [{"on": "ground", "condition": "total_head", "head": levels[-1]}]
    if "water" not in case["materials"][f"soil{count - 1}"]:
        del case["hydraulic"]
    case["construction"] = [{"name": "on", "duration": trial.rng.choice((0, 10)), "drainage": "drained", "add": ["fill"], "factor": False},
                            {"name": "off", "duration": 1, "drainage": "drained", "remove": ["fill"], "factor": False}]
    summary = trial.calculate("drawn", case)
    trial.near("settlement under the load", get_steps(summary, 0)[-1]["settlement"], right, 2e-3)
    last = get_steps(summary, 1)[-1]
    trial.near("displacement after it", max(abs(last["settlement"]), abs(last["heave"])), 0, 1e-6, right)
