# SPDX-License-Identifier: MIT
"""Evaluates the samples of a study: quantities, verdicts, effects, and what the runs that satisfy all statements have in common."""
import csv
import dataclasses
import importlib
import json

import numpy as np

from . import effects
from .statements import HELD


@dataclasses.dataclass
class Sample:
    """One sample: its choices and, when its runs have finished, {reading: {statement: Measured}}."""
    number: int
    choices: dict
    found: dict = None


class Evaluation:
    """The samples of a slope against its statements. The first reading is that of the example."""

    def __init__(self, name, slope, design):
        self.name, self.slope = name, slope
        self.module = importlib.import_module(f"envelope.{name}")
        self.statements, self.readings = self.module.STATEMENTS, self.module.READINGS
        self.samples = [Sample(i, choices) for i, choices in enumerate(design)]
        self.extra, self.broken, self.meshes = {}, [], {}

    def read(self, folder):
        """Evaluates every sample whose runs have all finished; `broken` are samples with a run that ended with an error."""
        results = read_results(folder)
        for sample in self.samples:
            names = {case: self.slope.get_name(sample.number, case) for case in self.slope.cases}
            folders = {case: folder / name.replace(" ", "_") for case, name in names.items()}
            if any(results.get(path.name, "").startswith(("unstable", "failed")) for path in folders.values()):
                self.broken.append(sample)
            elif all(is_finished(path) for path in folders.values()):
                sample.found = self.module.measure(folders)

    def read_extra(self, folder, samples):
        """Evaluates the further runs of these samples, where they have all finished."""
        for i in samples:
            name = self.slope.get_name(i, "")
            folders = {change: folder / f"extra_{self.name}" / f"{name}_{change}".replace(" ", "_") for change in self.module.CHANGES}
            if all(is_finished(path) for path in folders.values()):
                self.extra[i] = self.module.measure_extra(folder / f"runs_{self.name}" / name, folders)
                for found in self.samples[i].found.values():
                    found.update(self.extra[i])

    def read_meshes(self, folder):
        """Evaluates the central sample with the other mesh generators, where its runs have all finished."""
        central = self.choose_central()
        for name in self.slope.factors["algorithm"].names if central else ():
            cases = {case: folder / self.get_meshes_name() / f"{self.slope.get_name(central[2].number, case)} {name}".replace(" ", "_")
                     for case in self.slope.cases}
            if all(is_finished(path) for path in cases.values()):
                self.meshes[name] = self.module.measure(cases)

    def get_meshes_name(self):
        return f"meshes_{self.name}_{self.choose_central()[2].number + 1:03}"

    @property
    def finished(self):
        return [sample for sample in self.samples if sample.found]

    @property
    def counted(self):
        return [s for s in self.statements if s.counts]

    def get_values(self, name, reading=None):
        """The quantity of every finished sample; NaN where it was not evaluated."""
        reading = reading or self.readings[0]
        return np.array([s.found[reading][name].value if name in s.found[reading] else np.nan for s in self.finished])

    def judge(self, statement, kind, reading=None):
        """Whether the statement holds in each finished sample in which it was evaluated."""
        reading = reading or self.readings[0]
        verdicts = [statement.judge(s.found[reading].get(statement.name))[kind] for s in self.finished]
        return [v for v in verdicts if v is not None]

    def judge_all(self, kind, reading=None):
        return {s.name: self.judge(s, kind, reading) for s in self.counted}

    def list_complete(self, kind, reading=None):
        """Finished samples, by their place among these, in which every counted statement holds."""
        held = self.judge_all(kind, reading)
        return [i for i in range(len(self.finished)) if all(held[name][i] for name in held)]

    def compute_effects(self, statement, inside=None):
        """Main effects of all choices, largest first; `inside`: (factor, level) of the samples, for effects beside one that dominates."""
        values = self.get_values(statement.name)
        if statement.log:
            with np.errstate(divide="ignore", invalid="ignore"):
                values = np.where(values > 0, np.log(np.maximum(values, 1e-300)), np.nan)
        chosen = [i for i, s in enumerate(self.finished) if inside is None or s.choices[inside[0]] == inside[1]]
        return effects.compute_effects([self.finished[i].choices for i in chosen], values[chosen], self.slope.acts) if chosen else []

    def count_held(self, kind):
        """How many counted statements each finished sample satisfies."""
        return np.sum(list(self.judge_all(kind).values()), axis=0)

    def find_best_level(self, statement, factor):
        """The level in which the statement holds most often, strict before project."""
        verdicts = list(zip(self.judge(statement, "strict"), self.judge(statement, "project")))
        levels = [s.choices[factor] for s in self.finished]
        return max(sorted(set(levels)), key=lambda level: tuple(np.mean([v for v, at in zip(verdicts, levels) if at == level], axis=0)))

    def find_central(self, kind, reading=None):
        """(sample, distance) of the run that is nearest to what is printed; None when no run satisfies everything."""
        reading = reading or self.readings[0]
        values = [{name: m.value for name, m in s.found[reading].items()} for s in self.finished]
        targets = {s.name: (s.printed, s.tolerance) for s in self.counted if s.printed is not None}
        best = effects.find_central(self.list_complete(kind, reading), values, targets)
        return best and (self.finished[best[0]], best[1])

    def choose_central(self):
        """(kind, reading, sample, distance) of the most central run: strict before project, in each the first reading that has one; None when no
        run satisfies everything."""
        for kind in HELD:
            for reading in self.readings:
                best = self.find_central(kind, reading)
                if best:
                    return kind, reading, *best
        return None

    def write_csv(self, path):
        """One row a sample, also of those that have not finished."""
        with open(path, "w", newline="") as file:
            out = csv.writer(file)
            heads = [f"{s.name} [{s.unit or '-'}]" for s in self.statements] + [f"{s.name} holds" for s in self.statements]
            out.writerow(["sample", *self.slope.factors, *heads])
            for sample in self.samples:
                found = sample.found[self.readings[0]] if sample.found else {}
                out.writerow([sample.number + 1, *sample.choices.values(), *(format_value(s, found.get(s.name)) for s in self.statements),
                              *(format_verdict(s, found.get(s.name)) for s in self.statements)])


def is_finished(folder):
    summary = folder / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["status"] == "finished"


def read_results(folder):
    """{folder of a run: how it ended} of a study; empty without its table."""
    if not (folder / "study.csv").exists():
        return {}
    with open(folder / "study.csv", newline="") as file:
        return {row["variant"].replace(" ", "_"): row["result"] or "" for row in csv.DictReader(file)}


def format_value(statement, measured):
    if measured is None:
        return ""
    return "none" if np.isnan(measured.value) else f"{measured.value:.{statement.digits + 1}g}"


def format_verdict(statement, measured):
    """strict, project, or no; empty where it was not evaluated."""
    held = statement.judge(measured)
    return "" if measured is None else next((kind for kind in HELD if held[kind]), "no")
