# SPDX-License-Identifier: MIT
"""Values of the echoed case in SI units, and what belongs to polygons: soils at points, verticals, weights of columns."""
import math

import numpy as np

SI = {None: 1, "": 1, "1": 1, "m": 1, "mm": 1e-3, "in": 0.0254, "ft": 0.3048, "Pa": 1, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "psf": 47.88025898,
      "lbf/ft2": 47.88025898, "psi": 6894.757293, "N/m3": 1, "kN/m3": 1e3, "pcf": 157.0874638, "lbf/ft3": 157.0874638, "deg": math.pi / 180, "rad": 1,
      "kPa/m": 1e3, "kg/m3": 1, "m/s2": 1, "kN": 1e3, "kN/m": 1e3, "kPa-1": 1e-3, "%": 1e-2, "year": 1, "day": 86400}


class NotEvaluated(Exception):
    """A part of the case that this package does not know."""


def convert(value, unit, key):
    if unit not in SI:
        raise NotEvaluated(f"unit '{unit}' of {key}")
    if isinstance(value, list):
        return np.array(value, float) * SI[unit] if unit is not None or all(isinstance(v, (int, float, list)) for v in value) else value
    return value * SI[unit] if isinstance(value, (int, float)) and not isinstance(value, bool) else value


def get(block, key):
    """Value of a key of the echoed case in SI units; None if it has none."""
    entry = block.get(key)
    if entry is None or entry.get("value") is None:
        return None
    value = entry["value"]
    return convert(float("inf") if value == "inf" else value, entry.get("unit"), key)


def has(block, key):
    """Whether a list of the echoed case has entries."""
    values = get(block, key)
    return values is not None and len(values) > 0


def are_inside(polygon, x):
    """Whether points lie inside a polygon; array of the points."""
    inside = np.zeros(len(x), bool)
    for p, q in zip(polygon, np.roll(polygon, 1, axis=0)):
        if p[1] != q[1]:
            inside ^= ((p[1] > x[:, 1]) != (q[1] > x[:, 1])) & (x[:, 0] < (q[0] - p[0]) * (x[:, 1] - p[1]) / (q[1] - p[1]) + p[0])
    return inside


def find_area(polygon):
    x, y = polygon.T
    return abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def interpolate_level(line, x):
    """Ordinate of a polyline at x, level beyond its ends."""
    return np.interp(x, line[:, 0], line[:, 1])


class Polygons:
    """Polygons of soil; where one lies inside another, the inner one counts."""

    def __init__(self, case):
        polygons = [(get(p, "name"), get(p, "points")) for p in case["geometry"]["polygon"]]
        if not polygons or not all(len(p) for _, p in polygons):
            raise NotEvaluated("a section without polygons")
        names = {region: word["value"] if isinstance(word, dict) else word for region, word in case["regions"].items()}
        # From the smallest: the first that contains a point is the innermost.
        self.rings = sorted(((names[name], points) for name, points in polygons if name in names), key=lambda p: find_area(p[1]))
        points = np.vstack([p for _, p in self.rings])
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        self.near = 1e-5 * (self.high - self.low).max()
        self.names = sorted({name for name, _ in self.rings})

    def find_soils(self, x):
        """Numbers in `names` of the soils at points; -1: none."""
        found = np.full(len(x), -1)
        for name, ring in self.rings:
            left = np.flatnonzero(found < 0)
            found[left[are_inside(ring, x[left])]] = self.names.index(name)
        return found

    def list_crossings(self, x):
        """Levels of all polygon sides on verticals, by vertical; NaN where a side does not cross it."""
        columns = []
        for _, ring in self.rings:
            for p, q in zip(ring, np.roll(ring, -1, axis=0)):
                if p[0] != q[0]:
                    y = p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1])
                    columns.append(np.where((x >= min(p[0], q[0])) & (x <= max(p[0], q[0])), y, np.nan))
        return np.array(columns).T

    def find_tops(self, x):
        """Level of the ground at x; -inf beside the section."""
        levels = self.list_crossings(x)
        return np.where(np.isnan(levels), -np.inf, levels).max(axis=1)
