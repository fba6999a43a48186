# SPDX-License-Identifier: MIT
"""Water at rest, saturated and with suction, and Darcy's discharge through two layers."""
import numpy as np

from .runs import WATER_WEIGHT, Row, budget_row, by_element

SETTLEMENT = 0.6 * 1650 * 9.81 * 2**2 / 2 / (1e6 * 0.7 / (1.3 * 0.4))


LEFT_OVER = "one pressure in an element, and points that cross elements"
FLUTTERS = "oscillates where points cross elements"
# what is changed, settings, element size, why the pressure may miss
SETTLING = (("", {}, 0.1, ""), (", elements of 0.05 m", {"mesh__size": 0.05}, 0.05, LEFT_OVER),
            (", pressure smoothing", {"stage__settling__pressure_smoothing": "true"}, 0.1, FLUTTERS),
            (", strain smoothing", {"stage__settling__smoothing": '"strain"'}, 0.1, FLUTTERS))


def check_settling(runner):
    rows = []
    for number, (label, settings, _, miss) in enumerate(SETTLING):
        title = f"soft column settling by 14 mm under water, 60 s{label}"
        run = runner.run(f"hydrostatic_settling_{number}", "hydrostatic/settling.toml", may_break=miss == FLUTTERS, **settings)
        if run is None:
            rows.append(Row(title, "runs to its end", 0, 1, 0.5, note=f"{FLUTTERS}, and ends with an error", known_miss=True))
            continue
        last = run.frames()[-1]
        # at points: half a kilopascal of it is that the pressure is one in an element
        error = np.abs(last["pore_pressure"].ravel() - WATER_WEIGHT * (3 - last.points[:, 1]))
        rows.append(Row(title, "largest difference of pressure from rest", error.max(), 0, 1000, "Pa", note=miss, run=run,
                        known_miss=bool(miss)))
        rows.append(Row(title, "largest speed of the grains", np.abs(last["velocity"]).max(), 0, 1e-4, "m/s", run=run,
                        known_miss=miss == FLUTTERS, note=miss if miss == FLUTTERS else ""))
        if miss != FLUTTERS:
            rows.append(Row(title, "settlement", run.summary["stages"][0]["displacement"], SETTLEMENT, 0.02 * SETTLEMENT, "m",
                            run=run))
        rows.append(budget_row(title, run))
    return rows


def check(runner, draw):
    rows = []
    figure, axes = draw(2)
    for name, level, bound in (("saturated", 3, 0.2), ("suction", 1, 1)):
        run = runner.run(f"hydrostatic_{name}", f"hydrostatic/{name}.toml")
        first, last = run.frames()[0], run.frames()[-1]
        title = f"hydrostatic column, {name}, 5 s"
        speed = max(np.abs(last["velocity"]).max(), np.abs(last["water_velocity"]).max())
        rows += [
            Row(title, "largest speed of grains or water", speed, 0, 1e-6, "m/s", run=run),
            Row(title, "largest nodal speed, all rows of the history", run.table()["nodal_speed"].max(), 0, 5e-6, "m/s", run=run),
            Row(title, "largest change of pressure", np.abs(last["pore_pressure"] - first["pore_pressure"]).max(), 0, bound,
                "Pa", run=run),
            Row(title, "largest displacement", run.summary["stages"][0]["displacement"], 0, 1e-7, "m", run=run),
            budget_row(title, run),
        ]
        middles, pressure = by_element(last, "pore_pressure")
        axes[0].plot(pressure / 1e3, middles[:, 1], ".", ms=3, label=name)
        y = np.array([0, 2])
        axes[0].plot(WATER_WEIGHT * (level - y) / 1e3, y, "k-", lw=0.8)
    rows += check_settling(runner)
    axes[0].set(xlabel="pore pressure after 5 s [kPa]", ylabel="y [m]")
    axes[0].legend()

    exact = 0.3 * 0.4 / (1 / 1e-4 + 1 / 4e-5)
    for geometry, bound in (("frozen", 1e-6), ("moving", 1e-3)):
        run = runner.run(f"darcy_{geometry}", "darcy/case.toml", stage__flow__geometry=geometry)
        history = run.table()
        title = f"Darcy flow through two layers, {geometry} geometry"
        for quantity in ("bottom.inflow", "top.outflow"):
            rows.append(Row(title, quantity, history[quantity][-1], exact, bound * exact, "m³/s", run=run,
                            note="the surface rises by 0.11 mm, but standing water loads the mesh side that stays" if geometry == "moving" else ""))
        if geometry == "moving":
            rows.append(budget_row(title, run))
            axes[1].plot(history["time"], history["bottom.inflow"] / exact, label="inflow at the bottom")
            axes[1].plot(history["time"], history["top.outflow"] / exact, label="outflow at the top")
    axes[1].axhline(1, color="k", lw=0.8)
    axes[1].set(xlabel="time [s]", ylabel="discharge over Darcy's", ylim=(0, 3))
    axes[1].legend()
    return rows, figure
