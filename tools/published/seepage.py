# SPDX-License-Identifier: MIT
"""Steady seepage: rectangular dams, a ring, a block under recharge, earth dams; heads and discharges."""
from __future__ import annotations

import math
import re

from .flow_case import GAMMA_W, make_flow_case, ramp
from .runs import Broken
from .table import MISS, NOTE, PASS, Row, show_number

HEAD, DISCHARGE = 0.01, 0.02


def head_row(problem, what, method, computed, reference, drop, reason="", extra=0.0):
    """A head or an elevation, within 1 % of the head drop; `extra`: how well the reference can be read [m]."""
    low, high = reference if isinstance(reference, tuple) else (reference, reference)
    allowed = HEAD * drop + extra
    passes = computed is not None and low - allowed <= computed <= high + allowed
    band = "1 % of the drop" + (f" + {extra:g} m read" if extra else "")
    return Row(problem, what, method, computed, reference, band, PASS if passes else MISS, None, reason, "m")


def flow_row(problem, what, computed, reference, unit, reason="", band=DISCHARGE):
    low, high = reference if isinstance(reference, tuple) else (reference, reference)
    passes = computed is not None and low * (1 - band) <= computed <= high * (1 + band)
    return Row(problem, what, "seepage", computed, reference, f"±{100 * band:g} %", PASS if passes else MISS, None, reason, unit)


def find_level(lines, x):
    """Height of the water table at x, the highest where there are several; None where there is none."""
    found = None
    for line in lines:
        for (ax, ay), (bx, by) in zip(line, line[1:]):
            if min(ax, bx) <= x <= max(ax, bx) and ax != bx:
                y = ay + (by - ay) * (x - ax) / (bx - ax)
                found = y if found is None else max(found, y)
    return found


def read_pressure_heads(folder, places, radius):
    """Pressure heads [m] at places, by a plane through the material points around each. Needs h5py."""
    import h5py
    import numpy as np

    with h5py.File(folder / "results.vtkhdf") as file:
        points = np.array(file["VTKHDF/Points"])[:, :2]
        pressure = np.array(file["VTKHDF/PointData/pore_pressure"])  # positive in compression
    heads = []
    for place in places:
        away = points - place
        near = np.hypot(away[:, 0], away[:, 1]) < radius
        terms = np.column_stack([np.ones(near.sum()), away[near]])
        heads.append(float(np.linalg.lstsq(terms, pressure[near], rcond=None)[0][0]) / (1e3 * GAMMA_W))
    return heads


def rectangular_dams(runner, entry):
    """Dupuit's discharge is exact with a seepage face; exit heights and free surfaces from the entry."""
    rows = []
    for dam in entry["exit_height"]:
        h1, h2, length = dam["H1"], dam["H2"], dam["L"]
        n = round(160 / max(1, math.sqrt(length / h1 * 1.3)))  # elements over the height; a limit for their number
        fringe = 1.5 * h1 / n
        name = f"{entry['id']} {h1:g}/{h2:g}/{length:g}"
        ring = [(0, 0), (length, 0), (length, h1), (0, h1)]
        text = make_flow_case(f"Rectangular dam, levels {h1:g} and {h2:g} m, {length:g} m thick", [(0, 0), (length, h1)],
                              [("dam", ring)], {"dam": 1.0}, ramp(fringe), [],
                              [("left", "total_head", h1), ("right", "total_head", h2)], h1 / n)
        try:
            flow = runner.run(name, text)["seepage"]
        except Broken as fault:
            rows.append(Row(name, "seepage", "", None, None, "", MISS, None, str(fault)))
            continue
        rows.append(flow_row(name, "discharge over k (Dupuit)", flow["inflow"], (h1**2 - h2**2) / (2 * length), "m"))
        exits = [e["highest"][1] for e in flow["exits"] if e["name"] == "right"]
        exit_height = dam["exit"] if not isinstance(dam["exit"], list) else tuple(dam["exit"])
        rows.append(head_row(name, "exit height", "seepage", max(exits, default=None), exit_height, h1 - h2))
        surface = entry.get(f"free_surface_{h1:g}_{h2:g}_{length:g}")
        if surface:
            shares = surface.get("x_over_L", [0.1 * i for i in range(len(surface["y"]))])
            pairs = [(find_level(flow["water_table"], s * length), y) for s, y in zip(shares, surface["y"]) if s > 0]
            worst = max(pairs, key=lambda p: abs((p[0] if p[0] is not None else 1e9) - p[1]))
            rows.append(head_row(name, f"free surface, worst of {len(pairs)} places", "seepage", *worst, h1 - h2))
    return rows


