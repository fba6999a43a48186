#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The design, the effects and the statements of verify_envelope.py against known values."""
import collections
import pathlib
import sys
import tempfile
import types
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

try:
    import h5py  # noqa: F401
except ImportError:
    print("SKIP: python3-h5py is not here, which the statements read results with")
    sys.exit(77)

from envelope import centrifuge, effects, unsaturated, vegetated  # noqa: E402
from envelope.design import SLOPES, make_study, write_design  # noqa: E402
from envelope.evaluation import Evaluation, format_verdict  # noqa: E402
from envelope.page import make_page  # noqa: E402
from envelope.sampling import Levels, Range, draw_hypercube, to_toml  # noqa: E402
from envelope.statements import ANY, Measured, Statement, format_interval  # noqa: E402

try:
    import tomllib
except ImportError:
    tomllib = None


class Hypercube(unittest.TestCase):
    def test_every_stratum_holds_one_sample(self):
        samples = 40
        design = draw_hypercube({"a": Range(0, 1, digits=12), "b": Range(1, 100, log=True, digits=12)}, samples, 3)
        positions = {"a": [c["a"] for c in design], "b": [np.log(c["b"]) / np.log(100) for c in design]}
        for values in positions.values():
            self.assertEqual(sorted(int(v * samples) for v in values), list(range(samples)))

    def test_levels_come_by_their_weights(self):
        counts = collections.Counter(c["water"] for c in draw_hypercube({"water": Levels(flows=2, seeps=1)}, 90, 1))
        self.assertEqual(counts, {"flows": 60, "seeps": 30})

    def test_one_seed_gives_one_design(self):
        factors = {"a": Range(0, 1), "b": Levels(x=1, y=1)}
        self.assertEqual(draw_hypercube(factors, 20, 1), draw_hypercube(factors, 20, 1))
        self.assertNotEqual(draw_hypercube(factors, 20, 1), draw_hypercube(factors, 20, 2))

    def test_the_designs_are_those_of_the_results(self):
        for name, slope in SLOPES.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "design.csv"
                write_design(path, slope.factors, slope.draw())
                drawn = path.read_text().splitlines()
                stored = (ROOT / f"docs/verification_data/envelope_{name}.csv")
                if not stored.exists():
                    self.skipTest(f"{stored.name} is not here")
                width = 1 + len(slope.factors)
                self.assertEqual([line.split(",")[:width] for line in stored.read_text().splitlines()],
                                 [line.split(",") for line in drawn])


class Study(unittest.TestCase):
    def test_values_are_toml(self):
        self.assertEqual(to_toml({"a": [True, 0.5, "x"]}), '{a = [true, 0.5, "x"]}')

    @unittest.skipIf(tomllib is None, "tomllib came with Python 3.11")
    def test_a_row_holds_the_choices_of_its_sample(self):
        for name, slope in SLOPES.items():
            with self.subTest(name):
                rows = slope.list_rows(slope.draw(3))
                study = tomllib.loads(make_study(slope, rows))["study"]
                self.assertEqual(study["vary"][0]["names"], [row for row, _ in rows])
                for vary in study["vary"]:
                    self.assertEqual(len(vary["values"]), 3 * len(slope.cases))

    def test_a_sample_is_repeated_with_other_meshes(self):
        slope = SLOPES["vegetated"]
        choice = slope.draw(1)[0]
        names = [name for name, _ in slope.list_mesh_rows(0, choice | {"algorithm": "frontal"})]
        self.assertEqual(names[:2] + names[-1:], ["001 bare delaunay", "001 0.51 delaunay", "001 1.29 meshadapt"])

    def test_no_choice_acts_in_a_level_that_is_missing(self):
        for slope in SLOPES.values():
            for factor, (other, level) in slope.acts.items():
                self.assertIn(factor, slope.factors)
                self.assertIn(level, slope.factors[other].names)


class Intervals(unittest.TestCase):
    def test_clopper_pearson(self):
        # No event in n trials: 1 - (tail)^(1/n). Others: quantiles of the beta distribution.
        self.assertAlmostEqual(effects.compute_clopper_pearson(0, 10)[1], 1 - 0.05 ** 0.1, 9)
        self.assertAlmostEqual(effects.compute_clopper_pearson(10, 10)[0], 0.05 ** 0.1, 9)
        for (k, n), (low, high) in {(5, 10): (0.2224411, 0.7775589), (1, 20): (0.0025614, 0.2161066), (90, 100): (0.8362824, 0.9447368)}.items():
            found = effects.compute_clopper_pearson(k, n)
            self.assertAlmostEqual(found[0], low, 6)
            self.assertAlmostEqual(found[1], high, 6)


