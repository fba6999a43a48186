#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the tables of table_3_3.md: the study of the dry slope beside table 3.3 of the source, and the range of the
results over meshes of nearly one size.

Usage: table_3_3.py STUDY.csv [MESHES.csv]    (the study.csv of the two studies)
"""
import csv
import sys
from pathlib import Path

FACTORS = ["1.40", "1.45", "1.50", "1.55", "1.60"]
# factor → largest ratio of computed and published displacement, either way; beyond 1.55 single meshes differ by more
# than any band.
BANDS = {"1.40": (0.7, 1.3), "1.45": (0.7, 1.3), "1.50": (0.7, 1.3), "1.55": (1 / 1.5, 1.5)}
FOS_BAND = 0.05
# A mesh belongs to the size of table 3.3 from which it differs by less than this share.
SAME_SIZE = 0.04


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def get_displacement(row, factor):
    return float(row[f"displacement at SRF {float(factor):g} [mm]"])


def get_fos(row):
    return float(row["FoS, bilinear"])


def judge(factor, computed, published):
    if factor not in BANDS:
        return ""
    low, high = BANDS[factor]
    return "" if low <= computed / published <= high else " **out**"


def compare(computed, published):
    print("| variant | " + " | ".join(f"SRF {f}" for f in FACTORS) + " | FoS |")
    print("|---|" + "--:|" * (len(FACTORS) + 1))
    inside = total = 0
    for p in published:
        c = computed[p["variant"]]
        cells = []
        for f in FACTORS:
            u, u0 = get_displacement(c, f), float(p[f])
            verdict = judge(f, u, u0)
            total += f in BANDS
            inside += f in BANDS and not verdict
            cells.append(f"{u:.1f} / {u0:.1f} ({100 * (u / u0 - 1):+.0f} %){verdict}")
        fos, fos0 = get_fos(c), float(p["FoS"])
        out = abs(fos - fos0) > FOS_BAND
        total += 1
        inside += not out
        cells.append(f"{fos:.3f} / {fos0:.2f} ({fos - fos0:+.3f}){' **out**' if out else ''}")
        print(f"| {p['variant']} | " + " | ".join(cells) + " |")
    print(f"\n{inside} of {total} numbers with a band are inside it.\n")


def show_ranges(meshes, published):
    print("| size [m] | meshes | " + " | ".join(f"SRF {f}" for f in FACTORS) + " | FoS |")
    print("|--:|--:|" + "--:|" * (len(FACTORS) + 1))
    sizes = {"size_0.5": 0.5, "base": 0.75, "size_1.0": 1.0, "size_1.25": 1.25, "size_1.5": 1.5}
    by_name = {p["variant"]: p for p in published}
    for name, size in sizes.items():
        rows = [r for r in meshes if abs(float(r["mesh.size [m]"]) / size - 1) < SAME_SIZE]
        cells = []
        for f in FACTORS:
            values = sorted(get_displacement(r, f) for r in rows)
            published_u = float(by_name[name][f])
            mark = "" if values[0] <= published_u <= values[-1] else " *"
            cells.append(f"{values[0]:.1f}–{values[-1]:.1f} ({published_u:.1f}{mark})")
        values = sorted(get_fos(r) for r in rows)
        fos0 = float(by_name[name]["FoS"])
        mark = "" if values[0] - 0.005 <= fos0 <= values[-1] + 0.005 else " *"
        cells.append(f"{values[0]:.2f}–{values[-1]:.2f} ({fos0:.2f}{mark})")
        print(f"| {size:g} | {len(rows)} | " + " | ".join(cells) + " |")
    print()


def show_algorithms(meshes):
    print("| size [m] | algorithm | " + " | ".join(f"SRF {f}" for f in FACTORS) + " | FoS |")
    print("|--:|---|" + "--:|" * (len(FACTORS) + 1))
    for r in meshes:
        cells = [f"{get_displacement(r, f):.1f}" for f in FACTORS] + [f"{get_fos(r):.3f}"]
        print(f"| {r['mesh.size [m]']} | {r['mesh.algorithm']} | " + " | ".join(cells) + " |")
    print()


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    published = read(Path(__file__).with_name("table_3_3_published.csv"))
    compare({r["variant"]: r for r in read(sys.argv[1])}, published)
    if len(sys.argv) == 3:
        meshes = read(sys.argv[2])
        show_ranges(meshes, published)
        show_algorithms(meshes)


if __name__ == "__main__":
    main()
