#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Opens results.xdmf (and mesh.xdmf) in ParaView and compares what it shows with what h5py reads from the HDF5 file.

Usage: open_in_paraview.py FOLDER
Started by plain Python it runs itself in pvpython. Exit codes: 0 all is equal, 1 not, 77 ParaView is not there.
"""
import os
import shutil
import subprocess
import sys


def compare(folder, stem, reader_name):
    import h5py
    import numpy as np
    from paraview import servermanager, simple
    from vtk.util.numpy_support import vtk_to_numpy

    path = os.path.join(folder, stem + ".xdmf")
    reader = simple.XDMFReader(FileNames=[path]) if reader_name == "XDMFReader" else \
        getattr(simple, reader_name)(FileName=path)
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    with h5py.File(os.path.join(folder, stem + ".vtkhdf"), "r") as file:
        root = file["VTKHDF"]
        steps = root["Steps"]
        counts = root["NumberOfPoints"][:][steps["PartOffsets"][:]]
        shown = [i for i in range(len(counts)) if counts[i] > 0]
        wanted = [float(steps["Values"][i]) for i in shown]
        assert np.array_equal(times, wanted), f"{stem}: times {times}, expected {wanted}"
        for i, time in zip(shown, times):
            reader.UpdatePipeline(time)
            grid = servermanager.Fetch(reader)
            part, first = int(steps["PartOffsets"][i]), int(steps["PointOffsets"][i])
            assert grid.GetNumberOfPoints() == counts[i], f"{stem}: {grid.GetNumberOfPoints()} points at {time} s"
            assert grid.GetNumberOfCells() == root["NumberOfCells"][part], f"{stem}: cells at {time} s"
            points = vtk_to_numpy(grid.GetPoints().GetData())
            assert np.array_equal(points, root["Points"][first:first + counts[i]]), f"{stem}: points at {time} s"
            last = grid.GetCell(grid.GetNumberOfCells() - 1)
            begin = int(steps["ConnectivityIdOffsets"][i])
            ids = root["Connectivity"][begin:begin + int(root["NumberOfConnectivityIds"][part])]
            nodes = [last.GetPointId(k) for k in range(last.GetNumberOfPoints())]
            assert nodes == list(ids[-len(nodes):]), f"{stem}: the last cell at {time} s"
            for group, shown_data, rows in (("Point", grid.GetPointData(), counts[i]),
                                            ("Cell", grid.GetCellData(), grid.GetNumberOfCells())):
                for name, data in root[group + "Data"].items():
                    begin = int(steps[group + "DataOffsets"][name][i])
                    array = shown_data.GetArray(name)
                    assert array is not None, f"{stem}: '{name}' is not shown"
                    values = vtk_to_numpy(array)
                    assert np.array_equal(values, data[begin:begin + rows], equal_nan=data.dtype.kind == "f"), \
                        f"{stem}: '{name}' at {time} s"
    print(f"{stem}.xdmf, {reader_name}: {len(times)} times, all points, cells and fields as stored")


def main():
    folder = sys.argv[1]
    try:
        import paraview  # noqa: F401
    except ImportError:
        program = shutil.which("pvpython")
        if program is None or os.environ.get("TALUS_IN_PARAVIEW"):
            print("SKIPPED: ParaView (pvpython) is not installed; the XDMF file was NOT opened")
            sys.exit(77)
        environment = dict(os.environ, TALUS_IN_PARAVIEW="1", QT_QPA_PLATFORM="offscreen")
        sys.exit(subprocess.run([program, "--force-offscreen-rendering", __file__, folder], env=environment).returncode)
    try:
        import h5py  # noqa: F401
    except ImportError:
        print("SKIPPED: python3-h5py is not installed; the XDMF file was NOT opened")
        sys.exit(77)
    for reader_name in ("XDMFReader", "Xdmf3ReaderS", "Xdmf3ReaderT"):  # a user may choose any of the three
        compare(folder, "results", reader_name)
        if os.path.exists(os.path.join(folder, "mesh.xdmf")):
            compare(folder, "mesh", reader_name)


if __name__ == "__main__":
    main()
