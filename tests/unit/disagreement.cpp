// SPDX-License-Identifier: MIT
// Factors of one case of which one is far above the other.

#include "results/disagreement.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "results/governing.hpp"
#include "results/json.hpp"
#include "run/digest.hpp"

namespace talus::results {
namespace {

CriticalSurface make_found(SliceMethod method, double factor) {
  CriticalSurface c;
  c.surface.method = method;
  c.surface.title = get_title(method);
  c.surface.factor = factor;
  return c;
}

/// LEM by Spencer's method and FEM with ψ = φ.
RunResult make_pair(double lem, double fem) {
  RunResult run;
  run.title = "pair";
  run.slices.emplace().search.emplace();
  run.slices->critical = {make_found(SliceMethod::spencer, lem)};
  ElementRun reduction;
  reduction.flow = Flow::associated;
  reduction.factor = fem;
  run.elements.emplace().runs = {reduction};
  run.methods.emplace();
  return run;
}

std::string read_text(const RunResult& run) {
  const auto found = find_disagreement(run);
  return found ? found->text : "";
}

TEST(Disagreement, NamesBothFactorsBeforeTheOneThatGoverns) {
  EXPECT_FALSE(find_disagreement(RunResult()));
  EXPECT_FALSE(find_disagreement(make_pair(2.5, 1.0)));
  EXPECT_FALSE(find_disagreement(make_pair(1.0, 2.5)));
  const RunResult bedding = make_pair(1.05, 0.33);
  EXPECT_EQ(read_text(bedding),
            "The methods disagree by a factor of 3.2: FEM (ψ = φ) 0.330, LEM (Spencer, critical circle) 1.050; neither "
            "may be used before the reason is found.");
  const auto pair = find_disagreement(bedding);
  EXPECT_EQ(pair->low, 0.33);
  EXPECT_EQ(pair->high, 1.05);
  EXPECT_NEAR(pair->ratio, 1.05 / 0.33, 1e-12);
  EXPECT_EQ(find_main_factor(bedding), 0.33) << "the smallest still governs";
  // Terminal and summary.json state it, and the terminal before the factor.
  const std::string digest = run::write_digest(bedding);
  const auto stated = digest.find(pair->text), headline = digest.find("Factor of safety 0.330");
  EXPECT_LT(stated, headline) << digest;
  EXPECT_NE(headline, std::string::npos) << digest;
  EXPECT_EQ(to_json(bedding).at("disagreement").at("text"), pair->text);
  EXPECT_TRUE(to_json(make_pair(1, 1)).at("disagreement").is_null());
}

TEST(Disagreement, CountsProvenBounds) {
  RunResult run = make_pair(1.5, 1.2);
  BoundsResult& bounds = run.bounds.emplace();
  bounds.lower = 0.4;
  EXPECT_FALSE(find_disagreement(run)) << "a lower bound far below excludes nothing";
  bounds.upper = 0.45;
  EXPECT_EQ(read_text(run),
            "The methods disagree by a factor of 3.3: limit analysis at most 0.450, LEM (Spencer, critical circle) "
            "1.500; neither may be used before the reason is found.");
  bounds.is_davis = true;
  EXPECT_FALSE(find_disagreement(run)) << "with the strength of Davis nothing is proven of the soil";
  bounds.is_davis = false;
  bounds.lower = 1.053, bounds.upper = 1.07;
  run.elements->runs[0].factor = 0.354;
  EXPECT_EQ(read_text(run).find("The methods disagree by a factor of 4.2: FEM (ψ = φ) 0.354, LEM"), 0u);
  run.slices.reset();
  EXPECT_EQ(read_text(run).find("The methods disagree by a factor of 3.0: FEM (ψ = φ) 0.354, limit analysis at least"),
            0u);
  bounds.lower = 1.505, bounds.upper = 1.561;
  run.elements->runs[0].factor = 0.084;
  EXPECT_NEAR(find_disagreement(run)->ratio, 1.505 / 0.084, 1e-9);
  run.elements->runs[0].verdict = Verdict::too_low;
  EXPECT_FALSE(find_disagreement(run)) << "a factor that is ruled out is no headline";
}

TEST(Disagreement, ComparesTheMethodsOfLemOnEqualSurfaces) {
  RunResult run = make_pair(1.3, 1.3);
  run.slices->critical.push_back(make_found(SliceMethod::janbu, 0.4));
  EXPECT_EQ(read_text(run).find("The methods disagree by a factor of 3.2: LEM (Janbu"), 0u) << read_text(run);
  run.slices->critical[1].checks.refusal = "λ outside its limits";
  EXPECT_FALSE(find_disagreement(run)) << "a search would reject it";
  run.slices->critical.pop_back();
  // A surface high above the mechanism is no contradiction; two methods on it are one.
  run.slices->given = {make_found(SliceMethod::spencer, 5), make_found(SliceMethod::bishop, 4.8)};
  for (CriticalSurface& c : run.slices->given) c.surface.name = "deep";
  EXPECT_FALSE(find_disagreement(run));
  run.slices->given[1].surface.factor = 1.5;
  EXPECT_NE(read_text(run).find("on the given surface 'deep'"), std::string::npos) << read_text(run);
}

TEST(Disagreement, OfAGivenSurfaceAloneIsNoneWithAnUpperBoundBelowIt) {
  RunResult run = make_pair(4.0, 1.2);
  run.elements.reset();
  run.slices->search.reset();
  run.slices->given = std::move(run.slices->critical);
  run.slices->critical.clear();
  run.bounds.emplace().upper = 1.2;
  EXPECT_FALSE(find_disagreement(run)) << "another mechanism is weaker";
}

TEST(Disagreement, ComparesEqualTimesAndEqualDrainage) {
  RunResult run;
  ConstructionStage stage;
  stage.name = "fill";
  stage.factors = {{Method::lem, "LEM, Spencer", 1.5, {}, {}, {}, true}, {Method::fem, "FEM", 0.4, {}, {}, {}, {}}};
  run.construction.emplace().stages = {stage};
  EXPECT_FALSE(find_disagreement(run)) << "with and without drainage";
  run.construction->stages[0].factors[1].undrained = true;
  EXPECT_NE(read_text(run).find("at the end of stage 'fill': FEM 0.400, LEM, Spencer 1.500"), std::string::npos)
      << read_text(run);
  run.construction.reset();
  Timeline& timeline = run.timeline.emplace();
  timeline.factors.resize(2);
  timeline.factors[0].factor = 3.6, timeline.factors[1].factor = 1.2;
  timeline.factors[1].time = 86400;
  ElementRun reduction;
  reduction.factor = 1.1;
  timeline.elements = {{86400, "", {reduction}, {}}};
  EXPECT_FALSE(find_disagreement(run));
  timeline.elements[0].time = 0;
  EXPECT_NE(read_text(run).find("by a factor of 3.3 at "), std::string::npos) << read_text(run);
}

}  // namespace
}  // namespace talus::results
