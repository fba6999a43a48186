// SPDX-License-Identifier: MIT
// The engine of the studio: spans of keys, messages at their keys, and the numbers of a run.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "input/read.hpp"
#include "results/governing.hpp"
#include "run/lem/run_lem.hpp"
#include "studio/engine.hpp"
#include "studio/spans.hpp"

namespace talus {
namespace {

using nlohmann::json;

const std::string slope = R"(title = "Slöpe"   # a comment
unusual = []

[[geometry.polygon]]
name = "soil"
points = [[0, 0], [44, 0], # é
          [44, 5], [32, 5], ["1200 cm", 15], [0, 15]]

[materials.clay]
model = "mohr_coulomb"
unit_weight = 20
cohesion = "10 kPa"
friction_angle = 20

[regions]
soil = "clay"

[analysis]
methods = ["lem"]

[lem]
methods = ["bishop", "spencer"]
noncircular = false
)";

std::string replace(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string cut(const std::string& text, const studio::Span& span) {
  return text.substr(span[0], span[1] - span[0]);
}

std::string read_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Compares each value with what the bytes of its span give when they are read alone.
void check_spans(const toml::node& node, const std::string& path, const std::string& text,
                 const studio::TextSpans& spans, std::size_t& compared) {
  if (const toml::table* table = node.as_table())
    for (const auto& [key, value] : *table)
      check_spans(value, path.empty() ? std::string(key.str()) : path + "." + std::string(key.str()), text, spans,
                  compared);
  const toml::array* list = node.as_array();
  if (list != nullptr)
    for (std::size_t i = 0; i < list->size(); ++i)
      check_spans(*list->get(i), path + "." + std::to_string(i), text, spans, compared);
  const bool has_header = list != nullptr && list->is_array_of_tables();
  if (node.is_table() || has_header) return;
  ASSERT_TRUE(spans.values.contains(path)) << path;
  const std::string value = cut(text, spans.values.at(path));
  toml::table expected;
  node.visit([&](const auto& same) { expected.insert("v", same); });
  EXPECT_TRUE(toml::parse("v = " + value) == expected) << path << ": '" << value << "'";
  ++compared;
}

TEST(StudioSpans, TheBytesOfEverySpanAreItsValueInAllExamples) {
  std::size_t files = 0, compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TALUS_SOURCE_DIR "/examples")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string text = read_file(entry.path());
    check_spans(toml::parse(text), "", text, studio::find_spans(text), compared);
    ++files;
  }
  EXPECT_GT(files, 30u);
  EXPECT_GT(compared, 1000u);
}

TEST(StudioSpans, CountBytesBehindCharactersOfSeveralBytesAndMarks) {
  for (const std::string& text : {slope, "\xef\xbb\xbf" + slope}) {
    const studio::TextSpans spans = studio::find_spans(text);
    EXPECT_EQ(cut(text, spans.values.at("title")), "\"Slöpe\"");
    EXPECT_EQ(cut(text, spans.values.at("geometry.polygon.0.points.4")), "[\"1200 cm\", 15]");
    EXPECT_EQ(cut(text, spans.values.at("geometry.polygon.0.points.3.0")), "32");
    EXPECT_EQ(cut(text, spans.values.at("unusual")), "[]");
    EXPECT_EQ(cut(text, spans.keys.at("materials.clay.cohesion")), "cohesion");
  }
}

TEST(StudioSpans, ATableWithAHeaderEndsBehindItsLastValue) {
  const studio::TextSpans spans = studio::find_spans(slope);
  const std::string clay = cut(slope, spans.values.at("materials.clay"));
  EXPECT_TRUE(clay.starts_with("[materials.clay]")) << clay;
  EXPECT_TRUE(clay.ends_with("friction_angle = 20")) << clay;
  EXPECT_TRUE(studio::find_spans("a = [").values.empty());
}

TEST(StudioCheck, ASlopeWithoutFaultsIsReadyAndHasItsSectionInMetres) {
  const json answer = json::parse(studio::check(slope));
  EXPECT_EQ(answer["messages"], json::array());
  EXPECT_EQ(answer["ready"], true);
  const json& region = answer["section"]["regions"][0];
  EXPECT_EQ(region["soil"], "clay");
  EXPECT_EQ(region["path"], "geometry.polygon.0.points");
  EXPECT_EQ(region["polygon"][4], json({12.0, 15.0}));
  EXPECT_EQ(answer["section"]["ground"].size(), 4u);
}

TEST(StudioCheck, EveryMessageStandsAtItsKey) {
  struct Mistake {
    std::string from, to, key, span;
  };
  for (const Mistake& m : {Mistake{"\"10 kPa\"", "\"10 kg\"", "materials.clay.cohesion", "\"10 kg\""},
                           Mistake{"friction_angle", "fiction_angle", "materials.clay.fiction_angle", "fiction_angle"},
                           Mistake{"[32, 5]", "[32]", "geometry.polygon.0.points.3", "[32]"},
                           Mistake{"\"clay\"", "\"caly\"", "regions.soil", "\"caly\""}}) {
    const std::string text = replace(slope, m.from, m.to);
    const json answer = json::parse(studio::check(text));
    EXPECT_EQ(answer["ready"], false);
    bool is_found = false;
    for (const json& message : answer["messages"])
      if (message["key"] == m.key && message["severity"] == "error" && message["span"].is_array())
        is_found |= cut(text, message["span"].get<studio::Span>()) == m.span;
    EXPECT_TRUE(is_found) << m.key << ": " << answer["messages"].dump(1);
  }
}

