# SPDX-License-Identifier: MIT
"""Statements of section 3.4.2, unsaturated slope: quantities of one run, and further runs of a few samples for its sensitivities."""
import copy
import csv
import json

import numpy as np

from water_checks.runs import Run, read_frames

from .statements import ANY, Measured, Statement

TOE, NEAR, MIDDLE = np.array([32, 5]), 2.0, 10.0  # [m]
FEM = 1.289  # examples/unsaturated_slope/three_methods.toml, elements of 0.7 m, ψ = 0
READINGS = ("branches by least squares", "branches to 1.15 and from 1.35", "jump")
BRANCHES = (1.15, 1.35)

STATEMENTS = (
    Statement("U1", "3.4.2", "suction reaches a maximum of 56 kPa", "largest suction after the stages", "kPa", (52, 60), printed=56, tolerance=4),
    Statement("U2", "3.4.2", "the minimum degree of saturation is 0.52", "smallest saturation after the stages", "", (0.51, 0.53),
              printed=0.52, tolerance=0.01),
    Statement("U3", "3.4.2", "pore pressures are in very good agreement with FEM seepage", "RMS over elements of the difference to steady FEM seepage",
              "kPa", (0, 1), printed=0, tolerance=1),
    Statement("U4", "3.4.2", "factor of safety 1.28 by the criterion of the dry slope", "bilinear factor", "", (1.26, 1.30), (1.23, 1.33),
              printed=1.28, tolerance=0.02, digits=4),
    Statement("U5", "3.5", "clear transition from small displacement to rapid large deformation", "slope of the second line over that of the first",
              "", (10, ANY), (5, ANY), log=True),
    Statement("U6", "3.4.2", "MPM predicts a slightly lower factor than FEM", f"FEM ({FEM}) less bilinear factor", "", (0, 0.08), (-0.01, 0.08),
              printed=0.04, tolerance=0.04),
    Statement("U8", "3.4.2", "the strain band is fully developed near the toe but diffuse toward the crest",
              "largest strain within 2 m of the toe over the largest elsewhere (project: over the largest above mid-height), at the trial nearest to the factor",
              "", (1.5, ANY), (0, ANY), log=True),
    Statement("U9", "3.4.2", "the phreatic surface exits near the toe", "x of the highest wet point of the face", "m", (28, 32.2)),
    Statement("U10", "3.4.2", "time step, points per element and recording time have a negligible effect",
              "largest change of the factor: half the step, 6 points, twice the window", "", (0, 0.01), (0, 0.02), counts=False),
    Statement("U11", "3.4.2", "a finer discretization slightly lowers the factor", "change of the factor, 0.5 m for 0.75 m", "", (-0.07, 0), counts=False),
    Statement("U12", "3.4.2", "damping below 0.05 amplifies the displacement near failure several times over",
              "largest u(0)/u(0.05) over SRF from 1.15 to the factor", "", (2, ANY), (1.5, ANY), log=True, counts=False),
    Statement("U13", "3.4.2", "damping below 0.05 triggers failure slightly earlier", "change of the factor without damping", "", (-0.06, 0), counts=False),
)


def read_curve(folder):
    """SRF and largest displacement [m]."""
    with open(folder / "curve.csv", newline="") as file:
        rows = list(csv.reader(file))[1:]
    return np.array([[float(row[0]), float(row[1])] for row in rows]).T


def find_crossing(srf, moved, branches=BRANCHES):
    """SRF at which the lines through the points up to one SRF and from another one intersect."""
    (a, b), (c, d) = (np.polyfit(srf[part], moved[part], 1) for part in (srf <= branches[0] + 1e-9, srf >= branches[1] - 1e-9))
    return float((b - d) / (c - a))


def compare_seepage(run, frame):
    """Root mean square over the elements of the difference to the steady state of FEM on the same mesh [kPa]. Points are numbered element by
    element, and none leaves its element in the stages."""
    water = json.loads((run.folder / "water.json").read_text())
    elements, steady = np.array(water["elements"]), np.array(water["states"][0]["pressure"])
    computed = frame["pore_pressure"][np.argsort(frame["id"])].reshape(len(elements), -1).mean(axis=1)
    return float(np.sqrt(np.mean((computed - steady[elements].mean(axis=1)) ** 2))) / 1e3


def find_exit(frame, depth=0.25):
    """x of the highest wet point of the face, within this depth below it."""
    start = frame.points[:, :2] - frame["displacement"][:, :2]
    x, y = start.T
    below = (2 * (15 - y) - (x - 12)) / np.sqrt(5)
    wet = (below < depth) & (x > 12) & (x < 32.5) & (frame["pore_pressure"] > 0)
    return float(x[wet][np.argmax(y[wet])]) if wet.any() else float("nan")


