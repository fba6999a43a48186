# SPDX-License-Identifier: MIT
"""The factor beside γ_R of run, study and timeline, against the closed form of a plane."""
import csv
import math

from .supports import make_slope

# γ_c and γ_φ, γ_cu, γ_G, γ_Q, γ_R (docs/manual/how-to/eurocode-7.md)
SETS = {"DA1-1": (1, 1, 1.35, 1.5, 1.0), "DA1-2": (1.25, 1.4, 1, 1.3, 1.0), "DA2": (1, 1, 1.35, 1.5, 1.1), "DA3": (1.25, 1.4, 1, 1.3, 1.0),
        "EN1998-5": (1.25, 1.4, 1, 1, 1.0), "AASHTO-0.75": (1, 1, 1, 1, 1 / 0.75), "AASHTO-0.65": (1, 1, 1, 1, 1 / 0.65)}


def draw_plane(trial):
    """A cut with a plane through its toe; and its factor for given partial factors."""
    height = trial.draw(4, 12)
    run = round(height * trial.rng.uniform(0.2, 1.0), 3)
    slope = trial.rng.uniform(0.5, 0.85) * math.atan2(height, run)
    case = make_slope(trial, height, run)
    if trial.rng.random() < 0.3:
        case["materials"]["soil"] |= {"friction_angle": 0, "cohesion": trial.draw(20, 60)}
    case["lem"] |= {"methods": ["janbu"], "surface": [{"name": "plane", "points": [[-height / math.tan(slope), height], [0, 0]]}], "reject": False}
    soil = case["materials"]["soil"]
    width = height / math.tan(slope) - run
    weight = 0.5 * soil["unit_weight"] * height * width
    tan, load, is_variable = math.tan(math.radians(soil["friction_angle"])), trial.rng.choice((0, trial.draw(5, 40, 1))), trial.rng.random() < 0.6
    if load:
        case["surcharge"] = [{"name": "yard", "x": [-run - 0.8 * width, -run - 0.2 * width], "load": [load, load], "variable": is_variable}]

    def compute(set_name):
        material, undrained, permanent, variable, resistance = SETS[set_name]
        whole = permanent * weight + (variable if is_variable else permanent) * load * 0.6 * width
        cohesion = soil["cohesion"] / (material if tan else undrained)
        factor = (cohesion * height / math.sin(slope) + whole * math.cos(slope) * tan / material) / (whole * math.sin(slope))
        return factor, factor / resistance
    return case, compute


def judge_sets(trial):
    """A run's over-design factor and each row of a study over the sets are F/γ_R of the closed form."""
    case, compute = draw_plane(trial)
    name = trial.rng.choice(list(SETS))
    factor, over = compute(name)
    summary = trial.calculate("drawn", case | {"partial_factors": {"set": name}})
    trial.near(f"factor, {name}", summary["main_factor"], factor, 1e-3)
    trial.near(f"over-design factor, {name}", summary["methods"]["partial_factors"]["over_design"], over, 1e-3)
    names = trial.rng.sample(list(SETS), 3)
    study = case | {"partial_factors": {"set": names[0]}, "study": {"mode": "grid", "vary": [{"key": "partial_factors.set", "values": names}]}}
    verdict = trial.call("study", study, command="study")
    trial.expect(verdict.code == 0, f"the study ends with {verdict.code}: {verdict.said.strip()[-200:]}")
    table = trial.folder / "study" / "study.csv"
    rows = list(csv.reader(open(table, encoding="utf-8"))) if table.exists() else []
    for number, one in enumerate(names):
        numbers = []
        for cell in rows[number + 1] if number + 1 < len(rows) else []:
            try:
                numbers.append(float(cell))
            except ValueError:
                pass
        for what, right in zip(("F", "F/γ_R"), compute(one)):
            trial.expect(any(abs(n / right - 1) < 1e-3 for n in numbers), f"study.csv has no {what} = {right:.4f} of {one}: {numbers}")


def judge_timeline(trial):
    """Rising water in a slope: the timeline of a case with γ_R fails when that of the case without fails below γ_R, and ends in the factor of steady flow."""
    height = trial.draw(5, 9)
    run = round(1.8 * height, 3)
    case = make_slope(trial, height, run)
    soil = case["materials"]["soil"]
    soil |= {"porosity": 0.4, "water": {"retention": "van_genuchten", "reference_pressure": 10, "lambda": 0.5, "conductivity": "1e-5 m/s"}}
    case["lem"] |= {"methods": ["bishop"], "reject": False, "surface": [{"name": "circle", "centre": [0.3 * height, 1.9 * height], "radius": 2.05 * height}]}
    case["geometry"] |= {"line": [{"name": "inland", "points": [[-5 * height, -2 * height], [-5 * height, height]]},
                                  {"name": "front", "points": [[0, 0], [4 * height, 0]]}]}
    case |= {"mesh": {"size": round(0.6 * height, 3)}, "initial": {"pore_pressure": "seepage"},
             "timeline": {"duration": "400 day", "times": ["5 day", "400 day"]}}
    case["hydraulic"] = [{"on": "inland", "condition": "total_head", "head": [["0 day", -0.5 * height], ["1 day", 0.8 * height]]},
                         {"on": "front", "condition": "total_head", "head": 0}]
    plain = trial.calculate("plain", case)["timeline"]
    steady = {k: v for k, v in case.items() if k != "timeline"} | {"hydraulic": [case["hydraulic"][0] | {"head": 0.8 * height}, case["hydraulic"][1]]}
    trial.near("factor after 400 days", plain["factors"][-1]["factor"], trial.calculate("steady", steady)["main_factor"], 2e-3)
    resistance = trial.draw(1.05, 1.6)
    # half of the targets lie between the factors in time
    target = trial.draw(0.8, 1.4) if trial.number % 2 else round(0.5 * (plain["factors"][0]["factor"] + plain["least"]) / resistance, 4)
    case["timeline"]["target"] = target
    designed = trial.calculate("designed", case | {"partial_factors": {"set": "by_hand", "resistance": resistance}})
    case["timeline"]["target"] = target * resistance
    raised = trial.calculate("raised", case)
    a, b = designed["timeline"], raised["timeline"]
    trial.expect(bool(a["failure"]) == bool(b["failure"]), f"failure with γ_R: {a['failure']}, without at target × γ_R: {b['failure']}")
    trial.expect(bool(a["failure"] or a["fails_from_start"]) == (a["least"] / resistance < target),
                 f"least {a['least']:.4f}/{resistance} and target {target}: failure {a['failure']}")
    trial.expect(a["fails_from_start"] == b["fails_from_start"], "fails_from_start differs")
    if a["failure"] and b["failure"]:
        trial.near("time of failure", a["failure"]["to"], b["failure"]["to"], 1e-6)
