// SPDX-License-Identifier: MIT
// Back-analysis: values of keys with a closed form, their intervals, refusals and resumption.
#include "study/back_analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "results/json.hpp"
#include "results/named.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;
using results::BackAnalysisEnd;
using results::BackAnalysisRun;

/// A plane from (2, 10) to the toe (16, 0) cuts a wedge of 40 m2 off; the arc is another given surface.
const std::string wedge = R"(
title = "Wedge"
[geometry]
[[geometry.polygon]]
name = "soil"
points = [[0, -5], [30, -5], [30, 0], [16, 0], [10, 10], [0, 10]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 18
cohesion = 20
friction_angle = 20
[regions]
soil = "clay"
[analysis]
methods = ["lem"]
[lem]
methods = ["spencer"]
search = "none"
referee = false
[[lem.surface]]
name = "plane"
points = [[2, 10], [16, 0]]
)";

const std::string arc = R"(
[[lem.surface]]
name = "arc"
centre = [20, 16]
radius = 17
)";

BackAnalysisRequest vary(const std::string& key, const std::string& target, const std::string& from = "",
                         const std::string& to = "") {
  return {key, target, from, to, 1e-3};
}

class BackAnalysisRuns : public testing::Test {
 protected:
  BackAnalysisOutcome search(const std::string& text, const BackAnalysisRequest& request,
                             const std::vector<std::string>& sets = {}, bool resume = false,
                             Progress* progress = nullptr) const {
    std::vector<input::Override> overrides;
    for (const std::string& set : sets) overrides.push_back(input::parse_override(set));
    StudyOptions options;
    options.folder = folder_;
    options.resume = resume;
    options.overwrite = !resume;
    options.progress = progress;
    return search_key(input::read_case_text(text, "case.toml", overrides), overrides, request, options);
  }

  /// Returns the sentence of the refusal, before which nothing is written.
  std::string refuse(const BackAnalysisRequest& request) const {
    std::string sentence;
    try {
      search(wedge, request);
    } catch (const InputError& error) {
      EXPECT_EQ(error.diagnostics().size(), 1U);
      sentence = error.diagnostics().front().sentence;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::wrong_input);
      sentence = error.what();
    }
    EXPECT_FALSE(fs::exists(folder_)) << sentence;
    return sentence;
  }

  fs::path folder_ = support::make_scratch("back_analysis") / "results";
};

