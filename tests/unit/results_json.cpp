// SPDX-License-Identifier: MIT
// Results as JSON: written values are read back, missing ones keep their default, and wrong ones are reported with
// their place.

#include "results/json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "results/named.hpp"
#include "results/run.hpp"

namespace talus::results {
namespace {

using nlohmann::json;

/// The sentence that reading `text` as a run fails with.
std::string find_fault(const char* text) {
  try {
    from_json<RunResult>(json::parse(text), "summary.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

CriticalSurface make_surface(SliceMethod method, std::optional<double> factor) {
  CriticalSurface c;
  c.surface.method = method;
  c.surface.factor = factor;
  return c;
}

TEST(ResultsJson, WhatIsWrittenIsReadBack) {
  RunResult run;
  run.title = "A slope";
  run.status = Status::interrupted;
  run.error = "stopped";
  run.slope_height = 10;
  run.slices.emplace().critical.push_back(make_surface(SliceMethod::morgenstern_price, 1.4375));
  run.stages.emplace().push_back({"gravity", StageEnd::rest, 0, 3.25, 1234, 1e-4, 0.01, 1e-5, 1e-6, 0.5, {}, {}, {}});
  run.curve.emplace().points.push_back({1.25, StageEnd::time, 0.125, 5, 99, 0, 0, 0, {}});
  run.methods.emplace().remarks.push_back({Topic::mechanism, "One mechanism."});
  const json written = to_json(run);
  EXPECT_EQ(to_json(from_json<RunResult>(written, "summary.json")), written);
  EXPECT_EQ(written.at("status"), "interrupted");
  EXPECT_EQ(written.at("lem").at("critical").at(0).at("method"), "morgenstern_price");
  EXPECT_TRUE(written.at("lem").at("critical").at(0).at("circle").is_null()) << "a key is there, and null";
  EXPECT_FALSE(written.contains("water")) << "absent results are left out";
}

TEST(ResultsJson, MissingKeysKeepTheirDefaults) {
  const RunResult run = from_json<RunResult>(json::parse(R"({"title": "Old", "mesh": {"points": 7}})"), "summary.json");
  EXPECT_EQ(run.title, "Old");
  EXPECT_EQ(run.status, Status::unfinished);
  EXPECT_EQ(run.mesh->points, 7);
  EXPECT_EQ(run.mesh->dimension, 2);
  EXPECT_EQ(run.units.displacement, "mm");
  EXPECT_FALSE(run.runout);
}

TEST(ResultsJson, AFaultIsNamedWithItsPlace) {
  EXPECT_NE(find_fault(R"({"fem": {"runs": [{"factor": 1.2}, {"factor": "high"}]}})")
                .find("summary.json: fem.runs[1].factor should be a number"),
            std::string::npos);
  EXPECT_NE(find_fault(R"({"status": "excellent"})").find("status should be a word that this version knows"),
            std::string::npos);
  EXPECT_NE(find_fault(R"({"stages": {}})").find("stages should be a list"), std::string::npos);
}

TEST(ResultsJson, AMethodWithoutAFactorHasAllKeys) {
  RunResult run;
  run.elements.emplace().error = "no equilibrium";
  const json written = to_json(run).at("fem");
  EXPECT_EQ(written.at("error"), "no equilibrium");
  EXPECT_TRUE(written.at("runs").empty());
  EXPECT_EQ(from_json<RunResult>(json{{"fem", written}}, "").elements->error, "no equilibrium");
}

/// Expects every key that a run writes in the schema, and those that the schema requires in the run.
void expect_known(const json& value, const json& schema, const json& types, const std::string& path) {
  if (schema.contains("$ref")) {
    const std::string name = schema.at("$ref").get<std::string>().substr(std::string("#/$defs/").size());
    expect_known(value, types.at(name), types, path);
  } else if (schema.contains("allOf")) {
    expect_known(value, schema.at("allOf").at(0), types, path);
  } else if (schema.contains("anyOf")) {
    if (!value.is_null()) expect_known(value, schema.at("anyOf").at(0), types, path);
  } else if (value.is_object() && schema.contains("properties")) {
    for (const auto& [name, inner] : value.items()) {
      ASSERT_TRUE(schema.at("properties").contains(name)) << path << "." << name;
      expect_known(inner, schema.at("properties").at(name), types, path + "." + name);
    }
    for (const json& name : schema.at("required")) EXPECT_TRUE(value.contains(name)) << path << "." << name;
  } else if (value.is_array() && schema.contains("items")) {
    for (const json& inner : value) expect_known(inner, schema.at("items"), types, path + "[]");
  }
}

TEST(ResultsDocuments, SchemaContainsWhatIsWritten) {
  RunResult run;
  run.slices.emplace().given.push_back(make_surface(SliceMethod::bishop, {}));
  run.slices->search.emplace().limit_hits.push_back({"Bishop", "the entry lies at the edge"});
  run.elements.emplace().runs.emplace_back();
  run.factor_of_safety.emplace().frozen.emplace().meshes.emplace_back();
  run.runouts.emplace().emplace_back();
  run.season.emplace().layers.emplace_back();
  run.methods.emplace().partial_factors.emplace().values.emplace_back();
  const json schema = json::parse(write_schema());
  expect_known(to_json(run), schema, schema.at("$defs"), "");
  EXPECT_EQ(schema.at("$defs").at("Status").at("enum").size(), 5u);
  EXPECT_NE(write_manual().find("| `runout.front_advance` | m | advance of the front |"), std::string::npos);
  EXPECT_NE(write_manual().find("| `lem.critical[].slices.alpha` | rad |"), std::string::npos);
}

}  // namespace
}  // namespace talus::results
