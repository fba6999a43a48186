# SPDX-License-Identifier: MIT
"""First-order reliability, limit analysis, and what the file holds that other commands or tests verify."""
from __future__ import annotations

import copy
import math
import re

from . import elements
from .case_file import make_case
from .problem import read_problem
from .runs import Broken
from .slices import find, read_factor
from .table import MISS, NOTE, Row, judge

# Tests and tools that verify problems outside this campaign, by problem.
ELSEWHERE = {
    "SY": "tests physics.SeepageInfiltration, cases.WaterFlow; tools/verify_water.py",
    "TERZ": "tests physics.SeepageInfiltration, physics.TwoPhaseConsolidation, cases.WaterColumns; tools/verify_water.py",
    "MANDEL": "test cases.WaterFlow.StripBetweenPlatesHasMandelsPressures; tools/verify_water.py --only poroelastic",
    "RD-USACE-G": "tests physics.LemDrawdownUsace, physics.LemDrawdownStrength",
    "COL2D": "tools/verify_column_collapse.py",
    "GL-1-table": "test physics.SolidSlope.GriffithsAndLanesDisplacements; the factor: GL-1",
    "elem-study": "published T6 1.39 for GL-1, see its rows; linear triangles: the strength reduction theory page",
    "PRANDTL": "tests physics.StripFooting (N_c = 2 + π) and physics.ThickCylinder",
}
NOT_COVERED = {
    "GA": "not verified: sharp wetting fronts (Green and Ampt) are not what Richards' equation gives",
    "RITTER": "not offered: free water has no material",
}


def tell(entry):
    name = entry["id"]
    reason = ELSEWHERE.get(name) and f"verified elsewhere: {ELSEWHERE[name]}"
    reason = reason or NOT_COVERED.get(name) or "not verified by this command"
    return [Row(name, entry.get("title", "drawdown"), "", None, None, "", NOTE, None, reason)]


def find_sensitivities(runner, entry, lem):
    """Central differences over one standard deviation on both sides, each with its own search by Bishop's method."""
    base = lem.get(entry.get("base"))
    if base is None:
        return [Row(entry["id"], "reliability", "", None, None, "", NOTE, None, f"the file has no {entry.get('base')}")]

    def calculate(name, key=None, change=0.0):
        changed = copy.deepcopy(base)
        for material in changed["materials"]:
            if key:
                material[key] = material.get(key, 0) + change
        text = make_case(read_problem(changed), 100, True, surfaces=[])
        factor, refusal = read_factor(find(runner.run(f"{entry['id']}_{name}", text)["lem"].get("critical"), "bishop"))
        if not factor:
            raise Broken(refusal)
        return factor

    try:
        mean = calculate("mean")
        changes = [0.5 * (calculate(f"{k}_up", k, s) - calculate(f"{k}_down", k, -s)) for k, s in entry["sigma"].items()]
    except Broken as fault:
        return [Row(entry["id"], "reliability", "", None, None, "", MISS, None, str(fault))]
    deviation = math.sqrt(sum(c * c for c in changes))
    variation = deviation / mean
    lognormal = math.log(mean / math.sqrt(1 + variation**2)) / math.sqrt(math.log(1 + variation**2))
    rows = []
    for key, value, reference in zip(entry["sigma"], changes, entry["dF_per_sigma"]):
        rows.append(Row(entry["id"], f"change of F per deviation of {key}", "bishop", value, reference, "±0.003",
                        "pass" if abs(value - reference) <= 0.003 else MISS))
    published = [v for v in entry.get("published", {}).values() if isinstance(v, (int, float))]
    for what, value, key, band in (("standard deviation of F", deviation, "sigmaF", 0.02),
                                   ("reliability index, normal", (mean - 1) / deviation, "beta_N", 0.02),
                                   ("reliability index, lognormal", lognormal, "beta_LN", 0.02)):
        if key in entry:
            rows.append(Row(entry["id"], what, "bishop", value, entry[key], "±2 %", judge(value, entry[key], band, band),
                            (min(published), max(published)) if key == "beta_LN" and published else None))
    return rows


SAMPLED = {"c": "cohesion", "phi": "friction_angle", "gamma": "unit_weight", "ru": "pore_pressure_ratio"}