void expect_text(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

TEST_F(BackAnalysisRuns, TheCohesionOfAPlaneWedgeIsExact) {
  const double alpha = std::atan2(10.0, 14.0), phi = 20 * std::numbers::pi / 180, length = std::hypot(14.0, 10.0);
  const double weight = 18 * 40, exact = weight * (std::sin(alpha) - std::cos(alpha) * std::tan(phi)) / length;
  const BackAnalysisOutcome outcome = search(wedge, vary("materials.clay.cohesion", "factor=1"));
  ASSERT_TRUE(outcome.finding.value);
  EXPECT_NEAR(*outcome.finding.value, exact, 1e-6 * exact);
  EXPECT_EQ(outcome.finding.unit, "kPa");
  EXPECT_EQ(outcome.finding.runs.front().by, "lem.surface[plane].spencer");
  EXPECT_FALSE(outcome.failure);
  // The result has no interval, and the text says so.
  EXPECT_FALSE(outcome.finding.low || outcome.finding.high);
  expect_text(outcome.finding.sentences.back(), "no interval");
  expect_text(outcome.tables, outcome.finding.sentences.front());
}

TEST_F(BackAnalysisRuns, UndrainedStrengthOnACircleIsProportionalToTheFactor) {
  const std::vector<std::string> undrained{"materials.clay.friction_angle=0", "lem.methods=['bishop']"};
  const BackAnalysisOutcome outcome =
      search(wedge + arc, vary("materials.clay.cohesion", "lem.surface[arc].bishop=1.3"), undrained);
  ASSERT_TRUE(outcome.finding.value);
  const BackAnalysisRun& first = outcome.finding.runs.front();
  EXPECT_EQ(first.value, 20);
  EXPECT_NEAR(*outcome.finding.value, 20 * 1.3 / *first.result, 1e-6 * *outcome.finding.value);
  const auto study = results::read_file<results::StudyResult>(folder_ / "study.json");
  ASSERT_TRUE(study);
  EXPECT_EQ(study->back_analysis->value, outcome.finding.value);
  EXPECT_EQ(study->variants.size(), outcome.finding.runs.size());
  const auto has_result = [](const results::StudyColumn& c) { return c.name == "lem.surface[arc].bishop"; };
  EXPECT_TRUE(std::any_of(study->columns.begin(), study->columns.end(), has_result));
}

TEST_F(BackAnalysisRuns, TheEarthquakeAtFactorOneIsTheYieldAcceleration) {
  // Janbu's method is exact on a plane, where all bases have one inclination.
  const double alpha = std::atan2(10.0, 14.0), phi = 20 * std::numbers::pi / 180, length = std::hypot(14.0, 10.0);
  const double weight = 18 * 40, resistance = 20 * length + weight * std::cos(alpha) * std::tan(phi);
  const double exact =
      (resistance - weight * std::sin(alpha)) / (weight * (std::cos(alpha) + std::sin(alpha) * std::tan(phi)));
  const std::vector<std::string> plane{"lem.methods=['janbu']"}, curved{"lem.surface.plane="};
  for (const std::vector<std::string>& sets : {plane, curved}) {
    const bool is_plane = &sets == &plane || sets == plane;
    const BackAnalysisOutcome outcome = search(wedge + arc, vary("earthquake.horizontal", "factor=1"), sets);
    ASSERT_TRUE(outcome.finding.value) << outcome.tables;
    EXPECT_EQ(outcome.finding.runs.front().value, 0);
    const auto still = load_variant(folder_ / "horizontal_0");
    const auto yield = results::find_value(*still, "lem.yield_acceleration");
    ASSERT_TRUE(yield);
    EXPECT_NEAR(std::abs(*outcome.finding.value), *yield, 2e-5 * *yield);
    if (is_plane) {
      EXPECT_NEAR(*yield, exact, 1e-5);
    }
  }
}

TEST_F(BackAnalysisRuns, TheIntervalOfLimitAnalysisContainsTheValueByLimitEquilibrium) {
  const std::vector<std::string> limits{"materials.clay.tensile_strength=0", "analysis.methods=['bounds']",
                                        "bounds.gap=0.1"};
  BackAnalysisRequest request = vary("materials.clay.cohesion", "bounds.lower=1", "10", "25");
  request.tolerance = 0.02;
  const BackAnalysisOutcome bounds = search(wedge, request, limits);
  ASSERT_TRUE(bounds.finding.value && bounds.finding.low && bounds.finding.high) << bounds.tables;
  EXPECT_EQ(bounds.finding.interval_of, "limit analysis");
  const std::vector<std::string> slices{"lem.surface=", "lem.search=entry_exit", "lem.noncircular=false",
                                        "lem.entry_exit={exits=12, entries=12, depths=8}"};
  const BackAnalysisOutcome lem = search(wedge, vary("materials.clay.cohesion", "lem.factor=1", "10", "25"), slices);
  ASSERT_TRUE(lem.finding.value) << lem.tables;
  EXPECT_LT(*bounds.finding.low, *lem.finding.value);
  EXPECT_GT(*bounds.finding.high, *lem.finding.value);
  // The ends are values of runs whose interval excludes the target.
  for (const BackAnalysisRun& run : bounds.finding.runs) {
    if (run.value == *bounds.finding.low) {
      EXPECT_LT(*run.upper, 1);
    }
    if (run.value == *bounds.finding.high) {
      EXPECT_GT(*run.lower, 1);
    }
  }
}

/// Rows of nails on the face of the wedge; each pulls with the same force, so that the factor of the plane is known.
const std::string nails = R"(
[support.nails]
kind = "bolt"
first = [10.9, 8.5]
rows = 2
row_spacing = 1
inclination = 0
length = 9
out_of_plane_spacing = 1.5
tensile_strength = 30
)";

TEST_F(BackAnalysisRuns, RowsAreWholeNumbers) {
  // F = (c l + (W cos α + n T sin α) tan φ) / (W sin α - n T cos α), T = 30/1.5.
  const double alpha = std::atan2(10.0, 14.0), phi = 20 * std::numbers::pi / 180, length = std::hypot(14.0, 10.0);
  const auto compute = [&](double n) {
    return (20 * length + (720 * std::cos(alpha) + n * 20 * std::sin(alpha)) * std::tan(phi)) /
           (720 * std::sin(alpha) - n * 20 * std::cos(alpha));
  };
  int rows = 1;
  while (compute(rows) < 1.55) ++rows;
  ASSERT_EQ(rows, 4);
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"", ""}, {"1", "6"}}) {
    const BackAnalysisOutcome outcome = search(wedge + nails, vary("support.nails.rows", "factor=1.55", from, to));
    ASSERT_TRUE(outcome.finding.value) << outcome.tables;
    EXPECT_TRUE(outcome.finding.is_whole);
    EXPECT_EQ(*outcome.finding.value, rows);
    EXPECT_EQ(outcome.finding.bracket->low, rows - 1);
    EXPECT_NEAR(outcome.finding.bracket->low_result, compute(rows - 1), 1e-5);
    EXPECT_NEAR(outcome.finding.bracket->high_result, compute(rows), 1e-5);
    expect_text(outcome.finding.sentences.front(),
                "The smallest number with at least 1.55 is support.nails.rows = 4: ");
    expect_text(outcome.finding.sentences.front(), " at 3");
    for (const BackAnalysisRun& run : outcome.finding.runs) EXPECT_EQ(run.value, std::floor(run.value));
    EXPECT_FALSE(outcome.failure);
  }
  // The sixth row would lie below the foot of the slope.
  const BackAnalysisOutcome none =
      search(wedge + nails, vary("support.nails.rows", "factor=50"), {"support.nails.row_spacing=2"});
  EXPECT_EQ(none.finding.end, BackAnalysisEnd::not_reached);
  expect_text(none.tables, "beyond the foot of the slope");
  const BackAnalysisOutcome above = search(wedge + nails, vary("support.nails.rows", "factor=1.1"));
  expect_text(above.failure->what(), "is everywhere above 1.1: it is");
  try {
    search(wedge + nails, vary("support.nails.rows", "factor=1.5", "1.5", "4"));
    FAIL() << "a fraction of a row was accepted";
  } catch (const Error& error) {
    expect_text(error.what(), "--from is 1.5, and 'support.nails.rows' is a whole number");
  }
}

