// SPDX-License-Identifier: MIT
// `--set`: values of a case file replaced, added or removed on the command line, and the messages on faults.

#include "slope.hpp"

namespace talus::input {
namespace {

Case read_with(const std::vector<Override>& overrides) {
  return read_case_text(slope, "slope.toml", overrides).data;
}

TEST(Override, ReplacesAValueOfTheFile) {
  EXPECT_DOUBLE_EQ(read_with({{"materials.sand.cohesion", "5"}}).materials.at("sand").cohesion, 5000);
  EXPECT_DOUBLE_EQ(read_with({{"materials.sand.cohesion", "\"5 Pa\""}}).materials.at("sand").cohesion, 5);
  EXPECT_DOUBLE_EQ(read_with({{"mesh.size", "0.5"}, {"mesh.size", "0.25"}}).mesh.size, 0.25) << "the last one counts";
}

TEST(Override, TakesBareWordsAsTexts) {
  EXPECT_EQ(read_with({{"analysis.kind", "strength_reduction"}}).analysis, AnalysisKind::strength_reduction);
  EXPECT_DOUBLE_EQ(read_with({{"mesh.size", "50 cm"}}).mesh.size, 0.5);
  EXPECT_EQ(read_with({{"title", "two words"}}).title, "two words");
}

TEST(Override, FindsEntriesOfListsByNameSideOrNumber) {
  EXPECT_DOUBLE_EQ(read_with({{"stage.failure.duration", "7"}}).stages.at(1).duration, 7);
  EXPECT_DOUBLE_EQ(read_with({{"stage.1.duration", "8"}}).stages.at(1).duration, 8);
  EXPECT_EQ(read_with({{"boundary.left.fix", "full"}}).boundaries.at(1).fix, Fix::full);
}

TEST(Override, MakesTablesThatTheFileLacks) {
  EXPECT_DOUBLE_EQ(read_with({{"strength_reduction.curve.to", "3"}}).strength_reduction.curve.to, 3);
}

TEST(Override, OfARegionMayLeaveAMaterialOver) {
  const std::string two = change(slope, "[regions]\n",
                                 "[materials.rock]\nmodel = \"linear_elastic\"\ngrain_density = 2700\nporosity = 0\n"
                                 "young_modulus = 1e6\npoisson_ratio = 0.2\n\n[regions]\n");
  EXPECT_EQ(read_case_text(two, "slope.toml").warnings.size(), 1u) << "in the file it is a slip";
  EXPECT_TRUE(read_case_text(two, "slope.toml", {{"regions.soil", "rock"}}).warnings.empty())
      << "here it compares two soils";
}

TEST(Override, IsNamedInItsErrors) {
  const std::vector<std::pair<Override, std::string>> faults{
      {{"materials.sand.cohesion", "2 kg"}, "'2 kg' is a mass"},
      {{"materials.sand.cohesion", "-3"}, "'cohesion' is -3 kPa; it must be at least 0 kPa"},
      {{"materials.sand.cohesoin", "3"}, "did you mean 'cohesion'?"},
      {{"materials.sand.tensile_strength", "30"}, "apex"},
      {{"boundary.left.on", "lft"}, "did you mean 'left'?"},
      {{"stage.3.duration", "3"}, "'stage' has no entry '3'"},
      {{"stage.settling.duration", "3"}, "'stage' has no entry 'settling'"},
      {{"mesh.size.fine", "3"}, "'mesh.size' is a value and has no key 'fine'"},
      {{"mesh..size", "3"}, "empty part"},
      {{"rst.hold", "3"}, "unknown key 'rst'"},
      {{"titel", "3"}, "did you mean 'title'?"},
  };
  for (const auto& [change_of, part] : faults) {
    const auto found = find_faults(slope, {change_of});
    ASSERT_EQ(found.size(), 1u) << change_of.key;
    const std::string line = to_string(found[0]);
    EXPECT_NE(line.find(part), std::string::npos) << line;
    EXPECT_EQ(line.rfind("--set " + change_of.key + ": error: ", 0), 0u) << line;
  }
}

TEST(Override, CannotSmuggleInASecondKey) {
  EXPECT_EQ(read_with({{"title", "\"a\"\ncohesion = 3"}}).title, "\"a\"\ncohesion = 3");
}

TEST(Override, IsWrittenAsKeyAndValue) {
  const Override parsed = parse_override(" materials.sand.cohesion = a=b ");
  EXPECT_EQ(parsed.key, "materials.sand.cohesion");
  EXPECT_EQ(parsed.value, "a=b");
  EXPECT_THROW(parse_override("cohesion"), Error);
  EXPECT_THROW(parse_override("=3"), Error);
}

TEST(Override, WithoutValueRemovesWhatTheFileGives) {
  const std::string crack = slope + "[lem.tension_crack]\ndepth = 2\n";
  EXPECT_DOUBLE_EQ(read_case_text(crack, "").data.lem.crack.depth, 2);
  for (const char* key : {"lem.tension_crack.depth", "lem.tension_crack", "lem"})
    EXPECT_DOUBLE_EQ(read_case_text(crack, "", {{key, ""}}).data.lem.crack.depth, 0) << key;
  EXPECT_EQ(read_with({{"stage.failure", ""}}).stages.size(), 1u);
  const auto missing = find_faults(slope, {{"materials.sand.cohesion", ""}});
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_NE(missing[0].sentence.find("missing key 'cohesion'"), std::string::npos) << missing[0].sentence;
  const auto unknown = find_faults(slope, {{"materials.snad", ""}});
  ASSERT_EQ(unknown.size(), 1u);
  EXPECT_EQ(to_string(unknown[0]),
            "--set materials.snad: error: the file has no 'materials.snad' to remove; did you mean 'sand'?");
}

TEST(Override, ReplacesAWholeTable) {
  const Case data =
      read_with({{"materials.sand",
                  "{ model = \"linear_elastic\", grain_density = 2700, porosity = 0.1, young_modulus = 1e6, "
                  "poisson_ratio = 0.2 }"}});
  EXPECT_DOUBLE_EQ(data.materials.at("sand").grain_density, 2700);
  EXPECT_EQ(data.materials.at("sand").traits().word, std::string("linear_elastic"));
  const auto faults = find_faults(slope, {{"materials.sand", "{ model = \"linear_elastic\" }"}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].file, "--set materials.sand");
  EXPECT_TRUE(faults[0].sentence.starts_with(
      "missing keys 'grain_density', 'porosity', 'young_modulus' and 'poisson_ratio' in [materials.sand]"))
      << faults[0].sentence;
}

}  // namespace
}  // namespace talus::input
