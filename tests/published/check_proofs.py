#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The bounds of small cases are proven by tools/verify_proof.py too, and falsified ones are not.

Usage: check_proofs.py PROGRAM
"""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from verify_proof import verify  # noqa: E402

POINTS, TOLERANCE = 3, 5e-4
SOIL = """[materials.{name}]
model = "mohr_coulomb"
unit_weight = 18
cohesion = {c}
friction_angle = {phi}
tensile_strength = {tension}
{more}
"""
# Strength that grows below a level inside the soil, a water table inside triangles, r_u with a surcharge and an earthquake.
CASES = {
    "clay": """[geometry]
ground = [[0, 6], [12, 6], [20, 10], [32, 10]]
layer = [{ name = "fill", level = 6 }, { name = "clay", level = 0 }]
[regions]
fill = "fill"
clay = "clay"
""" + SOIL.format(name="fill", c=5, phi=32, tension=0, more="") + """[materials.clay]
model = "tresca"
unit_weight = 17
undrained_strength = 14
undrained_gradient = 2
undrained_level = 5.1
""",
    "water": """[geometry]
ground = [[0, 8], [10, 8], [18, 12], [30, 12]]
layer = [{ name = "soil", level = 0 }]
[regions]
soil = "soil"
[initial]
pore_pressure = "water_table"
water_table = [[0, 8.5], [11, 8.5], [17, 10.2], [30, 10.8]]
""" + SOIL.format(name="soil", c=4, phi=30, tension=2, more="saturated_unit_weight = 20"),
    "ratio": """[geometry]
ground = [[0, 6], [10, 6], [18, 10], [30, 10]]
layer = [{ name = "soil", level = 0 }]
[regions]
soil = "soil"
[earthquake]
horizontal = 0.1
direction = "left"
[[surcharge]]
name = "road"
x = [20, 26]
load = [10, 10]
""" + SOIL.format(name="soil", c=12, phi=28, tension=0, more="pore_pressure_ratio = 0.15"),
}


def change(folder, file, path, factor):
    """Multiplies a number of a file of results."""
    data = json.loads((folder / file).read_text(encoding="utf-8"))
    block = data
    for key in path[:-1]:
        block = block[key]
    block[path[-1]] *= factor
    (folder / file).write_text(json.dumps(data), encoding="utf-8")


def main():
    program, faults = sys.argv[1], []
    with tempfile.TemporaryDirectory() as place:
        for name, text in CASES.items():
            case, folder = pathlib.Path(place) / f"{name}.toml", pathlib.Path(place) / name
            case.write_text(f'title = "{name}"\n{text}[analysis]\nmethods = ["bounds"]\n[bounds]\ngap = 0.15\n', encoding="utf-8")
            done = subprocess.run([program, "run", case, "-o", folder], capture_output=True, text=True, check=False)
            if done.returncode:
                sys.exit(f"{name}: {done.stderr}")
            if verify(folder, POINTS, TOLERANCE) != 0:
                faults.append(f"{name} is not proven")
        changes = [("clay", "bounds.json", ["summary", "lower"], 1.01), ("clay", "bounds.json", ["summary", "upper"], 0.98),
                   ("clay", "summary.json", ["input", "materials", "clay", "undrained_gradient", "value"], 0.8),
                   ("water", "summary.json", ["input", "initial", "water_table", "value", 2, 1], 1.05),
                   ("ratio", "summary.json", ["input", "materials", "soil", "pore_pressure_ratio", "value"], 1.3),
                   ("ratio", "summary.json", ["input", "surcharge", 0, "load", "value", 0], 1.5)]
        for name, file, path, factor in changes:
            folder = pathlib.Path(place) / name
            before = (folder / file).read_bytes()
            change(folder, file, path, factor)
            if verify(folder, POINTS, TOLERANCE) != 1:
                faults.append(f"{name}: {'.'.join(map(str, path))} times {factor} is still proven")
            (folder / file).write_bytes(before)
    sys.exit("\n".join(faults) or 0)


if __name__ == "__main__":
    main()
