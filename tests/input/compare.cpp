// SPDX-License-Identifier: MIT
// [[compare]]: names, units and tolerances of the values that results are compared with.

#include "input/case/result_names.hpp"
#include "slope.hpp"

namespace talus::input {
namespace {

std::string compare(const std::string& name, const std::string& value, const std::string& tolerance) {
  return slope +
         "[analysis]\nkind = \"strength_reduction\"\n[strength_reduction.curve]\nrunout = [1.75]\n[[compare]]\n" +
         "name = " + name + "\nvalue = " + value + "\ntolerance = " + tolerance + "\nsource = \"a table\"\n";
}

TEST(Compare, NamesAResultOfTheCase) {
  expect_fault(compare("@@\"factor_of_safety.bilinera\"", "1.4", "\"5 %\""),
               "the case yields no result 'factor_of_safety.bilinera'; did you mean 'factor_of_safety.bilinear'?");
  EXPECT_TRUE(find_faults(compare("\"runout[1.75].moved_volume\"", "\"91 m3/m\"", "\"5 %\"")).empty());
  expect_fault(compare("@@\"runout[1.75].moved_volum\"", "91", "\"5 %\""), "did you mean 'runout[1.75].moved_volume'?");
}

TEST(Compare, MayNameWhatThisRunLeavesOut) {
  const std::string text = compare("\"curve.displacement[1.45]\"", "\"31 mm\"", "\"30 %\"");
  EXPECT_TRUE(find_faults(text).empty());
  EXPECT_TRUE(find_faults(text, {{"strength_reduction.curve.enabled", "false"}}).empty());
  EXPECT_TRUE(find_faults(text, {{"analysis.kind", "\"run\""}}).empty());
  EXPECT_TRUE(find_faults(compare("\"runout[1.6].moved_volume\"", "91", "\"5 %\"")).empty());
}

TEST(Compare, ValuesHaveTheDimensionOfTheResult) {
  expect_fault(compare("\"curve.displacement[1.45]\"", "@@\"31 kPa\"", "\"30 %\""),
               "'value' is \"31 kPa\"; 'curve.displacement[1.45]' is a length");
  expect_fault(compare("\"curve.displacement[1.45]\"", "\"31 mm\"", "@@\"2 s\""), "'tolerance' is \"2 s\"");
  expect_fault(compare("\"factor_of_safety\"", "@@\"1.4 m\"", "0.1"), "'value' is \"1.4 m\"");
  expect_fault(compare("\"factor_of_safety\"", "@@true", "0.1"), "'value' must be a number or a text with a unit");
  expect_fault(compare("\"factor_of_safety\"", "1.4", "@@-0.1"), "it must be at least 0");
}

TEST(Compare, TolerancesArePerCentOfTheValueOrInItsUnit) {
  const auto tolerance = [](const char* value, const char* text) {
    return find_tolerance(read_case_text(compare("\"curve.displacement[1.45]\"", value, text), "t").data.compare[0]);
  };
  EXPECT_DOUBLE_EQ(tolerance("\"31 mm\"", "\"30 %\""), 0.0093);
  EXPECT_DOUBLE_EQ(tolerance("\"31 mm\"", "\"2 mm\""), 0.002);
  EXPECT_DOUBLE_EQ(tolerance("0.031", "0.002"), 0.002);
  EXPECT_DOUBLE_EQ(tolerance("\"31 mm\"", "2"), 0.002) << "not two metres";
}

}  // namespace
}  // namespace talus::input
