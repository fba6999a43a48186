# SPDX-License-Identifier: MIT
"""Statements of section 4.5, centrifuge slope: quantities of one sample, which is two runs, fallow and rooted."""
import numpy as np

from centrifuge_checks.results import TRANSDUCERS, Results
from centrifuge_checks.table import PUBLISHED

from .statements import ANY, Measured, Statement

MOVES = 0.004  # displacement that begins movement, 1 % of the relief [m]
SURFACE = 0.02  # depth of points that count as surface [m]
PLACES = (0.20, 0.22, 0.24, 0.26, 0.28, 0.30, 0.32, 0.34)  # x of other points "near the slope toe" [m]
READINGS = ("monitor at (0.25, 0.12)", *(f"surface point at x = {x:.2f}" for x in PLACES))
GROUND = ([0, 0.2, 0.6, 0.8], [0.08, 0.08, 0.48, 0.48])  # [m]
STEP = 0.03  # rise of the highest moved soil that makes a new block, an element [m]

STATEMENTS = (
    Statement("C1–4", "Table 4.6", "computed pressures A to D, initial to rise 3", "pressures within 10 % before failure, of 16", "", (14, 16), (12, 16), digits=2),
    Statement("C5", "Table 4.6", "32.7 kPa at C and 43.6 kPa at D at failure", "larger difference at the onset", "%", (0, 10), (0, 15), printed=0, tolerance=10),
    Statement("C6", "4.5.3", "deformation first concentrates near the toe during the hold at the third water level",
              "largest strain at x < 0.3 m over the median, after rise 2 or 3, where it is the largest of all", "", (3, ANY), log=True),
    Statement("C7", "4.5.3", "failure immediately after the fourth raise", "onset after the fourth raise", "s", (0, 30), (0, 60)),
    Statement("C8", "4.5.3", "three blocks that develop progressively upslope", "steps of the highest moved soil", "", (3, ANY), (2, ANY), digits=2),
    Statement("C9", "4.5.3", "the fallow slope stabilizes near 245 mm", "displacement at the end; strict: less than 2 % of it in the last 20 s", "mm",
              (208, 282), (172, 318), printed=245, tolerance=37),
    Statement("C10", "4.5.3", "movement of the rooted slope starts about 25 s later, in the same raise", "onset, rooted less fallow", "s",
              (17, 33), (0, 60), printed=25, tolerance=8),
    Statement("C11", "4.5.3", "the rooted slope moves more gradually and stabilizes near 135 mm", "displacement at the end, rooted, with a smaller peak speed", "mm",
              (115, 155), (95, 175), printed=135, tolerance=20),
    Statement("C12", "4.5.3", "final displacement is roughly half that of the fallow slope", "rooted over fallow", "", (0.4, 0.7), printed=0.55, tolerance=0.15),
    Statement("C13", "4.5.3", "a shear surface beneath the rooted layer", "median strain of the moving soil, in the layer over below it, where the largest is below",
              "", (0, 0.25), (0, 0.5)),
    Statement("C14", "4.5.3", "displaced soil accumulates at the toe", "runout, fallow", "m", (0.05, ANY)),
    Statement("C15", "4.5.1", "initial saturation of 0.65", "mean saturation above the table; a measured value of the test", "", (0.62, 0.70), counts=False),
    Statement("C16", "4.5.3", "the slope is stable through rise 3", "displacement at the end of rise 3, fallow", "mm", (0, 4), (0, 8), log=True),
)


class Point:
    """Displacement of a surface point over the injection [m]: the monitor, or the point of the frames that starts nearest to a place."""

    def __init__(self, results, frames, x=None):
        start = results.summary["stages"][-1]["start"]
        if x is None:
            self.time, self.moved = results.time, results.displacement
        else:
            first = frames[0]
            surface = np.interp(first["points"][:, 0], *GROUND) - first["points"][:, 1] < SURFACE
            ids = first["id"][surface]
            chosen = ids[np.argmin(np.abs(first["points"][surface, 0] - x))]
            self.time = np.array([f["time"] for f in frames])
            self.moved = np.array([np.linalg.norm(f["displacement"][f["id"] == chosen], axis=1).max(initial=0) for f in frames])
        during = self.time > start + 0.5  # displacements begin again with the injection
        self.time, self.moved = self.time[during], self.moved[during]

    @property
    def onset(self):
        above = np.flatnonzero(self.moved > MOVES)
        if not len(above):
            return float("nan")
        i = above[0]
        return float(self.time[i] if i == 0 else np.interp(MOVES, self.moved[i - 1:i + 1], self.time[i - 1:i + 1]))

    @property
    def end(self):
        return float(self.moved[-1])

    def is_at_rest(self):
        return self.end - np.interp(self.time[-1] - 20, self.time, self.moved) < 0.02 * self.end

    def find_peak_speed(self):
        """Of means over 10 s [m/s]."""
        time = np.arange(self.time[0], self.time[-1], 10.0)
        return float(np.diff(np.interp(time, self.time, self.moved)).max() / 10)


