#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whole runs on a device beside the processor: factors, displacements, and where the time goes.

Usage: tools/verify_device.py PROGRAM [--device gpu|emulated] [--only NAME ...] [--out FOLDER] [--write]
The emulated device is the kernels of a GPU on the processor: it verifies the numbers, and not the behaviour of a
GPU's time. --write stores the table in docs/verification_data/device.md. The cases take a quarter of an hour with it.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "docs/verification_data/device.md"
# Local damping takes the sign of velocities that are round-off near rest; without it the same numbers are expected.
CASES = {
    "dry slope": ("dry_slope", []),
    "dry slope, undamped": ("dry_slope", ["analysis.kind=run", "stage.0.until=time", "stage.0.duration=2", "stage.0.damping=0",
                                          "stage.1.damping=0", "stage.1.duration=4"]),
    "vegetated slope": ("vegetated_slope", ["stage.0.duration=14", "stage.0.until=time", "stage.1.damping=0"]),
    "slope in 3D, H/10": ("slope_3d", ["mesh.size=1", "strength_reduction.curve.from=2", "strength_reduction.curve.to=2.4",
                                       "strength_reduction.curve.step=0.4", "strength_reduction.curve.runout_time=4"]),
}


def run(program, case, settings, device, folder):
    command = [program, "run", str(ROOT / "examples" / case / "case.toml"), "-o", str(folder), "--device", device, "-q", "--no-report"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{case} on {device}: {done.stderr.strip()}")
    return json.loads((folder / "summary.json").read_text())


def list_values(summary):
    """Name, unit and value of what a run has found."""
    factors = summary.get("factor_of_safety") or {}
    for criterion in factors.get("criteria") or []:
        yield f"factor, {criterion['name']}", "", criterion["factor"]
    if factors.get("frozen"):
        yield "factor, frozen", "", factors["frozen"]["factor"]
    for point in ((summary.get("curve") or {}).get("points") or [])[-1:]:
        yield f"largest displacement at SRF {point['srf']:g}", "m", point["displacement"]
    for stage in summary["stages"]:
        yield f"largest displacement, {stage['name']}", "m", stage["displacement"]


def write_rows(name, here, there):
    values = zip(list_values(here), list_values(there))
    return [f"| {name} | {what}{f' [{unit}]' if unit else ''} | {a:.9g} | {b:.9g} | {abs(b - a) / max(abs(a), 1e-12):.1e} |"
            for (what, unit, a), (_, _, b) in values if a is not None and b is not None]


def find_part(summary, name):
    return sum(part["seconds"] for part in summary["timing"]["parts"] if part["name"] == name)


def write_table(results, device):
    lines = ["# Whole runs on a device", "",
             f"Made by `tools/verify_device.py PROGRAM --device {device} --write`. The device is {device}"
             + (": the kernels of a GPU on the processor, so its times say nothing about a GPU." if device == "emulated" else "."), "",
             "| case | result | processor | device | relative difference |", "|---|---|--:|--:|--:|"]
    for name, (here, there) in results.items():
        lines += write_rows(name, here, there)
    lines += ["", "| case | points | processor, wall [s] | device, wall [s] | of it steps, summed over trials side by side [s] | of it transfers [s] |",
              "|---|--:|--:|--:|--:|--:|"]
    for name, (here, there) in results.items():
        lines.append(f"| {name} | {here['mesh']['points']} | {here['timing']['wall']:.1f} | {there['timing']['wall']:.1f} | "
                     f"{find_part(there, 'device'):.1f} | {find_part(there, 'transfer'):.2f} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--device", default="emulated")
    parser.add_argument("--only", nargs="+", choices=CASES, default=list(CASES))
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    if options.write and options.only != list(CASES):
        parser.error("--write stores the table of all cases: leave --only out")
    program = str(pathlib.Path(options.program).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.out or pathlib.Path(scratch)
        results = {}
        for name in options.only:
            case, settings = CASES[name]
            results[name] = [run(program, case, settings, device, folder / f"{name.replace(' ', '_')}.{device}") for device in ("cpu", options.device)]
        table = write_table(results, options.device)
    print(table)
    if options.write:
        TABLE.write_text(table)


if __name__ == "__main__":
    main()
