// SPDX-License-Identifier: MIT
#include "report/schema.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "results/json.hpp"

namespace talus::report {

namespace {

nlohmann::json read_schema(const char* name) {
  std::ifstream file(std::string(TALUS_SOURCE_DIR) + "/web/contract/" + name);
  return nlohmann::json::parse(file);
}

std::string find_faults(const nlohmann::json& document, const nlohmann::json& text) {
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
  std::string faults;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& step : error.context) faults += step;
    faults += ": " + error.description + "\n";
  }
  return faults;
}

}  // namespace

std::string find_schema_faults(const nlohmann::json& document) {
  return find_faults(document, read_schema("report.schema.json"));
}

std::string find_schema_faults(const ReadPage& page) {
  std::string faults = find_schema_faults(page.document);
  nlohmann::json schema = read_schema("results.schema.json");
  for (const auto& [key, type] : {std::pair{"result", "RunResult"}, std::pair{"study_result", "StudyResult"},
                                  std::pair{"point_tests", "PointTests"}, std::pair{"calibration", "Calibration"}})
    if (page.results.contains(key)) {
      schema["$ref"] = std::string("#/$defs/") + type;
      faults += find_faults(page.results.at(key), schema);
    }
  return faults;
}

TEST(ResultsSchema, IsThatOfThePage) {
  EXPECT_EQ(read_text(TALUS_SOURCE_DIR "/web/contract/results.schema.json"), results::write_schema())
      << "write it again: talus schema --results > web/contract/results.schema.json";
}

}  // namespace talus::report
