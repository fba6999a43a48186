# SPDX-License-Identifier: MIT
"""The tables: computed against published, and what each choice changes."""
import csv
import dataclasses

from .limit_equilibrium import factor
from .results import STAGES, TRANSDUCERS

PUBLISHED = {  # Table 4.6, computed, kPa
    "initial": (10.5, 12.1, 13.4, 13.8), "rise 1": (12.1, 17.4, 22.2, 26.7), "rise 2": (12.8, 20.0, 26.4, 32.2),
    "rise 3": (13.6, 22.6, 31.2, 40.1), "rise 4": (25.9, 32.2, 38.3, 47.3), "failure": (16.6, 24.2, 32.7, 43.6)}
MEASURED = {
    "initial": (7.0, 8.0, 12.0, 12.5), "rise 1": (8.0, 9.75, 20.5, 26.5), "rise 2": (8.25, 10.75, 24.75, 32.15),
    "rise 3": (8.75, 14.25, 32.75, 42.75), "rise 4": (8.9, 15.6, 37.6, 50.0),
    "failure": (9.1, 15.1, 32.2, 43.6)}

HEADING = """# Centrifuge slope: every number

Written by `tools/verify_centrifuge.py PROGRAM FOLDER --variants`. The results are discussed in
[the example](../../examples/centrifuge_slope/README.md). Times are processor times of one thread.

"""


@dataclasses.dataclass
class Row:
    quantity: str
    computed: float
    published: float
    low: float
    high: float
    unit: str
    measured: float = None

    @property
    def agrees(self):
        return self.low <= self.computed <= self.high


def compare(fallow, rooted, suffix=""):
    """`suffix` names the pair. Pressures of a slope that has failed are compared in no stage but that of its failure."""
    rows = []
    for stage, end in zip(STAGES[:-1], fallow.hold_ends()):
        if fallow.onset is None or end <= fallow.onset:
            add_pressures(rows, stage, fallow.pressures(end), suffix)
    if rooted.onset is None:  # stable: the pressures of the last raise in a slope at rest
        add_pressures(rows, "rise 4", rooted.pressures(rooted.time[-1]), " (the rooted slope, which is stable)" + suffix)
    if fallow.onset is not None:
        add_pressures(rows, "failure", fallow.pressures(fallow.onset), suffix)
        rows.append(Row("raise after which the fallow slope moves" + suffix, fallow.stage_at(fallow.onset), 4, 4, 4, ""))
    if None not in (fallow.onset, rooted.onset):
        rows.append(Row("rooted slope moves later by" + suffix, rooted.onset - fallow.onset, 25, 0.7 * 25, 1.3 * 25, "s"))
    ends = [r.displacement[-1] * 1e3 for r in (fallow, rooted)]
    rows.append(Row("displacement at the end, fallow" + suffix, ends[0], 245, 0.7 * 245, 1.3 * 245, "mm"))
    rows.append(Row("displacement at the end, rooted" + suffix, ends[1], 135, 0.7 * 135, 1.3 * 135, "mm"))
    rows.append(Row("rooted over fallow" + suffix, ends[1] / ends[0], 135 / 245, 0.4, 0.7, ""))
    return rows


def add_pressures(rows, stage, computed, suffix):
    for letter, value, published, measured in zip(TRANSDUCERS, computed, PUBLISHED[stage], MEASURED[stage]):
        low, high = 0.9 * published, 1.1 * published
        rows.append(Row(f"pressure at {letter}, {stage}{suffix}", value, published, low, high, "kPa", measured))


def equilibrium_table():
    """Bishop's factor with the pressures of Table 4.6."""
    lines = ["| Bishop's factor | " + " | ".join(STAGES) + " |", "|---|" + "---|" * len(STAGES)]
    for friction, words in ((24, "φ' = 24°, c' = 2 kPa, measured"), (32.9, "φ' = 32.9°, M = 0.94 in plane strain, c' = 2 kPa")):
        for name, table in (("published", PUBLISHED), ("measured", MEASURED)):
            factors = [f"{factor(stage, table[stage], 2, friction, name == 'measured'):.2f}" for stage in STAGES]
            lines.append(f"| {words}; {name} pressures | " + " | ".join(factors) + " |")
    return "\n".join(lines)


def describe(name, r):
    if r is None:
        return f"| {name} | ended with an error | | | | |"
    ends = r.hold_ends()[:4] + [r.time[-1]] * (r.time[-1] > r.raised_at[-1])
    onset = "none" if r.onset is None else f"{r.onset:.0f} s, rise {r.stage_at(r.onset)}"
    cells = [f"{r.moved(end) * 1e3:.0f}" for end in ends] + ["–"] * (5 - len(ends))
    at = "; ".join(f"{v:.1f}" for v in r.pressures(ends[min(2, len(ends) - 1)]))
    return f"| {name} | {onset} | {' / '.join(cells)} | {at} | {r.seconds:.0f} s |"


def variants_table(found, heading=True):
    heads = ("", "movement begins", "displacement at the end of each hold [mm]", "A; B; C; D after rise 2 [kPa]", "processor time")
    lines = ["| " + " | ".join(heads) + " |", "|---|---|---|---|---|"] if heading else []
    return "\n".join(lines + [describe(name, r) for name, r in found])


def write(rows, found, target):
    with open(target / "centrifuge_slope.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["quantity", "computed", "published", "low", "high", "unit", "measured", "agrees"])
        for r in rows:
            out.writerow([r.quantity, f"{r.computed:.4g}", f"{r.published:.4g}", f"{r.low:.4g}", f"{r.high:.4g}", r.unit,
                          "" if r.measured is None else r.measured, "yes" if r.agrees else "no"])
    lines = ["| quantity | computed | published | difference | measured | |", "|---|---|---|---|---|---|"]
    for r in rows:
        measured = "" if r.measured is None else f"{r.measured:g}"
        difference = f"{100 * (r.computed / r.published - 1):+.0f} %"
        lines.append(f"| {r.quantity} | {r.computed:.3g} {r.unit} | {r.published:.3g} {r.unit} | {difference} | {measured} | "
                     f"{'agrees' if r.agrees else '**differs**'} |")
    text = "\n".join(lines) + "\n\n" + variants_table(found) + "\n\n" + equilibrium_table() + "\n"
    (target / "centrifuge_slope.md").write_text(HEADING + text + "\n![Centrifuge slope](centrifuge_slope.png)\n")
    return text
