# SPDX-License-Identifier: MIT
"""Rows of the table, their verdicts, and how they are printed."""
from __future__ import annotations

import csv
from dataclasses import dataclass

PASS, MISS, NOTE = "pass", "MISS", "report"


@dataclass
class Row:
    problem: str
    what: str  # "circular search", "given surface crit_bishop" …
    method: str
    computed: float | None
    reference: float | tuple | None  # recomputed or published; a pair is a range
    band: str
    verdict: str
    published: tuple | None = None
    reason: str = ""
    unit: str = ""
    kind: str = ""  # "circle" or "polyline" of a search
    section: str = ""  # chapter of the table

    @property
    def difference(self):
        """Relative, of a range to its nearer end; None where there is nothing to compare."""
        if self.computed is None or self.reference is None:
            return None
        low, high = self.reference if isinstance(self.reference, tuple) else (self.reference, self.reference)
        nearest = min(max(self.computed, low), high)
        return (self.computed - nearest) / abs(nearest) if nearest else None


def judge(computed, reference, below, above):
    """PASS when the value lies in [low (1 - below), high (1 + above)]; below None: any smaller value."""
    if computed is None:
        return MISS
    low, high = reference if isinstance(reference, tuple) else (reference, reference)
    fits = computed <= high + above * abs(high) and (below is None or computed >= low - below * abs(low))
    return PASS if fits else MISS


def show_number(value):
    if value is None:
        return "–"
    if isinstance(value, tuple):
        low, high = value
        return show_number(low) if low == high else f"{show_number(low)}–{show_number(high)}"
    if value == 0:
        return "0"
    return f"{value:.4f}" if 0.1 <= abs(value) < 10 else f"{value:.5g}"


def show_difference(row):
    d = row.difference
    return "–" if d is None else f"{100 * d:+.2f} %"


HEADS = ["problem", "what", "method", "computed", "reference", "published", "difference", "band", "verdict", "reason"]


def cells(row):
    unit = f" {row.unit}" if row.unit else ""
    return [row.problem, row.what, row.method, show_number(row.computed) + (unit if row.computed is not None else ""),
            show_number(row.reference), show_number(row.published), show_difference(row), row.band, row.verdict, row.reason]


def print_table(rows, stream):
    lines = [HEADS] + [[c if i == len(HEADS) - 1 else c[:60] for i, c in enumerate(cells(r))] for r in rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(HEADS) - 1)]
    for line in lines:
        print("  ".join(text.ljust(w) for text, w in zip(line, widths)) + "  " + line[-1], file=stream, flush=True)


def count(rows):
    return {verdict: sum(r.verdict == verdict for r in rows) for verdict in (PASS, MISS, NOTE)}


def write_csv(rows, path):
    with open(path, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(HEADS[:4] + ["unit", "reference low", "reference high", "published low", "published high",
                                  "difference"] + HEADS[7:])
        for r in rows:
            ends = []
            for value in (r.reference, r.published):
                pair = value if isinstance(value, tuple) else (value, value)
                ends += ["" if v is None else f"{v:.6g}" for v in pair]
            out.writerow([r.problem, r.what, r.method, "" if r.computed is None else f"{r.computed:.6g}", r.unit, *ends,
                          "" if r.difference is None else f"{r.difference:.5f}", r.band, r.verdict, r.reason])


SECTIONS = {
    "slices": "Limit equilibrium: published problems",
    "coupled": "Seepage, then LEM",
    "fem": "FEM: published problems",
    "reduction": "FEM: factors of RS2",
    "seepage": "Seepage: published problems",
    "closed": "Closed forms and identities",
    "others": "Reliability, and what is verified elsewhere or not at all",
}


def group(rows):
    """[(section, its rows)] in the order of SECTIONS."""
    return [(key, part) for key in SECTIONS if (part := [r for r in rows if r.section == key])]


def describe_group(key, part):
    """Number, verdicts and the row farthest from its reference among those with a band."""
    judged = [r for r in part if r.verdict != NOTE and r.difference is not None]
    worst = max(judged, key=lambda r: abs(r.difference), default=None)
    passes = [r for r in judged if r.verdict == PASS]
    inside = sum(abs(r.difference) <= 0.001 for r in passes)
    total = count(part)
    text = f"{total[PASS]} pass, {total[MISS]} miss, {total[NOTE]} reported only"
    if worst and key not in ("seepage", "fem", "reduction"):
        text += f"; {inside} of {len(judged)} within 0.1 % of the reference"
    return text


def make_summary(rows):
    return "\n".join(f"{SECTIONS[key]}: {describe_group(key, part)}" for key, part in group(rows))


def make_table(rows):
    lines = ["| " + " | ".join(HEADS) + " |", "|" + "---|" * len(HEADS)]
    last = None
    for r in rows:
        text = [c.replace("|", "\\|") for c in cells(r)]
        if r.verdict == MISS:
            text[8] = "**miss**"
        if r.problem == last:
            text[0] = ""
        last = r.problem
        lines.append("| " + " | ".join(text) + " |")
    return "\n".join(lines) + "\n"


HEADING = """# Published problems: every number

Written by `tools/verify_published.py PROGRAM --fem --out FOLDER` from
[tests/data/published](../../tests/data/published/README.md). The results are discussed in
[verification](../verification.md#published-problems).
"""


def show_worst(rows):
    """Number of the rows with a band and the largest difference among them."""
    judged = [r for r in rows if r.verdict != NOTE]
    worst = max((r for r in judged if r.difference is not None), key=lambda r: abs(r.difference), default=None)
    return f"{len(judged)}: {show_difference(worst)}" if worst else "–"


def find_computed(rows, method):
    """Factors of a method: of the critical circle, else of the first given surface."""
    for chosen in (lambda r: r.kind == "circle", lambda r: True):
        row = next((r for r in rows if r.method == method and chosen(r)), None)
        if row:
            return show_number(row.computed)
    return "–"


def make_problem_table(rows):
    """One line for each problem: how far the worst of its methods is off, by kind of surface."""
    lines = ["| problem | given surfaces | critical circle | critical polyline | Bishop | Spencer | published | |", "|" + "---|" * 8]
    for name in dict.fromkeys(r.problem for r in rows):
        part = [r for r in rows if r.problem == name]
        published = [end for r in part if r.published for end in r.published]
        missed = [r for r in part if r.verdict == MISS]
        verdict = "pass" if not missed else "**miss**: " + ", ".join(dict.fromkeys(f"{r.method} ({r.what})" for r in missed))
        lines.append("| " + " | ".join([
            name, show_worst([r for r in part if not r.kind]), show_worst([r for r in part if r.kind == "circle"]),
            show_worst([r for r in part if r.kind == "polyline"]), find_computed(part, "bishop"), find_computed(part, "spencer"),
            show_number((min(published), max(published))) if published else "–", verdict]) + " |")
    return "\n".join(lines) + "\n"


def make_markdown(rows):
    parts = [HEADING]
    for key, part in group(rows):
        parts.append(f"## {SECTIONS[key]}\n\n{describe_group(key, part)}.\n")
        if key != "slices":
            parts.append(make_table(part))
            continue
        parts.append("Number of comparisons and the largest difference among the methods, from the recomputed factor; computed factors "
                     "of two methods; the range of what other programs and authors publish by any method. Every number is in "
                     "[published.csv](published.csv).\n")
        parts.append(make_problem_table(part))
        told = [r for r in part if r.verdict != PASS]
        if told:
            parts.append("Misses, and what is reported only:\n\n" + make_table(told))
    return "\n".join(parts)
