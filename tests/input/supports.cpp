// SPDX-License-Identifier: MIT
// [support.NAME]: patterns on slopes to either side, and the message on each fault.

#include "input/case/support_places.hpp"

#include <cmath>

#include "methods_slope.hpp"

namespace talus::input {
namespace {

/// Nails in the slope of slices_alone, which rises from (30, 25) to (50, 35).
std::string write_nails(const std::string& where = "first = [48, 34]\nrows = 3\nrow_spacing = 3\n",
                        const std::string& length = "inclination = 15\nlength = 8\n",
                        const std::string& resistance =
                            "out_of_plane_spacing = 1.5\ntensile_strength = 100\nplate = "
                            "50\nbond = 20\n") {
  return slices_alone + "[support.nails]\nkind = \"nail\"\n" + where + length + resistance;
}

const mesh::Polyline rising{{0, 25}, {30, 25}, {50, 35}, {90, 35}};
const ShownUnit metre{"m", 1};

TEST(Supports, RowsGoDownTheSlope) {
  const Case data = read(write_nails());
  const BarLayout layout = lay_bars(data.supports.at("nails"), rising, metre);
  ASSERT_EQ(layout.bars.size(), 3u);
  EXPECT_NEAR(layout.bars[1].head[0], 42, 1e-9);
  EXPECT_NEAR(layout.bars[2].head[1], 28, 1e-9);
  for (const BarLine& bar : layout.bars) {
    EXPECT_NEAR(bar.length(), 8, 1e-9);
    EXPECT_NEAR(bar.end[0] - bar.head[0], 8 * std::cos(15 * 0.017453292519943295), 1e-9);
    EXPECT_LT(bar.end[1], bar.head[1]);
  }
}

TEST(Supports, SpacingAlongTheFace) {
  Support support;
  support.first = std::array{48.0, 34.0};
  support.rows = 2;
  support.row_spacing = std::sqrt(5.0);
  support.spacing_along = RowSpacing::face;
  support.inclination = 0;
  support.lengths = {4, 6};
  const BarLayout layout = lay_bars(support, rising, metre);
  ASSERT_EQ(layout.bars.size(), 2u);
  EXPECT_NEAR(layout.bars[1].head[0], 46, 1e-9);
  EXPECT_NEAR(layout.bars[1].head[1], 33, 1e-9);
  EXPECT_NEAR(layout.bars[1].end[0], 52, 1e-9);
}

TEST(Supports, MirroredSlopeHasMirroredBars) {
  const Case data = read(write_nails());
  Support mirrored = data.supports.at("nails");
  mirrored.first = std::array{90.0 - 48, 34.0};
  const mesh::Polyline falling{{0, 35}, {40, 35}, {60, 25}, {90, 25}};
  const BarLayout right = lay_bars(data.supports.at("nails"), rising, metre), left = lay_bars(mirrored, falling, metre);
  ASSERT_EQ(left.bars.size(), right.bars.size());
  for (std::size_t i = 0; i < left.bars.size(); ++i) {
    EXPECT_NEAR(left.bars[i].head[0], 90 - right.bars[i].head[0], 1e-9);
    EXPECT_NEAR(left.bars[i].end[0], 90 - right.bars[i].end[0], 1e-9);
    EXPECT_NEAR(left.bars[i].end[1], right.bars[i].end[1], 1e-9);
  }
}

TEST(Supports, RowsOnAVerticalFace) {
  Support support;
  support.first = std::array{0.0, 5.0};
  support.rows = 3;
  support.row_spacing = 2;
  support.inclination = 0;
  support.length = 4;
  const BarLayout layout = lay_bars(support, {{-10, 0}, {0, 0}, {0, 6}, {20, 6}}, metre);
  ASSERT_EQ(layout.bars.size(), 3u);
  EXPECT_NEAR(layout.bars[2].head[1], 1, 1e-9);
  EXPECT_NEAR(layout.bars[2].head[0], 0, 1e-9);
  EXPECT_NEAR(layout.bars[2].end[0], 4, 1e-9);
  support.rows = 4;
  EXPECT_NE(lay_bars(support, {{-10, 0}, {0, 0}, {0, 6}, {20, 6}}, metre).fault.find("beyond the foot"),
            std::string::npos);
}

TEST(Supports, RowsOnABenchLeadIntoTheSlope) {
  // Rows along the face, the third on the level bench.
  Support support;
  support.rows = 4;
  support.row_spacing = std::sqrt(8.0);
  support.spacing_along = RowSpacing::face;
  support.inclination = 0;
  support.length = 5;
  const mesh::Polyline benched{{0, 0}, {16, 0}, {20, 4}, {23, 4}, {26, 7}, {40, 7}};
  support.first = std::array{25.0, 6.0};
  const BarLayout layout = lay_bars(support, benched, metre);
  ASSERT_EQ(layout.fault, "");
  ASSERT_EQ(layout.bars.size(), 4u);
  EXPECT_NEAR(layout.bars[2].head[1], 4, 1e-9) << "on the bench";
  EXPECT_NEAR(layout.bars[3].head[1], 4 - (3 * std::sqrt(8.0) - std::sqrt(8.0) - 3) / std::sqrt(2.0), 1e-9);
  for (const BarLine& bar : layout.bars)
    EXPECT_NEAR(bar.end[0] - bar.head[0], 5, 1e-9) << "all lead to the side of the first";
  support.rows = 6;
  EXPECT_NE(lay_bars(support, benched, metre).fault.find("row 6 of 6 lies beyond the foot"), std::string::npos)
      << "and none onto the level ground in front of the toe";
}

TEST(Supports, NeedOnePlace) {
  expect_one_fault(write_nails(""), "support 'nails': it has no place; give either 'heads', or 'first' and 'rows'");
  expect_one_fault(write_nails("first = [48, 34]\nheads = [[46, 33]]\n"), "its place is given twice");
  expect_one_fault(write_nails("first = [48, 34]\nrows = 2\n"), "2 rows need a 'row_spacing'");
  expect_fault(write_nails("heads = [[48, 34]]\nrows = @@2\n"), "rows need their 'first' head");
  expect_one_fault(write_nails("x = [40]\n"), "'x'");
  expect_fault(write_nails("first = [48, 34]\nrows = @@20\nrow_spacing = 3\n"), "lies beyond the foot of the slope");
}

TEST(Supports, NeedOneLength) {
  const std::string where = "heads = [[48, 34], [44, 32]]\n";
  expect_one_fault(write_nails(where, "inclination = 15\n"),
                   "it has no length; give 'length', or 'lengths' of each row");
  expect_one_fault(write_nails(where, "length = 8\n"), "it needs an 'inclination', or 'ends'");
  expect_fault(write_nails(where, "inclination = 15\nlength = 8\nlengths = @@[8, 8]\n"), "given twice");
  expect_fault(write_nails(where, "inclination = 15\nlengths = @@[8]\n"), "'lengths' has 1 values for 2 heads");
  expect_fault(write_nails(where, "ends = @@[[56, 30]]\n"), "'ends' has 1 points for 2 heads");
  expect_fault(write_nails(where, "ends = [[56, 30], [52, 28]]\ninclination = @@10\n"),
               "belongs to bars without 'ends'");
  expect_fault(write_nails(where, "inclination = 15\nlength = @@-8\n"), "it must be above 0");
}

TEST(Supports, LieInTheSoil) {
  expect_fault(write_nails("heads = @@[[48, 36]]\n"), "the head (48, 36) lies in the air");
  expect_fault(write_nails("heads = @@[[48, 30]]\n"), "lies in the soil");
  expect_fault(write_nails("heads = [[48, 34]]\n", "ends = @@[[40, 36]]\n"), "above the ground");
  expect_fault(write_nails("heads = [[48, 34]]\n", "inclination = 80\nlength = @@30\n"), "below its bottom");
  expect_fault(write_nails("heads = [[48, 34]]\n", "inclination = 0\nlength = @@60\n"), "the side of the section");
  expect_fault(write_nails("heads = @@[[10, 25]]\n"), "it is not on an inclined part of the ground");
}

TEST(Supports, NeedResistance) {
  const std::string where = "heads = [[48, 34]]\n", length = "inclination = 15\nlength = 8\n",
                    bar = "out_of_plane_spacing = 1.5\nplate = 50\n";
  expect_fault(write_nails(where, length, bar + "bond = 20\ntensile_strength = @@0\n"), "it must be above 0");
  expect_fault(
      write_nails(where, length, "out_of_plane_spacing = @@-1.5\nplate = 50\nbond = 20\ntensile_strength = 90\n"),
      "it must be above 0");
  expect_one_fault(write_nails(where, length, bar + "tensile_strength = 90\n"), "it has no resistance to pull-out");
  expect_one_fault(write_nails(where, length, bar + "tensile_strength = 90\nbond_friction = 25\n"),
                   "give its 'diameter'");
  expect_fault(write_nails(where, length, bar + "tensile_strength = 90\nbond = @@20\nbond_adhesion = 5\n"),
               "given twice");
  expect_fault(write_nails(where, length, bar + "tensile_strength = 90\nbond = 20\nconnection = @@4\n"), "kind");
}

TEST(Supports, StagesNameTheirSupports) {
  expect_one_fault(write_nails() + "stage = 2\n",
                   "'stage' in [support.nails]: supports come and go by their names in 'add' and 'remove' of "
                   "[[construction]]");
}

/// A cut of 2 m that is dug out of level ground in two steps, and a support.
std::string write_stages(const std::string& support, const std::string& stages) {
  return R"(
title = "Cut"
[[geometry.polygon]]
name = "ground"
points = [[0, -6], [20, -6], [20, 0], [10, 0], [10, 2], [0, 2]]
[[geometry.polygon]]
name = "cut_1"
points = [[10, 1], [20, 1], [20, 2], [10, 2]]
[[geometry.polygon]]
name = "cut_2"
points = [[10, 0], [20, 0], [20, 1], [10, 1]]
[regions]
ground = "soil"
cut_1 = "soil"
cut_2 = "soil"
[materials.soil]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 5
friction_angle = 30
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
[analysis]
methods = ["fem"]
[fem]
size = 2
)" + support +
         "[[construction]]\nname = \"one\"\nduration = 1\nremove = [\"cut_1\"]\n" + stages;
}

TEST(Supports, StandOnTheGroundOfTheStageThatAddsThem) {
  const auto write_nail = [](const char* head) {
    return fmt::format(
        "[support.nail]\nkind = \"nail\"\nheads = [[10, {}]]\ninclination = 10\nlength = 5\nplate = 40\n"
        "out_of_plane_spacing = 1.5\n"
        "tensile_strength = 120\nbond = 18\naxial_stiffness = 1e5\n",
        head);
  };
  const std::string two = "[[construction]]\nname = \"two\"\nduration = 1\nremove = [\"cut_2\"]\n";
  const std::string now = "add = [\"nail\"]\n";
  const std::string text = write_stages(write_nail("1.5"), now + two);
  EXPECT_TRUE(find_faults(text).empty());
  EXPECT_TRUE(find_faults(write_stages(write_nail("0.5"), two + now)).empty());
  expect_one_fault(write_stages(write_nail("0.5"), now + two),
                   "the head (10, 0.5) lies in the soil, 0.5 m below the ground of stage 'one'");
  expect_one_fault(write_stages(write_nail("1.5"), two), "lies in the soil, 0.5 m below the ground at the start");
  const Case data = read(text);
  const Support fixed = fix_places(data.supports.at("nail"), lay_bars(data, "nail"));
  const BarLayout before = lay_bars(data, "nail"), after = lay_bars(fixed, {{0, 2}, {20, 2}}, metre);
  EXPECT_EQ(after.bars.at(0).head, before.bars.at(0).head);
  EXPECT_EQ(after.bars.at(0).end, before.bars.at(0).end);
  EXPECT_LT(before.bars.at(0).end[0], 10) << "into the soil that stays";
}

TEST(Supports, LeaveWithTheSoilAroundThem) {
  const std::string sheet =
      "[support.sheet]\nkind = \"geosynthetic\"\nheads = [[20, 1.5]]\nends = [[12, 1.5]]\nstrength = 20\nconnection = "
      "0\n"
      "bond_friction = 20\nsheet_stiffness = 1e3\n";
  expect_one_fault(write_stages(sheet, ""), "stage 'one' removes the soil at (20, 1.5)");
  EXPECT_TRUE(find_faults(change(write_stages(sheet, ""), "[\"cut_1\"]", "[\"cut_1\", \"sheet\"]")).empty());
}

TEST(Supports, StrutsComeWithTheStageThatExposesTheirWall) {
  const std::string wall =
      "[support.sheet]\nkind = \"wall\"\nline = [[10, 2], [10, -4]]\naxial_stiffness = 2e6\n"
      "bending_stiffness = 5e4\ninterface_strength = 0.7\nstrut_levels = [1.5, 0.5]\nstrut_stiffness = 2e4\n"
      "strut_strength = 200\n";
  const std::string two = "[[construction]]\nname = \"two\"\nduration = 1\nremove = [\"cut_2\"]\n";
  const std::string first = "add = [\"sheet.strut_1\"]\n", second = "add = [\"sheet.strut_2\"]\n";
  EXPECT_TRUE(find_faults(write_stages(wall, first + two + second)).empty());
  expect_one_fault(write_stages(wall, first + two),
                   "the strut at y = 0.5 m has soil on both sides of the wall at the start; let the stage that exposes "
                   "it add \"sheet.strut_2\"");
  expect_one_fault(write_stages(wall, "add = [\"sheet.strut_1\", \"sheet.strut_3\"]\n" + two + second),
                   "there is no region, surcharge, support or drain 'sheet.strut_3'");
  expect_one_fault(change(write_stages(wall, first + two + second), "[1.5, 0.5]", "[2.5, 0.5]"),
                   "the strut at y = 2.5 m is above or below the wall");
}

TEST(Supports, WallsDoNotMeetThemselves) {
  const auto write = [](const char* line) {
    return slices_alone + "[support.sheet]\nkind = \"wall\"\nline = " + line + "\n";
  };
  expect_one_fault(write("[[40, 30], [40, 22], [39, 23], [41, 23]]"), "'line' meets itself");
  expect_one_fault(write("[[40, 30], [40, 22], [40, 29]]"), "'line' meets itself at (40, 29)");
  EXPECT_TRUE(find_faults(write("[[40, 30], [40, 22], [39, 23]]")).empty());
}

TEST(Supports, AnchorHasABondedPart) {
  const auto write = [](const std::string& part) {
    return slices_alone +
           "[support.tie]\nkind = \"anchor\"\nheads = [[48, 34]]\ninclination = 20\nlength = 15\nout_of_plane_spacing "
           "= "
           "2\ntensile_strength = 400\nplate = 300\nbond = 60\n" +
           part;
  };
  EXPECT_TRUE(find_faults(write("bond_length = 6\n")).empty());
  expect_one_fault(write(""), "an anchor is bonded over a part of its length; give 'free_length' or 'bond_length'");
  expect_fault(write("bond_length = @@16\n"), "the bond length, 16 m, exceeds the length of the anchor in row 1, 15 m");
  expect_fault(write("free_length = @@15\n"), "leaves nothing bonded of the anchor in row 1");
}

TEST(Supports, PilesNeedAForce) {
  const auto write = [](const std::string& law) {
    return slices_alone + "[support.row]\nkind = \"pile\"\nx = [40]\nlength = 8\nout_of_plane_spacing = 2\n" + law;
  };
  EXPECT_TRUE(find_faults(write("lateral_resistance = 60\n")).empty());
  EXPECT_TRUE(find_faults(write("lateral_law = \"ito_matsui\"\ndiameter = 0.8\n")).empty());
  expect_one_fault(write(""), "needs a 'lateral_resistance' or a 'shear_strength'");
  expect_one_fault(write("lateral_law = \"ito_matsui\"\n"), "needs the 'diameter' of the piles");
  expect_fault(write("lateral_law = \"ito_matsui\"\ndiameter = @@2.5\n"), "must be less than the spacing of the axes");
  expect_one_fault(slices_alone +
                       "[support.row]\nkind = \"pile\"\nx = [99]\nlength = 8\nout_of_plane_spacing = 2\n"
                       "lateral_resistance = 60\n",
                   "x = 99 m is not on the ground");
}

TEST(Supports, WallsHaveALineAndAnInterface) {
  const auto write = [](const std::string& part, const std::string& place = "line = [[40, 30], [40, 22]]\n") {
    return slices_alone + "[support.sheet]\nkind = \"wall\"\n" + place + part;
  };
  EXPECT_TRUE(find_faults(write("")).empty());
  EXPECT_TRUE(find_faults(write("", "x = [40]\nlength = 8\n")).empty());
  EXPECT_TRUE(find_faults(write("", "heads = [[40, 30]]\nends = [[41, 22]]\n")).empty());
  EXPECT_TRUE(find_faults(write("", "line = [[30, 25], [50, 35], [60, 35]]\n")).empty()) << "a facing";
  EXPECT_TRUE(find_faults(write("crossing = \"resisted\"\nshear_strength = 400\n")).empty());
  expect_fault(write("crossing = @@\"resisted\"\n"), "needs the 'shear_strength' of the wall");
  expect_one_fault(write("", ""), "it has no place; give either 'heads', or 'first' and 'rows', or 'x' of a wall");
  expect_fault(write("length = @@8\n"), "'length' belongs to walls without 'line'");
  expect_fault(write("", "line = @@[[40, 30]]\n"), "'line' has one point");
  expect_fault(write("", "line = @@[[40, 30], [40, 30], [40, 22]]\n"), "the point (40, 30) twice in a row");
  expect_fault(write("", "line = @@[[40, 33], [40, 22]]\n"), "lies in the air");
  expect_fault(write("", "line = @@[[40, 30], [20, 30]]\n"), "above the ground");
  expect_fault(write("interface_strength = @@1.2\n"), "it must be");
  expect_fault(write("interface_strength = @@0.7\nbond_friction = 20\n"), "the interface is given twice");
  expect_fault(write("strut_stiffness = @@1e4\n"), "'strut_stiffness' needs 'strut_levels'");
  expect_fault(write("strut_levels = @@[28]\n"), "struts need 'strut_stiffness' and 'strut_strength' above 0");
  expect_fault(write("strut_levels = [28]\nstrut_stiffness = 1e4\nstrut_strength = 100\nstrut_prestress = @@200\n"),
               "the prestress exceeds 'strut_strength', 100 kN");
  expect_fault(write("out_of_plane_spacing = @@2\n"), "'out_of_plane_spacing'");
  expect_fault(write("plastic_moment = @@0\n"), "it must be above 0");
  expect_fault(write("plastic_force = @@-1\n"), "it must be above 0");
}

TEST(Supports, WallsAreRefusedWhereTheyAreNotTaken) {
  const std::string sheet = "[support.sheet]\nkind = \"wall\"\nline = [[40, 30], [40, 22]]\n",
                    base = "[[boundary]]\non = \"bottom\"\nfix = \"full\"\n",
                    stiffness = "axial_stiffness = 1e6\nbending_stiffness = 2e4\n";
  expect_one_fault(with_elements + base + sheet + stiffness, "FEM needs its 'interface_strength'");
  expect_one_fault(with_elements + base + sheet + "axial_stiffness = 1e6\ninterface_strength = 0.7\n",
                   "FEM needs its 'bending_stiffness', E I of a metre of wall");
  EXPECT_TRUE(find_faults(with_elements + base + sheet + stiffness + "interface_strength = 0.7\n").empty());
  const std::string with_bounds = change(with_elements, "[\"lem\", \"fem\"]", "[\"lem\", \"bounds\"]") + base;
  expect_one_fault(with_bounds + sheet, "limit analysis needs its 'interface_strength'");
  EXPECT_TRUE(find_faults(with_bounds + sheet + "interface_strength = 0.7\n").empty());
  expect_one_fault(with_bounds +
                       "[support.row]\nkind = \"pile\"\nx = [40]\nlength = 8\nout_of_plane_spacing = 2\n"
                       "lateral_resistance = 50\n",
                   "support 'row' is a pile, and limit analysis takes nails, anchors, geosynthetics and walls");
}

/// Limit analysis judges the factors of LEM beside bars whose force is axial, and says why not beside others.
TEST(Supports, WithAxialForcesLeaveTheRefereeOn) {
  const auto is_judged = [](const std::string& text) { return read_case_text(text, "slope.toml").data.lem.referee; };
  const std::string grid =
      "[support.grid]\nkind = \"geosynthetic\"\nheads = [[35, 24]]\nends = [[45, 24]]\nstrength = 40\n"
      "bond_friction = 25\nconnection = 0\n";
  EXPECT_TRUE(is_judged(write_nails()));
  EXPECT_TRUE(is_judged(write_nails() + "sense = \"active\"\n" + grid));
  EXPECT_FALSE(is_judged(write_nails() + "direction = \"tangent\"\n"));
  const std::string wall = "[support.sheet]\nkind = \"wall\"\nline = [[40, 30], [40, 22]]\n",
                    row =
                        "[support.row]\nkind = \"pile\"\nx = [40]\nlength = 8\nout_of_plane_spacing = 2\n"
                        "lateral_resistance = 50\n";
  for (const std::string& bent : {wall, row}) {
    EXPECT_FALSE(is_judged(slices_alone + bent));
    EXPECT_FALSE(is_judged(write_nails() + bent));
  }
  Case data = read_case_text(write_nails() + wall, "slope.toml").data;
  EXPECT_NE(find_axial_obstacle(data).value_or("").find("'sheet' is a wall, whose bending"), std::string::npos);
  data.supports.erase("sheet");
  EXPECT_FALSE(find_axial_obstacle(data).has_value());
}

TEST(Supports, LooseHeadOnAWallBringsAWarning) {
  const std::string sheet = "[support.sheet]\nkind = \"wall\"\nline = [[42, 31], [42, 22]]\nweight = 8\n";
  const auto read_warnings = [&](const std::string& plate) {
    const std::string nails = change(write_nails(), "plate = 50", "plate = " + plate);
    return read_case_text(nails + sheet, "slope.toml").warnings;
  };
  EXPECT_TRUE(read_warnings("50").empty());
  const auto warnings = read_warnings("0");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].sentence.find("the head of support 'nails' in row 2 lies on the wall 'sheet'"),
            std::string::npos)
      << warnings[0].sentence;
  expect_fault(slices_alone + change(sheet, "weight = 8", "weight = @@-1"), "it must be at least 0");
}

