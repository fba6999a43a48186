#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Energy budgets and convergence of fronts: a sand block on two floors, columns that collapse, the runout of the dry slope.

Usage: tools/verify_energy.py PROGRAM [--only NAME …] [--jobs N] [--out FOLDER] [--write]

Each body on three meshes, one half the size of the other. The residual is what the columns of history.csv do not explain, over the work
done: the largest external work and the energy of motion at the start. --write stores the table in docs/verification_data/energy.md. --out
keeps cases and results, and finished runs found there are taken. Five minutes on two cores. Ends with 1 where a residual is above 1 %.
"""
import argparse
import concurrent.futures
import csv
import math
import os
import pathlib
import sys
import tempfile

from published.runs import Broken, Runner

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "docs" / "verification_data" / "energy.md"
GATE = 0.01
PARTS = ("kinetic_energy", "elastic_energy", "plastic_work", "damping_work", "wall_work", "mapping_loss")
WATER_PARTS = ("drag_work", "pore_water_work")  # of soil with pore water

SAND = """
[materials.sand]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.4
young_modulus = "5 MPa"
poisson_ratio = 0.3
cohesion = 0
friction_angle = 30
dilatancy_angle = 0
tensile_strength = 0
"""


def make_block(floor, smoothing):
    """A block of sand, 2 m by 1 m, that comes along at 3 m/s."""
    held = 'fix = "full"' if floor == "rough" else 'fix = "friction"\nfriction = 0.3'
    return f"""title = "Sand block on a {floor} floor"
[geometry]
box = [[0, 0], [12, 4]]
[[geometry.polygon]]
name = "block"
points = [[1, 0], [3, 0], [3, 1], [1, 1]]
[mesh]
size = 0.1
{SAND}
[regions]
block = "sand"
[initial]
stress = "k0"
velocity = {{ block = [3, 0] }}
[[boundary]]
on = "bottom"
{held}
[[boundary]]
on = "left"
fix = "normal"
[[stage]]
name = "slide"
duration = 2
smoothing = "{smoothing}"
[output]
history_interval = 0.05
"""


def make_column(aspect):
    return f"""title = "Column of sand, {aspect} times as high as wide"
[geometry]
box = [[0, 0], [{2 + 5 * max(aspect, 1):g}, {aspect + 1:g}]]
[[geometry.polygon]]
name = "column"
points = [[0, 0], [1, 0], [1, {aspect}], [0, {aspect}]]
[mesh]
size = 0.1
{SAND}
[regions]
column = "sand"
[initial]
stress = "k0"
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[stage]]
name = "collapse"
duration = {1.5 * 3.3 * math.sqrt(aspect / 9.81) + 1:.3g}
smoothing = "stable"
[output]
history_interval = 0.05
"""


def make_wet_column(conductivity):
    """A column of saturated sand that lets its water out; soft water, which the balance does not mind."""
    water = f"""[materials.sand.water]
retention = "saturated"
conductivity = "{conductivity} m/s"

[water]
bulk_modulus = "20 MPa"

[regions]"""
    start = """[initial]
pore_pressure = "water_table"
water_table = [[0, 1], [7, 1]]"""
    text = make_column(1).replace("Column of sand", "Column of saturated sand")
    return text.replace("[regions]", water).replace("[initial]", start).replace('smoothing = "stable"', 'smoothing = "none"')


def make_slope():
    """The dry slope of the source at 1/1.75 of its strength, with its weight carried."""
    return f"""title = "Runout of the dry slope"
