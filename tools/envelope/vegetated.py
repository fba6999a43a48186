# SPDX-License-Identifier: MIT
"""Statements of section 4.4, vegetated slope: quantities of one sample, which is four runs, bare and with three root contents."""
import numpy as np

from roots_checks.quantities import (compare_preconsolidation, count_parts, find_face_strain, find_lower_face, find_moving_strain, find_wetted,
                                     read_suction)
from roots_checks.runs import MONITORS, Slope

from .design import CONTENTS
from .statements import ANY, Measured, Statement

ROOTED = tuple(name for name in CONTENTS if name != "bare")
THRESHOLDS = {"10 cm": 0.1, "5 cm": 0.05, "20 cm": 0.2}  # displacement that begins movement [m]; the first is the example's
PRINTED = (1798, 959, 1003, 3009, 990)  # triangles, nodes, triangles with soil, points, points of the layer
BANDS = (0.03, 0.03, 0.03, 0.03, 0.15)

STATEMENTS = (
    Statement("V1", "4.4.1", "1,798 triangles, 959 nodes; 1,003 with soil, 3,009 points, 990 in the layer",
              "largest difference over its band of 3 % (layer: 15 %)", "", (0, 1), (0, 2)),
    Statement("V2", "4.4.1", "computed suctions remain below about 30 kPa", "largest suction during the rain, bare; project: from 120 s on",
              "kPa", (0, 33), (0, ANY)),
    Statement("V3", "4.4.1", "all water infiltrates and no ponding occurs", "runoff over rain, bare", "", (0, 0.02), (0, 0.4)),
    Statement("V4", "4.4.2", "p'_c increases linearly below the table, suction strengthens above it, roots enlarge it", "parts that hold, of three",
              "", (3, 3), digits=1),
    Statement("V5", "4.4.2", "much of the upper profile falls to about 50 kPa", "fraction of the wetted soil with p'_c of 35 to 65 kPa at 230 s, bare",
              "", (0.5, 1), (0.25, 1)),
    Statement("V6", "4.4.2", "bare: the toe moves first, the mid-face follows, the crest joins last", "smaller gap between two onsets", "s", (1e-9, ANY)),
    Statement("V7", "4.4.2", "rooted: all three points start moving together", "(last – first)/last onset, largest of three contents", "",
              (0, 0.10), (0, 0.20)),
    Statement("V8", "4.4.2", "increasing biomass roughly halves the displacement of the upper slope",
              "mid-face, 1.29 % over bare; strict: the crest too, and less with each content", "", (0.35, 0.65), printed=0.5, tolerance=0.15),
    Statement("V9", "4.4.2", "with a smaller reduction near the toe", "toe ratio less mid-face ratio, smallest of three contents", "", (0.02, ANY), (0, ANY)),
    Statement("V10", "4.4.2", "by 200 s the lower face of the bare slope has failed", "larger of strain there over 0.2 and toe movement over 10 cm", "",
              (1, ANY), log=True),
    Statement("V11", "4.4.2", "by 200 s the rooted faces show no localization yet", "largest strain from the crest's edge on", "", (0, 0.1), log=True),
    Statement("V12", "4.4.2", "bare: strain spreads through the moving mass; rooted: a band below a block that is little strained",
              "smaller of median strain over 0.3, bare, and a quarter of that below the layer over that in it, rooted", "", (1, ANY), (0.5, ANY), log=True),
    Statement("V13", "4.4.2", "every case reaches a runout distance of about 2 m", "runout farthest from 2 m, of four cases", "m", (1.5, 2.5),
              printed=2, tolerance=0.5),
    Statement("V14", "4.4.2", "roots delay the onset of movement", "first onset of the rooted slopes less that of the bare one", "s", (1e-9, ANY)),
)
READINGS = tuple(f"movement begins at {name}" for name in THRESHOLDS)


