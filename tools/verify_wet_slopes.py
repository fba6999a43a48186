#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Random slopes with a water table and suction above it: comparison of the frozen factor of MPM with FEM and LEM.

Usage: tools/verify_wet_slopes.py PROGRAM [--count 20] [--only N …] [--out FOLDER] [--keep] [--jobs N] [--write]

Draws wet slopes (number N is always the same slope) whose soil retains water by van Genuchten's curve, and runs all three methods on each: LEM (Spencer
and Morgenstern–Price), FEM on two meshes with the soil's own ψ and with ψ = φ, and the frozen factor of MPM on two meshes. The frozen
factor and that of FEM with the same ψ may differ by 5 %; so may it and LEM where ψ = φ, which LEM assumes. Prints
every slope, with what is known of those that differ (tests/data/wet_slopes.json). --write writes docs/verification_data/wet_slopes.md. Ends with 1 where a slope
without a reason is apart, or has no factor.
"""
import math
import pathlib
import random
import sys

from published.campaign import judge_all, parse_options, read_reasons, show
from published.runs import Broken

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "verification_data" / "wet_slopes.md"
REASONS = ROOT / "tests" / "data" / "wet_slopes.json"
AGREE = 0.05
LEVEL = 14  # elements of the coarse mesh over the height of the slope


def draw_slope(number):
    """Slope `number`: geometry [m] and soil [kPa, °] as words of a case file."""
    rng = random.Random(3000 + number)
    height = round(rng.uniform(5, 15), 2)
    run = round(rng.uniform(1.2, 3) * height, 2)
    below = round(rng.uniform(0.25, 0.6) * height, 2)
    back, front = round(1.5 * height, 2), round(1.2 * height, 2)
    top, width = below + height, back + run + front
    friction = round(rng.uniform(20, 38), 1)
    table_front = below + rng.choice((-0.2, 0, 0, 0.1)) * height
    table_back = max(below + rng.uniform(0.2, 0.8) * height, table_front)
    return {"height": height, "top": top, "width": width, "below": below, "crest": back, "toe": back + run, "friction": friction,
            "dilatancy": round(rng.choice((0, 0.5, 1)) * friction, 2), "cohesion": round(rng.uniform(0.15, 0.9) * height, 1),
            "porosity": round(rng.uniform(0.32, 0.5), 3), "young": round(rng.uniform(10, 50), 1), "poisson": round(rng.uniform(0.25, 0.35), 2),
            "suction": rng.choice((0, 10, 20)), "reference": round(rng.uniform(4, 15), 1), "lambda": round(rng.uniform(0.2, 0.4), 2),
            "table": [[0, round(table_back, 3)], [round(back, 3), round(table_back, 3)], [round(back + run, 3), round(table_front, 3)],
                      [round(width, 3), round(table_front, 3)]]}


def write_case(number, s):
    size = round(s["height"] / LEVEL, 4)
    ring = [[0, 0], [s["width"], 0], [s["width"], s["below"]], [s["toe"], s["below"]], [s["crest"], s["top"]], [0, s["top"]]]
    ring = [[round(v, 3) for v in p] for p in ring]
    apex = s["cohesion"] / math.tan(math.radians(s["friction"]))
    return f"""title = "random wet slope {number}"
geometry.box = [[0, 0], [{s["width"]:.3f}, {s["top"] + 2 * size:.4f}]]
geometry.polygon = [{{ name = "soil", points = {ring} }}]
mesh.size = {size}
regions.soil = "soil"
boundary = [{{ on = "bottom", fix = "full" }}, {{ on = "left", fix = "normal" }}, {{ on = "right", fix = "normal" }}]
stage = [{{ name = "gravity", duration = 20, until = "rest", damping = 0.75, cohesion = "500 kPa", water = "held", geometry = "frozen" }}]