[geometry]
box = [[0, 0], [64, 17]]
[[geometry.polygon]]
name = "soil"
points = [[0, 0], [64, 0], [64, 5], [32, 5], [12, 15], [0, 15]]
[mesh]
size = 1
{SAND.replace("cohesion = 0", 'cohesion = "2 kPa"').replace("5 MPa", "45 MPa")}
[regions]
soil = "sand"
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"
[[stage]]
name = "gravity"
duration = 20
until = "rest"
damping = 0.75
cohesion = "200 kPa"
[[stage]]
name = "failure"
duration = 12
strength_factor = 1.75
smoothing = "stable"
reset_displacement = true
[output]
history_interval = 0.1
"""


#: name: case, mesh sizes [m], stage from which the work counts
BODIES = {
    "sand block, rough floor": (make_block("rough", "stable"), (0.2, 0.1, 0.05)),
    "the same without smoothing": (make_block("rough", "none"), (0.2, 0.1, 0.05)),
    "sand block, floor with μ = 0.3": (make_block("frictional", "stable"), (0.2, 0.1, 0.05)),
    "column, h/r = 1": (make_column(1), (0.1, 0.05, 0.025)),
    "column, h/r = 2": (make_column(2), (0.1, 0.05, 0.025)),
    "saturated column, k = 1 mm/s": (make_wet_column("1e-3"), (0.2, 0.1, 0.05)),
    "saturated column, k = 0.01 mm/s": (make_wet_column("1e-5"), (0.2, 0.1, 0.05)),
    "runout of the dry slope, F = 1.75": (make_slope(), (2, 1, 0.5)),
}


def read_budget(folder, from_time):
    """Parts and residual of the balance, over the work done since `from_time` [s]."""
    with open(folder / "history.csv", newline="") as file:
        rows = [{k.split(" ")[0]: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
    rows = [r for r in rows if r["time"] >= from_time - 1e-9]
    first, last = rows[0], rows[-1]
    change = lambda row, part: row[part] - first[part]
    parts = [p for p in PARTS + WATER_PARTS if p in first]
    residual = lambda row: change(row, "external_work") - sum(change(row, p) for p in parts)
    work = max(abs(change(r, "external_work")) for r in rows) + first["kinetic_energy"]
    steps = [r["time_step"] for r in rows[1:]]
    return {
        "work": work, "residual": residual(last) / work, "worst": max((residual(r) / work for r in rows), key=abs),
        **{p: change(last, p) / work if p in first else None for p in PARTS + WATER_PARTS}, "kinetic_energy": last["kinetic_energy"] / work,
        "centre": change(last, "centre_x"), "step": min(steps) / max(steps), "speed": last["nodal_speed"],
    }


def measure(runner, name, size):
    try:
        summary = runner.run(f"{name} {size:g}", BODIES[name][0], [f"mesh.size={size:g}"])
    except Broken as error:
        return {"said": str(error)}
    stages = summary["stages"]
    start = stages[-2]["time"] if len(stages) > 1 else 0
    return {**read_budget(runner.get_folder(f"{name} {size:g}"), start), "front": summary["runout"]["mass_front_advance"]}


def find_order(values):
    """Order of convergence over three meshes, each half the size of the last; None where the differences do not shrink."""
    a, b = values[1] - values[0], values[2] - values[1]
    return math.log2(a / b) if b != 0 and a / b > 1 else None


def write_table(results):
    percent = lambda v: "–" if v is None else f"{100 * v:.1f}"
    lines = ["# Where the energy goes", "", "Made by `tools/verify_energy.py PROGRAM --write`. Shares of the work done, in percent; the residual is what the columns do not explain,",
             "the worst its largest value on the way ([theory](../theory/09-budgets.md)). The step is the smallest over the largest.", "",
             "| body | h [m] | work [kJ/m] | plastic | walls | damping | drag | pore water | mapping | in motion | residual | worst | step | centre of mass [m] | front [m] |",
             "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"]
    orders, missed = [], []
    for name, (_, sizes) in BODIES.items():
        rows = [results.get((name, size)) for size in sizes]
        for size, r in zip(sizes, rows):
            if r is None:
                continue
            if "said" in r:
                lines.append(f"| {name} | {size:g} | – | " + "| " * 11 + f"{r['said']} |")
                missed.append(f"{name}, h = {size:g} m: {r['said']}")
                continue
            lines.append(f"| {name} | {size:g} | {r['work'] / 1000:.3g} | " + " | ".join(
                percent(r[p]) for p in ("plastic_work", "wall_work", "damping_work", *WATER_PARTS, "mapping_loss", "kinetic_energy")) +
                f" | {100 * r['residual']:+.2f} | {100 * r['worst']:+.2f} | {r['step']:.2f} | {r['centre']:.3f} | {r['front']:.2f} |")
            if abs(r["worst"]) > GATE:
                missed.append(f"{name}, h = {size:g} m: {100 * r['worst']:+.2f} %")
        if all(r and "said" not in r for r in rows):
            told = []
            for what, word in (("centre", "centre of mass"), ("front", "front"), ("mapping_loss", "mapping")):
                order = find_order([r[what] for r in rows])
                told.append(f"{word} {'–' if order is None else f'{order:.1f}'}")
            orders.append(f"| {name} | " + " | ".join(t.rpartition(" ")[2] for t in told) + " |")
    lines += ["", "Orders of convergence over the three meshes; – where the differences do not shrink:", "",
              "| body | centre of mass | front | mapping |", "|---|--:|--:|--:|", *orders]
    return "\n".join(lines) + "\n", missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--out")
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    folder = args.out or tempfile.mkdtemp()
    runner = Runner(os.path.abspath(args.program), folder, keep=args.out is not None)
    wanted = [(name, size) for name, (_, sizes) in BODIES.items() for size in sizes if not args.only or any(o in name for o in args.only)]
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        results = dict(zip(wanted, pool.map(lambda w: measure(runner, *w), wanted)))
    table, missed = write_table(results)
    print(table)
    if args.write:
        TABLE.write_text(table)
    for line in missed:
        print("above 1 %:", line)
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
