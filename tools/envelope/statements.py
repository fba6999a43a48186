# SPDX-License-Identifier: MIT
"""A statement of the source as a quantity of the results and an interval, strict and as the project's bands have it."""
import dataclasses
import math

ANY = math.inf
HELD = ("strict", "project")  # the two readings of a statement: that of a careful engineer, and the project's bands


@dataclasses.dataclass
class Statement:
    """`printed` and `tolerance` rank runs that satisfy everything; `log`: effects are those on the logarithm. `counts`: it is one of the statements
    that a run has to satisfy together; not so what the source says of the test, and what needs more runs than the study has."""
    name: str
    place: str
    wording: str
    quantity: str
    unit: str
    strict: tuple
    project: tuple = None
    printed: float = None
    tolerance: float = None
    digits: int = 3
    log: bool = False
    counts: bool = True

    def get_interval(self, kind):
        return self.project if kind == "project" and self.project else self.strict

    def judge(self, measured):
        """{kind: whether it holds}; None without a value to judge."""
        if measured is None:
            return {kind: None for kind in HELD}
        return {kind: measured.get_verdict(kind, self.get_interval(kind)) for kind in HELD}


@dataclasses.dataclass
class Measured:
    """A quantity of one sample; NaN where it is not defined, which satisfies nothing. `strict` and `project` add conditions to the interval."""
    value: float
    strict: bool = True
    project: bool = True

    def get_verdict(self, kind, interval):
        return bool(getattr(self, kind)) and interval[0] <= self.value <= interval[1]


def format_interval(statement, kind):
    low, high = statement.get_interval(kind)
    unit = f" {statement.unit}" if statement.unit else ""
    if math.isinf(high):
        return f"≥ {low:g}{unit}"
    return f"≤ {high:g}{unit}" if math.isinf(low) else f"{low:g} to {high:g}{unit}"
