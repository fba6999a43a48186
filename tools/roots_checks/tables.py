# SPDX-License-Identifier: MIT
"""The tables of the vegetated slope, as Markdown and CSV."""
import csv

from .runs import MONITORS
from .variants import PAIR

THRESHOLDS = (0.04, 0.1, 0.2, 0.5)  # [m]
HEADING = """# Vegetated slope: every number

Written by `tools/verify_roots.py PROGRAM FOLDER`. The results are discussed in [its reading](vegetated_reading.md).
Times count from the start of the rain; onset: displacement above 0.1 m; toe / mid-face / crest, and – where it does not come by the end.
Processor times are those of one thread of the machine it ran on, beside other work.
"""
SIZES_HEADING = """# Vegetated slope in elements of four sizes

Written by `tools/verify_roots.py PROGRAM FOLDER --only sizes`: Darcy formulation, 2.2 GPa, mass scaling 80, rain for 700 s. The results are discussed in
[its reading](vegetated_reading.md#softening-and-the-size-of-the-elements). Onset: displacement above 0.1 m; toe / mid-face / crest, and – where it does not
come by the end. Processor times are those of one thread of the machine it ran on, beside other work.
"""


def join(values, form, empty="–"):
    return " / ".join(empty if v is None else form.format(v) for v in values)


def table_of(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *("| " + " | ".join(row) + " |" for row in rows)]) + "\n"


def describe(r):
    return [join([r.onset(m) for m in MONITORS], "{:.0f}"), join([r.moved(m) for m in MONITORS], "{:.2f}"), f"{r.runout:.2f}"]


def show_statements(statements):
    return table_of(["source", "it states", "comes out", "", "why, or how measured"],
                    [[s.place, s.text, s.found, s.verdict, s.why] for s in statements])


def show_slopes(slopes):
    rows = []
    for name, r in slopes.items():
        water = r.water()
        rows.append([name, *describe(r), f"{r.moved_volume(560):.1f}", f"{water['supplied']:.2f}; {water['runoff']:.2f}",
                     f"{r.steps:,}", f"{r.seconds:.0f} s"])
    return table_of(["", "onset [s]", "displacement at the end [m]", "runout [m]", "moved by more than 0.1 m [m³/m]", "rain; run off [m³/m]", "steps", "processor time"], rows)


def show_thresholds(slopes):
    rows = [[name, *(join([r.first_passing(m, limit) for m in MONITORS], "{:.0f}") for limit in THRESHOLDS)] for name, r in slopes.items()]
    return table_of(["onset [s] at a displacement of", *(f"{100 * limit:.0f} cm" for limit in THRESHOLDS)], rows)


def show_variants(found, head="other choices"):
    """found: name to {content: run}; of each the bare slope and the one with the most roots, the other contents are in the CSV."""
    rows = []
    for name, runs in found.items():
        pair = [runs.get(content) for content in PAIR]
        there = [r for r in pair if r]
        ratio = f"{pair[1].moved('mid_face') / pair[0].moved('mid_face'):.2f}" if all(pair) else ""
        onsets = [join([r.onset(m) for m in MONITORS], "{:.0f}") if r else "" for r in pair]
        rows.append([name, *onsets, "; ".join(f"{r.moved('mid_face'):.2f}" for r in there), ratio, "; ".join(f"{r.runout:.2f}" for r in there),
                     "; ".join(join([r.slide_depth(560)], "{:.1f}") for r in there), "; ".join(f"{r.seconds:.0f}" for r in there)])
    return table_of([head, "onset, bare [s]", "onset, 1.29 % [s]", "mid-face moved [m]", "ratio", "runout [m]", "slid to a depth of [m]", "processor time [s]"],
                    rows)


def write_csv(path, found):
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["variant", "roots", *(f"onset {m} [s]" for m in MONITORS), *(f"displacement {m} [m]" for m in MONITORS), "runout [m]",
                      "moved [m3/m]", "by more than [m]", "pattern", "rain [m3/m]", "entered [m3/m]", "run off [m3/m]", "left [m3/m]", "error of the budget",
                      "points", "steps", "time step [s]", "processor time [s]", "command"])
        for name, runs in found.items():
            for content, r in runs.items():
                if r is None:
                    out.writerow([name, content, "ended with an error"])
                    continue
                water = r.water()
                out.writerow([name, content, *("" if r.onset(m) is None else f"{r.onset(m):.1f}" for m in MONITORS),
                              *(f"{r.moved(m):.4f}" for m in MONITORS), f"{r.runout:.3f}", f"{r.values['runout.moved_volume']:.2f}", f"{r.summary['runout']['moved_threshold']:.3g}", r.pattern,
                              *(f"{water[k]:.4f}" for k in ("supplied", "entered", "runoff", "left")), f"{water['error']:.1e}", r.points, r.steps,
                              f"{r.summary['stages'][-1]['time_step']:.4g}", f"{r.seconds:.1f}", r.command])