def compare_band(folder, factor):
    """Largest deviatoric strain within 2 m of the toe over the largest elsewhere, and over the largest above mid-height, at the trial nearest to
    the factor."""
    if not np.isfinite(factor):
        return Measured(float("nan"))
    trials = {float(path.name.split("_")[1]): path for path in (folder / "trials").glob("srf_*")}
    nearest = min(trials, key=lambda srf: abs(srf - factor))
    frame = read_frames(trials[nearest] / "results.vtkhdf", ("displacement", "deviatoric_strain"))[-1]
    start = frame.points[:, :2] - frame["displacement"][:, :2]
    near, strain = np.linalg.norm(start - TOE, axis=1) < NEAR, frame["deviatoric_strain"]
    largest = strain[near].max()
    return Measured(float(largest / strain[~near].max()), project=largest >= 1.5 * strain[start[:, 1] > MIDDLE].max())


def find_factors(run):
    """The factor of each of READINGS; NaN where there is none."""
    found = {c["name"]: c["factor"] for c in run.summary["factor_of_safety"]["criteria"] if c["factor"] is not None}
    return [found.get("bilinear", float("nan")), find_crossing(*read_curve(run.folder)), found.get("jump", float("nan"))]


def measure(folders):
    """{reading: {statement: Measured}} of one sample, whose only case has the folder folders[""]."""
    run = Run(folders[""], "")
    frame = run.frames(("id", "displacement", "pore_pressure", "saturation"))[-1]
    lines = run.summary["curve"].get("bilinear")
    ratio = lines["second"]["slope"] / max(lines["first"]["slope"], 1e-9) if lines else float("nan")
    common = {"U1": Measured(-frame["pore_pressure"].min() / 1e3), "U2": Measured(float(frame["saturation"].min())),
              "U3": Measured(compare_seepage(run, frame)), "U5": Measured(ratio), "U9": Measured(find_exit(frame))}
    found = {}
    for reading, factor in zip(READINGS, find_factors(run)):
        found[reading] = common | {"U4": Measured(factor), "U6": Measured(FEM - factor), "U8": compare_band(folders[""], factor)}
    return found


# Further runs of the samples nearest to the printed factor: one parameter is changed in each.
CURVE = "strength_reduction.curve"


def change(curve=None, **keys):
    """Settings with other values in the table of the curve and of other keys; a function of the settings of a sample."""
    def apply(settings):
        settings = copy.deepcopy(settings)
        settings[CURVE] |= curve(settings[CURVE]) if curve else {}
        return settings | {"mesh.points_per_element": 3} | {key.replace("__", "."): value for key, value in keys.items()}
    return apply


def damp(value):
    return lambda curve: {"damping": value} | ({"water_damping": value} if curve["water"] == "flows" else {})


CHANGES = {
    "step": change(lambda curve: {"courant": 0.49}),
    "points": change(mesh__points_per_element=6),
    "window": change(lambda curve: {"window": 2 * curve["window"]}),
    "fine": change(mesh__size=0.5),
    "damping 0.01": change(damp(0.01)),
    "damping 0": change(damp(0)),
}


def select_nearest(values, count=10):
    """Samples whose factor is nearest to the printed one. `values`: {sample: factor}."""
    printed = next(s.printed for s in STATEMENTS if s.name == "U4")
    return sorted((i for i in values if np.isfinite(values[i])), key=lambda i: abs(values[i] - printed))[:count]


def list_extra_rows(slope, design, samples):
    """(name, settings) of the further runs of these samples."""
    return [(f"{slope.get_name(i, '')} {name}", apply(slope.settings(design[i], ""))) for i in samples for name, apply in CHANGES.items()]


def measure_extra(base, folders):
    """{statement: Measured} of U10 to U13. `base`: folder of the sample; `folders`: {change: folder} of the further runs."""
    runs = {name: Run(folder, "") for name, folder in folders.items()}
    factor = find_factors(Run(base, ""))[0]
    shift = {name: find_factors(run)[0] - factor for name, run in runs.items()}
    (srf, moved), (others, free) = read_curve(base), read_curve(folders["damping 0"])
    srf, i, j = np.intersect1d(np.round(srf, 6), np.round(others, 6), return_indices=True)
    near = (srf >= 1.15) & (srf <= factor)
    return {"U10": Measured(max(abs(shift[name]) for name in ("step", "points", "window"))), "U11": Measured(shift["fine"]),
            "U12": Measured(float((free[j] / moved[i])[near].max(initial=0))), "U13": Measured(shift["damping 0"])}