[analysis]
kind = "strength_reduction"
methods = ["lem", "fem", "mpm"]
[strength_reduction.curve]
enabled = false
[strength_reduction.frozen]
from = 0.6
to = 3
resolution = 0.01
mesh_scatter = false
[lem]
methods = ["spencer", "morgenstern_price"]
yield_acceleration = false
[fem]
size = {0.5 * size}
flow = "both"
meshes = 2
[materials.soil]
model = "mohr_coulomb"
grain_density = 2650
porosity = {s["porosity"]}
young_modulus = "{s["young"]} MPa"
poisson_ratio = {s["poisson"]}
cohesion = "{s["cohesion"]} kPa"
friction_angle = {s["friction"]}
dilatancy_angle = {s["dilatancy"]}
tensile_strength = "{0.999999 * apex:.6f} kPa"  # the apex: no tension cut-off
[materials.soil.water]
conductivity = "1e-5 m/s"
retention = "van_genuchten"
minimum_saturation = 0.1
reference_pressure = "{s["reference"]} kPa"
lambda = {s["lambda"]}
relative_conductivity = "constant"
[initial]
stress = "k0"
pore_pressure = "water_table"
water_table = {s["table"]}
largest_suction = "{s["suction"]} kPa"
"""


def judge(runner, number):
    """A row: the slope, the factors of MPM, FEM and LEM, and the differences of those that should agree."""
    slope = draw_slope(number)
    row = {"slope": number, "friction": slope["friction"], "dilatancy": slope["dilatancy"], "suction": slope["suction"], "points": None,
           "uncertainty": None, "same": None, "associated": None, "slices": None, "from_elements": None, "from_slices": None, "note": ""}
    try:
        summary = runner.run(f"wet_{number}", write_case(number, slope))
    except Broken as fault:
        return dict(row, note=str(fault))
    frozen = summary["factor_of_safety"]
    frozen = frozen.get("frozen", frozen)
    row["points"], row["uncertainty"], row["note"] = frozen.get("factor"), frozen.get("uncertainty"), frozen.get("note", "")
    for run in summary["fem"]["runs"]:
        row["associated" if run["flow"] == "associated" else "same"] = run.get("factor")
    if row["same"] is None and slope["dilatancy"] == slope["friction"]:
        row["same"] = row["associated"]
    row["slices"] = min((r["factor"] for r in summary["methods"]["table"] if r["method"] == "lem" and r["factor"]), default=None)
    if row["points"] and row["same"]:
        row["from_elements"] = row["points"] / row["same"] - 1
    if row["points"] and row["slices"] and slope["dilatancy"] == slope["friction"]:
        row["from_slices"] = row["points"] / row["slices"] - 1
    return row


def is_apart(row):
    differences = [row["from_elements"]] + ([row["from_slices"]] if row["dilatancy"] == row["friction"] else [])
    return any(d is None or abs(d) > AGREE for d in differences)


def write_page(rows, reasons):
    apart = [r for r in rows if is_apart(r)]
    lines = ["# Random wet slopes by MPM, FEM and LEM", "",
             f"{len(rows)} slopes with a water table and suction above it, drawn by `tools/verify_wet_slopes.py build/release/bin/talus --write`. MPM: the "
             f"frozen factor, on two meshes, H/{LEVEL} and half of it. FEM: two meshes too, with the ψ of the soil and with ψ = φ. LEM: the smaller of "
             "Spencer and Morgenstern–Price. LEM assumes ψ = φ, so MPM is compared with it only there.", "",
             f"- No factor: {sum(r['points'] is None for r in rows)}.",
             f"- Within {100 * AGREE:.0f} %: {len(rows) - len(apart)} of {len(rows)}.", "",
             "| slope | φ | ψ | suction | MPM | FEM | FEM, ψ = φ | LEM | MPM over FEM | over LEM | |",
             "|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|"]
    for r in rows:
        points = "–" if r["points"] is None else f"{r['points']:.3f} ± {r['uncertainty']:.3f}"
        note = " ".join(t for t in (r["note"], reasons.get(str(r["slope"]), "") if is_apart(r) else "") if t)
        lines.append(f"| {r['slope']} | {r['friction']} | {r['dilatancy']} | {r['suction']} kPa | {points} | {show(r['same'], '{:.3f}')} | "
                     f"{show(r['associated'], '{:.3f}')} | {show(r['slices'], '{:.3f}')} | {show(r['from_elements'], '{:+.1%}')} | "
                     f"{show(r['from_slices'], '{:+.1%}')} | {note} |")
    return "\n".join(lines) + "\n"


def main():
    options = parse_options(__doc__, 20, str(PAGE.relative_to(ROOT)))
    rows = judge_all(options, judge)
    reasons = read_reasons(REASONS)
    page = write_page(rows, reasons)
    print(page)
    if options.write:
        PAGE.write_text(page)
    unexplained = [r["slope"] for r in rows if is_apart(r) and str(r["slope"]) not in reasons]
    if unexplained:
        print(f"without a reason: {unexplained}", file=sys.stderr)
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main())
