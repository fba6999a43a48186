# SPDX-License-Identifier: MIT
"""Water that seeps, with pressures at the nodes: steady discharge beside the seepage solver, and a soft column that settles."""
import numpy as np

from .runs import WATER_WEIGHT, Row, budget_row
from .still import SETTLEMENT

SEEPS = '"seeps"'
REAL = '"2.2 GPa"'
#: problem, file, sizes of the elements [m]
STEADY = (("flow round a corner", "corner/case.toml", (0.1, 0.05, 0.025)), ("flow under a sheet pile", "sheet_pile/case.toml", (0.1, 0.05)))
#: name, what is changed, mass scaling
WATERS = (("water of 20 MPa", {}, 1000), ("water of 2.2 GPa", {"water__bulk_modulus": REAL}, 1000),
          ("water of 2.2 GPa, a third of the step", {"water__bulk_modulus": REAL}, 100))
COARSE = "the outermost element is integrated where its points are"
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


def check(runner, draw):
    figure, axes = draw(2)
    return check_steady(runner, axes[0]) + check_settling(runner, axes[1]), figure
