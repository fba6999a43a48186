# SPDX-License-Identifier: MIT
"""Free drainage of a column against Richards' equation, solved here by finite volumes with implicit steps."""
import numpy as np

from .runs import WATER_WEIGHT, Row, budget_row, by_element

P_REF, LAMBDA, S_MIN, POROSITY, K_S = 3e3, 0.6, 0.1, 0.4, 1e-5
MODULUS, WATER_MODULUS = 20e6 * 0.7 / (1.3 * 0.4), 100e6


def find_saturation(pressure):
    """Saturation at pressures positive in compression [Pa]."""
    suction = np.maximum(-pressure, 0)
    return S_MIN + (1 - S_MIN) * (1 + (suction / P_REF)**(1 / (1 - LAMBDA)))**-LAMBDA


def find_conductivity(pressure):
    x = (find_saturation(pressure) - S_MIN) / (1 - S_MIN)
    return K_S * np.sqrt(x) * (1 - (1 - x**(1 / LAMBDA))**LAMBDA)**2


def find_content(pressure, still):
    """Water per volume of soil: pores, compression of the water and of the skeleton. `still`: pressure at the start."""
    s = find_saturation(pressure)
    return s * (POROSITY * (1 + pressure / WATER_MODULUS) + (s * pressure - still) / MODULUS)


def solve_richards(times, cells=400):
    """Pressures [Pa] at the middles of the cells and the outflow since the start [m] at the given times [s].

    Backward Euler in mixed form, Newton with differences for derivatives; the conductivity between two cells is their mean."""
    h = 1 / cells
    y = (np.arange(cells) + 0.5) * h
    still = WATER_WEIGHT * (1 - y)
    p, t, out, step, results = still.copy(), 0.0, 0.0, 0.1, []
    for end in times:
        while t < end - 1e-9:
            dt = min(step, end - t)
            bottom = 9810 * max(0.0, 1 - (t + dt) / 60)

            def fluxes(q):
                k = find_conductivity(q)
                inner = -0.5 * (k[1:] + k[:-1]) * (np.diff(q) / h / WATER_WEIGHT + 1)
                return np.concatenate(([-0.5 * (k[0] + K_S) * ((q[0] - bottom) / (h / 2) / WATER_WEIGHT + 1)], inner, [0.0]))

            new, old = p.copy(), find_content(p, still)
            for _ in range(30):
                f = find_content(new, still) - old + dt / h * np.diff(fluxes(new))
                jacobian = np.zeros((3, cells))  # each third column at once
                for k in range(3):
                    e = np.zeros(cells)
                    e[k::3] = 1e-3
                    g = (find_content(new + e, still) - old + dt / h * np.diff(fluxes(new + e)) - f) / 1e-3
                    for row in range(3):  # rows below, at and above the changed cell
                        column = np.arange(k, cells, 3)
                        i = column + row - 1
                        inside = (i >= 0) & (i < cells)
                        jacobian[row, column[inside]] = g[i[inside]]
                change = solve_banded(jacobian, -f)
                new += np.clip(change, -2000, 2000)
                if np.abs(change).max() < 1e-4:
                    break
            else:
                step = dt / 2
                continue
            out -= dt * fluxes(new)[0]
            p, t, step = new, t + dt, min(dt * 1.15, 30.0)
        results.append((p.copy(), out))
    return y, results


def solve_banded(bands, right):
    """Thomas: bands[row, column] holds the entries of `column` in the rows above (0), at (1) and below (2) it."""
    n = len(right)
    upper, middle, lower = bands[0], bands[1].copy(), bands[2]
    x = right.copy()
    for i in range(1, n):
        w = lower[i - 1] / middle[i - 1]
        middle[i] -= w * upper[i]
        x[i] -= w * x[i - 1]
    x[-1] /= middle[-1]
    for i in range(n - 2, -1, -1):
        x[i] = (x[i] - upper[i + 1] * x[i + 1]) / middle[i]
    return x


def check(runner, draw):
    run = runner.run("drainage", "drainage/case.toml")
    name, rows = "free drainage", []
    figure, axes = draw(2)
    frames = [f for f in run.frames() if f.time > 0]
    chosen = [min(frames, key=lambda f: abs(f.time - hours * 3600)) for hours in (0.5, 1, 2, 4, 8)]
    y, solution = solve_richards([f.time for f in chosen])
    for frame, (pressure, _) in zip(chosen, solution):
        middles, computed = by_element(frame, "pore_pressure")
        _, saturation = by_element(frame, "saturation")
        expected = np.interp(middles[:, 1], y, pressure)
        label = f"{frame.time / 3600:.1f} h"
        rows.append(Row(name, f"saturation after {label}, largest difference",
                        np.abs(saturation - find_saturation(expected)).max(), 0, 0.002, run=run))
        rows.append(Row(name, f"pressure head after {label}, largest difference",
                        np.abs(computed - expected).max() / WATER_WEIGHT, 0, 0.002, "m", run=run))
        axes[0].plot(find_saturation(pressure), y, "k-", lw=0.8)
        axes[0].plot(saturation[::3], middles[::3, 1], ".", ms=4, label=label)
    axes[0].set(xlabel="saturation", ylabel="y [m]")
    axes[0].legend()
    left = run.summary["water"]["left"] / 1000 / 0.02
    rows.append(Row(name, "water drained in 8 h, per area", left, solution[-1][1], 0.002 * solution[-1][1], "m", run=run))
    rows.append(budget_row(name, run))
    history = run.table()
    drained = np.concatenate(([0], np.cumsum(np.diff(history["time"]) * history["bottom.outflow"][1:]))) / 0.02
    axes[1].plot([f.time / 3600 for f in chosen], [out for _, out in solution], "kx", label="Richards' equation")
    axes[1].plot(history["time"] / 3600, drained, lw=1, label="drained")
    axes[1].set(xlabel="time [h]", ylabel="water per area [m]")
    axes[1].legend()
    return rows, figure
