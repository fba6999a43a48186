// SPDX-License-Identifier: MIT
// Factors of safety by the criteria of the displacement curve, on curves with a known factor.

#include "run/mpm/reduction/criteria.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/extrapolate.hpp"
#include "run/mpm/reduction/frozen_factor.hpp"
#include "run/mpm/reduction/leg.hpp"

namespace talus::run {
namespace {

/// Two straight lines that meet at factor 1.5.
std::vector<CurvePoint> make_kink() {
  std::vector<CurvePoint> curve;
  for (int i = 0; i <= 15; ++i) {
    const double f = 1.0 + 0.05 * i;
    curve.push_back({f, 0.01 * (f - 1) + (f > 1.5 ? 2 * (f - 1.5) : 0)});
  }
  return curve;
}

TEST(Bilinear, FindsTheKinkOfTwoLinesByItself) {
  const auto b = construct_bilinear(make_kink());
  ASSERT_TRUE(b && b->criterion.factor);
  EXPECT_NEAR(*b->criterion.factor, 1.5, 1e-9);
  EXPECT_NEAR(b->first.slope, 0.01, 1e-9);
  EXPECT_NEAR(b->last.slope, 2.01, 1e-9);
  EXPECT_LE(b->criterion.lower.value(), 1.5 + 1e-9);
  EXPECT_GE(b->criterion.upper.value(), 1.5 - 1e-9);
}

TEST(Bilinear, UsesTheBranchesThatAreNamed) {
  auto curve = make_kink();
  curve[10].displacement += 0.3;  // SRF 1.50, outside both named branches
  const auto b = construct_bilinear(curve, {1.0, 1.45}, {1.60, 1.75});
  ASSERT_TRUE(b && b->criterion.factor);
  EXPECT_NEAR(*b->criterion.factor, 1.5, 1e-9);
  EXPECT_EQ(b->first.factors.size(), 10u);
  EXPECT_EQ(b->last.factors.size(), 4u);
}

/// The published curve of the dry slope (Table 3.3, reference row, and the values of figure 3.2 at the ends are not
/// printed): with the peer's curve of the same slope the construction gives the peer's own 1.586.
TEST(Bilinear, GivesThePeersFactorOnThePeersCurve) {
  const std::vector<CurvePoint> peer{{1.0, 0.0},      {1.2, 0.00315}, {1.4, 0.01629},  {1.44, 0.02679},
                                     {1.45, 0.03039}, {1.5, 0.05787}, {1.55, 0.10831}, {1.6, 0.18737},
                                     {1.65, 0.3158},  {1.7, 0.54784}, {1.75, 1.00805}};
  const auto b = construct_bilinear(peer, {1.0, 1.45}, {1.60, 1.75});
  ASSERT_TRUE(b && b->criterion.factor);
  // The peer weighted every point alike; ours weigh by distance. That moves the intersection by less than 0.01.
  EXPECT_NEAR(*b->criterion.factor, 1.586, 0.01);
}

TEST(Bilinear, ReportsACurveThatDoesNotSteepen) {
  std::vector<CurvePoint> curve;
  for (int i = 0; i < 8; ++i) curve.push_back({1 + 0.1 * i, std::sqrt(i)});
  const auto b = construct_bilinear(curve);
  ASSERT_TRUE(b);
  EXPECT_FALSE(b->criterion.factor);
  EXPECT_FALSE(b->criterion.note.empty());
}

TEST(Bilinear, RefinedStretchesDoNotCountMore) {
  auto coarse = make_kink();
  auto fine = coarse;
  for (const double f : {1.61, 1.62, 1.63, 1.64}) fine.push_back({f, 0.01 * (f - 1) + 2 * (f - 1.5)});
  std::sort(fine.begin(), fine.end(), [](const auto& a, const auto& b) { return a.factor < b.factor; });
  EXPECT_NEAR(*construct_bilinear(fine)->criterion.factor, *construct_bilinear(coarse)->criterion.factor, 1e-9);
}

TEST(Bilinear, GivesNoFactorBeyondTheComputedOnes) {
  const auto b = construct_bilinear({{1.0, 1.0}, {1.1, 1.1}, {1.2, 2.2}, {1.3, 4.2}}, {1.0, 1.1}, {1.2, 1.3});
  ASSERT_TRUE(b && b->criterion.factor);
  const auto outside = construct_bilinear({{1.0, 1.0}, {1.1, 1.1}, {1.2, 5.0}, {1.3, 6.0}}, {1.0, 1.1}, {1.2, 1.3});
  ASSERT_TRUE(outside);
  EXPECT_FALSE(outside->criterion.factor);
  EXPECT_NE(outside->criterion.note.find("no factor was computed"), std::string::npos);
}

TEST(Criteria, GiveNoFactorWhereTheSlopeHasFailedAtTheSmallest) {
  const std::vector<CurvePoint> failed{{0.9, 299.4}, {0.95, 300.1}, {1.0, 300.7}, {1.05, 350}, {1.1, 400}};
  const auto criteria = find_criteria(failed, construct_bilinear(failed), 0.03, 10, {"m", 1});
  ASSERT_EQ(criteria.size(), 3u);
  for (const results::Criterion& c : criteria) {
    EXPECT_FALSE(c.factor);
    EXPECT_NE(c.note.find("already the smallest computed factor, 0.9, moves the slope by 299 m"), std::string::npos);
  }
}

TEST(DisplacementCriterion, InterpolatesBetweenTrials) {
  const results::Criterion c = find_displacement_criterion({{1.0, 0.0}, {1.4, 0.1}, {1.5, 0.5}}, 0.3, {"m", 1});
  ASSERT_TRUE(c.factor);
  EXPECT_NEAR(*c.factor, 1.45, 1e-12);
  EXPECT_EQ(c.lower, 1.4);
  EXPECT_EQ(c.upper, 1.5);
  EXPECT_FALSE(find_displacement_criterion({{1.0, 0.0}, {1.4, 0.1}}, 0.3, {"m", 1}).factor);
}

TEST(JumpCriterion, FindsTheIntervalOfFastestGrowthAndIgnoresElasticNoise) {
  const results::Criterion c =
      find_jump_criterion({{1.0, 1e-9}, {1.1, 1e-6}, {1.2, 0.02}, {1.3, 0.03}, {1.4, 0.9}, {1.5, 1.5}}, 0.01);
  ASSERT_TRUE(c.factor);
  EXPECT_EQ(c.lower, 1.3);
  EXPECT_EQ(c.upper, 1.4);
}

TEST(Refinement, HalvesWhereTheCurveBendsAndStaysOnTheGrid) {
  const auto curve = make_kink();
  const auto added = choose_refinement(curve, 0.01);
  ASSERT_EQ(added.size(), 2u);
  EXPECT_NEAR(added[0], 1.47, 1e-9);
  EXPECT_NEAR(added[1], 1.52, 1e-9);
  EXPECT_TRUE(choose_refinement(curve, 0.05).empty()) << "intervals as short as the smallest are not halved";
}

/// Trials of a slope that fails above `critical`; counts them.
struct IdealSlope {
  double critical;
  int trials = 0;
  results::Trial operator()(double factor) {
    ++trials;
    results::Trial t;
    t.factor = factor;
    t.end = factor < critical ? results::StageEnd::rest : results::StageEnd::failed;
    return t;
  }
};

/// One trial after the other.
RunTrials in_turn(std::function<results::Trial(double)> run_one) {
  return [run_one = std::move(run_one)](const std::vector<double>& factors) {
    std::vector<results::Trial> trials;
    std::transform(factors.begin(), factors.end(), std::back_inserter(trials), run_one);
    return trials;
  };
}

TEST(FrozenSearch, BracketsTheFactorToTheResolution) {
  input::FrozenFactor settings;
  for (const double critical : {1.0001, 1.3, 1.4444, 1.77, 1.9999}) {
    IdealSlope slope{critical};
    const results::MeshFactor found = search_frozen_factor(settings, in_turn(std::ref(slope)));
    EXPECT_LE(found.lower.value(), critical);
    EXPECT_GE(found.upper.value(), critical);
    EXPECT_LE(*found.upper - *found.lower, settings.resolution * (1 + 1e-9));
    EXPECT_LE(slope.trials, 14) << critical;
    EXPECT_FALSE(found.undecided);
  }
}

TEST(FrozenSearch, LeavesTheFirstBracketWhenTheFactorIsOutside) {
  input::FrozenFactor settings;
  for (const double critical : {0.4, 0.95, 2.05, 5.0}) {
    IdealSlope slope{critical};
    const results::MeshFactor found = search_frozen_factor(settings, in_turn(std::ref(slope)));
    EXPECT_LE(found.lower.value(), critical);
    EXPECT_GE(found.upper.value(), critical);
    EXPECT_LE(*found.upper - *found.lower, settings.resolution * (1 + 1e-9)) << critical;
  }
}

TEST(FrozenSearch, CountsAnUndecidedTrialAsFailedAndReportsIt) {
  const results::MeshFactor found =
      search_frozen_factor({}, in_turn([](double factor) {
                             results::Trial t;
                             t.factor = factor;
                             t.end = factor < 1.5 ? results::StageEnd::rest : results::StageEnd::time;
                             return t;
                           }));
  EXPECT_TRUE(found.undecided);
  EXPECT_NEAR(found.factor().value(), 1.5, 0.01);
  EXPECT_NE(describe_undecided(found, {}, {"m", 1}).find("and a factor that was not found. A longer 'window'"),
            std::string::npos);
}

TEST(FrozenSearch, WarnsOfUndecidedTrialsWhereTheyLeaveTheFactorOpen) {
  for (const double runs_away : {1.51, 1.60}) {
    const results::MeshFactor found = search_frozen_factor({}, in_turn([&](double factor) {
                                                             results::Trial t;
                                                             t.factor = factor;
                                                             t.end = factor < 1.5         ? results::StageEnd::rest
                                                                     : factor < runs_away ? results::StageEnd::time
                                                                                          : results::StageEnd::failed;
                                                             return t;
                                                           }));
    EXPECT_TRUE(found.undecided);
    EXPECT_EQ(describe_undecided(found, {}, {"m", 1}).empty(), runs_away < 1.53) << "2 % of the factor";
    // The interval extends to the factor of the failed trial, not to the undecided one that was counted as failed.
    const results::FrozenFactor frozen = join_meshes({found});
    EXPECT_GE(*frozen.factor + frozen.bracket, runs_away);
  }
}

TEST(FrozenSearch, HasNoFactorWhereAnEndOfTheBracketWasNotFound) {
  input::FrozenFactor settings;
  IdealSlope strong{1e9}, weak{0};
  const results::MeshFactor above = search_frozen_factor(settings, in_turn(std::ref(strong)));
  EXPECT_TRUE(above.lower.has_value());
  EXPECT_FALSE(above.upper.has_value()) << "nothing failed";
  EXPECT_FALSE(above.factor().has_value());
  const results::FrozenFactor none = join_meshes({above});
  EXPECT_FALSE(none.factor.has_value());
  EXPECT_EQ(none.note.rfind("above 15", 0), 0u) << none.note;
  const results::MeshFactor below = search_frozen_factor(settings, in_turn(std::ref(weak)));
  EXPECT_FALSE(below.lower.has_value()) << "nothing rested";
  EXPECT_NE(join_meshes({below}).note.find("does not depend on the strength"), std::string::npos);
}

TEST(FrozenSearch, TriesTheSameFactorsForAnyNumberOfThreads) {
  const auto list = [](int side_by_side) {
    const RunTrials run = [&](const std::vector<double>& factors) {
      std::vector<results::Trial> trials;
      const auto run_one = [&](int i) { return results::TrialOutcome{IdealSlope{1.39}(factors[i]), {}, {}}; };
      for (const auto& o : run_side_by_side(static_cast<int>(factors.size()), side_by_side, run_one))
        trials.push_back(o.trial);
      return trials;
    };
    std::vector<double> factors;
    for (const results::Trial& t : search_frozen_factor({}, run).trials) factors.push_back(t.factor);
    return factors;
  };
  EXPECT_EQ(list(1), list(2));
}

results::MeshFactor make_mesh(double size, double factor) {
  results::MeshFactor mesh;
  mesh.size = size;
  mesh.lower = factor - 0.002;
  mesh.upper = factor + 0.002;
  return mesh;
}

TEST(FrozenInterval, HoldsBracketsAndWhatTheMeshDoes) {
  const auto pair = [] { return std::vector{make_mesh(0.75, 1.459), make_mesh(0.375, 1.427)}; };
  const results::FrozenFactor plain = join_meshes(pair());
  EXPECT_NEAR(*plain.factor, 1.395, 1e-12) << "the error of half the size is a half";
  EXPECT_NEAR(plain.bracket, 0.006, 1e-12) << "(2 + 1) times half a bracket";
  EXPECT_NEAR(plain.mesh_effect.value(), 0.032, 1e-12) << "what lies between the meshes";
  EXPECT_NEAR(plain.uncertainty.value(), 0.038, 1e-12);
  const results::FrozenFactor apart = join_meshes(pair(), {}, make_mesh(0.75, 1.496));
  EXPECT_EQ(apart.factor, plain.factor) << "the other mesher moves no factor";
  EXPECT_NEAR(apart.mesh_effect.value(), 0.037, 1e-12);
  const results::FrozenFactor close =
      join_meshes({make_mesh(0.75, 1.430), make_mesh(0.375, 1.428)}, {}, make_mesh(0.75, 1.430));
  EXPECT_NEAR(close.mesh_effect.value(), 3 * 0.006 * 1.426, 1e-12) << "meshes that agree by chance";
  const results::FrozenFactor one = join_meshes({make_mesh(0.75, 1.459)});
  EXPECT_FALSE(one.mesh_effect.has_value()) << "one mesh has no mesh error";
  EXPECT_FALSE(one.uncertainty.has_value());
  EXPECT_FALSE(one.lower().has_value()) << "a bracket of the search is no interval of the factor";
  EXPECT_NEAR(one.bracket, 0.002, 1e-12);
}

/// Through 2h, h and h/2 with weights 1/h the coefficients of the three factors are −5/13, 2/13 and 16/13.
TEST(FrozenInterval, OfThreeMeshesIsThatOfTheLineThroughThem) {
  const auto line = [](double h) { return make_mesh(h, 1.36 + 0.1 * h); };
  EXPECT_NEAR(*join_meshes({line(0.75), line(0.375)}, line(1.5)).factor, 1.36, 1e-12);
  const results::FrozenFactor scattered =
      join_meshes({make_mesh(0.75, 1.442), make_mesh(0.375, 1.397)}, make_mesh(1.5, 1.492));
  EXPECT_NEAR(*scattered.factor, (-5 * 1.492 + 2 * 1.442 + 16 * 1.397) / 13, 1e-12);
  EXPECT_NEAR(scattered.bracket, 23.0 / 13 * 0.002, 1e-12);
  EXPECT_NEAR(scattered.mesh_effect.value(), 0.045, 1e-12) << "what lies between the two finest";
  const results::FrozenFactor finest = join_meshes({line(0.75), line(0.375), line(0.1875)});
  EXPECT_NEAR(*finest.factor, 1.36, 1e-12);
  EXPECT_NEAR(finest.mesh_effect.value(), 0.01875, 1e-12) << "what lies between the two finest";
  results::MeshFactor none = line(1.5);
  none.lower.reset();
  EXPECT_NEAR(*join_meshes({line(0.75), line(0.375)}, none).factor, 1.36, 1e-12) << "a coarser mesh without a factor";
}

/// Pairs of the study of eight slopes with ψ = φ (docs/verification_data/frozen_meshes.md) and the ends of what is
/// proven: the interval of every pair reaches it.
TEST(FrozenInterval, HoldsWhatIsProvenOfTheStudiedSlopes) {
  struct Pair {
    double lower, upper, coarse, fine;
  };
  for (const Pair& p : {Pair{1.431, 1.442, 1.529, 1.479}, {1.431, 1.442, 1.496, 1.463}, {1.431, 1.442, 1.479, 1.455},
                        {1.375, 1.385, 1.508, 1.447},     {1.375, 1.385, 1.471, 1.426}, {1.375, 1.385, 1.447, 1.414},
                        {1.300, 1.300, 1.364, 1.340},     {1.300, 1.300, 1.356, 1.327}, {1.300, 1.300, 1.340, 1.319},
                        {1.294, 1.302, 1.377, 1.344},     {1.294, 1.302, 1.352, 1.331}, {1.294, 1.302, 1.344, 1.323},
                        {1.266, 1.281, 1.294, 1.282},     {1.266, 1.281, 1.286, 1.278}, {1.266, 1.281, 1.282, 1.274},
                        {1.195, 1.204, 1.233, 1.216},     {1.195, 1.204, 1.224, 1.212}, {1.195, 1.204, 1.216, 1.208},
                        {1.187, 1.194, 1.253, 1.224},     {1.187, 1.194, 1.241, 1.216}, {1.187, 1.194, 1.224, 1.212},
                        {1.200, 1.215, 1.228, 1.220},     {1.200, 1.215, 1.241, 1.212}, {1.200, 1.215, 1.220, 1.208}}) {
    const results::FrozenFactor f = join_meshes({make_mesh(2, p.coarse), make_mesh(1, p.fine)});
    EXPECT_LT(f.lower().value(), p.upper) << p.coarse << ", " << p.fine;
    EXPECT_GT(f.upper().value(), p.lower) << p.coarse << ", " << p.fine;
  }
}

/// The vertical cut of the same study in tetrahedra, between smooth walls: 1.3 is exact.
TEST(FrozenInterval, ContainsTheKnownFactorsOfTetrahedra) {
  for (const auto& [coarse, fine] : {std::pair{1.426, 1.389}, {1.389, 1.356}}) {
    const results::FrozenFactor f = join_meshes({make_mesh(2, coarse), make_mesh(1, fine)}, {}, {}, 3);
    EXPECT_NEAR(f.mesh_effect.value(), 1.5 * (coarse - fine), 1e-12);
    EXPECT_LT(f.lower().value(), 1.3);
  }
}

TEST(Extrapolation, IsExactForErrorsThatFallWithTheMeshSize) {
  const auto line = [](double h) { return 1.44 + 0.08 * h; };
  EXPECT_NEAR(extrapolate_to_zero(0.75, line(0.75), 0.375, line(0.375)), 1.44, 1e-12);
  EXPECT_NEAR(extrapolate_to_zero(1.0, line(1.0), 0.4, line(0.4)), 1.44, 1e-12);
}

}  // namespace
}  // namespace talus::run
