# SPDX-License-Identifier: MIT
"""The undrained wave of 2.6.1: plateau, arrival and doubling against (2.98)-(2.100)."""
import numpy as np

from .runs import Row, budget_row

MODULUS = 1e7 * 0.7 / (1.3 * 0.4)  # E_c [Pa]
STIFFNESS = 2.15e9 / 0.4  # K_w/n [Pa]
LOAD = 1e3
SPEED = np.sqrt((MODULUS + STIFFNESS) / (0.4 * 1000 + 0.6 * 2650))
PRESSURE = LOAD * STIFFNESS / (MODULUS + STIFFNESS)
PUBLISHED_STEP = 3.67e-7


def find_crossing(time, value, level):
    """When `value` passes `level` for the first time, linear between rows."""
    i = int(np.argmax(value >= level))
    return time[i - 1] + (time[i] - time[i - 1]) * (level - value[i - 1]) / (value[i] - value[i - 1])


def check(runner, draw):
    rows, curves = [], []
    for drag in ("explicit", "implicit"):
        run = runner.run(f"wave_{drag}", "wave/case.toml", stage__wave__drag=drag)
        table, history = run.table("monitors.csv"), run.table()
        time, pressure = table["time"], table["middle.pore_pressure"]
        # uniaxial strain: |σ_y - σ_x| is the deviatoric stress, and the mean lies a third of it from σ_x
        effective = -(table["middle.mean_stress"] - 2 / 3 * table["middle.deviatoric_stress"]
                      * np.where(table["middle.mean_stress"] < 0, 1, -1))
        plateau = (time > 4e-4) & (time < 8e-4)
        name = f"undrained wave, {drag} drag"
        if drag == "explicit":
            rows.append(Row(name, "critical time step (2.85)", run.step / 0.98, PUBLISHED_STEP, 5e-10, "s", run=run))
        rows += [
            Row(name, "plateau of p at 0.5 m", pressure[plateau].mean(), PRESSURE, 1e-3 * PRESSURE, "Pa", run=run),
            Row(name, "plateau of σ' at 0.5 m", effective[plateau].mean(), LOAD - PRESSURE, 0.01 * (LOAD - PRESSURE), "Pa",
                run=run),
            Row(name, "arrival at 0.5 m (half the plateau)", find_crossing(time, pressure, PRESSURE / 2), 0.5 / SPEED,
                0.005 * 0.5 / SPEED, "s", run=run),
            Row(name, "doubling (three halves)", find_crossing(time, pressure, 1.5 * PRESSURE), 1.5 / SPEED,
                0.005 * 1.5 / SPEED, "s", run=run),
        ]
        before = int(np.searchsorted(history["time"], 5.5e-4))  # the bottom is not reached yet
        impulse = -LOAD * 0.001 * history["time"][before]
        rows.append(Row(name, "momentum of both phases at 0.55 ms: load times time", history["momentum_y"][before], impulse,
                        1e-6 * abs(impulse), "kg m/s", run=run))
        rows.append(budget_row(name, run))
        curves.append((drag, time, pressure, effective))
    figure, axes = draw(2)
    for axis, column, plateau_value, label in ((axes[0], 2, PRESSURE, "pore pressure [kPa]"),
                                               (axes[1], 3, LOAD - PRESSURE, "effective stress [kPa]")):
        for curve in curves:
            axis.plot(1e3 * curve[1], curve[column] / 1e3, label=f"{curve[0]} drag", lw=1)
        times = np.array([0, 0.5, 0.5, 1.5, 1.5, 1.645]) / SPEED * 1e3
        axis.plot(times, np.array([0, 0, 1, 1, 2, 2]) * plateau_value / 1e3, "k--", lw=0.8, label="closed form")
        axis.set(xlabel="time [ms]", ylabel=label, xlim=(0, 1))
    axes[0].legend()
    return rows, figure
