// SPDX-License-Identifier: MIT
// Manual, template, schema and echo agree with the declarations that the reader uses.

#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "slope.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

/// Calls `visit` with each key that a schema describes: its dotted path and its own schema.
void walk_schema(const json& schema, const std::string& path,
                 const std::function<void(const std::string&, const json&)>& visit) {
  if (schema.contains("items") && schema["items"].contains("properties"))
    return walk_schema(schema["items"], path, visit);
  if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object())
    return walk_schema(schema["additionalProperties"], path + ".NAME", visit);
  if (!schema.contains("properties")) return visit(path, schema);
  for (const auto& [key, inner] : schema["properties"].items())
    walk_schema(inner, path.empty() ? key : path + "." + key, visit);
}

/// The values of an echo without the marks of what was given.
json drop_marks(json echo) {
  if (echo.is_object()) {
    if (echo.contains("given")) echo.erase("given");
    for (auto& item : echo) item = drop_marks(item);
  } else if (echo.is_array()) {
    for (auto& item : echo) item = drop_marks(item);
  }
  return echo;
}

TEST(Template, IsACaseWithoutFaults) {
  const LoadedCase loaded = read_case_text(write_template(), "template.toml");
  EXPECT_EQ(loaded.data.boundaries.size(), 3u);
  EXPECT_EQ(loaded.data.materials.count("sand"), 1u);
  EXPECT_GT(loaded.data.materials.at("sand").cohesion, 0);
}

TEST(Template, ShowsTheDefaultsThatTheReaderTakes) {
  const std::string text = write_template();
  // "#key = value" is a default: without its "#" the case must stay the same.
  const std::string given = std::regex_replace(text, std::regex("(^|\n)#([a-z])"), "$1$2");
  ASSERT_NE(given, text);
  const LoadedCase before = read_case_text(text, "template.toml");
  const LoadedCase after = read_case_text(given, "template.toml");
  EXPECT_EQ(drop_marks(after.echo.get()), drop_marks(before.echo.get()));
  EXPECT_TRUE(after.echo.get()["gravity"]["acceleration"]["given"].get<bool>());
  EXPECT_FALSE(before.echo.get()["gravity"]["acceleration"]["given"].get<bool>());
}

TEST(Template, NamesEveryKeyOfTheSchema) {
  const std::string text = write_template();
  walk_schema(write_schema(), "", [&](const std::string& path, const json&) {
    const std::string key = path.substr(path.rfind('.') + 1);
    if (key == "NAME") return;
    EXPECT_NE(text.find(key + " = "), std::string::npos) << path;
  });
}

TEST(Manual, NamesEveryKeyOfTheSchema) {
  const std::string text = write_manual();
  int keys = 0;
  walk_schema(write_schema(), "", [&](const std::string& path, const json& schema) {
    const std::string key = path.substr(path.rfind('.') + 1);
    EXPECT_NE(text.find("| `" + key + "` |"), std::string::npos) << path;
    EXPECT_FALSE(schema["description"].get<std::string>().empty()) << path;
    ++keys;
  });
  EXPECT_GT(keys, 90);
}

TEST(Manual, GivesExamplesThatAreToml) {
  // Every block of the manual shows one line for each of its keys.
  const std::string text = write_manual();
  int blocks = 0;
  for (auto at = text.find("```toml\n"); at != std::string::npos; at = text.find("```toml\n", at + 8)) {
    const std::string block = text.substr(at + 8, text.find("```\n", at + 8) - at - 8);
    // Read as a case it is incomplete, but no line of it may be bad TOML, unknown, or of a wrong type or range.
    for (const Diagnostic& fault : find_faults(block)) {
      for (const char* bad :
           {"not TOML", "unknown key", "no choice", " must be ", " needs a length", " needs a stress"}) {
        EXPECT_EQ(fault.sentence.find(bad), std::string::npos) << fault.sentence << "\nin\n" << block;
      }
    }
    ++blocks;
  }
  EXPECT_GT(blocks, 15);
}

