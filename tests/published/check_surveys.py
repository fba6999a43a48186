#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables of lines and boreholes become sections: check_surveys.py PROGRAM."""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

DATA = pathlib.Path(__file__).resolve().parents[1] / "data/tables"
PROGRAM = sys.argv.pop(1)
HOLES = """\
hole;x [m];collar (m);top_m;bottom_m;soil
BH2;20;9,5;0;2,0;fill
BH2;20;9,5;2;6,5;clay
BH2;20;9,5;6,5;12;sand
# a comment
BH1;0;10,0;0;4,0;clay
BH1;0;10,0;4,0;11;sand
BH3;40;5,0;0;3;clay
BH3;40;5;3;3,5;peat
BH3;40;5;3,5;5;sand
BH4;60;5;0;4;clay
"""


class Surveys(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, **texts):
        for name, text in texts.items():
            (self.folder / f"{name}.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
        return [self.folder / f"{name}.csv" for name in texts]

    def run_import(self, files, *options):
        case = self.folder / "case.toml"
        result = subprocess.run([PROGRAM, "import", *files, "-o", case, "--overwrite", *options], capture_output=True, text=True)
        return result, tomllib.loads(case.read_text()) if result.returncode == 0 else None

    def read(self, files, *options):
        result, case = self.run_import(files, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return case, result.stdout

    def find_fault(self, files, *options):
        result, _ = self.run_import(files, *options)
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        return result.stderr

    def run_lem(self, case, added="", **strengths):
        """Completes every material, adds a text, checks the case and returns the summary of a run."""
        text = (self.folder / "case.toml").read_text() + added
        for key, value in {"unit_weight": 19, "cohesion": 10, "friction_angle": 28, **strengths}.items():
            text = "\n".join(f"{key} = {value}" if line.startswith(f"# {key} =") else line for line in text.split("\n"))
        path = self.folder / "complete.toml"
        path.write_text(text)
        checked = subprocess.run([PROGRAM, "check", path], capture_output=True, text=True)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        # The section is what these tests are about: one method and its circles find its factor.
        search = [word for key in ("noncircular", "yield_acceleration", "referee") for word in ("--set", f"lem.{key}=false")]
        subprocess.run([PROGRAM, "run", path, "-o", self.folder / "out", "--no-report", "--set", "lem.methods=['bishop', 'spencer']", *search],
                       check=True, capture_output=True)
        return json.loads((self.folder / "out/summary.json").read_text())

    def test_lines_become_layers_and_run(self):
        ground = "x,y\n0,20\n10,20\n30,10\n50,10\n"
        case, printed = self.read(self.write(ground=ground, clay="x,y\n0,12\n50,7\n", rock="x,y\n0,0\n50,0\n"))
        self.assertEqual(case["geometry"]["ground"], [[0, 20], [10, 20], [30, 10], [50, 10]])
        self.assertEqual([layer["name"] for layer in case["geometry"]["layer"]], ["clay", "rock"])
        self.assertEqual(case["geometry"]["layer"][0]["bottom"], [[0, 12], [50, 7]])
        self.assertIn("lengths without a unit count as metres", printed)
        factors = [r["factor"] for r in self.run_lem(case)["lem"]["critical"]]
        self.assertTrue(all(1 < f < 4 for f in factors), factors)

    def test_separators_units_and_marks_of_spreadsheets_make_no_difference(self):
        plain, _ = self.read(self.write(a="x,y\n0,20\n40.5,10\n"), "--base=-5")
        for text in (b"\xef\xbb\xbfStation [m];Elevation [m]\r\n0;20,0\r\n40,5;10\r\n", b"chainage\tlevel\n0\t20\n40,5\t10\n",
                     b"% from the total station\n0 20\n// end of the cut\n40.5   10\n", b"x [ft],z (mAOD)\n0,20\n132.8740157480315,10\n",
                     b'Distance_m,Code,Elevation_cm\n0,"a, b",2000\n40.5,c,1000\n',
                     b"x [m]  y [m]\n0 20\n40.5 10\n", b"x,y\nm,m\n40.5,10\n0,20\n"):
            case, _ = self.read(self.write(a=text), "--base=-5")
            self.assertEqual(case["geometry"], plain["geometry"], text)
        case, _ = self.read(self.write(a="x,y\n0,65.61679790026247\n132.8740157480315,32.808398950131235\n"), "--base=-5", "--units", "ft")
        self.assertEqual(case["geometry"], plain["geometry"])
        case, _ = self.read(self.write(a="x,y\n0,20\n40.5,10\n"), "--base=-10 ft")
        self.assertEqual(case["geometry"]["layer"], [{"name": "soil", "level": -3.048}])

    def test_columns_without_headings_and_headings_of_others(self):
        case, printed = self.read(self.write(a="0 0 10\n3 4 9\n30 40 5\n"), "--base=0")
        self.assertEqual(case["geometry"]["ground"], [[0, 10], [5, 9], [50, 5]])
        self.assertIn("as x, y and z", printed)
        case, _ = self.read(self.write(a="Punkt\tStation\tHöhe [m]\n1\t0,00\t12,50\n2\t10,00\t8,25\n".encode("latin-1")), "--base=0")
        self.assertEqual(case["geometry"]["ground"], [[0, 12.5], [10, 8.25]])
        case, _ = self.read(self.write(a="Bohrung;x;z;von;bis;Schicht\nB1;0;9;0;2;Auffüllung\nB1;0;9;2;6;Ton\nB2;20;8;0;3;Auffüllung\nB2;20;8;3;5;Ton\n"))
        self.assertEqual(case["geometry"]["layer"][0], {"name": "Auffüllung", "depths": [[0, 2], [20, 3]]})

    def test_boreholes_with_a_row_for_each_layer(self):
        case, printed = self.read(self.write(holes=HOLES))
        self.assertEqual(case["geometry"]["ground"], [[0, 10], [20, 9.5], [40, 5], [60, 5]])
        self.assertEqual(case["geometry"]["layer"], [
            {"name": "fill", "depths": [[0, 0], [20, 2], [40, 0], [60, 0]]}, {"name": "clay", "depths": [[0, 4], [20, 6.5], [40, 3], [60, 4]]},
            {"name": "peat", "depths": [[0, 4], [20, 6.5], [40, 3.5], [60, 4]]}, {"name": "sand", "level": -2.5}])
        self.assertIn("borehole BH4 ends above the lower boundary of 'clay', which was drawn through its end, 4 m deep", printed)
        self.assertIn("level at y = -2.5 m, the lowest end of a borehole", printed)
        self.assertGreater(self.run_lem(case)["lem"]["critical"][0]["factor"], 1)

    def test_boreholes_with_a_row_each_and_a_ground_of_its_own(self):
        ground = "x,y\n0,30\n60,20\n"
        holes = "name;x [m];colluvium [m];weathered rock [m]\nBH1;12,0;4,7;9,5\nBH3;48,0;6,1;\nBH2;24;0;\n"
        case, printed = self.read(self.write(ground=ground, holes=holes), "--base=0")
        self.assertEqual(case["geometry"]["layer"], [
            {"name": "colluvium", "depths": [[12, 4.7], [24, 0], [48, 6.1]]}, {"name": "weathered rock", "depths": [[12, 9.5]]},
            {"name": "base", "level": 0}])
        self.assertIn("a row for each and a column for each boundary", printed)

    def test_positions_and_layers_in_two_tables(self):
        collars = "HOLEID,EASTING,NORTHING,ELEVATION\nA,1000,2000,50\nB,1030,2040,46\nC,1060,2080,40\n"
        layers = "HOLEID,FROM,TO,LITHOLOGY\nA,0,3,silt\nA,3,20,marl\nB,0,5,silt\nB,5,12,marl\nC,0,2,silt\nC,2,9,marl\n"
        case, printed = self.read(self.write(collars=collars, layers=layers))
        self.assertEqual(case["geometry"]["ground"], [[0, 50], [50, 46], [100, 40]], "distances along the line of the boreholes")
        self.assertEqual(case["geometry"]["layer"][0], {"name": "silt", "depths": [[0, 3], [50, 5], [100, 2]]})
        self.assertIn("azimuth 36.9°", printed)

    def test_a_soil_that_returns_is_a_layer_of_the_same_material(self):
        case, _ = self.read(self.write(h="hole,x,z,bottom,soil\nA,0,9,2,clay\nA,0,9,4,sand\nA,0,9,9,clay\nB,20,8,3,clay\nB,20,8,5,sand\nB,20,8,9,clay\n"))
        self.assertEqual(case["regions"], {"clay": "clay", "sand": "sand", "clay 2": "clay"})
        self.assertEqual(set(case["materials"]), {"clay", "sand"})

    def test_orders_that_contradict_one_another_are_named(self):
        fault = self.find_fault(self.write(h="hole,x,z,bottom,soil\nA,0,9,2,clay\nA,0,9,4,sand\nB,20,8,3,sand\nB,20,8,5,clay\n"))
        self.assertRegex(fault, r"'clay' is above 'sand' in borehole A \(.*h.csv:2\), and below it in borehole B \(.*h.csv:4\)")
        rows = [f"{hole},{x},9,{depth},{soil}" for hole, x, soils in (("A", 0, "ab"), ("B", 9, "bc"), ("C", 18, "ca")) for depth, soil in zip((2, 5), soils)]
        fault = self.find_fault(self.write(h="\n".join(["hole,x,z,bottom,soil", *rows])))
        for part in ("'a' is above 'b' in borehole A", "'b' is above 'c' in borehole B", "'c' is above 'a' in borehole C"):
            self.assertIn(part, fault)

    def test_what_is_not_understood_is_listed_with_its_line(self):
        case, printed = self.read(self.write(a="x,y\n0,20\nabout here,15\n20,\n40,10\n"), "--base=0")
        self.assertEqual(case["geometry"]["ground"], [[0, 20], [40, 10]])
        self.assertIn("a.csv:3: 'about here' is not a number; the row was not used", printed)
        self.assertIn("1 row of", printed)
        _, printed = self.read(self.write(h=HOLES + "BH5;80;5;0;two;clay\n"))
        self.assertIn("h.csv:12: 'two' is not a number", printed)
        self.assertIn("borehole BH5 was left out, because of a row that is not understood", printed)

    def test_tables_of_others(self):
        case, printed = self.read([DATA / "subsurface_no_tops.csv"])
        self.assertEqual([layer["name"] for layer in case["geometry"]["layer"]],
                         ["Quaternary", "MittlererBuntsandsteinGP", "Zechstein", "UntererKeuperGP", "OberJura", "UnterJura", "MittelJura"])
        self.assertAlmostEqual(case["geometry"]["ground"][1][0], ((32429575.25 - 32428405.75)**2 + (5782307.49 - 5784686.57)**2)**0.5, places=3)
        case, printed = self.read([DATA / "pygslib_collar.csv", DATA / "pygslib_litho.csv"])
        self.assertEqual(case["geometry"]["layer"][0]["name"], "Casing")
        self.assertEqual(len(case["geometry"]["layer"]), 12)
        self.assertEqual(case["regions"]["Early Diorite 2"], "Early Diorite")
        self.assertIn("borehole B-576 (", printed)
        case, _ = self.read([DATA / "own_slope_surface.csv", DATA / "own_slope_base.csv"])
        self.assertEqual(len(case["geometry"]["ground"]), 60)
        self.assertGreater(self.run_lem(case)["lem"]["critical"][0]["factor"], 1)

    def measure_areas(self, summary):
        """Areas of the soils of a run [m²], by the shoelace formula."""
        areas = {}
        for polygon in summary["input"]["geometry"]["polygon"]:
            points = polygon["points"]["value"]
            twice = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))
            areas[polygon["name"]["value"]] = abs(twice) / 2
        return areas

    def test_cross_section_of_a_river_with_lines_above_its_headings(self):
        """The points are in feet, and neither in their order nor with a unit in the headings."""
        case, printed = self.read([DATA / "aquarius_cross_section.csv"], "--base=-3")
        foot = 0.3048
        ground = [[0, 7.467], [19.1, 6.909], [44.8, 6.3], [70.1, 5.356], [82.4, 5.287]]
        for found, expected in zip(case["geometry"]["ground"], ground, strict=True):
            self.assertAlmostEqual(found[0], expected[0] * foot, places=5)
            self.assertAlmostEqual(found[1], expected[1] * foot, places=5)
        self.assertIn("11 lines above the headings, of which the unit is used: ft", printed)
        self.assertNotIn("without a unit", printed)
        summary = self.run_lem(case, cohesion=0.01, friction_angle=5)
        area = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(ground, ground[1:])) * foot**2 + 3 * 82.4 * foot
        self.assertAlmostEqual(self.measure_areas(summary)["soil"], area, places=4)
        # An infinite slope as steep as the steepest part has tan 5° / (0.944 / 25.3) = 2.345.
        for found in summary["lem"]["critical"]:
            self.assertTrue(2.345 < found["factor"] < 2.5, found["factor"])

    def test_boreholes_of_an_ags_file(self):
        """AGS 3 with headings on two lines, rows that <CONT> continues, groups of no use, and a borehole without layers."""
        case, printed = self.read([DATA / "kaitak_boreholes.ags"])
        self.assertIn("group HOLE has positions of boreholes", printed)
        self.assertIn("kaitak_boreholes.ags:13) has no layers, and was left out", printed)
        self.assertIn("azimuth 39.4°", printed)
        x = [hole[0] for hole in case["geometry"]["ground"]]
        self.assertAlmostEqual(x[1], ((838293.22 - 838261.55)**2 + (820443.88 - 820399.78)**2)**0.5, delta=0.2)
        self.assertEqual([level for _, level in case["geometry"]["ground"]], [4.89, 4.42, 4.89])
        above, below = case["geometry"]["layer"]
        self.assertEqual((above["name"], below["name"]), ("Q", "L"))
        self.assertEqual([depth for _, depth in above["depths"]], [31, 24, 20.3], "fill and alluvium above the granite")
        self.assertAlmostEqual(below["level"], 4.89 - 53.39)
        summary = self.run_lem(case, '[[surcharge]]\nname = "stand"\nx = [60, 75]\nload = [250, 250]\n')
        areas = self.measure_areas(summary)
        thick = (x[1] - x[0]) * (31 + 24) / 2 + (x[2] - x[1]) * (24 + 20.3) / 2
        self.assertAlmostEqual(areas["Q"], thick, places=2)
        self.assertAlmostEqual(areas["Q"] + areas["L"], (x[2] - x[0]) * (48.5 + (4.89 + 4.42) / 2), places=2)
        self.assertTrue(all(1 < found["factor"] < 5 for found in summary["lem"]["critical"]))

    def test_boreholes_of_a_section_are_chosen_by_name(self):
        case, printed = self.read([DATA / "kaitak_boreholes.ags"], "--boreholes", "BH43", "--boreholes", "BH45")
        self.assertEqual(len(case["geometry"]["ground"]), 2)
        self.assertIn("2 boreholes that --boreholes does not name were left out", printed)
        self.assertIn("did you mean 'BH45'?", self.find_fault([DATA / "kaitak_boreholes.ags"], "--boreholes", "bh45"))
        self.assertIn("no meaning for a drawing", self.find_fault([self.folder / "a.dxf"], "--boreholes", "BH1"))

    def test_ags_of_version_4_with_codes_of_soils(self):
        groups = """"GROUP","LOCA"
"HEADING","LOCA_ID","LOCA_NATE","LOCA_NATN","LOCA_GL"
"UNIT","","m","m","m"
"TYPE","ID","2DP","2DP","2DP"
"DATA","BH1","0.00","100.00","20.00"
"DATA","BH2","30.00","140.00","15.00"

"GROUP","GEOL"
"HEADING","LOCA_ID","GEOL_TOP","GEOL_BASE","GEOL_DESC","GEOL_LEG","GEOL_GEOL"
"UNIT","","m","m","","",""
"TYPE","ID","2DP","2DP","X","PA","PA"
"DATA","BH1","0.00","2.50","Brown ""stiff"" CLAY, sandy","202",""
"DATA","BH1","2.50","9.00","Grey SAND","403",""
"DATA","BH2","0.00","4.00","Grey CLAY","202",""
"DATA","BH2","4.00","8,00","Grey SAND","403",""
"""
        codes = '"GROUP","ABBR"\n"HEADING","ABBR_HDNG","ABBR_CODE","ABBR_DESC"\n"DATA","GEOL_LEG","202","Silty CLAY"\n'
        path = self.folder / "site.AGS"
        path.write_bytes(b"\xef\xbb\xbf" + (groups.replace("8,00", "8.00") + codes).replace("\n", "\r\n").encode())
        case, _ = self.read([path])
        self.assertEqual(case["geometry"]["ground"], [[0, 20], [50, 15]])
        self.assertEqual(case["geometry"]["layer"], [{"name": "Silty CLAY", "depths": [[0, 2.5], [50, 4]]}, {"name": "403", "level": 7}])
        path.write_text(groups)
        self.assertIn("one borehole of 2 that can be used and no ground", self.find_fault([path]), "BH2 has a comma in a number, and is left out")
        for text, said in ((groups[:groups.index('"GROUP","GEOL"')], "no group GEOL"), (groups[groups.index('"GROUP","GEOL"'):], "no group LOCA"),
                           ("x,y\n1,2\n", "no groups of the AGS format"), ("", "no groups"), ('"GROUP","LOCA"\n"GROUP","GEOL"\n', "site.AGS:1: the group LOCA has no line of headings")):
            path.write_text(text)
            self.assertIn(said, self.find_fault([path]))

    def test_boreholes_of_ags_that_are_easily_misread(self):
        places = "**HOLE\n*HOLE_ID,*HOLE_NATE,*HOLE_NATN,*HOLE_GL,*HOLE_INCL\n{0},0,0,20,{1}\nB2,50,0,15,90\n"
        layers = "**GEOL\n*HOLE_ID,*GEOL_TOP,*GEOL_BASE,*GEOL_GEOL\n" + "".join(
            f"{{0}},0,2,QA\n{{0}},2,5,QB\n{hole},0,3,QA\n{hole},3,6,QB\n" if hole == "B2" else "" for hole in ("B2",))
        codes = "**ABBR\n*ABBR_HDNG,*ABBR_CODE,*ABBR_DESC\nGEOL_GEOL,QA,Alluvium\nGEOL_GEOL,QB,Alluvium\n"
        path = self.folder / "site.ags"
        write = lambda name, angle: path.write_text(places.format(name, angle) + layers.format(name) + codes)
        write('"#3"', 90)
        case, _ = self.read([path])
        self.assertEqual(case["geometry"]["ground"], [[0, 20], [50, 15]], "a name with # is no comment")
        self.assertEqual([layer["name"] for layer in case["geometry"]["layer"]], ["QA", "QB"], "one description of two codes")
        write("B1", 45)
        self.assertIn("borehole B1 is inclined, HOLE_INCL = 45°", self.find_fault([path]))

    def test_tables_that_are_easily_misread(self):
        line = [[0, 10.5], [20, 9], [50, 4]]
        for text in ("Punkt;Abstand;Höhe;Genauigkeit\n1;0;10,5;0,02\n2;20;9,0;0,02\n3;50;4,0;0,02\n",
                     "PointNo,x,z\n101,0,10.5\n57,20,9\nTBM1,50,4\n",
                     "Cross section 3: surface elevation vs distance\n\nDistance,Elevation\n0,10.5\n20,9\n50,4\n"):
            case, _ = self.read(self.write(a=text), "--base=-5", "--units", "m")
            self.assertEqual(case["geometry"]["ground"], line, text)
        self.assertIn("a.csv' is in UTF-16", self.find_fault(self.write(a="x,z\n0,1\n5,1\n".encode("utf-16")), "--base=-5"))
        _, printed = self.read(self.write(a="x [m],z [m],b\xe9\n0,1,2\n5,1,2\n".encode("latin-1")), "--base=-5")
        self.assertIn("was read as Latin-1", printed)

    def test_faults_are_one_sentence(self):
        for text, options, fault in (
                ("a,b\n1,2\n", (), "neither those of a line"), ("", (), "is empty"), ("x,y\n", (), "no rows"),
                ("x,y\n0,1\n5,1\n3,1\n9,1\n", ("--base=0",), "a.csv:4: the line folds back from x = 5 m to x = 3 m"),
                ("x,y\n0,1\n5,1\n", (), "nothing below it"), ("x,y\n0,1\n0,5\n", ("--base=0",), "has no width"),
                ("hole,x,z,bottom,soil\nA,1,2,3,clay\n", (), "one borehole and no ground"),
                ("hole,x,z,bottom,soil\nA,1,2,3,clay\nB,1,2,3,clay\n", (), "are both at x = 1 m"),
                ("hole,x,z,bottom,soil\nA,1,2,3,clay\nA,1,2,9,sand\nB,9,2,3,clay\n", ("--base=0",), "is not below the lowest boundary"),
                ("hole,bottom,soil\nA,3,clay\nB,4,clay\n", (), "has no position"),
                ("1,2,3,4\n5,6,7,8\n", (), "has 4 columns without headings"), ("P1,10.5,20.2,5.1,TOE\nP2,11,21,6,\n", (), "in its first line and no headings"),
                ("name,lat,lon,z\nA,51.5,-0.1,20\n", (), "are latitudes and longitudes"),
                ("hole,x,z,from,to,soil\nA,0,10,0,3,clay\nB,20,8,0,2,clay\nB,20,8,1,9,sand\n", (), "one borehole of 2 that can be used and no ground: give a table of the ground (x and elevation) too; borehole B ("),
                ("X,Y,Distance (ft),Z (ft)\n0,0,0,9\n0,44,100,5\n", ("--base=-9",), "is 30.48 m long by 'Distance (ft)' and 44 m by 'X' and 'Y'"),
                ("x [kg],y\n0,1\n", (), "'x' of"), ("x,y\n0,1\n5,1\n", ("--lines", "tops"), "no meaning for tables"),
                ("x,y\n0,1\n5,1e12\n", ("--base=0",), "has one point"), ("x,y\n" + "".join(f"{i / 50},{i % 2}\n" for i in range(5000)), ("--base=-9",), "the survey has 5000 points")):
            self.assertIn(fault, self.find_fault(self.write(a=text), *options), text[:60])
        self.assertIn("cannot be read: No such file", self.find_fault([self.folder / "none.csv"]))
        (self.folder / "b.dxf").write_text("")
        self.assertIn("several files must be tables", self.find_fault([*self.write(a="x,y\n0,1\n5,1\n"), self.folder / "b.dxf"]))


if __name__ == "__main__":
    unittest.main()
