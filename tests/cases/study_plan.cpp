// SPDX-License-Identifier: MIT
// The variants of a study, and the rejection of studies that cannot be computed.

#include "study_slope.hpp"

namespace talus::study {
namespace {

std::vector<std::string> list_names(const StudyPlan& plan) {
  std::vector<std::string> names;
  for (const Variant& v : plan.variants) names.push_back(v.name);
  return names;
}

/// Messages of all faults.
std::vector<std::string> find_faults(const std::string& text) {
  try {
    plan_text(text);
  } catch (const InputError& error) {
    std::vector<std::string> sentences;
    for (const Diagnostic& d : error.diagnostics()) sentences.push_back(to_string(d));
    return sentences;
  }
  return {};
}

TEST(StudyPlan, ChangesOneKeyAtATimeOnTopOfTheBaseCase) {
  const StudyPlan plan = plan_text(cohesion_study + R"(
[[study.vary]]
key = "mesh.size"
values = [2.5]
)");
  EXPECT_EQ(list_names(plan), (std::vector<std::string>{"base", "cohesion_4_kPa", "cohesion_8", "size_2.5"}));
  EXPECT_EQ(plan.summary.vary[0].unit, "kPa");
  EXPECT_EQ(plan.summary.vary[1].unit, "m");
  const std::vector<std::vector<std::string>> values{{"2", "3"}, {"4", "3"}, {"8", "3"}, {"2", "2.5"}};
  const double cohesions[] = {2000, 4000, 8000, 2000}, sizes[] = {3, 3, 3, 2.5};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(plan.variants[i].values, values[i]);
    EXPECT_DOUBLE_EQ(plan.variants[i].loaded.data.materials.at("sand").cohesion, cohesions[i]);
    EXPECT_DOUBLE_EQ(plan.variants[i].loaded.data.mesh.size, sizes[i]);
  }
}

TEST(StudyPlan, CombinesEveryValueInAGridAndCalculatesTheBaseCaseOnce) {
  const StudyPlan plan = plan_text(coarse_slope + R"(
[study]
mode = "grid"

[[study.vary]]
key = "materials.sand.cohesion"
values = [2, 4, 8]

[[study.vary]]
key = "mesh.size"
values = [3, 2.5]
)");
  EXPECT_EQ(list_names(plan),
            (std::vector<std::string>{"base", "cohesion_2__size_2.5", "cohesion_4__size_3", "cohesion_4__size_2.5",
                                      "cohesion_8__size_3", "cohesion_8__size_2.5"}));
  ASSERT_EQ(plan.summary.notes.size(), 1u);
  EXPECT_EQ(plan.summary.notes[0], "cohesion = 2, size = 3 is the same case as base.");
}

TEST(StudyPlan, ChangesKeysTogetherUnderOneName) {
  const std::string study = coarse_slope + R"(
[study]
mode = "together"

[[study.vary]]
key = "materials.sand.cohesion"
values = [4, 8]
names = ["firm", "stiff"]

[[study.vary]]
key = "mesh.size"
values = )";
  const StudyPlan plan = plan_text(study + "[2.5, 2]");
  EXPECT_EQ(list_names(plan), (std::vector<std::string>{"base", "firm", "stiff"}));
  EXPECT_EQ(plan.variants[1].values, (std::vector<std::string>{"4", "2.5"}));
  EXPECT_EQ(plan.variants[2].values, (std::vector<std::string>{"8", "2"}));
  EXPECT_EQ(plan.summary.mode, "together");
  try {
    plan_text(study + "[2.5]");
    FAIL() << "one size for two cohesions";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'mesh.size' has 1 values and 'materials.sand.cohesion' has 2"),
              std::string::npos)
        << error.what();
  }
}

TEST(StudyPlan, NamesKeysByTheirDifference) {
  const StudyPlan plan = plan_text(coarse_slope + R"(
[[study.vary]]
key = "stage.gravity.damping"
values = [0.5]

[[study.vary]]
key = "strength_reduction.curve.damping"
values = [0]
)");
  EXPECT_EQ(list_names(plan), (std::vector<std::string>{"base", "gravity.damping_0.5", "curve.damping_0"}));
  EXPECT_EQ(plan.variants[0].values, (std::vector<std::string>{"0.75", "0.05"})) << "values of the base case";
}

TEST(StudyPlan, AppliesChangesOfTheCommandLineToEveryVariant) {
  for (const Variant& v : plan_text(cohesion_study, {{"materials.sand.friction_angle", "25"}}).variants)
    EXPECT_NEAR(v.loaded.data.materials.at("sand").friction_angle, 0.4363323, 1e-7) << v.name;
}

TEST(StudyPlan, RecognisesAVariantWhenTheStudyGrows) {
  // Otherwise --resume would throw away what was calculated before a value was added.
  const StudyPlan before = plan_text(cohesion_study);
  const StudyPlan after = plan_text(cohesion_study + "\n[[study.vary]]\nkey = \"mesh.size\"\nvalues = [2.5]\n");
  for (std::size_t i = 0; i < before.variants.size(); ++i) {
    EXPECT_EQ(before.variants[i].name, after.variants[i].name);
    EXPECT_EQ(before.variants[i].input_hash, after.variants[i].input_hash);
  }
}

TEST(StudyPlan, NamesOfVariantsStayInTheFolderOfTheStudy) {
  const StudyPlan plan = plan_text(coarse_slope + R"(
[[study.vary]]
key = "materials.sand.cohesion"
values = [3, 4, 5, 6, 7, 8]
names = ["..", "../../x", "report.html", "jobs", "\u001b]0;x\u0007", ")" +
                                   std::string(300, 'y') + "\"]\n");
  EXPECT_EQ(list_names(plan), (std::vector<std::string>{"base", "empty", "x", "report.html_", "jobs_",
                                                        "u001b_0_x_u0007", std::string(40, 'y')}));
}

TEST(StudyPlan, ReportsEveryFaultOfEveryVariantOnce) {
  const std::string text = coarse_slope + R"(
[study]
mode = "grid"

[[study.vary]]
key = "strength_reduction.curve.from"
values = [1.0, 1.5]

[[study.vary]]
key = "strength_reduction.curve.to"
values = [1.45, 1.8]

[[study.vary]]
key = "mesh.size"
values = [2, 2.5]
)";
  const auto faults = find_faults(text);
  const std::string before = text.substr(0, text.find("[[study.vary]]"));
  const auto line = std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0], "slope.toml:" + line +
                           ":1: error: variant 'from = 1.5, to = 1.45, size = 2': 'from' is 1.5 and 'to' is "
                           "1.45; 'from' must be smaller");
}

TEST(StudyPlan, RefusesAStudyOfNothingAndFactorsWithoutACurve) {
  auto faults = find_faults(coarse_slope);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("there is nothing to vary"), std::string::npos) << faults[0];
  faults = find_faults(coarse_slope + R"(
[study]
factors = [1.5]

[[study.vary]]
key = "analysis.kind"
values = ["run"]
)");
  EXPECT_TRUE(faults.empty()) << "the base case has a curve";
  const auto no_curve = [](const std::string& kind) {
    std::string text = cohesion_study;
    return text.replace(text.find("\"strength_reduction\""), 20, kind);
  };
  faults = find_faults(no_curve("\"run\""));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("no variant calculates one"), std::string::npos) << faults[0];
}

}  // namespace
}  // namespace talus::study