TEST(Schema, HasTypesRangesAndWords) {
  const json schema = write_schema();
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  const json material = schema["properties"]["materials"]["additionalProperties"];
  const json& poisson = material["properties"]["poisson_ratio"];
  EXPECT_EQ(poisson["exclusiveMaximum"], 0.5);
  EXPECT_EQ(poisson["exclusiveMinimum"], -1);
  EXPECT_FALSE(material["additionalProperties"].get<bool>());
  const json& fix = schema["properties"]["boundary"]["items"]["properties"]["fix"]["enum"];
  EXPECT_EQ(fix, json::array({"full", "normal", "plane", "friction", "velocity"}));
  EXPECT_EQ(schema["properties"]["gravity"]["properties"]["acceleration"]["default"], 9.81);
  // Every Mohr–Coulomb model needs a cohesion; the schema has no rule for the others.
  json models = json::array();
  for (const json& rule : material["allOf"]) {
    if (rule["then"]["required"] != json::array({"cohesion"})) continue;
    for (const json& one : rule["if"]["anyOf"]) models.push_back(one["properties"]["model"]["const"]);
  }
  EXPECT_EQ(models, json::array({"mohr_coulomb", "rooted_mohr_coulomb", "softening_mohr_coulomb", "drucker_prager",
                                 "bedding"}));
  for (const json& rule : material["allOf"])
    EXPECT_NE(rule["then"]["required"], json::array({"young_modulus"}))
        << "only with some methods, which it cannot see";
  EXPECT_EQ(schema["else"]["required"], json::array({"stage"})) << "where \"mpm\" is among the methods";
  const json& methods = schema["properties"]["lem"]["properties"]["methods"];
  EXPECT_EQ(methods["items"]["enum"].at(4), "spencer");
  const json& bundle = schema["properties"]["roots"]["items"]["properties"]["bundle"];
  EXPECT_EQ(bundle["required"], json::array({"model", "area_ratios", "strengths"})) << "where there is a bundle at all";
}

TEST(Schema, AcceptsTheQuantitiesThatTheReaderAccepts) {
  const json schema = write_schema();
  const std::string pattern =
      schema["properties"]["mesh"]["properties"]["size"]["anyOf"].at(1)["pattern"].get<std::string>();
  const std::regex quantity(pattern, std::regex::ECMAScript);
  for (const char* text : {"2 m", "50cm", "1e-1 m", "+.5 m", " 3. km"}) {
    EXPECT_TRUE(std::regex_match(text, quantity)) << text;
    EXPECT_NO_THROW(read_case_text(slope, "slope.toml", {{"mesh.size", '"' + std::string(text) + '"'}})) << text;
  }
  for (const char* text : {"2", "m", "", "two m", "2 3 m"}) {
    EXPECT_FALSE(std::regex_match(text, quantity)) << text;
    EXPECT_THROW(read_case_text(slope, "slope.toml", {{"mesh.size", '"' + std::string(text) + '"'}}), InputError)
        << text;
  }
}

TEST(Echo, HasValueUnitAndWhetherItWasGiven) {
  const json echo = read_case_text(slope, "slope.toml", {{"rest.hold", "2"}}).echo.get();
  const json& sand = echo["materials"]["sand"];
  EXPECT_EQ(sand["young_modulus"], (json{{"value", 45000.0}, {"unit", "kPa"}, {"given", true}}));
  EXPECT_EQ(sand["friction_angle"], (json{{"value", 30.0}, {"unit", "deg"}, {"given", true}}));
  EXPECT_EQ(echo["gravity"]["acceleration"], (json{{"value", 9.81}, {"unit", "m/s2"}, {"given", false}}));
  EXPECT_EQ(echo["stage"][0]["damping"], (json{{"value", 0.7}, {"given", true}}));
  EXPECT_EQ(echo["stage"][1]["damping"], (json{{"value", 0.0}, {"given", false}}));
  EXPECT_EQ(echo["rest"]["hold"]["given"], true) << "--set gives a value as well";
  EXPECT_EQ(echo["boundary"][1]["fix"]["value"], "normal");
  EXPECT_FALSE(echo["boundary"][0].contains("normal")) << "a full fixity has no normal";
}

}  // namespace
}  // namespace talus::input
