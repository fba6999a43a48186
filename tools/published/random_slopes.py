# SPDX-License-Identifier: MIT
"""Random slopes with layers, water, loads and earthquakes (number N is always the same slope), and the gates of their factors.

Numbers above `VARIED` have one of the laws below in a soil, or in all of them, besides."""
import random

VARIED = 1000

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


def draw_gradient(rng, material, top, height):
    """Strength that grows below a level inside the section."""
    return {"cu_rate_per_depth": round(rng.uniform(0.5, 3), 2), "cu_ref_elev": round(top - rng.uniform(0, 1) * height, 3),
            "c": round(rng.uniform(5, 30), 1)}


def draw_profile(rng, material, top, height):
    """Undrained strengths by depth or level, with a weaker zone below a crust."""
    weak = round(rng.uniform(12, 30), 1)
    strengths = [round(weak * rng.uniform(1, 2.5), 1), weak, round(weak * rng.uniform(1.2, 2.5), 1)]
    crust, deep = round(rng.uniform(0.1, 0.4) * height, 2), round(rng.uniform(0.8, 1.5) * height, 2)
    if rng.random() < 0.5:
        return {"profile_depths": [0, crust, deep], "profile_strengths": strengths, "phi": 0}
    return {"profile_levels": [round(top, 3), round(top - crust, 3), round(top - deep, 3)], "profile_strengths": strengths, "phi": 0}


def draw_shansep(rng, material, top, height):
    values = {"strength_ratio": round(rng.uniform(0.2, 0.32), 3), "strength_exponent": round(rng.uniform(0.7, 0.9), 2),
              "added_strength": rng.choice((0, 5)), "phi": 0}
    if rng.random() < 0.5:
        return values | {"ocr": round(rng.uniform(1, 4), 2)}
    return values | {"profile_levels": [round(top, 3), round(top - 1.5 * height, 3)],
                     "profile_preconsolidation": [round(rng.uniform(60, 150), 1), round(rng.uniform(150, 400), 1)]}


def draw_power(rng, material, top, height):
    return {"power": [round(rng.uniform(1, 3), 2), round(rng.uniform(0.65, 0.9), 2), rng.choice((0, 2, 5))]}


def draw_table(rng, material, top, height):
    """A concave envelope of four points [kPa]."""
    slopes = sorted((rng.uniform(0.25, 0.9) for _ in range(3)), reverse=True)
    stresses, strengths = [0, 40, 120, 300], [round(rng.uniform(1, 10), 1)]
    for a, b, slope in zip(stresses, stresses[1:], slopes):
        strengths.append(round(strengths[-1] + slope * (b - a), 1))
    return {"table": [stresses, strengths]}


def draw_rock(rng, material, top, height):
    return {"hoek_brown": [round(rng.uniform(0.5, 3), 2), round(rng.uniform(10, 25), 1), round(rng.uniform(5, 10), 1)]}


def draw_bedding(rng, material, top, height):
    return {"bedding": [round(rng.uniform(-40, 40), 1), round(rng.uniform(1, 15), 1), round(rng.uniform(12, 28), 1)],
            "c": round(rng.uniform(10, 40), 1), "phi": round(rng.uniform(25, 38), 1)}


LAWS = {"gradient": draw_gradient, "profile": draw_profile, "shansep": draw_shansep, "power curve": draw_power, "table": draw_table,
        "Hoek-Brown": draw_rock, "bedding": draw_bedding}


def draw_varied_slope(number):
    """A random slope of which one soil has the law number % 7; of a tenth all soils have one, each with numbers of its own."""
    rng = random.Random(70000 + number)
    entry = draw_slope(number - VARIED)
    law = list(LAWS)[number % len(LAWS)]
    height, chosen = entry["ground"][2][1], rng.randrange(len(entry["materials"]))
    for place, material in enumerate(entry["materials"]):
        if place == chosen or rng.random() < 0.1:
            material.update(LAWS[law](rng, material, height, height))
    return entry | {"id": f"slope_{number}", "title": f"random slope {number}", "law": law}


def draw_any_slope(number):
    return draw_varied_slope(number) if number > VARIED else draw_slope(number)


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
    parts += [entry["law"]] if entry.get("law") else []
    return ", ".join(parts)