def count_pressures(results, onset):
    """How many of the 16 pressures from the start to rise 3 lie within 10 % of the published ones; only before the slope fails."""
    ends = results.hold_ends()[:4]
    return sum(abs(value / published - 1) <= 0.1 for stage, end in zip(("initial", "rise 1", "rise 2", "rise 3"), ends)
               if not onset < end for value, published in zip(results.pressures(end), PUBLISHED[stage]))


def compare_failure(results, onset):
    """Larger difference of C and D at the onset [%]."""
    if np.isnan(onset):
        return float("nan")
    found = dict(zip(TRANSDUCERS, results.pressures(onset)))
    return max(100 * abs(found[letter] / PUBLISHED["failure"][TRANSDUCERS.index(letter)] - 1) for letter in "CD")


def find_toe_strain(results, frames, onset):
    """Largest strain over the median strain at the end of rise 2 or rise 3, where the largest is at the toe and the slope is stable; NaN else."""
    ratios = []
    for end in results.hold_ends()[2:4]:
        frame = min(frames, key=lambda f: abs(f["time"] - end))
        largest = np.argmax(frame["deviatoric_strain"])
        if not onset < end and frame["points"][largest, 0] < 0.3:
            ratios.append(float(frame["deviatoric_strain"][largest] / np.median(frame["deviatoric_strain"])))
    return max(ratios, default=float("nan"))


def count_blocks(results, frames):
    """Steps by which the highest soil of the face that has moved rises; frames that rise one after another make one step."""
    heights, _ = results.highest_moved(frames)
    rises = np.diff(heights) > STEP
    return int(np.sum(rises & ~np.concatenate([[False], rises[:-1]])))


def find_layer(results, frame, origin):
    """Points that start in the rooted layer."""
    roots = results.summary["input"]["roots"][0]
    x, y = origin.T
    depth = np.where((x > 0.2) & (x < 0.6), (np.interp(x, *GROUND) - y) / np.sqrt(2), np.interp(x, *GROUND) - y)
    inside = depth < roots["depth"]["value"]
    along = roots.get("along", {}).get("value") or []
    return inside & (x > along[0][0]) & (x < along[-1][0]) if along else inside


def compare_layer(results, frames):
    """Median strain of the moving soil in the layer over that below it, where the largest strain is below; NaN else."""
    first = {int(i): p for i, p in zip(frames[0]["id"], frames[0]["points"])}
    frame = frames[-1]
    layer = find_layer(results, frame, np.array([first[int(i)] for i in frame["id"]]))
    moving, strain = np.linalg.norm(frame["displacement"], axis=1) > MOVES, frame["deviatoric_strain"]
    if layer[np.argmax(strain)] or not (moving & layer).any() or not (moving & ~layer).any():
        return float("nan")
    return float(np.median(strain[moving & layer]) / np.median(strain[moving & ~layer]))


def measure_point(fallow, rooted, points):
    """C1–4, C5, C7 and C9 to C12, C16, which depend on the point that is followed."""
    one, two = points
    same = np.isfinite(two.onset) and np.isfinite(one.onset) and fallow.stage_at(one.onset) == rooted.stage_at(two.onset)
    gradual = two.find_peak_speed() < one.find_peak_speed()
    stable = np.interp(fallow.raised_at[3], one.time, one.moved)
    return {"C1–4": Measured(count_pressures(fallow, one.onset)), "C5": Measured(compare_failure(fallow, one.onset)),
            "C7": Measured(one.onset - fallow.raised_at[3]),
            "C9": Measured(1e3 * one.end, strict=one.is_at_rest()), "C10": Measured(two.onset - one.onset, same, same),
            "C11": Measured(1e3 * two.end, gradual, gradual), "C12": Measured(two.end / one.end if one.end > MOVES else float("nan")),
            "C16": Measured(1e3 * float(stable))}


def measure(folders):
    """{reading: {statement: Measured}} of one sample. `folders`: {case: folder}."""
    fallow, rooted = (Results(folders[case], "") for case in ("fallow", "rooted"))
    names = ("id", "displacement", "deviatoric_strain", "saturation", "pore_pressure")
    frames, others = fallow.frames(names), rooted.frames(names)
    dry = frames[0]["pore_pressure"] < 0
    found = fallow.summary["runout"]
    runout = max(0.0, found["direction"] * (found["mass_front"] - found["initial_toe"]))  # of 99 % of the moved mass
    monitor = Point(fallow, frames).onset
    common = {"C6": Measured(find_toe_strain(fallow, frames, monitor)), "C8": Measured(count_blocks(fallow, frames)),
              "C13": Measured(compare_layer(rooted, others)), "C14": Measured(runout),
              "C15": Measured(float(frames[0]["saturation"][dry].mean()))}
    found = {}
    for reading, x in zip(READINGS, (None, *PLACES)):
        found[reading] = common | measure_point(fallow, rooted, (Point(fallow, frames, x), Point(rooted, others, x)))
    return found
