# SPDX-License-Identifier: MIT
"""Water of a case at points: water table, piezometric lines, suction, and standing water."""
import numpy as np

from .case import NotEvaluated, get, interpolate_level

STEEPEST = 10  # a water table that is steeper is a step (docs/manual/how-to/supports.md)


class Retention:
    """χ s of Bishop's stress and the saturation at a suction (docs/manual, [materials.NAME.water])."""

    def __init__(self, soil):
        water = soil.get("water") or {}
        self.kind = get(water, "retention") or "dry"
        self.is_wet = self.kind != "dry"
        self.mode = get(soil, "suction_strength") or "from_water"
        if self.mode == "from_water":
            self.mode = "saturation" if self.is_wet else "none"
        if self.is_wet and self.mode == "saturation" and self.kind == "table":
            raise NotEvaluated("a retention table")
        self.water, self.soil = water, soil
        if self.mode == "saturation" and get(water, "chi") not in (None, "saturation"):
            raise NotEvaluated("χ of Khalili and Khabbaz")

    def find_saturation(self, s):
        least, most = get(self.water, "minimum_saturation") or 0, get(self.water, "maximum_saturation")
        most = 1 if most is None else most
        if self.kind == "saturated":
            return np.full(np.shape(s), most)
        if self.kind == "van_genuchten":
            m = get(self.water, "lambda")
            return least + (most - least) * (1 + (s / get(self.water, "reference_pressure")) ** (1 / (1 - m))) ** -m
        if self.kind == "linear":
            return most - (most - least) * np.minimum(1, s / get(self.water, "dry_suction"))
        if self.kind == "exponential":
            return least + (most - least) * np.exp(-get(self.water, "decay") * s)
        raise NotEvaluated(f"retention = {self.kind}")

    def find_suction_stress(self, s):
        if self.mode == "none":
            return np.zeros(np.shape(s))
        if self.mode == "phi_b":
            return s * np.tan(get(self.soil, "phi_b")) / np.tan(get(self.soil, "friction_angle"))
        return s if self.kind == "saturated" else s * self.find_saturation(s)


class Water:
    def __init__(self, case):
        initial = case["initial"]
        self.weight = get(case["water"], "density") * get(case["gravity"], "acceleration")
        self.kind = get(initial, "pore_pressure")
        self.largest_suction = get(initial, "largest_suction")
        if get(initial, "result"):
            raise NotEvaluated("a start from a result")
        if get(initial, "season"):
            raise NotEvaluated("a season")
        self.table, self.lines = None, {}
        if self.kind == "water_table":
            self.table = self.read_line(get(initial, "water_table"))
            for line in initial.get("piezometric_line") or []:
                for name in get(line, "materials"):
                    self.lines[name] = self.read_line(get(line, "points"))
        elif self.kind not in ("zero", "seepage"):
            raise NotEvaluated(f"pore_pressure = {self.kind}")
        self.pools = []  # (points of the line or None, level)
        self.read_pools(case)

    @staticmethod
    def read_line(points):
        run, rise = np.diff(points[:, 0]), np.abs(np.diff(points[:, 1]))
        if (rise > STEEPEST * run).any():
            raise NotEvaluated("a step of the water table")
        return points

    def read_pools(self, case):
        lines = {get(line, "name"): get(line, "points") for line in case["geometry"].get("line") or []}
        for condition in case.get("hydraulic") or []:
            if self.kind == "water_table":
                continue  # water stands on the ground under the table
            if get(condition, "condition") == "pressure":
                raise NotEvaluated("a given pressure on a line")
            if get(condition, "condition") != "total_head":
                continue
            head, on = get(condition, "head"), get(condition, "on")
            if not isinstance(head, float):
                head = np.atleast_2d(head)
                if head.size != 1 and len(np.unique(head[:, 1])) != 1:
                    raise NotEvaluated("heads that change")
                head = head.flat[-1]
            self.pools.append((lines.get(on), on, head))

    def find_level_pressure(self, name, x):
        """Pressure below the line of a soil, negative above it [Pa]; None without one."""
        line = self.lines.get(name, self.table)
        return None if line is None else self.weight * (interpolate_level(line, x[:, 0]) - x[:, 1])

    def find_standing(self, x, middle=None):
        """Pressure of standing water on the ground at points [Pa]; `middle`: of the side on which they lie."""
        if self.table is not None:
            return self.weight * np.maximum(0, interpolate_level(self.table, x[:, 0]) - x[:, 1])
        pressure = np.zeros(len(x))
        for points, _, head in self.pools:
            if points is not None and middle is not None and is_on(points, middle):
                pressure = np.maximum(pressure, self.weight * np.maximum(0, head - x[:, 1]))
        return pressure


def is_on(line, x, near=1e-4):
    """Whether a point lies on a polyline."""
    for p, q in zip(line, line[1:]):
        d = q - p
        length = np.hypot(*d)
        s = np.dot(x - p, d) / length
        if -near <= s <= length + near and abs(d[0] * (x[1] - p[1]) - d[1] * (x[0] - p[0])) / length < near:
            return True
    return False
