# SPDX-License-Identifier: MIT
"""Darcy formulation, with pressures at the nodes: steady discharge beside the seepage solver, a soft column that settles, and the
problems of two velocities that have no waves."""
import numpy as np

from . import dam, drainage, infiltration, terzaghi
from .runs import WATER_WEIGHT, Row, budget_row, by_element
from .still import SETTLEMENT

SEEPS = '"seeps"'
REAL = '"2.2 GPa"'
#: problem, file, sizes of the elements [m]
STEADY = (("flow round a corner", "corner/case.toml", (0.1, 0.05, 0.025)), ("flow under a sheet pile", "sheet_pile/case.toml", (0.1, 0.05)))
#: name, what is changed, mass scaling
WATERS = (("water of 20 MPa", {}, 1000), ("water of 2.2 GPa", {"water__bulk_modulus": REAL}, 1000),
          ("water of 2.2 GPa, a third of the step", {"water__bulk_modulus": REAL}, 100))
COARSE = "the outermost element is integrated by its points"
SETTLING = ((0.1, "none"), (0.1, "strain"), (0.07, "strain"), (0.05, "strain"), (0.05, "stable"))


def check_steady(runner, axes):
    rows = []
    for problem, file, sizes in STEADY:
        for label, settings, scaling in WATERS:
            for size in sizes:
                if scaling == 100 and size != 0.1:
                    continue
                run = runner.run(f"seeping_{file.split('/')[0]}_{len(rows)}", file, mesh__size=size, stage__flow__water=SEEPS,
                                 stage__flow__duration=20, stage__flow__damping=0.5, stage__flow__mass_scaling=scaling, **settings)
                solver = run.summary["seepage"]["inflow"]
                outflow = run.table()["outlet.outflow"]
                title = f"{problem}, {label}, {size} m"
                rows.append(Row(title, "discharge over that of the seepage solver", outflow[-1] / solver, 1, 0.002, run=run))
                rows.append(budget_row(title, run))
                axes.plot(run.table()["time"][1:], outflow[1:] / solver, lw=1, label=title)
    axes.set(xlabel="time [s]", ylabel="discharge over that of the seepage solver", ylim=(0.99, 1.01))
    return rows


