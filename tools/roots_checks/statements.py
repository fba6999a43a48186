# SPDX-License-Identifier: MIT
"""The statements of the source about the slope, beside the results: agrees, in part, or differs, and why."""
import dataclasses

import numpy as np

from .quantities import (compare_preconsolidation, count_parts, find_face_strain, find_front, find_lower_face, find_moving_strain, find_wetted,
                         read_suction)
from .runs import MONITORS

ROOTED = ("0.51 %", "0.94 %", "1.29 %")
FOOT = 4 * 6e-4 * 560  # rain on the level foot [m³/m]


@dataclasses.dataclass
class Statement:
    place: str
    text: str
    found: str
    verdict: str
    why: str = ""


def judge(holds, partly=False):
    return "agrees" if holds else "in part" if partly else "**differs**"


def seconds(value):
    return "–" if value is None else f"{value:.0f}"


def onsets(r):
    return " / ".join(seconds(r.onset(m)) for m in MONITORS)


def band_ratio(values, low, high):
    return all(low <= v <= high for v in values)


def find_setup(slopes):
    bare = slopes["bare"]
    elements, nodes, active, points, layer = count_parts(bare)
    points_differ = abs(points / 3009 - 1)
    yield Statement("4.4.1", "1,798 triangles, 959 nodes; 1,003 with soil, 3,009 points, 990 of them in the layer",
                    f"{elements:,}, {nodes:,}; {active}, {points:,}, {layer}",
                    judge(points_differ < 0.02, points_differ < 0.1),
                    "the layer of 0.5 m takes two rows of elements; of 0.21 m each it would be 990 points; size of the box not printed")
    start, (time, largest) = bare.frame(0), read_suction(bare)
    suction, below = -start["pore_pressure"].min() / 1e3, float(time[largest < 30][0])
    saturation = float(start["saturation"].min())
    yield Statement("4.4.1", "computed suctions stay below about 30 kPa, where S ≥ 0.7",
                    f"{suction:.1f} kPa, S = {saturation:.2f} at the crest before the rain; below 30 kPa after {below:.0f} s",
                    judge(suction < 33, below < 300), "the printed water table, 4 m below the crest, gives 39 kPa")


def find_water(slopes):
    waters = {name: r.water() for name, r in slopes.items()}
    bare = waters["bare"]
    yield Statement("4.4.1", "all water infiltrates, no ponding",
                    f"of {bare['supplied']:.2f} m³/m {bare['runoff']:.2f} run off in the bare slope; {FOOT:.2f} fall on the level foot",
                    judge(bare["runoff"] < 0.02 * bare["supplied"], bare["runoff"] < 1.3 * FOOT),
                    "the foot is saturated from the start: its water table is at the surface; the rest leaves where the lower face is full")
    error = max(abs(w["error"]) for w in waters.values())
    yield Statement("–", "water: stored – (start + in – out), over the water", f"at most {error:.0e}", judge(error < 1e-9))


def find_preconsolidation(slopes):
    bare, rooted = slopes["bare"], slopes["1.29 %"]
    found = compare_preconsolidation(bare, rooted)
    wet = found["wet"]
    yield Statement("4.4.2", "before rainfall $p'_c$ increases linearly with depth below the water table",
                    f"{wet.min():.0f} to {wet.max():.0f} kPa at x = 2 m, within {100 * found['off']:.1f} % of a line", judge(found["off"] < 0.03))
    yield Statement("", "suction strengthens above it, most strongly near the crest",
                    f"{found['low']:.0f}, {found['middle']:.0f}, {found['crest']:.0f} kPa at heights of 1.5, 3, {found['top']:.1f} m",
                    judge(found["crest"] > found["middle"] > wet.max()), "$\\exp(b(1-S))$ is 35 at the crest")
    yield Statement("", "roots enlarge it further in the layer", f"{found['roots']:.3f} times at 1.29 %", judge(found["roots"] > 1.1),
                    f"$\\exp(0.4\\cdot1.29)$ = {np.exp(0.4 * 1.29):.3f}")
    low, high, share = find_wetted(bare)
    yield Statement("", "$p'_c$ collapses to its saturated value; much of the upper profile falls to about 50 kPa",
                    f"bare, wetted part at 230 s, x = 2 to 5 m: {low:.0f} to {high:.0f} kPa, {100 * share:.0f} % of it 35 to 65 kPa", judge(share > 0.5, share > 0),
                    "3 times $p'_{ini}$, the mean effective stress with suction at rest, 12 to 23 kPa; x of section A is not printed")
    low, high, share = find_wetted(rooted)
    yield Statement("", "the same with roots, which leave more strength in place", f"1.29 %: {low:.0f} to {high:.0f} kPa, {100 * share:.0f} % of it 35 to 65 kPa",
                    judge(share > 0.5, low > 50), "in the layer 1.68 times the bare soil's, so more than 50 kPa")
    fronts = [find_front(r) for r in (bare, rooted)]
    yield Statement("", "roots do not slow the softening", f"wetting front at 230 s, x = 2 m: {fronts[0]:.1f} m bare, {fronts[1]:.1f} m at 1.29 %",
                    judge(fronts[1] > 0.9 * fronts[0]))


