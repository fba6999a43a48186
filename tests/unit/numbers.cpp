// SPDX-License-Identifier: MIT
// Numbers in sentences, rounded by their uncertainty, and the uncertainty from two meshes.

#include "base/numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "results/named.hpp"
#include "results/runout.hpp"
#include "run/digest.hpp"

namespace talus {
namespace {

TEST(Uncertain, TheValueEndsWhereItsUncertaintyDoes) {
  EXPECT_EQ(format_uncertain(1.2508, 0.3582), "1.3 ± 0.4");
  EXPECT_EQ(format_uncertain(1.2508, 0.1182), "1.25 ± 0.12");
  EXPECT_EQ(format_uncertain(132.4, 23.1), "130 ± 20");
  EXPECT_EQ(format_uncertain(0.9714, 2.8), "1 ± 3");
  EXPECT_EQ(format_uncertain(-0.0614, 0.0004), "-0.0614 ± 0.0004");
  EXPECT_EQ(format_uncertain(-0.04, 0.3), "0.0 ± 0.3") << "nothing has a sign";
  EXPECT_EQ(format_uncertain(0.2, 0.096), "0.20 ± 0.10");
  EXPECT_EQ(format_uncertain(5, 0.995), "5.0 ± 1.0");
  EXPECT_EQ(format_uncertain(0, 0.5), "0.0 ± 0.5");
}

TEST(Uncertain, RoundingIsNaN) {
  EXPECT_EQ(format_uncertain(7e-18, std::nullopt), "0");
  EXPECT_EQ(format_uncertain(-7e-18, 3e-17), "0");
  EXPECT_EQ(format_uncertain(5.4321, 3e-16), "5.43") << "two meshes that agree";
  EXPECT_EQ(format_uncertain(5.4321, 1e-3), "5.43");
  EXPECT_EQ(format_uncertain(std::numeric_limits<double>::quiet_NaN(), 1.0), "–");
  EXPECT_EQ(format_uncertain(1.0, std::numeric_limits<double>::infinity()), "–");
}

TEST(Uncertain, WithoutAnUncertaintyTwoDigitsAreMeant) {
  EXPECT_EQ(format_uncertain(78.26, std::nullopt), "78");
  EXPECT_EQ(format_uncertain(1234.5, std::nullopt), "1200");
  EXPECT_EQ(format_uncertain(2.19, std::nullopt), "2.2");
  EXPECT_EQ(format_uncertain(0.0615, std::nullopt), "0.062");
  EXPECT_EQ(format_uncertain(0, std::nullopt), "0");
  EXPECT_EQ(format_uncertain(2.1949, 0.0), "2.19") << "two meshes agree";
}

TEST(Uncertain, OfTwoMeshesIsThreeTimesTheirDifference) {
  // A first-order error: at h it is e, at 2h 2e. The limit lies e away, a third of what is stated.
  const double limit = 5, error = 0.2;
  EXPECT_NEAR(results::find_mesh_uncertainty(limit + error, limit + 2 * error), 3 * error, 1e-12);
  EXPECT_NEAR(results::find_mesh_uncertainty(limit - error, limit - 2 * error), 3 * error, 1e-12);
  results::Runout runout;
  EXPECT_FALSE(results::RunoutEstimates(runout).front_advance.uncertainty()) << "one mesh has none";
  runout.front_advance = 1.2;
  runout.coarser_mesh = {0.5, 1.1};
  EXPECT_NEAR(*results::RunoutEstimates(runout).front_advance.uncertainty(), 0.3, 1e-12);
}

TEST(Estimate, IsDeterminedUpToHalfOfItselfOrAnElement) {
  using results::Estimate;
  EXPECT_TRUE((Estimate{6}).is_determined()) << "one mesh has no uncertainty";
  EXPECT_TRUE((Estimate{6, 5}).is_determined()) << "± 3 is half of it";
  EXPECT_FALSE((Estimate{6, 4.999}).is_determined());
  EXPECT_FALSE((Estimate{-6, -7.001}).is_determined());
  EXPECT_TRUE((Estimate{0, 0}).is_determined());
  EXPECT_FALSE((Estimate{0, 0.1}).is_determined());
  EXPECT_TRUE((Estimate{0, 0.1, 0, 0.5}).is_determined()) << "± 0.3 is less than an element";
  EXPECT_FALSE((Estimate{1006, 1004, 1000}).is_determined()) << "a level over the lowest ground";
  EXPECT_TRUE((Estimate{1006, 1005, 1000}).is_determined());
  const ShownUnit foot{"ft", 0.3048};
  EXPECT_EQ(results::format_estimate({0.3048 * 6, 0.3048 * 4}, foot), "not determined (two meshes: 6.0 ft and 4.0 ft)");
  EXPECT_EQ(results::format_estimate({0.3048 * 6, 0.3048 * 5.5}, foot), "6.0 ± 1.5 ft");
  EXPECT_EQ(results::format_estimate({0.3048 * 6}, foot), "6.0 ft");
}

TEST(Estimate, OfTheKeptCaseOfQuickClayIsNotDetermined) {
  // Front 2 ± 6 m, toe passed by 200 ± 500 m, 10,000 ± 30,000 m³/m on elements of 1.5 m.
  results::RunResult run;
  results::Runout& r = run.runout.emplace();
  r.front_advance = 2, r.toe_distance = 155, r.moved_volume = 7000, r.highest_ground = 29.9, r.lowest_ground = 15;
  r.coarser_mesh = {3, 4, 0, 0, 17000, 29.95, 0};
  EXPECT_EQ(results::RunoutEstimates(r).list_undetermined(),
            (std::vector<std::string>{"front_advance", "toe_distance", "moved_volume"}));
  EXPECT_FALSE(results::find_value(run, "runout.front_advance"));
  EXPECT_EQ(results::find_value(run, "runout.crest_retreat"), 0);
  EXPECT_EQ(results::explain_undetermined(*results::find_named(run, "runout.moved_volume")),
            "not determined (two meshes: 7000 m³/m and 17000 m³/m)");
  const std::string text = run::write_digest(run);
  for (const char* part : {"advance of the front not determined (two meshes: 2.0 m and 4.0 m)",
                           "distance beyond the toe not determined (two meshes: 160 m and 0 m)", "crest retreats 0 m",
                           "moved volume not determined (two meshes: 7000 m³/m and 17000 m³/m)"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find(" ± "), std::string::npos) << text;
}

}  // namespace
}  // namespace talus