def check_settling(runner, axes):
    rows = []
    for size, smoothing in SETTLING:
        title = f"soft column settling under real water, {size} m, smoothing {smoothing}"
        run = runner.run(f"seeping_settling_{size}_{smoothing}", "hydrostatic/settling.toml", may_break=True, mesh__size=size,
                         water__bulk_modulus=REAL, stage__settling__water=SEEPS, stage__settling__smoothing=f'"{smoothing}"')
        if run is None:
            rows.append(Row(title, "runs to its end", 0, 1, 0.5))
            continue
        last = run.frames()[-1]
        error = np.abs(last["pore_pressure"].ravel() - WATER_WEIGHT * (3 - last.points[:, 1]))
        rows.append(Row(title, "largest difference of pressure from rest", error.max(), 0, 1000, "Pa", run=run))
        rows.append(Row(title, "largest speed of the grains", np.abs(last["velocity"]).max(), 0, 1e-4, "m/s", run=run))
        rows.append(Row(title, "settlement", run.summary["stages"][0]["displacement"], SETTLEMENT, 0.02 * SETTLEMENT, "m", run=run,
                        known_miss=size == 0.1, note=COARSE if size == 0.1 else ""))
        rows.append(budget_row(title, run))
        few = slice(None, None, 1 + len(error) // 200)
        axes.plot(error[few], last.points[few, 1], ".", ms=3, label=f"{size} m, {smoothing}")
    axes.set(xlabel="difference of pressure from rest [Pa]", ylabel="height [m]")
    axes.legend(fontsize=6)
    return rows


def check_rest(runner):
    for name in ("saturated", "suction"):
        run = runner.run(f"seeping_{name}", f"hydrostatic/{name}.toml", stage__rest__water=SEEPS)
        first, last = run.frames()[0], run.frames()[-1]
        title = f"hydrostatic column, {name}, 5 s"
        change = np.abs(last["pore_pressure"] - first["pore_pressure"]).max()
        yield Row(title, "largest nodal speed, all rows of the history", run.table()["nodal_speed"].max(), 0, 5e-6, "m/s", run=run)
        yield Row(title, "largest change of pressure", change, 0, 0.2, "Pa", run=run)
        yield Row(title, "largest displacement", run.summary["stages"][0]["displacement"], 0, 1e-7, "m", run=run)


def check_terzaghi(runner):
    run = runner.run("seeping_terzaghi", "terzaghi/case.toml", stage__consolidation__water=SEEPS, stage__consolidation__water_damping=0)
    title, speed = "Terzaghi, mass scaling 1e5, 800 s", terzaghi.SPEED
    frames = [f for f in run.frames() if speed * f.time > 0.19]
    error = max(terzaghi.find_isochrone_error(f, speed * f.time) for f in frames)
    degree = max(abs(terzaghi.settle(f) / terzaghi.SETTLEMENT - terzaghi.find_degree(speed * f.time)[0]) for f in frames)
    yield Row(title, "isochrones T ≥ 0.2, largest difference over p0", error, 0, 0.005, run=run)
    yield Row(title, "degree U(T), largest difference", degree, 0, 0.003, run=run)
    yield budget_row(title, run)


def check_infiltration(runner):
    run = runner.run("seeping_infiltration", "infiltration/case.toml", stage__rain__water=SEEPS)
    title = "infiltration, Srivastava and Yeh"
    for hours in (1, 2, 5, 20):
        frame = min(run.frames(), key=lambda f: abs(f.time - hours * infiltration.HOUR))
        middles, pressure = by_element(frame, "pore_pressure")
        exact = infiltration.find_head(middles[:, 1], frame.time - 1)  # the rain begins after one second
        yield Row(title, f"suction head after {hours} h, largest difference (range 0.23 m)",
                  np.abs(pressure / WATER_WEIGHT - exact).max(), 0, 0.002, "m", run=run)
    yield budget_row(title, run)


def check_drainage(runner):
    run = runner.run("seeping_drainage", "drainage/case.toml", stage__drainage__water=SEEPS)
    frames = [f for f in run.frames() if f.time > 0]
    chosen = [min(frames, key=lambda f: abs(f.time - hours * 3600)) for hours in (0.5, 2, 8)]
    y, solution = drainage.solve_richards([f.time for f in chosen])
    title = "free drainage"
    for frame, (pressure, _) in zip(chosen, solution):
        middles, saturation = by_element(frame, "saturation")
        exact = drainage.find_saturation(np.interp(middles[:, 1], y, pressure))
        yield Row(title, f"saturation after {frame.time / 3600:.1f} h, largest difference", np.abs(saturation - exact).max(), 0, 0.002, run=run)
    left = solution[-1][1]
    yield Row(title, "water drained in 8 h, per area", run.summary["water"]["left"] / 1000 / 0.02, left, 0.002 * left, "m", run=run)
    yield budget_row(title, run)


def check_discharge(runner):
    run = runner.run("seeping_darcy", "darcy/case.toml", stage__flow__water=SEEPS)
    exact = 0.3 * 0.4 / (1 / 1e-4 + 1 / 4e-5)
    yield Row("Darcy flow through two layers", "top.outflow", run.table()["top.outflow"][-1], exact, 1e-3 * exact, "m³/s", run=run)
    yield budget_row("Darcy flow through two layers", run)
    for size in (0.5, 1):
        run = runner.run(f"seeping_dam_{size}", "dam/case.toml", mesh__size=size, stage__flow__water=SEEPS)
        title = f"dam, {size} m, from the steady state"
        history, solver = run.table(), run.summary["seepage"]["inflow"] / dam.DISCHARGE
        yield Row(title, "outflow over Dupuit's, beside that of the seepage solver", history["right.outflow"][-1] / dam.DISCHARGE, solver, 0.02 * size,
                  run=run)
        yield budget_row(title, run)


def check(runner, draw):
    figure, axes = draw(2)
    rows = check_steady(runner, axes[0]) + check_settling(runner, axes[1])
    for part in (check_rest, check_terzaghi, check_infiltration, check_drainage, check_discharge):
        rows += part(runner)
    return rows, figure
