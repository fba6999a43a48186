#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A section with a cavity: LEM refuses it with the place, FEM runs it, and refuses loads on its ground: check_overhangs.py PROGRAM."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
CASE = """
[[geometry.polygon]]
name = "soil"
points = [[0, 0], [40, 0], [40, 5], [24, 5], [18, 15], [10, 15], [10, 4], [0, 4]]
[[geometry.polygon]]
name = "upper"
points = [[0, 4], [4, 4], [4, 8], [7, 8], [7, 4], [10, 4], [10, 15], [0, 15]]
[regions]
soil = "clay"
upper = "clay"
[materials.clay]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 60
friction_angle = 25
dilatancy_angle = 10
tensile_strength = 40
young_modulus = "50 MPa"
poisson_ratio = 0.3
"""


class Cavity(unittest.TestCase):
    def run_talus(self, command, method, *more):
        with tempfile.TemporaryDirectory() as scratch:
            case = pathlib.Path(scratch) / "case.toml"
            case.write_text(CASE + f'[mesh]\nsize = 3\n[analysis]\nmethods = ["{method}"]\n' + "\n".join(more))
            options = ["-o", pathlib.Path(scratch) / "out", "--no-report"] if command == "run" else []
            result = subprocess.run([PROGRAM, command, case, *options], capture_output=True, text=True)
            summary = pathlib.Path(scratch) / "out/summary.json"
            return result, json.loads(summary.read_text()) if summary.exists() else None

    def test_lem_refuses_it_with_the_place(self):
        result, _ = self.run_talus("check", "lem")
        self.assertEqual(result.returncode, 2)
        self.assertIn("on 12 m² from (4, 4) to (7, 8), around (5.5, 6); LEM needs soil without gaps, overhangs and cavities", result.stderr)

    def test_fem_runs_it(self):
        result, summary = self.run_talus("run", "fem")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(summary["methods"]["table"][0]["factor"], 0.5)

    def test_loads_on_the_ground_are_refused(self):
        result, _ = self.run_talus("check", "fem", '[[surcharge]]\nname = "road"\nx = [0, 10]\nload = [20, 20]')
        self.assertEqual(result.returncode, 2)
        self.assertIn("the soil at x = 5.5 m has a gap between y = 4 m and 8 m", result.stderr)


if __name__ == "__main__":
    unittest.main()
