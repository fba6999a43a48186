#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What must hold for every slope, on random ones: the same slope written otherwise has the same factor.

Usage: tools/verify_properties.py PROGRAM [--count 200] [--only N …] [--out FOLDER] [--jobs N] [--write]

Each of the random slopes of tools/published/random_slopes.py (layers, water, loads, earthquakes) is calculated by slices as it is and
  - mirrored, moved by (1234.5, 678.9) m, and in feet and pounds: the factor of every method on its critical circle is the same;
  - with c and tan φ of all soils times 1.25: the factor is 1.25 times as large;
and the methods keep their order: Fellenius is not above Bishop (where Bishop is above 1), Janbu not above Janbu corrected, Spencer and
Morgenstern–Price agree. The order leaves circles out that are as shallow as the search allows, of which the program warns.
Every run ends with factors or with a sentence. --write writes docs/verification_data/properties.md. Ends with 1 where something else came out.
"""
import copy
import math
import pathlib
import sys

from published.campaign import judge_all, parse_options
from published.case_file import make_case
from published.problem import FOOT, PCF, PSF, read_problem
from published.random_slopes import describe, draw_slope
from published.runs import Broken

ROOT = pathlib.Path(__file__).resolve().parent.parent
STRONGER = 1.25
# The search goes other ways where the last digit of a number differs: what it finds may differ by its own tolerance.
SAME = 0.002
# Of the same surface; each method has its own, so that only the minima can be compared. Below 1 more than the soil's friction is mobilised
# in Bishop's normal forces, and Fellenius may be above him.
ABOVE = 0.005
APART = 0.03


def change_points(entry, change):
    """Every point of the entry through change(x, y), and every x of a load."""
    entry["ground"] = [change(x, y) for x, y in entry["ground"]]
    entry["base_elev"] = change(0, entry["base_elev"])[1]
    entry["layer_lines"] = [[i, line if isinstance(line, (int, float)) else [change(x, y) for x, y in line]] for i, line in entry["layer_lines"]]
    if "piezo" in entry:
        entry["piezo"] = [change(x, y) for x, y in entry["piezo"]]
    entry["dloads"] = [[[change(x, 0)[0], q] for x, q in strip] for strip in entry.get("dloads", [])]
    return entry


def mirror(entry):
    change_points(entry, lambda x, y: [-x, y])
    for key in ("ground", "piezo"):
        if key in entry:
            entry[key].reverse()
    for line in entry["layer_lines"]:
        line[1].reverse()
    for strip in entry["dloads"]:
        strip.reverse()
    return entry


def shift(entry):
    return change_points(entry, lambda x, y: [round(x + 1234.5, 6), round(y + 678.9, 6)])


def to_feet(entry):
    entry["units"] = "imperial"
    change_points(entry, lambda x, y: [x / FOOT, y / FOOT])
    for strip in entry["dloads"]:
        for point in strip:
            point[1] *= 1e3 / PSF
    for soil in entry["materials"]:
        soil["c"] *= 1e3 / PSF
        for key in ("gamma", "gamma_sat"):
            if key in soil:
                soil[key] *= 1e3 / PCF
    return entry


def strengthen(entry):
    for soil in entry["materials"]:
        soil["c"] *= STRONGER
        soil["phi"] = math.degrees(math.atan(STRONGER * math.tan(math.radians(soil["phi"]))))
    return entry


WRITTEN = {"mirrored": (mirror, 1), "moved": (shift, 1), "in feet": (to_feet, 1), "stronger": (strengthen, STRONGER)}


def find_factors(runner, name, entry):
    """Method → smallest factor of its circles, and the methods whose circle is as shallow as the search allows."""
    entry = {**entry, "id": name}
    # The water of the feet has 62.4 lbf/ft³; that of the metres 9.81 kN/m³.
    settings = ["water.density=1000"] if entry.get("piezo") else []
    summary = runner.run(name, make_case(read_problem(entry), 50, search=True), settings)
    results, limit = summary["lem"]["critical"], 1.01 * summary["lem"]["search"]["smallest_depth"]
    return ({result["method"]: result.get("factor") for result in results},
            {result["method"] for result in results if (result.get("depth") or math.inf) <= limit})


def find_order_faults(factors, shallow):
    """What differs from the order that the methods have on one surface."""
    factors = {method: factor for method, factor in factors.items() if method not in shallow}
    pairs = [("fellenius", "bishop"), ("janbu", "janbu_corrected")]
    faults = [f"{low} {factors[low]:.4f} is above {high} {factors[high]:.4f}" for low, high in pairs
              if factors.get(low) and factors.get(high) and factors[high] > 1 and factors[low] > factors[high] * (1 + ABOVE)]
    a, b = factors.get("spencer"), factors.get("morgenstern_price")
    if a and b and abs(a / b - 1) > APART:
        faults.append(f"Spencer {a:.4f} and Morgenstern–Price {b:.4f}")
    return faults


def judge(runner, number):
    entry = draw_slope(number)
    row = {"slope": number, "what": describe(entry), "faults": [], "refused": "", "shallow": False, "largest": dict.fromkeys(WRITTEN, 0.0)}
    try:
        factors, shallow = find_factors(runner, f"slope_{number}", copy.deepcopy(entry))
    except Broken as fault:
        row["refused"] = str(fault)
        return row
    row["faults"] += find_order_faults(factors, shallow)
    row["shallow"] = bool(shallow)
    for name, (change, times) in WRITTEN.items():
        try:
            others, _ = find_factors(runner, f"slope_{number}_{name}", change(copy.deepcopy(entry)))
        except Broken as fault:
            row["faults"].append(f"{name}: {fault}")
            continue
        for method in sorted(factors):
            factor = factors[method]
            other = others.get(method)
            if (factor is None) != (other is None):
                row["faults"].append(f"{name}: {method} {factor} and {other}")
            elif factor is not None:
                apart = other / (times * factor) - 1
                row["largest"][name] = max(row["largest"][name], abs(apart))
                if abs(apart) > SAME:
                    row["faults"].append(f"{name}: {method} {other:.4f} for {times * factor:.4f} ({100 * apart:+.2f} %)")
    return row


def write_page(rows):
    answered = [row for row in rows if not row["refused"]]
    lines = ["# Slopes that are written otherwise", "",
             f"{len(rows)} random slopes by slices, `tools/verify_properties.py build/release/bin/talus --write`: {len(answered)} answered, "
             f"{len(rows) - len(answered)} refused with a sentence. Factors on the critical circles of six methods.", "",
             "| written | factor is | largest difference | median of the slopes |", "|---|---|--:|--:|"]
    for name, (_, times) in WRITTEN.items():
        apart = sorted(row["largest"][name] for row in answered)
        lines.append(f"| {name} | {'the same' if times == 1 else f'{times} times'} | {100 * apart[-1]:.4f} % | {100 * apart[len(apart) // 2]:.6f} % |")
    faulty = [row for row in rows if row["faults"]]
    lines += ["", f"Slopes of which the program says that a circle is as shallow as the search allows: {sum(row['shallow'] for row in rows)}; the methods' order leaves those circles out."]
    lines += ["", f"Slopes with more than {100 * SAME:g} %, or methods out of order: {len(faulty)}."]
    lines += [f"- slope {row['slope']} ({row['what']}): {'; '.join(row['faults'])}" for row in faulty]
    lines += [f"- slope {row['slope']} ({row['what']}) was refused: {row['refused']}" for row in rows if row["refused"]]
    return "\n".join(lines) + "\n"


def main():
    page_file = ROOT / "docs" / "verification_data" / "properties.md"
    options = parse_options(__doc__, 200, str(page_file.relative_to(ROOT)))
    rows = judge_all(options, judge)
    page = write_page(rows)
    print(page)
    if options.write:
        page_file.write_text(page, encoding="utf-8")
    return 1 if any(row["faults"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
