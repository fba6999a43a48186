# SPDX-License-Identifier: MIT
"""Strength laws: the factor that a stress allows, and the dissipation and flow rule of a strain rate.

Every isotropic law is a set of lines R ≤ c cos φ − σ_m sin φ with R the radius and σ_m the mean of a circle of stress (tension positive); a
curved envelope is that of its tangents, as a circle below all of them is below it. The support function of the set is the dissipation.
"""
import math

import numpy as np

from .case import NotEvaluated, get

TANGENTS = 500  # of a curved envelope; they lie outside it by less than 1e-4 of the strength
CHUNK = 20000  # points evaluated at once


def find_line_factor(c, tangent, radius, mean):
    """Largest F with R √(1 + tan²φ/F²) ≤ (c − σ_m tan φ)/F; infinity without shear, 0 if none is small enough."""
    available = c - mean * tangent
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = available / radius
        factor = np.where(ratio > tangent, np.sqrt(np.maximum((ratio - tangent) * (ratio + tangent), 0)), 0.0)
    return np.where(radius > 0, factor, np.where(available < 0, 0.0, np.inf))


class Rigid:
    """Material without a strength limit: any stress, no strain."""

    planes = None

    def find_factor(self, x, radius, mean, least):
        return np.full(len(x), np.inf)

    def dissipate(self, x, opening, shear, factor):
        return np.zeros(len(x)), np.abs(opening) + shear


class Straight:
    """|τ| ≤ c − σ' tan φ and a tensile strength; c is a function of places."""

    def __init__(self, find_cohesion, tangent, tension, is_reduced):
        self.find_cohesion, self.tangent, self.tension, self.is_reduced = find_cohesion, tangent, tension, is_reduced

    def find_values(self, x):
        c = self.find_cohesion(x)
        return c, np.where(self.tension * self.tangent < c, self.tension, np.inf)

    def find_factor(self, x, radius, mean, least):
        c, tension = self.find_values(x)
        factor = find_line_factor(np.maximum(c, least), self.tangent, radius, mean)
        with np.errstate(divide="ignore", invalid="ignore"):
            factor = np.where(radius + mean > 0, np.minimum(factor, np.maximum(tension, least) / (radius + mean)), factor)
        return factor if self.is_reduced else np.where(factor >= 1, np.inf, 0.0)

    def dissipate(self, x, opening, shear, factor):
        c, tension = self.find_values(x)
        factor = factor if self.is_reduced else 1.0
        c, tangent, tension = c / factor, self.tangent / factor, tension / factor
        sine = tangent / math.sqrt(1 + tangent**2)
        if tangent > 1e-12:
            whole, lack = c / tangent * opening, np.maximum(sine * shear - opening, 0)
        else:
            whole, lack = c * shear, np.abs(opening)
        finite = np.isfinite(tension)
        if not finite.any():
            return whole, lack
        # With a tension cut-off the corner between both lines bears, or the tip.
        cut = np.where(finite, tension, 0)
        mean = (cut - c * math.sqrt(1 - sine**2)) / (1 - sine)
        corner = np.where(opening >= shear, cut * opening, mean * opening + (cut - mean) * shear)
        return np.where(finite, corner, whole), np.where(finite, np.maximum(sine * shear - opening, 0), lack)


class Curved:
    """Tangents of a concave envelope, by falling tan φ, and a tensile strength."""

    def __init__(self, cohesions, tangents, tension, is_reduced):
        self.c, self.t, self.tension, self.is_reduced = np.array(cohesions), np.array(tangents), tension, is_reduced

    def find_factor(self, x, radius, mean, least):
        factor = np.full(len(x), np.inf)
        for begin in range(0, len(x), CHUNK):
            part = slice(begin, begin + CHUNK)
            factor[part] = find_line_factor(np.maximum(self.c[0], least) + (self.c - self.c[0]), self.t, radius[part, None], mean[part, None]).min(axis=1)
        if math.isfinite(self.tension):
            with np.errstate(divide="ignore", invalid="ignore"):
                factor = np.where(radius + mean > 0, np.minimum(factor, max(self.tension, least) / (radius + mean)), factor)
        return factor if self.is_reduced else np.where(factor >= 1, np.inf, 0.0)

    def list_corners(self, factor):
        """Corners (σ_m, R) of the set, from the apex into compression, and sin φ of the last line."""
        t = self.t / factor
        sines = t / np.sqrt(1 + t**2)
        lines = list(zip(self.c / factor * np.sqrt(1 - sines**2), sines))
        if math.isfinite(self.tension):
            lines = [(self.tension / factor, 1.0)] + lines
        # Lines R = k − σ_m s by falling s: those that lie above the others everywhere are left out.
        kept, corners = [], []
        for k, s in lines:
            if kept and abs(s - kept[-1][1]) < 1e-12:
                if k >= kept[-1][0]:
                    continue
                kept.pop()
                if corners:
                    corners.pop()
            while kept:
                mean = (kept[-1][0] - k) / (kept[-1][1] - s)
                if not corners or mean < corners[-1][0]:
                    break
                kept.pop()
                corners.pop()
            if kept:
                corners.append((mean, k - mean * s))
            kept.append((k, s))
        apex = kept[0][0] / kept[0][1]
        while corners and corners[0][1] < 0:  # a corner beyond the apex
            corners.pop(0)
            kept.pop(0)
            apex = kept[0][0] / kept[0][1]
        return np.array([(apex, 0.0)] + corners), kept[-1][1]

    def dissipate(self, x, opening, shear, factor):
        corners, sine = self.list_corners(factor if self.is_reduced else 1.0)
        whole = np.empty(len(x))
        for begin in range(0, len(x), CHUNK):
            part = slice(begin, begin + CHUNK)
            whole[part] = (corners[:, 0] * opening[part, None] + corners[:, 1] * shear[part, None]).max(axis=1)
        return whole, np.maximum(sine * shear - opening, 0)


