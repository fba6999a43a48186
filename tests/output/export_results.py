#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `talus export` writes is read back: export_results.py PROGRAM. Every number of summary.json is in the workbook, the
slices in their columns; `talus import` of the drawing gives the same polygons. Exits with 77 without the modules."""
import bisect
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
import xml.etree.ElementTree as xml
import zipfile

PROGRAM = sys.argv.pop(1)
SPREADSHEET = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
RELATION = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}id"
# Units of display of the default units: value in SI = shown value × factor.
SHOWN = {"Pa": 1e3, "N/m": 1e3, "N/m3": 1e3, "rad": math.pi / 180}
PRECISION = 2e-15  # libxlsxwriter writes 16 digits

ROOT = pathlib.Path(__file__).resolve().parents[2]

STUDY = {
    "title": "Sizes", "case_file": "case.toml", "mode": "one", "reference": "",
    "columns": [{"name": "mesh.size", "title": "mesh size", "unit": "m", "kind": "other", "by": "",
                 "cells": [{"full": "0.5", "shown": "0.5"}, {"full": "0.25", "shown": "0.3"}]},
                {"name": "note", "title": "note", "unit": "", "kind": "other", "by": "",
                 "cells": [{"full": "=2", "shown": "=2"}, {"full": "", "shown": ""}]}],
    "variants": [{"name": name, "folder": name, "status": "finished", "reason": ""} for name in ("a", "b")],
}

CASE = """
title = "=1+1"
[geometry]
[[geometry.polygon]]
name = "base"
points = [[4000000, 0], [4000044.25, 0], [4000044.25, 5.125], [4000032, 5], [4000000, 5]]
[[geometry.polygon]]
name = "slope"
points = [[4000000, 5], [4000032, 5], [4000012, 15], [4000000, 15]]
[[geometry.polygon]]
name = "lens"
points = [[4000002, 7], [4000008, 7], [4000008, 8], [4000002, 8]]
[regions]
base = "Löß / \\"A\\""
slope = "=HYPERLINK(1)"
lens = "=HYPERLINK(1)"
[materials."Löß / \\"A\\""]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 16
friction_angle = 32
young_modulus = "45 MPa"
poisson_ratio = 0.3
dilatancy_angle = 0
tensile_strength = 0
[materials."=HYPERLINK(1)"]
model = "mohr_coulomb"
unit_weight = 18.5
cohesion = 18
friction_angle = 26
young_modulus = "45 MPa"
poisson_ratio = 0.3
dilatancy_angle = 0
tensile_strength = 0
[initial]
pore_pressure = "water_table"
water_table = [[4000000, 6.5], [4000044.25, 6]]
[analysis]
methods = ["lem", "fem", "bounds"]
[lem]
methods = ["bishop", "spencer"]
[lem.entry_exit]
exits = 10
entries = 10
depths = 8
[[lem.surface]]
name = "toe circle"
centre = [4000028, 28]
radius = 23
[fem]
size = 4
meshes = 1
resolution = 0.05
[bounds]
gap = 0.2
"""


def run(*arguments, code=0):
    result = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert result.returncode == code, f"{arguments}: {result.returncode} {result.stderr}"
    return result.stderr if code else result.stdout


def read_workbook(path):
    """{sheet: [[cell]]}: numbers, booleans, texts, None; a formula is an error."""
    with zipfile.ZipFile(path) as archive:
        def parse(name):
            return xml.fromstring(archive.read(name))
        texts = ["".join(t.text or "" for t in item.iter(SPREADSHEET + "t")) for item in parse("xl/sharedStrings.xml")]
        files = {r.get("Id"): r.get("Target") for r in parse("xl/_rels/workbook.xml.rels")}
        sheets = {}
        for sheet in parse("xl/workbook.xml").iter(SPREADSHEET + "sheet"):
            root = parse("xl/" + files[sheet.get(RELATION)])
            rows = sheets[sheet.get("name")] = []
            for row in root.iter(SPREADSHEET + "row"):
                rows += [[] for _ in range(int(row.get("r")) - len(rows))]
                for cell in row:
                    assert cell.find(SPREADSHEET + "f") is None, f"a formula in {cell.get('r')}"
                    column = 0
                    for letter in re.match("[A-Z]+", cell.get("r"))[0]:
                        column = 26 * column + ord(letter) - ord("A") + 1
                    rows[-1] += [None] * (column - len(rows[-1]))
                    value = cell.find(SPREADSHEET + "v")
                    if value is not None:
                        kind = cell.get("t")
                        rows[-1][-1] = texts[int(value.text)] if kind == "s" else value.text == "1" if kind == "b" else float(value.text)
            pane = root.find(f".//{SPREADSHEET}pane")
            sheets[sheet.get("name")].insert(0, pane is not None and pane.get("state") == "frozen")
    return {name: (rows[0], rows[1:]) for name, rows in sheets.items()}


def read_entities(path):
    """[(kind, layer, closed, points, text)] of the entities of a DXF."""
    lines = path.read_bytes().decode("cp1252").splitlines()
    pairs = [(int(lines[i]), lines[i + 1].strip()) for i in range(0, len(lines) - 1, 2)]
    entities, is_inside = [], False
    for code, value in pairs:
        if code == 2 and value == "ENTITIES":
            is_inside = True
        elif code == 0 and is_inside:
            if value == "ENDSEC":
                break
            entities.append([value, "", False, [], ""])
        elif is_inside and entities:
            last = entities[-1]
            if code == 8:
                last[1] = value
            elif code == 70:
                last[2] = value == "1"
            elif code == 10:
                last[3].append([float(value)])
            elif code == 20:
                last[3][-1].append(float(value))
            elif code == 1:
                last[4] = value
    return [tuple(e) for e in entities]


def list_units():
    """{path of keys without []: (unit, title)} of every result."""
    rows = re.findall(r"^\| `([^`]*)` \| ([^|]*) \| (.*) \|$", run("manual", "--results"), re.MULTILINE)
    return {path.replace("[]", ""): (unit.strip(), title) for path, unit, title in rows}


def list_numbers(node, path=""):
    """(path, number) of every number of a result."""
    if isinstance(node, dict):
        for key, value in node.items():
            yield from list_numbers(value, f"{path}.{key}" if path else key)
    elif isinstance(node, list):
        for value in node:
            yield from list_numbers(value, path)
    elif isinstance(node, (int, float)) and not isinstance(node, bool):
        yield path, node


def is_close(a, b):
    return abs(a - b) <= PRECISION * max(abs(a), abs(b))


class Exports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        (cls.folder / "case.toml").write_text(CASE)
        run("run", cls.folder / "case.toml", "-o", cls.folder / "results", "--no-report")
        cls.summary = json.loads((cls.folder / "results/summary.json").read_text())
        for name in ("tables.xlsx", "section.dxf"):
            result = subprocess.run([PROGRAM, "export", cls.folder / "results", "-o", cls.folder / name], capture_output=True, text=True)
            if "because it has no" in result.stderr:
                print(f"SKIP: {result.stderr.strip()}: nothing was exported", flush=True)
                os._exit(77)
            assert result.returncode == 0, result.stderr
        cls.sheets = read_workbook(cls.folder / "tables.xlsx")
        cls.entities = read_entities(cls.folder / "section.dxf")

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_every_number_of_the_results_is_in_the_workbook(self):
        units = list_units()
        self.assertGreater(len(units), 300)
        found = sorted(c for _, rows in self.sheets.values() for row in rows for c in row if isinstance(c, float))
        missing, count = [], 0
        summary = {key: value for key, value in self.summary.items() if key not in ("input", "results")}
        summary["lem"]["search"].pop("ranges")  # pairs of limits, left out
        for path, number in list_numbers(summary):
            unit = units.get(path, ("", ""))[0]
            shown = number / SHOWN.get(unit, 1)
            count += 1
            i = bisect.bisect_left(found, shown)
            if not any(is_close(x, shown) for x in found[max(i - 1, 0):i + 1]):
                missing.append((path, number, unit))
        self.assertEqual(missing, [])
        self.assertGreater(count, 1000)

    def test_slices_stand_in_their_columns(self):
        units = list_units()
        for kind in ("critical", "noncircular", "given"):
            is_frozen, rows = self.sheets[f"lem.{kind}.slices"]
            self.assertTrue(is_frozen)
            head, rows = rows[0], rows[1:]
            surfaces = self.summary["lem"][kind]
            self.assertEqual(len(rows), sum(len(s["slices"]["left"]) for s in surfaces))
            first = 0
            for number, surface in enumerate(surfaces, 1):
                for i in range(len(surface["slices"]["left"])):
                    row = rows[first + i] + [None] * len(head)
                    self.assertEqual(row[:2], [number, surface["method"]])
                    for key, values in surface["slices"].items():
                        unit, title = units[f"lem.{kind}.slices.{key}"]
                        shown = {"Pa": "kPa", "N/m": "kN/m", "rad": "deg"}.get(unit, unit)
                        parts = values[i] if isinstance(values[i], list) else [values[i]]
                        for part, suffix in zip(parts, [" x", " y"] if len(parts) == 2 else [""]):
                            name = f"{title}{suffix} [{shown}]" if shown else title + suffix
                            if part is None:
                                self.assertTrue(name not in head or row[head.index(name)] is None)
                            elif isinstance(part, str):
                                self.assertEqual(row[head.index(name)], part)
                            else:
                                self.assertTrue(is_close(row[head.index(name)] * SHOWN.get(unit, 1), part), (name, part))
                first += len(surface["slices"]["left"])

    def test_the_summary_has_case_program_and_factors(self):
        cells = [c for row in self.sheets["Summary"][1] for c in row]
        for text in ("=1+1", self.summary["provenance"]["version"], "Spencer", "factor of safety", "Warnings"):
            self.assertIn(text, cells)
        self.assertTrue(any(isinstance(c, float) and is_close(c, self.summary["main_factor"]) for c in cells))
        self.assertEqual(list(self.sheets)[0], "Summary")

    def test_the_input_is_listed(self):
        is_frozen, rows = self.sheets["Input"]
        self.assertTrue(is_frozen)
        listed = {row[0]: row[1:] for row in rows[1:]}
        self.assertEqual(listed["materials.=HYPERLINK(1).unit_weight"], [18.5, "kN/m3", True])
        self.assertEqual(listed["fem.size"], [4, "m", True])

    def test_names_of_sheets_are_short_and_unique(self):
        self.assertTrue(all(len(name) <= 31 for name in self.sheets))
        self.assertEqual(len({name.lower() for name in self.sheets}), len(self.sheets))

    def test_the_drawing_has_soils_water_and_surfaces(self):
        layers = {}
        for kind, layer, closed, points, text in self.entities:
            layers.setdefault(layer, []).append((kind, closed, points, text))
        soils = {layer: [p for kind, closed, p, _ in items if kind == "LWPOLYLINE" and closed] for layer, items in layers.items()}
        self.assertEqual(sorted(len(p) for p in soils["Löß _ _A_"]), [5])
        self.assertEqual(len(soils["_HYPERLINK(1)"]), 2)
        for layer in ("ground", "water_table", "ponds"):
            self.assertTrue(any(kind == "LWPOLYLINE" and not closed for kind, closed, _, _ in layers[layer]), layer)
        for surface in self.summary["methods"]["surfaces"]:
            name = "slip_" + surface["name"].replace(".", "_").replace("[", "_").replace("]", "") + f"_{surface['factor']:.3f}"
            drawn = [points for kind, _, points, _ in layers[name] if kind == "LWPOLYLINE"]
            self.assertEqual(len(drawn), 1)
            self.assertEqual(len(drawn[0]), len(surface["points"]))
            for a, b in zip(drawn[0], surface["points"]):
                self.assertTrue(all(math.isclose(x, y, rel_tol=1e-9, abs_tol=1e-9) for x, y in zip(a, b)))
            texts = [text for kind, _, _, text in layers[name] if kind == "MTEXT"]
            self.assertEqual(len(texts), 1)
            self.assertIn(f"{surface['factor']:.3f}", texts[0])

    def check_import(self, drawing, *options):
        case = self.folder / f"back_{drawing.stem}.toml"
        remarks = run("import", drawing, "-o", case, *options)
        back = tomllib.loads(case.read_text())
        given = tomllib.loads(CASE)["geometry"]["polygon"]
        polygons = {p["name"]: p["points"] for p in back["geometry"]["polygon"]}
        self.assertEqual(set(polygons), {p["name"] for p in given})
        for polygon in given:
            read = polygons[polygon["name"]]
            self.assertEqual(len(read), len(polygon["points"]))
            for a, b in zip(read, polygon["points"]):
                self.assertTrue(all(math.isclose(x, y, rel_tol=1e-9, abs_tol=1e-9) for x, y in zip(a, b)), (a, b))
        return back, remarks

    def test_the_drawing_is_imported_as_the_same_section(self):
        back, remarks = self.check_import(self.folder / "section.dxf")
        table = back["initial"]["water_table"]
        self.assertTrue(all(abs(y - (6.5 - 0.5 * (x - 4000000) / 44.25)) < 1e-5 for x, y in table), table)
        self.assertIn("slip surfaces, supports and ponds", remarks)

    def test_a_drawing_in_millimetres_states_them(self):
        drawing = self.folder / "millimetres.dxf"
        run("export", self.folder / "results", "-o", drawing, "--units", "mm")
        self.assertEqual(max(x for *_, points, _ in read_entities(drawing) for x, _ in points), 4000044250)
        self.check_import(drawing)

    def test_a_case_gives_its_section(self):
        drawing = self.folder / "case.dxf"
        run("export", self.folder / "case.toml", "-o", drawing)
        self.check_import(drawing)
        self.assertFalse(any(layer.startswith("slip_") for _, layer, *_ in read_entities(drawing)))

    def test_the_bars_of_a_support_are_drawn(self):
        case, drawing = self.folder / "held.toml", self.folder / "held.dxf"
        case.write_text(CASE + """
