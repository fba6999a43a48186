#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws docs/manual/paraview/figure_3_4.py's panels of a small run in ParaView and compares them with the HDF5 files.

Usage: figure_3_4.py TALUS_PROGRAM SOURCE_DIR
Started by plain Python it calculates the run and starts itself once in pvpython. Exit codes: 0 all is equal, 1 not,
77 something is not installed; the reason is printed as GoogleTest prints it, so that tools/test.sh names it.
"""
import contextlib
import os
import shutil
import subprocess
import sys
import tempfile

FACTORS = (1.45, 1.60, 1.70, 1.75)
YELLOW = (253, 231, 37)  # the upper end of viridis


def skip(reason):
    print(f"figure_3_4.py: Skipped\n{reason}: the figure was NOT drawn in ParaView")
    sys.exit(77)


@contextlib.contextmanager
def find_screen():
    """The name of an X display, for Debian's ParaView draws through X only: one of our own, or else the user's.

    Not xvfb-run: its server ends after it does, and takes away the display of the next one that starts."""
    if shutil.which("Xvfb") is None:
        if not os.environ.get("DISPLAY"):
            skip("there is no screen, and xvfb is not installed")
        yield os.environ["DISPLAY"]
        return
    answer, question = os.pipe()
    # -noreset: ParaView opens and closes connections, and a server that starts anew meanwhile refuses the next one.
    server = subprocess.Popen(["Xvfb", "-displayfd", str(question), "-screen", "0", "1600x1200x24", "-nolisten", "tcp", "-noreset"],
                              pass_fds=[question], stderr=subprocess.DEVNULL)
    os.close(question)
    try:
        with os.fdopen(answer) as pipe:
            number = pipe.readline().strip()  # comes when the server listens; empty when it has ended
        if not number:
            raise RuntimeError("Xvfb does not start")
        yield ":" + number
    finally:
        server.terminate()
        server.wait()


def read_stored(folder):
    """Times [s], and for every frame the positions [m] and lengths of the displacements [m], with h5py alone."""
    import h5py
    import numpy as np

    with h5py.File(os.path.join(folder, "results.vtkhdf"), "r") as file:
        grid, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        frames = []
        for i in range(len(steps["Values"])):
            count = grid["NumberOfPoints"][steps["PartOffsets"][i]]
            first, at = steps["PointDataOffsets/displacement"][i], steps["PointOffsets"][i]
            frames.append((grid["Points"][at:at + count],
                           np.linalg.norm(grid["PointData/displacement"][first:first + count], axis=1)))
        return list(steps["Values"]), frames


def read_picture(path):
    """Red, green and blue of a PNG file, the first row at the bottom."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


def check_values(panel, stored_times, frames, time):
    """ParaView has read the times and, at the panel's frame, the displacements that the file holds."""
    assert panel.times == stored_times, f"SRF {panel.srf}: times {panel.times}, stored {stored_times}"
    i = min(range(len(stored_times)), key=lambda k: abs(stored_times[k] - time))
    assert panel.time == stored_times[i], f"SRF {panel.srf}: frame at {panel.time} s instead of {stored_times[i]} s"
    lengths = frames[i][1]
    for seen, stored in zip(panel.range, (lengths.min(), lengths.max())):
        assert abs(seen - stored) <= 1e-6 * lengths.max(), f"SRF {panel.srf}: ParaView sees {seen} m, stored {stored} m"
    return frames[i]


def check_picture(panel, positions, lengths):
    """The soil fills its ground, its discs end within half a metre of it, and the soil that moved most is yellow."""
    import numpy as np

    picture = read_picture(panel.picture)
    height, width, _ = picture.shape
    metre = height / (2 * panel.view.CameraParallelScale)  # pixels
    centre = panel.view.CameraFocalPoint

    def find_pixel(x, y):
        return int(round(width / 2 + (x - centre[0]) * metre)), int(round(height / 2 + (y - centre[1]) * metre))

    coloured = picture.max(axis=2) - picture.min(axis=2) > 30
    left, bottom = find_pixel(0.5, 0.5)
    right, top = find_pixel(43.5, 4.0)
    ground = coloured[bottom:top, left:right].mean()
    assert ground > 0.98, f"SRF {panel.srf}: {100 * ground:.1f} % of the ground is drawn"
    left, bottom = find_pixel(36, 5.5)
    right, top = find_pixel(43, 14)
    air = coloured[bottom:top, left:right].mean()
    assert air < 0.001, f"SRF {panel.srf}: {100 * air:.1f} % of the air is drawn"
    column, row = find_pixel(*positions[lengths.argmax()][:2])
    near = picture[row - 4:row + 5, column - 4:column + 5].reshape(-1, 3)
    distance = np.abs(near - YELLOW).sum(axis=1).min()
    assert distance < 30, f"SRF {panel.srf}: the soil that moved most has another colour"
    return picture


