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
from proof.judge import judge_folder  # noqa: E402
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
    # Feet and psf, map coordinates, vertical earthquake, a liquid of its own, a load on a line.
    "feet": """[geometry]
ground = [["900000 ft", "20 ft"], ["900030 ft", "20 ft"], ["900060 ft", "33 ft"], ["900100 ft", "33 ft"]]
layer = [{ name = "soil", level = "0 ft" }]
line = [{ name = "crest", points = [["900070 ft", "33 ft"], ["900085 ft", "33 ft"]] }]
[regions]
soil = "soil"
[earthquake]
horizontal = 0.05
vertical = 0.1
direction = "left"
[[slurry]]
name = "mud"
x = ["900005 ft", "900025 ft"]
level = "22 ft"
unit_weight = "75 pcf"
[[traction]]
on = "crest"
traction = [0, "-200 psf"]
[materials.soil]
model = "mohr_coulomb"
unit_weight = "120 pcf"
cohesion = "200 psf"
friction_angle = 26
tensile_strength = "50 psf"
""",
    # A curved envelope above clay with a stress history, artesian water, suction.
    "curved": """[geometry]
ground = [[0, 6], [12, 6], [20, 10], [32, 10]]
layer = [{ name = "fill", level = 5 }, { name = "clay", level = 2 }, { name = "sand", level = 0 }]
[regions]
fill = "fill"
clay = "clay"
sand = "sand"
[initial]
pore_pressure = "water_table"
water_table = [[0, 5.5], [12, 5.5], [20, 7], [32, 7.2]]
[[initial.piezometric_line]]
materials = ["sand"]
points = [[0, 6.2], [32, 7.5]]
[materials.fill]
model = "power_curve"
unit_weight = 18
saturated_unit_weight = 19
power_factor = 1.8
power_exponent = 0.8
power_shift = 2
[materials.clay]
model = "shansep"
unit_weight = 17
strength_ratio = 0.25
strength_exponent = 0.8
added_strength = 3
profile_levels = [5, 2]
profile_preconsolidation = [80, 110]
""" + SOIL.format(name="sand", c=1, phi=30, tension=0, more='suction_strength = "phi_b"\nphi_b = 12'),
    "bedding": """[geometry]
ground = [[0, 6], [10, 6], [18, 10], [30, 10]]
layer = [{ name = "schist", level = 0 }]
[regions]
schist = "schist"
""" + SOIL.format(name="schist", c=25, phi=33, tension=5, more="""bedding_angle = 20
bedding_cohesion = 4
bedding_friction = 18
bedding_range = 5""").replace("mohr_coulomb", "bedding"),
    "nail": """[geometry]
ground = [[0, 6], [10, 6], [12, 2], [22, 2]]
layer = [{ name = "silt", level = -2 }]
[regions]
silt = "silt"
[support.nails]
kind = "nail"
heads = [[10.5, 5], [11.25, 3.5]]
inclination = 12
length = 5
out_of_plane_spacing = 1.5
tensile_strength = 80
plate = 50
bond = 22
""" + SOIL.format(name="silt", c=6, phi=30, tension=10, more=""),
}
# Parts that are not evaluated have to be named.
UNKNOWN = {
    "wall": ("""[geometry]
ground = [[0, 3], [12, 3], [12, 0], [24, 0]]
layer = [{ name = "soil", level = -6 }]
[regions]
soil = "soil"
[support.sheet]
kind = "wall"
line = [[12, 3], [12, -3]]
plastic_moment = 180
interface_strength = 0.67
""" + SOIL.format(name="soil", c=4, phi=30, tension=0, more=""), "support of kind wall"),
}


def change(folder, file, path, factor):
    """Multiplies a number, or all numbers of nested lists, of a file of results."""
    data = json.loads((folder / file).read_text(encoding="utf-8"))
    block = data
    for key in path[:-1]:
        block = block[key]

    def scale(value):
        return [scale(v) for v in value] if isinstance(value, list) else value * factor

    last = max(range(len(block)), key=lambda i: abs(block[i][0]) + abs(block[i][1])) if path[-1] == "fastest" else path[-1]
    block[last] = scale(block[last])
    (folder / file).write_text(json.dumps(data), encoding="utf-8")


SUMMARY, FIELDS = "summary.json", "bounds.json"
CHANGES = [
    ("clay", FIELDS, ["summary", "lower"], 1.01), ("clay", FIELDS, ["summary", "upper"], 0.98),
    ("clay", FIELDS, ["holds", "stress"], 1.02), ("clay", FIELDS, ["moves", "velocity", "fastest"], 1.5),
    ("clay", SUMMARY, ["input", "materials", "clay", "undrained_gradient", "value"], 0.8),
    ("water", SUMMARY, ["input", "initial", "water_table", "value", 2, 1], 1.05), ("water", FIELDS, ["holds", "pressure"], 0.98),
    ("ratio", SUMMARY, ["input", "materials", "soil", "pore_pressure_ratio", "value"], 1.3),
    ("ratio", SUMMARY, ["input", "surcharge", 0, "load", "value", 0], 1.5),
    ("feet", SUMMARY, ["input", "earthquake", "vertical", "value"], 1.5), ("feet", SUMMARY, ["input", "slurry", 0, "unit_weight", "value"], 1.2),
    ("curved", SUMMARY, ["input", "materials", "fill", "power_factor", "value"], 0.95),
    ("curved", SUMMARY, ["input", "materials", "clay", "profile_preconsolidation", "value"], 0.9),
    ("curved", SUMMARY, ["input", "materials", "clay", "profile_preconsolidation", "value"], 1.3),
    ("curved", SUMMARY, ["input", "initial", "piezometric_line", 0, "points", "value", 1, 1], 1.6),
    ("bedding", SUMMARY, ["input", "materials", "schist", "bedding_cohesion", "value"], 0.8),
    ("bedding", SUMMARY, ["input", "materials", "schist", "bedding_friction", "value"], 1.3),
    ("nail", SUMMARY, ["input", "support", "nails", "bond", "value"], 0.95), ("nail", SUMMARY, ["input", "support", "nails", "bond", "value"], 1.3),
]


def run(program, folder, text):
    case = folder.with_suffix(".toml")
    case.write_text(f'title = "{folder.name}"\n{text}[analysis]\nmethods = ["bounds"]\n[bounds]\ngap = 0.3\n', encoding="utf-8")
    done = subprocess.run([program, "run", case, "-o", folder, "-q"], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{folder.name}: {done.stderr}")


def main():
    program, faults = sys.argv[1], []
    with tempfile.TemporaryDirectory() as scratch:
        place = pathlib.Path(scratch)
        for name, text in CASES.items():
            run(program, place / name, text)
            if verify(place / name, POINTS, TOLERANCE) != 0:
                faults.append(f"{name} is not proven")
        for name, (text, why) in UNKNOWN.items():
            run(program, place / name, text)
            found = judge_folder(place / name, POINTS, TOLERANCE)
            if found.status != 2 or why not in found.reasons:
                faults.append(f"{name}: {found.word}: {found.reasons}, and not: {why}")
        for name, file, path, factor in CHANGES:
            before = (place / name / file).read_bytes()
            change(place / name, file, path, factor)
            if verify(place / name, POINTS, TOLERANCE) != 1:
                faults.append(f"{name}: {'.'.join(map(str, path))} times {factor} is still proven")
            (place / name / file).write_bytes(before)
    sys.exit("\n".join(faults) or 0)


if __name__ == "__main__":
    main()
