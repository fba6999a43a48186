# SPDX-License-Identifier: MIT
"""Cohesion of roots below a line of the ground (docs/manual, [[roots]]; docs/theory/17-root-cohesion.md)."""
import numpy as np

from .case import NotEvaluated, get


def find_distance(line, x):
    """Distance of points from a polyline [m]."""
    distance = np.full(len(x), np.inf)
    for p, q in zip(line, line[1:]):
        d = q - p
        s = np.clip(((x - p) @ d) / (d @ d), 0, 1)
        distance = np.minimum(np.hypot(*(x - p - s[:, None] * d).T), distance)
    return distance


def find_bundle_cohesion(bundle):
    """(T17.2) and (T17.4)."""
    areas, strengths = np.array(get(bundle, "area_ratios")), np.array(get(bundle, "strengths"))
    if get(bundle, "model") == "wu_waldron":
        return get(bundle, "orientation") * (areas * strengths).sum()
    section = np.pi * np.array(get(bundle, "diameters")) ** 2 / 4
    force, count = strengths * section, areas / section
    return get(bundle, "orientation") * max(f * count[force >= f].sum() for f in force)


def find_grown(block, age, table):
    points = (block.get(table) or {}).get("value")
    time = (block.get(age) or {}).get("value")
    if not points or time is None:
        return 1.0
    return float(np.interp(time, *np.array(points, float).T))


class Roots:
    def __init__(self, block, lines):
        self.line = lines[get(block, "ground")]
        self.depth, self.profile = get(block, "depth"), get(block, "profile")
        self.decay = get(block, "decay_depth")
        self.table = np.array(block["depth_table"]["value"], float) if (block.get("depth_table") or {}).get("value") else None
        self.along = np.array(block["along"]["value"], float) if (block.get("along") or {}).get("value") else None
        self.cohesion = get(block, "cohesion")
        if self.cohesion is None:
            self.cohesion = find_bundle_cohesion(block["bundle"]) if block.get("bundle") else 0.0
        self.cohesion *= find_grown(block, "age", "growth") * find_grown(block, "felled", "decay")

    def find(self, x):
        depth = find_distance(self.line, x)
        part = np.ones(len(x))
        if self.profile == "exponential":
            part = np.exp(-depth / self.decay)
        elif self.profile == "table":
            part = np.interp(depth, *self.table.T)
        if self.along is not None:
            part = part * np.interp(x[:, 0], *self.along.T)
        return np.where(depth <= self.depth, self.cohesion * part, 0.0)


def find_root_cohesion(case, soil):
    """Function of places that returns the cohesion of roots [Pa]: that of the blocks that reach a point, of the soil elsewhere."""
    constant = get(soil, "root_cohesion") or 0.0
    lines = {get(line, "name"): get(line, "points") for line in case["geometry"].get("line") or []}
    blocks = [Roots(block, lines) for block in case.get("roots") or []]
    if blocks and constant:
        raise NotEvaluated("root_cohesion of a soil beside [[roots]]")
    return lambda x: sum((block.find(x) for block in blocks), np.full(len(x), constant))
