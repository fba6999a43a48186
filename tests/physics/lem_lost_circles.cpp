// SPDX-License-Identifier: MIT
// Circles without a solution by methods of complete equilibrium: tension at the crest of steep slopes, and the limits
// of λ.

#include <algorithm>

#include "lem/search/search.hpp"
#include "lem/search/search_findings.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

/// 10 m at 60°, c/γH = 0.165, φ = 11.9°. Limit analysis has 1.187 to 1.199 with tension up to the apex, 1.104 to 1.117
/// without tension.
Section make_steep() {
  return make_section({{0, 5}, {15, 5}, {20.773503, 15}, {35.773503, 15}}, make_soil(33.066704, 11.947134, 20), 0);
}

SearchOptions make_options(std::vector<Method> methods) {
  SearchOptions options;
  options.methods = std::move(methods);
  options.optimise_surface = false;
  options.threads = 2;
  return options;
}

bool has(const std::vector<std::string>& warnings, const std::string& words) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// Without a crack the least circle of Spencer's method that passes its checks has 1.326.
void expect_crack(const std::vector<Method>& methods) {
  const Slope slope(make_steep());
  const SearchResult result = search(slope, make_options(methods));
  for (const Critical& c : result.circular) {
    if (c.method == Method::bishop) continue;
    EXPECT_GT(c.solution.factor, 1.104) << to_word(c.method);
    EXPECT_LT(c.solution.factor, 1.199) << to_word(c.method);
    EXPECT_EQ(c.solution.refusal, Refusal::none);
    // Rankine's depth with the strength over F.
    const double f = c.solution.factor, angle = std::atan(std::tan(11.947134 * degree) / f);
    EXPECT_GT(c.surface.crack, 0);
    EXPECT_LT(c.surface.crack, 1.02 * 2 * 33.066704 / (20 * f) * std::tan(45 * degree + angle / 2));
    const Slice& crest = c.cut.slices.back();
    EXPECT_NEAR(crest.top_right - crest.base_right[1], c.surface.crack, 1e-6) << "the mass ends at the crack";
    EXPECT_TRUE(has(c.warnings, "dry tension crack"));
  }
}

TEST(LemLostCircles, OfASteepSlopeEndInATensionCrack) {
  expect_crack({Method::bishop, Method::spencer, Method::morgenstern_price});
}

TEST(LemLostCircles, AreFoundWithoutBishopsMethodAmongTheOthers) {
  expect_crack({Method::spencer});
}

TEST(LemLostCircles, OfTheMirroredSlopeEndInTheSameCrack) {
  Section mirrored =
      make_section({{-35.773503, 15}, {-20.773503, 15}, {-15, 5}, {0, 5}}, make_soil(33.066704, 11.947134, 20), 0);
  const Slope left(make_steep()), right(std::move(mirrored));
  const Critical a = search(left, make_options({Method::spencer})).circular.front(),
                 b = search(right, make_options({Method::spencer})).circular.front();
  EXPECT_FALSE(b.cut.slides_left);
  EXPECT_NEAR(a.surface.crack, b.surface.crack, 0.02 * a.surface.crack);
  EXPECT_NEAR(a.solution.factor, b.solution.factor, 2e-3 * a.solution.factor);
}

/// Soil at the crest below a water table has no dry crack.
TEST(LemLostCircles, BelowWaterHaveNoCrack) {
  Section section = make_steep();
  section.water_table = {{0, 5}, {15, 5}, {20.773503, 5.5}, {21.5, 14.9}, {35.773503, 14.9}};
  const Slope slope(std::move(section));
  for (const Critical& c : search(slope, make_options({Method::bishop, Method::spencer})).circular)
    EXPECT_EQ(c.surface.crack, 0);
}

TEST(LemLostCircles, OfAGentleSlopeNeedNoCrack) {
  const Slope slope(make_section({{0, 5}, {15, 5}, {35, 15}, {55, 15}}, make_soil(15, 20, 20), 0));
  const SearchResult result = search(slope, make_options({Method::bishop, Method::spencer}));
  for (const Critical& c : result.circular) EXPECT_EQ(c.surface.crack, 0);
}

TEST(LemLostCircles, AreAWarningWhereTheSectionHasItsOwnCrack) {
  Section section = make_steep();
  section.crack = TensionCrack{0.4, 0};
  const Slope slope(std::move(section));
  const SearchResult result = search(slope, make_options({Method::bishop, Method::spencer}));
  ASSERT_EQ(result.circular.size(), 2u);
  EXPECT_EQ(result.circular[1].surface.crack, 0);
  EXPECT_TRUE(has(result.warnings, "has no solution on Bishop's critical circle"));
}

TEST(LemWarnings, FactorThatRestsOnALimitOfLambda) {
  const Slope slope(make_steep());
  const Checks checks;
  Critical critical;
  critical.surface = make_circle(slope, {12, 22}, 18);
  critical.cut = cut_surface(slope, critical.surface, 30, checks);
  critical.solution.factor = 1.2;
  critical.solution.lambda = checks.smallest_lambda + 1e-3;
  EXPECT_TRUE(has(find_warnings(slope, checks, critical), "rests on [lem] smallest_lambda = -0.1"));
  critical.solution.lambda = checks.largest_lambda;
  EXPECT_TRUE(has(find_warnings(slope, checks, critical), "rests on [lem] largest_lambda = 1.5"));
  critical.solution.lambda = 0.3;
  EXPECT_FALSE(has(find_warnings(slope, checks, critical), "rests on"));
  critical.solution.lambda = checks.smallest_lambda;
  critical.method = Method::bishop;
  EXPECT_FALSE(has(find_warnings(slope, checks, critical), "rests on")) << "Bishop has no λ";
}

}  // namespace
}  // namespace talus::lem
