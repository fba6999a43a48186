#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the mesh of a box of soil, each cell split once into two triangles, in Gmsh's format 4.1.

Usage: tools/make_box_mesh.py CELLS_X CELLS_Y WIDTH HEIGHT FILE
The region is called soil, the sides left, right, bottom and top. Lengths are in metres.
"""
import pathlib
import sys


def write_box(nx, ny, width, height, path):
    def node(i, j):
        return j * (nx + 1) + i + 1

    sides = {  # name: (nodes in order, corners of its curve)
        "bottom": ([node(i, 0) for i in range(nx + 1)], (1, 2)),
        "right": ([node(nx, j) for j in range(ny + 1)], (2, 3)),
        "top": ([node(i, ny) for i in range(nx, -1, -1)], (3, 4)),
        "left": ([node(0, j) for j in range(ny, -1, -1)], (4, 1)),
    }
    triangles = []
    for j in range(ny):
        for i in range(nx):
            a, b, c, d = node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
    corners = [(0, 0), (width, 0), (width, height), (0, height)]
    out = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", "5"]
    out += [f'1 {11 + k} "{name}"' for k, name in enumerate(sides)] + ['2 1 "soil"', "$EndPhysicalNames"]
    out += ["$Entities", "4 4 1 0"] + [f"{k + 1} {x:.9g} {y:.9g} 0 0" for k, (x, y) in enumerate(corners)]
    for k, (_, (a, b)) in enumerate(sides.values()):
        (xa, ya), (xb, yb) = corners[a - 1], corners[b - 1]
        out.append(f"{k + 1} {min(xa, xb):.9g} {min(ya, yb):.9g} 0 {max(xa, xb):.9g} {max(ya, yb):.9g} 0 1 {11 + k} 2 {a} -{b}")
    out += [f"1 0 0 0 {width:.9g} {height:.9g} 0 1 1 4 1 2 3 4", "$EndEntities"]
    count = (nx + 1) * (ny + 1)
    out += ["$Nodes", f"1 {count} 1 {count}", f"2 1 0 {count}"] + [str(k + 1) for k in range(count)]
    out += [f"{width * i / nx:.9g} {height * j / ny:.9g} 0" for j in range(ny + 1) for i in range(nx + 1)]
    lines = sum(len(nodes) - 1 for nodes, _ in sides.values())
    total, number = lines + len(triangles), 0
    out += ["$EndNodes", "$Elements", f"5 {total} 1 {total}"]
    for k, (nodes, _) in enumerate(sides.values()):
        out.append(f"1 {k + 1} 1 {len(nodes) - 1}")
        for a, b in zip(nodes, nodes[1:]):
            number += 1
            out.append(f"{number} {a} {b}")
    out.append(f"2 1 2 {len(triangles)}")
    for triangle in triangles:
        number += 1
        out.append(f"{number} " + " ".join(map(str, triangle)))
    out.append("$EndElements")
    pathlib.Path(path).write_text("\n".join(out) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    write_box(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4]), sys.argv[5])
