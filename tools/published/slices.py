# SPDX-License-Identifier: MIT
"""Limit equilibrium: given surfaces, the circular search and the search of polylines, each against its band."""
from __future__ import annotations

import re

from .case_file import make_case
from .problem import METHODS, find_published, read_given_surfaces, read_problem
from .runs import Broken
from .table import MISS, NOTE, PASS, Row, judge

FIXED, SEARCH, POLYLINE = 0.003, 0.005, 0.02
RECHECK_SLICES = 400
BY_MOMENTS = ("oms", "bishop")  # on a polyline their factor depends on where moments are taken about


def has_value(reference):
    """Returns whether the recomputation has a factor; -1 means none."""
    return isinstance(reference, (int, float)) and reference > 0


def find(results, method, name=None):
    """The entry of a list of solutions for a method of the file (and a given surface)."""
    for result in results or []:
        if result["method"] == METHODS[method] and (name is None or result.get("name") == name):
            return result
    return None


def read_factor(result):
    """(factor or None, refusal): a surface that fails a check may still carry its factor."""
    if result is None:
        return None, "no result"
    factor = result.get("factor") or None
    return factor, (result.get("checks") or {}).get("refusal", "")


def check_given(problem, answers):
    """{(surface, method): factor} of the file for every surface that it gives."""
    recomputed = problem.entry.get("recomputed") or {}
    expected = {}
    for name, values in (recomputed.get("specified_surface") or {}).items():
        expected.update({(name, m): values[m] for m in METHODS if m in values})
    for name, values in (recomputed.get("fixed_circle_400_slices") or {}).items():
        expected.update({(name, m): values["F"][m] for m in METHODS if m in values["F"]})
    specified = set(recomputed.get("specified_surface") or {})
    is_line = {name for name, s in read_given_surfaces(problem) if "points" in s}
    rows = []
    for (name, method), reference in expected.items():
        if not has_value(reference):
            continue
        factor, refusal = read_factor(find(answers.get("given"), method, name))
        verdict, reason = judge(factor, reference, FIXED, FIXED), refusal
        if name in is_line and method in BY_MOMENTS:
            verdict, reason = NOTE, "by moments a polyline's factor depends on the centre: no reference"
        rows.append(Row(problem.id, f"surface {name}", METHODS[method], factor, reference, "±0.3 %", verdict,
                        find_published(problem, method) if name in specified else None, reason))
    return rows


def find_end_above_crack(problem, centre, radius, crack, direction):
    """x where the arc would meet the ground beyond the crack that cuts it off at x = crack."""
    for a, b in zip(problem.ground, problem.ground[1:]):
        u = (b[0] - a[0], b[1] - a[1])
        w = (a[0] - centre[0], a[1] - centre[1])
        p, q, r = u[0] ** 2 + u[1] ** 2, u[0] * w[0] + u[1] * w[1], w[0] ** 2 + w[1] ** 2 - radius**2
        if p == 0 or q * q < p * r:
            continue
        for t in ((-q - (q * q - p * r) ** 0.5) / p, (-q + (q * q - p * r) ** 0.5) / p):
            x = a[0] + t * u[0]
            if -1e-9 <= t <= 1 + 1e-9 and (x - crack) * direction >= 0:
                return x
    return crack


def drop_straight(points):
    """A polyline without the points between its corners."""
    kept = points[:1]
    for i in range(1, len(points) - 1):
        a, p, b = kept[-1], points[i], points[i + 1]
        if abs((p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])) > 1e-9 * ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2):
            kept.append(p)
    return kept + points[-1:]


def describe_surface(problem, result):
    """A result's surface as one that is given, so that it can be calculated again."""
    points = result["points"]
    if not result.get("circle"):
        return {"points": drop_straight(points)}
    centre, radius = result["circle"]["centre"], result["circle"]["radius"]
    ends = [points[0][0], points[-1][0]]
    if problem.entry.get("tension_crack"):
        upper = 1 if result.get("slides_left", points[-1][1] > points[0][1]) else 0
        ends[upper] = find_end_above_crack(problem, centre, radius, ends[upper], 1 if upper else -1)
    return {"circle": (*centre, radius), "ends": ends}


