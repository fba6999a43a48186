# SPDX-License-Identifier: MIT
"""Soil, water, loads and fixed sides of a case at points, from its echo in summary.json. Formulas: docs/theory/21-proven-bounds.md and 18."""
import math

import numpy as np

from .case import NotEvaluated, Polygons, get, has
from .roots import find_root_cohesion
from .strength import Bedded, Curved, Rigid, Straight, make_power, make_rock, make_table
from .water import Retention, Water, is_on

KNOWN = ("mohr_coulomb", "rooted_mohr_coulomb", "softening_mohr_coulomb", "tresca", "shansep", "bedding", "power_curve", "strength_table", "hoek_brown",
         "softening_hoek_brown", "linear_elastic")
CURVED = ("power_curve", "strength_table", "hoek_brown", "softening_hoek_brown")
TOTAL = ("tresca", "shansep")  # in total stresses


class Section:
    def __init__(self, case):
        self.refuse(case)
        self.case, self.polygons = case, Polygons(case)
        self.low, self.high, self.near, self.names = self.polygons.low, self.polygons.high, self.polygons.near, self.polygons.names
        self.soils = [case["materials"][name] for name in self.names]
        self.water = Water(case)
        self.gravity = get(case["gravity"], "acceleration")
        self.horizontal = get(case["earthquake"], "horizontal") or 0
        self.vertical = 1 + (get(case["earthquake"], "vertical") or 0)
        self.direction = get(case["earthquake"], "direction")
        if self.horizontal < 0:
            self.horizontal, self.direction = -self.horizontal, {"left": "right", "right": "left"}.get(self.direction, self.direction)
        self.is_limited = get(case["bounds"], "tension") == "as_given"
        self.is_davis = get(case["bounds"], "flow") == "davis"
        self.loads = [(get(s, "x"), np.atleast_1d(get(s, "load"))) for s in case.get("surcharge", [])]
        self.slurries = [(get(s, "x"), get(s, "level"), get(s, "unit_weight")) for s in case.get("slurry") or []]
        self.lines = {get(line, "name"): get(line, "points") for line in case["geometry"].get("line") or []}
        self.tractions = [(get(t, "on"), np.array(get(t, "traction"), float)) for t in case.get("traction") or []]
        if any((t.get("factor") or {}).get("value") for t in case.get("traction") or []):
            raise NotEvaluated("a traction that changes")
        self.read_sides(case)
        self.retention = [Retention(soil) for soil in self.soils]
        self.unit = max(max(get(s, k) or 0 for k in ("unit_weight", "saturated_unit_weight")) or 20e3 for s in self.soils) * (self.high[1] - self.low[1])
        self.laws = [self.make_law(soil) for soil in self.soils]

    @staticmethod
    def refuse(case):
        for block in ("construction", "timeline"):
            if case.get(block):
                raise NotEvaluated(f"[{block}]")
        if get(case["partial_factors"], "set") not in (None, "none"):
            raise NotEvaluated("[partial_factors]")
        if list(get(case["gravity"], "direction")) != [0, -1]:
            raise NotEvaluated("inclined gravity")
        if get(case["geometry"], "dimension") == 3:
            raise NotEvaluated("three dimensions")
        if get(case["mesh"], "file"):
            raise NotEvaluated("a mesh from a file")

    def read_sides(self, case):
        self.sides = {}
        box = get(case["geometry"], "box")
        self.box_low, self.box_high = (self.low, self.high) if box is None or not len(box) else (box[0], box[1])
        given = [(get(b, "on"), get(b, "fix"), get(b, "normal")) for b in case["boundary"]] or [(s, "normal", None) for s in ("left", "right")] + [
            ("bottom", "normal", None)]
        for on, fix, normal in given:
            if fix == "plane" and normal is not None and on in ("left", "right", "bottom"):
                across = 0 if on in ("left", "right") else 1
                fix = "normal" if abs(normal[1 - across]) < 1e-9 * abs(normal[across]) else fix
            if fix not in ("full", "normal") or (on not in ("bottom", "left", "right") and on not in self.lines):
                raise NotEvaluated(f"fix = {fix} on {on}")
            self.sides[on] = fix

    # Strength

    def make_law(self, soil):
        model, is_reduced = get(soil, "model"), get(soil, "reduced") is not False
        if model not in KNOWN:
            raise NotEvaluated(f"model = {model}")
        if model == "linear_elastic":
            return Rigid()
        if model in CURVED:
            return self.make_curved(soil, model, is_reduced)
        if model == "shansep":
            return Straight(lambda x: self.find_shansep(soil, x), 0.0, math.inf, is_reduced)
        if model == "tresca":
            return Straight(lambda x: self.find_undrained(soil, x), 0.0, math.inf, is_reduced)
        prefix = "residual_" if model == "softening_mohr_coulomb" and get(soil, "limit_strength") == "residual" else ""
        c, tangent = get(soil, prefix + "cohesion"), math.tan(get(soil, prefix + "friction_angle"))
        gradient, level = get(soil, "cohesion_gradient") or 0, get(soil, "cohesion_level") or 0
        tension = get(soil, "tensile_strength")
        fraction = 1.0
        if self.is_davis:
            if prefix or model == "bedding":
                raise NotEvaluated("flow = davis of this soil")
            phi, psi = get(soil, "friction_angle"), get(soil, "dilatancy_angle") or 0
            fraction = math.cos(psi) * math.cos(phi) / (1 - math.sin(psi) * math.sin(phi))
        roots = find_root_cohesion(self.case, soil) if model == "rooted_mohr_coulomb" else None

        def find_cohesion(x):
            added = roots(x) if roots else 0.0
            return fraction * (c + added + gradient * np.maximum(0, level - x[:, 1]))

        if self.is_limited and tension is None:
            raise NotEvaluated("a soil without a tensile strength")
        body = Straight(find_cohesion, fraction * tangent, tension if self.is_limited else math.inf, is_reduced)
        if model != "bedding":
            return body
        if not is_reduced:
            raise NotEvaluated("bedding with reduced = false")
        return Bedded(body, get(soil, "bedding_angle"), get(soil, "bedding_cohesion"), math.tan(get(soil, "bedding_friction")))

    def make_curved(self, soil, model, is_reduced):
        if self.is_davis:
            raise NotEvaluated("flow = davis of this soil")
        largest, tension = 30 * self.unit, 0.0
        if model == "power_curve":
            lines = make_power(soil, largest)
        elif model == "strength_table":
            lines = make_table(soil)
        else:
            lines, tension = make_rock(soil, largest)
        return Curved(*lines, tension if self.is_limited else math.inf, is_reduced)

    def find_profile(self, soil, key, x):
        """Values along a profile, or between several, linear between places and constant beyond them."""
        places = -get(soil, "profile_levels") if has(soil, "profile_levels") else get(soil, "profile_depths")
        at = -x[:, 1] if has(soil, "profile_levels") else self.polygons.find_tops(x[:, 0]) - x[:, 1]
        values = get(soil, key)
        if not has(soil, "profile_x"):
            return np.interp(at, places, values)
        across = get(soil, "profile_x")
        columns = np.array([np.interp(at, places, row) for row in values.reshape(len(across), -1)])
        k = np.clip(np.searchsorted(across, x[:, 0]) - 1, 0, len(across) - 2)
        part = np.clip((x[:, 0] - across[k]) / (across[k + 1] - across[k]), 0, 1)
        return (1 - part) * columns[k, np.arange(len(x))] + part * columns[k + 1, np.arange(len(x))]

    def find_undrained(self, soil, x):
        if has(soil, "profile_strengths"):
            return self.find_profile(soil, "profile_strengths", x)
        return get(soil, "undrained_strength") + (get(soil, "undrained_gradient") or 0) * np.maximum(0, (get(soil, "undrained_level") or 0) - x[:, 1])

    def find_shansep(self, soil, x):
        """s_u = A + S σ'_v OCR^m; σ'_v of the weights and loads above, less the pore pressure."""
        vertical = self.find_overburden(x) + self.find_load_above(x)
        pressure = self.water.find_level_pressure(self.names[self.soils.index(soil)], x)
        if get(soil, "pore_pressure_ratio"):
            pressure = get(soil, "pore_pressure_ratio") * self.find_overburden(x)
        vertical = np.maximum(vertical - (0 if pressure is None else np.maximum(pressure, 0)), 1e-9)
        if has(soil, "profile_preconsolidation"):
            ratio = np.maximum(1, self.find_profile(soil, "profile_preconsolidation", x) / vertical)
        else:
            ratio = self.find_profile(soil, "profile_ocr", x) if has(soil, "profile_ocr") else get(soil, "ocr")
        return (get(soil, "added_strength") or 0) + get(soil, "strength_ratio") * vertical * ratio ** get(soil, "strength_exponent")

    def find_load_above(self, x):
        """Surcharges and standing water on the ground above points [Pa]."""
        load = sum((self.find_surcharge(places, loads, x[:, 0]) for places, loads in self.loads), np.zeros(len(x)))
        ground = np.c_[x[:, 0], self.polygons.find_tops(x[:, 0])]
        return load + self.water.find_standing(ground)

    @staticmethod
    def find_surcharge(places, loads, x):
        return np.where((x > places[0]) & (x < places[-1]), np.interp(x, places, np.broadcast_to(loads, len(places))), 0)

    # Water and weights

    def find_pressures(self, soil, x):
        """Pore pressure in a soil [Pa]; suction stress is negative. None: that of the file is needed."""
        law, block = self.laws[soil], self.soils[soil]
        if get(block, "model") in TOTAL or isinstance(law, Rigid) or (isinstance(law, Straight) and law.tangent == 0):
            return np.zeros(len(x))
        ratio = get(block, "pore_pressure_ratio")
        if ratio:
            return ratio * self.find_overburden(x)
        if self.water.kind == "seepage":
            return None if self.retention[soil].is_wet else np.zeros(len(x))
        pressure = self.water.find_level_pressure(self.names[soil], x)
        if pressure is None:
            return np.zeros(len(x))
        suction = np.maximum(0, -pressure)
        if self.water.largest_suction is not None:
            suction = np.minimum(suction, self.water.largest_suction)
        return np.where(pressure > 0, pressure, -self.retention[soil].find_suction_stress(suction))

    def find_soil_weights(self, soil, x):
        """Unit weight in a soil [N/m³] without the vertical earthquake. None: the water of the file is needed."""
        block, retention = self.soils[soil], self.retention[soil]
        pressure = self.water.find_level_pressure(self.names[soil], x)
        if self.water.kind == "seepage" and retention.is_wet:
            return None
        wet = np.zeros(len(x), bool) if pressure is None else pressure > 0
        dry, saturated = self.find_extreme_weights(soil)
        if get(block, "unit_weight") is None and retention.is_wet and pressure is not None:
            suction = np.maximum(0, -pressure)
            if self.water.largest_suction is not None:
                suction = np.minimum(suction, self.water.largest_suction)
            solid = (1 - self.find_porosity(block)) * get(block, "grain_density") * self.gravity
            return np.where(wet, saturated, solid + self.find_porosity(block) * retention.find_saturation(suction) * self.water.weight)
        return np.where(wet, saturated, dry)

    @staticmethod
    def find_porosity(block):
        e = get(block, "void_ratio")
        return get(block, "porosity") if e is None else e / (1 + e)

    def find_extreme_weights(self, soil):
        block = self.soils[soil]
        dry, saturated = get(block, "unit_weight"), get(block, "saturated_unit_weight")
        if dry is None:
            porosity = self.find_porosity(block)
            dry = (1 - porosity) * get(block, "grain_density") * self.gravity
            saturated = dry + porosity * self.water.weight * (self.retention[soil].find_saturation(np.zeros(1))[0] if self.retention[soil].is_wet else 1) \
                if saturated is None else saturated
        return dry, dry if saturated is None else saturated

    def find_weights(self, soils, x):
        weights = np.zeros(len(x))
        for soil in np.unique(soils):
            if soil < 0:
                continue
            part = soils == soil
            found = self.find_soil_weights(soil, x[part])
            if found is None:
                raise NotEvaluated("overburden in seepage")
            weights[part] = found
        return weights

    def find_overburden(self, x):
        """Static weight of the soil above points: between all borders and water tables on their verticals."""
        columns = [self.polygons.list_crossings(x[:, 0])]
        lines = [self.water.table, *self.water.lines.values()]
        columns += [np.interp(x[:, 0], line[:, 0], line[:, 1])[:, None] for line in lines if line is not None]
        tops = np.maximum(self.polygons.find_tops(x[:, 0]), x[:, 1])
        levels = np.hstack([np.where(np.isnan(c), -np.inf, c) for c in columns] + [x[:, 1:2], tops[:, None]])
        levels = np.sort(np.clip(levels, x[:, 1:2], tops[:, None]), axis=1)
        total = np.zeros(len(x))
        for k in range(levels.shape[1] - 1):
            thick = np.flatnonzero(levels[:, k + 1] - levels[:, k] > 1e-9)
            if len(thick):
                middle = np.c_[x[thick, 0], (levels[thick, k] + levels[thick, k + 1]) / 2]
                total[thick] += (levels[thick, k + 1] - levels[thick, k]) * self.find_weights(self.polygons.find_soils(middle), middle)
        return total

    # Sides

    def find_traction(self, x, normal, middle):
        """Traction of water, liquids and loads at points of a free side [Pa]; surcharges are per horizontal length."""
        pressure = self.water.find_standing(x, middle)
        for places, level, weight in self.slurries:
            if places[0] < middle[0] < places[1]:
                pressure = pressure + weight * np.maximum(0, level - x[:, 1])
        traction = -pressure[:, None] * normal
        if normal[1] > 1e-6:
            for places, loads in self.loads:
                if places[0] < middle[0] < places[-1]:
                    traction[:, 1] -= np.interp(x[:, 0], places, np.broadcast_to(loads, len(places))) * normal[1]
        for on, load in self.tractions:
            if on in self.lines and is_on(self.lines[on], middle):
                traction += load
            elif on not in self.lines and self.is_on_side(on, middle):
                traction += load
        return traction

    def is_on_side(self, name, middle):
        low, high = self.box_low, self.box_high
        axis, value = {"bottom": (1, low[1]), "left": (0, low[0]), "right": (0, high[0]), "top": (1, high[1])}[name]
        return abs(middle[axis] - value) < self.near

    def find_support(self, p, q):
        """Directions that a side from p to q holds: "full", "normal" or None."""
        held = None
        for name, axis, value in (("bottom", 1, self.box_low[1]), ("left", 0, self.box_low[0]), ("right", 0, self.box_high[0])):
            if name in self.sides and abs(p[axis] - value) < self.near and abs(q[axis] - value) < self.near:
                held = "full" if held == "full" else self.sides[name]
        for name, points in self.lines.items():
            if name in self.sides and is_on(points, p) and is_on(points, q):
                held = "full" if held == "full" else self.sides[name]
        return held
