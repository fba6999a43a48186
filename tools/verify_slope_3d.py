#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Factors of safety of examples/slope_3d over the width between the end walls, beside an upper bound for clay.

Usage: tools/verify_slope_3d.py PROGRAM FOLDER [--size H] [--quick] | --draw CSV SVG
Writes slope_3d.csv (appended when it exists) to FOLDER. --size 2 takes 3 minutes on one core, --size 1 twelve.
--quick: the section and smooth walls only. --draw CSV SVG draws the factor over that between smooth walls 10 m apart.

The bound: soil with cohesion only fails as a rigid cylinder that turns about an axis along z. It slides on its base and,
at rough end walls, on its two plane ends; the work of gravity against the work of c on these surfaces bounds the factor
from above (kinematic theorem of limit analysis). The smallest over all circles that stay in the soil is taken.
"""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

HEIGHT, COTANGENT, UNIT_WEIGHT, COHESION = 10.0, 2.0, 20.0, 50.0  # [m], [-], [kN/m3], [kPa] of the clay
CLAY = ["materials.soil.friction_angle=0", f"materials.soil.cohesion={COHESION}", "materials.soil.tensile_strength=1000",
        "strength_reduction.frozen.from=1.5", "strength_reduction.frozen.to=4"]
FRICTIONAL = ["strength_reduction.frozen.from=1", "strength_reduction.frozen.to=3"]


def bound_factor(width=None, samples=400):
    """Smallest factor over circles; width [m] between rough walls, None for plane strain."""
    best = np.inf
    toe = COTANGENT * HEIGHT  # x = 0 at the crest, y = 0 at the toe and the firm base
    share = (np.arange(12) + 0.5) / 12
    for xc in np.linspace(0, 2.5 * HEIGHT, 41):
        for yc in np.linspace(HEIGHT, 5 * HEIGHT, 61):
            for radius in np.linspace(yc - 0.95 * HEIGHT, yc, 60):
                x = np.linspace(xc - radius, xc + radius, samples)
                dx = x[1] - x[0]
                arc = yc - np.sqrt(np.maximum(0, radius**2 - (x - xc) ** 2))
                ground = np.where(x < 0, HEIGHT, np.where(x > toe, 0, HEIGHT - x / COTANGENT))
                inside = np.flatnonzero(arc < ground)
                if len(inside) < 10 or inside[-1] - inside[0] + 1 != len(inside):
                    continue
                x, arc, depth = x[inside], arc[inside], (ground - arc)[inside]
                driving = UNIT_WEIGHT * np.sum(depth * (xc - x)) * dx
                if driving <= 0:
                    continue
                angle = np.arctan2(arc[-1] - yc, x[-1] - xc) - np.arctan2(arc[0] - yc, x[0] - xc)
                resisting = COHESION * radius**2 * angle
                if width is not None:
                    lever = np.hypot((x - xc)[:, None], arc[:, None] + depth[:, None] * share - yc)
                    resisting += 2 * COHESION * np.sum(lever * depth[:, None] / len(share)) * dx / width
                best = min(best, resisting / driving)
    return best


def run(program, case, settings):
    with tempfile.TemporaryDirectory() as scratch:
        command = [program, "run", str(case), "-o", scratch + "/run", "--threads", "1", "-q"]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True)
        summary = json.loads(pathlib.Path(scratch, "run", "summary.json").read_text())
    mesh = summary["factor_of_safety"]["frozen"]["meshes"][0]
    return mesh["factor"], mesh["points"], summary["timing"]["wall"]


def draw(table, picture):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "talus", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    import matplotlib.pyplot as plt
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    figure, axes = plt.subplots(figsize=(5.6, 3.6), layout="constrained")
    section = bound_factor()
    ratios = [w / HEIGHT for w in (10, 14, 20, 28, 40, 56, 80)]
    axes.plot(ratios, [bound_factor(w * HEIGHT) / section for w in ratios], "k-", lw=1, label="clay, upper bound over that of the section")
    for soil, mark in (("frictional", "o"), ("clay", "s")):
        for size, fill in ((2, "none"), (1, "k")):
            mine = [r for r in rows if r["soil"] == soil and float(r["element size [m]"]) == size]
            smooth = next(float(r["factor"]) for r in mine if r["end walls"] == "smooth" and r["width [m]"] == "10")
            rough = [(float(r["width [m]"]) / HEIGHT, float(r["factor"]) / smooth) for r in mine if r["end walls"] == "rough"]
            rough = [x for x in rough if x[0] >= 1]
            axes.plot(*zip(*rough), "k" + mark, ms=5, mfc=fill, label=f"{'φ = 20°' if soil == 'frictional' else 'clay'}, elements {size} m")
    axes.set(xlabel="width between rough walls over height, W/H", ylabel="factor over that between smooth walls", xlim=(0, 8.4), ylim=(0.95, 2.1))
    axes.axhline(1, color="0.7", lw=0.8)
    axes.legend(frameon=False)
    figure.savefig(picture, metadata={"Date": None})


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["--draw"]:
        draw(arguments[1], arguments[2])
        return
    size = 2.0
    if "--size" in arguments:
        at = arguments.index("--size")
        size = float(arguments[at + 1])
        del arguments[at:at + 2]
    quick = "--quick" in arguments
    program, target = os.path.abspath(arguments[0]), pathlib.Path(arguments[1])
    example = pathlib.Path(__file__).resolve().parent.parent / "examples" / "slope_3d"
    target.mkdir(parents=True, exist_ok=True)
    common = [f"mesh.size={size}", "strength_reduction.curve.enabled=false", "strength_reduction.frozen.meshes=1"]
    rows = []
    for soil, settings in (("frictional", FRICTIONAL), ("clay", CLAY)):
        jobs = [("section", None)] + [("smooth", w) for w in (4, 10)]
        if not quick:
            jobs += [("rough", w) for w in ((5, 10, 20, 40, 80) if size >= 2 else (5, 10, 20, 40))]
        for walls, width in jobs:
            extra = []
            if width:
                fix = "full" if walls == "rough" else "normal"
                extra = [f"geometry.thickness={width}", f"boundary.front.fix={fix}", f"boundary.back.fix={fix}"]
            case = example / ("case.toml" if width else "section.toml")
            factor, points, wall = run(program, case, settings + common + extra)
            bound = bound_factor(width if walls == "rough" else None) if soil == "clay" else None
            rows.append([soil, size, walls, width or "", f"{factor:.4f}", "" if bound is None else f"{bound:.4f}", points, f"{wall:.0f}"])
            print(*rows[-1], sep="  ", flush=True)
    path = target / "slope_3d.csv"
    is_new = not path.exists()
    with open(path, "a", newline="") as file:
        out = csv.writer(file)
        if is_new:
            out.writerow(["soil", "element size [m]", "end walls", "width [m]", "factor", "upper bound", "points", "wall [s]"])
        out.writerows(rows)


if __name__ == "__main__":
    main()
