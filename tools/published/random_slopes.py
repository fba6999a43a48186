# SPDX-License-Identifier: MIT
"""Random slopes with layers, water, loads and earthquakes (number N is always the same slope), and the gates of their factors."""
import random

RIGOROUS = ("spencer", "morgenstern_price")


def draw_soil(rng, name):
    """A clay without friction that is undrained, or a soil with both, within the range of real ones [kPa, °, kN/m³]."""
    gamma = round(rng.uniform(17, 21), 2)
    if rng.random() < 0.2:
        return {"name": name, "c": round(rng.uniform(20, 80), 1), "phi": 0, "gamma": gamma}
    return {"name": name, "c": round(rng.uniform(2, 25), 1), "phi": round(rng.uniform(18, 38), 1), "gamma": gamma}


def draw_layers(rng, ground, base, height):
    """Layers from the ground downwards; the lower ones begin at inclined lines from side to side."""
    lines, levels = [[0, ground]], sorted((rng.uniform(base + 0.15 * height, ground[0][1] + 0.8 * height)
                                           for _ in range(rng.choice((0, 0, 1, 1, 2)))), reverse=True)
    left, right = ground[0][0], ground[-1][0]
    for number, level in enumerate(levels, 1):
        dip = rng.uniform(-0.05, 0.1) * (right - left)
        points = [[left, max(level - 0.5 * dip, base + 0.1 * height)], [right, max(level + 0.5 * dip, base + 0.1 * height)]]
        above = lines[-1][1] if number > 1 else None
        if above and any(b[1] >= a[1] - 0.05 * height for a, b in zip(above, points)):
            continue  # it would cross the layer above
        lines.append([len(lines), [[round(x, 3), round(y, 3)] for x, y in points]])
    return lines


def draw_water(rng, ground, height):
    """A water table from beyond the toe to under the crest: at, above or below the ground in front."""
    toe, crest, left, right = ground[1], ground[2], ground[0][0], ground[-1][0]
    front = toe[1] + rng.choice((-0.3, -0.1, 0, 0, 0.2)) * height
    back = crest[1] - rng.uniform(0.25, 0.7) * height
    back = max(back, front)
    middle = 0.5 * (toe[0] + crest[0])
    return [[left, round(front, 3)], [toe[0], round(front, 3)],
            [round(middle, 3), round(min(front + 0.45 * (back - front), toe[1] + 0.45 * height), 3)],
            [crest[0] + height, round(back, 3)], [right, round(back, 3)]]


def draw_slope(number):
    """Slope `number` as an entry of the schema of tests/data/published/problems.json."""
    rng = random.Random(1000 + number)
    height = round(rng.uniform(5, 25), 2)
    angle = rng.uniform(1.2, 3.5)  # run over rise
    toe = round(1.8 * height, 3)
    ground = [[0, 0], [toe, 0], [round(toe + angle * height, 3), height], [round(toe + angle * height + 2.2 * height, 3), height]]
    base = -round(rng.uniform(0.2, 0.8) * height, 2)
    lines = draw_layers(rng, ground, base, height)
    entry = {"id": f"slope_{number}", "title": f"random slope {number}", "ground": ground, "base_elev": base, "layer_lines": lines,
             "materials": [draw_soil(rng, f"soil{i + 1}") for i in range(len(lines))]}
    if rng.random() < 0.5:
        entry["piezo"] = draw_water(rng, ground, height)
        for material in entry["materials"]:
            material["gamma_sat"] = round(material["gamma"] + rng.uniform(0, 1.5), 2)
    if rng.random() < 0.3:
        crest = ground[2][0]
        load = round(rng.uniform(5, 40), 1)
        entry["dloads"] = [[[round(crest + 0.1 * height, 3), load], [round(crest + rng.uniform(0.6, 1.5) * height, 3), load]]]
    if rng.random() < 0.2:
        entry["kh"] = round(rng.uniform(0.02, 0.12), 3)
    return entry


def find_gate_faults(slices):
    """Factors of limit equilibrium that the program should not have printed."""
    faults = []
    for kind in ("critical", "noncircular"):
        for result in slices.get(kind) or []:
            factor, checks = result.get("factor"), result.get("checks") or {}
            if not factor:
                continue
            name = f"{kind} {result['method']}"
            if not 0.05 < factor < 30:
                faults.append(f"{name}: factor {factor:.4g}")
            if checks.get("refusal"):
                faults.append(f"{name}: printed though {checks['refusal']}")
            if result.get("lambda") is not None and not -0.1 <= result["lambda"] <= 1.5:
                faults.append(f"{name}: λ = {result['lambda']:.3g}")
            if (checks.get("thrust_outside") or 0) > 0.3:
                faults.append(f"{name}: {100 * checks['thrust_outside']:.0f} % of the thrust outside")
            if (checks.get("tensile_share") or 0) > 0.2:
                faults.append(f"{name}: tension over {100 * checks['tensile_share']:.0f} %")
    return faults


def describe(entry):
    parts = [f"{len(entry['layer_lines'])} soil{'s' * (len(entry['layer_lines']) > 1)}"]
    parts += [word for key, word in (("piezo", "water"), ("dloads", "load"), ("kh", "earthquake")) if entry.get(key)]
    return ", ".join(parts)