def quarter_ring(runner, entry):
    found = re.search(r"r1=([\d.]+) h=([\d.]+), r2=([\d.]+) h=([\d.]+)", entry.get("title", ""))
    r1, h1, r2, h2 = map(float, found.groups()) if found else (10, 30, 30, 10)
    lift = r1 + r2  # both heads above the ring, so that it is saturated and confined: only their difference matters
    n = 48

    def arc(r):
        points = [(r * math.cos(0.5 * math.pi * i / n), r * math.sin(0.5 * math.pi * i / n)) for i in range(n + 1)]
        return [(round(x, 9), round(y, 9)) for x, y in points]

    text = make_flow_case(entry.get("title", "quarter of a ring"), [(0, 0), (r2 * 1.03, r2 * 1.03)],
                          [("ring", arc(r2) + arc(r1)[::-1])], {"ring": 1.0}, [(0, 1), (1e6, 1)],
                          [("inner", arc(r1)), ("outer", arc(r2))],
                          [("inner", "total_head", h1 + lift), ("outer", "total_head", h2 + lift), ("left", "no_flow", None),
                           ("bottom", "no_flow", None)], (r2 - r1) / 20)
    flow = runner.run(entry["id"], text)["seepage"]
    reference = entry.get("q_over_k", 0.5 * math.pi * abs(h1 - h2) / math.log(r2 / r1))
    rows = [flow_row(entry["id"], "discharge over k", flow["inflow"], reference, "m")]
    places = [(r * math.cos(0.25 * math.pi), r * math.sin(0.25 * math.pi)) for r in (r1 + share * (r2 - r1) for share in (0.25, 0.5, 0.75))]
    try:
        computed = read_pressure_heads(runner.get_folder(entry["id"]), places, 0.075 * (r2 - r1))
    except ImportError:
        return rows
    for (x, y), pressure in zip(places, computed):
        r = math.hypot(x, y)
        exact = h1 + (h2 - h1) * math.log(r / r1) / math.log(r2 / r1)
        rows.append(head_row(entry["id"], f"head at r = {r:g} (closed form)", "seepage", pressure + y - lift, exact, abs(h1 - h2)))
    return rows


def find_highest(points, reach):
    """Top of a line, by a parabola through its points around the highest."""
    top = max(points, key=lambda p: p[1])
    near = [(x - top[0], y) for x, y in points if abs(x - top[0]) <= reach]
    sums = [sum(x**n for x, _ in near) for n in range(5)]
    right = [sum(y * x**n for x, y in near) for n in range(3)]

    def determinant(m):
        return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))

    matrix = [sums[i:i + 3] for i in range(3)]
    whole = determinant(matrix)
    c0, c1, c2 = (determinant([[right[r] if c == column else matrix[r][c] for c in range(3)] for r in range(3)]) / whole
                  for column in range(3))
    return (top[0] - 0.5 * c1 / c2, c0 - 0.25 * c1 * c1 / c2) if c2 < 0 else top


def block_under_recharge(runner, entry):
    numbers = {key: float(value) for key, value in re.findall(r"(h1|h2|L|P|k)=([\d.eE+-]+)", entry.get("title", ""))}
    h1, h2, length = numbers.get("h1", 3.75), numbers.get("h2", 3.0), numbers.get("L", 10.0)
    rain, k, height = numbers.get("P", 2.5e-6), numbers.get("k", 1e-5), 5.0
    text = make_flow_case(entry.get("title", "block under recharge"), [(0, 0), (length, height)],
                          [("block", [(0, 0), (length, 0), (length, height), (0, height)])], {"block": k}, ramp(0.25), [],
                          [("left", "total_head", h1), ("right", "total_head", h2), ("top", "flux", rain)], 0.1)
    flow = runner.run(entry["id"], text)["seepage"]
    top = find_highest([p for line in flow["water_table"] for p in line], 0.1 * length)
    answers = [entry[key] for key in ("dupuit", "Slide", "xslope") if key in entry]
    rows = []
    for what, key, value in (("place of the highest water table", "xa", top[0]), ("highest water table", "hmax", top[1])):
        values = [a[key] for a in answers if key in a]
        rows.append(head_row(entry["id"], what, "seepage", value, (min(values), max(values)), height,
                             "between Dupuit's theory and two programs"))
    entered = {d["name"]: d["inflow"] for d in flow["discharges"]}
    added = flow["outflow"] - sum(v for name, v in entered.items() if name != "top")
    rows.append(flow_row(entry["id"], "water that recharge adds", added, entry.get("Q", rain * length), "m²/s"))
    return rows


def homogeneous_dam(runner, entry):
    text = make_flow_case("Earth dam on rock, base 100 m, crest 10 m at 20 m, reservoir at 18.5 m", [(0, 0), (100, 21)],
                          [("dam", [(0, 0), (100, 0), (60, 20), (50, 20)])], {"dam": 6.67e-6}, ramp(2.0),
                          [("upstream", [(0, 0), (50, 20)]), ("downstream", [(60, 20), (100, 0)])],
                          [("upstream", "total_head", 18.5), ("downstream", "seepage_face", None)], 0.7)
    flow = runner.run(entry["id"], text)["seepage"]
    published = entry["Q_m3_per_min"]
    programs = [v for name, v in published.items() if not isinstance(v, list)]
    nets = [v for value in published.values() if isinstance(value, list) for v in value]
    reason = (f"flow nets {show_number((min(nets), max(nets)))}, programs {show_number((min(programs), max(programs)))}: what flows "
              "above the water table is not published; here a fringe of 2 m")
    return [flow_row(entry["id"], "discharge", 60 * flow["outflow"], (min(nets + programs), max(nets + programs)), "m²/min", reason)]


