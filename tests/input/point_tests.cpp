// SPDX-License-Identifier: MIT
// [[test]]: element tests in a case and in a file of their own, and the messages on wrong input.

#include <fstream>

#include "slope.hpp"

namespace talus::input {
namespace {

const std::string two_tests = R"(
[[test]]
name = "cell 100"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 100
axial_strain = 0.2
)";

const std::string soil_alone =
    "title = \"Soil\"\n" +
    slope.substr(slope.find("[materials.sand]"), slope.find("[regions]") - slope.find("[materials.sand]"));

LoadedCase read_tests(const std::string& text, const std::vector<Override>& overrides = {}) {
  return read_case_text(text, "case.toml", overrides, CaseScope::whole_or_tests);
}

/// All faults of a file that may hold tests alone, a line each.
std::string find_test_faults(const std::string& text) {
  try {
    read_tests(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PointTestInput, AWholeCaseMayHoldTestsAndIsTheSameCase) {
  const LoadedCase with = read_case_text(slope + two_tests, "case.toml"), without = read_case_text(slope, "case.toml");
  EXPECT_TRUE(with.is_whole);
  ASSERT_EQ(with.data.tests.size(), 1u);
  EXPECT_DOUBLE_EQ(with.data.tests[0].confining_pressure.value(), 100e3);
  nlohmann::json echo = with.echo.get();
  echo.erase("test");
  nlohmann::json other = without.echo.get();
  other.erase("test");
  EXPECT_EQ(echo, other);
}

TEST(PointTestInput, TestsAloneNeedNoSlopeButARunDoes) {
  const LoadedCase loaded = read_tests(soil_alone + two_tests);
  EXPECT_FALSE(loaded.is_whole);
  EXPECT_FALSE(loaded.echo.get().contains("geometry"));
  EXPECT_TRUE(loaded.echo.get().contains("materials"));
  EXPECT_THROW(read_case_text(soil_alone + two_tests, "case.toml"), InputError) << "a run needs the slope";
  // Any key of a slope makes the file one of a slope.
  EXPECT_NE(find_test_faults(soil_alone + "[mesh]\nsize = 1\n" + two_tests).find("missing key 'box'"),
            std::string::npos);
  EXPECT_NE(find_test_faults(soil_alone).find("missing key 'box'"), std::string::npos) << "no slope and no tests";
}

TEST(PointTestInput, ATestHasItsMaterialWithWhatItSets) {
  const LoadedCase loaded = read_tests(
      soil_alone + two_tests + "set = { cohesion = \"7 kPa\", friction_angle = 25 }\n" +
      "[[test]]\nname = \"bare\"\nmaterial = \"sand\"\nkind = \"oedometer\"\nvertical_stress = 20\nk0 = 0.5\n" +
      "control = \"stress\"\naxial_stress = [400, \"0.1 MPa\"]\n");
  ASSERT_EQ(loaded.data.test_soils.size(), 2u);
  EXPECT_DOUBLE_EQ(loaded.data.test_soils[0].cohesion, 7e3);
  EXPECT_NEAR(loaded.data.test_soils[0].friction_angle, 25 * M_PI / 180, 1e-12);
  EXPECT_DOUBLE_EQ(loaded.data.test_soils[1].cohesion, 2e3);
  EXPECT_EQ(loaded.data.tests[1].axial_stress, (std::vector<double>{400e3, 100e3}));
  // --set changes the material of all tests, and what a test sets comes last.
  const LoadedCase changed = read_tests(soil_alone + two_tests + "set = { cohesion = 7 }\n",
                                        {{"materials.sand.cohesion", "3"}, {"materials.sand.friction_angle", "20"}});
  EXPECT_DOUBLE_EQ(changed.data.test_soils[0].cohesion, 7e3);
  EXPECT_NEAR(changed.data.test_soils[0].friction_angle, 20 * M_PI / 180, 1e-12);
}

TEST(PointTestInput, FaultsAreReportedWithTheirPlace) {
  const auto with = [](const std::string& from, const std::string& to) { return slope + change(two_tests, from, to); };
  expect_fault(with("\"sand\"", "@@\"snad\""), "there is no material 'snad'; did you mean 'sand'?");
  expect_fault(with("\"cell 100\"", "@@\"cell [100]\""), "must not hold any of [ ] /");
  expect_fault(with("axial_strain = 0.2", "axial_strain = 0.2\nshear_strain = @@0.3"),
               "'shear_strain' in [[test]] has no meaning here; this test follows 'axial_strain'");
  expect_fault(with("axial_strain = 0.2", "axial_strain = 0.2\nvertical_stress = @@30"),
               "'vertical_stress' in [[test]] has a meaning only with kind = \"oedometer\"");
  expect_fault(with("axial_strain = 0.2", "axial_strain = @@1.5"), "it must be above -1 and below 1");
  expect_fault(with("axial_strain = 0.2", "axial_strain = 0.2\nset = @@{ cohesoin = 3 }"),
               "the test 'cell 100' cannot change material 'sand' so: unknown key 'cohesoin'");
  expect_fault(with("axial_strain = 0.2", "axial_strain = 0.2\nset = @@{ cohesion = -3 }"), "'cohesion' is -3 kPa");
  expect_fault(with("axial_strain = 0.2", "axial_strain = 0.2\nsuction = @@50"), "add [materials.sand.water]");
  expect_fault(slope + two_tests + change(two_tests, "\"cell 100\"", "@@\"cell 100\""),
               "there are two tests named 'cell 100'");
}

TEST(PointTestInput, WhatIsMissingIsNamedWithItsReason) {
  EXPECT_NE(find_test_faults(soil_alone + change(two_tests, "axial_strain = 0.2", "control = \"stress\""))
                .find("missing key 'axial_stress' in [[test]]; control = \"stress\" needs it"),
            std::string::npos);
  EXPECT_NE(find_test_faults(soil_alone + change(two_tests, "confining_pressure = 100", ""))
                .find("missing key 'confining_pressure' in [[test]]"),
            std::string::npos);
  EXPECT_NE(find_test_faults(soil_alone + "[[test]]\nname = \"ring\"\nmaterial = \"sand\"\nkind = \"oedometer\"\n"
                                          "vertical_stress = 20\naxial_strain = 0.1\n")
                .find("missing key 'k0' in [[test]]"),
            std::string::npos);
  EXPECT_NE(find_test_faults(soil_alone + "[[test]]\nname = \"wet\"\nmaterial = \"sand\"\nkind = \"wetting\"\n"
                                          "confining_pressure = 20\nsuction = 50\n")
                .find("needs at least two values"),
            std::string::npos);
}

TEST(PointTestInput, ResultsOfTestsMayBeCompared) {
  const auto compare = [](const std::string& name, const std::string& value) {
    return slope + two_tests + "[[compare]]\nname = " + name + "\nvalue = " + value +
           "\ntolerance = \"1 %\"\nsource = \"a laboratory\"\n";
  };
  EXPECT_TRUE(find_faults(compare("\"test[cell 100].q[0.1]\"", "\"200 kPa\"")).empty());
  EXPECT_TRUE(find_faults(compare("\"test[cell 100].void_ratio\"", "0.4")).empty());
  EXPECT_TRUE(find_faults(compare("\"test[cell 100].peak_q\"", "\"200 kPa\"")).empty());
  expect_fault(compare("@@\"test[cell 200].q[0.1]\"", "\"200 kPa\""),
               "the case yields no result 'test[cell 200].q[0.1]'");
  expect_fault(compare("@@\"test[cell 100].void_ratoi\"", "0.4"), "did you mean 'test[cell 100].void_ratio'?");
  expect_fault(compare("\"test[cell 100].q[0.1]\"", "@@\"2 m\""), "'test[cell 100].q[0.1]' is a stress");
}

}  // namespace
}  // namespace talus::input