class Effects(unittest.TestCase):
    factors = {"number": Range(0, 1), "level": Levels(x=1, y=1), "idle": Levels(x=1, y=1), "inside": Levels(x=1, y=1)}

    def setUp(self):
        self.design = draw_hypercube(self.factors, 3000, 7)

    def test_additive_function_has_the_shares_of_its_terms(self):
        noise = np.random.default_rng(5).normal(0, 1, 3000)
        bins = [min(int(3 * c["number"]), 2) - 1 for c in self.design]  # variance 2/3
        values = [2 * b + (c["level"] == "x") * 2 + e for b, c, e in zip(bins, self.design, noise)]
        total = 4 * 2 / 3 + 1 + 1
        found = {e.factor: e for e in effects.compute_effects(self.design, values, {})}
        for factor, share in (("number", 4 * 2 / 3 / total), ("level", 1 / total), ("idle", 0), ("inside", 0)):
            self.assertAlmostEqual(found[factor].share, share, delta=0.03)
            self.assertLessEqual(found[factor].low, share)
            self.assertGreaterEqual(found[factor].high, share)
        self.assertAlmostEqual(found["level"].means["x"] - found["level"].means["y"], 2, delta=0.2)

    def test_a_choice_is_tested_where_it_acts(self):
        values = [1.0 * (c["inside"] == "x") * (c["level"] == "x") for c in self.design]
        found = {e.factor: e for e in effects.compute_effects(self.design, values, {"inside": ("level", "x")})}
        self.assertAlmostEqual(found["inside"].share, 1, 6)
        self.assertEqual(found["inside"].where, "level = x")

    def test_small_samples_and_constants_have_no_effect(self):
        self.assertEqual(effects.compute_effects(self.design[:5], [1, 2, 3, 4, 5], {}), [])
        self.assertEqual(effects.compute_effects(self.design, [1.0] * 3000, {}), [])

    def test_intervals_of_noise_reach_zero(self):
        design = self.design[:150]
        values = np.random.default_rng(2).normal(0, 1, 150)
        found = effects.compute_effects(design, values, {})
        self.assertGreaterEqual(sum(not e.is_clear for e in found), 3)


class Conflicts(unittest.TestCase):
    # 20 samples: A holds in the first 10, B in the last 10, C in every second one, D in all.
    held = {"A": [i < 10 for i in range(20)], "B": [i >= 10 for i in range(20)], "C": [i % 2 == 0 for i in range(20)], "D": [True] * 20}

    def test_exclusive_statements_are_found(self):
        pairs = effects.list_conflicts(self.held)
        self.assertEqual([p.names for p in pairs], [("A", "B")])
        self.assertEqual((pairs[0].both, pairs[0].expected), (0, 5))
        self.assertAlmostEqual(pairs[0].tail, 1 / 184756, 9)  # 1 / C(20, 10)

    def test_failing_sets_name_what_must_be_dropped(self):
        self.assertEqual(effects.list_failing_sets(self.held), [(("A",), 5), (("B",), 5), (("A", "C"), 5), (("B", "C"), 5)])

    def test_the_central_run_is_nearest_to_what_is_printed(self):
        values = [{"F": 1.30, "u": 245}, {"F": 1.29, "u": 300}, {"F": 1.28, "u": 245}]
        targets = {"F": (1.28, 0.02), "u": (245, 37)}
        self.assertEqual(effects.find_central([0, 1], values, targets)[0], 0)
        self.assertEqual(effects.find_central([0, 1, 2], values, targets), (2, 0))
        self.assertIsNone(effects.find_central([], values, targets))


class Statements(unittest.TestCase):
    statement = Statement("X", "1", "", "", "kPa", (52, 60), (50, ANY))

    def check(self, measured, verdict):
        self.assertEqual(format_verdict(self.statement, measured), verdict)

    def test_an_interval_and_a_condition_decide(self):
        self.check(Measured(56), "strict")
        self.check(Measured(61), "project")
        self.check(Measured(56, strict=False), "project")
        self.check(Measured(49), "no")
        self.check(Measured(float("nan")), "no")
        self.check(None, "")
        self.assertEqual([format_interval(self.statement, kind) for kind in ("strict", "project")], ["52 to 60 kPa", "≥ 50 kPa"])

    def test_names_are_given_once(self):
        for module in (unsaturated, vegetated, centrifuge):
            names = [s.name for s in module.STATEMENTS]
            self.assertEqual(len(names), len(set(names)))


