// SPDX-License-Identifier: MIT
// Warnings on valid but improbable input: polygons that do not fit, unusual values, misspellings.

#include <fmt/format.h>

#include "base/units.hpp"
#include "methods_slope.hpp"

namespace talus::input {
namespace {

/// The warnings of a text, a line each.
std::vector<std::string> find_warnings(const std::string& text, const std::vector<Override>& overrides = {}) {
  std::vector<std::string> lines;
  for (const Diagnostic& warning : read_case_text(text, "slope.toml", overrides).warnings)
    lines.push_back(write_warning(warning));
  return lines;
}

void expect_part(const std::string& line, const std::string& part) {
  EXPECT_NE(line.find(part), std::string::npos) << "'" << part << "' is not in: " << line;
}

/// Slices in two layers; the lower corners of the upper one are at `left` and `right`.
std::string write_layers(const std::string& left, const std::string& right, const std::string& methods = "\"lem\"") {
  return R"(geometry.polygon = [{ name = "a", points = [[0, 0], [40, 0], [40, 5], [0, 5]] },
  { name = "b", points = [)" +
         left + ", " + right + R"(, [30, 5], [18, 12], [0, 12]] }]
geometry.box = [[0, 0], [40, 20]]
mesh.size = 1
materials.s.model = "mohr_coulomb"
materials.s.unit_weight = 18
materials.s.cohesion = 5
materials.s.friction_angle = 28
materials.s.young_modulus = "20 MPa"
materials.s.poisson_ratio = 0.3
materials.s.dilatancy_angle = 0
materials.s.tensile_strength = 0
regions = { a = "s", b = "s" }
analysis.methods = [)" +
         methods + "]\n";
}

TEST(Polygons, ThatOverlapAreFaultsOfAllMethods) {
  for (const char* methods : {"\"lem\"", "\"fem\"", "\"lem\", \"fem\""}) {
    const auto faults = find_faults(write_layers("[0, 4.98]", "[20, 5]", methods));
    ASSERT_EQ(faults.size(), 1u) << methods;
    EXPECT_EQ(faults[0].line, 2) << "where the second polygon is";
    expect_part(faults[0].sentence,
                "polygons 'a' and 'b' overlap on 0.2 m² from (0, 4.98) to (20, 5), around (10, 4.995)");
    expect_part(faults[0].sentence, "within 4e-05 m");
  }
}

TEST(Polygons, LeaveGapsThatAreFaultsOfSlicesAndWarningsOfOthers) {
  const auto faults = find_faults(write_layers("[0, 5.02]", "[20, 5]"));
  ASSERT_EQ(faults.size(), 1u);
  expect_part(faults[0].sentence, "no soil between polygons 'b' and 'a' on 0.2 m² from (0, 5) to (20, 5.02)");
  const auto warnings = find_warnings(write_layers("[0, 5.02]", "[20, 5]", "\"fem\""));
  ASSERT_EQ(warnings.size(), 1u);
  expect_part(warnings[0], "slope.toml:1:");
  expect_part(warnings[0], ": warning: there is no soil between polygons 'b' and 'a' on 0.2 m²");
  EXPECT_TRUE(
      find_warnings("unusual = [\"geometry.polygon\"]\n" + write_layers("[0, 5.02]", "[20, 5]", "\"fem\"")).empty());
}

TEST(Polygons, ThatOverhangAreNamedAlone) {
  const auto faults = find_faults(change(slices_alone, "[50, 35], [30, 25]", "[28, 35], [30, 25]"));
  ASSERT_EQ(faults.size(), 1u);
  expect_part(faults[0].sentence,
              "polygon 'soil' has no soil below an overhang, or in a cavity, of 10 m² from (28, 25) to "
              "(30, 35)");
}

TEST(Polygons, ThatNearlyMeetAreJoinedWithAWarning) {
  const LoadedCase loaded = read_case_text(write_layers("[0, 5.00002]", "[20, 5]"), "slope.toml");
  EXPECT_EQ(loaded.data.mesh.polygons[1].points[0], (std::array<double, 2>{0, 5}));
  ASSERT_EQ(loaded.warnings.size(), 1u);
  expect_part(loaded.warnings[0].sentence,
              "one point of 'b' moved onto what it misses by less than 4e-05 m; the first "
              "goes from (0, 5.00002) to (0, 5)");
}

TEST(UsualRange, IsQuotedWithTheUnitThatMayHaveBeenMeant) {
  const std::vector<std::array<std::string, 3>> slips{
      {"materials.s.unit_weight", "1800",
       "1800 kN/m3; the usual range is 10 to 28 kN/m3 (1800 kg/m3 would be 17.7 kN/m3)"},
      {"materials.s.unit_weight", "115", "(115 pcf would be 18.1 kN/m3)"},
      {"materials.s.friction_angle", "0.44",
       "0.44 deg; the usual range is 5 to 50 deg, or 0 (0.44 rad would be 25.2 deg)"},
      {"materials.s.cohesion", "5000", "(5000 Pa would be 5 kPa; 5000 psf would be 239 kPa)"},
      {"materials.s.young_modulus", "20", "(20 MPa would be 2e+04 kPa)"},
      {"materials.s.young_modulus", "\"20 kPa\"", "20 kPa; the usual range is 200 to 5e+06 kPa. Correct it"},
      {"materials.s.poisson_ratio", "0.499", "the usual range is 0.05 to 0.495, or 0"},
      {"materials.s.dilatancy_angle", "0.1", "(0.1 rad would be 5.73 deg)"},
      {"earthquake.horizontal", "1.5", "1.5 m/s2 would be 0.153)"},
  };
  for (const auto& [key, value, part] : slips) {
    const std::vector<Override> change{{key, value}};
    const auto warnings = find_warnings(write_layers("[0, 5]", "[20, 5]"), change);
    ASSERT_EQ(warnings.size(), 1u) << key << " = " << value;
    expect_part(warnings[0], "--set " + key + ": warning: '" + key + "' is ");
    expect_part(warnings[0], part);
    EXPECT_TRUE(find_warnings("unusual = [\"" + key + "\"]\n" + write_layers("[0, 5]", "[20, 5]"), change).empty())
        << "silenced by its key";
    EXPECT_TRUE(
        find_warnings("unusual = [\"" + key.substr(0, key.rfind('.')) + "\"]\n" + write_layers("[0, 5]", "[20, 5]"),
                      change)
            .empty())
        << "silenced by its block";
  }
}

TEST(UsualRange, HoldsWhatSoilsAre) {
  for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{{"unit_weight", "11"},
                                                                                   {"unit_weight", "26"},
                                                                                   {"friction_angle", "0"},
                                                                                   {"friction_angle", "45"},
                                                                                   {"cohesion", "0"},
                                                                                   {"cohesion", "300"},
                                                                                   {"young_modulus", "500"},
                                                                                   {"young_modulus", "\"1 GPa\""}})
    EXPECT_TRUE(find_warnings(write_layers("[0, 5]", "[20, 5]"), {{"materials.s." + key, value}}).empty())
        << key << " = " << value;
  EXPECT_TRUE(find_warnings(slope).empty());
}

TEST(UsualRange, OfAConductivityIncludesCentimetres) {
  const auto warnings = find_warnings(
      slope +
      "[materials.sand.water]\nretention = \"saturated\"\nrelative_conductivity = \"constant\"\nconductivity = 3\n");
  ASSERT_EQ(warnings.size(), 1u);
  expect_part(warnings[0], "(3 cm/s would be 0.03 m/s; 3 m/day would be 3.47e-05 m/s; 3 mm/h would be 8.33e-07 m/s)");
}

TEST(Unusual, NamesKeysOfTheCase) {
  expect_fault("unusual = [@@\"materials.sand.cohesoin\"]\n" + slope,
               "which this case does not give; did you mean 'materials.sand.cohesion'?");
}

TEST(DecimalComma, IsExplained) {
  const auto faults = find_faults(change(slope, "size = 0.75", "size = 0,75"));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].line, 16);
  EXPECT_EQ(faults[0].sentence, "'0,75' has a decimal comma; write it with a point: 0.75");
  expect_part(find_faults(slope + "rest = { force_ratio = 1,5 }\n").at(0).sentence, "'1,5' has a decimal comma");
  expect_part(find_faults(change(slope, "\"45 MPa\"", "\"4,5 MPa\"")).at(0).sentence,
              "'4,5 MPa' has a decimal comma; write it with a point: 4.5 MPa");
  expect_part(find_faults(slope, {{"mesh.size", "0,5"}}).at(0).sentence, "'0,5' has a decimal comma");
  expect_part(find_faults(change(slope, "[12, 15], [0, 15]]", "[12,5, 15], [0, 15]]")).at(0).sentence,
              "decimals have a point, not a comma");
}

