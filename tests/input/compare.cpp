// SPDX-License-Identifier: MIT
// [[compare]]: names, units and tolerances of the expected values.

#include "input/case/compare.hpp"
#include "input/case/result_names.hpp"
#include "results/named.hpp"
#include "run/digest.hpp"
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

TEST(Compare, NamesBothBounds) {
  for (const char* name : {"bounds.lower", "bounds.upper"})
    EXPECT_TRUE(find_faults(compare(std::string("\"") + name + "\"", "1.4", "\"5 %\""),
                            {{"analysis.methods", "['bounds', 'mpm']"}})
                    .empty())
        << name;
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

TEST(Compare, CallsAFactorInTimeByTheUsersOwnNumber) {
  using results::is_same_result;
  EXPECT_TRUE(is_same_result("timeline.factor[1110093]", "timeline.factor[1110093]"));
  // 12.848298611 days, and as six digits wrote it.
  EXPECT_TRUE(is_same_result("timeline.factor[1110092.99999]", "timeline.factor[1110093]"));
  EXPECT_TRUE(is_same_result("timeline.factor[1110093]", "timeline.factor[1.110093e6]"));
  EXPECT_FALSE(is_same_result("timeline.factor[1110093]", "timeline.factor[1110100]"));
  EXPECT_FALSE(is_same_result("timeline.factor[0]", "timeline.factor[1]"));
  EXPECT_FALSE(is_same_result("timeline.factor[43200]", "timeline.factor[43200"));
  EXPECT_FALSE(is_same_result("lem.bishop", "lem.spencer"));
  results::RunResult run;
  run.timeline.emplace().factors.emplace_back().time = 1110093;
  run.timeline->factors.back().factor = 1.25;
  EXPECT_EQ(results::find_value(run, "timeline.factor[1110093]"), 1.25);
}

TEST(Digest, IsInTheUnitsOfTheCase) {
  constexpr double foot = 0.3048;
  results::RunResult run;
  run.units = {"ft", "in", "psf"};
  run.runout.emplace();
  run.runout->front_advance = 12.2 * foot;
  run.runout->largest_displacement = 15 * foot;
  run.runout->moved_volume = 100 * foot * foot;
  run.runout->coarser_mesh = {4 * foot, 11.9 * foot, 0, 0, 97 * foot * foot};
  run.seepage.emplace();
  run.seepage->inflow = 3 * foot * foot;
  run.seepage->largest_suction = 47.880259 * 250;
  const std::string text = run::write_digest(run);
  for (const char* line :
       {"Runout: front advances 12.2 ± 0.9 ft and stays behind the toe, crest retreats 0 ft, largest displacement "
        "15 ft, 100 ± 9 ft³/ft move\n",
        "Steady seepage: 3 ft³/s per ft through, largest suction 250 psf\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  run.runout->moved_volume = 0;
  run.runout->threshold = foot;
  EXPECT_NE(run::write_digest(run).find("Runout: no soil moves more than 1 ft; largest displacement 15 ft\n"),
            std::string::npos);
}

TEST(Compare, IsPrintedAtTheTerminal) {
  results::RunResult run;
  run.title = "A slope";
  run.comparisons = {
      {"lem.spencer", "Spencer, critical circle", {"", 1}, 1.386, 1.39, 0.02, "0.02", "a referee", true, ""},
      {"stage[a].displacement", "largest displacement", {"mm", 1e-3}, 0.05, 0.03, 0.003, "10 %", "B", false, ""},
      {"fem.factor", "FEM", {"", 1}, {}, 1.4, 0.1, "0.1", "C", false, "the case leaves it out"}};
  const std::string text = run::write_digest(run);
  for (const char* line : {"Compared with published values:\n",
                           "  Spencer, critical circle: 1.386, published 1.39 ± 0.02 (a referee): passes\n",
                           "  largest displacement: 50 mm, published 30 mm ± 10 % (B): misses\n",
                           "  FEM: not calculated, published 1.4 ± 0.1 (C); the case leaves it out\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

}  // namespace
}  // namespace talus::input
