# SPDX-License-Identifier: MIT
"""Hostile changes of valid cases: `check` accepts what `run` computes and refuses what it refuses, each with one sentence."""
import copy
import json
import re

from published.rewritten import read_case
from reliability.trial import SMALL, run

from .exits import draw_dam
from .stages import make_column
from .supports import draw_bar, make_slope

CASES, SHAPES, SECONDS = 4, 6, 4  # changed cases and named ones of a trial, and the seconds after which a run counts as computing
NUMBERS = [0, -1, 1e-6, 1e6, 1e300, -1e300, 1e-300, float("nan"), float("inf"), float("-inf"), 1.5, 7]


def make_flow(trial):
    case, _ = draw_dam(trial)
    foot = case["geometry"]["line"][1]["points"][1][0]
    case["seepage"] = {"section": [{"name": "below", "points": [[0.5 * foot, -2], [0.5 * foot, 1]]}],
                       "heave": [{"name": "toe", "x": [foot, foot + 2], "level": -1}]}
    return case


def make_bars(trial):
    height = trial.draw(4, 8)
    run_ = round(0.6 * height, 3)
    case = make_slope(trial, height, run_)
    case["lem"] |= {"methods": ["bishop"], "search": "entry_exit", "noncircular": False, "entry_exit": {"entries": 5, "exits": 5, "depths": 4}}
    case["support"] = {"bar": draw_bar(trial, height, run_, "nail"), "tie": draw_bar(trial, height, run_, "anchor") | {"prestress": 50},
                       "row": {"kind": "pile", "x": [-0.3 * run_], "length": height, "out_of_plane_spacing": 2, "lateral_resistance": 100}}
    case["surcharge"] = [{"name": "yard", "x": [-3 * height, -1.5 * height], "load": [10, 10]}]
    case["initial"] = {"pore_pressure": "water_table", "water_table": [[-5 * height, 0.4 * height], [0, 0], [4 * height, 0]]}
    return case


def make_wall(trial):
    depth = trial.draw(2, 4)
    return {"title": "Sheet pile", "analysis": {"methods": ["fem"]}, "regions": {"sand": "sand"}, "fem": {"size": 2, "meshes": 1, "resolution": 0.1},
            "geometry": {"ground": [[0, depth], [12, depth], [12, 0], [24, 0]], "layer": [{"name": "sand", "level": -6}]},
            "materials": {"sand": {"model": "mohr_coulomb", "unit_weight": 18, "cohesion": 5, "friction_angle": 32, "dilatancy_angle": 0, "tensile_strength": 0,
                                   "young_modulus": "30 MPa", "poisson_ratio": 0.3}},
            "support": {"sheet": {"kind": "wall", "line": [[12, depth], [12, 0.3], [12, -3]], "axial_stiffness": 2e6, "bending_stiffness": 5e4,
                                  "plastic_moment": 180, "interface_strength": 0.67, "strut_levels": [depth - 0.5], "strut_stiffness": 2e4,
                                  "strut_strength": 200, "weight": 8}}}


def make_stages(trial):
    height = trial.draw(4, 8, 2)
    case, width, _, _ = make_column(trial, [0, height, height + 2], 1)
    case["surcharge"] = [{"name": "fill", "x": [0, width], "load": [5, 5]}]
    case["hydraulic"] = [{"on": "ground", "condition": "total_head", "head": [["0 day", height + 2], ["5 day", height + 1]]}]
    case["construction"] = [{"name": "load", "duration": 0, "add": ["fill"], "factor": False},
                            {"name": "dig", "duration": 5, "remove": ["part1", "fill"], "factor": False}]
    case["output"] = {"monitor": [{"name": "top", "at": [0.5 * width, height]}], "section": [{"name": "line", "from": [0, height], "to": [width, height]}]}
    return case


