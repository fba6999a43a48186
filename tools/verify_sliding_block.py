#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs examples/sliding_block for several friction coefficients and compares the acceleration with Coulomb's.

Usage: tools/verify_sliding_block.py PROGRAM FOLDER
Writes sliding_block.csv and sliding_block.svg (needs gnuplot) to FOLDER and prints the table as Markdown.
"""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile

GRAVITY = 9.81
SETTLED = 0.4  # end of the first stage [s]
CASES = [  # file, name of the plane, sin, cos, friction coefficients
    ("case.toml", "bottom", 0.6, 0.8, (0, 0.2, 0.4, 0.5, 0.6, 0.7, 0.9)),
    ("case.toml", "bottom", 0.28, 0.96, (0.1, 0.2, 0.4)),
    ("inclined.toml", "plane", 0.6, 0.8, (0, 0.2, 0.4, 0.5, 0.6, 0.7, 0.9)),
]


def run(program, case, settings, folder):
    """History rows (time, velocity x, velocity y, centre x, centre y) of a run."""
    command = [program, "run", str(case), "-o", str(folder), "--threads", "1", "-q", "--overwrite"]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True)
    rows = []
    with open(folder / "history.csv", newline="") as file:
        for r in csv.DictReader(file):
            mass = float(r["mass [kg]"])
            rows.append((float(r["time [s]"]), float(r["momentum_x [kg m/s]"]) / mass, float(r["momentum_y [kg m/s]"]) / mass,
                         float(r["centre_x [m]"]), float(r["centre_y [m]"])))
    return rows


def main():
    program, target = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
    example = pathlib.Path(__file__).resolve().parent.parent / "examples" / "sliding_block"
    target.mkdir(parents=True, exist_ok=True)
    table, curves = [], {}
    with tempfile.TemporaryDirectory() as scratch:
        for name, plane, sine, cosine, frictions in CASES:
            inclined = name == "inclined.toml"
            for friction in frictions:
                settings = [f"boundary.{plane}.friction={friction}"]
                if not inclined:
                    settings.append(f"gravity.direction=[{sine}, {-cosine}]")
                rows = run(program, example / name, settings, pathlib.Path(scratch) / "run")
                along = (cosine, -sine) if inclined else (1, 0)
                start = max(i for i, r in enumerate(rows) if r[0] <= SETTLED + 1e-3)
                speed = [r[1] * along[0] + r[2] * along[1] for r in rows]
                elapsed = rows[-1][0] - rows[start][0]
                computed = (speed[-1] - speed[start]) / elapsed
                moved = (rows[-1][3] - rows[start][3]) * along[0] + (rows[-1][4] - rows[start][4]) * along[1]
                exact = GRAVITY * max(0.0, sine - friction * cosine)
                table.append((name, sine / cosine, friction, computed, exact, computed - exact,
                              (computed - exact) / exact if exact else None, moved))
                if inclined:
                    curves[friction] = [(r[0] - rows[start][0], v - speed[start]) for r, v in zip(rows[start:], speed[start:])]
    with open(target / "sliding_block.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["case", "tan theta", "mu", "a computed [m/s2]", "a exact [m/s2]", "difference [m/s2]", "relative", "path in 1 s [m]"])
        for row in table:
            out.writerow([row[0]] + [("" if v is None else f"{v:.5g}") for v in row[1:]])
    print("| plane | tan θ | μ | computed a [m/s²] | exact a [m/s²] | difference [m/s²] | relative |\n|---|---|---|---|---|---|---|")
    for name, tan, mu, computed, exact, difference, relative, _ in table:
        plane = "line" if name == "inclined.toml" else "floor"
        share = "sticks" if relative is None else f"{100 * relative:+.2f} %"
        print(f"| {plane} | {tan:.4g} | {mu:g} | {computed:.4f} | {exact:.4f} | {difference:+.4f} | {share} |")
    draw(curves, target / "sliding_block.svg")


def draw(curves, path):
    """Velocity gained over time for the inclined line: symbols computed, lines exact."""
    script = ["set terminal svg size 640,420 font 'sans,12' background 'white'", f"set output '{path}'",
              "set xlabel 'time since the end of settling [s]'", "set ylabel 'velocity gained along the plane [m/s]'",
              "set key left top", "set xrange [0:1]"]
    plots, data = [], []
    for k, (mu, points) in enumerate(curves.items(), 1):
        a = GRAVITY * max(0.0, 0.6 - 0.8 * mu)
        plots += [f"{a}*x with lines lc {k} notitle", f"'-' with points pt 6 ps 0.6 lc {k} title 'μ = {mu:g}'"]
        data += [f"{t} {v}" for t, v in points[::3]] + ["e"]
    script.append("plot " + ", ".join(plots))
    subprocess.run(["gnuplot"], input="\n".join(script + data) + "\n", text=True, check=True)


if __name__ == "__main__":
    main()
