# SPDX-License-Identifier: MIT
"""Problems with a closed form, and identities: planes, an infinite slope, partial factors, k_y, FOSM."""
from __future__ import annotations

import math
import re

from .case_file import make_case
from .problem import METHODS, read_given_surfaces, read_problem
from .runs import Broken
from .slices import find, read_factor
from .table import MISS, NOTE, PASS, Row, judge

EXACT, SEARCH = 0.003, 0.005


def make_entry(name, title, ground, c, phi, gamma, base, **more):
    return {"id": name, "title": title, "units": "SI", "ground": ground, "base_elev": base,
            "materials": [{"name": "soil", "c": c, "phi": phi, "gamma": gamma}], **more}


def run_surface(runner, entry, points, slices=200):
    text = make_case(read_problem(entry), slices, search=False, surfaces=[("plane", {"points": points})])
    return runner.run(entry["id"], text)["lem"].get("given")


def plane_rows(name, what, given, reference, methods=("janbu", "spencer", "mp")):
    """On a plane every method that keeps horizontal equilibrium has the block's factor."""
    rows = []
    for method in methods:
        factor, refusal = read_factor(find(given, method, "plane"))
        rows.append(Row(name, what, METHODS[method], factor, reference, "±0.3 %", judge(factor, reference, EXACT, EXACT), None, refusal))
    return rows


def infinite_slope(runner, check, lem):
    rows = []
    for name, reference in check["values"].items():
        found = re.match(r"phi([\d.]+)_beta([\d.]+)", name)
        if not found:
            tangents = re.search(r"tan([\d.]+)/tan([\d.]+)", name)
            if tangents:
                value = math.tan(math.radians(float(tangents[1]))) / math.tan(math.radians(float(tangents[2])))
                rows.append(Row(check["id"], name, "formula", value, reference, "±0.3 %", judge(value, reference, EXACT, EXACT), None,
                                "arithmetic of the file only; the slope itself is ACADS-2a"))
            continue
        phi, beta = float(found[1]), math.radians(float(found[2]))
        height, depth = 100.0, 0.2
        run = height / math.tan(beta)
        entry = make_entry(f"{check['id']}-{found[1]}", f"Dry slope without cohesion at {found[2]} degrees, a thin plane slice",
                           [[-20, 20], [0, 20], [run, 20 + height], [run + 20, 20 + height]], 0, phi, 20, 0)
        # parallel to the face, `depth` under it measured vertically
        t = math.tan(beta)
        x0, x1 = 1.0 / t, (height - 1.0) / t
        points = [(round(x0, 6), round(20 + x0 * t, 9)), (round(x0 + 2 * depth / t, 6), round(20 + x0 * t + depth, 9)),
                  (round(x1 - 0.01, 6), round(20 + (x1 - 0.01) * t - depth, 9)), (round(x1, 6), round(20 + x1 * t, 9))]
        rows += plane_rows(check["id"], f"φ = {found[1]}°, β = {found[2]}°, 0.2 m under the face", run_surface(runner, entry, points),
                           reference, ("janbu", "spencer", "mp"))
    return rows


def plane_from_toe(runner, check, lem):
    angle = float(re.search(r"at ([\d.]+) deg", check["what"])[1])
    (x, y), values = read_face(check["what"]), read_strength(check["what"])
    entry = make_entry(check["id"], check["what"], [[-10, 0], [0, 0], [x, y], [x + 4 * y, y]], *values, -10)
    end = y / math.tan(math.radians(angle))
    return plane_rows(check["id"], f"plane at {angle:g}°", run_surface(runner, entry, [(0, 0), (round(end, 9), y)]), check["F"])


def read_face(text):
    found = re.search(r"face \(0,0\)-\(([\d.]+),([\d.]+)\)", text)
    return float(found[1]), float(found[2])


def read_strength(text):
    return tuple(float(re.search(rf"{key}=([\d.]+)", text)[1]) for key in ("c", "phi", "gamma"))


def block_with_crack(runner, check, lem):
    angle = math.radians(float(re.search(r"plane ([\d.]+) deg", check["what"])[1]))
    bottom = float(re.search(r"to y=([\d.]+)", check["what"])[1])
    water = float(re.search(r"water ([\d.]+) m", check["what"])[1])
    (x, y), values = read_face(check["what"]), read_strength(check["what"])
    end = y / math.tan(angle)  # of the plane on the crest, above the crack
    at_crack = bottom / math.tan(angle)
    entry = make_entry(check["id"], check["what"], [[-20, 0], [0, 0], [x, y], [end + 40, y]], *values, -10,
                       tension_crack={"depth": y - bottom, "water": water},
                       piezo=[[-20, 0], [0, 0], [at_crack, bottom + water], [end + 40, bottom + water]])
    given = run_surface(runner, entry, [(0, 0), (round(end, 9), y)])
    return plane_rows(check["id"], "plane with a crack and water", given, check["F"])