class Unsaturated(unittest.TestCase):
    def test_two_lines_cross(self):
        srf = np.arange(1, 1.501, 0.025)
        moved = np.maximum(0.1 * (srf - 1), 5 * srf - 6.3)
        self.assertAlmostEqual(unsaturated.find_crossing(srf, moved), 6.2 / 4.9, 9)

    def test_the_exit_is_the_highest_wet_point_of_the_face(self):
        points = np.array([[20, 10.9], [28, 6.9], [30, 5.9], [28, 2]])
        frame = types.SimpleNamespace(points=points, fields={"displacement": np.zeros((4, 2)), "pore_pressure": np.array([-1, 1, 1, 1])})
        frame_type = type("F", (), {"points": points, "__getitem__": lambda self, name: frame.fields[name]})
        self.assertEqual(unsaturated.find_exit(frame_type()), 28)

    def test_further_runs_change_one_parameter(self):
        slope = SLOPES["unsaturated"]
        design = slope.draw()
        base = slope.settings(design[4], "")
        rows = dict(unsaturated.list_extra_rows(slope, design, [4]))
        self.assertEqual(rows["005 fine"] | {"mesh.size": base["mesh.size"]}, base | {"mesh.points_per_element": 3})
        curve = rows["005 damping 0"]["strength_reduction.curve"]
        self.assertEqual((curve["damping"], curve["water_damping"], base["strength_reduction.curve"]["damping"]), (0, 0, 0.05))
        self.assertEqual(unsaturated.select_nearest({0: 1.2, 1: 1.29, 2: float("nan"), 3: 1.28}, 2), [3, 1])


class Vegetated(unittest.TestCase):
    @staticmethod
    def make_run(toe, middle, crest):
        times = {"toe": toe, "mid_face": middle, "crest": crest}
        return types.SimpleNamespace(first_passing=lambda monitor, threshold: times[monitor], start=30,
                                     summary={"stages": [{"time": 590}]})

    def test_order_delay_and_one_block(self):
        block = self.make_run(400, 404, 412)
        runs = {"bare": self.make_run(200, 260, 380), "0.51": block, "0.94": block, "1.29": self.make_run(440, 430, 450)}
        found = vegetated.measure_movement(runs, 0.1)
        self.assertEqual((found["V6"].value, found["V14"].value), (60, 200))
        self.assertAlmostEqual(found["V7"].value, 20 / 450)

    def test_points_that_do_not_move_are_in_no_order(self):
        block = self.make_run(None, None, None)
        found = vegetated.measure_movement({"bare": self.make_run(200, 260, None)} | dict.fromkeys(vegetated.ROOTED, block), 0.1)
        self.assertTrue(np.isnan(found["V6"].value) and np.isnan(found["V7"].value))
        self.assertEqual(found["V14"].value, 360)  # to the end of the rain

    def test_a_prescribed_flux_does_not_run_off(self):
        self.assertEqual(vegetated.compute_runoff({"supplied": 0, "runoff": 0, "entered": 4.4}), 0)
        self.assertEqual(vegetated.compute_runoff({"supplied": 4, "runoff": 1, "entered": 3}), 0.25)


class Centrifuge(unittest.TestCase):
    def test_steps_of_the_moved_soil_are_blocks(self):
        heights = [0.08, 0.08, 0.20, 0.25, 0.25, 0.35, 0.36, 0.36, 0.48, 0.48]
        results = types.SimpleNamespace(highest_moved=lambda frames: (np.array(heights), None))
        self.assertEqual(centrifuge.count_blocks(results, []), 3)

    def test_a_point_moves_and_comes_to_rest(self):
        results = types.SimpleNamespace(time=np.array([0, 20, 21, 30, 40, 50, 100.0]), displacement=np.array([0, 0, 0, 2, 6, 245, 245]) * 1e-3,
                                        summary={"stages": [{"start": 20}]})
        point = centrifuge.Point(results, [])
        self.assertAlmostEqual(point.onset, 35)
        self.assertTrue(point.is_at_rest())
        self.assertAlmostEqual(point.find_peak_speed(), 0.0239, 2)

    def test_the_layer_follows_the_ground(self):
        results = types.SimpleNamespace(summary={"input": {"roots": [{"depth": {"value": 0.05}, "along": {"value": [[0.19, 0], [0.61, 0]]}}]}})
        origin = np.array([[0.4, 0.25], [0.4, 0.2], [0.1, 0.07], [0.6, 0.46]])  # depths normal to the face: 0.02, 0.06; before the toe; at the crest
        self.assertEqual(centrifuge.find_layer(results, None, origin).tolist(), [True, False, False, True])


class Pages(unittest.TestCase):
    def test_a_page_names_the_central_run_or_the_conflict(self):
        slope = SLOPES["unsaturated"]
        design = slope.draw(40)
        for best, words in ((1.28, "most central one is sample 3 "), (1.40, "hold in no sample (strict): U4")):
            evaluation = Evaluation("unsaturated", slope, design)
            for sample in evaluation.samples:
                values = {s.name: Measured(s.printed or s.strict[0]) for s in evaluation.statements if s.counts}
                factor = best if sample.number == 2 else 1.35 + 0.001 * sample.number
                sample.found = {reading: values | {"U4": Measured(factor)} for reading in evaluation.readings}
            if evaluation.choose_central():
                evaluation.meshes["frontal"] = evaluation.samples[0].found
            page = make_page(evaluation)
            self.assertIn(words, page)
            self.assertEqual("with the other mesh generators" in page, best == 1.28)
            self.assertIn("| U4 | 3.4.2 |", page)


if __name__ == "__main__":
    unittest.main()