[support.nail]
kind = "nail"
heads = [[4000022, 10]]
ends = [[4000015, 8]]
out_of_plane_spacing = 1.5
tensile_strength = 100
plate = 50
bond = 15
axial_stiffness = 1e5
""")
        run("export", case, "-o", drawing)
        bars = [points for _, layer, *_, points, _ in read_entities(drawing) if layer == "supports"]
        self.assertEqual(len(bars), 1)
        for (x, y), (x_given, y_given) in zip(bars[0], [(4000022, 10), (4000015, 8)]):
            self.assertAlmostEqual(x, x_given, 6)
            self.assertAlmostEqual(y, y_given, 6)
        self.check_import(drawing)

    def test_mistakes_give_one_sentence(self):
        study, solid = self.folder / "study", self.folder / "solid.toml"
        study.mkdir()
        summary = dict(STUDY, format=self.summary["format"])
        (study / "study.json").write_text(json.dumps(summary))
        solid.write_text((ROOT / "examples/slope_3d/case.toml").read_text())
        results, out = self.folder / "results", self.folder / "new.dxf"
        for arguments, part in (
                (("nowhere", "-o", out), "there is no folder of results and no case file 'nowhere'"),
                (("nowhere", "-o", "a.xlsx"), "there is no folder of results 'nowhere'"),
                ((results, "-o", "a.pdf"), "'a.pdf' does not end in .dxf (section) or .xlsx (tables)"),
                ((self.folder, "-o", out), "is no folder of results"),
                ((self.folder, "-o", self.folder / "new.xlsx"), "is no folder of results"),
                ((results, "-o", self.folder / "section.dxf"), "exists; give another name with -o, or --overwrite"),
                ((self.folder / "case.toml", "-o", "a.xlsx"), "is a case, which has no results yet"),
                ((study, "-o", out), "is a study, and a DXF shows one run"),
                ((solid, "-o", out), "is a slope in 3D; a DXF shows a plane section"),
                ((results, "-o", out, "--units", "kPa"), "a length"),
                ((results, "-o", out, "--units", "furlong"), "a DXF cannot state the unit 'furlong'"),
                ((results, "-o", "a.xlsx", "--units", "m"), "--units is the unit of length of a DXF")):
            message = run("export", *arguments, code=2)
            self.assertIn(part, message)
            self.assertEqual(message.count("\n"), 1, message)
        self.assertFalse(out.exists())

    def test_the_table_of_a_study_is_a_sheet(self):
        study = self.folder / "table"
        study.mkdir()
        (study / "study.json").write_text(json.dumps(dict(STUDY, format=self.summary["format"])))
        run("export", study, "-o", self.folder / "study.xlsx")
        sheets = read_workbook(self.folder / "study.xlsx")
        self.assertEqual(sheets["study"][1], [["mesh size [m]", "note"], [0.5, "=2"], [0.25]])

    def test_a_file_is_replaced_where_asked(self):
        path = self.folder / "again.xlsx"
        path.write_text("old")
        self.assertIn("exists", run("export", self.folder / "results", "-o", path, code=2))
        run("export", self.folder / "results", "-o", path, "--overwrite")
        self.assertEqual(read_workbook(path).keys(), self.sheets.keys())


if __name__ == "__main__":
    unittest.main()
