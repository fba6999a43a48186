#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks the layout of a VTKHDF time series against the specification, with nothing of this program's own.

Usage: read_with_h5py.py FILE
https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/vtkhdf_specifications.html
Exit codes: 0 the file holds to the specification, 1 it does not (each fault is a line), 77 h5py is not there.
"""
import sys

try:
    import h5py
    import numpy as np
except ImportError as missing:
    print(f"SKIPPED: {missing}")
    sys.exit(77)

NODES = {1: 1, 5: 3, 10: 4}  # VTK's numbers of the cell types and their nodes
faults = []


def require(condition, sentence):
    if not condition:
        faults.append(sentence)


def check_step(root, steps, i):
    """The grid and every field of step i lie inside their datasets and fit each other."""
    part = int(steps["PartOffsets"][i])
    require(steps["NumberOfParts"][i] == 1, f"step {i}: NumberOfParts is not 1")
    points, cells, ids = (int(root[name][part])
                          for name in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"))
    first_point, first_cell, first_id = (int(steps[name][i])
                                         for name in ("PointOffsets", "CellOffsets", "ConnectivityIdOffsets"))
    require(root["Points"][first_point:first_point + points].shape == (points, 3), f"step {i}: points are missing")
    types = root["Types"][first_cell:first_cell + cells]
    offsets = root["Offsets"][first_cell + part:first_cell + part + cells + 1].astype(int)
    connectivity = root["Connectivity"][first_id:first_id + ids]
    require(len(types) == cells and len(offsets) == cells + 1 and len(connectivity) == ids,
            f"step {i}: cells are missing")
    require(offsets[0] == 0 and offsets[-1] == ids, f"step {i}: offsets do not span the connectivity")
    require(all(np.diff(offsets) == [NODES[t] for t in types]), f"step {i}: offsets do not fit the cell types")
    require(ids == 0 or (connectivity.min() >= 0 and connectivity.max() < points), f"step {i}: a node is not there")
    for group, rows in (("Point", points), ("Cell", cells)):
        for name, data in root[group + "Data"].items():
            first = int(steps[group + "DataOffsets"][name][i])
            require(first + rows <= data.shape[0], f"step {i}: '{name}' is too short")


def check(path):
    with h5py.File(path, "r") as file:
        root = file["VTKHDF"]
        require(list(root.attrs["Version"]) == [2, 0], "Version is not [2, 0]")
        kind = root.attrs.get_id("Type")
        require(root.attrs["Type"] == b"UnstructuredGrid", "Type is not UnstructuredGrid")
        require(kind.get_type().get_class() == h5py.h5t.STRING and not kind.get_type().is_variable_str()
                and kind.get_type().get_cset() == h5py.h5t.CSET_ASCII, "Type is not a fixed ASCII text")
        steps = root["Steps"]
        count = int(steps.attrs["NSteps"])
        require(np.all(np.diff(steps["Values"][:]) >= 0), "times do not grow")
        for name in ("Values", "PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"):
            require(steps[name].shape[0] == count, f"{name} has not one entry a step")
        for name in ("Connectivity", "Offsets", "NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"):
            require(root[name].dtype == np.int64, f"{name} is not 64-bit")
        require(root["Types"].dtype == np.uint8, "Types are not bytes")
        require(root["Points"].dtype == np.float64, "Points are not doubles")
        for group in ("Point", "Cell"):
            require(set(root[group + "Data"]) == set(steps[group + "DataOffsets"]),
                    f"{group}Data and its offsets name different fields")
            for name, data in root[group + "Data"].items():
                require("unit" in data.attrs, f"'{name}' has no unit")
                require(data.compression == "gzip" and data.shuffle, f"'{name}' is not compressed")
        for i in range(count):
            check_step(root, steps, i)
        return count


if __name__ == "__main__":
    number = check(sys.argv[1])
    for fault in faults:
        print(f"{sys.argv[1]}: {fault}")
    print(f"{number} steps, {len(faults)} faults")
    sys.exit(1 if faults else 0)
