# SPDX-License-Identifier: MIT
"""The figure: three moments of three slides, displacement, how far up the slope has gone, and the transducers."""
import matplotlib.pyplot as plt
import numpy as np

from .results import STAGES, TRANSDUCERS
from .table import PUBLISHED

GROUND = ([0, 0.2, 0.6, 0.8], [0.08, 0.08, 0.48, 0.48])
LINES = {"fallow": ("#b35900", "-"), "rooted": ("#2b6a2b", "-"),
         "fallow, K0 = 0.6": ("#b35900", "--"), "rooted, K0 = 0.6": ("#2b6a2b", "--")}
SHOWN = ("fallow", "fallow, K0 = 0.6", "rooted, K0 = 0.6")


def choose_moments(results, frames):
    """12 and 35 s after movement begins, and the end."""
    begin = results.onset or results.raised_at[-1]
    wanted = (begin + 12, begin + 35, results.time[-1])
    return [min(range(len(frames)), key=lambda i: abs(frames[i]["time"] - t)) for t in wanted]


def draw_moment(axes, frame, label, roots):
    order = np.argsort(frame["deviatoric_strain"])
    dots = axes.scatter(*frame["points"][order].T, c=frame["deviatoric_strain"][order], s=9, marker="s", cmap="viridis",
                        vmin=0, vmax=1, linewidths=0, antialiased=False)
    axes.plot(*GROUND, "k--", linewidth=0.6)
    if roots:  # the lower edge of the layer at the start, bent on the bisectors
        depth = roots[0]["depth"]["value"]
        shift = depth * np.tan(np.pi / 8)
        axes.plot([0, 0.2 + shift, 0.6 + shift, 0.8], np.array(GROUND[1]) - depth, "r-", linewidth=0.7)
    axes.set(xlim=(0, 0.8), ylim=(0, 0.5), aspect="equal")
    axes.set_title(label, fontsize=8)
    return dots


def draw(runs):
    figure = plt.figure(figsize=(10, 9), layout="constrained")
    grid = figure.add_gridspec(4, 3)
    frames = {name: r.frames() for name, r in runs.items()}
    pictures = []
    for row, name in enumerate(SHOWN):
        r = runs[name]
        for column, i in enumerate(choose_moments(r, frames[name])):
            frame = frames[name][i]
            pictures.append(figure.add_subplot(grid[row, column]))
            label = f"{name}: {frame['time']:.0f} s (rise {r.stage_at(frame['time'] - 1)})"
            dots = draw_moment(pictures[-1], frame, label, r.summary["input"].get("roots"))
    figure.colorbar(dots, ax=pictures, label="deviatoric strain", shrink=0.5, aspect=30, pad=0.01)
    moved, height, pressure = (figure.add_subplot(grid[3, k]) for k in range(3))
    for name, r in runs.items():
        colour, style = LINES[name]
        moved.plot(r.time, r.displacement * 1e3, color=colour, linestyle=style, label=name)
        height.plot([f["time"] for f in frames[name]], r.highest_moved(frames[name])[0], color=colour, linestyle=style,
                    drawstyle="steps-post")
    for name, value in (("fallow", 245), ("rooted", 135)):
        moved.axhline(value, color=LINES[name][0], linewidth=0.8, linestyle=":", label=f"published, {name}")
    moved.set(xlabel="time [s]", ylabel="displacement [mm]", title="monitored point (0.25, 0.12)")
    moved.legend(loc="upper left")
    height.set(xlabel="time [s]", ylabel="its y at the start [m]", title="highest soil that has moved 20 mm",
               ylim=(0.06, 0.4))
    for i, letter in enumerate(TRANSDUCERS):
        r = runs["fallow"]
        pressure.plot(r.time, r.monitors[f"{letter}.pore_pressure"], color=f"C{i}", linewidth=0.9, label=letter)
        published = [PUBLISHED[stage][i] for stage in STAGES]
        pressure.plot(r.hold_ends(), published, "x", color=f"C{i}", markersize=5)
    pressure.set(xlabel="time [s]", ylabel="pore pressure [kPa]", title="transducers, fallow (×: published)",
                 ylim=(8, 55))
    pressure.legend(ncols=4, loc="upper left")
    for axes in (moved, height, pressure):
        for at in runs["fallow"].raised_at:
            axes.axvline(at, color="0.6", linewidth=0.6, linestyle="--")
    return figure
