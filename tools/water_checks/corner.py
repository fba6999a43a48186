# SPDX-License-Identifier: MIT
"""Confined flow round a corner against conformal mapping; shows how flow locks without exchange of water between elements."""
import numpy as np

from .runs import WATER_WEIGHT, Row

UNIT = 1e-4 * 0.5  # k Δh [m²/s]
PRESSURE = 0.5 * WATER_WEIGHT  # ρ_w g Δh [Pa]


def find_complete_integral(m):
    """K(m), complete elliptic integral of the first kind, by the arithmetic-geometric mean."""
    a, b = 1.0, np.sqrt(1 - m)
    while abs(a - b) > 1e-15:
        a, b = 0.5 * (a + b), np.sqrt(a * b)
    return np.pi / (2 * a)


def find_discharge():
    """Q/(kΔh): sn maps the square to the half plane, its corners to ±1, ±1/κ, the middles of its sides to ±1/√κ."""
    kappa = (np.sqrt(2) - 1)**2  # K'/K = 2
    a, b, c, d = -1 / np.sqrt(kappa), -1, 1 / np.sqrt(kappa), 1 / kappa  # ends of the inlet and of the outlet
    m = (b - a) * (d - c) / ((c - a) * (d - b))
    return find_complete_integral(m) / find_complete_integral(1 - m)


SIZES = (0.1, 0.05, 0.025)
STYLES = ("-", "--", ":")
LOCKS = "locks, and falls further with time"
LIMITED = "the exchange between elements in a step is limited: less in large steps"
# label, settings, element sizes, known miss; the first three are drawn
VARIANTS = (("coupled", {}, SIZES, LIMITED),
            ("coupled, without exchange", {"stage__flow__water_exchange": "false"}, SIZES, LOCKS),
            ("coupled, pressure smoothing too", {"stage__flow__pressure_smoothing": "true"}, SIZES, ""),
            ("coupled, a step of 1/32", {"stage__flow__mass_scaling": 10, "stage__flow__duration": 15}, (0.05,), ""),
            ("coupled, water of 2.2 GPa", {"water__bulk_modulus": '"2.2 GPa"', "stage__flow__duration": 20}, (0.05,), LIMITED))


def check(runner, draw):
    rows, exact = [], find_discharge()
    results = {"seepage solver": []}
    figure, axes = draw(2)
    for number, (label, settings, sizes, miss) in enumerate(VARIANTS):
        results[label] = []
        for size in sizes:
            run = runner.run(f"corner_{number}_{size}", "corner/case.toml", mesh__size=size, **settings)
            history = run.table()
            results[label].append(history["outlet.outflow"][-1] / UNIT)
            name = f"flow round a corner, {label}, {size} m"
            rows.append(Row(name, "discharge over kΔh", results[label][-1], exact, 1.6 * size * exact, run=run,
                            known_miss=bool(miss), note=miss))
            first, last = (frame["pore_pressure"] for frame in (run.frames()[0], run.frames()[-1]))
            rows.append(Row(name, "pressure over Δh, root of the mean square difference from the seepage solver",
                            np.sqrt(np.square(last - first).mean()) / PRESSURE, 0, 0.1, run=run,
                            known_miss=bool(miss), note="high and low by turns" if miss == LOCKS else ""))
            if number == 0:
                results["seepage solver"].append(run.summary["seepage"]["inflow"] / UNIT)
                rows.append(Row(f"flow round a corner, seepage solver, {size} m", "discharge over kΔh",
                                results["seepage solver"][-1], exact, 1.6 * size * exact, run=run))
            if number < 3:
                axes[0].plot(history["time"][1:], history["outlet.outflow"][1:] / UNIT / exact, lw=1,
                             label=f"{size} m" if number == 0 else None, color=f"C{SIZES.index(size)}", ls=STYLES[number])
        if number < 3:
            axes[0].plot([], [], "k", lw=1, ls=STYLES[number], label=label)
    axes[0].axhline(1, color="k", lw=0.8)
    axes[0].set(xlabel="time [s]", ylabel="discharge over the exact one", ylim=(0.5, 1.1))
    axes[0].legend(loc="lower right", fontsize=6, ncols=2)
    for label, values in results.items():
        if len(values) == len(SIZES):
            axes[1].plot(SIZES, np.array(values) / exact, "o-", label=label)
    axes[1].axhline(1, color="k", lw=0.8)
    axes[1].set(xlabel="element size [m]", ylabel="discharge over the exact one", xlim=(0, 0.11), ylim=(0.5, 1.1))
    axes[1].legend(fontsize=7)
    return rows, figure
