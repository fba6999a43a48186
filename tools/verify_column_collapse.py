#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs examples/column_collapse for several aspect ratios and compares runout and height with Lube et al. (2005).

Usage: tools/verify_column_collapse.py PROGRAM FOLDER [--size H] [ASPECT ...] [-- KEY=VALUE ...]
       tools/verify_column_collapse.py --draw FOLDER TARGET
Writes column_collapse_hH.csv and the profiles to FOLDER and prints the table as Markdown; seconds for a mesh. --draw makes the pictures of
what FOLDER holds, column_collapse.svg and column_collapse_deposits.svg, in TARGET.
"""
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile


def law_runout(a):
    """(d_inf - d0)/d0 of Lube et al. (2005): linear to a = 1.8, a power above 2.8, and both values between."""
    if a <= 1.8:
        return (1.2 * a, 1.2 * a)
    power = 1.9 * a ** (2 / 3)
    return (power, power) if a >= 2.8 else (1.2 * a, power)


def law_height(a):
    return a if a < 1.15 else 1.1 * a**0.4


def run(program, case, aspect, size, extra, folder):
    fall = 3.3 * math.sqrt(aspect / 9.81)
    settings = [f"geometry.box=[[0, 0], [{2 + 5 * max(aspect, 1):g}, {aspect + 0.5:g}]]", f"mesh.size={size}",
                f"geometry.polygon.column.points=[[0, 0], [1, 0], [1, {aspect}], [0, {aspect}]]",
                f"stage.collapse.duration={1.5 * fall + 0.3:.3f}", *extra]
    command = [program, "run", str(case), "-o", str(folder), "--threads", "1", "-q", "--overwrite"]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True)
    summary = json.loads((folder / "summary.json").read_text())
    with open(folder / "profile.csv", newline="") as file:
        profile = [(float(r["x [m]"]), float(r["ground after [m]"])) for r in csv.DictReader(file) if r["ground after [m]"]]
    with open(folder / "history.csv", newline="") as file:
        history = list(csv.DictReader(file))
    start, end = history[0], history[-1]
    number = lambda row, key: float(row[key])
    stored = number(end, "kinetic_energy [J]") + number(end, "elastic_energy [J]") - number(start, "elastic_energy [J]")
    spent = stored + sum(number(end, f"{part} [J]") for part in ("plastic_work", "damping_work", "wall_work", "mapping_loss"))
    released = number(start, "potential_energy [J]") - number(end, "potential_energy [J]")
    return {
        "a": aspect, "runout": summary["runout"]["mass_front"] - 1, "height": max(h for _, h in profile),
        "farthest": summary["runout"]["farthest_advance"],
        "area": sum(h for _, h in profile) * min(b[0] - a[0] for a, b in zip(profile, profile[1:])) / aspect,
        "lost_points": summary["budgets"]["lost"]["points"],
        "mass_error": abs(number(end, "mass [kg]") + summary["budgets"]["lost"]["mass"] - number(start, "mass [kg]")) / number(start, "mass [kg]"),
        "work_error": (number(end, "external_work [J]") - released) / released,
        "energy_gap": (spent - released) / released, "end": summary["stages"][-1]["end"],
        "steps": sum(s["steps"] for s in summary["stages"]), "wall": summary["timing"]["wall"], "profile": profile,
    }


def read_table(path):
    with open(path, newline="") as file:
        return [{k: float(v) for k, v in row.items() if k != "end"} for row in csv.DictReader(file)]


def draw(folder, target):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "talus", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    import matplotlib.pyplot as plt
    tables = {float(p.stem.rpartition("_h")[2]): read_table(p) for p in folder.glob("column_collapse_h*.csv")}
    sizes = sorted(tables, reverse=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    aspects = [0.4 + 0.05 * i for i in range(116)]
    short, tall = [a for a in aspects if a <= 1.8], [a for a in aspects if a >= 2.8]
    for part in (short, tall):
        left.plot(part, [law_runout(a)[0] for a in part], "k-", lw=1, label="Lube et al. (2005)" if part is short else None)
    for part, disks in (([a for a in aspects if a < 2.3], lambda a: 1.67 * a), ([a for a in aspects if a >= 2.3], lambda a: 2.5 * a ** (2 / 3))):
        left.plot(part, [disks(a) for a in part], "k--", lw=0.8, label="disks in two dimensions, Kumar (2015)" if part[0] < 2.3 else None)
    right.plot(aspects, [law_height(a) for a in aspects], "k-", lw=1, label="Lube et al. (2005)")
    for size, mark in zip(sizes, ("o", "s", "^")):
        for axes, key in ((left, "runout"), (right, "height")):
            axes.plot([r["a"] for r in tables[size]], [r[key] for r in tables[size]], mark, ms=4, mfc="none", label=f"Talus, d0/{1 / size:.0f}")
    left.set(xlabel="height over width of the column, a", ylabel="runout (d∞ − d0)/d0", xlim=(0, 6.3), ylim=0)
    right.set(xlabel="height over width of the column, a", ylabel="height of the heap h∞/d0", xlim=(0, 6.3), ylim=0)
    left.legend(frameon=False, loc="upper left")
    right.legend(frameon=False, loc="lower right")
    figure.savefig(target / "column_collapse.svg", metadata={"Date": None})
    figure, axes = plt.subplots(figsize=(9, 2.6), layout="constrained")
    for row in tables[sizes[-1]]:
        with open(folder / f"profile_a{row['a']:g}_h{sizes[-1]:g}.csv", newline="") as file:
            profile = [(float(p["x/d0"]), float(p["h/d0"])) for p in csv.DictReader(file)]
        axes.plot(*zip(*profile), lw=1, label=f"a = {row['a']:g}")
    axes.set(xlabel="x/d0", ylabel="h/d0", xlim=(0, 10), ylim=0, aspect="equal")
    axes.legend(frameon=False, ncols=2)
    figure.savefig(target / "column_collapse_deposits.svg", metadata={"Date": None})


def main():
    arguments, extra = sys.argv[1:], []
    if arguments[:1] == ["--draw"]:
        draw(pathlib.Path(arguments[1]), pathlib.Path(arguments[2]))
        return
    if "--" in arguments:
        cut = arguments.index("--")
        arguments, extra = arguments[:cut], arguments[cut + 1:]
    size = 0.1
    if "--size" in arguments:
        at = arguments.index("--size")
        size = float(arguments[at + 1])
        del arguments[at:at + 2]
    program, target = os.path.abspath(arguments[0]), pathlib.Path(arguments[1])
    aspects = [float(a) for a in arguments[2:]] or [0.5, 1, 1.5, 2, 3, 4, 6]
    case = pathlib.Path(__file__).resolve().parent.parent / "examples" / "column_collapse" / "case.toml"
    target.mkdir(parents=True, exist_ok=True)
    rows = []
    print("| a | runout | Lube | difference | height | Lube | difference | area | energy gap | lost points |\n|---|---|---|---|---|---|---|---|---|---|")
    for aspect in aspects:
        with tempfile.TemporaryDirectory() as scratch:
            r = run(program, case, aspect, size, extra, pathlib.Path(scratch) / "run")
        rows.append(r)
        low, high = law_runout(aspect)
        law = f"{low:.2f}" if low == high else f"{low:.2f} to {high:.2f}"
        off = f"{100 * (r['runout'] / low - 1):+.0f} %" if low == high else f"{100 * (r['runout'] / low - 1):+.0f} to {100 * (r['runout'] / high - 1):+.0f} %"
        print(f"| {aspect:g} | {r['runout']:.2f} | {law} | {off} | {r['height']:.2f} | {law_height(aspect):.2f} | "
              f"{100 * (r['height'] / law_height(aspect) - 1):+.0f} % | {r['area']:.2f} | {100 * r['energy_gap']:+.1f} % | {r['lost_points']} |",
              flush=True)
        with open(target / f"profile_a{aspect:g}_h{size:g}.csv", "w", newline="") as file:
            out = csv.writer(file)
            out.writerow(["x/d0", "h/d0"])
            out.writerows([f"{x:.4f}", f"{h:.4f}"] for x, h in r["profile"])
    keys = [k for k in rows[0] if k != "profile"]
    with open(target / f"column_collapse_h{size:g}.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(keys + ["law_runout_low", "law_runout_high", "law_height"])
        for r in rows:
            out.writerow([f"{r[k]:.5g}" if isinstance(r[k], float) else r[k] for k in keys] + [f"{v:.4g}" for v in law_runout(r["a"])] +
                         [f"{law_height(r['a']):.4g}"])


if __name__ == "__main__":
    main()
