// SPDX-License-Identifier: MIT
// The governing factor and its surface.

#include "results/governing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "results/interval.hpp"
#include "results/json.hpp"
#include "results/named.hpp"

namespace talus::results {
namespace {

CriticalSurface make_governing_surface(SliceMethod method, std::optional<double> factor,
                                       const std::string& refusal = "") {
  CriticalSurface c;
  c.surface.method = method;
  c.surface.factor = factor;
  c.checks.refusal = refusal;
  c.yield_acceleration = factor ? std::optional(*factor - 1) : std::nullopt;
  return c;
}

std::string name_governing(const RunResult& run) {
  const auto found = find_governing_surface(run);
  return found ? found->name : "";
}

TEST(GoverningSurface, IsTheWeakestByTheMethodsThatSatisfyMostOfTheEquilibrium) {
  RunResult run;
  EXPECT_EQ(name_governing(run), "");
  run.slices.emplace().error = "no circle";
  EXPECT_EQ(name_governing(run), "");
  run.slices.emplace().critical = {make_governing_surface(SliceMethod::fellenius, 1.1),
                                   make_governing_surface(SliceMethod::bishop, {})};
  EXPECT_EQ(name_governing(run), "lem.fellenius") << "no other method has one";
  run.slices->critical[1].surface.factor = 1.4;
  EXPECT_EQ(name_governing(run), "lem.bishop") << "Fellenius leaves more out";
  run.slices->critical.push_back(make_governing_surface(SliceMethod::spencer, 1.45));
  EXPECT_EQ(name_governing(run), "lem.spencer");
  run.slices->noncircular = {make_governing_surface(SliceMethod::spencer, 1.3),
                             make_governing_surface(SliceMethod::morgenstern_price, 1.25),
                             make_governing_surface(SliceMethod::janbu_corrected, 1.0)};
  EXPECT_EQ(name_governing(run), "lem.noncircular.morgenstern_price");
  run.slices->given = {make_governing_surface(SliceMethod::spencer, 1.2)};
  run.slices->given[0].surface.name = "bed";
  EXPECT_EQ(name_governing(run), "lem.surface[bed].spencer");
  run.methods.emplace().optimised = {make_governing_surface(SliceMethod::spencer, 1.15)};
  run.methods->optimised[0].surface.name = "lem.handed[fem.band].spencer_optimised";
  EXPECT_EQ(name_governing(run), "lem.handed[fem.band].spencer_optimised");
}

/// Two meshes do not show the error of an extrapolation by more than 7 %: the interval then is the result.
TEST(FarExtrapolation, IsThatOfTheMainFactor) {
  RunResult run;
  EXPECT_FALSE(find_far_extrapolation(run));
  ElementRun& elements = run.elements.emplace().runs.emplace_back();
  elements.factor = 0.937;
  EXPECT_FALSE(find_far_extrapolation(run)) << "one mesh";
  elements.meshes = {{1.753, 1.201, 1.199, 1.203, 1.203}, {0.898, 1.072, 1.070, 1.074, 1.074}};
  elements.interval = {0.660, 1.075};
  const auto far = find_far_extrapolation(run);
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->fraction, 0.126, 1e-3);
  EXPECT_EQ(far->size, 0.898);
  EXPECT_EQ(far->lower, 0.660);
  EXPECT_EQ(far->upper, 1.075);
  elements.factor = 1.0;
  EXPECT_FALSE(find_far_extrapolation(run)) << "by 6.7 %";
  elements.factor = 0.937;
  run.slices.emplace().critical = {make_governing_surface(SliceMethod::spencer, 0.9)};
  EXPECT_FALSE(find_far_extrapolation(run)) << "LEM governs";
}

/// A mass that slides down to the left over a base at 45°, held by an anchor at `dip` below the horizontal.
CriticalSurface make_anchored_surface(double factor, double dip) {
  CriticalSurface c = make_governing_surface(SliceMethod::spencer, factor);
  c.slides_left = true;
  c.slices.left = {0, 1}, c.slices.right = {1, 2};
  c.slices.base_left = {{0, 0}, {1, 1}}, c.slices.base_right = {{1, 1}, {2, 2}};
  SupportForce& force = c.supports.emplace().emplace_back();
  force.is_active = true;
  force.crossing = {1.5, 1.5};
  force.direction = {std::cos(dip), -std::sin(dip)};
  return c;
}

/// Prestress is a load in LEM and a resistance in limit analysis, which differ where it drives the mass.
TEST(GoverningSurface, WithAnAnchorThatDrivesIsNotTooLow) {
  Referee referee;
  referee.lower = 1.18, referee.upper = 1.23;
  const double degree = std::acos(-1) / 180;
  EXPECT_EQ(judge(referee, make_anchored_surface(1.1, 40 * degree)), Verdict::too_low);
  EXPECT_EQ(judge(referee, make_anchored_surface(1.1, 50 * degree)), Verdict::possible);
  EXPECT_EQ(judge(referee, make_anchored_surface(1.3, 50 * degree)), Verdict::too_high);
  CriticalSurface mirrored = make_anchored_surface(1.1, 40 * degree);
  mirrored.slides_left = false;
  EXPECT_EQ(judge(referee, mirrored), Verdict::possible) << "the same pull drives a mass that slides to the right";
  CriticalSurface passive = make_anchored_surface(1.1, 50 * degree);
  passive.supports->front().is_active = false;
  EXPECT_EQ(judge(referee, passive), Verdict::too_low);
  // The heads of supports leave no upper bound: the lower one rules out all the same.
  referee.upper.reset();
  RunResult run;
  run.slices.emplace().search.emplace();
  run.slices->critical = {make_anchored_surface(1.3, 40 * degree)};
  run.slices->noncircular = {make_anchored_surface(1.1, 40 * degree)};
  take_referee(referee, *run.slices);
  EXPECT_EQ(run.slices->critical[0].verdict, Verdict::possible);
  EXPECT_EQ(run.slices->noncircular[0].verdict, Verdict::too_low);
  EXPECT_EQ(find_main_factor(run), 1.18) << "the least factor left lies 10 % above the lower bound";
  EXPECT_EQ(find_proven_end(run), ProvenEnd::lower);
  EXPECT_NE(describe_ruled_out(run), "");
  run.slices->critical[0].surface.factor = 1.2;
  EXPECT_EQ(find_main_factor(run), 1.2);
  EXPECT_EQ(describe_ruled_out(run), "");
}

TEST(GoverningSurface, IsNeverOneThatLimitAnalysisProvesImpossible) {
  RunResult run;
  run.slices.emplace().search.emplace();
  run.slices->critical = {make_governing_surface(SliceMethod::bishop, 1.21),
                          make_governing_surface(SliceMethod::spencer, 1.33)};
  run.slices->noncircular = {make_governing_surface(SliceMethod::spencer, 1.08)};
  Referee referee;
  referee.lower = 1.18, referee.upper = 1.23;
  take_referee(referee, *run.slices);
  EXPECT_EQ(name_governing(run), "lem.bishop") << "one method is too high and too low, the other inside";
  EXPECT_EQ(find_main_factor(run), 1.21);
  EXPECT_FALSE(find_proven_end(run).has_value());
  run.slices->critical.erase(run.slices->critical.begin());
  EXPECT_EQ(name_governing(run), "");
  EXPECT_EQ(find_main_factor(run), 1.18) << "the least factor lies below what is possible";
  EXPECT_EQ(find_proven_end(run), ProvenEnd::lower);
  run.slices->noncircular.clear();
  EXPECT_EQ(find_main_factor(run), 1.23) << "a mechanism has less than every factor";
  EXPECT_EQ(find_proven_end(run), ProvenEnd::upper);
  // A surface from another method is a candidate as well.
  run.methods.emplace().optimised = {make_governing_surface(SliceMethod::spencer, 1.1)};
  run.methods->optimised[0].verdict = referee.judge(1.1);
  EXPECT_EQ(name_governing(run), "");
  // Factors of given surfaces are no factors of the slope: none is refused from above.
  run.methods.reset();
  run.slices->search.reset();
  run.slices->critical.clear();
  run.slices->given = {make_governing_surface(SliceMethod::spencer, 1.33)};
  take_referee(referee, *run.slices);
  EXPECT_EQ(find_main_factor(run), 1.33);
}

/// A weak seam: polylines of 1.075 and 1.091 follow it, the circle of 1.189 misses it.
TEST(GoverningSurface, IsTheLeastWhereTheIntervalIsWide) {
  RunResult run;
  run.slices.emplace().search.emplace();
  run.slices->critical = {make_governing_surface(SliceMethod::spencer, 1.189),
                          make_governing_surface(SliceMethod::bishop, 1.7)};
  run.slices->noncircular = {make_governing_surface(SliceMethod::spencer, 1.075)};
  Referee referee;
  referee.lower = 1.098, referee.upper = 1.68;
  take_referee(referee, *run.slices);
  EXPECT_EQ(find_main_factor(run), 1.075);
  EXPECT_EQ(run.slices->critical[1].verdict, Verdict::too_high) << "an upper bound is safe";
  referee.upper = 1.098 * 1.0513;  // 5.002 % of the middle
  EXPECT_EQ(referee.judge(1.075), Verdict::possible);
  referee.upper = 1.098 * 1.0512;
  EXPECT_EQ(referee.judge(1.075), Verdict::too_low);
  referee.upper.reset();
  EXPECT_EQ(referee.judge(1.075), Verdict::possible) << "no interval";
}

TEST(GoverningSurface, IsNoneWhereTheLeastPossibleOneMissesTheLowerBound) {
  RunResult run;
  run.slices.emplace().search.emplace();
  run.slices->critical = {make_governing_surface(SliceMethod::spencer, 1.135)};
  Referee referee;
  referee.lower = 1.1, referee.upper = 1.15;
  take_referee(referee, *run.slices);
  EXPECT_EQ(find_main_factor(run), 1.135) << "nothing was ruled out";
  EXPECT_EQ(describe_ruled_out(run), "");
  run.slices->noncircular = {make_governing_surface(SliceMethod::spencer, 1.05)};
  take_referee(referee, *run.slices);
  EXPECT_EQ(find_main_factor(run), 1.1);
  EXPECT_EQ(find_proven_end(run), ProvenEnd::lower);
  EXPECT_NE(describe_ruled_out(run).find("the least possible one, 1.135, lies more than 3 % above"), std::string::npos);
  run.slices->critical[0].surface.factor = 1.13;
  EXPECT_EQ(find_main_factor(run), 1.13) << "within 3 %";
  // Given surfaces without a search: none was missed.
  run.slices->search.reset();
  run.slices->given = std::move(run.slices->noncircular);
  run.slices->given.push_back(make_governing_surface(SliceMethod::spencer, 1.3));
  run.slices->critical.clear(), run.slices->noncircular.clear();
  take_referee(referee, *run.slices);
  EXPECT_EQ(find_main_factor(run), 1.3);
}

/// The printed bounds are 1.334 and 1.366. A factor printed as 1.334 is not said to be below 1.334.
TEST(Referee, DoesNotJudgeFactorsWithinAFifthOfAPerCentOfABound) {
  Referee referee;
  referee.lower = 1.334769, referee.upper = 1.3655;
  EXPECT_EQ(referee.judge(1.333926), Verdict::possible);
  EXPECT_EQ(referee.judge(1.3315), Verdict::possible);
  EXPECT_EQ(referee.judge(1.331), Verdict::too_low);
  EXPECT_EQ(referee.judge(1.3685), Verdict::possible);
  EXPECT_EQ(referee.judge(1.369), Verdict::too_high);
}

TEST(MainFactor, IsNotAboveTheUpperBound) {
  RunResult run;
  run.bounds.emplace().lower = 1.3;
  run.bounds->upper = 1.4;
  EXPECT_EQ(find_main_factor(run), 1.3) << "bounds alone";
  run.slices.emplace().critical = {make_governing_surface(SliceMethod::spencer, 1.5)};
  EXPECT_EQ(find_main_factor(run), 1.4);
  run.slices->critical[0].surface.factor = 1.35;
  EXPECT_EQ(find_main_factor(run), 1.35);
  run.slices->critical[0].surface.factor = 1.2;
  EXPECT_EQ(find_main_factor(run), 1.2) << "the bounds do not hold for ψ < φ";
  run.slices->critical[0].surface.factor = 1.5;
  EXPECT_TRUE(is_main_factor_proven(run));
  run.bounds->is_davis = true;
  EXPECT_EQ(find_main_factor(run), 1.5) << "they hold for a weaker soil";
  EXPECT_FALSE(is_main_factor_proven(run));
}

TEST(MainFactor, IsNotTheUpperBoundWhereSupportsActInAnotherMethod) {
  // The mechanism of the upper bound may be that of the soil below the heads, which the other methods do not judge.
  RunResult fem;
  fem.bounds.emplace().lower = 1.1, fem.bounds->upper = 1.2;
  auto& elements = fem.elements.emplace().runs.emplace_back();
  elements.factor = 1.3;
  elements.supports.emplace();
  EXPECT_EQ(find_main_factor(fem), 1.3);
  EXPECT_FALSE(is_main_factor_proven(fem));
  elements.supports.reset();
  EXPECT_EQ(find_main_factor(fem), 1.2) << "without supports it limits the factor";
  RunResult lem;
  lem.bounds = fem.bounds;
  lem.slices.emplace().critical = {make_governing_surface(SliceMethod::spencer, 1.5)};
  lem.slices->critical[0].supports.emplace();
  EXPECT_EQ(find_main_factor(lem), 1.5);
  RunResult mpm;
  mpm.bounds = fem.bounds;
  mpm.factor_of_safety.emplace().value = 1.4;
  mpm.supports.emplace();
  EXPECT_EQ(find_main_factor(mpm), 1.4);
  mpm.factor_of_safety.reset();
  EXPECT_EQ(find_main_factor(mpm), 1.1) << "limit analysis alone";
}

TEST(MainFactor, IsNoFactorByFemOutsideTheBounds) {
  RunResult run;
  run.slices.emplace().critical = {make_governing_surface(SliceMethod::spencer, 1.3)};
  run.bounds.emplace().lower = 1.25, run.bounds->upper = 1.32;
  auto& elements = run.elements.emplace().runs.emplace_back();
  elements.factor = 1.2;
  EXPECT_EQ(find_main_factor(run), 1.2) << "the bounds do not hold for soil with another flow rule";
  elements.verdict = Verdict::too_low;
  EXPECT_EQ(find_main_factor(run), 1.3);
  run.slices.reset();
  EXPECT_EQ(find_main_factor(run), 1.25) << "nothing else is left";
  run.elements->runs.emplace_back().factor = 1.27;
  EXPECT_EQ(find_main_factor(run), 1.27);
}

TEST(ProvenBounds, AreShownAwayFromTheirMiddle) {
  EXPECT_DOUBLE_EQ(show_lower(1.43199), 1.431);
  EXPECT_DOUBLE_EQ(show_upper(1.44501), 1.446);
  EXPECT_LE(show_lower(1.432), 1.432);
  EXPECT_GE(show_upper(1.445), 1.445);
}

TEST(GoverningSurface, IsNotOneThatASearchWouldRefuseWhereThereIsAnother) {
  RunResult run;
  run.slices.emplace().critical = {make_governing_surface(SliceMethod::bishop, 1.4)};
  run.slices->noncircular = {make_governing_surface(SliceMethod::spencer, 0.2, "tension")};
  EXPECT_EQ(name_governing(run), "lem.bishop");
  run.slices->critical.clear();
  EXPECT_EQ(name_governing(run), "lem.noncircular.spencer");
}

TEST(GoverningSurface, NamesTheFactorAndTheYieldAcceleration) {
  RunResult run;
  run.slices.emplace().critical = {make_governing_surface(SliceMethod::spencer, 1.4)};
  run.slices->noncircular = {make_governing_surface(SliceMethod::spencer, 1.1)};
  EXPECT_EQ(find_value(run, "lem.factor"), 1.1);
  EXPECT_EQ(find_value(run, "main_factor"), 1.1);
  EXPECT_NEAR(find_value(run, "lem.yield_acceleration").value_or(0), 0.1, 1e-12);
  EXPECT_NEAR(find_value(run, "lem.yield_acceleration.spencer").value_or(0), 0.4, 1e-12) << "of its circle";
}

TEST(MainFactor, IsTheSmallestOfTheMethods) {
  RunResult run;
  EXPECT_EQ(find_main_factor(run), std::nullopt);
  run.slices.emplace().critical = {make_governing_surface(SliceMethod::spencer, 1.3)};
  EXPECT_EQ(find_main_factor(run), 1.3);
  run.elements.emplace().runs.emplace_back().factor = 1.2;
  EXPECT_EQ(find_main_factor(run), 1.2);
  run.factor_of_safety.emplace().criteria.emplace() = {{CriterionKind::bilinear, {}, {}, {}, ""},
                                                       {CriterionKind::displacement, 1.4, 1.3, 1.5, ""}};
  EXPECT_EQ(find_main_factor(run), 1.2);
  run.factor_of_safety->value = 1.15;
  EXPECT_EQ(find_main_factor(run), 1.15);
  EXPECT_EQ(to_json(run).at("main_factor"), 1.15) << "the summary has it";
}

}  // namespace
}  // namespace talus::results