def calculate_again(runner, problem, suffix, surfaces, slices):
    """{(surface, method): (factor, refusal)} of surfaces, given to the program."""
    if not surfaces:
        return {}
    text = make_case(problem, slices, search=False, surfaces=surfaces)
    try:
        answers = runner.run(f"{problem.id}_{suffix}", text)["lem"]
    except Broken as fault:
        return {(name, m): (None, str(fault)) for name, _ in surfaces for m in METHODS}
    return {(name, m): read_factor(find(answers.get("given"), m, name)) for name, _ in surfaces for m in METHODS}


def recheck(runner, problem, found):
    """Factors of the surfaces found, {"kind.method": result}, calculated again with many slices."""
    surfaces = [(name, describe_surface(problem, result)) for name, result in found.items()]
    again = calculate_again(runner, problem, "again", surfaces, RECHECK_SLICES)
    return {name: again[(name, name.split(".")[1])] for name in found}


def describe_reference(problem, values):
    """The recomputed critical surface, its circle put through its two ends on the ground: it is printed rounded."""
    length = problem.units.length
    if "pts" in values:
        return {"points": problem.scale(values["pts"])}
    left, right = sorted(values[key] * length for key in ("x_toe", "x_crest"))
    ground = problem.ground
    ends = []
    for x in (max(left, ground[0][0]), min(right, ground[-1][0])):
        y = next((a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0])
                  for a, b in zip(ground, ground[1:]) if b[0] > a[0] and a[0] <= x <= b[0]), ground[-1][1])
        ends.append((x, y))
    (x0, y0), (x1, y1) = ends
    chord = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
    radius = max(values["R"] * length * (1 + 1e-6), 0.5 * chord)
    rise = (radius**2 - 0.25 * chord**2) ** 0.5
    centre = (0.5 * (x0 + x1) - (y1 - y0) / chord * rise, 0.5 * (y0 + y1) + (x1 - x0) / chord * rise)
    return {"circle": (*centre, radius), "ends": [x0, x1]}


def explain_misses(runner, problem, rows, expected_by_kind, slices):
    """The program's factor of the recomputed surface, where its own search ends higher."""
    wanted = [(row, kind, method, values) for kind, expected in expected_by_kind.items() for method, values in expected.items()
              for row in rows if row.verdict == MISS and row.kind == kind and method in METHODS and row.method == METHODS[method]
              and (row.computed is None or row.computed > values["F"])]
    wanted = [w for w in wanted if "pts" in w[3] or {"R", "x_toe", "x_crest"} <= set(w[3])]
    surfaces = [(f"{kind}.{method}", describe_reference(problem, values)) for _, kind, method, values in wanted]
    again = calculate_again(runner, problem, "theirs", surfaces, slices)
    for row, kind, method, _ in wanted:
        factor, refusal = again[(f"{kind}.{method}", method)]
        if refusal:
            row.reason = f"the recomputed surface is refused: {refusal}" + (f" (factor {factor:.4f})" if factor else "")
        elif factor:
            row.reason = f"the search ends higher; the recomputed surface has {factor:.4f}"


def read_acceptance(caveat):
    """{method: limit} of a caveat such as "accept anything <=0.72 for Spencer/M-P"."""
    found = re.search(r"accept anything <=\s*([\d.]+) for ([\w/ -]+?) with", caveat)
    if not found:
        return {}
    names = {"spencer": "spencer", "m-p": "mp", "mp": "mp", "bishop": "bishop", "janbu": "janbu"}
    return {names[n.strip().lower()]: float(found[1]) for n in found[2].split("/") if n.strip().lower() in names}