TEST_F(BackAnalysisRuns, TheForceForATargetStandsBesideThatOfOtherMethods) {
  // One bolt of 1 m spacing pulls horizontally: F = (c l + (W cos α + T sin α) tan φ) / (W sin α - T cos α). All
  // methods that balance forces agree on a plane.
  const double alpha = std::atan2(10.0, 14.0), phi = 20 * std::numbers::pi / 180, length = std::hypot(14.0, 10.0);
  const auto compute = [&](double factor) {
    return (factor * 720 * std::sin(alpha) - 20 * length - 720 * std::cos(alpha) * std::tan(phi)) /
           (factor * std::cos(alpha) + std::sin(alpha) * std::tan(phi));
  };
  const std::vector<std::string> pull{"support.nails.rows=1", "support.nails.out_of_plane_spacing=1",
                                      "support.nails.tensile_strength=50", "lem.methods=['janbu', 'spencer']"};
  BackAnalysisRequest request = vary("support.nails.tensile_strength", "factor=1.5");
  request.further = {"lem.surface[plane].janbu=1.5", "lem.surface[plane].spencer=1.7", "lem.surface[plane].janbu=40"};
  const BackAnalysisOutcome outcome = search(wedge + nails, request, pull);
  ASSERT_TRUE(outcome.finding.value) << outcome.tables;
  EXPECT_NEAR(*outcome.finding.value, compute(1.5), 1e-4 * compute(1.5));
  ASSERT_EQ(outcome.finding.further.size(), 3U);
  EXPECT_NEAR(*outcome.finding.further[0].value, compute(1.5), 1e-4 * compute(1.5));
  EXPECT_NEAR(*outcome.finding.further[1].value, compute(1.7), 1e-4 * compute(1.7));
  for (const auto& t : outcome.finding.further) EXPECT_EQ(t.runs.size(), outcome.finding.runs.size());
  expect_text(outcome.tables, "| target | support.nails.tensile_strength | its interval allows |");
  expect_text(outcome.tables, "| lem.surface[plane].spencer = 1.7 | ");
  const auto study = results::read_file<results::StudyResult>(folder_ / "study.json");
  ASSERT_TRUE(study);
  EXPECT_EQ(study->back_analysis->further[1].value, outcome.finding.further[1].value);
  // No value is repeated, and a target out of reach is the failure of the search.
  for (std::size_t i = 0; i < outcome.finding.runs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(outcome.finding.runs[i].value, outcome.finding.runs[k].value);
  if (!outcome.finding.further[2].value) {
    ASSERT_TRUE(outcome.failure);
    expect_text(outcome.failure->what(), "'lem.surface[plane].janbu'");
  }
}

TEST_F(BackAnalysisRuns, ATargetOutOfReachIsOneSentenceWithTheFactorsAtBothEnds) {
  const BackAnalysisOutcome outcome = search(wedge, vary("materials.clay.cohesion", "factor=1", "15 kPa", "0.03 MPa"));
  EXPECT_EQ(outcome.finding.end, BackAnalysisEnd::not_reached);
  EXPECT_FALSE(outcome.finding.value || outcome.finding.bracket);
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code(), ExitCode::wrong_input);
  const std::string sentence = outcome.failure->what();
  expect_text(sentence, "does not reach 1: it is 1.1262 at materials.clay.cohesion = 15 kPa and 1.7429 at 30 kPa");
  // The arc does not govern beside the plane.
  const BackAnalysisOutcome other = search(wedge + arc, vary("lem.surface.arc.radius", "factor=1", "17", "18"));
  EXPECT_EQ(other.finding.end, BackAnalysisEnd::no_effect) << other.tables;
  expect_text(other.finding.sentences.front(), "does not depend on lem.surface.arc.radius");
}

