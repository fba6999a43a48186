# SPDX-License-Identifier: MIT
"""Reads a run of the centrifuge slope: transducers, the monitored point, and how far up the face the soil has moved."""
import csv
import json

import numpy as np

from water_checks.runs import read_frames

TRANSDUCERS = "ABCD"
STAGES = ("initial", "rise 1", "rise 2", "rise 3", "rise 4")
RISES = STAGES[1:]
MOVED = 0.02  # m; a point beyond this has gone


class Results:
    """Times in s, lengths in m, pressures in kPa (positive in compression)."""

    def __init__(self, folder, command):
        self.folder, self.command = folder, command
        self.summary = json.loads((folder / "summary.json").read_text())
        inlet = next(h for h in self.summary["input"]["hydraulic"] if h["on"]["value"] == "inlet")
        rows = inlet["pressure"]["value"]
        self.raised_at = [row[0] for row in rows[1:]]  # time of each raise
        with open(folder / "monitors.csv", newline="") as file:
            table = list(csv.reader(file))
        values = np.array([[float(v) for v in row] for row in table[1:]])
        self.monitors = {head.rsplit(" [", 1)[0]: values[:, i] for i, head in enumerate(table[0])}
        self.time = self.monitors["time"]
        stage = self.summary["stages"][-1]
        self.displacement = np.where(self.time < stage["start"], 0, self.monitors["toe.displacement"]) / 1e3
        self.seconds = self.summary["timing"]["cpu"]

    @property
    def onset(self):
        """When the monitored point has moved by 1 % of the relief, as the program's summary says, but in time since the start of
        the run; None if it has not."""
        onset = next(m["onset"] for m in self.summary["motion"]["monitors"] if m["name"] == "toe")
        return None if onset is None else onset + self.summary["motion"]["start"]

    def hold_ends(self):
        """When each hold ends, the baseline's first; of those that the run reached."""
        ends = [*self.raised_at, self.time[-1]]
        return [end for end in ends if end <= self.time[-1] + 1e-6]

    def stage_at(self, time):
        """Number of raises made by then."""
        return sum(time >= at for at in self.raised_at)

    def pressures(self, time):
        """At A to D, the mean of the 10 s before."""
        during = (self.time > time - 10) & (self.time <= time)
        return [float(self.monitors[f"{name}.pore_pressure"][during].mean()) for name in TRANSDUCERS]

    def moved(self, time):
        return float(np.interp(time, self.time, self.displacement))

    def frames(self, names=("id", "displacement", "deviatoric_strain")):
        return [{"time": frame.time, "points": frame.points[:, :2]} | frame.fields for frame in read_frames(self.folder / "results.vtkhdf", names)]

    def highest_moved(self, frames):
        """For every frame: the height above the base from which soil of the face has moved, at the start (0.08 m: none), and
        the fraction of the points that has moved."""
        start = frames[0]
        first = {int(i): p for i, p in zip(start["id"], start["points"])}
        heights, shares = [], []
        for frame in frames:
            origin = np.array([first[int(i)] for i in frame["id"]])
            gone = np.linalg.norm(frame["displacement"], axis=1) > MOVED
            gone &= frame["time"] > self.summary["stages"][-1]["start"] + 0.5
            heights.append(origin[gone, 1].max() if gone.any() else 0.08)
            shares.append(gone.mean())
        return np.array(heights), np.array(shares)
