#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Collapse of clay whose strength grows with depth: strip footings by the method of characteristics, vertical cuts by circles.

Usage: tools/clay_collapse.py [--parts N] [r …]

s_u = c₀ + ρ z below the ground. For each ratio r the tool prints, in units of c₀,
- the mean pressure q of a smooth and of a rough strip of width B with r = ρB/c₀, and Davis and Booker's (1973) factor F of each,
  q = F ((2 + π) c₀ + ρB/4), by N characteristics;
- γH of a vertical cut of height H with r = ρH/c₀: 2 (1 + r) is a lower bound (σ_v = γz, σ_h = 0), the least circle through the toe an upper one.

In plane strain without weight, which adds nothing to q, with the mean stress p (compression) and the angle ψ of the major principal stress
from the vertical towards the free ground, dp + 2 c dψ + ρ dx = 0 along dx/dz = tan(ψ + π/4), and dp − 2 c dψ − ρ dx = 0 along
dx/dz = tan(ψ − π/4). The characteristics start at the free ground (ψ = π/2, p = c₀), turn about the edge of the strip at (0, 0), and end on a
smooth base (ψ = 0), on a rough one along which soil slips (ψ = −π/4), or on the last characteristic of the wedge below it, which meets the axis
of symmetry where ψ = 0.
"""
import argparse
import math

COHESION, GRADIENT = 1.0, 1.0  # c₀ and ρ: one strip differs from another by its width alone


def strength(z):
    return COHESION + GRADIENT * z


def mix(a, b, s):
    return tuple(u + s * (v - u) for u, v in zip(a, b))


def press(base):
    """The vertical force on points of the base, from right to left."""
    return sum(0.5 * (a[2] + b[2] + COHESION * (math.cos(2 * a[3]) + math.cos(2 * b[3]))) * (a[0] - b[0]) for a, b in zip(base[:-1], base[1:]))


def cross(a, b):
    """The point where the first kind of characteristic from `a` meets the second one from `b`; points are (x, z, p, ψ)."""
    x, z, p, psi = mix(a, b, 0.5)
    for _ in range(60):
        before = p, psi, x, z
        one, two = 0.5 * (a[3] + psi) + math.pi / 4, 0.5 * (b[3] + psi) - math.pi / 4
        s, c, u, v = math.sin(one), math.cos(one), math.sin(two), math.cos(two)
        # c (x − xa) = s (z − za), v (x − xb) = u (z − zb)
        right, other, det = c * a[0] - s * a[1], v * b[0] - u * b[1], s * v - c * u
        x, z = (s * other - u * right) / det, (c * other - v * right) / det
        ca, cb = strength(0.5 * (a[1] + z)), strength(0.5 * (b[1] + z))
        # p + 2 ca ψ = first, p − 2 cb ψ = second
        first = a[2] + 2 * ca * a[3] - GRADIENT * (x - a[0])
        second = b[2] - 2 * cb * b[3] + GRADIENT * (x - b[0])
        psi = (first - second) / (2 * (ca + cb))
        p = first - 2 * ca * psi
        if max(abs(u - v) for u, v in zip(before, (p, psi, x, z))) < 1e-12:
            break
    return (x, z, p, psi)


def end_on_base(a, psi):
    """The point of the base that the first kind of characteristic from `a` meets, where ψ is given."""
    along = 0.5 * (a[3] + psi) + math.pi / 4
    x = a[0] - a[1] * math.tan(along)
    c = strength(0.5 * a[1])
    return (x, 0.0, a[2] - 2 * c * (psi - a[3]) - GRADIENT * (x - a[0]), psi)


def start_fan(last, parts):
    """Points of the edge, where the stress turns from that of the free ground to ψ = last."""
    turns = [math.pi / 2 + (last - math.pi / 2) * i / parts for i in range(parts + 1)]
    return [(0.0, 0.0, COHESION * (1 + math.pi - 2 * psi), psi) for psi in turns]


def march(front, x):
    """The next characteristic of the first kind, from the free ground at x over the second kind through the points of `front`."""
    line = [(x, 0.0, COHESION, math.pi / 2)]
    for point in front:
        line.append(cross(line[-1], point))
    return line


def smooth(width, parts):
    """Mean pressure under a smooth strip, of which one half flows to each side."""
    step = 0.5 * width / parts
    front, base = start_fan(0, parts), [(0.0, 0.0, COHESION * (1 + math.pi), 0.0)]
    k = 0
    while base[-1][0] > -0.5 * width:
        k += 1
        line = march(front, k * step)
        base.append(end_on_base(line[-1], 0))
        front = line + [base[-1]]
    a, b = base[-2:]
    base[-1] = mix(a, b, (a[0] + 0.5 * width) / (a[0] - b[0]))
    return press(base) / (0.5 * width)


def force_on(line):
    """Vertical force on the soil above a characteristic of the second kind, from left to right."""
    total = 0
    for a, b in zip(line[:-1], line[1:]):
        x, z, p, psi = mix(a, b, 0.5)
        c = strength(z)
        vertical, shear = p + c * math.cos(2 * psi), c * math.sin(2 * psi)
        total += abs(vertical * (b[0] - a[0]) - shear * (b[1] - a[1]))
    return total


def rough_from(last, slipping, step, parts):
    """Half the width and the force on it, where the wedge begins at the edge with ψ = last, or after `slipping` characteristics that end on
    the base with ψ = −π/4."""
    front, wedge, base = start_fan(last, parts), [], []
    base.append(front[-1])
    k = 0
    while True:
        k += 1
        line = march(front, k * step)
        if k <= slipping:
            base.append(end_on_base(line[-1], -math.pi / 4))
            line.append(base[-1])
        wedge.append(line[-1])
        front = line
        if wedge[-1][3] >= 0:
            break
        if -wedge[-1][0] > 2 * parts * step:  # wider than the strip
            break
    wedge = ([base[-1]] + wedge[slipping:]) if slipping else [base[-1]] + wedge
    a, b = wedge[-2:]
    s = -a[3] / (b[3] - a[3]) if b[3] > a[3] else 1
    wedge[-1] = mix(a, b, s)
    return -wedge[-1][0], press(base) + force_on(wedge)


def rough(width, parts):
    """Mean pressure under a rough strip: bisects for the beginning of the wedge that gives half the width."""
    step, half = 0.5 * width / parts, 0.5 * width
    low, high = -math.pi / 4, 0.0
    if rough_from(low, 0, step, parts)[0] > half:
        low_value = None
        for _ in range(40):
            middle = 0.5 * (low + high)
            low_value = rough_from(middle, 0, step, parts)
            low, high = (middle, high) if low_value[0] > half else (low, middle)
        return low_value[1] / low_value[0]
    results = [rough_from(low, 0, step, parts)]
    while results[-1][0] < half:
        results.append(rough_from(low, len(results), step, parts))
    (x0, f0), (x1, f1) = results[-2:]
    s = (half - x0) / (x1 - x0)
    return (f0 + s * (f1 - f0)) / half


def rate_circle(x, y, ratio, parts=400):
    """γH/c₀ at which the soil above a circle through the toe (0, 0) of a cut of height 1 turns about (x, y)."""
    square, weight, resistance = x * x + y * y, 0.0, 0.0
    for i in range(parts):
        level = (i + 0.5) / parts
        run = math.sqrt(square - (level - y) ** 2)  # from the centre to the circle
        weight += (0.5 * (run + x) ** 2 - x * (run + x)) / parts
        resistance += (1 + ratio * (1 - level)) * square / run / parts
    return resistance / weight


def cut(ratio):
    """The least γH/c₀ of circles, by a search with a shrinking step."""
    x, y, step = -0.5, 2.0, 0.5
    least = rate_circle(x, y, ratio)
    while step > 1e-5:
        trials = [(rate_circle(x + dx, y + dy, ratio), x + dx, y + dy) for dx in (-step, 0, step) for dy in (-step, 0, step) if y + dy > 1 and x + dx < 0]
        best = min(trials)
        if best[0] < least - 1e-12:
            least, x, y = best
        else:
            step *= 0.5
        if math.hypot(x, y) > 1e3:  # a plane
            break
    return least


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ratios", nargs="*", type=float, default=[1, 4, 20], metavar="r")
    parser.add_argument("--parts", type=int, default=80)
    options = parser.parse_args()
    print("     r   smooth q      F    rough q      F    cut: above  below")
    for ratio in options.ratios:
        unit = 2 + math.pi + ratio / 4
        values = smooth(ratio, options.parts), rough(ratio, options.parts)
        print(f"{ratio:6g} " + " ".join(f"{q:10.4f} {q / unit:6.4f}" for q in values) + f" {2 * (1 + ratio):12.4f} {cut(ratio):7.4f}")


if __name__ == "__main__":
    main()