def sample(runner, entry, lem):
    """The same by one `talus study`: first order at the means, and 10,000 samples of normal distributions."""
    base = lem.get(entry.get("base"))
    if base is None or not set(entry["sigma"]) <= set(SAMPLED):
        return []
    problem = read_problem(base)
    units = {"c": problem.units.stress_name, "gamma": problem.units.weight_name, "phi": "deg"}
    text = make_case(problem, 50, True, surfaces=[])
    text = re.sub(r"(\[lem\]\n)methods = .*", r'\1methods = ["bishop"]', text)
    text += '\n[study]\nmode = "sample"\nsamples = 10000\nmethod = "lem"\n'
    for key, deviation in entry["sigma"].items():
        for material in problem.materials:
            value = f'"{deviation} {units[key]}"' if key in units else deviation
            text += (f'\n[[study.random]]\nkey = "materials.{material["key"]}.{SAMPLED[key]}"\ndistribution = "normal"\n'
                     f"deviation = {value}\n")
    try:
        found = runner.run(f"{entry['id']}_study", text, command="study", answer="study.json")["sampling"]
    except Broken as fault:
        return [Row(entry["id"], "talus study", "bishop", None, None, "", MISS, None, str(fault))]
    first, rows = found["first_order"], []
    for what, value, key, band in (("talus study, first order: deviation", first["deviation"], "sigmaF", 0.02),
                                   ("talus study, first order: index, normal", first["index_normal"], "beta_N", 0.02),
                                   ("talus study, first order: index, lognormal", first["index_lognormal"], "beta_LN", 0.02),
                                   ("10,000 samples: deviation of F", found["factor"]["deviation"], "sigmaF", 0.03),
                                   ("10,000 samples: index, normal", found["fits"]["normal"]["index"], "beta_N", 0.03)):
        if key in entry:
            rows.append(Row(entry["id"], what, "bishop", value, entry[key], f"±{100 * band:g} %", judge(value, entry[key], band, band)))
    return rows


def make_limit_entry(name, values):
    """A toe slope on 5 m and more of the same soil, from the numbers of a limit analysis."""
    height = values["H"]
    run = height / math.tan(math.radians(values["beta"]))
    return {"id": name, "title": f"slope of {height:g} m at {values['beta']:g} degrees", "units": "SI",
            "ground": [[-3 * height, height], [0, height], [run, 2 * height], [run + 3 * height, 2 * height]],
            "materials": [{"name": "soil", "c": values["c"], "phi": values["phi"], "gamma": values["gamma"]}], "base_elev": 0,
            "recomputed_fem_srm_bracket": {"psi=0": values.get("my_fem_psi0"), "psi=phi": values.get("my_fem_psi_phi")},
            "log_spiral_upper_bound": values["F_UB"]}


def verify_limit(runner, name, values, meshes):
    return elements.verify(runner, make_limit_entry(name, values), meshes)


def verify_curve(runner, entry, lem, mesh):
    """Griffiths and Lane's example 4 over the ratio of the two strengths, from GL-4-1.0."""
    base = lem.get("GL-4-1.0")
    if base is None:
        return tell(entry)
    rows = []
    for ratio, bracket in entry["my_fem"].items():
        changed = copy.deepcopy(base)
        changed["id"] = f"{entry['id']} {ratio}"
        changed["materials"][1]["c"] = base["materials"][0]["c"] * float(ratio)
        problem = read_problem(changed)
        text = make_case(problem, search=False, surfaces=[], finite_elements=True)
        level = elements.choose_level(problem, mesh)
        size = round(elements.find_height(problem) / level, 6)
        try:
            summary = runner.run(f"{changed['id']}_fem{level}", text,
                                 ['analysis.methods=["fem"]', f"fem.size={size}", "fem.meshes=1", "fem.flow=as_given", "fem.resolution=0.005"])
        except Broken as fault:
            rows.append(Row(changed["id"], "strength reduction", "", None, None, "", MISS, None, str(fault)))
            continue
        factor = summary["fem"]["runs"][0].get("factor")
        rows.append(Row(changed["id"], f"strength reduction, H/{level}", "φ = 0", factor, tuple(bracket), "±2 %",
                        judge(factor, tuple(bracket), 0.02, 0.02)))
    return rows
