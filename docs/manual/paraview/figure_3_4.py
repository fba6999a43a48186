#!/usr/bin/env pvpython
# SPDX-License-Identifier: MIT
"""Draws displacement at four levels of strength reduction in ParaView, as Figure 3.4 of the source.

Usage: pvpython figure_3_4.py RESULTS_DIR OUT_DIR [--srf A B C D] [--after SECONDS] [--width PIXELS] [--shared]

RESULTS_DIR is what `talus run examples/dry_slope/case.toml` wrote. Into OUT_DIR go one picture for each panel, all
panels in one picture, and figure_3_4.pvsm, the same as a state that ParaView opens. Without a screen:
xvfb-run -a pvpython figure_3_4.py ...
"""
import argparse
import json
import math
import os
import sys

from paraview import simple

RADIUS = 0.95  # of a point's disc, in sides of the square of its volume; 0.56 has the same area, the rest closes gaps
BLACK = [0.0, 0.0, 0.0]


def fail(sentence):
    sys.exit("figure_3_4: " + sentence)


def list_trials(folder):
    """Factor to folder of every trial whose frames can be opened."""
    trials = os.path.join(folder, "trials")
    names = sorted(os.listdir(trials)) if os.path.isdir(trials) else []
    found = {float(name[4:]): os.path.join(trials, name) for name in names
             if name.startswith("srf_") and os.path.exists(os.path.join(trials, name, "results.xdmf"))}
    if not found:
        fail(f"'{folder}' has no trials/srf_*/results.xdmf; give the folder of a strength reduction with a curve")
    return found


def read_summary(folder):
    """The outline's polygons [m] and the time [s] at which the strength was reduced."""
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    except OSError as error:
        fail(f"cannot read '{error.filename}': {error.strerror}; the run has not finished")
    if summary["input"]["geometry"]["dimension"]["value"] != 2:
        fail(f"'{folder}' is a case in three dimensions; this figure is a section")
    return summary["outlines"], summary["stages"][-1]["time"]