def make_envelope(stresses, strengths, slopes):
    """Tangents at points of an envelope."""
    return [s - n * t for n, s, t in zip(stresses, strengths, slopes)], slopes


def make_power(soil, largest):
    a, b = get(soil, "power_factor"), get(soil, "power_exponent")
    shift, constant = get(soil, "power_shift") or 0.0, get(soil, "power_cohesion") or 0.0
    # The secant replaces the curve below σ' + d = 0.1 kPa, where its slope would become infinite.
    at = np.concatenate([[0.1], np.geomspace(0.1, (largest + shift) / 1e3, TANGENTS)])
    tau, slope = 1e3 * a * at**b + constant, a * b * at ** (b - 1)
    slope[0] = a * 0.1 ** (b - 1)
    return make_envelope(1e3 * at - shift, tau, slope)


def make_rock(soil, largest):
    """Hoek–Brown 2002 as an envelope: Balmer's formulae by the minor principal stress; returns it and the tensile strength."""
    sci, gsi, mi, d = get(soil, "intact_strength"), get(soil, "gsi"), get(soil, "intact_constant"), get(soil, "disturbance") or 0.0
    if get(soil, "model") == "softening_hoek_brown" and get(soil, "limit_strength") == "residual":
        raise NotEvaluated("a residual GSI")
    m, s = mi * math.exp((gsi - 100) / (28 - 14 * d)), math.exp((gsi - 100) / (9 - 3 * d))
    a = 0.5 + (math.exp(-gsi / 15) - math.exp(-20 / 3)) / 6
    tension = s * sci / m
    root = np.geomspace(1e-6 * s, m * largest / sci + s, 2 * TANGENTS)  # m σ3/σ_ci + s
    minor = (root - s) * sci / m
    major, k = minor + sci * root**a, 1 + a * m * root ** (a - 1)
    normal, tau = minor + (major - minor) / (1 + k), (major - minor) * np.sqrt(k) / (1 + k)
    return make_envelope(normal, tau, (k - 1) / (2 * np.sqrt(k))), tension


def make_table(soil):
    x, y = get(soil, "normal_stresses"), get(soil, "shear_strengths")
    slopes = np.diff(y) / np.diff(x)
    return make_envelope(x[:-1], y[:-1], slopes)


class Bedded:
    """Soil with planes of one direction; |τ| ≤ (c_b − σ_n tan φ_b)/F on them."""

    def __init__(self, body, angle, cohesion, tangent):
        self.body, self.angle, self.c, self.t = body, angle, cohesion, tangent

    def find_plane_factor(self, stress, least):
        mean, half = (stress[:, 0] + stress[:, 1]) / 2, (stress[:, 0] - stress[:, 1]) / 2
        c2, s2 = math.cos(2 * self.angle), math.sin(2 * self.angle)
        normal, shear = mean - half * c2 - stress[:, 2] * s2, np.abs(stress[:, 2] * c2 - half * s2)
        available = max(self.c, least) - normal * self.t
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where((shear > 0) | (available < 0), np.where(available > 0, available / shear, 0.0), np.inf)

    def divide(self, x, rate, factor):
        """Dissipation and lack of the flow rule: the least of divisions of (ε_x + ε_y, ε_x − ε_y, γ_xy) between soil and planes that slip."""
        c2, s2 = math.cos(2 * self.angle), math.sin(2 * self.angle)
        tangent, c = self.t / factor, self.c / factor

        def evaluate(slip):
            # A slip g along the planes with its dilatancy w = |g| tan φ: engineering strain g in their axes, and w across them.
            w = np.abs(slip) * tangent
            difference = rate[1] - (-slip * s2 - w * c2)
            distortion = rate[2] - (slip * c2 - w * s2)
            whole, lack = self.body.dissipate(x, rate[0] - w, np.hypot(difference, distortion), factor)
            return whole + c * np.abs(slip), lack

        most = 4 * np.hypot(rate[1], rate[2]) + np.abs(rate[0]) + 1e-300
        price = 1e3 * max(self.c, 1e3)

        def cost(slip):
            whole, lack = evaluate(slip)
            return whole + price * lack

        low, high, golden = -most, most, (math.sqrt(5) - 1) / 2
        a, b = high - golden * (high - low), low + golden * (high - low)
        fa, fb = cost(a), cost(b)
        for _ in range(60):
            left = fa < fb
            low, high = np.where(left, low, a), np.where(left, b, high)
            a, b = high - golden * (high - low), low + golden * (high - low)
            fa, fb = cost(a), cost(b)
        best = np.where(fa < fb, a, b)
        zero = cost(np.zeros(len(x))) <= np.minimum(fa, fb)
        return evaluate(np.where(zero, 0.0, best))
