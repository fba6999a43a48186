#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The design and the effects of verify_envelope.py against known values."""
import collections
import pathlib
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from envelope import effects  # noqa: E402
from envelope.design import SLOPES, make_study, write_design  # noqa: E402
from envelope.sampling import Levels, Range, draw_hypercube, to_toml  # noqa: E402

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


if __name__ == "__main__":
    unittest.main()
