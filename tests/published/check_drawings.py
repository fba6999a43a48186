#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Drawings that other programs wrote are read by `talus import`: check_drawings.py PROGRAM. Exits with 77 without GDAL."""
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

DATA = pathlib.Path(__file__).resolve().parents[1] / "data/drawings"
PROGRAM = sys.argv.pop(1)


class Drawings(unittest.TestCase):
    def run_import(self, name, *options):
        name = name if isinstance(name, pathlib.Path) or "." in name else f"{name}.dxf"
        with tempfile.TemporaryDirectory() as scratch:
            case = pathlib.Path(scratch) / "case.toml"
            result = subprocess.run([PROGRAM, "import", DATA / name, "-o", case, *options], capture_output=True, text=True)
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

    def test_formats_of_gis_give_the_section_of_the_drawing(self):
        options = ("--units", "m", "--lines", "tops", "--base=-5")
        wanted, *_ = self.read("geotechstaff_sample_section", *options)
        for ending in ("gpkg", "geojson"):
            case, *_ = self.read(f"geotechstaff_sample_section.{ending}", *options)
            self.assertEqual(case, wanted)

    def test_attributes_name_soils(self):
        case, _, polygons, _ = self.read("hand_written_cut.geojson")
        self.assertEqual(case["regions"], {"fill": "fill", "clay": "clay", "clay 2": "clay"})
        self.assertEqual(sorted(case["materials"]), ["clay", "fill"])
        self.assertEqual(case["initial"]["water_table"], [[0, 12], [30, 8], [50, 8]])

    def test_maps_are_refused(self):
        text = (DATA / "hand_written_cut.geojson").read_text()
        stated = text.replace("{", '{"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}},', 1)
        degrees = re.sub(r"\[(\d+), (\d+)\]", lambda m: f"[{8.5 + int(m[1]) / 1e5:.6f}, {47.3 + int(m[2]) / 1e5:.6f}]", text)
        for kind in (stated, degrees):
            with tempfile.NamedTemporaryFile(suffix=".geojson") as file:
                pathlib.Path(file.name).write_text(kind)
                result, _ = self.run_import(pathlib.Path(file.name))
            self.assertEqual(result.returncode, 2)
            self.assertIn("has longitudes and latitudes (WGS 84), a map and not a section", result.stderr)

    def write_dxf(self, lines, texts=()):
        pairs = [(0, "SECTION"), (2, "HEADER"), (9, "$INSUNITS"), (70, 6), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
        for layer, points in lines:
            for (x1, y1, *z1), (x2, y2, *z2) in zip(points, points[1:]):
                pairs += [(0, "LINE"), (8, layer), (10, x1), (20, y1), (30, *(z1 or [0])), (11, x2), (21, y2), (31, *(z2 or [0]))]
        for text, x, y in texts:
            pairs += [(0, "MTEXT"), (8, "labels"), (10, x), (20, y), (40, 1), (1, text)]
        file = tempfile.NamedTemporaryFile(suffix=".dxf")
        self.addCleanup(file.close)
        path = pathlib.Path(file.name)
        path.write_text("".join(f"{code}\n{value}\n" for code, value in [*pairs, (0, "ENDSEC"), (0, "EOF")]))
        return path

    def test_crossing_lines_enclose_the_soils(self):
        lines = [("GROUND", [(0, 20), (15, 20), (35, 10), (50, 10)]), ("FILL", [(-1, 14), (51, 8)]), ("CLAY", [(0, 8), (50, 12)]),
                 ("sides", [(0, -1), (0, 20)]), ("sides", [(50, 10.004), (50, 0)]), ("BASE", [(0, 0), (49.997, 0)]), ("wall", [(35, 10), (35, 4)])]
        drawing = self.write_dxf(lines, [("upper fill", 5, 17), ("stiff clay", 10, 5)])
        case, layers, polygons, printed = self.read(drawing)
        self.assertEqual(layers, [])
        self.assertEqual([p["name"] for p in polygons], ["upper fill", "FILL", "CLAY", "stiff clay", "GROUND"])
        area = sum(abs(sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in zip(p["points"], p["points"][1:] + p["points"][:1]))) / 2 for p in polygons)
        self.assertAlmostEqual(area, 15 * 20 + 20 * 15 + 15 * 10, delta=0.1)
        for part in ("a gap of 0.004 m at (50, 10) m was closed", "a gap of 0.003 m at (49.997, 0) m was closed",
                     "a part of a line, 5.846 m long, that ends at (35, 4) m bounds no area", "a part of a line, 1 m long, that ends at (0, -1) m",
                     "Ends and corners nearer than 0.0052 m are one", "'upper fill', by its text", "'FILL', by the layer of the line above it"):
            self.assertIn(part, printed)
        # The two polygons at a crossing share its corner exactly.
        self.assertEqual(sum([30.11811, 10.409449] in p["points"] for p in polygons), 4)

    def test_gaps_are_closed_up_to_snap(self):
        lines = [("a", [(0, 0), (0, 10), (20, 10), (20, 0), (0, 0)][:4]), ("b", [(0.05, 0), (19.95, 0)]), ("c", [(10, 9.96), (10, 0.04)])]
        drawing = self.write_dxf(lines)
        *_, polygons, printed = self.read(drawing, "--as", "regions", "--snap", "0.06")
        self.assertEqual(len(polygons), 2)
        self.assertIn("a gap of 0.05 m", printed)
        result, _ = self.run_import(drawing, "--as", "regions")
        self.assertIn("the lines of the drawing enclose no area", result.stderr)
        result, _ = self.run_import(drawing, "--as", "regions", "--snap", "3")
        self.assertIn("--snap is 3 m; it must be from", result.stderr)

    def test_a_base_closes_crossing_boundaries(self):
        lines = [("GROUND", [(0, 20), (50, 10)]), ("A", [(0, 15), (50, 5)]), ("B", [(0, 8), (50, 8)])]
        *_, layers, polygons, printed = self.read(self.write_dxf(lines))
        self.assertEqual((len(layers), len(polygons)), (2, 0))
        self.assertIn("lines cross at (50, 5) m", printed)
        *_, layers, polygons, _ = self.read(self.write_dxf(lines), "--base=-4 m")
        self.assertEqual((len(layers), len(polygons)), (0, 4))
        *_, layers, polygons, _ = self.read(self.write_dxf(lines), "--base=-4", "--as", "layers")
        self.assertEqual((len(layers), len(polygons)), (3, 0))

    def test_a_section_in_x_and_z(self):
        ground, base = [(0, 10), (10, 10), (30, 4), (50, 4)], [(0, 0), (50, 0)]
        flat = self.read(self.write_dxf([("GROUND", ground), ("BASE", base)]))
        for y in (0, -7.5):
            raised = [(layer, [(x, y, z) for x, z in points]) for layer, points in (("GROUND", ground), ("BASE", base))]
            case, *_, printed = self.read(self.write_dxf(raised))
            self.assertEqual(case["geometry"], flat[0]["geometry"])
            self.assertIn("the section is drawn in x and z", printed)
        # Ends at one place in plan are not those of a closed line: the crest at (0, 10) remains.
        outline = [("SOIL", [(0, 0, 0), (50, 0, 0), (50, 0, 4), (30, 0, 4), (10, 0, 10), (0, 0, 10)]), ("SIDE", [(0, 0, 0), (0, 0, 10)])]
        result, case = self.run_import(self.write_dxf(outline))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(case["geometry"]["polygon"], [{"name": "SOIL", "points": [[0, 0], [0, 10], [10, 10], [30, 4], [50, 4], [50, 0]]}])
        level = [(layer, [(x, y, 3) for x, y in points]) for layer, points in (("GROUND", ground), ("BASE", base))]
        self.assertEqual(self.read(self.write_dxf(level))[0]["geometry"], flat[0]["geometry"])
        in_space = self.write_dxf([("BREAKLINE", [(0, 0, 10), (30, 5, 4), (50, 9, 4)]), ("BASE", [(0, 0, 0), (50, 9, 0)])])
        result, _ = self.run_import(in_space)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"is drawn in space: z changes by 6 along the line \w+ on layer 'BREAKLINE', and y by 9")

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
    "autocad2017_R12": (0, 22), "bricscad_edgeminer_lines_arcs": (0, 8), "cadman_sdi_empty_handles": (0, 2),
    "cloudcompare_dxflib_profile": (0, 1), "ezdxf_small_r13_dos932": (2, 4), "geotechstaff_sample_section": (1, 0),
    "leica_disto_s910": f"the drawing '{DATA / 'leica_disto_s910.dxf'}' cannot be read: it is drawn in space: z changes by 0.789924 along the line 76 on layer 'LEICA_DISTO_3D', "
    "and y by 0.894519 in the drawing; a section is drawn in x and y, or in x and z",
    "librecad_hatches": (0, 2), "librecad_layers": (0, 3), "qcad_supported_entities": (0, 39),
}

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        probe = subprocess.run([PROGRAM, "import", DATA / "librecad_layers.dxf", "-o", pathlib.Path(scratch) / "case.toml"], capture_output=True, text=True)
    if "it has no GDAL" in probe.stderr:
        print(f"SKIP: no drawing was read: {probe.stderr.strip()}")
        sys.exit(77)
    unittest.main()
