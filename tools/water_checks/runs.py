# SPDX-License-Identifier: MIT
"""Runs a case with the program and reads what it left: histories, frames, summary."""
import csv
import dataclasses
import json
import pathlib
import subprocess

import h5py
import numpy as np

GRAVITY = 9.81
WATER_WEIGHT = 1000 * GRAVITY
CASES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "verification"


@dataclasses.dataclass
class Row:
    """One line of the table. `bound` is the largest difference that passes, in the unit of the values."""
    problem: str
    quantity: str
    computed: float
    exact: float
    bound: float
    unit: str = ""
    note: str = ""
    run: "Run" = None
    known_miss: bool = False  # listed in the table, but not a failure of the program

    @property
    def passes(self):
        return abs(self.computed - self.exact) <= self.bound


@dataclasses.dataclass
class Frame:
    time: float
    points: np.ndarray
    fields: dict

    def __getitem__(self, name):
        return self.fields[name]


def read_frames(path, names):
    """The stored frames of a run or a trial, with the named fields."""
    frames = []
    with h5py.File(path) as file:
        grid, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        for i, time in enumerate(steps["Values"]):
            n, at = grid["NumberOfPoints"][steps["PartOffsets"][i]], steps["PointOffsets"][i]
            fields = {}
            for name in names:
                first = steps["PointDataOffsets"][name][i]
                fields[name] = grid["PointData"][name][first:first + n]
            frames.append(Frame(float(time), grid["Points"][at:at + n], fields))
    return frames


class Run:
    """A finished run: its command, what it cost, and its results in SI units."""

    def __init__(self, folder, command):
        self.folder, self.command = folder, command
        self.summary = json.loads((folder / "summary.json").read_text())
        stages = self.summary["stages"]
        self.seconds = self.summary["timing"]["cpu"]  # processor time: what else runs on the machine does not matter
        self.steps = sum(stage["steps"] for stage in stages)
        self.points = self.summary["mesh"]["points"]
        self.step = stages[0]["time_step"]
        self.rate = self.steps * self.points / self.seconds

    def table(self, name="history.csv"):
        """Columns by their names without units; kPa and mm become Pa and m."""
        with open(self.folder / name, newline="") as file:
            rows = list(csv.reader(file))
        values = np.array([[float(v) for v in row] for row in rows[1:]])
        factors = {"kPa]": 1e3, "mm]": 1e-3}
        return {head.rsplit(" [", 1)[0]: values[:, i] * factors.get(head.rsplit("[", 1)[-1], 1)
                for i, head in enumerate(rows[0])}

    def frames(self, names=("id", "pore_pressure", "strain", "stress", "volume", "saturation", "velocity", "water_velocity")):
        return read_frames(self.folder / "results.vtkhdf", names)


class Runner:
    """Runs cases into one folder; with `reuse` a finished run with the same command is taken as it is."""

    def __init__(self, program, folder, threads, reuse):
        self.program, self.folder, self.threads, self.reuse = program, folder, threads, reuse

    def run(self, name, case, may_break=False, **settings):
        """The finished run; None when it may break, and did."""
        target = self.folder / name
        shown = f"talus run examples/verification/{case}"
        command = [self.program, "run", str(CASES / case), "-o", str(target), "--threads", str(self.threads), "-q",
                   "--overwrite", "--no-report"]
        for key, value in settings.items():
            setting = f"{key.replace('__', '.')}={value}"
            command += ["--set", setting]
            shown += f" --set '{setting}'" if " " in setting or '"' in setting else f" --set {setting}"
        record = target / "command.txt"
        if not (self.reuse and record.exists() and record.read_text() == shown):
            if subprocess.run(command, check=not may_break).returncode != 0:
                return None
            record.write_text(shown)
        return Run(target, shown)


def by_element(frame, name, count=3):
    """Middles of the elements (means of their points) and the element's value of a field, sorted upwards.

    Points are numbered element by element at the start, and in these problems none leaves its element."""
    order = np.argsort(frame["id"])
    middles = frame.points[order].reshape(-1, count, 3).mean(axis=1)
    values = frame[name][order].reshape(len(middles), count, -1).mean(axis=1).squeeze()
    upwards = np.argsort(middles[:, 1], kind="stable")
    return middles[upwards], values[upwards]


def budget_row(problem, run):
    return Row(problem, "water: stored – (start + in – out), over the water", abs(run.summary["water"]["error"]), 0, 1e-6,
               run=run)
