// SPDX-License-Identifier: MIT
// Rejected [[roots]] and rooted soils, and the messages.

#include "rooted_slope.hpp"

namespace talus::input {
namespace {

const std::string bundle = R"([roots.bundle]
model = "wu_waldron"
diameters = [1, 2]
area_ratios = [1e-4, 2e-4]
strengths = [30, 20]
)";

/// The slope whose [[roots]] give only `keys` of their content or cohesion.
std::string without_content(const std::string& keys = "") {
  return change(change(rooted_slope, "content = 0.94\n", keys), "root_strength = 0.18",
                "root_strength = 0.18\nroot_content = 0.5");
}

TEST(Roots, GrowUnderANamedLine) {
  expect_root_fault("ground = \"face\"", "ground = @@\"fase\"",
                    "there is no side or line 'fase'; did you mean 'face'?");
  expect_fault(change(change(rooted_slope, "ground = \"face\"\n", ""), "[[roots]]", "@@[[roots]]"),
               "missing key 'ground' in [[roots]]");
  expect_root_fault("depth = 0.5", "depth = @@0", "'depth' is 0 m; it must be above 0 m");
}

TEST(Roots, ReportTheirCohesionOnce) {
  expect_fault(change(without_content(), "[[roots]]", "@@[[roots]]"), "[[roots]] does not say what roots there are");
  expect_fault(
      change(change(with_cohesion("cohesion = 5\n" + bundle), "[[roots]]", "@@[[roots]]"), "[initial]", "[initial]"),
      "more than one of 'content', 'cohesion' and [roots.bundle]");
}

TEST(Roots, NeedASoilThatTakesThem) {
  expect_fault(change(without_content(), "depth = 0.5\n", "depth = 0.5\ncohesion = @@5\n"),
               "'cohesion' of [[roots]] needs a material with model = \"rooted_mohr_coulomb\"");
  expect_fault(without_content("@@" + bundle), "'bundle' of [[roots]] needs a material with model = \"rooted_mohr_");
  expect_fault(
      change(with_cohesion("content = @@1\n"), "tensile_strength = 0\n", "tensile_strength = 0\nroot_cohesion = 0\n"),
      "'content' of [[roots]] needs a material with model = \"rooted_cam_clay\"");
}

TEST(RootedSoil, NeedsItsRoots) {
  const auto marked = [](const std::string& text) { return change(text, "[materials.loess]", "@@[materials.loess]"); };
  const std::string nothing = "[[roots]]\nground = \"face\"\ndepth = 0.5\n";
  expect_fault(marked(change(rooted_slope, nothing + "content = 0.94\n", "")),
               "material 'loess' is rooted, but nothing says by how much: give 'root_content' (0 for none)");
  expect_fault(marked(change(with_cohesion(""), nothing, "")),
               "nothing says by how much: give 'root_cohesion' (0 for none), or a [[roots]] with 'cohesion'");
  EXPECT_TRUE(find_faults(without_content("[roots.transpiration]\nrate = 1\n")).empty());
}

TEST(RootContent, IsAFractionOfTheSoil) {
  expect_root_fault("content = 0.94", "content = @@-1", "'content' is -1 %; it must be at least 0 % and below 100 %");
  expect_root_fault("content = 0.94", "content = @@\"100 %\"", "below 100 %");
  expect_root_fault("content = 0.94", "content = @@\"0.94\"", "'0.94' is a text without a unit");
  expect_root_fault("content = 0.94", "content = @@[1]",
                    "'content' must be a number of per cent, or a text such as \"0.88 %\"");
  expect_root_fault("content = 0.94", "content = @@\"1 kg\"", "'1 kg' is a mass");
}

TEST(RootProfile, ComesWithWhatItNeeds) {
  const auto profile = [](const std::string& word) { return "profile = \"" + word + "\"\n"; };
  expect_fault(change(with_roots(profile("exponential")), "[[roots]]", "@@[[roots]]"),
               "missing key 'decay_depth' in [[roots]]");
  expect_fault(change(with_roots(profile("table")), "[[roots]]", "@@[[roots]]"),
               "missing key 'depth_table' in [[roots]]");
  expect_fault(with_roots("decay_depth = @@0.2\n"), "has a meaning only with profile = \"exponential\"");
  expect_fault(with_roots(profile("table") + "depth_table = [[0, 1], @@[0, 0.5]]\n"),
               "the first numbers of 'depth_table' must increase from row to row");
  expect_fault(with_roots(profile("table") + "depth_table = [[0, 1], [1, @@-0.5]]\n"), "it must be at least 0");
  expect_fault(with_roots(profile("table") + "depth_table = [[0, 1], @@[1]]\n"), "not a list of 1");
  expect_fault(with_roots("along = [[5, 1], @@[3, 0.5]]\n"), "the first numbers of 'along' must increase");
}

TEST(RootBundle, HasOneNumberForEachClass) {
  const auto with = [](const std::string& old_part, const std::string& new_part) {
    return with_cohesion(change(bundle, old_part, new_part));
  };
  expect_fault(with("[30, 20]", "@@[30]"), "'strengths' has 1 numbers and 'area_ratios' has 2");
  expect_fault(with("[1, 2]", "@@[1, 2, 3]"), "'diameters' has 3 numbers and 'area_ratios' has 2");
  expect_fault(change(with("diameters = [1, 2]\n", ""), "[roots.bundle]\nmodel = \"wu_waldron\"",
                      "@@[roots.bundle]\nmodel = \"fibre_bundle\""),
               "'diameters' has 0 numbers and 'area_ratios' has 2");
  expect_fault(with("[1e-4, 2e-4]", "[1e-4, @@1]"), "above 0 and below 1");
  expect_fault(change(with("strengths = [30, 20]\n", ""), "[roots.bundle]", "@@[roots.bundle]"),
               "missing key 'strengths' in [roots.bundle]");
  expect_fault(with("diameters", "@@diametres"),
               "unknown key 'diametres' in [roots.bundle]; did you mean 'diameters'?");
}

TEST(Age, ComesWithItsTable) {
  expect_fault(with_roots("age = @@3\n"), "'age' needs 'growth', the share of the roots at different times");
  expect_fault(with_roots("decay = @@[[0, 1], [5, 0]]\n"), "'decay' has no meaning without 'felled'");
  expect_fault(with_roots("age = 3\ngrowth = [[0, 0], @@[0, 1]]\n"), "the first numbers of 'growth' must increase");
  expect_fault(with_roots("age = @@\"3 m\"\ngrowth = [[0, 0], [10, 1]]\n"), "'3 m' is a length");
}

TEST(Transpiration, DrinksPoreWater) {
  const std::string plants = with_roots("[roots.transpiration]\nrate = 4\n");
  const auto from = plants.find("[materials.loess.water]"), to = plants.find("[regions]");
  std::string dry = plants.substr(0, from) + plants.substr(to);
  dry = change(dry, "pore_pressure = \"water_table\"\nwater_table = [[0, 1]]\n", "");
  expect_fault(change(dry, "[roots.transpiration]", "@@[roots.transpiration]"),
               "[roots.transpiration] has no meaning: no material has pore water");
  expect_fault(with_roots("[roots.transpiration]\nrate = 4\nsuctions = [1, 2, @@2, 1500]\n"),
               "the four numbers of 'suctions' must increase");
  expect_fault(with_roots("[roots.transpiration]\nrate = 4\nsuctions = @@[1, 2]\n"),
               "a list of four increasing numbers");
  expect_fault(with_roots("[roots.transpiration]\nseries = \"steps\"\nrate = @@[[0, 1], [0, 2]]\n"),
               "the times of 'rate' must increase from row to row where series = \"steps\"");
}

TEST(Equilibrium, IsAStageWithSomethingToDo) {
  expect_root_fault("equilibrium = \"gravity\"", "equilibrium = @@\"gravty\"", "there is no stage 'gravty'");
  expect_fault(change(change(rooted_slope, "preconsolidation_ratio = 3", "preconsolidation = 50"),
                      "equilibrium = \"gravity\"", "equilibrium = @@\"gravity\""),
               "'equilibrium' has no meaning: no material has a 'preconsolidation_ratio'");
}

TEST(Season, StartsFromAKnownPressure) {
  expect_fault(change(rooted_slope, "pore_pressure = \"water_table\"\nwater_table = [[0, 1]]\n", "season = @@30\n"),
               "has a meaning only with pore_pressure = \"water_table\" or \"seepage\"");
}

}  // namespace
}  // namespace talus::input