def make_nails(trial):
    """Nails that are added in the stage after a cut."""
    return {"title": "Nailed pit", "analysis": {"methods": ["fem", "lem"]}, "fem": {"size": 2, "meshes": 1, "resolution": 0.1},
            "lem": {"methods": ["bishop"], "noncircular": False, "referee": False, "entry_exit": {"entries": 4, "exits": 4, "depths": 3}},
            "geometry": {"polygon": [{"name": "silt", "points": [[0, -4], [24, -4], [24, 2], [13, 2], [12, 6], [0, 6]]},
                                     {"name": "cut", "points": [[13, 2], [24, 2], [24, 6], [12, 6]]}]},
            "regions": {"silt": "silt", "cut": "silt"}, "initial": {"stress": "k0", "k0": 0.5},
            "materials": {"silt": {"model": "mohr_coulomb", "unit_weight": 19, "cohesion": trial.draw(8, 20), "friction_angle": 30, "dilatancy_angle": 0,
                                   "tensile_strength": 0, "young_modulus": "30 MPa", "poisson_ratio": 0.3}},
            "support": {"nails": {"kind": "nail", "heads": [[12.25, 5], [12.75, 3]], "inclination": 10, "length": 5, "out_of_plane_spacing": 1.5,
                                  "tensile_strength": 100, "plate": 50, "bond": 20, "axial_stiffness": 5e4}},
            "construction": [{"name": "dig", "duration": 2, "drainage": "drained", "remove": ["cut"], "factor": False},
                             {"name": "nail", "duration": 1, "drainage": "drained", "add": ["nails"]}],
            "output": {"monitor": [{"name": "crest", "at": [12, 6]}]}}


def make_motion(trial):
    case = read_case(SMALL)
    case["output"]["monitor"] = [{"name": "crest", "at": [5, 5]}]
    case["stage"][1]["duration"] = 0.3
    return case


BASES = [make_flow, make_bars, make_wall, make_stages, make_nails, make_motion]


def list_places(tree, path=()):
    """The path of every table, list and leaf below the root."""
    found = [path] if path else []
    for key, value in tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ():
        found += list_places(value, (*path, key))
    return found


def get(tree, path):
    for key in path:
        tree = tree[key]
    return tree


def change_number(rng, parent, key, value):
    parent[key] = rng.choice([*NUMBERS, value * 1e3, -value, value * 1e-7, value + 1e-6, value + 1])


def change_list(rng, parent, key, value):
    """An entry doubled, dropped, turned; a line that returns on itself; a crossing."""
    kind = rng.randrange(6)
    if kind == 0 and value:
        value.insert(rng.randrange(len(value)), copy.deepcopy(rng.choice(value)))
    elif kind == 1 and value:
        value.pop(rng.randrange(len(value)))
    elif kind == 2:
        value.reverse()
    elif kind == 3:
        value += copy.deepcopy(value[:-1][::-1])
    elif kind == 4 and len(value) > 1:
        i, j = rng.sample(range(len(value)), 2)
        value[i], value[j] = value[j], value[i]
    else:
        value.clear()


def mutate(rng, case):
    """A changed copy, and the change in words."""
    case = copy.deepcopy(case)
    path = rng.choice([p for p in list_places(case) if p[0] != "title"])
    parent, key = get(case, path[:-1]), path[-1]
    value = parent[key]
    kind = "removed" if rng.random() < 0.2 else "changed"
    if kind == "removed":
        del parent[key]
    elif isinstance(value, bool):
        parent[key] = not value
    elif isinstance(value, (int, float)):
        change_number(rng, parent, key, value)
    elif isinstance(value, list):
        change_list(rng, parent, key, value)
    elif isinstance(value, str):
        words = [get(case, p) for p in list_places(case)]
        parent[key] = rng.choice([w for w in words if isinstance(w, str)] + ["", "0 m", "nan", "1e400"])
    elif isinstance(parent, list):
        parent.append(copy.deepcopy(value))
    else:
        parent[f"{key} 2" if rng.random() < 0.5 else f"{key}2"] = copy.deepcopy(value)
    return case, f"{'.'.join(map(str, path))} {kind}"


def find_unclear(said):
    """Why a message is no clear sentence; empty where it is one."""
    errors = [line for line in said.splitlines() if "error: " in line]
    if not errors:
        return "no line with 'error: '"
    text = " ".join(errors)
    for word in ("std::", "terminate", "exception", "assert", "bad_alloc", "Traceback", "internal", "what()"):
        if word in text:
            return f"'{word}' in the message"
    return f"a message of {len(errors[0])} letters" if len(errors[0]) > 900 else ""


def judge_case(trial, name, case, label):
    path = trial.write(name, case)
    checked = run(trial.program, ["check", path], 60)
    ran = run(trial.program, ["run", path, "-o", trial.folder / name, "-q", "--no-report", "--threads", "1"], SECONDS)
    for what, verdict in (("check", checked), ("run", ran)):
        trial.expect(not verdict.fault, f"{label}: {what}: {verdict.fault}")
        if verdict.code == 2:
            trial.expect(not find_unclear(verdict.said), f"{label}: {what}: {find_unclear(verdict.said)}: {verdict.said.strip()[-200:]}")
    trial.expect(checked.code in (0, 2), f"{label}: check ends with {checked.code}")
    said = re.sub(r"\s+", " ", (ran.said or checked.said).strip())[-300:]
    trial.expect((checked.code == 2) == (ran.code == 2), f"{label}: check ends with {checked.code}, run with {ran.code}: {said}")
    if ran.code == 0 and (trial.folder / name / "summary.json").exists():
        json.loads((trial.folder / name / "summary.json").read_text())