def join_by_logarithms(pairs, parts=6):
    """The table with rows between, on straight lines of the logarithm: the case file joins them by cubics."""
    rows = [(round(pairs[0][0], 6), pairs[0][1])]
    for (s0, k0), (s1, k1) in zip(pairs, pairs[1:]):
        for i in range(1, parts + 1):
            rows.append((round(s0 + (s1 - s0) * i / parts, 6), float(f"{k0 * (k1 / k0) ** (i / parts):.6g}")))
    return rows


def zoned_dam(runner, entry):
    """Fredlund and Rahardjo's dam: pressure heads on the middle line, discharge of another program."""
    k = entry["k_table_psi_m_k"][0][1]
    curve = join_by_logarithms([(-head * GAMMA_W, value / k) for head, value in entry["k_table_psi_m_k"]])
    ring = [(0, 0), (52, 0), (28, 12), (24, 12)]
    up, down, drain = ("upstream", [(0, 0), (24, 12)]), ("downstream", [(28, 12), (52, 0)]), ("drain", [(40, 0), (52, 0)])
    heads, faces = ("upstream", "total_head", 10.0), ("downstream", "seepage_face", None)
    open_drain = ("drain", "pressure", 0)
    ys, read = entry["line_x26_y"], entry.get("read_precision", 0.1)
    # case: (key, lines, conditions, k_x/k_y, core?)
    cases = [("case1_drain_40_52", [up, down, drain], [heads, faces, open_drain], 1, False),
             ("case2_kh9kv", [up, down, drain], [heads, faces, open_drain], 9, False),
             ("case3_core_x24_28_y0_10_k1e9", [up, down, drain], [heads, faces, open_drain], 1, True),
             ("case4_rain_1e8", [up, down, drain, ("crest", [(24, 12), (28, 12)])],
              [heads, ("downstream", "rain", 1e-8), ("crest", "rain", 1e-8), open_drain], 1, False),
             ("case5_seepage_face", [up, down], [heads, faces], 1, False)]
    rows = []
    for number, (key, lines, conditions, ratio, core) in enumerate(cases):
        if key not in entry:
            continue
        shrink = math.sqrt(ratio)  # k_x ≠ k_y: x divided by √(k_x/k_y) and k = √(k_x k_y), Samsioe's transformation

        def squeeze(points):
            return [(round(x / shrink, 9), y) for x, y in points]

        polygons, conductivity, curves = [("dam", squeeze(ring))], {"dam": k * shrink}, curve
        if core:
            polygons.append(("core", [(24, 0), (28, 0), (28, 10), (24, 10)]))
            conductivity["core"] = 1e-9
            curves = {"dam": curve, "core": [(0, 1), (curve[-1][0], 1)]}  # one number is given for the core
        text = make_flow_case(f"{entry['id']} {key}: {entry['title']}", squeeze([(0, 0), (52, 13)]), polygons, conductivity, curves,
                              [(n, squeeze(p)) for n, p in lines], conditions, 0.35 / math.sqrt(shrink))
        name = f"{entry['id']} case {number + 1}"
        try:
            summary = runner.run(f"{entry['id']}_{number + 1}", text)
        except Broken as fault:
            rows.append(Row(name, "seepage", "", None, None, "", MISS, None, str(fault)))
            continue
        expected, places = entry[key], ys
        if isinstance(expected, dict):
            expected, places = expected["p"], expected["y"]
        try:
            computed = read_pressure_heads(runner.get_folder(f"{entry['id']}_{number + 1}"),
                                           [(26 / shrink, max(y, 1e-6)) for y in places], 0.7)
        except ImportError:
            rows.append(Row(name, "pressure heads on x = 26 m", "seepage", None, None, "", NOTE, None, "needs h5py"))
            computed = []
        for y, value, reference in zip(places, computed, expected):
            rows.append(head_row(name, f"pressure head at (26, {y:g})", "seepage", value, reference, 10.0, extra=read))
        if "Q_xslope" in entry and number < len(entry["Q_xslope"]):
            rows.append(flow_row(name, "discharge, against another program's", summary["seepage"]["outflow"],
                                 entry["Q_xslope"][number], "m²/s"))
    return rows


HANDLERS = {"SP-rect": rectangular_dams, "SP-radial": quarter_ring, "GW1": block_under_recharge, "GW9a": homogeneous_dam,
            "GW6": zoned_dam}


def verify(runner, entry):
    handler = HANDLERS.get(entry["id"])
    if handler is None and "exit_height" in entry:
        handler = rectangular_dams
    if handler is None:
        return [Row(entry["id"], entry.get("title", ""), "seepage", None, None, "", NOTE, None,
                    "no way is known to read this problem's geometry from the file")]
    try:
        return handler(runner, entry)
    except Broken as fault:
        return [Row(entry["id"], entry.get("title", ""), "seepage", None, None, "", MISS, None, str(fault))]