def partial_factors(runner, check, lem):
    problem = read_problem(lem["BRIEF-1"])
    rows = []
    plain = runner.run("CF-EC7_plain", make_case(problem, 100, True, surfaces=[]))["lem"]
    text = make_case(problem, 100, True, surfaces=[]) + '\n[partial_factors]\nset = "DA1-2"\n'
    design = runner.run("CF-EC7_design", text)["lem"]
    for method, (characteristic, factored) in (("bishop", check["bishop"]), ("spencer", check["spencer"])):
        before, _ = read_factor(find(plain.get("critical"), method))
        after, refusal = read_factor(find(design.get("critical"), method))
        rows.append(Row(check["id"], "characteristic values", METHODS[method], before, characteristic, "≤ +0.5 %",
                        judge(before, characteristic, EXACT, SEARCH)))
        rows.append(Row(check["id"], "DA1-2", METHODS[method], after, factored, "≤ +0.5 %", judge(after, factored, EXACT, SEARCH), None, refusal))
        if before and after:
            rows.append(Row(check["id"], "ratio of the two", METHODS[method], before / after, 1.25, "±0.1 %",
                            judge(before / after, 1.25, 0.001, 0.001)))
    return rows


def submerged(runner, check, lem):
    rows, factors = [], {}
    for name in ("DW-70a", "DW-70b"):
        text = make_case(read_problem(lem[name]), 100, True, surfaces=[])
        answers = runner.run(f"{check['id']}_{name}", text)["lem"]
        for method in ("bishop", "spencer"):
            factors[name, method], refusal = read_factor(find(answers.get("critical"), method))
            rows.append(Row(check["id"], name, METHODS[method], factors[name, method], check[method], "≤ +0.5 %",
                            judge(factors[name, method], check[method], EXACT, SEARCH), None, refusal))
    for method in ("bishop", "spencer"):
        a, b = factors["DW-70a", method], factors["DW-70b", method]
        if a and b:
            rows.append(Row(check["id"], "higher pool over lower", METHODS[method], b / a, 1.0, "±0.1 %", judge(b / a, 1.0, 0.001, 0.001)))
    return rows


def yield_acceleration(runner, check, lem):
    entry = lem["BRIEF-1"]
    text = make_case(read_problem(entry), 100, True, surfaces=[]).replace("yield_acceleration = false", "yield_acceleration = true")
    static = runner.run(check["id"], text)["lem"]
    rows = []
    for method in ("bishop", "spencer"):
        k = (find(static.get("critical"), method) or {}).get("yield_acceleration")
        rows.append(Row(check["id"], "k_y of the critical circle at rest", METHODS[method], k, check[method], "≥ −0.3 %",
                        PASS if k and k >= check[method] * (1 - EXACT) else MISS, None, "the least k_y of all circles lies below it"))
        shaken = read_problem({**entry, "id": f"{check['id']}_{method}", "kh": check[method]})
        answers = runner.run(f"{check['id']}_{method}", make_case(shaken, 100, True, surfaces=[]))["lem"]
        factor, refusal = read_factor(find(answers.get("critical"), method))
        rows.append(Row(check["id"], f"critical circle with k_h = {check[method]:g}", METHODS[method], factor, 1.0, "±0.5 %",
                        judge(factor, 1.0, SEARCH, SEARCH), None, refusal))
    return rows


def critical_acceleration(runner, check, lem):
    found = re.search(r"([\d.]+) m ([\d.]+):1 slope", check["what"])
    height, run = float(found[1]), float(found[1]) * float(found[2])
    rows = []
    for name, case in check["cases"].items():
        ratio = float(name[2:]) if name.startswith("ru") else 0
        entry = make_entry(f"{check['id']}-{name}", f"{check['what']}, {name}",
                           [[-4 * height, height], [0, height], [run, 2 * height], [run + 4 * height, 2 * height]],
                           *read_strength(check["what"]), 0, kh=case["kc"], ru=ratio)
        answers = runner.run(entry["id"], make_case(read_problem(entry), 100, True, surfaces=[]))["lem"]
        values = next(v for key, v in case.items() if key.startswith("my F"))
        for method, reference in zip(("bishop", "spencer"), values):
            factor, refusal = read_factor(find(answers.get("critical"), method))
            rows.append(Row(check["id"], f"{name}, k_h = {case['kc']:g}", METHODS[method], factor, reference, "±1 %",
                            judge(factor, reference, 0.01, 0.01), None, refusal or "size of the model not published"))
    return rows


def tieback(runner, check, lem):
    """With φ = 0 every method of moments has one factor on a circle."""
    rows = []
    for sense in ("passive", "active"):
        problem = read_problem(lem[f"DW-85-{sense}"])
        surfaces = read_given_surfaces(problem)
        given = runner.run(f"{check['id']}_{sense}", make_case(problem, 200, search=False, surfaces=surfaces))["lem"].get("given")
        factor, refusal = read_factor(find(given, "bishop", surfaces[0][0]))
        reference = check[f"{sense}_F"]
        rows.append(Row(check["id"], f"{sense}, on its circle", METHODS["bishop"], factor, reference, "±0.3 %",
                        judge(factor, reference, EXACT, EXACT), None, refusal))
    return rows


HANDLERS = {"CF-inf": infinite_slope, "CF-culmann": plane_from_toe, "CF-priest": block_with_crack, "CF-tieback": tieback,
            "CF-EC7": partial_factors, "CF-submerged": submerged, "CF-ky": yield_acceleration,
            "CF-kc-Loukidis": critical_acceleration}


def verify(runner, check, lem):
    handler = HANDLERS.get(check["id"])
    if handler is None:
        return [Row(check["id"], check.get("what", ""), "", None, None, "", NOTE, None, "no way is known to read this check from the file")]
    try:
        return handler(runner, check, lem)
    except KeyError as name:
        return [Row(check["id"], check.get("what", ""), "", None, None, "", NOTE, None, f"needs the problem {name}, which the file does not have")]
    except Broken as fault:
        return [Row(check["id"], check.get("what", ""), "", None, None, "", MISS, None, str(fault))]
