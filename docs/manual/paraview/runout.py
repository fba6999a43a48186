#!/usr/bin/env pvpython
# SPDX-License-Identifier: MIT
"""Shows one trial in ParaView: the band of large strain, a movie, and the way of one point over time.

Usage: pvpython runout.py RESULTS_DIR OUT_DIR [--srf 1.75] [--strain 0.1] [--point ID] [--width PIXELS]

Writes band.png, movie.avi and point.csv (time, displacement) into OUT_DIR. Only a trial with a runout has a movie.
Without a screen: xvfb-run -a pvpython runout.py ...
"""
import argparse
import csv
import os
import sys

from paraview import servermanager, simple

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from figure_3_4 import (RADIUS, aim, fail, list_trials, read_summary, show_colours, show_points,  # noqa: E402
                        show_title)


def show_band(sized, view, strain):
    """All soil in grey, and in front of it, in colour, what is strained by more than `strain`."""
    soil = show_points(sized, view)
    simple.ColorBy(soil, None)
    soil.AmbientColor = soil.DiffuseColor = [0.82, 0.80, 0.76]
    band = simple.Threshold(registrationName="band", Input=sized, Scalars=["POINTS", "deviatoric_strain"])
    band.ThresholdMethod, band.UpperThreshold = "Above Upper Threshold", strain
    band.UpdatePipeline(view.ViewTime)
    shown = show_points(band, view)
    shown.Position = [0, 0, 0.5]
    simple.ColorBy(shown, ("POINTS", "deviatoric_strain"))
    colours = simple.GetColorTransferFunction("deviatoric_strain")
    colours.ApplyPreset("Inferno (matplotlib)", True)
    show_colours(shown, colours, view, "deviatoric strain [-]")
    return band, colours


def follow(reader, view, identity):
    """Rows of time [s] and displacement [m] of the point with this `id`, in every frame in which it is there."""
    simple.Show(reader, view)  # a selection by query needs a source that is shown
    simple.QuerySelect(QueryString=f"(id == {identity})", FieldType="POINT", Source=reader)
    plot = simple.PlotSelectionOverTime(Input=reader, Selection=reader.GetSelectionInput(reader.Port))
    plot.UpdatePipeline()
    blocks = servermanager.Fetch(plot)
    simple.ClearSelection(reader)
    simple.Hide(reader, view)
    if blocks.GetNumberOfBlocks() == 0:
        fail(f"there is no point with the id {identity}")
    table = blocks.GetBlock(0)
    times, lengths = table.GetColumnByName("Time"), table.GetColumnByName("avg(displacement (Magnitude))")
    return [(times.GetValue(i), lengths.GetValue(i)) for i in range(table.GetNumberOfRows())]


def draw(results, out, srf=1.75, strain=0.1, identity=None, width=1200):
    """Writes the picture, the movie and the table; returns the reader, the band's filter and the table's rows."""
    trials = list_trials(results)
    if srf not in trials:
        fail(f"'{results}' has no trial at {srf:g}; it has {', '.join(f'{known:g}' for known in trials)}")
    outlines, _ = read_summary(results)
    os.makedirs(out, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateRenderView()
    reader = simple.XDMFReader(FileNames=[os.path.abspath(os.path.join(trials[srf], "results.xdmf"))])
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    sized = simple.Calculator(Input=reader, ResultArrayName="radius", Function=f"{RADIUS}*sqrt(volume)")
    rows = follow(reader, view, identity) if identity is not None else []
    size = [width, width // 2]
    aim(view, outlines, size)
    view.ViewTime = times[-1]
    sized.UpdatePipeline(times[-1])
    band, colours = show_band(sized, view, strain)
    largest = sized.PointData["deviatoric_strain"].GetRange()[1]
    colours.RescaleTransferFunction(strain, max(largest, 1.01 * strain))  # of the last frame, for the movie too
    show_title(simple.AnnotateTimeFilter(Input=reader, Format=f"SRF = {srf:.2f},  t = {{time:.2f}} s,  "
                                         f"deviatoric strain above {strain:g}"), view)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().AnimationTime = times[-1]
    simple.SaveScreenshot(os.path.join(out, "band.png"), view, ImageResolution=size)
    if len(times) > 1:
        simple.SaveAnimation(os.path.join(out, "movie.avi"), view, ImageResolution=size, FrameRate=10,
                             FrameWindow=[0, len(times) - 1])
    if rows:
        with open(os.path.join(out, "point.csv"), "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([("time [s]", "displacement [m]")] + rows)
    return reader, band, rows


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", metavar="RESULTS_DIR")
    parser.add_argument("out", metavar="OUT_DIR")
    parser.add_argument("--srf", type=float, default=1.75, help="factor of the trial")
    parser.add_argument("--strain", type=float, default=0.1, help="smallest deviatoric strain that is coloured")
    parser.add_argument("--point", type=int, help="id of the point that is followed")
    parser.add_argument("--width", type=int, default=1200, help="of the picture [pixels]")
    given = parser.parse_args()
    draw(given.results, given.out, given.srf, given.strain, given.point, given.width)
