# SPDX-License-Identifier: MIT
"""De Leeuw's cylinder in plane strain (1964): its pore pressure rises before it falls.

With η = G/E_c, ω = n E_c/K_w, m = 1 + ω(1 – η) and T = c t/R² with c = k E_c/(γ_w (1 + ω)), equilibrium is
E_c ε = p + f(t), and the load q on the round gives (1 – η) f = –q + η⟨p⟩, ⟨p⟩ the mean over the section; p = 0 on the round. The
poles of the Laplace transform give the series below (Verruijt 2016, Theory and problems of poroelasticity, chapter 3, there
with ω = 0). The load rises within RAMP; the round has four chords, and R is the radius of the same area.
"""
import numpy as np

from .runs import WATER_WEIGHT, Row, budget_row

YOUNG, POISSON, POROSITY, CONDUCTIVITY, LOAD, RAMP = 1e7, 0.2, 0.4, 1e-5, 1e4, 0.05
CHORD = np.radians(7.5)
SQUARE = np.sin(CHORD) / CHORD  # R² [m²]
RATIO = (1 - 2 * POISSON) / (2 - 2 * POISSON)  # η
CONFINED = YOUNG / (2 * (1 + POISSON)) / RATIO  # E_c
STORAGE = POROSITY * CONFINED / 2.2e9  # ω
FACTOR = 1 + STORAGE * (1 - RATIO)  # m
SPEED = CONDUCTIVITY * CONFINED / WATER_WEIGHT / (1 + STORAGE) / SQUARE  # T/t
UNDRAINED = LOAD / (1 + STORAGE)  # p0 under a sudden load
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


ROOTS = find_roots(lambda z: FACTOR * bessel(0, z) - 2 * RATIO * bessel(1, z) / z, 60)
WEIGHTS = 2 / (FACTOR * ROOTS * bessel(1, ROOTS) - 2 * RATIO * bessel(2, ROOTS))


def find_pressure(r, t):
    """p/p0 at the radii r [m] and the time t > RAMP [s]."""
    rate = ROOTS**2 * SPEED
    left = (np.exp(-rate * (t - RAMP)) - np.exp(-rate * t)) / (rate * RAMP)  # mean of exp(–ξ²T) over the ramp
    shape = bessel(0, np.multiply.outer(r / np.sqrt(SQUARE), ROOTS)) - bessel(0, ROOTS)
    return LOAD / UNDRAINED * shape @ (WEIGHTS * left)


def read_pressure(frame):
    """Radii of the elements' middles, and p/p0 there."""
    order = np.argsort(frame["id"])
    middles = frame.points[order].reshape(-1, 3, 3).mean(axis=1)
    return np.hypot(middles[:, 0], middles[:, 1]), frame["pore_pressure"].ravel()[order].reshape(-1, 3).mean(axis=1) / UNDRAINED


def check(runner, draw):
    figure, axes = draw(2)
    rows = []
    s = np.linspace(0, 1, 100)
    for size in SIZES:
        run = runner.run(f"de_leeuw_{size}", "de_leeuw/case.toml", mesh__size=size)
        name = f"de Leeuw's cylinder, water of 2.2 GPa, no mass scaling, elements of {size} m"
        errors, middle = {}, []
        for frame in run.frames():
            factor = SPEED * frame.time
            if factor < 0.04:
                continue
            r, pressure = read_pressure(frame)
            errors[factor] = np.abs(pressure - find_pressure(r, frame.time)).max()
            near = np.argmin(r)
            middle.append((factor, pressure[near]))
            if size == SIZES[1] and min(abs(factor - f) for f in (0.05, 0.1, 0.2, 0.5)) < 0.003:
                axes[1].plot(r, pressure, ".", ms=3, label=f"T = {factor:.2g}")
                axes[1].plot(s, find_pressure(s, frame.time), "k-", lw=0.6)
        first = min(errors)
        rows.append(Row(name, f"largest difference of p over p0, T = {first:.2f}", errors[first], 0, 0.01, run=run,
                        known_miss=size == 0.1, note="two elements over what has drained" if size == 0.1 else ""))
        rows.append(Row(name, "the same, later", max(e for f, e in errors.items() if f > first), 0, 0.01, run=run))
        rows.append(budget_row(name, run))
        axes[0].plot(*zip(*middle), ".", ms=4, label=f"{size} m")
    times = np.linspace(0.003, 0.5, 200) / SPEED
    axes[0].plot(SPEED * times, [find_pressure(np.array([0.0]), t)[0] for t in times], "k-", lw=0.8, label="series, r = 0")
    axes[0].set(xlabel="T", ylabel="p/p0 in the middle")
    axes[1].set(xlabel="r [m]", ylabel="p/p0")
    for a in axes:
        a.legend(fontsize=6)
    return rows, figure
