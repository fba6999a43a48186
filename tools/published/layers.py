# SPDX-License-Identifier: MIT
"""Soil polygons from lines that each say where a soil begins: exact pieces of straight lines, no rasters."""
from __future__ import annotations

TINY = 1e-9  # of the width of the section


def extend_line(line, left, right):
    """The polyline with its ends carried on horizontally to x = left and right."""
    line = [tuple(p) for p in line]
    if line[0][0] > line[-1][0]:
        line.reverse()
    if line[0][0] > left:
        line.insert(0, (left, line[0][1]))
    if line[-1][0] < right:
        line.append((right, line[-1][1]))
    return line


def find_breaks(lines, left, right):
    """Every x where a line bends or two of them cross, from left to right."""
    tiny = TINY * (right - left)
    places = {left, right}
    segments = []
    for line in lines:
        places.update(x for x, _ in line)
        segments.append([(a, b) for a, b in zip(line, line[1:]) if b[0] - a[0] > tiny])
    for i, first in enumerate(segments):
        for second in segments[:i]:
            for (ax, ay), (bx, by) in first:
                for (cx, cy), (dx, dy) in second:
                    lo, hi = max(ax, cx), min(bx, dx)
                    if hi - lo <= tiny:
                        continue
                    slope = (by - ay) / (bx - ax) - (dy - cy) / (dx - cx)
                    if slope == 0:
                        continue
                    gap = (ay - (by - ay) / (bx - ax) * ax) - (cy - (dy - cy) / (dx - cx) * cx)
                    x = -gap / slope
                    if lo + tiny < x < hi - tiny:
                        places.add(x)
    found = []
    for x in sorted(p for p in places if left <= p <= right):
        if not found or x - found[-1] > tiny:
            found.append(x)
    return found


def find_height(line, x, other):
    """Elevation of the polyline at x, as seen from the side where x = other lies: vertical steps have two."""
    middle = 0.5 * (x + other)
    for (ax, ay), (bx, by) in zip(line, line[1:]):
        if ax <= middle <= bx and bx > ax:
            return ay + (by - ay) * (x - ax) / (bx - ax)
    raise ValueError(f"the line {line[0]} … {line[-1]} does not reach x = {x}")


def split_layers(ground, base, layer_lines):
    """[(material, ring)] of what lies below each line and above the next; the first line is the ground itself, and no
    line rises above the one before it."""
    left, right = ground[0][0], ground[-1][0]
    tops = [list(ground)]
    materials = []
    for number, (material, line) in enumerate(layer_lines):
        materials.append(material)
        if number > 0:
            tops.append(extend_line(line, left, right))
    tops.append([(left, base), (right, base)])
    breaks = find_breaks(tops, left, right)
    strips = []  # per strip: heights of all tops at its two ends
    for a, b in zip(breaks, breaks[1:]):
        heights = []
        for line in tops:
            pair = (find_height(line, a, b), find_height(line, b, a))
            if heights:
                pair = (min(pair[0], heights[-1][0]), min(pair[1], heights[-1][1]))
            heights.append((max(pair[0], base), max(pair[1], base)))
        strips.append((a, b, heights))
    tiny = TINY * (right - left)
    rings = []
    for layer, material in enumerate(materials):
        piece = []
        for a, b, heights in strips + [(right, right, None)]:
            thick = heights is not None and max(heights[layer][i] - heights[layer + 1][i] for i in (0, 1)) > tiny
            if thick:
                pinched = piece and max(piece[-1][2][layer][1] - piece[-1][2][layer + 1][1],
                                        heights[layer][0] - heights[layer + 1][0]) <= tiny
                if pinched:
                    rings.append((material, make_ring(piece, layer)))
                    piece = []
                piece.append((a, b, heights))
            elif piece:
                rings.append((material, make_ring(piece, layer)))
                piece = []
    return share_corners([(material, drop_straight(ring, tiny)) for material, ring in rings], tiny)


def make_ring(piece, layer):
    """Counter-clockwise: along the bottom from left to right, back along the top."""
    bottom, top = [], []
    for a, b, heights in piece:
        bottom += [(a, heights[layer + 1][0]), (b, heights[layer + 1][1])]
        top += [(a, heights[layer][0]), (b, heights[layer][1])]
    return bottom + top[::-1]


def drop_straight(ring, tiny):
    """The ring without repeated corners and without those on a straight side."""
    ring = [p for i, p in enumerate(ring) if abs(p[0] - ring[i - 1][0]) > tiny or abs(p[1] - ring[i - 1][1]) > tiny]
    kept = []
    for i, p in enumerate(ring):
        a, b = ring[i - 1], ring[(i + 1) % len(ring)]
        area = (p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])
        if abs(area) > tiny * max(abs(b[0] - a[0]) + abs(b[1] - a[1]), tiny):
            kept.append(p)
    return kept


def share_corners(rings, tiny):
    """The rings with the corners of their neighbours on their sides, so that the sides of neighbours coincide in a mesh."""
    corners = sorted({p for _, ring in rings for p in ring})
    shared = []
    for material, ring in rings:
        whole = []
        for i, a in enumerate(ring):
            b = ring[(i + 1) % len(ring)]
            length = ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5
            inside = []
            for p in corners:
                along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length
                off = ((p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])) / length
                if abs(off) <= 10 * tiny and 10 * tiny < along < length - 10 * tiny:
                    inside.append((along, p))
            whole += [a] + [p for _, p in sorted(inside)]
        shared.append((material, whole))
    return shared