TEST(StudioCheck, TextThatIsNoTomlHasItsFaultAtItsPlaceAndNoSection) {
  const std::string text = replace(slope, "cohesion = \"10 kPa\"", "cohesion = 10 kPa");
  const json answer = json::parse(studio::check(text));
  ASSERT_EQ(answer["messages"].size(), 1u);
  EXPECT_EQ(answer["messages"][0]["line"], 12);
  EXPECT_TRUE(answer["messages"][0]["span"].is_array());
  EXPECT_TRUE(answer["section"].is_null());
  EXPECT_EQ(answer["spans"], json::object());
}

TEST(StudioCheck, AFaultySectionIsShownAsFarAsItIsRead) {
  const json answer = json::parse(studio::check(replace(slope, "cohesion = \"10 kPa\"\n", "")));
  EXPECT_EQ(answer["ready"], false);
  EXPECT_EQ(answer["section"]["regions"].size(), 1u);
}

TEST(StudioCheck, BoundariesOfLayersAreThoseOfTheText) {
  const std::string layers = replace(
      slope, slope.substr(slope.find("[[geometry"), slope.find("[materials") - slope.find("[[geometry")),
      "[geometry]\nground = [[0, 15], [12, 15], [32, 5], [44, 5]]\n[[geometry.layer]]\nname = \"soil\"\nlevel = 0\n");
  const json answer = json::parse(studio::check(layers));
  EXPECT_EQ(answer["messages"], json::array());
  const json& lines = answer["section"]["boundaries"];
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0]["path"], "geometry.ground");
  EXPECT_EQ(lines[0]["points"].size(), 4u);
  EXPECT_EQ(lines[1]["kind"], "level");
  EXPECT_TRUE(answer["section"]["regions"][0]["path"].is_null());
}

TEST(StudioSolve, HasTheNumbersOfARun) {
  const input::LoadedCase loaded = input::read_case_text(slope, "slope.toml");
  const run::SliceOutcome outcome = run::run_lem(loaded.data, run::prepare_slope(loaded.data), 2);
  const auto governing = results::find_governing_surface(outcome.result, nullptr);
  ASSERT_TRUE(governing);
  const json answer = json::parse(studio::solve(slope));
  EXPECT_EQ(answer["factor"].get<double>(), governing->found->surface.factor);
  EXPECT_EQ(answer["method"], "spencer");
  EXPECT_EQ(answer["surface"].get<std::vector<lem::Point>>(), governing->found->surface.points);
  EXPECT_EQ(answer["searched"], outcome.result.search->tried);
  EXPECT_EQ(answer["surfaces"].size(), 2u);
}

TEST(StudioSolve, AQuickSearchTriesAboutTheCirclesAskedForAndIsNearTheWholeSearch) {
  const json whole = json::parse(studio::solve(slope, R"({"methods": ["bishop"]})")),
             quick = json::parse(studio::solve(slope, R"({"methods": ["bishop"], "circles": 1000})"));
  EXPECT_LE(quick["searched"], 1000);
  EXPECT_GE(quick["searched"], 700);
  EXPECT_NEAR(quick["factor"].get<double>(), whole["factor"].get<double>(), 0.01 * whole["factor"].get<double>());
  EXPECT_EQ(quick["method"], "bishop");
  EXPECT_FALSE(quick["circle"].is_null());
}

TEST(StudioSolve, DoesNotDependOnThreads) {
  const auto solve = [](int threads) {
    return studio::solve(slope, json{{"circles", 1000}, {"threads", threads}}.dump());
  };
  EXPECT_EQ(solve(1), solve(3));
}

TEST(StudioSolve, ErrorsAreAnswers) {
  for (const auto& [text, options] : {std::pair<std::string, std::string>{"a = [", "{}"},
                                      {slope, "[]"},
                                      {slope, "{"},
                                      {slope, R"({"circles": 0})"},
                                      {slope, R"({"circles": 1.5})"},
                                      {slope, R"({"circles": 1e300})"},
                                      {slope, R"({"methods": []})"},
                                      {slope, R"({"methods": ["bishp"]})"},
                                      {slope, R"({"speed": 1})"},
                                      {slope, "{\"methods\": [\"\xff\"]}"},
                                      {std::string(11'000'000, ' '), "{}"}}) {
    const json answer = json::parse(studio::solve(text, options));
    EXPECT_TRUE(answer["error"].is_string()) << options;
  }
}

TEST(StudioSolve, ACaseOfAnotherMethodIsSearchedWithTheDefaults) {
  const std::string text =
      replace(replace(slope, slope.substr(slope.find("[analysis]")), "[analysis]\nmethods = [\"bounds\"]\n"),
              "friction_angle = 20\n", "friction_angle = 20\ndilatancy_angle = 20\ntensile_strength = 0\n");
  const json answer = json::parse(studio::solve(text, R"({"circles": 1000})"));
  EXPECT_TRUE(answer["factor"].is_number()) << answer.dump(1);
  EXPECT_EQ(answer["messages"][0]["severity"], "note");
}

TEST(StudioSolve, ThreeDimensionsAreRefusedWhateverTheMethods) {
  const std::string text = read_file(TALUS_SOURCE_DIR "/examples/slope_3d/case.toml");
  const json answer = json::parse(studio::solve(text, R"({"circles": 1000})"));
  EXPECT_NE(answer["error"].get<std::string>().find("LEM analyses a plane section"), std::string::npos) << answer;
}

}  // namespace
}  // namespace talus
