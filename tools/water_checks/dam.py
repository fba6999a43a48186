# SPDX-License-Identifier: MIT
"""A rectangular dam: Dupuit's discharge from the seepage solver and from the coupled step run to its steady state."""
import numpy as np

from .runs import Row, budget_row

DISCHARGE = 1e-4 * (10**2 - 2**2) / (2 * 10)
# Baiocchi's free surface at x/L = 0.1 … 0.9, solved on 960 cells
SURFACE = [9.739, 9.393, 8.99, 8.535, 8.025, 7.458, 6.821, 6.092, 5.219]


def find_water_level(frame, size):
    """Height where the pressure is zero, in columns of width `size` at x = 1 … 9 m."""
    levels = []
    for x in range(1, 10):
        near = np.abs(frame.points[:, 0] - x) < 0.75 * size
        y, p = frame.points[near, 1], frame["pore_pressure"][near]
        order = np.argsort(y)
        y, p = y[order], p[order]
        around = np.abs(p) < 8e3
        slope, at_zero = np.polyfit(p[around], y[around], 1)
        levels.append(at_zero)
    return np.array(levels)


def check(runner, draw):
    rows = []
    figure, axes = draw(2)
    steady = runner.run("dam_from_steady", "dam/case.toml")
    rows.append(Row("dam, steady seepage solver, 0.5 m", "discharge over Dupuit's", steady.summary["seepage"]["inflow"] / DISCHARGE,
                    1, 0.03, note="the fringe carries the rest", run=steady))
    high, low = [{"initial__pore_pressure": '"water_table"', "initial__water_table": f"[[0, 10], [10, {level}]]"}
                 for level in (8, 4)]
    runs = [("dam, coupled, 0.5 m, from the steady state", steady, 0.03),
            ("dam, coupled, 0.5 m, from a table that is too high", runner.run("dam_from_high", "dam/case.toml", **high), 0.03),
            ("dam, coupled, 0.5 m, from a table that is too low", runner.run("dam_from_low", "dam/case.toml", **low), 0.03),
            ("dam, coupled, 1 m, from the steady state", runner.run("dam_coarse", "dam/case.toml", mesh__size=1), 0.1),
            ("dam, coupled, 0.5 m, without exchange",
             runner.run("dam_no_exchange", "dam/case.toml", stage__flow__water_exchange="false"), 0.03)]
    notes = {"without": "locks, see flow round a corner"}
    for name, run, bound in runs:
        history = run.table()
        note = next((text for key, text in notes.items() if key in name), "")
        rows.append(Row(name, "inflow over Dupuit's", history["left.inflow"][-1] / DISCHARGE, 1, bound, note=note, run=run,
                        known_miss=bool(note)))
        rows.append(Row(name, "outflow over Dupuit's", history["right.outflow"][-1] / DISCHARGE, 1, bound, note=note, run=run,
                        known_miss=bool(note)))
        rows.append(budget_row(name, run))
        axes[1].plot(history["time"][1:] / 3600, history["right.outflow"][1:] / DISCHARGE, lw=1, label=name[14:])
    levels = find_water_level(steady.frames()[-1], 0.5)
    rows.append(Row(runs[0][0], "free surface, largest difference", np.abs(levels - SURFACE).max(), 0, 0.5, "m", run=steady))
    high_levels = find_water_level(runs[1][1].frames()[-1], 0.5)
    rows.append(Row(runs[1][0], "free surface, largest difference", np.abs(high_levels - SURFACE).max(), 0, 0.5, "m",
                    note="from above, by the width of an element", run=runs[1][1], known_miss=True))
    x = np.arange(1, 10)
    axes[0].plot(x, SURFACE, "k-", lw=0.8, label="Baiocchi")
    axes[0].plot(x, levels, "o", ms=4, label="from the steady state")
    axes[0].plot(x, high_levels, "x", ms=5, label="from a table that is too high")
    axes[0].set(xlabel="x [m]", ylabel="free surface [m]", ylim=(0, 10))
    axes[0].legend()
    axes[1].axhline(1, color="k", lw=0.8)
    axes[1].set(xlabel="time [h]", ylabel="outflow over Dupuit's", ylim=(0, 1.6))
    axes[1].legend(fontsize=7)
    return rows, figure
