# SPDX-License-Identifier: MIT
"""A random input of one kind, the runs of the program on it, and the differences from the right answer."""
from __future__ import annotations

import json
import math
import pathlib
import random
import shutil
import time
import tomllib

from published.rewritten import write_case
from reliability.trial import run

WATER = 9.81e3  # unit weight of water [N/m³]
LIMIT = 120  # seconds of a run


class Refused(Exception):
    """The program ended without a result; the text is its message."""


class Trial:
    """Input `number` of a kind: `rng` draws it, `calculate` runs it, `near` and `expect` judge."""

    def __init__(self, program, folder, kind, seed, number, shift=0.0):
        """`shift`: all right answers are falsified by this part of their size, so that every comparison beyond its tolerance must fail."""
        self.program, self.kind, self.number, self.shift = program, kind, number, shift
        self.folder = pathlib.Path(folder) / f"{kind}_{number}".replace(" ", "_")
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.rng = random.Random(f"{seed} {kind} {number}")
        self.faults, self.checks, self.seconds = [], 0, time.monotonic()

    def draw(self, low, high, digits=3):
        return round(self.rng.uniform(low, high), digits)

    def draw_log(self, low, high):
        return float(f"{math.exp(self.rng.uniform(math.log(low), math.log(high))):.3e}")

    def write(self, name, case):
        """The path of NAME.toml with a case, which is a text or nested tables."""
        path = self.folder / f"{name}.toml"
        path.write_text(case if isinstance(case, str) else write_case(case))
        return path

    def call(self, name, case, *more, command="run", limit=LIMIT):
        path = self.write(name, case)
        return run(self.program, [command, path, *self.name_output(name, command), *more], limit)

    def name_output(self, name, command):
        return [] if command == "check" else ["-o", self.folder / name, "-q", "--no-report", "--threads", "1", "--overwrite"]

    def calculate(self, name, case, *more):
        """The summary of a run; a run without one is a fault of this trial."""
        verdict = self.call(name, case, *more)
        if verdict.code != 0 or verdict.fault:
            raise Refused(f"{name}: {verdict.fault or verdict.said.strip().rpartition('error: ')[2][:300]}")
        return json.loads((self.folder / name / "summary.json").read_text())

    def results(self, name, case, *more):
        return read_results(self.calculate(name, case, *more))

    def expect(self, truth, what):
        self.checks += 1
        if not truth:
            self.faults.append(what)

    def near(self, what, value, right, tolerance, scale=None):
        """`value` is `right` within `tolerance` times `scale` (by default its own size)."""
        size = abs(right) if scale is None else scale
        right += self.shift * size
        is_near = value is not None and abs(value - right) <= tolerance * size
        self.expect(is_near, f"{what} is {show(value)}, right: {show(right)}")


def show(value):
    return "missing" if value is None else f"{value:.6g}"


def read_results(summary):
    return {r["name"]: r["value"] for r in summary["results"]}


def read_case(text):
    return tomllib.loads(text)
