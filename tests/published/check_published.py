#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The command that verifies published problems reads them correctly and finds faults.

check_published.py                 geometry, units, bands and reasons by themselves
check_published.py PROGRAM [N]     and every Nth case file that it writes is sound to `talus check`, and a wrong answer is a miss
"""
import copy
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from published import slices  # noqa: E402
from published.coupled import make_coupled_case  # noqa: E402
from published.case_file import make_case  # noqa: E402
from published.elements import judge_run  # noqa: E402
from published.layers import split_layers  # noqa: E402
from published.problem import find_published, read_given_surfaces, read_problem, read_strips  # noqa: E402
from published.runs import Runner  # noqa: E402
from published.table import MISS, NOTE, PASS, Row, judge  # noqa: E402

DATA = json.loads((ROOT / "tests/data/published/problems.json").read_text())
PROGRAM = None
STRIDE = 1


def find_area(ring):
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))


def find_level(line, x):
    line = sorted(line)
    if x <= line[0][0]:
        return line[0][1]
    for (ax, ay), (bx, by) in zip(line, line[1:]):
        if ax <= x <= bx and bx > ax:
            return ay + (by - ay) * (x - ax) / (bx - ax)
    return line[-1][1]


def is_inside(ring, x, y):
    inside = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
            inside = not inside
    return inside


class Layers(unittest.TestCase):
    def check(self, ground, base, layers):
        rings = split_layers(ground, base, layers)
        width = ground[-1][0] - ground[0][0]
        for _, ring in rings:
            self.assertGreater(find_area(ring), 0)
        whole = sum(0.5 * (a[1] + b[1] - 2 * base) * (b[0] - a[0]) for a, b in zip(ground, ground[1:]))
        self.assertAlmostEqual(sum(find_area(r) for _, r in rings), whole, delta=1e-9 * whole)
        for i in range(40):  # the soil at a place is that of the last line over it
            for j in range(40):
                x = ground[0][0] + width * (i + 0.513) / 40
                top = find_level(ground, x)
                y = base + (top - base) * (j + 0.487) / 40
                height, wanted = top, layers[0][0]
                for material, line in layers[1:]:
                    height = min(height, find_level(line, x))
                    if y < height:
                        wanted = material
                if min(abs(y - find_level(line, x)) for _, line in layers) < 1e-6:
                    continue
                self.assertEqual({m for m, r in rings if is_inside(r, x, y)}, {wanted}, (x, y))
        return rings

    def test_of_all_problems(self):
        for entry in DATA["lem"]:
            if entry.get("layer_lines") and not entry.get("ground_full"):
                self.check([tuple(p) for p in entry["ground"]], entry["base_elev"], entry["layer_lines"])

    def test_lens_and_crossing_lines(self):
        ground = [(0, 10), (20, 10)]
        self.check(ground, 0, [[0, ground], [1, [(0, 8), (5, 8), (10, 4), (20, 4)]], [2, [(0, 6), (20, 6)]]])
        lens = self.check(ground, 0, [[0, ground], [1, [(0, 5), (8, 7), (12, 7), (20, 5)]], [0, [(0, 5), (20, 5)]]])
        self.assertEqual([m for m, _ in lens], [0, 1, 0])

    def test_a_line_that_comes_out_of_the_face(self):
        rings = self.check([(0, 0), (10, 0), (30, 20), (40, 20)], -5, [[0, [(0, 0), (40, 20)]], [1, [(20, 10), (40, 10)]]])
        self.assertEqual([m for m, _ in rings], [0, 1])

    def test_neighbours_share_their_corners(self):
        rings = split_layers([(0, 10), (20, 10)], 0, [[0, [(0, 10), (20, 10)]], [1, [(0, 5), (20, 5)]], [2, [(0, 3), (10, 5), (20, 3)]]])
        corners = {p for _, r in rings for p in r}
        for _, ring in rings:
            for a, b in zip(ring, ring[1:] + ring[:1]):
                for p in corners - {a, b}:
                    along = (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])
                    off = (p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])
                    between = abs(off) < 1e-9 and 0 < along < (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
                    self.assertFalse(between, f"{p} lies on the side {a}-{b} without being its corner")


ENTRY = {
    "id": "X", "title": "made up", "units": "imperial", "ground": [[0, 50], [100, 50], [200, 0], [250, 0]], "mirror": True,
    "materials": [{"name": "Fill 1", "c": 100, "phi": 20, "gamma": 120, "ru": 0.1},
                  {"name": "Fill 1", "c": 200, "phi": 0, "gamma": 100, "cu_rate_per_depth": 2, "cu_ref_elev": -10}],
    "base_elev": -30, "layer_lines": [[0, [[0, 50], [250, 0]]], [1, [[0, 0], [250, 0]]]], "extend": [-20, 300],
    "dloads": [[20, 500], [40, 700]], "tension_crack": {"depth": 5, "water": 2}, "kh": 0.1, "mindepth": 3,
    "circles": [[150, 100, 120], [150, 100, 110, 205, 60]], "piezo": [[0, 30], [250, 5]], "surfaces": [[[210, 0], [150, -5], [70, 50]]],
    "recomputed": {}, "published": {"A": {"gle": 1.2, "any": [1.0, 1.4]}, "B": {"bishop": 1.1}}, "something": 1,
}


class Reading(unittest.TestCase):
    def setUp(self):
        self.problem = read_problem(ENTRY)

    def test_feet_become_metres(self):
        self.assertEqual(self.problem.ground[0], (-6.096, 15.24))
        self.assertEqual(self.problem.ground[-1], (91.44, 0))
        self.assertAlmostEqual(self.problem.base, -9.144)
        self.assertEqual(read_strips(self.problem), [[(6.096, 500), (12.192, 700)]])

    def test_loads_end_with_the_ground(self):
        far = read_problem({**ENTRY, "extend": None, "dloads": [[[-10, 0], [10, 200]], [[260, 1], [280, 1]]]})
        self.assertEqual(read_strips(far), [[(0, 100), (3.048, 200)]])

    def test_surfaces(self):
        surfaces = dict(read_given_surfaces(self.problem))
        self.assertEqual(surfaces["circle0"]["ends"], [])
        self.assertEqual(surfaces["circle1"]["ends"], [18.288, 62.484])
        self.assertEqual(surfaces["surface0"]["points"][0], (21.336, 15.24))

    def test_names_are_told_apart(self):
        self.assertEqual([m["key"] for m in self.problem.materials], ["fill_1", "fill_1_2"])
        self.assertEqual(self.problem.unknown, ["something"])

    def test_published_values(self):
        self.assertEqual(find_published(self.problem, "mp"), (1.0, 1.4))
        self.assertEqual(find_published(self.problem, "bishop"), (1.0, 1.4))

    def test_the_case_has_it_all(self):
        text = make_case(self.problem)
        for line in ('cohesion = "100 lbf/ft2"', 'unit_weight = "120 lbf/ft3"', "pore_pressure_ratio = 0.1", "horizontal = 0.1",
                     'cohesion_gradient = "2 lbf/ft3"', "cohesion_level = -3.048", "depth = 1.524", "water = 0.6096",
                     "smallest_depth = 0.9144", "water_table = [[0, 9.144], [76.2, 1.524]]", 'load = ["500 lbf/ft2", "700 lbf/ft2"]'):
            self.assertIn(line, text)

    def test_soil_without_strength(self):
        soils = [{"name": "cap", "c": 0, "phi": 0, "gamma": 120}, ENTRY["materials"][1] | {"c": 0}]
        text = make_case(read_problem({**ENTRY, "materials": soils}))
        self.assertEqual(text.count('model = "no_strength"'), 1)
        self.assertEqual(text.count("friction_angle"), 1)

    def test_rapid_drawdown(self):
        text = make_case(read_problem(next(e for e in DATA["lem"] if e["id"] == "DWW-99")), search=False)
        for line in ("[materials.silty_clay.undrained_envelope]", 'cohesion = "2017.775 lbf/ft2"', "[lem.drawdown]", 'method = "three_stage"',
                     "water_table = [[0, 36.576], [265.176, 36.576], [396.24, 0], [548.64, -3.048]]"):
            self.assertIn(line, text)

    def test_water_on_faces(self):
        entry = next(e for e in DATA["coupled_seepage_to_stability"] if e["id"] == "DW-72a")
        text, heads = make_coupled_case(read_problem(entry), 2, 3)
        self.assertEqual(heads, [92.0496, 69.1896])
        for line in ("points = [[0, 69.1896], [48.768, 69.1896], [117.348, 92.0496]]", 'on = "water_0"', "head = 92.0496", 'search = "none"',
                     'on = "ground"', "points = [[144.78, 96.6216], [227.076, 69.1896]]", 'conductivity = "5.09016e-09 m/s"'):
            self.assertIn(line, text)


class Verdicts(unittest.TestCase):
    def test_bands(self):
        self.assertEqual(judge(1.003, 1.0, 0.003, 0.0031), PASS)
        self.assertEqual(judge(1.004, 1.0, 0.003, 0.003), MISS)
        self.assertEqual(judge(0.996, 1.0, 0.003, 0.003), MISS)
        self.assertEqual(judge(0.5, 1.0, None, 0.005), PASS)
        self.assertEqual(judge(None, 1.0, None, 0.005), MISS)
        self.assertEqual(judge(1.21, (1.0, 1.2), 0.02, 0.02), PASS)

    def test_lower_minima_must_hold(self):
        entry = {**ENTRY, "recomputed": {"circular_search": {"bishop": {"F": 1.0}}}}
        problem = read_problem(entry)
        answers = {"critical": [{"method": "bishop", "factor": 0.9, "checks": {"refusal": ""}}]}
        for again, verdict in (((0.9005, ""), PASS), ((0.95, ""), MISS), ((0.9, "tension"), MISS), ((None, "outside"), MISS)):
            row, = slices.check_search(problem, answers, {"circle.bishop": again}, "circle", entry["recomputed"]["circular_search"], 0.005)
            self.assertEqual(row.verdict, verdict, again)

    def test_published_polylines(self):
        problem = read_problem({**ENTRY, "recomputed": {}, "circles": [], "surfaces": [], "search": "polyline", "published": {"A": {"spencer": 1.0}}})
        answers = {name: [{"method": "spencer", "factor": factor}] for name, factor in (("critical", 1.2), ("noncircular", 1.01))}
        row, = slices.check_published_only(problem, answers)
        self.assertEqual((row.what, row.computed, row.verdict), ("critical polyline", 1.01, PASS))

    def test_finite_elements(self):
        gentle = next(e for e in DATA["lem"] if e["id"] == "AT-1")
        steep = next(e for e in DATA["lem"] if e["id"] == "PRU-14-1")
        self.assertEqual(judge_run(read_problem(gentle), "associated", 1.42, "").verdict, PASS)
        self.assertEqual(judge_run(read_problem(gentle), "associated", 1.45, "").verdict, MISS)
        self.assertEqual(judge_run(read_problem(gentle), "as_given", 1.30, "").verdict, PASS)
        self.assertEqual(judge_run(read_problem(gentle), "as_given", 1.20, "").verdict, MISS)
        self.assertEqual(judge_run(read_problem(steep), "as_given", 0.30, "").verdict, NOTE)

    def test_acceptance_in_a_caveat(self):
        limits = slices.read_acceptance("spread; accept anything <=0.72 for Spencer/M-P with admissible line of thrust")
        self.assertEqual(limits, {"spencer": 0.72, "mp": 0.72})

    def test_difference_from_a_range(self):
        self.assertEqual(Row("", "", "", 1.1, (1.0, 1.2), "", PASS).difference, 0)
        self.assertAlmostEqual(Row("", "", "", 1.32, (1.0, 1.2), "", PASS).difference, 0.1)


class Program(unittest.TestCase):
    def test_every_case_is_sound(self):
        with tempfile.TemporaryDirectory() as folder:
            for entry in [*DATA["lem"][::STRIDE], ENTRY]:
                case = pathlib.Path(folder) / "case.toml"
                case.write_text(make_case(read_problem(entry), finite_elements=True))
                done = subprocess.run([PROGRAM, "check", str(case)], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, f"{entry['id']}: {done.stdout}{done.stderr}")

    def test_a_wrong_reference_is_a_miss(self):
        entry = copy.deepcopy(next(e for e in DATA["lem"] if e["id"] == "FK-1"))
        values = entry["recomputed"]["specified_surface"]["circle0"]
        values["bishop"] *= 1.004
        with tempfile.TemporaryDirectory() as folder:
            rows = slices.verify(Runner(PROGRAM, folder), entry, 100)
        verdicts = {r.method: r.verdict for r in rows}
        self.assertEqual(verdicts.pop("bishop"), MISS)
        self.assertEqual(set(verdicts.values()), {PASS})
        self.assertTrue(all(math.isfinite(r.computed) for r in rows))


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        PROGRAM = sys.argv.pop(1)
        if len(sys.argv) > 1 and sys.argv[1].isdigit():
            STRIDE = int(sys.argv.pop(1))
    else:
        del Program
    unittest.main()
