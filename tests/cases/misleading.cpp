// SPDX-License-Identifier: MIT
// Cases whose answer once misled: each with the number that governs, and what must be said about it.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "cases/methods_slope.hpp"

namespace talus {
namespace {

using nlohmann::json;

class Misleading : public MethodsTest {
 protected:
  json run_case(const std::string& name, const std::vector<input::Override>& overrides = {}) {
    std::ifstream file(TALUS_SOURCE_DIR "/tests/data/misleading/" + name + ".toml");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return run(text, overrides);
  }

  /// Whether a warning holds all of the words.
  static bool warns(const json& summary, const std::vector<std::string>& words) {
    for (const std::string warning : summary.at("warnings")) {
      const auto is_in = [&](const std::string& word) { return warning.find(word) != std::string::npos; };
      if (std::all_of(words.begin(), words.end(), is_in)) return true;
    }
    return false;
  }
};

TEST_F(Misleading, TheBedGovernsAndNotTheCircleAboveIt) {
  const json summary = run_case("bedding_storm");
  EXPECT_NEAR(summary.at("main_factor").get<double>(), 1.006, 0.01);
  EXPECT_GT(find_factor(summary, "spencer"), 1.2);
  EXPECT_EQ(support::find_result(summary, "lem.factor"), summary.at("main_factor").get<double>());
  EXPECT_TRUE(warns(summary, {"critical polyline", "bedding", "governs"})) << summary.at("warnings");
}

TEST_F(Misleading, FelleniusDoesNotFallToZeroUnderAFullPool) {
  const json summary = run_case("dam_full_pool", {{"lem.methods", "[\"fellenius\", \"spencer\"]"}});
  const double spencer = find_factor(summary, "spencer");
  EXPECT_NEAR(spencer, 1.74, 0.02);
  EXPECT_GT(find_factor(summary, "fellenius"), 0.7 * spencer);
  EXPECT_EQ(summary.at("main_factor").get<double>(), spencer) << "Fellenius is lower, and leaves more out";
}

TEST_F(Misleading, NoFactorHasForcesThatNoSoilBears) {
  const json summary = run_case("steep_cut");
  int count = 0;
  for (const char* list : {"critical", "noncircular"})
    for (const json& c : summary.at("lem").at(list)) {
      if (c.at("lambda").is_null()) continue;
      EXPECT_LE(std::abs(c.at("lambda").get<double>() - 0.625), 0.875) << c.at("method");
      ++count;
    }
  EXPECT_GE(count, 3);
}

TEST_F(Misleading, MethodsOnBothSidesOfOneAreTheFirstWarningAndTheSmallestFactorGoverns) {
  const json summary = run_case("methods_on_both_sides_of_one");
  EXPECT_LT(summary.at("main_factor").get<double>(), 0.75);
  const auto& warnings = summary.at("warnings");
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].get<std::string>().find("disagree on whether the slope stands"), std::string::npos) << warnings;
  EXPECT_TRUE(warns(summary, {"unstable by inspection", "φ = 37.1°", "0.60"})) << warnings;
}

}  // namespace
}  // namespace talus