def check_search(problem, answers, again, kind, expected, above):
    rows = []
    results = answers.get("critical" if kind == "circle" else "noncircular")
    caveat = problem.entry.get("caveat", "")
    accepted = read_acceptance(caveat)
    for method, values in expected.items():
        if method not in METHODS:
            continue
        reference = values.get("F")
        if not has_value(reference):
            continue
        factor, refusal = read_factor(find(results, method))
        verdict, reason = judge(factor, reference, None, above), refusal
        if verdict == PASS and factor < reference * (1 - FIXED):
            checked, refused = again.get(f"{kind}.{method}", (None, "not calculated again"))
            if refused or checked is None:
                verdict, reason = MISS, f"lower, and not admissible: {refused}"
            elif abs(checked / factor - 1) > FIXED:
                verdict, reason = MISS, f"lower, but {checked:.4f} as a given surface with {RECHECK_SLICES} slices"
            else:
                reason = f"lower and admissible; {checked:.4f} as a given surface with {RECHECK_SLICES} slices"
        limit = accepted.get(method)
        if verdict == MISS and limit and factor and factor <= limit and not refusal:
            verdict, reason = PASS, f"accepted up to {limit:g} by the problem: {caveat}"
        elif caveat:
            reason = "; ".join(filter(None, [reason, f"caveat: {caveat}"]))
        what = "critical circle" if kind == "circle" else "critical polyline"
        rows.append(Row(problem.id, what, METHODS[method], factor, reference, f"≤ +{100 * above:g} %", verdict,
                        find_published(problem, method), reason, kind=kind))
    return rows


def check_published_only(problem, answers):
    """Without a recomputation: inside the published values, 2 % more on both sides."""
    rows = []
    name = next((n for n, _ in read_given_surfaces(problem)), None)
    kind, results, what = "circle", answers.get("critical"), "critical circle"
    if name:
        kind, results, what = "", answers.get("given"), f"surface {name}"
    elif problem.entry.get("search") == "polyline":
        kind, results, what = "polyline", answers.get("noncircular"), "critical polyline"
    for method in METHODS:
        published = find_published(problem, method)
        if published is None:
            continue
        factor, refusal = read_factor(find(results, method, name))
        rows.append(Row(problem.id, what, METHODS[method], factor, published, "published ±2 %",
                        judge(factor, published, 0.02, 0.02), published, refusal, kind=kind))
    return rows


def compare_moment_methods(problem, answers):
    """Without friction Bishop's critical factor is Fellenius'."""
    if any(m["phi"] for m in problem.materials):
        return []
    bishop, _ = read_factor(find(answers.get("critical"), "bishop"))
    fellenius, _ = read_factor(find(answers.get("critical"), "oms"))
    if not (bishop and fellenius):
        return []
    return [Row(problem.id, "φ = 0: critical circle, Bishop's against Fellenius'", "bishop", bishop, fellenius, "±0.1 %",
                judge(bishop, fellenius, 0.001, 0.001))]


def verify(runner, entry, slices):
    """All rows of one problem, and the text of its case."""
    problem = read_problem(entry)
    recomputed = entry.get("recomputed") or {}
    circular, polyline = recomputed.get("circular_search") or {}, recomputed.get("noncircular_search") or {}
    search = bool(circular or polyline or not read_given_surfaces(problem))
    noncircular = bool(polyline) or entry.get("search") == "polyline"
    text = make_case(problem, slices, search, noncircular, finite_elements="recomputed_fem_srm_bracket" in entry)
    try:
        answers = runner.run(problem.id, text)["lem"]
    except Broken as fault:
        return [Row(problem.id, "limit equilibrium", "all", None, None, "", MISS, None, str(fault))]
    rows = []
    if problem.unknown:
        rows.append(Row(problem.id, "input", "", None, None, "", NOTE, None,
                        f"keys that are not of the schema are left out: {', '.join(problem.unknown)}"))
    found = {}
    for kind, expected in (("critical", circular), ("noncircular", polyline)):
        for method in expected:
            result = find(answers.get(kind), method) if method in METHODS else None
            reference = expected[method].get("F")
            if result and result.get("factor") and has_value(reference) and result["factor"] < reference * (1 - FIXED):
                found[f"{'circle' if kind == 'critical' else 'polyline'}.{method}"] = result
    again = recheck(runner, problem, found)
    rows += check_given(problem, answers)
    rows += check_search(problem, answers, again, "circle", circular, SEARCH)
    rows += check_search(problem, answers, again, "polyline", polyline, POLYLINE)
    explain_misses(runner, problem, rows, {"circle": circular, "polyline": polyline}, slices)
    rows += compare_moment_methods(problem, answers)
    if not recomputed:
        rows += check_published_only(problem, answers)
    return rows