TEST(Override, OfAMisspeltNameSuggestsTheNearest) {
  for (const auto& [key, part] : std::vector<std::pair<std::string, std::string>>{
           {"materials.snad.cohesion", "there is no [materials.snad]; did you mean 'sand'?"},
           {"stage.gravty.duration", "did you mean 'gravity'?"},
           {"boundary.botom.fix", "did you mean 'bottom'?"},
           {"mesch.size", "did you mean 'mesh'?"}}) {
    const auto faults = find_faults(slope, {{key, "3"}});
    ASSERT_EQ(faults.size(), 1u) << key;
    expect_part(to_string(faults[0]), "--set " + key + ": error: ");
    expect_part(faults[0].sentence, part);
  }
}

TEST(UnitsOfPractice, AreThoseOfTheirDefinitions) {
  // lbf = 4.4482216152605 N and ft = 0.3048 m, both exact.
  constexpr double lbf = 4.4482216152605, ft = 0.3048;
  EXPECT_DOUBLE_EQ(units::parse_as_si("500 psf", "kPa", "c"), 500 * lbf / (ft * ft));
  EXPECT_DOUBLE_EQ(units::parse_as_si("2 ksf", "kPa", "c"), 2000 * lbf / (ft * ft));
  EXPECT_DOUBLE_EQ(units::parse_as_si("1.5 tsf", "kPa", "c"), 3000 * lbf / (ft * ft));
  EXPECT_DOUBLE_EQ(units::parse_as_si("120 pcf", "kN/m3", "g"), 120 * lbf / (ft * ft * ft));
  EXPECT_DOUBLE_EQ(units::parse_as_si("33 ft", "m", "h"), 33 * ft);
  EXPECT_DOUBLE_EQ(units::parse_as_si("14.7 psi", "kPa", "c"), 14.7 * lbf * 144 / (ft * ft));
  EXPECT_THROW(units::parse_as_si("120 pcf", "kPa", "c"), Error);
}