def judge_changes(trial):
    """Cases of seepage, LEM with supports, walls, stages, nails of a pit and MPM, each with one or two hostile changes."""
    for number in range(CASES):
        case = BASES[(trial.number + number) % len(BASES)](trial)
        changes = []
        for _ in range(trial.rng.choice((1, 1, 2))):
            case, change = mutate(trial.rng, case)
            changes.append(change)
        judge_case(trial, f"case_{number}", case, f"case_{number} ({'; '.join(changes)})")


def judge_named(trial):
    """The places and shapes that `check` once passed and `run` refused, or that were computed without a word: both refuse them."""
    x, far = trial.draw(0.1, 0.9), trial.rng.choice((-1, 1)) * trial.draw(30, 900)
    flow, wall, stages, nails, motion = make_flow(trial), make_wall(trial), make_stages(trial), make_nails(trial), make_motion(trial)
    line = wall["support"]["sheet"]["line"]
    weighed = {k: v for k, v in motion["materials"]["silt"].items() if k not in ("grain_density", "porosity")} | {"unit_weight": 19}

    def place(base, path, value):
        case = copy.deepcopy(base)
        get(case, path[:-1])[path[-1]] = value
        return case
    sheet = ("support", "sheet")
    cases = {
        "monitor outside, stages": place(stages, ("output", "monitor", 0, "at"), [far, 1]),
        "section of discharge outside": place(flow, ("seepage", "section", 0, "points"), [[far, -1], [far + 1, -0.5]]),
        "heave block outside": place(flow, ("seepage", "heave", 0, "x"), [far, far + 1]),
        "heave block below the base": place(flow, ("seepage", "heave", 0, "level"), -50 - x),
        "strut in the soil": place(wall, (*sheet, "strut_levels"), [-1 - x]),
        "strut above the wall": place(wall, (*sheet, "strut_levels"), [line[0][1] + x]),
        "wall on the base": place(wall, (*sheet, "line"), [[10, -6], [14 + x, -6]]),
        "wall of 1 µm": place(wall, (*sheet, "line"), [[12, line[0][1]], [12, line[0][1] - 1e-6]]),
        "folded wall": place(wall, (*sheet, "line"), [[12, line[0][1]], [12, -3], [12, -1 - x]]),
        "crossing wall": place(wall, (*sheet, "line"), [[12, line[0][1]], [12, -4], [15, -4], [9, -1 - x]]),
        "gravity 0 with unit_weight": place(motion, ("materials", "silt"), weighed) | {"gravity": {"acceleration": 0}},
        "nail above the ground of its stage": place(nails, ("support", "nails", "heads"), [[14 + x, 5]]),
        "cohesion nan": place(nails, ("materials", "silt", "cohesion"), float("nan")),
        "head inf": place(flow, ("hydraulic", 0, "head"), float("inf")),
        "conductivity 0": place(flow, ("materials", "sand", "water", "conductivity"), "0 m/s"),
    }
    for name in trial.rng.sample(list(cases), SHAPES):
        path = trial.write(name.replace(" ", "_"), cases[name])
        for command in ("check", "run"):
            verdict = run(trial.program, [command, path, *(["-o", trial.folder / name, "-q", "--no-report"] if command == "run" else [])], SECONDS)
            trial.expect(verdict.code == 2 and not verdict.fault and not find_unclear(verdict.said),
                         f"{name}: {command} ends with {verdict.code}: {verdict.fault or verdict.said.strip()[-200:]}")
    valid = {"flow": flow, "wall": wall, "stages": stages, "nails": nails, "motion": motion, "bars": make_bars(trial)}
    judge_valid(trial, {name: valid[name] for name in trial.rng.sample(list(valid), 2)})


def judge_valid(trial, cases):
    """The cases before the changes are computed."""
    for name, case in cases.items():
        judge_case(trial, f"valid_{name}", case, f"valid {name}")
        verdict = run(trial.program, ["check", trial.folder / f"valid_{name}.toml"], 60)
        trial.expect(verdict.code == 0, f"valid {name} is refused: {verdict.said.strip()[-300:]}")