def show_points(source, view):
    """Shows points as discs whose radius [m] is the field `radius` of `source`."""
    shown = simple.Show(source, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.ShaderPreset = "Plain circle"
    shown.ScaleByArray, shown.SetScaleArray, shown.UseScaleFunction = 1, ["POINTS", "radius"], 0
    shown.GaussianRadius = 1
    return shown


def choose_text_size(view):
    return max(8, view.ViewSize[0] // 53)


def show_colours(shown, colours, view, title):
    """Shows the bar of colours below the section."""
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle, bar.Orientation = title, "", "Horizontal"
    bar.WindowLocation, bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = "Any Location", [0.2, 0.02], 0.6, 10
    bar.TitleColor = bar.LabelColor = BLACK
    bar.TitleFontSize = bar.LabelFontSize = choose_text_size(view)
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.3g", "%.3g"
    shown.SetScalarBarVisibility(view, True)


def show_title(source, view):
    title = simple.Show(source, view)
    title.Color, title.FontSize, title.WindowLocation = BLACK, choose_text_size(view), "Upper Center"


class Panel:
    """One view: the points of one trial at one time, coloured by displacement, over the original outline."""

    def __init__(self, srf, folder, outlines, view):
        self.srf, self.view = srf, view
        self.reader = simple.XDMFReader(registrationName=f"SRF {srf:.2f}",
                                        FileNames=[os.path.abspath(os.path.join(folder, "results.xdmf"))])
        self.reader.UpdatePipelineInformation()
        self.times = list(self.reader.TimestepValues)
        sized = simple.Calculator(Input=self.reader, ResultArrayName="radius", Function=f"{RADIUS}*sqrt(volume)")
        self.data = simple.Calculator(Input=sized)
        self.outlines = [simple.PolyLineSource(Points=[c for x, y in outline for c in (x, y, 0.0)], Closed=1)
                         for outline in outlines]

    def choose_time(self, wanted):
        """The frame nearest to `wanted` [s]; the last one when it is None."""
        self.time = self.times[-1] if wanted is None else min(self.times, key=lambda t: abs(t - wanted))

    def measure(self):
        """The range of the displacement [m] that ParaView sees at the chosen time."""
        self.reader.UpdatePipeline(self.time)
        self.range = self.reader.PointData["displacement"].GetRange(-1)
        return self.range

    def show(self, limits, after, letter):
        """Draws with the colours from 0 to limits[1], in m or, below 1 m, in mm."""
        name, scale = ("displacement [m]", 1) if limits[1] >= 1 else ("displacement [mm]", 1000)
        self.data.ResultArrayName, self.data.Function = name, f"{scale}*mag(displacement)"
        shown = show_points(self.data, self.view)
        simple.ColorBy(shown, ("POINTS", name), separate=True)
        colours = simple.GetColorTransferFunction(name, shown, separate=True)
        colours.ApplyPreset("Viridis (matplotlib)", True)
        colours.RescaleTransferFunction(0, scale * limits[1] or 1)
        show_colours(shown, colours, self.view, name)
        for outline in self.outlines:
            line = simple.Show(outline, self.view)
            line.AmbientColor = line.DiffuseColor = BLACK
            line.LineWidth = 2
            line.Position = [0, 0, 1]  # in front of the points
        show_title(simple.Text(Text=f"({letter})  SRF = {self.srf:.2f},  {after:.1f} s after the reduction,  "
                                    f"largest {scale * self.range[1]:.3g} {name.split('[')[1][:-1]}"), self.view)


def aim(view, outlines, size):
    """Looks at the same rectangle in every panel: the outline, with room for the title above and the colours below."""
    x, y = zip(*(corner for outline in outlines for corner in outline))
    width, height = max(x) - min(x), max(y) - min(y)
    half = max(0.62 * width * size[1] / size[0], 0.75 * height)
    centre = [(min(x) + max(x)) / 2, (min(y) + max(y)) / 2 - 0.2 * half]
    view.ViewSize = size
    view.UseColorPaletteForBackground, view.Background = 0, [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.InteractionMode, view.CameraParallelProjection, view.CameraParallelScale = "2D", 1, half
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = centre + [0], centre + [100], [0, 1, 0]
    view.CenterOfRotation = view.CameraFocalPoint
    grid = view.AxesGrid
    grid.Visibility, grid.XTitle, grid.YTitle, grid.ZTitle = 1, "x [m]", "y [m]", ""
    for axis in "XY":
        for part in ("Title", "Label"):
            setattr(grid, f"{axis}{part}Color", BLACK)
            setattr(grid, f"{axis}{part}FontSize", choose_text_size(view) - 2)
    grid.GridColor = BLACK
    grid.AxesToLabel = 1 + 2  # the lower x axis and the left y axis


def draw(results, out, factors=(1.45, 1.60, 1.70, 1.75), after=None, width=1600, shared=False):
    """Writes the pictures and the state; returns the panels, whose `times` and `range` are what ParaView has read."""
    trials = list_trials(results)
    for srf in factors:
        if srf not in trials:
            fail(f"'{results}' has no trial at {srf:g}; it has {', '.join(f'{known:g}' for known in trials)}")
    outlines, start = read_summary(results)
    os.makedirs(out, exist_ok=True)
    columns = 2 if len(factors) > 1 else 1
    size = [width // columns, width // columns // 2]  # of a panel
    rows = math.ceil(len(factors) / columns)
    whole = [size[0] * columns, size[1] * rows]
    simple._DisableFirstRenderCameraReset()  # as ParaView's own traces do: the camera is aimed below
    layout = simple.CreateLayout("Figure 3.4")
    panels = []
    for srf in factors:
        view = simple.CreateRenderView()
        panels.append(Panel(srf, trials[srf], outlines, view))
    place_views(layout, [panel.view for panel in panels], columns, rows)
    layout.SetSize(*whole)
    for panel in panels:
        panel.choose_time(None if after is None else start + after)
        panel.measure()
    simple.GetAnimationScene().AnimationTime = max(panel.time for panel in panels)
    largest = max(panel.range[1] for panel in panels)
    for panel, letter in zip(panels, "abcdefghijklmnopqrstuvwxyz"):
        panel.view.ViewTime = panel.time
        aim(panel.view, outlines, size)
        panel.show((0, largest) if shared else panel.range, panel.time - start, letter)
        simple.Render(panel.view)
        panel.picture = os.path.join(out, f"panel_{letter}_srf_{panel.srf:.4f}.png")
        simple.SaveScreenshot(panel.picture, panel.view, ImageResolution=size)
        print(f"{panel.picture}: frame at {panel.time:.3f} s of {len(panel.times)}, largest {panel.range[1]:.6g} m")
    simple.SaveScreenshot(os.path.join(out, "figure_3_4.png"), layout, ImageResolution=whole)
    simple.SaveState(os.path.join(out, "figure_3_4.pvsm"))
    return panels


def place_views(layout, views, columns, rows):
    """Puts the views into a grid, row by row: halves of halves, as ParaView's layouts are."""
    cells, rest = [], 0
    for row in range(rows):
        first = rest
        if row + 1 < rows:
            first = layout.SplitVertical(rest, 1 / (rows - row))
            rest = first + 1
        if columns == 2:
            first = layout.SplitHorizontal(first, 0.5)
            cells += [first, first + 1]
        else:
            cells.append(first)
    for view, cell in zip(views, cells):
        layout.AssignView(cell, view)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", metavar="RESULTS_DIR")
    parser.add_argument("out", metavar="OUT_DIR")
    parser.add_argument("--srf", type=float, nargs="+", default=[1.45, 1.60, 1.70, 1.75], help="factors of the panels")
    parser.add_argument("--after", type=float, help="seconds after the reduction (default: each trial's last frame)")
    parser.add_argument("--width", type=int, default=1600, help="of the composed picture [pixels]")
    parser.add_argument("--shared", action="store_true", help="one range of colours for all panels")
    given = parser.parse_args()
    draw(given.results, given.out, given.srf, given.after, given.width, given.shared)
