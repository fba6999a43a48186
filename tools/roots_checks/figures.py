# SPDX-License-Identifier: MIT
"""The figures: displacements (4.7), preconsolidation (4.6), deviatoric strain (4.8 to 4.11), and softer water
with mass scaling."""
import matplotlib.pyplot as plt
import numpy as np

from .runs import MONITORS

GROUND = ([0, 3, 7, 11], [5, 5, 1, 1])
LAYER = ([0, 2.7929, 6.7929, 11], [4.5, 4.5, 0.5, 0.5])
COLOURS = {"toe": "#b2182b", "mid_face": "#e08214", "crest": "#2166ac"}
STRAIN_TIMES, SECTION_TIMES, SECTIONS = (0, 200, 400, 560), (0, 40, 120, 230, 560), (2, 4)


def draw_histories(slopes, threshold):
    figure, axes = plt.subplots(1, 4, figsize=(11, 2.9), layout="constrained", sharey=True)
    for a, (name, r) in zip(axes, slopes.items()):
        for monitor in MONITORS:
            time, moved = r.history(monitor)
            a.plot(time, moved, color=COLOURS[monitor], label=monitor.replace("_", "-"))
            if r.onset(monitor) is not None:
                a.plot(r.onset(monitor), threshold, "o", color=COLOURS[monitor], ms=3)
        a.set(title=name if name == "bare" else f"{name} roots", xlabel="time [s]", xlim=(0, 560))
        a.axhline(threshold, color="k", lw=0.4, ls=":")
    axes[0].set(ylabel="displacement [m]")
    axes[0].legend()
    return figure


def draw_profiles(slopes):
    figure, axes = plt.subplots(1, 4, figsize=(11, 3.6), layout="constrained", sharey=True)
    pairs = [(name, x) for x in SECTIONS for name in ("bare", "1.29 %")]
    colours = plt.get_cmap("viridis")(np.linspace(0, 0.9, len(SECTION_TIMES)))
    for a, (name, x) in zip(axes, pairs):
        for time, colour in zip(SECTION_TIMES, colours):
            y, value = slopes[name].profile(time, "preconsolidation_pressure", x)
            a.plot(value / 1e3, y, "o-", ms=2, lw=1, color=colour, label=f"{time} s")
        a.axvline(50, color="k", lw=0.6, ls=":")
        a.set(title=f"{name}, x = {x} m", xlabel="$p'_c$ [kPa]", xscale="log", xlim=(10, 5000), ylim=(0, 5.2))
    axes[0].set(ylabel="height [m]")
    axes[0].legend(loc="lower left")
    return figure


def draw_strain(slopes):
    figure, axes = plt.subplots(4, 4, figsize=(11, 5.6), layout="constrained", sharex=True, sharey=True)
    for row, (name, r) in zip(axes, slopes.items()):
        for a, time in zip(row, STRAIN_TIMES):
            frame = r.frame(time)
            order = np.argsort(frame["deviatoric_strain"])
            dots = a.scatter(*frame.points[order, :2].T, c=frame["deviatoric_strain"][order], s=5, cmap="viridis", vmin=0, vmax=0.5,
                             linewidths=0)
            a.plot(*GROUND, "k--", lw=0.5)
            a.plot(*LAYER, "w:", lw=0.5)
            a.set(xlim=(0, 11), ylim=(0, 5.4), aspect="equal")
            if r is next(iter(slopes.values())):
                a.set_title(f"{time} s")
        row[0].set_ylabel(name)
    figure.colorbar(dots, ax=axes, label="deviatoric strain", shrink=0.6, extend="max")
    return figure


def draw_crutches(variants):
    """variants: name to {content: run}, the case as it stands first."""
    figure, axes = plt.subplots(1, 2, figsize=(11, 3.1), layout="constrained")
    for i, (name, runs) in enumerate(variants.items()):
        for a, (content, r) in zip(axes, runs.items()):
            if r is None:
                continue
            a.plot(*r.history("mid_face"), lw=1.6 if i == 0 else 1, color="k" if i == 0 else f"C{i - 1}", label=name)
            a.set(title=f"mid-face, {content}", xlabel="time [s]", ylabel="displacement [m]", xlim=(250, 560), ylim=(0, 1.6))
    axes[0].legend(fontsize=6)
    return figure