def find_onsets(run, threshold):
    """Onset of movement of each monitored point [s]; NaN where it does not move."""
    found = {m: run.first_passing(m, threshold) for m in MONITORS}
    return {m: float("nan") if t is None else t for m, t in found.items()}


def measure_movement(runs, threshold):
    """V6, V7, V14, which depend on the displacement that begins movement."""
    onsets = {name: find_onsets(run, threshold) for name, run in runs.items()}
    bare = onsets["bare"]
    gaps = [bare["mid_face"] - bare["toe"], bare["crest"] - bare["mid_face"]]
    spread = [(max(times.values()) - min(times.values())) / max(times.values()) if np.isfinite(list(times.values())).all() else float("nan")
              for times in (onsets[name] for name in ROOTED)]
    end = runs["bare"].summary["stages"][-1]["time"] - runs["bare"].start
    first = {name: min(end if np.isnan(t) else t for t in times.values()) for name, times in onsets.items()}
    moves = first["bare"] < end
    return {"V6": Measured(float(np.min(gaps))), "V7": Measured(float(np.max(spread))),
            "V14": Measured(min(first[name] for name in ROOTED) - first["bare"] if moves else float("nan"))}


def compute_runoff(water):
    """Fraction of the rain that runs off; a prescribed flux supplies nothing that could."""
    return water["runoff"] / water["supplied"] if water["supplied"] else 0.0


def compare_counts(run):
    return max(abs(found / printed - 1) / band for found, printed, band in zip(count_parts(run), PRINTED, BANDS))


def count_preconsolidation(runs):
    found = compare_preconsolidation(runs["bare"], runs["1.29"])
    return int(found["off"] < 0.03) + int(found["crest"] > found["middle"] > found["wet"].max()) + int(found["roots"] > 1.1)


def measure_displacement(runs):
    """V8 and V9. A slope that has not moved gives no ratio."""
    moved = {name: {m: run.moved(m) for m in MONITORS} for name, run in runs.items()}
    ratio = {m: [moved[name][m] / moved["bare"][m] if moved["bare"][m] > 0.1 else float("nan") for name in ROOTED] for m in MONITORS}
    falls = all(a > b for m in ("mid_face", "crest") for a, b in zip(ratio[m], ratio[m][1:]))
    return {"V8": Measured(ratio["mid_face"][-1], strict=falls and 0.35 <= ratio["crest"][-1] <= 0.65),
            "V9": Measured(float(np.min(np.subtract(ratio["toe"], ratio["mid_face"]))))}


def compare_strain(runs):
    """V12: 1 where both parts are just satisfied."""
    parts = [find_moving_strain(runs["bare"])[0] / 0.3]
    for name in ROOTED:
        _, inside, below = find_moving_strain(runs[name])
        parts.append(0.25 * below / inside if inside else float("nan"))
    return float(np.min(parts))


def measure(folders):
    """{reading: {statement: Measured}} of one sample. `folders`: {case: folder}."""
    runs = {name: Slope(folder, "") for name, folder in folders.items()}
    bare = runs["bare"]
    water, (strain, toe) = bare.water(), find_lower_face(bare)
    time, suction = read_suction(bare)
    runouts = [run.runout for run in runs.values()]
    common = {"V1": Measured(compare_counts(bare)), "V2": Measured(float(suction.max()), project=suction[time > 120].max() <= 33),
              "V3": Measured(compute_runoff(water)), "V4": Measured(count_preconsolidation(runs)),
              "V5": Measured(find_wetted(bare)[2])} | measure_displacement(runs)
    common |= {"V10": Measured(float(max(strain / 0.2, toe / 0.1))), "V11": Measured(float(max(find_face_strain(runs[name]) for name in ROOTED))),
               "V12": Measured(compare_strain(runs)), "V13": Measured(max(runouts, key=lambda r: abs(r - 2)))}
    return {reading: common | measure_movement(runs, threshold) for reading, threshold in zip(READINGS, THRESHOLDS.values())}
