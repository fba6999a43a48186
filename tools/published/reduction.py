# SPDX-License-Identifier: MIT
"""Strength reduction against the published factors of another program, RS2, on one mesh of about as many elements."""
from __future__ import annotations

import math

from .case_file import make_case
from .coupled import make_coupled_case
from .problem import read_problem
from .runs import Broken
from .table import MISS, NOTE, Row, judge

ELEMENTS = 1500  # about, as in the published models
BAND = 0.02


def find_section(entry, lem):
    """The section of an entry: that of the problem it names, without tension cracks, or its own."""
    base = lem.get(entry.get("base")) or {}
    section = {**base, **{k: v for k, v in entry.items() if k not in ("base", "rs2", "xslope")}}
    for key in ("recomputed", "tension_crack", "drawdown", "circles", "surfaces"):
        section.pop(key, None)
    return section


def choose_size(problem):
    """Element size [m] of ELEMENTS equilateral triangles."""
    area = sum(0.5 * abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))) for _, _, ring in problem.regions)
    return float(f"{math.sqrt(4 * area / math.sqrt(3) / ELEMENTS):.3g}")


def describe_others(entry, run):
    """The factor extrapolated over two meshes, and that of another program."""
    told = []
    limits = run.get("interval")
    if run.get("factor") and limits:
        told.append(f"extrapolated {run['factor']:.3f} [{limits['lower']:.3f}, {limits['upper']:.3f}]")
    if entry.get("xslope"):
        told.append(f"xslope {entry['xslope']:g}")
    return "; ".join(told + [entry["notes"]] if entry.get("notes") else told)


def verify(runner, entry, lem):
    """ψ = 0, tensile strength as large as the cohesion, as RS2's models have it; its strength is reduced too, unlike theirs."""
    section = find_section(entry, lem)
    problem = read_problem(section)
    size = choose_size(problem)
    what = f"strength reduction, {size:g} m"
    try:
        if section.get("seepage_bc"):
            text = make_coupled_case(problem, size, 1.5 * size, stiffness=True)[0]
        else:
            text = make_case(problem, search=False, surfaces=[], finite_elements=True, largest_tension="cohesion")
        guess = float(f"{entry['rs2']:.2g}")
        summary = runner.run(entry["id"], text, ['analysis.methods=["fem"]', f"fem.size={size}", "fem.flow=as_given", "fem.resolution=0.005",
                                                 f"fem.from={0.85 * guess:g}", f"fem.to={1.15 * guess:g}"])
    except Broken as fault:
        return [Row(entry["id"], what, "ψ = 0", None, entry["rs2"], "±2 %", MISS, (entry["rs2"],) * 2, str(fault))]
    run = summary["fem"]["runs"][0]
    factor = find_fine(run)
    return [Row(entry["id"], what, "ψ = 0", factor, entry["rs2"], "±2 %", judge(factor, entry["rs2"], BAND, BAND), (entry["rs2"],) * 2,
                describe_others(entry, run))]


def find_fine(run):
    """The factor on elements of the size asked for."""
    meshes = run.get("meshes") or []
    return meshes[-1].get("factor") if meshes else run.get("factor")
