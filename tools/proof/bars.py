# SPDX-License-Identifier: MIT
"""Nails, anchors and geosynthetics: the tension that a stress field gives them, and what a mechanism has to extend.

A bar bears at a distance s from its head at most the least of its tensile strength, of head and bond in front, and of the bond behind (T18.16).
"""
import math

import numpy as np

from .case import NotEvaluated, get, has

SAMPLES = 2000  # of the bond along a bar
HALF_HEAD = 0.5  # half the width of the ground on which a head presses [m]


def find_face(section, level, start):
    """Point of the ground at a level that is nearest to a point."""
    best, distance = None, math.inf
    for _, ring in section.polygons.rings:
        for p, q in zip(ring, np.roll(ring, -1, axis=0)):
            if min(p[1], q[1]) <= level <= max(p[1], q[1]) and p[1] != q[1]:
                x = p + (level - p[1]) / (q[1] - p[1]) * (q - p)
                off = (q - p) / np.hypot(*(q - p)) * section.near * 10
                sides = section.polygons.find_soils(np.array([x + [-off[1], off[0]], x - [-off[1], off[0]]]))
                if (sides >= 0).sum() == 1 and np.hypot(*(x - start)) < distance:
                    best, distance = x, np.hypot(*(x - start))
    if best is None:
        raise NotEvaluated("rows of supports beside the face")
    return best


class Bar:
    def __init__(self, section, support, head, end):
        kind, spacing = get(support, "kind"), get(support, "out_of_plane_spacing") or 1.0
        self.head, self.end = np.array(head, float), np.array(end, float)
        self.length = np.hypot(*(self.end - self.head))
        self.along = (self.end - self.head) / self.length
        sense = get(support, "sense") or "usual"
        self.is_active = sense == "active" or (sense == "usual" and kind == "anchor")
        s = np.linspace(0, self.length, SAMPLES + 1)
        if kind == "geosynthetic":
            coverage = get(support, "coverage") or 1.0
            around = (1 if get(support, "sides") == "one" else 2) * coverage
            tensile, plate = get(support, "strength") * coverage, get(support, "connection") * coverage
        else:
            around = math.pi * (get(support, "diameter") or 0) / spacing
            tensile, plate = get(support, "tensile_strength") / spacing, get(support, "plate") / spacing
        if get(support, "bond") is not None:
            bond = np.full(len(s), get(support, "bond") / spacing)
        else:
            bond = around * np.full(len(s), get(support, "bond_adhesion") or 0.0)
            if get(support, "bond_friction"):
                inside = self.head + np.clip(s, 1e-6, self.length - 1e-6)[:, None] * self.along
                effective = np.maximum(0, self.find_effective(section, inside))
                bond = bond + around * (get(support, "bond_scale") or 1.0) * effective * math.tan(get(support, "bond_friction"))
        free = get(support, "free_length")
        if free is None:
            bonded = get(support, "bond_length")
            free = self.length - bonded if bonded is not None else 0.0
        self.s = s
        steps = np.where(s[:-1] + s[1:] >= 2 * free, (bond[:-1] + bond[1:]) / 2 * np.diff(s), 0)
        front = np.concatenate([[0], np.cumsum(steps)])
        self.capacity = np.maximum(0, np.minimum(np.minimum(tensile, plate + front), front[-1] - front))

    @staticmethod
    def find_effective(section, x):
        tops = np.c_[x[:, 0], section.polygons.find_tops(x[:, 0])]
        vertical = section.find_overburden(x) + section.water.find_standing(tops)
        soils = section.polygons.find_soils(x)
        for soil in np.unique(soils[soils >= 0]):
            some = soils == soil
            pressure = section.find_pressures(soil, x[some])
            if pressure is None:
                raise NotEvaluated("bond in seepage")
            vertical[some] -= np.maximum(pressure, 0)
        return vertical

    def find_capacity(self, s):
        return np.interp(s, self.s, self.capacity)

    def measure(self, x):
        """Distance of points along the bar from its head, and off it."""
        d = x - self.head
        return d @ self.along, np.abs(d[..., 0] * self.along[1] - d[..., 1] * self.along[0])

    def list_edges(self, mesh, near):
        """Edges of a mesh on the bar: (nodes from head to end, distances), by distance; all of its length has to be covered."""
        s, off = self.measure(mesh.nodes)
        on = (off < near) & (s > -near) & (s < self.length + near)
        found = []
        for (a, b) in mesh.edges:
            if on[a] and on[b]:
                found.append(((a, b), s[a], s[b]) if s[a] < s[b] else ((b, a), s[b], s[a]))
        found.sort(key=lambda e: e[1])
        if abs(sum(e[2] - e[1] for e in found) - self.length) > 1e-3 * self.length:
            raise NotEvaluated("a bar that is no line of the mesh")
        return found