TEST(Supports, SheetsMayLieInTheSoil) {
  const auto write = [](const std::string& connection) {
    return slices_alone +
           "[support.grid]\nkind = \"geosynthetic\"\nheads = [[35, 24]]\nends = [[45, 24]]\nstrength = "
           "40\nbond_friction = 25\nconnection = " +
           connection + "\n";
  };
  EXPECT_TRUE(find_faults(write("0")).empty());
  expect_fault(write("@@10"), "lies in the soil, where nothing connects it");
}

TEST(Supports, NeedWhatTheMethodsTake) {
  const std::string nails =
      "[[boundary]]\non = \"bottom\"\nfix = \"full\"\n" + write_nails().substr(slices_alone.size());
  expect_one_fault(with_elements + nails, "FEM needs its 'axial_stiffness'");
  EXPECT_TRUE(find_faults(with_elements + nails + "axial_stiffness = 1e5\n").empty());
  const std::string with_bounds = change(with_elements, "[\"lem\", \"fem\"]", "[\"lem\", \"bounds\"]");
  EXPECT_TRUE(find_faults(with_bounds + nails).empty());
  expect_one_fault(with_bounds + nails + "direction = \"tangent\"\n",
                   "is not axial, as that of a bar in limit analysis");
}

TEST(Supports, CrossingBarsBringAWarning) {
  const std::string second = write_nails("heads = [[38, 29]]\n", "ends = [[56, 34]]\n").substr(slices_alone.size());
  const LoadedCase loaded =
      read_case_text(write_nails() + change(second, "[support.nails]", "[support.others]"), "slope.toml");
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_NE(loaded.warnings[0].sentence.find("crosses that of"), std::string::npos) << loaded.warnings[0].sentence;
}

}  // namespace
}  // namespace talus::input