TEST_F(BackAnalysisRuns, RunsWithoutAResultNarrowTheSearch) {
  // A circle of less than 16 m does not meet the ground, which is a fault of the case. The search expands to it.
  const BackAnalysisOutcome outcome =
      search(wedge + arc, vary("lem.surface.arc.radius", "lem.surface[arc].spencer=1.6"));
  ASSERT_TRUE(outcome.finding.value) << outcome.tables;
  const BackAnalysisOutcome none = search(wedge + arc, vary("lem.surface.arc.radius", "lem.surface[arc].spencer=0.1"));
  EXPECT_EQ(none.finding.end, BackAnalysisEnd::not_reached);
  expect_text(none.tables, "lies outside the ground");
  expect_text(none.tables, "| failed |");
}

TEST_F(BackAnalysisRuns, ImpossibleRequestsAreOneSentenceBeforeAnythingIsWritten) {
  const std::string cohesion = "materials.clay.cohesion";
  expect_text(refuse(vary("materials.clay.cohesoin", "factor=1")), "did you mean 'cohesion'?");
  expect_text(refuse(vary("materials.caly.cohesion", "factor=1")), "did you mean 'clay'?");
  expect_text(refuse(vary("materials.clay.model", "factor=1")), "'materials.clay.model' is not a single number");
  expect_text(refuse(vary("lem.entry_exit.exits", "factor=1")), "is a whole number that sets a method");
  for (const char* target : {"factor", "=1", "factor="})
    expect_text(refuse(vary(cohesion, target)), "write NAME=VALUE");
  expect_text(refuse(vary(cohesion, "lem.spencr=1")), "the case yields no result 'lem.spencr'");
  expect_text(refuse(vary(cohesion, "factor=one")), "one");
  expect_text(refuse(vary(cohesion, "factor=nan")), "nan");
  expect_text(refuse(vary(cohesion, "factor=1", "20", "10")), "--from is 20 and --to is 10; --from is the smaller one");
  expect_text(refuse(vary(cohesion, "factor=1", "20")), "--from and --to belong together");
  expect_text(refuse(vary(cohesion, "factor=1", "-5", "10")), "outside of the range of 'materials.clay.cohesion'");
  expect_text(refuse(vary(cohesion, "factor=1", "5 m", "10")), "'5 m' is a length; --from needs a stress");
  expect_text(refuse(vary("lem.tension_crack.depth", "factor=1")), "gives no scale");
  BackAnalysisRequest request = vary(cohesion, "factor=1");
  for (const double tolerance : {0.0, -1.0, 1.0, std::nan("")}) {
    request.tolerance = tolerance;
    expect_text(refuse(request), "--tolerance");
  }
}

TEST_F(BackAnalysisRuns, AResumedSearchHasTheSameResult) {
  const BackAnalysisRequest request = vary("materials.clay.cohesion", "factor=1");
  const BackAnalysisOutcome whole = search(wedge, request);
  ASSERT_GE(whole.finding.runs.size(), 3U);
  {
    Progress progress(Progress::Listener([](const ProgressReport& report) {
      if (report.line.starts_with("[3:")) request_interrupt();
    }));
    const BackAnalysisOutcome part = search(wedge, request, {}, false, &progress);
    request_interrupt(false);
    ASSERT_TRUE(part.failure);
    EXPECT_EQ(part.failure->code(), ExitCode::interrupted);
    EXPECT_EQ(part.finding.end, BackAnalysisEnd::interrupted);
    EXPECT_LT(part.finding.runs.size(), whole.finding.runs.size());
  }
  const std::string first = support::read_text(folder_ / "cohesion_20" / "summary.json");
  const BackAnalysisOutcome resumed = search(wedge, request, {}, true);
  EXPECT_EQ(support::read_text(folder_ / "cohesion_20" / "summary.json"), first) << "the finished run is kept";
  EXPECT_EQ(resumed.finding.value, whole.finding.value);
  EXPECT_EQ(resumed.finding.sentences, whole.finding.sentences);
  ASSERT_EQ(resumed.finding.runs.size(), whole.finding.runs.size());
  for (std::size_t i = 0; i < whole.finding.runs.size(); ++i) {
    EXPECT_EQ(resumed.finding.runs[i].value, whole.finding.runs[i].value);
    EXPECT_EQ(resumed.finding.runs[i].result, whole.finding.runs[i].result);
  }
  EXPECT_FALSE(resumed.failure);
  // Results of another case are not taken for those of this one.
  try {
    search(wedge, request, {"materials.clay.unit_weight=19"}, true);
    FAIL() << "results of another input were resumed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    expect_text(error.what(), "belong to another input");
  }
}

}  // namespace
}  // namespace talus::study
