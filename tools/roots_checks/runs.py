# SPDX-License-Identifier: MIT
"""Runs the vegetated slope with settings and reads its results: onsets, displacements, sections, frames."""
import pathlib
import re
import subprocess

import numpy as np

from water_checks.runs import Run

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples" / "vegetated_slope"
MONITORS = ("toe", "mid_face", "crest")
DENSITY = 1000  # of water [kg/m³]


class Slope(Run):
    """A finished run of the slope; times count from the start of the rain."""

    def __init__(self, folder, command):
        super().__init__(folder, command)
        self.values = {r["name"]: r["value"] for r in self.summary["results"]}
        self.start = self.summary["clock"]["start"]

    def onset(self, monitor):
        """[s], None when it does not move."""
        return self.values.get(f"onset[{monitor}]")

    def moved(self, monitor):
        """Displacement at the end [m]."""
        return self.values[f"displacement[{monitor}]"]

    @property
    def runout(self):
        """Distance beyond the toe of 99 % of the moved mass [m]."""
        found = self.summary["runout"]
        return max(0.0, found["direction"] * (found["mass_front"] - found["initial_toe"]))

    @property
    def pattern(self):
        return self.summary["motion"]["pattern"]

    def first_passing(self, monitor, threshold):
        """When its displacement passes a threshold [m] for the first time [s]; None when never."""
        time, moved = self.history(monitor)
        above = np.flatnonzero(moved > threshold)
        if not len(above):
            return None
        i = above[0]
        return float(np.interp(threshold, moved[i - 1:i + 1], time[i - 1:i + 1]))

    def history(self, monitor):
        """Time from the start of the rain [s] and displacement [m]."""
        table = self.table("monitors.csv")
        time = table["time"] - self.start
        rain = time > 0
        return time[rain], table[f"{monitor}.displacement"][rain]

    def water(self):
        """Rain on the ground [m³/m]: supply, infiltration, runoff; and the error of the budget."""
        ground = next(s for s in self.summary["water"]["surfaces"] if s["name"] == "ground")
        return {key: ground[key] / DENSITY for key in ("supplied", "entered", "left", "runoff")} | {"error": self.summary["water"]["error"]}

    def frame(self, time):
        """The stored frame nearest to a time from the start of the rain."""
        if not hasattr(self, "_frames"):
            self._frames = self.frames(("id", "material", "displacement", "mean_stress", "deviatoric_strain", "pore_pressure", "saturation",
                                        "volume", "preconsolidation_pressure"))
        return min(self._frames, key=lambda f: abs(f.time - self.start - time))

    def moved_volume(self, time, threshold=0.1):
        """Volume of the points that have moved by more than a threshold [m³/m]."""
        frame = self.frame(time)
        return float(frame["volume"][np.linalg.norm(frame["displacement"], axis=1) > threshold].sum())

    def slide_depth(self, time, threshold=0.1):
        """Largest depth normal to the original face, of points of the face that have moved by more than a threshold [m]; None of none."""
        frame = self.frame(time)
        x, y = (frame.points - frame["displacement"])[:, :2].T
        slid = (x > 3) & (x < 7) & (np.linalg.norm(frame["displacement"], axis=1) > threshold)
        return float(((8 - x - y) / np.sqrt(2))[slid].max()) if slid.any() else None

    def profile(self, time, name, x, half_width=0.15, part=0.2):
        """Height and volume-weighted mean of a field over the points within half_width of a vertical line."""
        frame = self.frame(time)
        near = np.abs(frame.points[:, 0] - x) < half_width
        y, value, weight = frame.points[near, 1], frame[name][near], frame["volume"][near]
        bins = (y / part).astype(int)
        rows = [(np.average(y[bins == b], weights=weight[bins == b]), np.average(value[bins == b], weights=weight[bins == b]))
                for b in np.unique(bins)]
        return np.array(rows).T


class Runner:
    """Runs variants into one folder; with `reuse` a finished run with the same command is taken as it is, and with `finished`
    no other is started."""

    def __init__(self, program, folder, threads, reuse, finished=False):
        self.program, self.folder, self.threads, self.reuse, self.finished = program, folder, threads, reuse, finished

    def run(self, name, settings, case="case.toml"):
        """The finished run; None when it ended with an error or is left out. Its folder is the name in plain letters."""
        target = self.folder / re.sub(r"[^a-z0-9.]+", "_", name.lower().replace("×", "x").replace("β", "beta")).strip("_")
        shown = f"talus run examples/vegetated_slope/{case}"
        command = [self.program, "run", str(EXAMPLE / case), "-o", str(target), "--threads", str(self.threads), "-q", "--overwrite",
                   "--no-report"]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
            shown += f" --set '{key}={value}'" if " " in str(value) else f" --set {key}={value}"
        record = target / "command.txt"
        if not (self.reuse and record.exists() and record.read_text() == shown):
            if self.finished:
                return None
            if subprocess.run(command).returncode != 0:
                return None
            record.write_text(shown)
        return Slope(target, shown)
