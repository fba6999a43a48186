#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the fields of a bounds.json prove, evaluated against the case by other code than the program's.

Usage: tools/verify_proof.py FOLDER … [--tolerance 5e-4] [--points 7]

FOLDER is a results folder with summary.json and bounds.json of `methods = ["bounds"]`. For the lower bound: equilibrium of each
triangle with the weights of the case, tractions across edges and on free sides, and the strength of the case at points inside.
For the upper bound: the work of weights, loads and pore pressures of the case, and its dissipation, at points inside; the flow rule;
the fixed sides. --points: points on a side of the lattice of each triangle.
Ends with 1 where a printed bound is not proven within the tolerance, with 2 where a part of the case is not evaluated here.
Formulas: docs/theory/21-proven-bounds.md. Stress is positive in tension, pore pressure in compression; SI units.
"""
import argparse
import json
import math
import pathlib
import sys
from collections import defaultdict

import numpy as np

SI = {None: 1, "m": 1, "ft": 0.3048, "Pa": 1, "kPa": 1e3, "MPa": 1e6, "psf": 47.88025898, "N/m3": 1, "kN/m3": 1e3, "pcf": 157.08746,
      "deg": math.pi / 180, "rad": 1, "kPa/m": 1e3, "kg/m3": 1, "m/s2": 1}
FLOW = 1e-4  # allowed lack of the flow rule over the mean shear rate: velocities are stored with six digits
EQUILIBRIUM = 1e-3  # allowed imbalance over the largest overburden, on triangles that no step of the unit weight crosses


class NotEvaluated(Exception):
    """A part of the case that this script does not know."""


def get(block, key):
    """Value of a key of the echoed case in SI units; None if it has none."""
    entry = block.get(key)
    if entry is None or entry.get("value") is None:
        return None
    unit, value = entry.get("unit"), entry["value"]
    if unit not in SI:
        raise NotEvaluated(f"unit '{unit}' of {key}")
    if isinstance(value, list):
        return np.array(value, float) * SI[unit]
    return value * SI[unit] if isinstance(value, (int, float)) and not isinstance(value, bool) else value


def is_inside(polygon, x):
    inside, j = False, len(polygon) - 1
    for i, p in enumerate(polygon):
        q = polygon[j]
        if (p[1] > x[1]) != (q[1] > x[1]) and x[0] < (q[0] - p[0]) * (x[1] - p[1]) / (q[1] - p[1]) + p[0]:
            inside = not inside
        j = i
    return inside


class Section:
    """Soil, water and loads of a case at a point."""

    def __init__(self, case):
        for block in ("support", "roots", "slurry", "traction", "hydraulic", "construction", "timeline"):
            if case.get(block):
                raise NotEvaluated(f"[{block}]")
        if get(case["partial_factors"], "set") not in (None, "none"):
            raise NotEvaluated("[partial_factors]")
        if get(case["bounds"], "flow") != "associated":
            raise NotEvaluated("flow = davis")
        if list(get(case["gravity"], "direction")) != [0, -1] or get(case["earthquake"], "vertical"):
            raise NotEvaluated("inclined gravity or a vertical earthquake")
        self.polygons = [(get(p, "name"), get(p, "points")) for p in case["geometry"]["polygon"]]
        if not self.polygons or not all(len(p) for _, p in self.polygons):
            raise NotEvaluated("a section without polygons")
        self.soils = {name: case["materials"][word["value"] if isinstance(word, dict) else word] for name, word in case["regions"].items()}
        self.polygons = [(name, points) for name, points in self.polygons if name in self.soils]
        self.water_weight = get(case["water"], "density") * get(case["gravity"], "acceleration")
        self.horizontal = get(case["earthquake"], "horizontal") or 0
        self.direction = get(case["earthquake"], "direction")
        self.takes_tension = get(case["bounds"], "tension") == "as_given"
        self.read_water(case["initial"])
        self.loads = [(get(s, "x"), get(s, "load")) for s in case.get("surcharge", [])]
        if any(x is None or q is None for x, q in self.loads):
            raise NotEvaluated("a surcharge of this form")
        self.sides = {get(b, "on"): get(b, "fix") for b in case["boundary"]}
        if not set(self.sides) <= {"bottom", "left", "right"}:
            raise NotEvaluated(f"sides {sorted(self.sides)}")
        points = np.vstack([p for _, p in self.polygons])
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        self.near = 1e-5 * (self.high - self.low).max()
        for soil in self.soils.values():
            self.check(soil)

    def read_water(self, initial):
        kind = get(initial, "pore_pressure")
        self.table = None
        if kind == "water_table" and not initial.get("piezometric_line"):
            self.table = get(initial, "water_table")
        elif kind != "zero":
            raise NotEvaluated(f"pore_pressure = {kind}")

    def check(self, soil):
        model = get(soil, "model")
        if model not in ("mohr_coulomb", "tresca"):
            raise NotEvaluated(f"model = {model}")
        if self.has(soil, "profile_x"):
            raise NotEvaluated("a grid of profiles")
        if get(soil, "b_bar") or soil.get("water", {}).get("retention", {}).get("value", "dry") != "dry":
            raise NotEvaluated("B-bar or suction")

    @staticmethod
    def has(soil, key):
        values = get(soil, key)
        return values is not None and len(values) > 0

    def find_soil(self, x):
        for name, polygon in self.polygons:
            if is_inside(polygon, x):
                return self.soils[name]
        raise NotEvaluated(f"no soil at {x[0]:.3f}, {x[1]:.3f}")

    def find_top(self, x):
        """Level of the ground at x."""
        top = -math.inf
        for _, polygon in self.polygons:
            for p, q in zip(polygon, np.roll(polygon, -1, axis=0)):
                if min(p[0], q[0]) <= x <= max(p[0], q[0]):
                    top = max(top, p[1], q[1]) if p[0] == q[0] else max(top, p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]))
        return top

    def find_head(self, x):
        return 0.0 if self.table is None else self.water_weight * max(0.0, np.interp(x[0], self.table[:, 0], self.table[:, 1]) - x[1])

    def find_weight(self, soil, x):
        saturated = get(soil, "saturated_unit_weight")
        return saturated if saturated is not None and self.find_head(x) > 0 else get(soil, "unit_weight")

    def find_pressure(self, soil, x):
        if get(soil, "model") == "tresca":
            return 0.0
        ratio = get(soil, "pore_pressure_ratio")
        return ratio * self.find_overburden(x) if ratio else self.find_head(x)

    def find_overburden(self, x):
        """Weight of the soil above a point, by the borders of polygons and the water table on its vertical."""
        levels = {x[1], self.find_top(x[0])}
        for _, polygon in self.polygons:
            for p, q in zip(polygon, np.roll(polygon, -1, axis=0)):
                if p[0] != q[0] and min(p[0], q[0]) <= x[0] <= max(p[0], q[0]):
                    levels.add(p[1] + (x[0] - p[0]) / (q[0] - p[0]) * (q[1] - p[1]))
        if self.table is not None:
            levels.add(float(np.interp(x[0], self.table[:, 0], self.table[:, 1])))
        above = sorted(y for y in levels if x[1] <= y <= max(x[1], self.find_top(x[0])))
        total = 0.0
        for a, b in zip(above, above[1:]):
            middle = np.array([x[0], (a + b) / 2])
            total += (b - a) * self.find_weight(self.find_soil(middle), middle)
        return total

    def find_strength(self, soil, x):
        """Returns c [Pa], tan φ and the tensile strength [Pa], infinite where none limits."""
        if self.has(soil, "profile_strengths"):
            # Linear between levels or depths, constant beyond them.
            by_level = self.has(soil, "profile_levels")
            places = -get(soil, "profile_levels") if by_level else get(soil, "profile_depths")
            return np.interp(-x[1] if by_level else self.find_top(x[0]) - x[1], places, get(soil, "profile_strengths")), 0.0, math.inf
        if get(soil, "model") == "tresca":
            c = get(soil, "undrained_strength") + get(soil, "undrained_gradient") * max(0.0, get(soil, "undrained_level") - x[1])
            return c, 0.0, math.inf
        c = get(soil, "cohesion") + get(soil, "cohesion_gradient") * max(0.0, get(soil, "cohesion_level") - x[1])
        tangent = math.tan(get(soil, "friction_angle"))
        tension = get(soil, "tensile_strength")
        return c, tangent, tension if self.takes_tension and tension * tangent < c else math.inf

    def find_traction(self, x, normal, middle):
        """Traction of water and surcharges on a free side [Pa]; loads are per horizontal length."""
        t = -self.find_head(x) * normal
        if normal[1] > 1e-6:
            for places, load in self.loads:
                if places[0] < middle[0] < places[-1]:
                    t = t + np.array([0.0, -float(np.interp(x[0], places, np.atleast_1d(load))) * normal[1]])
        return t

    def find_support(self, p, q):
        """What a side from p to q holds: "full", "normal" or None."""
        for name, axis, value in (("bottom", 1, self.low[1]), ("left", 0, self.low[0]), ("right", 0, self.high[0])):
            if name in self.sides and abs(p[axis] - value) < self.near and abs(q[axis] - value) < self.near:
                return self.sides[name]
        return None


def make_lattice(n):
    """Barycentric weights of points inside a triangle: the centres of n² equal parts."""
    points = []
    for i in range(n):
        for j in range(n - i):
            points.append(((i + 1 / 3) / n, (j + 1 / 3) / n))
            if j < n - i - 1:
                points.append(((i + 2 / 3) / n, (j + 2 / 3) / n))
    points = np.array(points)
    return np.c_[1 - points.sum(axis=1), points]


def find_gradients(corners):
    """Gradients of the three shape functions [1/m], and the area."""
    (ax, ay), (bx, by), (cx, cy) = corners
    twice = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    return np.array([[by - cy, cx - bx], [cy - ay, ax - cx], [ay - by, bx - ax]]) / twice, twice / 2


def list_edges(triangles):
    edges = defaultdict(list)
    for e, t in enumerate(triangles):
        for i in range(3):
            edges[tuple(sorted((int(t[i]), int(t[(i + 1) % 3]))))].append((e, i))
    return edges


def find_normal(p, q):
    """Outward normal of a side of a counterclockwise triangle."""
    d = (q - p) / np.linalg.norm(q - p)
    return np.array([d[1], -d[0]])


def find_point_factor(c, tangent, tension, stress):
    """Largest F that an effective stress allows."""
    radius, mean = math.hypot((stress[0] - stress[1]) / 2, stress[2]), (stress[0] + stress[1]) / 2
    available, factor = c - mean * tangent, math.inf
    if radius > 0:
        ratio = available / radius
        factor = math.sqrt((ratio - tangent) * (ratio + tangent)) if ratio > tangent else 0.0
    elif available < 0:
        factor = 0.0
    if math.isfinite(tension) and radius + mean > 0:
        factor = min(factor, tension / (radius + mean))
    return factor


def find_proven_lower(section, holds, points, way):
    """The least factor at all points, the largest imbalance over the largest overburden, and the place of the factor."""
    nodes, triangles = np.array(holds["nodes"]), np.array(holds["triangles"])
    stress = np.array(holds["stress"]).reshape(-1, 3, 3)
    pressure = np.array(holds["pressure"]) if holds.get("pressure") else np.zeros((len(triangles), 3))
    total = stress.copy()
    total[:, :, :2] -= pressure[:, :, None]
    lattice = make_lattice(points)
    unit = max(get(s, "unit_weight") for s in section.soils.values()) * (section.high[1] - section.low[1])
    least = 1e-6 * unit  # of cohesion and tension: a computed field only approximates stress-free soil
    factor, place, imbalance = math.inf, None, 0.0
    for e, t in enumerate(triangles):
        corners = nodes[t]
        gradients, _ = find_gradients(corners)
        soil = section.find_soil(corners.mean(axis=0))
        inside = lattice @ corners
        weights = [section.find_weight(soil, x) for x in inside]
        force = np.array([gradients[:, 0] @ total[e][:, 0] + gradients[:, 1] @ total[e][:, 2],
                          gradients[:, 0] @ total[e][:, 2] + gradients[:, 1] @ total[e][:, 1]])
        if max(weights) == min(weights):
            lack = force + weights[0] * np.array([way * section.horizontal, -1.0])
            imbalance = max(imbalance, np.abs(lack).max() * np.ptp(corners, axis=0).max() / unit)
        linear, effective = lattice @ pressure[e], lattice @ stress[e]
        for k, x in enumerate(inside):
            c, tangent, tension = section.find_strength(soil, x)
            more = section.find_pressure(soil, x) - linear[k]
            own = find_point_factor(max(c, least), tangent, max(tension, least), effective[k] + np.array([more, more, 0]))
            if own < factor:
                factor, place = own, x
    for (a, b), owners in list_edges(triangles).items():
        e, i = owners[0]
        p, q = nodes[triangles[e][i]], nodes[triangles[e][(i + 1) % 3]]
        normal = find_normal(p, q)
        for node in (a, b):
            traction = [np.array([s[0] * normal[0] + s[2] * normal[1], s[2] * normal[0] + s[1] * normal[1]])
                        for s in (total[f][list(triangles[f]).index(node)] for f, _ in owners)]
            if len(owners) == 2:
                imbalance = max(imbalance, np.abs(traction[0] - traction[1]).max() / unit)
                continue
            held = section.find_support(p, q)
            if held == "full":
                continue
            lack = traction[0] - section.find_traction(nodes[node], normal, (p + q) / 2)
            if held == "normal":
                lack = lack - (lack @ normal) * normal
            imbalance = max(imbalance, np.abs(lack).max() / unit)
    return factor, imbalance, place


def find_dissipation(c, tangent, tension, opening, shear):
    """Dissipation per volume of a strain rate [W/m³], and what the flow rule lacks [1/s]; arrays. Strengths are reduced."""
    sine = tangent / np.sqrt(1 + tangent**2)
    lack = np.maximum(sine * shear - opening, 0)
    has_friction = tangent > 1e-12
    cone = np.where(has_friction, c / np.where(has_friction, tangent, 1) * opening, c * shear)
    lack = np.where(has_friction, lack, np.abs(opening))
    # With a tension cut-off the corner between both lines bears, or the tip.
    finite = np.isfinite(tension)
    cut = np.where(finite, tension, 0)
    mean = (cut - c * np.sqrt(1 - sine**2)) / (1 - sine)
    corner = np.where(opening >= shear, cut * opening, mean * opening + (cut - mean) * shear)
    lack = np.where(finite & ~has_friction, np.maximum(-opening, 0), lack)
    return np.where(finite, corner, cone), lack


def find_proven_upper(section, moves, points, way, printed):
    """At the printed factor: work over dissipation, and the mean lack of the flow rule over the mean shear rate; the largest motion of a
    fixed side. At a smaller factor the mechanism violates the flow rule, so that none is sought."""
    nodes, triangles, velocity = np.array(moves["nodes"]), np.array(moves["triangles"]), np.array(moves["velocity"])
    lattice = make_lattice(points)
    work, parts = 0.0, []
    shapes = np.c_[lattice * (2 * lattice - 1), 4 * lattice[:, 0] * lattice[:, 1], 4 * lattice[:, 1] * lattice[:, 2],
                   4 * lattice[:, 2] * lattice[:, 0]]
    for t in triangles:
        corners = nodes[t[:3]]
        gradients, area = find_gradients(corners)
        soil = section.find_soil(corners.mean(axis=0))
        for k, x in enumerate(lattice @ corners):
            w = lattice[k]
            slope = np.array([(4 * w[i] - 1) * gradients[i] for i in range(3)] +
                             [4 * (w[(i + 1) % 3] * gradients[i] + w[i] * gradients[(i + 1) % 3]) for i in range(3)])
            rate = velocity[t].T @ slope
            opening, shear = rate[0, 0] + rate[1, 1], math.hypot(rate[0, 0] - rate[1, 1], rate[0, 1] + rate[1, 0])
            v, part = shapes[k] @ velocity[t], area / len(lattice)
            weight = section.find_weight(soil, x)
            work += part * (weight * (way * section.horizontal * v[0] - v[1]) + section.find_pressure(soil, x) * opening)
            parts.append((part, *section.find_strength(soil, x), opening, shear))
    moved = 0.0
    for owners in list_edges(triangles).values():
        if len(owners) > 1:
            continue
        e, i = owners[0]
        a, b, middle = triangles[e][i], triangles[e][(i + 1) % 3], triangles[e][3 + i]
        p, q = nodes[a], nodes[b]
        normal, held = find_normal(p, q), section.find_support(p, q)
        for node in (a, b, middle):
            moved = max(moved, {"full": np.abs(velocity[node]).max(), "normal": abs(velocity[node] @ normal)}.get(held, 0.0))
        if held == "full":
            continue
        for s, part in ((0.5 - math.sqrt(0.15), 5 / 18), (0.5, 8 / 18), (0.5 + math.sqrt(0.15), 5 / 18)):
            v = np.array([(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)]) @ velocity[[a, b, middle]]
            traction = section.find_traction(p + s * (q - p), normal, (p + q) / 2)
            if held == "normal":
                traction = traction - (traction @ normal) * normal
            work += part * np.linalg.norm(q - p) * (traction @ v)
    part, c, tangent, tension, opening, shear = np.array(parts).T

    dissipation, lack = find_dissipation(c / printed, tangent / printed, tension / printed, opening, shear)
    return work / (part * dissipation).sum(), (part * lack).sum() / (part * shear).sum(), moved


def verify(folder, points, tolerance):
    """Prints the row of a folder; returns the exit status."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    fields = json.loads((folder / "bounds.json").read_text(encoding="utf-8"))
    bounds = fields["summary"]
    try:
        section = Section(summary["input"])
        ways = {"right": [1], "left": [-1], "both": [1, -1]}.get(section.direction, [1]) if section.horizontal else [0]
        if (bounds.get("earthquake") or {}).get("direction"):
            ways = [bounds["earthquake"]["direction"]]
        status, text = 0, []
        if bounds.get("lower"):
            factor, imbalance, place = min((find_proven_lower(section, fields["holds"], points, w) for w in ways), key=lambda r: r[1])
            proven = factor >= bounds["lower"] * (1 - tolerance) and imbalance <= EQUILIBRIUM
            status = status or int(not proven)
            text.append(f"lower {bounds['lower']:.4f}, here {factor:.4f} (at {place[0]:.2f}, {place[1]:.2f} m; imbalance {imbalance:.1e})"
                        + ("" if proven else " NOT PROVEN"))
        if bounds.get("upper"):
            ratio, lack, moved = max((find_proven_upper(section, fields["moves"], points, w, bounds["upper"]) for w in ways), key=lambda r: r[0])
            proven = ratio >= 1 - tolerance and lack < FLOW and moved < 1e-6
            status = status or int(not proven)
            text.append(f"upper {bounds['upper']:.4f}: work over dissipation {ratio:.4f} (flow rule {lack:.1e}, fixed sides {moved:.1e})"
                        + ("" if proven else " NOT PROVEN"))
    except NotEvaluated as what:
        print(f"SKIP: {folder}: not evaluated here: {what}")
        return 2
    print(f"{folder}: " + ("; ".join(text) or "no bound"))
    return status


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=7)
    parser.add_argument("--tolerance", type=float, default=5e-4)
    args = parser.parse_args()
    found = [verify(folder, args.points, args.tolerance) for folder in args.folders]
    sys.exit(1 if 1 in found else 2 if 2 in found else 0)


if __name__ == "__main__":
    main()