TEST(UnitsOfPractice, GiveTheSameCaseAsSiUnits) {
  const auto write = [](const char* points, const char* soil, const char* load) {
    return fmt::format(
        "geometry.polygon = [{{ name = \"a\", points = {} }}]\n"
        "materials.s = {{ model = \"mohr_coulomb\", {}, friction_angle = 25 }}\nregions.a = \"s\"\n"
        "surcharge = [{{ name = \"road\", {} }}]\nanalysis.methods = [\"lem\"]\n"
        "output.stress_unit = \"psf\"\noutput.length_unit = \"ft\"\n",
        points, soil, load);
  };
  // 1 psf is 47.880258980335840 Pa and 1 pcf 157.08746384624618 N/m³, as NIST SP 811 has them to seven digits.
  const Case practice = read(write(R"([["0 ft", "0 ft"], ["150 ft", "0 ft"], ["150 ft", "20 ft"], ["0 ft", "45 ft"]])",
                                   R"(unit_weight = "120 pcf", cohesion = "200 psf")",
                                   R"(x = ["10 ft", "30 ft"], load = ["250 psf", "0.125 tsf"])"));
  const Case si = read(write("[[0, 0], [45.72, 0], [45.72, 6.096], [0, 13.716]]",
                             "unit_weight = 18.850495661549542, cohesion = 9.576051796067168",
                             "x = [3.048, 9.144], load = [11.97006474508396, 11.97006474508396]"));
  EXPECT_NEAR(practice.materials.at("s").cohesion, si.materials.at("s").cohesion, 1e-9);
  EXPECT_NEAR(*practice.materials.at("s").slices.unit_weight, *si.materials.at("s").slices.unit_weight, 1e-9);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(practice.surcharges[0].load[i], si.surcharges[0].load[i], 1e-9);
    EXPECT_NEAR(practice.surcharges[0].x[i], si.surcharges[0].x[i], 1e-12);
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t d = 0; d < 2; ++d)
      EXPECT_NEAR(practice.mesh.polygons[0].points[i][d], si.mesh.polygons[0].points[i][d], 1e-12);
}

TEST(Sliver, BetweenSoilAndBoxIsReported) {
  for (const char* gap : {"44.00005", "44.05"}) {
    const auto warnings = find_warnings(change(slope, "[44, 17]]", fmt::format("[{}, 17]]", gap)));
    ASSERT_EQ(warnings.size(), 1u) << gap;
    expect_part(warnings[0], "from the right side of the box");
  }
  for (const char* gap : {"44", "44.00000001", "44.5"})
    EXPECT_TRUE(find_warnings(change(slope, "[44, 17]]", fmt::format("[{}, 17]]", gap))).size() < 2) << gap;
}

TEST(Seam, ThinnerThanAnElementIsReported) {
  const std::string seam = change(change(slope, "[[0, 0], [44, 0],", "[[0, 0.3], [44, 0.3],"), "[regions]\n",
                                  "[[geometry.polygon]]\nname = \"seam\"\npoints = [[0, 0], [44, 0], [44, 0.3], [0, "
                                  "0.3]]\n[regions]\nseam = \"sand\"\n");
  const auto warnings = find_warnings(seam);
  ASSERT_EQ(warnings.size(), 1u);
  expect_part(warnings[0], "polygon 'seam' is 0.3 m thick on average, less than one element of 0.75 m");
  EXPECT_TRUE(find_warnings(seam + "[[mesh.refine]]\nnear = [[22, 0.15]]\nsize = 0.1\ndistance = 30\n").empty());
}

}  // namespace
}  // namespace talus::input