def check_history(folder, times, frames):
    """runout.py follows one point through all frames, finds the strained soil, and makes a movie."""
    import h5py
    import runout

    out = os.path.join(folder, "runout")
    with h5py.File(os.path.join(folder, "trials", "srf_1.7500", "results.vtkhdf"), "r") as file:
        data, steps = file["VTKHDF/PointData"], file["VTKHDF/Steps/PointDataOffsets"]
        count = len(frames[-1][1])
        row = int(frames[-1][1].argmax())
        identity = int(data["id"][steps["id"][-1] + row])
        strained = int((data["deviatoric_strain"][steps["deviatoric_strain"][-1]:][:count] > 0.05).sum())
        stored = []
        for i, (_, lengths) in enumerate(frames):
            ids = list(data["id"][steps["id"][i]:steps["id"][i] + len(lengths)])
            stored.append((times[i], lengths[ids.index(identity)]))
    _, band, rows = runout.draw(folder, out, 1.75, 0.05, identity, width=600)
    assert len(rows) == len(stored), f"{len(rows)} rows, {len(stored)} frames"
    for seen, kept in zip(rows, stored):
        assert seen[0] == kept[0] and abs(seen[1] - kept[1]) <= 1e-6 * stored[-1][1], f"{seen}, stored {kept}"
    assert 0 < strained < count and band.GetDataInformation().GetNumberOfPoints() == strained, f"{strained} strained"
    for name in ("band.png", "movie.avi", "point.csv"):
        assert os.path.getsize(os.path.join(out, name)) > 100, f"{name} is empty"


def check_figure(folder, source):
    """Runs inside pvpython: draws, then compares."""
    import json
    try:
        import h5py  # noqa: F401
    except ImportError:
        skip("pvpython has no h5py (python3-h5py)")

    sys.path.insert(0, os.path.join(source, "docs", "manual", "paraview"))
    import figure_3_4

    out = os.path.join(folder, "figure")
    try:
        figure_3_4.draw(folder, out, (1.45, 3.21))
        raise AssertionError("a factor that was not calculated is drawn")
    except SystemExit as error:
        assert "no trial at 3.21; it has 1.4, 1.45," in str(error.code), error.code
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        reduced = json.load(file)["stages"][-1]["time"]

    panels = figure_3_4.draw(folder, out, FACTORS, width=1200)
    assert [panel.srf for panel in panels] == list(FACTORS)
    pictures = []
    for panel in panels:
        times, frames = read_stored(os.path.join(folder, "trials", f"srf_{panel.srf:.4f}"))
        assert (len(times) > 1) == (panel.srf == 1.75), "only the trial with a runout has several frames"
        pictures.append(check_picture(panel, *check_values(panel, times, frames, times[-1])))
    whole = read_picture(os.path.join(out, "figure_3_4.png"))
    for number, picture in enumerate(pictures):
        assert all((picture != other).any() for other in pictures[:number]), "two panels are the same picture"
        rows, columns, _ = picture.shape
        first_row, first_column = (1 - number // 2) * rows, number % 2 * columns  # rows are counted from below
        part = whole[first_row:first_row + rows, first_column:first_column + columns]
        equal = (abs(part - picture).max(axis=2) < 30).mean()
        assert part.shape == picture.shape and equal > 0.9, f"panel {number} is not in its place in the composed figure"
    assert os.path.getsize(os.path.join(out, "figure_3_4.pvsm")) > 1000

    earlier, = figure_3_4.draw(folder, os.path.join(folder, "earlier"), (1.75,), after=2.0, width=600)
    check_picture(earlier, *check_values(earlier, times, frames, reduced + 2.0))
    check_history(folder, times, frames)
    print(f"{len(panels)} panels and one earlier frame, a band and a point: as stored, and pictures as they should be")


def main():
    program, source = sys.argv[1:3]
    inside = os.environ.get("TALUS_FIGURE_FOLDER")
    if inside:
        check_figure(inside, source)
        return
    if shutil.which("pvpython") is None:
        skip("ParaView (pvpython) is not installed")
    with find_screen() as screen, tempfile.TemporaryDirectory(prefix="talus-figure-") as folder:
        changes = [f"--set={change}" for change in (
            "mesh.size=1.5", "strength_reduction.curve.from=1.4", "strength_reduction.curve.refine=false",
            "strength_reduction.frozen.enabled=false")]
        subprocess.run([program, "run", os.path.join(source, "examples", "dry_slope", "case.toml"), "-q", "--overwrite",
                        "-o", folder, "--threads", "2"] + changes, check=True)
        environment = dict(os.environ, TALUS_FIGURE_FOLDER=folder, DISPLAY=screen, PYTHONDONTWRITEBYTECODE="1")
        sys.exit(subprocess.run(["pvpython", "--force-offscreen-rendering", os.path.abspath(__file__), program, source],
                                env=environment).returncode)


if __name__ == "__main__":
    main()
