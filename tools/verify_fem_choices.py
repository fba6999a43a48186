#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The FEM factor of the unsaturated slope over what section 3.4.2 of the source leaves open: which choice gives the printed 1.32?

Usage: tools/verify_fem_choices.py PROGRAM FOLDER

Runs examples/unsaturated_slope/three_methods.toml by FEM on one mesh with the unit weight, the suction, the mesh, the tolerances and the tension
changed, and by three-node triangles: MPM at frozen geometry without smoothing, whose elements these are. Writes FOLDER/envelope_fem.md. Five
minutes of one core.
"""
import pathlib
import sys
import tempfile

from published.runs import Runner
from roots_checks.tables import table_of

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "examples" / "unsaturated_slope" / "three_methods.toml"
PRINTED, TOLERANCE = 1.32, 0.005  # two printed decimals
FULL = 19.521  # kN/m³ of the grains and full pores of Table 3.1
ELEMENTS = ("analysis.methods=[\"fem\"]", "fem.meshes=1", "fem.from=1.0", "fem.to=1.6", "compare=[]")


def set_weight(above, below=FULL):
    return [f"materials.sand.unit_weight={above}", f"materials.sand.saturated_unit_weight={below}"]


NO_SUCTION = ["materials.sand.suction_strength=none"]
VARIANTS = [("weight by the saturation, suction with χ = S, elements of 0.7 m", []),
            ("elements of 1.4 m", ["fem.size=1.4"]), ("elements of 1.0 m", ["fem.size=1.0"]), ("elements of 0.5 m", ["fem.size=0.5"]),
            ("mesh by frontal", ["fem.algorithm=frontal"]), ("mesh by meshadapt", ["fem.algorithm=meshadapt"]),
            *((f"tolerances of {value}", [f"fem.force_tolerance={value}", f"fem.displacement_tolerance={value}"]) for value in (1e-3, 1e-2)),
            ("tension up to c/tan φ", ["materials.sand.tensile_strength=3.464"]),
            ("suction adds no strength", NO_SUCTION),
            *((f"{weight} kN/m³ everywhere", set_weight(weight, weight)) for weight in (15.597, 17.5, FULL)),
            *((f"{weight} kN/m³ above the water table, {FULL} below", set_weight(weight)) for weight in (15.597, 16.4, 17, 18)),
            (f"15.597 kN/m³ above the water table, {FULL} below, suction adds no strength", set_weight(15.597) + NO_SUCTION)]
TRIANGLES = ["analysis.methods=[\"mpm\"]", "strength_reduction.curve.enabled=false", "strength_reduction.frozen.meshes=1",
             "strength_reduction.frozen.smoothing=none", "compare=[]"]


def read_elements(summary):
    """Factors with ψ = 0 and with ψ = φ."""
    factors = {run["flow"]: run["factor"] for run in summary["fem"]["runs"]}
    return factors["as_given"], factors["associated"]


def show(factor):
    return f"**{factor:.3f}**" if abs(factor - PRINTED) <= TOLERANCE else f"{factor:.3f}"


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(program, scratch)
        text = CASE.read_text()
        for name, settings in VARIANTS:
            factors = read_elements(runner.run(name, text, [*ELEMENTS, *settings]))
            rows.append([name, *map(show, factors)])
            print(*rows[-1], flush=True)
        for size in (1.5, 0.75):
            frozen = runner.run(f"triangles {size}", text, [*TRIANGLES, f"mesh.size={size}"])["factor_of_safety"]["frozen"]
            rows.append([f"three-node triangles of {size} m, no smoothing", show(frozen["factor"]), "–"])
            print(*rows[-1], flush=True)
    (folder / "envelope_fem.md").write_text(f"""# Unsaturated slope: FEM over what the source leaves open

Written by `tools/verify_fem_choices.py PROGRAM FOLDER`. Section 3.4.2 prints {PRINTED} by another program and says nothing of its elements, mesh, weights and tolerances;
factors within {TOLERANCE} of it are bold.

{table_of(["choice", "ψ = 0, as printed", "ψ = φ"], rows)}""")


if __name__ == "__main__":
    main()
