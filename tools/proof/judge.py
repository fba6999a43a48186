# SPDX-License-Identifier: MIT
"""Verdict on the bounds of a results folder."""
import json
import math
from dataclasses import dataclass, field

from .bars import Bars
from .case import NotEvaluated
from .fields import Lower, Upper
from .section import Section

FLOW = 1e-4  # allowed lack of the flow rule over the mean shear rate: velocities are stored with six digits
EQUILIBRIUM = 1e-3  # allowed imbalance over the largest overburden
MOVED_WEIGHT = 1e-3  # of the whole: what triangles with the mean of two unit weights may move
MISSING = 5e-3  # of the area of the soil: the raster that measures it is as coarse


@dataclass
class Verdict:
    """status 0: all printed bounds are confirmed, 1: one is not proven, 2: a part was not evaluated, which `reasons` name."""

    status: int = 0
    word: str = "confirmed"
    reasons: list = field(default_factory=list)
    text: str = ""
    lower: float = None  # that the stress field proves
    ratio: float = None  # work over dissipation at the printed upper bound


def judge_lower(section, fields, bounds, ways, points, tolerance, bars, out):
    lower = min((Lower(section, fields["holds"], points, way, bars) for way in ways), key=lambda r: r.imbalance)
    factor = min(lower.factor, lower.bar_factor)
    faults = []
    if not factor >= bounds["lower"] * (1 - tolerance):
        faults.append(f"the field proves {factor:.4f}")
    if not lower.imbalance <= EQUILIBRIUM:
        faults.append(f"imbalance {lower.imbalance:.1e}")
    if not abs(lower.missing) <= MISSING:
        faults.append(f"triangles cover {100 * (1 - lower.missing):.1f} % of the soil")
    taken = list(lower.taken)
    if lower.moved > MOVED_WEIGHT:
        taken.append(f"unit weights of triangles that a water table crosses ({100 * lower.moved:.2f} % of the weight moved, {100 * lower.added:.2f} % added)")
    elif lower.moved > 1e-5:
        lower.notes.append(f"weight moved {lower.moved:.1e}, added {lower.added:.1e}")
    text = (f"lower {bounds['lower']:.4f}, here {factor:.4f} (at {lower.place[0]:.2f}, {lower.place[1]:.2f} m; imbalance {lower.imbalance:.1e}"
            + "".join(f"; {note}" for note in lower.notes) + ")")
    out.lower = factor
    return lower, faults, taken, text


def judge_upper(section, fields, bounds, ways, points, tolerance, bars, file_water, out):
    upper = max((Upper(section, fields["moves"], points, way, bounds["upper"], bars, file_water) for way in ways), key=lambda r: r.ratio)
    faults = []
    if not upper.ratio >= 1 - tolerance:
        faults.append(f"work over dissipation {upper.ratio:.4f}")
    if not upper.lack < FLOW:
        faults.append(f"flow rule {upper.lack:.1e}")
    if not upper.moved < 1e-6:
        faults.append(f"fixed sides move by {upper.moved:.1e}")
    text = f"upper {bounds['upper']:.4f}: work over dissipation {upper.ratio:.4f} (flow rule {upper.lack:.1e}, fixed sides {upper.moved:.1e})"
    out.ratio = upper.ratio
    return faults, text


def judge_folder(folder, points=7, tolerance=5e-4):
    """Verdict on a folder with summary.json and bounds.json."""
    out = Verdict()
    try:
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        fields = json.loads((folder / "bounds.json").read_text(encoding="utf-8"))
    except FileNotFoundError as what:
        return Verdict(2, "not evaluated", [f"no {what.filename}"], "no file")
    bounds = fields["summary"]
    texts, faults, taken = [], [], []
    try:
        section = Section(summary["input"])
        ways = {"right": [1], "left": [-1], "both": [1, -1]}.get(section.direction, [1]) if section.horizontal else [0]
        shaken = bounds.get("earthquake") or {}
        if shaken.get("direction"):
            ways = [shaken["direction"]]
        bars = Bars(section, summary["input"]) if summary["input"].get("support") else None
        file_water = None
        if bounds.get("lower"):
            lower, own, assumed, text = judge_lower(section, fields, bounds, ways, points, tolerance, bars, out)
            file_water = lower.file_water
            faults += [f"lower: {f}" for f in own]
            taken += assumed
            if shaken.get("direction"):
                taken.append(f"the lower bound of the earthquake in the other direction ({shaken.get('other_stable') or math.nan:.4f})")
            texts.append(text + (" NOT PROVEN: " + ", ".join(own) if own else ""))
        if bounds.get("upper"):
            own, text = judge_upper(section, fields, bounds, ways, points, tolerance, bars, file_water, out)
            faults += [f"upper: {f}" for f in own]
            texts.append(text + (" NOT PROVEN: " + ", ".join(own) if own else ""))
        if section.is_davis:
            taken.append("that the soil has the strength of Davis")
    except NotEvaluated as what:
        return Verdict(2, "not evaluated", [str(what)], "; ".join(texts))
    if not texts:
        return Verdict(2, "no bound", [bounds.get("no_lower") or "", bounds.get("no_upper") or ""], "no bound")
    out.text = "; ".join(texts)
    if faults:
        out.status, out.word, out.reasons = 1, "NOT PROVEN", faults
    elif taken:
        out.status, out.word, out.reasons = 2, "in part", [f"not checked: {t}" for t in taken]
    return out
