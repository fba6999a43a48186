#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Drawings that other programs wrote are read by `talus import`: check_drawings.py PROGRAM. Exits with 77 without GDAL."""
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

DATA = pathlib.Path(__file__).resolve().parents[1] / "data/drawings"
PROGRAM = sys.argv.pop(1)


class Drawings(unittest.TestCase):
    def run_import(self, name, *options):
        with tempfile.TemporaryDirectory() as scratch:
            case = pathlib.Path(scratch) / "case.toml"
            result = subprocess.run([PROGRAM, "import", DATA / f"{name}.dxf", "-o", case, *options], capture_output=True, text=True)
            return result, tomllib.loads(case.read_text()) if case.exists() else None

    def read(self, name, *options):
        result, case = self.run_import(name, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        geometry = case.get("geometry", {})
        return case, geometry.get("layer", []), geometry.get("polygon", []), result.stdout

    def test_a_section_by_tops(self):
        result, _ = self.run_import("geotechstaff_sample_section")
        self.assertIn("layer 'CLAY_TOP' of the drawing is named after a top", result.stderr)
        case, layers, polygons, _ = self.read("geotechstaff_sample_section", "--lines", "tops", "--base=-5")
        self.assertEqual([layer["name"] for layer in layers], ["GROUND_SURFACE", "CLAY_TOP"])
        self.assertEqual(polygons, [])
        self.assertEqual(layers[1]["bottom"][0][1], -5)
        self.assertIn("water_table", case["initial"])

    def test_units_must_be_known(self):
        result, _ = self.run_import("cloudcompare_dxflib_profile")
        self.assertEqual(result.returncode, 2)
        self.assertIn("does not state its unit of length", result.stderr)

    def test_every_file_gives_a_case_or_a_sentence(self):
        read = {}
        for file in sorted(DATA.glob("*.dxf")):
            result, case = self.run_import(file.stem, "--units", "m", "--lines", "bottoms")
            if result.returncode == 0:
                geometry = case["geometry"]
                read[file.stem] = (len(geometry.get("layer", [])), len(geometry.get("polygon", [])))
            else:
                self.assertEqual(result.returncode, 2)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                read[file.stem] = result.stderr.split("error: ")[1].strip()
        self.assertEqual(read, EXPECTED)


# Layers and closed regions, or the sentence.
EXPECTED = {
    "autocad2017_R12": (16, 2), "bricscad_edgeminer_lines_arcs": (0, 8), "cadman_sdi_empty_handles": (0, 2),
    "cloudcompare_dxflib_profile": (0, 1), "ezdxf_small_r13_dos932": (2, 4), "geotechstaff_sample_section": (1, 0),
    "leica_disto_s910": "the drawing shows no section: no closed lines, and no two lines above one another",
    "librecad_hatches": (0, 2), "librecad_layers": (0, 3), "qcad_supported_entities": (16, 18),
}

if __name__ == "__main__":
    probe = subprocess.run([PROGRAM, "import", DATA / "librecad_layers.dxf", "-o", "/dev/null", "--overwrite"], capture_output=True, text=True)
    if "it has no GDAL" in probe.stderr:
        print("SKIP: this build has no GDAL, so no drawing was read")
        sys.exit(77)
    unittest.main()
