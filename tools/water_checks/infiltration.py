# SPDX-License-Identifier: MIT
"""Infiltration against the closed solution of Srivastava and Yeh (1991) for the exponential laws."""
import numpy as np

from .runs import WATER_WEIGHT, Row, budget_row, by_element

HOUR = 3600
ALPHA, K_S, THETA_S, THETA_R, LENGTH = 10.0, 0.01 / HOUR, 0.4, 0.06, 1.0  # 1/m, m/s, -, -, m
BEFORE, AFTER = 0.1, 0.9  # over k_s


def find_roots(count=400):
    """Roots of tan(λL) + 2λ = 0 for the dimensionless length αL: one in each ((i - ½)π/L, iπ/L), by bisection."""
    length = ALPHA * LENGTH
    low = (np.arange(1, count) - 0.5) * np.pi / length + 1e-12
    high = np.arange(1, count) * np.pi / length
    for _ in range(80):
        middle = 0.5 * (low + high)
        below = np.tan(middle * length) + 2 * middle < 0
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)


ROOTS = find_roots()


def find_head(height, time):
    """Pressure head ψ [m], negative, at heights over the water table."""
    z, length = ALPHA * np.asarray(height), ALPHA * LENGTH
    t = ALPHA * K_S * time / (THETA_S - THETA_R)
    terms = np.sin(np.outer(z, ROOTS)) * np.sin(ROOTS * length) * np.exp(-ROOTS**2 * t) / (
        1 + length / 2 + 2 * ROOTS**2 * length)
    relative = AFTER - (AFTER - 1) * np.exp(-z) - 4 * (AFTER - BEFORE) * np.exp((length - z) / 2) * np.exp(
        -t / 4) * terms.sum(axis=1)
    return np.log(relative) / ALPHA


def check(runner, draw):
    run = runner.run("infiltration", "infiltration/case.toml")
    rows, name = [], "infiltration, Srivastava and Yeh"
    figure, axes = draw(2)
    z = np.linspace(0, 1, 300)
    frames = run.frames()
    for hours in (1, 2, 3, 5, 10, 20):
        frame = min(frames, key=lambda f: abs(f.time - hours * HOUR))
        middles, pressure = by_element(frame, "pore_pressure")
        exact = find_head(middles[:, 1], frame.time - 1)  # the rain begins after one second
        difference = np.abs(pressure / WATER_WEIGHT - exact).max()
        rows.append(Row(name, f"suction head after {hours} h, largest difference (range 0.23 m)", difference, 0, 0.002, "m",
                        run=run))
        axes[0].plot(find_head(z, frame.time - 1), z, "k-", lw=0.8)
        axes[0].plot(pressure[::3] / WATER_WEIGHT, middles[::3, 1], ".", ms=4, label=f"{hours} h")
    axes[0].set(xlabel="pressure head [m]", ylabel="height over the water table [m]")
    axes[0].legend()
    history = run.table()
    outflow = history["bottom.outflow"][1:] / 0.02  # means between two rows
    time = 0.5 * (history["time"][1:] + history["time"][:-1])
    k_bottom = [(-find_head(np.array([1e-4]), max(t, 60))[0] / 1e-4) for t in time]
    exact_flow = K_S * (1 - np.array(k_bottom))
    axes[1].plot(time / HOUR, exact_flow / K_S, "k-", lw=0.8, label="closed form")
    axes[1].plot(time[::2] / HOUR, outflow[::2] / K_S, ".", ms=3, label="outflow through the water table")
    axes[1].set(xlabel="time [h]", ylabel="discharge over k_s")
    axes[1].legend()
    rows.append(Row(name, "outflow after 20 h over k_s", outflow[-1] / K_S, exact_flow[-1] / K_S, 0.002, run=run))
    rows.append(Row(name, "rain that entered, of 0.9 k_s", history["top.inflow"][-1] / 0.02 / K_S, AFTER, 1e-6, run=run))
    rows.append(budget_row(name, run))
    return rows, figure
