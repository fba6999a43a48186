# SPDX-License-Identifier: MIT
"""De Leeuw's cylinder and Mandel's strip in plane strain: their pore pressure rises before it falls.

With η = G/E_c, ω = n E_c/K_w, m = 1 + ω(1 – η), R the radius or half the length and T = c t/R², c = k E_c/(γ_w (1 + ω)),
equilibrium is E_c ε = p + f(t), and p = 0 where it drains. The load q on the round of the cylinder gives (1 – η) f =
–q + η⟨p⟩ with ⟨p⟩ the mean; the mean load q under the plates of the strip gives (1 – η) f = –q/2 + η⟨p⟩, and these come
nearer by f/(2G). The poles of the Laplace transform give the series below (Verruijt 2016, Theory and problems of
poroelasticity, chapter 3, there with ω = 0). Both loads rise within RAMP. The cylinder's round has four chords, and its R
is the radius of the same area.
"""
import tomllib

import numpy as np

from .runs import CASES, WATER_WEIGHT, Row, budget_row, by_element

YOUNG, POISSON, POROSITY, CONDUCTIVITY, RAMP = 1e7, 0.2, 0.4, 1e-5, 0.05
RATIO = (1 - 2 * POISSON) / (2 - 2 * POISSON)  # η
SHEAR = YOUNG / (2 * (1 + POISSON))
CONFINED = SHEAR / RATIO  # E_c
STORAGE = POROSITY * CONFINED / 2.2e9  # ω
FACTOR = 1 + STORAGE * (1 - RATIO)  # m
SPEED = CONDUCTIVITY * CONFINED / WATER_WEIGHT / (1 + STORAGE)  # c [m²/s]
CHORD = np.radians(7.5)
SIZES = (0.1, 0.05, 0.025)


def bessel(order, x):
    """J_n(x) by the trapezoidal rule, which converges exponentially for its integral (Abramowitz and Stegun 9.1.21)."""
    angle = (np.arange(400) + 0.5) * np.pi / 400
    return np.cos(order * angle - np.multiply.outer(x, np.sin(angle))).mean(axis=-1)


def find_roots(function, count):
    """The root in each interval of π, by bisection."""
    low, high = (np.arange(count) + 1e-9) * np.pi, (np.arange(count) + 1 - 1e-9) * np.pi
    sign = np.sign(function(low))
    for _ in range(60):
        middle = (low + high) / 2
        same = np.sign(function(middle)) == sign
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return low


class Cylinder:
    name, file, axis = "de Leeuw's cylinder", "de_leeuw", "r [m]"
    square = np.sin(CHORD) / CHORD  # R² [m²]
    undrained = 1e4 / FACTOR  # p under a sudden load [Pa]
    roots = find_roots(lambda z: FACTOR * bessel(0, z) - 2 * RATIO * bessel(1, z) / z, 60)
    weights = 2 * FACTOR / (FACTOR * roots * bessel(1, roots) - 2 * RATIO * bessel(2, roots))

    @classmethod
    def shape(cls, r):
        return bessel(0, np.multiply.outer(r / np.sqrt(cls.square), cls.roots)) - bessel(0, cls.roots)

    @staticmethod
    def find_place(middles):
        return np.hypot(middles[:, 0], middles[:, 1])


class Strip:
    name, file, axis = "Mandel's strip", "mandel", "x [m]"
    square, height, load = 1, 0.2, 2e4
    undrained = load / 2 / FACTOR
    roots = find_roots(lambda z: FACTOR * z * np.cos(z) - RATIO * np.sin(z), 4000)
    weights = 2 * FACTOR * np.cos(roots) / (RATIO - FACTOR * np.cos(roots) ** 2)

    @classmethod
    def shape(cls, x):
        return np.cos(np.multiply.outer(x, cls.roots)) - np.cos(cls.roots)

    @staticmethod
    def find_place(middles):
        return middles[:, 0]

    @classmethod
    def find_approach(cls, t):
        """Settlement of the plates at the time t > RAMP [m]."""
        strain = 1 / (1 - RATIO) - (1 + STORAGE) / FACTOR * np.sum(cls.weights * np.cos(cls.roots) * find_left(cls, t))
        return cls.height * cls.load / 2 * strain / (2 * SHEAR)