class Bars:
    def __init__(self, section, case):
        self.section, self.bars = section, []
        self.near = 2e-5 * (section.high - section.low).max()
        for support in case["support"].values():
            if get(support, "kind") not in ("nail", "anchor", "geosynthetic"):
                raise NotEvaluated(f"support of kind {get(support, 'kind')}")
            self.read(section, support)

    def read(self, section, support):
        if has(support, "heads"):
            heads = get(support, "heads")
        else:
            first, rows = np.array(get(support, "first"), float), int(get(support, "rows"))
            if rows > 1 and get(support, "spacing_along") == "face":
                raise NotEvaluated("rows along the face")
            heads = [first] + [find_face(section, first[1] - k * get(support, "row_spacing"), first) for k in range(1, rows)]
        if has(support, "ends"):
            ends = get(support, "ends")
        else:
            dip = get(support, "inclination") or 0.0
            lengths = get(support, "lengths") if has(support, "lengths") else np.full(len(heads), get(support, "length"))
            ends = []
            for head, length in zip(heads, lengths):
                ways = [np.array([side * math.cos(dip), -math.sin(dip)]) for side in (-1, 1)]
                inside = section.polygons.find_soils(np.array([head + 0.3 * w for w in ways])) >= 0
                if inside.sum() != 1:
                    raise NotEvaluated("a bar whose direction is not evident")
                ends.append(head + length * ways[int(np.argmax(inside))])
        self.bars += [Bar(section, support, h, e) for h, e in zip(heads, ends)]

    def check_lower(self, mesh, jumps, lacks):
        """The least factor of passive bars (0 where an active one bears more than it can), and the largest traction that no bar explains
        [Pa]. Takes what bars explain out of `jumps` and `lacks`."""
        factor, worst = math.inf, 0.0
        heads = []
        for bar in self.bars:
            edges = bar.list_edges(mesh, self.near)
            pull = []  # ∫ of the traction along each edge, in the direction of the bar
            for (a, b), low, high in edges:
                pair = jumps[tuple(sorted((a, b)))]
                across = max(abs(v @ [-bar.along[1], bar.along[0]]) for v in pair)
                worst = max(worst, across)
                # The traction of the bar on the soil is the difference of what both sides of the edge bear.
                mean = (pair[0] + pair[1]) @ bar.along / 2
                pull.append((mean * (high - low), low, high))
                jumps[tuple(sorted((a, b)))] = [np.zeros(2)]
            tension = 0.0
            tensions = [(bar.length, 0.0)]
            for part, low, high in reversed(pull):
                tension -= part
                tensions.append((low, tension))
            heads.append((bar, tension))
            for s, n in tensions:
                if n < -1e-4 * max(bar.capacity.max(), 1):
                    factor = 0.0
                room = bar.find_capacity(s)
                if bar.is_active:
                    factor = factor if n <= room * (1 + 1e-3) + 1e-4 * bar.capacity.max() else 0.0
                elif n > 1e-4 * bar.capacity.max():
                    factor = min(factor, room / n)
        self.take_heads(heads, lacks)
        return factor, worst

    def take_heads(self, heads, lacks):
        """The tractions of heads on the ground within half a metre."""
        for bar, tension in heads:
            if tension <= 0:
                continue
            near = [key for key, (lack, p, q, held) in lacks.items()
                    if held is None and np.hypot(*((p + q) / 2 - bar.head)) < HALF_HEAD + 1e-3]
            length = sum(np.hypot(*(lacks[key][2] - lacks[key][1])) for key in near)
            for key in near:
                lack, p, q, held = lacks[key]
                # The lack is the traction of the field less that of the case: the head adds its own.
                lacks[key] = ([v - tension / length * bar.along for v in lack], p, q, held)

    def find_dissipation(self, mesh, velocity, printed):
        """Power that bars take up [W/m]: their capacity on their extension, at the head too."""
        total = 0.0
        for bar in self.bars:
            divisor = 1.0 if bar.is_active else printed
            for (a, b), low, high in bar.list_edges(mesh, self.near):
                e, i = mesh.edges[tuple(sorted((a, b)))][0]
                middle = mesh.triangles[e, 3 + i]
                va, vm, vb = (velocity[n] @ bar.along for n in (a, middle, b))
                t = (np.arange(40) + 0.5) / 40
                rate = (va * (4 * t - 3) + vm * (4 - 8 * t) + vb * (4 * t - 1)) / (high - low)
                room = bar.find_capacity(low + t * (high - low))
                total += (room * np.maximum(rate, 0)).mean() * (high - low) / divisor
            total += self.find_head_power(bar, mesh, velocity) / divisor
        return total

    def find_head_power(self, bar, mesh, velocity):
        force = bar.find_capacity(0.0)
        if not force > 0:
            return 0.0
        first = int(np.argmin(np.hypot(*(mesh.nodes - bar.head).T)))
        total = length = 0.0
        for owners in mesh.edges.values():
            if len(owners) != 1:
                continue
            e, i = owners[0]
            nodes = mesh.triangles[e, [i, (i + 1) % 3, 3 + i]]
            p, q = mesh.nodes[nodes[0]], mesh.nodes[nodes[1]]
            if np.hypot(*((p + q) / 2 - bar.head)) < HALF_HEAD + 1e-3:
                size = np.hypot(*(q - p))
                total += size * (velocity[nodes] * np.array([[1], [1], [4]])).sum(axis=0) @ bar.along / 6
                length += size
        if not length:
            raise NotEvaluated("a head beside the ground")
        return force * max(0.0, velocity[first] @ bar.along - total / length)
