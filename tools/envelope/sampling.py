# SPDX-License-Identifier: MIT
"""Latin hypercube over named levels and ranges of numbers, and values as TOML."""
import numpy as np


class Levels:
    """Named levels with weights."""

    def __init__(self, **weights):
        self.names, self.ends = list(weights), np.cumsum(list(weights.values())) / sum(weights.values())

    def at(self, u):
        return self.names[int(np.searchsorted(self.ends, u, side="right"))]


class Range:
    """Numbers between two ends, uniform or uniform in the logarithm, rounded to significant digits."""

    def __init__(self, low, high, log=False, digits=4):
        self.low, self.high, self.log, self.digits = low, high, log, digits

    def at(self, u):
        v = self.low * (self.high / self.low) ** u if self.log else self.low + (self.high - self.low) * u
        return float(f"{v:.{self.digits}g}")


def draw_hypercube(factors, samples, seed):
    """One {factor: level or number} for each sample. In every factor each of `samples` strata of equal probability holds one sample."""
    rng = np.random.default_rng(seed)
    columns = {name: [f.at(u) for u in (rng.permutation(samples) + rng.random(samples)) / samples] for name, f in factors.items()}
    return [{name: columns[name][i] for name in factors} for i in range(samples)]


def to_toml(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k} = {to_toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(to_toml(v) for v in value) + "]"
    return f'"{value}"' if isinstance(value, str) else f"{value:.10g}"