def find_left(body, t):
    """Remaining fraction of each term of the series at the time t > RAMP: the mean of exp(–ξ²T) over the ramp."""
    rate = body.roots**2 * SPEED / body.square
    return (np.exp(-rate * (t - RAMP)) - np.exp(-rate * t)) / (rate * RAMP)


def find_pressure(body, place, t):
    """p/p0 at r or x [m] and the time t > RAMP [s]."""
    return body.shape(place) @ (body.weights * find_left(body, t))


def check_plate():
    """The velocities of the case file against the series."""
    plate = tomllib.loads((CASES / "mandel" / "case.toml").read_text())["boundary"][2]
    time, factor = np.array(plate["factor"]).T
    way = -plate["velocity"][1] * np.concatenate([[0], np.cumsum(np.diff(time) * (factor[1:] + factor[:-1]) / 2)])
    worst = max(abs(np.interp(t, time, way) / Strip.find_approach(t) - 1) for t in np.geomspace(0.1, time[-1], 50))
    return Row(Strip.name, "way of the plate in the case file over that of the series, less 1", worst, 0, 0.0005)


def compare(runner, body, axes):
    rows = []
    line = np.linspace(0, np.sqrt(body.square), 100)
    for size in SIZES:
        run = runner.run(f"{body.file}_{size}", f"{body.file}/case.toml", mesh__size=size)
        name = f"{body.name}, water of 2.2 GPa, no mass scaling, elements of {size} m"
        errors, middle, borne = {}, [], []
        for frame in run.frames():
            factor = SPEED / body.square * frame.time
            if factor < 0.04:
                continue
            middles, pressure = by_element(frame, "pore_pressure")
            place = body.find_place(middles)
            errors[factor] = np.abs(pressure / body.undrained - find_pressure(body, place, frame.time)).max()
            middle.append((factor, pressure[np.argmin(place)] / body.undrained))
            if body is Strip:
                stress = by_element(frame, "stress")[1][:, 1] - pressure
                volume = by_element(frame, "volume")[1]
                borne.append(-np.sum(stress * volume) / np.sum(volume) / body.load)
            if size == SIZES[1] and min(abs(factor - f) for f in (0.05, 0.1, 0.2, 0.5)) < 0.003:
                axes[1].plot(place, pressure / body.undrained, ".", ms=3, label=f"T = {factor:.2g}")
                axes[1].plot(line, find_pressure(body, line, frame.time), "k-", lw=0.6)
        first = min(errors)
        coarse = {"known_miss": True, "note": "few elements over the drained zone"} if size == SIZES[0] else {}
        later = max(e for f, e in errors.items() if f > first)
        rows.append(Row(name, f"largest difference of p over p0, T = {first:.2f}", errors[first], 0, 0.01, run=run, **coarse))
        rows.append(Row(name, "the same, later", later, 0, 0.01, run=run, **(coarse if body is Strip else {})))
        if borne:
            worst = max(borne, key=lambda b: abs(b - 1))
            rows.append(Row(name, "load on the plate over the given load, farthest from 1", worst, 1, 0.01, run=run, **coarse))
        rows.append(budget_row(name, run))
        axes[0].plot(*zip(*middle), ".", ms=4, label=f"{size} m")
    times = np.linspace(0.003, 0.5, 200) * body.square / SPEED
    axes[0].plot(SPEED / body.square * times, [find_pressure(body, np.array([0.0]), t)[0] for t in times], "k-", lw=0.8, label="series")
    axes[0].set(xlabel="T", ylabel="p/p0 in the middle", title=body.name)
    axes[1].set(xlabel=body.axis, ylabel="p/p0")
    for a in axes:
        a.legend(fontsize=6)
    return rows


def check(runner, draw):
    figure, axes = draw(4)
    rows = compare(runner, Cylinder, axes[:2]) + [check_plate()] + compare(runner, Strip, axes[2:])
    return rows, figure