def find_movement(slopes, longer, lower_conductivity):
    """longer: bare and 1.29 % with rain for 1,200 s, or None."""
    bare = slopes["bare"]
    longer, longer_rooted = longer or (None, None)
    order = [bare.onset(m) for m in MONITORS]
    first_two = None not in order[:2] and order[0] < order[1]
    later = "" if longer is None else f"; rain for 1,200 s: {onsets(longer)} s"
    ordered = longer is not None and None not in [longer.onset(m) for m in MONITORS] and longer.pattern == "upwards"
    yield Statement("4.4.2", "bare: toe first, mid-face follows, crest joins last", f"{onsets(bare)} s{later}",
                    judge(first_two and order[2] is not None and order[2] > order[1], first_two and ordered),
                    "by 560 s the slide has not reached the crest; it does if the rain continues")
    text = "; ".join(f"{name} {onsets(slopes[name])}" for name in ROOTED)
    yield Statement("", "rooted: all three start together, as one block", f"{text} s",
                    judge(all(slopes[n].pattern == "together" for n in ROOTED)), "together: first and last within 10 %")
    yield Statement("", "roots delay the onset of movement", f"first point: {min(filter(None, order)):.0f} s bare, "
                    f"{' / '.join(f'{min(slopes[n].onset(m) for m in MONITORS):.0f}' for n in ROOTED)} s",
                    judge(all(slopes[n].onset("toe") > order[0] for n in ROOTED)))
    middle, toe = ([slopes[n].moved(m) / bare.moved(m) for n in ROOTED] for m in ("mid_face", "toe"))
    yield Statement("", "roots roughly halve the displacement of the upper slope (band: 0.35 to 0.65)",
                    f"mid-face, rooted over bare: {' / '.join(f'{v:.2f}' for v in middle)}",
                    judge(0.35 <= middle[2] <= 0.65, True), "of the crest there is no ratio: the bare one does not slide by 560 s, and rooted ones do" + (
                        "" if longer is None else "; after 1,200 s of rain, 1.29 %, toe / mid-face / crest: " + " / ".join(
                            f"{longer_rooted.moved(m) / longer.moved(m):.2f}" for m in MONITORS)))
    yield Statement("", "with a smaller reduction near the toe", f"toe: {' / '.join(f'{v:.2f}' for v in toe)}",
                    judge(all(t > m for t, m in zip(toe, middle))), "the difference is small")
    if lower_conductivity is not None:
        a, b = slopes["1.29 %"], lower_conductivity
        yield Statement("", "reinforcement outweighs the small hydraulic contrast", f"1.29 % in a layer no more conductive than the soil: "
                        f"{onsets(b)} s, mid-face {b.moved('mid_face'):.2f} m (with contrast {onsets(a)} s, {a.moved('mid_face'):.2f} m)",
                        judge(abs(a.onset("toe") - b.onset("toe")) < 0.3 * (a.onset("toe") - order[0])))
    runouts = [r.runout for r in slopes.values()]
    yield Statement("", "every case reaches a runout of about 2 m beyond the toe (±0.5)", " / ".join(f"{v:.2f}" for v in runouts) + " m",
                    judge(band_ratio(runouts, 1.5, 2.5)))


def find_strain(slopes, on_face):
    """on_face: the bare slope with the rain on the face itself, or None."""
    bare = slopes["bare"]
    largest, toe = find_lower_face(bare)
    yield Statement("Fig. 4.8", "by 200 s the lower face of the bare slope has failed",
                    f"largest strain there {largest:.3f}, toe moved {100 * toe:.1f} cm; it fails at {seconds(bare.onset('toe'))} s", judge(toe > 0.1),
                    "" if on_face is None else f"{seconds(on_face.onset('toe'))} s if the rain falls on the face itself: see the other readings")
    strains = [find_face_strain(slopes[name]) for name in ROOTED]
    yield Statement("Figs. 4.9–4.11", "rooted faces show no localization at 200 s", f"largest strain from the crest's edge on {max(strains):.3f}",
                    judge(max(strains) < 0.1))
    spread = find_moving_strain(bare)[0]
    yield Statement("Fig. 4.8", "bare: shear strain spreads through the entire moving mass", f"median of the moving mass at 560 s {spread:.2f}", judge(spread > 0.3))
    texts, kept = [], []
    for name in ROOTED:
        _, inside, below = find_moving_strain(slopes[name])
        texts.append(f"{name}: {inside:.2f} in the layer, {below:.2f} below")
        kept.append(inside < 0.25 * below)
    yield Statement("Figs. 4.9–4.11", "rooted: a continuous band at the base, the material above it moves with little strain",
                    "median of what moves at 560 s, " + "; ".join(texts), judge(all(kept)), "the bands run below the layer, from the crest to the foot")
    yield Statement("4.4.2", "roots do not prevent failure under continued rainfall", f"largest displacement at 1.29 %: "
                    f"{slopes['1.29 %'].values['runout.largest_displacement']:.2f} m", judge(True))


def find_all(slopes, longer, lower_conductivity, on_face):
    for part in (find_setup(slopes), find_water(slopes), find_preconsolidation(slopes), find_movement(slopes, longer, lower_conductivity),
                 find_strain(slopes, on_face)):
        yield from part
